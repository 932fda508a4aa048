/* SPDX-License-Identifier: MIT */
/* The functions of the browser's module, compiled by the compiler at hand, for tests/web/module.mjs:
 *     native COUNT FOLDER
 * writes COUNT arguments into FOLDER/x and the results of each function into FOLDER/NAME, as doubles, and prints the
 * names. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/unit/random.h"
#include "web/web.h"

const char *web_function_name(int i);
int web_functions_with_exponent(void);
void web_map(int i, const double *x, double *y, size_t n, double exponent);

/* In turn: from 0 to 1, from 0 to 3, from 2^-40 to 2^40, any double of either sign */
static double argument(struct random_state *r, size_t i)
{
    static const double special[] = {0, -0.0, 1, -1, INFINITY, -INFINITY, NAN, 0.5, 5e-324, 1.7976931348623157e308};
    if (i < sizeof special / sizeof *special)
        return special[i];
    if (i % 4 < 2)
        return random_uniform(r, 0, i % 4 == 0 ? 1 : 3);
    return i % 4 == 2 ? random_log(r, 0x1p-40, 0x1p40) : (i % 8 == 3 ? -1 : 1) * random_pattern(r, INFINITY);
}

static void written(const char *folder, const char *name, const double *y, size_t n)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *const file = fopen(path, "wb");
    if (!file || fwrite(y, sizeof *y, n, file) != n || fclose(file) != 0)
        exit(1);
}

int main(int argc, char **argv)
{
    const size_t n = argc == 3 ? strtoul(argv[1], NULL, 10) : 0;
    double *const x = malloc(2 * n * sizeof *x), *const y = x + n;
    struct random_state r = random_seeded(34);
    if (n == 0 || !x)
        return 2;
    for (size_t i = 0; i < n; i++)
        x[i] = argument(&r, i);
    written(argv[2], "x", x, n);
    for (int i = 0; web_function_name(i); i++) {
        /* the quadrature of Hunt and Crossley's times takes ten microseconds */
        const int slow = i >= web_functions_with_exponent() && strstr(web_function_name(i), "overlap") == NULL;
        const size_t some = slow ? n / 20 : n;
        web_map(i, x, y, some, 1.5);
        written(argv[2], web_function_name(i), y, some);
        puts(web_function_name(i));
    }
    free(x);
    return 0;
}
