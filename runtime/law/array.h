/* SPDX-License-Identifier: MIT */
/* The array functions by instruction set: array_kernel.c. */
#ifndef COR_RUNTIME_LAW_ARRAY_H
#define COR_RUNTIME_LAW_ARRAY_H

#include <stddef.h>

#include "runtime/law/functions.h"
#include "runtime/number/sets.h"

typedef void cor_law_array_function(const double *in, double *out, size_t n);

#define COR_LAW_LOOP_NUMBER_(name, public, least, largest) COR_LAW_##name,
enum cor_law_loop { COR_LAW_LOOPS(COR_LAW_LOOP_NUMBER_, COR_LAW_LOOP_NUMBER_) COR_LAW_LOOP_COUNT };

/* The loops of a set, by enum cor_law_loop */
struct cor_law_loops {
    cor_law_array_function *of[COR_LAW_LOOP_COUNT];
};
COR_TABLES(struct cor_law_loops, cor_law_loops, cor_law_loops)

/* Calls the loop in the default environment: for doubles, and for floats, whose results are rounded once. The first two
 * take the loop of the widest set. */
void cor_law_array(enum cor_law_loop loop, const double *x, double *y, size_t n);
void cor_law_arrayf(enum cor_law_loop loop, const float *x, float *y, size_t n);
void cor_law_array_by(cor_law_array_function *loop, const double *x, double *y, size_t n);
void cor_law_arrayf_by(cor_law_array_function *loop, const float *x, float *y, size_t n);

#endif
