/* SPDX-License-Identifier: MIT */
/* The array functions of law.h by instruction set: kernels in array_kernel.c, rows by runtime/table/row_loops.h. */
#ifndef COR_RUNTIME_LAW_ARRAY_H
#define COR_RUNTIME_LAW_ARRAY_H

#include <stddef.h>

#include "runtime/law/closed_form.h"
#include "runtime/law/linear.h"
#include "runtime/number/sets.h"

/* The functions whose array forms are loops: kernels, LOOP(name, public, least, largest, value), whose `value` of x and
 * cor_<public> give the same bits on least <= x <= largest; and the functions of COR_CLOSED_FORMS, whose loops read
 * rows. */
#define COR_LAW_LOOPS(LOOP)                                                                                            \
    LOOP(linear_inline_duration_zero_overlap, linear_duration_zero_overlap, 0.0, COR_RATIO_BELOW_ONE,                  \
         cor_linear_inline_duration_zero_overlap_near(x))                                                              \
    LOOP(linear_inline_duration_zero_force, linear_duration_zero_force, 0.0, COR_RATIO_FORCE_NEAR,                     \
         cor_linear_inline_duration_zero_force_near(x))                                                                \
    LOOP(linear_inline_time_of_max_overlap, linear_time_of_max_overlap, 0.0, COR_RATIO_FORCE_NEAR,                     \
         cor_linear_inline_time_of_max_overlap_near(x))
#define COR_LAW_LOOP_NUMBER_(name, ...) COR_LAW_##name,
#define COR_LAW_FORM_NUMBERS_(law, public, x, end, LAW, X, END)                                                        \
    COR_LAW_##law##_eps##end, COR_LAW_##law##_loss##end, COR_LAW_##law##_##x##end, COR_LAW_##law##_##x##_of_loss##end,
/* Loops of kernels, then those of rows */
enum cor_law_loop {
    COR_LAW_LOOPS(COR_LAW_LOOP_NUMBER_) COR_LAW_KERNELS,
    COR_LAW_BEFORE_FORMS = COR_LAW_KERNELS - 1,
    COR_CLOSED_FORMS(COR_LAW_FORM_NUMBERS_) COR_LAW_LOOP_COUNT
};

/* The kernels of a set; floats are the results for doubles, rounded once. */
struct cor_law_loops {
    void (*run)(enum cor_law_loop loop, const double *in, double *out, size_t n);
    void (*run_floats)(enum cor_law_loop loop, const float *in, float *out, size_t n);
};
COR_TABLES(struct cor_law_loops, cor_law_loops, cor_law_loops)

/* Call a loop of a set in the default environment; return 0 if this build lacks the set or this processor cannot run
 * it. */
int cor_law_array_of_set(int set, enum cor_law_loop loop, const double *x, double *y, size_t n);
int cor_law_arrayf_of_set(int set, enum cor_law_loop loop, const float *x, float *y, size_t n);

#endif
