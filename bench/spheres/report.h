/* SPDX-License-Identifier: MIT */
/* The tables, as csv files and printed as they come. */
#ifndef COR_BENCH_SPHERES_REPORT_H
#define COR_BENCH_SPHERES_REPORT_H

#include <stdio.h>

#include "methods.h"

struct result {
    const struct method *method;
    const char *form;      /* "scalar", "array" in the cache, or "large" array */
    double ns, ns_chained; /* NaN: not measured */
    double error;          /* NaN: gives no eps, or not everywhere in the scene */
};

struct report {
    FILE *csv[2]; /* by enum input */
};

/* Opens DIR/spheres_speed.csv and DIR/spheres_beta.csv; exits where it cannot. */
void report_open(struct report *report, const char *directory);
void report_close(struct report *report);

void report_row(struct report *report, const struct scene *scene, const struct result *result);

#endif
