/* SPDX-License-Identifier: MIT */
/* Polynomials through samples at n nodes, in barycentric form */
#ifndef COR_GEN_APPROXIMATION_BARYCENTRIC_H
#define COR_GEN_APPROXIMATION_BARYCENTRIC_H

#include <stdbool.h>

#include "support/flint.h"

/* Point j of the n Chebyshev points on [-1, 1] in ascending order, with the accuracy of a double */
double chebyshev_point(slong j, slong n);

void barycentric_weights(arb_ptr weight, arb_srcptr node, slong n, slong prec);

/* The polynomial at x */
void barycentric_value(arb_t y, arb_srcptr node, arb_srcptr weight, arb_srcptr value, slong n, const arb_t x,
                       slong prec);

/* Rounds a sample to `bits` bits; the result counts as exact. Returns false if the interval does not determine it. */
bool sample_rounded(arb_t y, const arb_t x, slong bits);

#endif
