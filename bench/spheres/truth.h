/* SPDX-License-Identifier: MIT */
/* eps of the checked speeds of a scene, from the long double integration of the tests. */
#ifndef COR_BENCH_SPHERES_TRUTH_H
#define COR_BENCH_SPHERES_TRUTH_H

#include "methods.h"

enum { CHECKED = 2000 };

struct truth {
    double in[2][CHECKED];          /* by enum input: speeds, even in their logarithm, and their beta */
    long double eps[2][2][CHECKED]; /* by enum input and enum end */
};

/* eps at speed g is that of the exact beta_per_root g^(1/5), eps at beta that of the double in in[FROM_BETA]. */
void truth_compute(struct truth *truth, const struct scene *scene);

/* Largest |eps/truth - 1|; NaN if an eps is none. */
double truth_worst_error(const struct truth *truth, const struct scene *scene, const struct method *method);

/* eps of the published formulas and of the library at a few beta, with their errors. */
void truth_print_formulas(void);

#endif
