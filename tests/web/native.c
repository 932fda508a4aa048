/* SPDX-License-Identifier: MIT */
/* The functions of the browser's module, compiled by the compiler at hand, for tests/web/module.mjs:
 *     native COUNT FOLDER
 * writes COUNT arguments into FOLDER/x and the results of each function into FOLDER/NAME, as doubles. It prints the
 * names of these files. NAME is LAW,END,QUANTITY, or a function of hunt_crossley. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "tests/unit/random.h"
#include "web/web.h"

const char *web_name(int list, int i);
int web_law_function(int law, int end, int quantity, double y[3]);
void web_law(int law, int end, int quantity, const double *x, double *y, size_t n);
void web_hunt_crossley(int i, const double *x, double *y, size_t n, double elastic_exponent);

/* Returns an argument; the kinds alternate: from 0 to 1, from 0 to 3, from 2^-40 to 2^40, any double of either sign. */
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
    puts(name);
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
    for (int i = 0; i < COR_LAWS * COR_ENDS * COR_QUANTITIES; i++) {
        const int law = i % COR_LAWS, end = i / COR_LAWS % COR_ENDS, quantity = i / COR_LAWS / COR_ENDS;
        char name[200];
        if (!web_law_function(law, end, quantity, y))
            continue;
        snprintf(name, sizeof name, "%s,%s,%s", web_name(0, law), web_name(1, end), web_name(2, quantity));
        const size_t some = law == COR_LAW_HUNT_CROSSLEY ? n / 20 : n; /* its durations take 10 us each */
        web_law(law, end, quantity, x, y, some);
        written(argv[2], name, y, some);
    }
    for (int i = 0; web_name(3, i); i++) {
        web_hunt_crossley(i, x, y, n / 20, 1.3);
        written(argv[2], web_name(3, i), y, n / 20);
    }
    free(x);
    return 0;
}
