/* SPDX-License-Identifier: MIT */
/* The tables as text and as csv. */
#ifndef COR_BENCH_SPHERES_REPORT_H
#define COR_BENCH_SPHERES_REPORT_H

#include <stdio.h>

#include "methods.h"

struct result {
    const struct method *method;
    double throughput_ns, latency_ns; /* NaN: not measured */
    double error;                     /* NaN: gives no eps, or not everywhere in the scene */
};

struct report {
    const char *build; /* how the bench was compiled */
    FILE *speed_csv, *large_csv;
    int missed; /* targets */
};

/* Opens DIR/speed.csv and DIR/large.csv, to append if so; exits where it cannot. */
void report_open(struct report *report, const char *directory, const char *build, int append);
void report_close(struct report *report);

/* One scene; ratios are to the row with BASELINE. */
void report_scene(struct report *report, const struct scene *scene, const struct result *results, size_t n);

/* Arrays larger than the cache; ratios are to the last COPY. */
void report_large(struct report *report, const struct scene *scene, const struct result *results, size_t n,
                  size_t elements);

#endif
