/* SPDX-License-Identifier: MIT */
/* The bits of every public function.
 *     bits write FILE DRAWS      calls every function with DRAWS times 150 arguments, and writes the results
 *     bits compare FILE OTHER    prints FUNCTION RESULTS DIFFERENT LARGEST for each function whose results differ: how
 *                                many differ, and the largest relative difference
 * A file has "FUNCTION RESULTS" and a line break, then the results with the low byte first, for each function. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/unit/public_calls.h"

static void put_results(FILE *file, const struct results *r)
{
    for (size_t i = 0; i < r->count; i++) {
        uint64_t bits = UINT64_C(0x7ff8000000000000); /* every NaN counts as one */
        if (!isnan(r->value[i]))
            memcpy(&bits, &r->value[i], sizeof bits);
        for (int byte = 0; byte < 8; byte++)
            putc((int)(bits >> (8 * byte) & 255), file);
    }
}

/* Every function draws the same arguments, so that none depends on how many results another has. */
static int write_all(FILE *file, int draws)
{
    static struct arguments a;
    for (size_t f = 0; f < public_function_count; f++) {
        struct random_bits random = {{random_bits_next}, random_seeded(36)};
        struct results r = {NULL, 0, 0};
        for (int draw = 0; draw < draws; draw++) {
            arguments_draw(&a, &random.source, PUBLIC_COUNT, 1);
            public_functions[f].call(&a, &r);
        }
        fprintf(file, "%s %lu\n", public_functions[f].name, (unsigned long)r.count);
        put_results(file, &r);
        results_clear(&r);
    }
    return ferror(file) != 0;
}

static int read_double(FILE *file, double *x)
{
    uint64_t bits = 0;
    for (int byte = 0; byte < 8; byte++) {
        const int c = getc(file);
        if (c == EOF)
            return 0;
        bits |= (uint64_t)c << (8 * byte);
    }
    memcpy(x, &bits, sizeof bits);
    return 1;
}

/* The relative difference; infinite between a number and NaN, or between 0 and -0 */
static double distance(double x, double y)
{
    if (memcmp(&x, &y, sizeof x) == 0 || (isnan(x) && isnan(y)))
        return 0;
    return x == y || isnan(x) || isnan(y) ? INFINITY : fabs(x - y) / fmax(fabs(x), fabs(y));
}

static int compare_all(FILE *file, FILE *other)
{
    char name[100], other_name[100];
    unsigned long count, other_count;
    while (fscanf(file, "%99s %lu", name, &count) == 2) {
        if (fscanf(other, "%99s %lu", other_name, &other_count) != 2 || strcmp(name, other_name) != 0 ||
            count != other_count || getc(file) != '\n' || getc(other) != '\n')
            return fprintf(stderr, "%s: other results\n", name), 1;
        unsigned long different = 0;
        double worst = 0;
        for (unsigned long i = 0; i < count; i++) {
            double x, y;
            if (!read_double(file, &x) || !read_double(other, &y))
                return fprintf(stderr, "%s: too short\n", name), 1;
            const double off = distance(x, y);
            different += off > 0;
            worst = fmax(worst, off);
        }
        if (different > 0)
            printf("%s %lu %lu %.2g\n", name, count, different, worst);
    }
    return 0;
}

int main(int argc, char **argv)
{
    const int write = argc == 4 && strcmp(argv[1], "write") == 0;
    FILE *const file = argc == 4 ? fopen(argv[2], write ? "wb" : "rb") : NULL;
    FILE *const other = argc == 4 && !write ? fopen(argv[3], "rb") : NULL;
    if (file == NULL || (!write && other == NULL))
        return 2;
    const int status = write ? write_all(file, atoi(argv[3])) : compare_all(file, other);
    return fclose(file) != 0 || status;
}
