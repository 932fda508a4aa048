/* SPDX-License-Identifier: MIT */
/* Array functions of hertz_dashpot.h by the loops of runtime/table/row_loops.h. */
#ifndef COR_RUNTIME_LAW_DASHPOT_ARRAY_H
#define COR_RUNTIME_LAW_DASHPOT_ARRAY_H

#include <stddef.h>

/* OF_BETA(function) or OF_EPS(function), by argument */
#define COR_DASHPOT_LOOPS(OF_BETA, OF_EPS)                                                                             \
    OF_BETA(eps_zero_overlap)                                                                                          \
    OF_BETA(eps_zero_force)                                                                                            \
    OF_BETA(loss_zero_overlap)                                                                                         \
    OF_BETA(loss_zero_force)                                                                                           \
    OF_BETA(duration_zero_overlap)                                                                                     \
    OF_BETA(duration_zero_force)                                                                                       \
    OF_BETA(max_overlap)                                                                                               \
    OF_BETA(time_of_max_overlap)                                                                                       \
    OF_EPS(beta_zero_overlap)                                                                                          \
    OF_EPS(beta_zero_force)                                                                                            \
    OF_BETA(eps_approach_only)                                                                                         \
    OF_BETA(loss_approach_only)                                                                                        \
    OF_BETA(duration_approach_only)                                                                                    \
    OF_EPS(beta_approach_only)

#define COR_DASHPOT_NUMBER_(function) COR_DASHPOT_##function,
enum cor_dashpot_number { COR_DASHPOT_LOOPS(COR_DASHPOT_NUMBER_, COR_DASHPOT_NUMBER_) COR_DASHPOT_LOOP_COUNT };

/* Calls the loop of a set; returns 0 if this build lacks the set or this processor cannot run it. */
int cor_dashpot_array_of_set(int set, enum cor_dashpot_number function, const double *in, double *out, size_t n);

#endif
