/* SPDX-License-Identifier: MIT */
/* The floor: the array read and written, and nothing computed. */
#include <string.h>

#include "methods.h"

static void loop_each(const struct method *method, const struct scene *scene, const double *in, double *out, size_t n)
{
    (void)method;
    (void)scene;
    for (size_t i = 0; i < n; i++) { /* may overlap for all the compiler knows: stays a loop */
        ONE_BY_ONE;
        out[i] = in[i];
    }
}

static void memcpy_each(const struct method *method, const struct scene *scene, const double *in, double *out, size_t n)
{
    (void)method;
    (void)scene;
    memcpy(out, in, n * sizeof *out);
}

void add_copies(struct methods *methods)
{
    static const struct method copies[] = {
        {.curve = "copy", .setting = "loop", .end = NO_END, .flags = ARRAY | LARGE, .each = loop_each},
        {.curve = "copy", .setting = "memcpy", .end = NO_END, .flags = ARRAY | LARGE, .each = memcpy_each},
    };
    methods_add(methods, &copies[0]);
    methods_add(methods, &copies[1]);
}
