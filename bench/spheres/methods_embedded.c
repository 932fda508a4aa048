/* SPDX-License-Identifier: MIT */
/* Headers to embed, included as a user would: generated/cor_sphere.h, for every beta, and those that corgen embed
 * writes for the scene of two decades (CMakeLists.txt). This file is compiled once for each set of flags, with ADD the
 * name of its one function, AVAILABLE the test of the machine, and FLAGS what the table calls them. */
#include "methods.h"

#include <stdio.h>

#include "cor_sphere.h"

#ifdef COR_BENCH_HAS_SCENES
#include "scene_force_array.h"
#include "scene_force_balanced.h"
#include "scene_force_scalar.h"
#include "scene_overlap_array.h"
#include "scene_overlap_balanced.h"
#include "scene_overlap_scalar.h"
#endif

/* Whether the compiler was told to make vectors: then rows are arrays, else scalars. */
#ifdef __AVX2__
enum { VECTORS = 1 };
#else
enum { VECTORS = 0 };
#endif

#define ROOT_OF_SCENE const double unit = scene->contact.beta5_per_speed
SCALAR_METHOD(full_overlap, ROOT_OF_SCENE, cor_inline_eps_zero_overlap_root(unit *g))
SCALAR_METHOD(full_force, ROOT_OF_SCENE, cor_inline_eps_zero_force_root(unit *g))

/* The flags' name goes behind the name and the label of the row. */
static inline void add(struct methods *methods, struct method method)
{
    char name[sizeof method.name], label[sizeof method.label] = "";
    snprintf(name, sizeof name, "%.40s, %s", method.name, FLAGS);
    if (method.label[0])
        snprintf(label, sizeof label, "%.20s %s", method.label, FLAGS);
    snprintf(method.name, sizeof method.name, "%s", name);
    snprintf(method.label, sizeof method.label, "%s", label);
    methods_add(methods, &method);
}

static void add_full(struct methods *methods)
{
    for (enum end end = ZERO_OVERLAP; end <= ZERO_FORCE; end++) {
        const struct method method = {.name = "cor_sphere.h, from speed",
                                      .label = "cor_sphere.h",
                                      .precision = "full",
                                      .scene = "ordinary",
                                      .end = end,
                                      .least_speed_up = 1,
                                      .least_latency_gain = 1 / 1.2,
                                      .each = end == ZERO_OVERLAP ? full_overlap_each : full_force_each,
                                      .chain = end == ZERO_OVERLAP ? full_overlap_chain : full_force_chain};
        add(methods, method);
    }
}

#ifdef COR_BENCH_HAS_SCENES
/* NAME_each and NAME_chain for calls, NAME_array_each for a loop, of the function NAME */
#define SCENE_METHODS(NAME) SCALAR_METHOD(NAME, , NAME(g)) ARRAY_METHOD(NAME##_array, , NAME(g))
SCENE_METHODS(scene_overlap_balanced)
SCENE_METHODS(scene_overlap_scalar)
SCENE_METHODS(scene_overlap_array)
SCENE_METHODS(scene_force_balanced)
SCENE_METHODS(scene_force_scalar)
SCENE_METHODS(scene_force_array)

static void add_scenes(struct methods *methods)
{
#define FUNCTIONS(NAME)                                                                                                \
    {                                                                                                                  \
        NAME##_each, NAME##_array_each, NAME##_chain                                                                   \
    }
    static const struct {
        const char *use;
        enum end end;
        struct {
            void (*each)(const struct method *, const struct scene *, const double *, double *, size_t);
            void (*array)(const struct method *, const struct scene *, const double *restrict, double *restrict,
                          size_t);
            double (*chain)(const struct method *, const struct scene *, const double *, size_t);
        } f;
    } rows[] = {
        {"balanced", ZERO_OVERLAP, FUNCTIONS(scene_overlap_balanced)},
        {"scalar", ZERO_OVERLAP, FUNCTIONS(scene_overlap_scalar)},
        {"array", ZERO_OVERLAP, FUNCTIONS(scene_overlap_array)},
        {"balanced", ZERO_FORCE, FUNCTIONS(scene_force_balanced)},
        {"scalar", ZERO_FORCE, FUNCTIONS(scene_force_scalar)},
        {"array", ZERO_FORCE, FUNCTIONS(scene_force_array)},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct method method = {.precision = "1e-6",
                                .scene = "two decades",
                                .end = rows[i].end,
                                .tolerance = 1e-6,
                                .flags = VECTORS ? ARRAY : 0};
        /* a header for calls promises nothing of loops, nor the other way round */
        if (rows[i].use[0] == (VECTORS ? 's' : 'a'))
            continue;
        snprintf(method.name, sizeof method.name, "corgen embed --for %s%s", rows[i].use, VECTORS ? ", loop" : "");
        if (rows[i].use[0] == 'b')
            snprintf(method.label, sizeof method.label, "corgen embed");
        method.least_speed_up = VECTORS ? 10 : 3;
        if (VECTORS) {
            method.each = rows[i].f.array;
        } else {
            method.each = rows[i].f.each;
            method.chain = rows[i].f.chain;
        }
        add(methods, method);
    }
}
#endif

void ADD(struct methods *methods)
{
    if (!AVAILABLE())
        return;
    if (!VECTORS)
        add_full(methods);
#ifdef COR_BENCH_HAS_SCENES
    add_scenes(methods);
#endif
}
