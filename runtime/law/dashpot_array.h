/* SPDX-License-Identifier: MIT */
/* Array functions of hertz_dashpot.h by instruction set: dashpot_array_kernel.c. Their callers pass the rows, so that
 * the library holds the tables once. */
#ifndef COR_RUNTIME_LAW_DASHPOT_ARRAY_H
#define COR_RUNTIME_LAW_DASHPOT_ARRAY_H

#include <stddef.h>

#include "runtime/number/sets.h"

/* The first row of each table of a quantity, or NULL. For the inverse `near` holds rows of the loss, and `middle` those
 * of eps. */
struct cor_dashpot_rows {
    const double *near, *middle, *below;
};

typedef void cor_dashpot_loop(const struct cor_dashpot_rows *rows, const double *in, double *out, size_t n);

/* EPS(function, tables) of a quantity whose rows near 0 give the loss, LOSS of its loss, VALUE of a quantity whose rows
 * all give its value, and BETA of an inverse */
#define COR_DASHPOT_LOOPS(EPS, LOSS, VALUE, BETA)                                                                      \
    EPS(eps_zero_overlap, eps_zero_overlap)                                                                            \
    EPS(eps_zero_force, eps_zero_force)                                                                                \
    LOSS(loss_zero_overlap, eps_zero_overlap)                                                                          \
    LOSS(loss_zero_force, eps_zero_force)                                                                              \
    VALUE(duration_zero_overlap, duration_zero_overlap)                                                                \
    VALUE(duration_zero_force, duration_zero_force)                                                                    \
    VALUE(max_overlap, max_overlap)                                                                                    \
    VALUE(time_of_max_overlap, time_of_max_overlap)                                                                    \
    BETA(beta_zero_overlap, inverse_eps_zero_overlap)                                                                  \
    BETA(beta_zero_force, inverse_eps_zero_force)

#define COR_DASHPOT_NUMBER_(function, tables) COR_DASHPOT_##function,
enum cor_dashpot_number {
    COR_DASHPOT_LOOPS(COR_DASHPOT_NUMBER_, COR_DASHPOT_NUMBER_, COR_DASHPOT_NUMBER_, COR_DASHPOT_NUMBER_)
        COR_DASHPOT_LOOP_COUNT
};

/* The loops of a set, by enum cor_dashpot_number */
struct cor_dashpot_loops {
    cor_dashpot_loop *of[COR_DASHPOT_LOOP_COUNT];
};
COR_TABLES(struct cor_dashpot_loops, cor_dashpot_loops, cor_dashpot_loops)

/* Calls the loop of a set; returns 0 if this build lacks the set or this processor cannot run it. */
int cor_dashpot_array_of_set(int set, enum cor_dashpot_number function, const double *in, double *out, size_t n);

#endif
