/* SPDX-License-Identifier: MIT */
/* Formal power series in beta at a point of a trajectory: f(delta; beta) = sum_m f_m(beta) delta^m with
 * delta = O(beta). No analysis, so no remainder: a coefficient of the result uses finitely many of f's. */
#ifndef COR_GEN_JET_H
#define COR_GEN_JET_H

#include "flint.h"

/* y = f(delta(beta); beta) up to beta^(n-1), from f[0..count-1], count >= n; delta(0) = 0. */
void jet_compose(arb_poly_t y, const arb_poly_struct *f, slong count, const arb_poly_t delta, slong n, slong prec);

/* The delta(beta) with delta(0) = 0 and f(delta; beta) = 0 up to beta^(n-1). f_0(0) is taken as exactly 0,
 * f_1(0) must not be. */
void jet_solve(arb_poly_t delta, const arb_poly_struct *f, slong count, slong n, slong prec);

#endif
