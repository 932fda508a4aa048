/* SPDX-License-Identifier: MIT */
/* The array functions by instruction set: array_kernel.c. */
#ifndef COR_RUNTIME_LAW_ARRAY_H
#define COR_RUNTIME_LAW_ARRAY_H

#include <stddef.h>

#include "runtime/law/functions.h"
#include "runtime/number/sets.h"

#define COR_LAW_LOOP_NUMBER_(name, ...) COR_LAW_##name,
enum cor_law_loop { COR_LAW_LOOPS(COR_LAW_LOOP_NUMBER_, COR_LAW_LOOP_NUMBER_) COR_LAW_LOOP_COUNT };

/* The loops of a set; floats are the results for doubles, rounded once. */
struct cor_law_loops {
    void (*run)(enum cor_law_loop loop, const double *in, double *out, size_t n);
    void (*run_floats)(enum cor_law_loop loop, const float *in, float *out, size_t n);
};
COR_TABLES(struct cor_law_loops, cor_law_loops, cor_law_loops)

/* Calls the loop of the widest set in the default environment. */
void cor_law_array(enum cor_law_loop loop, const double *x, double *y, size_t n);
void cor_law_arrayf(enum cor_law_loop loop, const float *x, float *y, size_t n);

#endif
