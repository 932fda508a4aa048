/* SPDX-License-Identifier: MIT */
/* The functions whose array forms are loops: kernels, LOOP(name, public, least, largest, value), whose `value` of x and
 * cor_<public> give the same bits on least <= x <= largest; and the functions of COR_CLOSED_FORMS, whose loops read
 * rows (runtime/table/row_loops.h). */
#ifndef COR_RUNTIME_LAW_FUNCTIONS_H
#define COR_RUNTIME_LAW_FUNCTIONS_H

#include "runtime/law/closed_form.h"
#include "runtime/law/linear.h"

#define COR_LAW_LOOPS(LOOP)                                                                                            \
    LOOP(linear_inline_duration_zero_overlap, linear_duration_zero_overlap, 0.0, COR_RATIO_BELOW_ONE,                  \
         cor_linear_inline_duration_zero_overlap_near(x))                                                              \
    LOOP(linear_inline_duration_zero_force, linear_duration_zero_force, 0.0, COR_RATIO_FORCE_NEAR,                     \
         cor_linear_inline_duration_zero_force_near(x))                                                                \
    LOOP(linear_inline_time_of_max_overlap, linear_time_of_max_overlap, 0.0, COR_RATIO_FORCE_NEAR,                     \
         cor_linear_inline_time_of_max_overlap_near(x))

#endif
