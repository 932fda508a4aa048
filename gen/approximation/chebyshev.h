/* SPDX-License-Identifier: MIT */
/* What polynomials through samples need */
#ifndef COR_GEN_APPROXIMATION_CHEBYSHEV_H
#define COR_GEN_APPROXIMATION_CHEBYSHEV_H

#include <stdbool.h>

#include "support/flint.h"

/* Point j of the n Chebyshev points on [-1, 1] in ascending order, with the accuracy of a double */
double chebyshev_point(slong j, slong n);

/* t = -1 at x = lo, 1 at hi */
void unit_place(arb_t t, const arb_t x, double lo, double hi, slong prec);

/* Rounds a sample to `bits` bits; the result counts as exact. Returns false if the interval does not determine it. */
bool sample_rounded(arb_t y, const arb_t x, slong bits);

#endif
