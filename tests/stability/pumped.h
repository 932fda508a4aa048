/* SPDX-License-Identifier: MIT */
/* The loading by Taylor steps of a plain kind, for dampings of either sign: a route to eps by the inverse collision,
 * and to the trajectory at a time. Floating point without error bounds, in as many bits as are asked for. */
#ifndef COR_TESTS_PUMPED_H
#define COR_TESTS_PUMPED_H

#include "support/flint.h"

/* Y(beta) = x_max for beta > -h* */
void pumped_max_overlap(arb_t x, const arb_t beta, slong prec);

/* x(t) before the turning point */
void pumped_position(arb_t x, const arb_t beta, const arb_t t, slong prec);

/* eps at zero overlap, and h = beta eps^(1/5): h Y(-h)^(1/4) = beta Y(beta)^(1/4). Returns 0, or 1 where no h below h*
 * was found. */
int pumped_eps(arb_t eps, arb_t h, double beta);

#endif
