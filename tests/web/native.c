/* SPDX-License-Identifier: MIT */
/* The functions of the browser's module, compiled by the compiler at hand: hashes of their results, by which
 * tests/web/module.mjs compares those of WebAssembly.
 *     native COUNT FILE           writes COUNT arguments into FILE, as doubles, and prints NAME HASH
 *     native COUNT FILE NAME      writes the results of one function, as doubles
 *     native time                 prints NAME NANOSECONDS of eps of spheres, for an argument, at best */
#define _POSIX_C_SOURCE 200809L
#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

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

/* FNV-1a over words of 32 bits, the lower one first; every NaN counts as one. */
static uint32_t hash_of(const double *y, size_t n)
{
    uint32_t hash = 2166136261u;
    for (size_t i = 0; i < n; i++) {
        uint64_t bits = 0x7ff8000000000000u;
        if (!isnan(y[i]))
            memcpy(&bits, &y[i], sizeof bits);
        hash = (hash ^ (uint32_t)bits) * 16777619u;
        hash = (hash ^ (uint32_t)(bits >> 32)) * 16777619u;
        hash ^= hash >> 15;
    }
    return hash;
}

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void print_times(void)
{
    enum { SOME = 1000, TIMES = 4000 };
    static double x[SOME], y[SOME];
    for (int i = 0; i < SOME; i++)
        x[i] = 0.3 + 1.6 * (i * 619 % SOME) / SOME;
    for (int f = 0; strncmp(web_function_name(f), "sphere.eps_zero", 15) == 0; f++) {
        double best = INFINITY;
        for (int k = 0; k < TIMES; k++) {
            const double start = seconds();
            web_map(f, x, y, SOME, 0);
            best = fmin(best, seconds() - start);
        }
        printf("%s %.3f\n", web_function_name(f), 1e9 * best / SOME);
    }
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "time") == 0) {
        print_times();
        return 0;
    }
    const size_t n = argc >= 3 ? strtoul(argv[1], NULL, 10) : 0;
    if (n == 0)
        return 2;
    double *const x = malloc(2 * n * sizeof *x), *const y = x + n;
    FILE *const file = x ? fopen(argv[2], "wb") : NULL;
    struct random_state r = random_seeded(34);
    for (size_t i = 0; i < n && file; i++)
        x[i] = argument(&r, i);
    if (!file || fwrite(x, sizeof *x, n, file) != n || fclose(file) != 0) {
        free(x);
        return 1;
    }
    for (int i = 0; web_function_name(i); i++) {
        /* the quadrature of Hunt and Crossley's times takes ten microseconds */
        const int slow = i >= web_functions_with_exponent() && strstr(web_function_name(i), "overlap") == NULL;
        const size_t some = slow ? n / 20 : n;
        if (argc > 3 && strcmp(argv[3], web_function_name(i)) != 0)
            continue;
        web_map(i, x, y, some, 1.5);
        if (argc > 3) {
            fwrite(y, sizeof *y, some, stdout);
            continue;
        }
        printf("%s %08" PRIx32 "\n", web_function_name(i), hash_of(y, some));
    }
    free(x);
    return 0;
}
