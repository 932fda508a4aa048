/* SPDX-License-Identifier: MIT */
/* Computes with formal power series in beta at a point of a trajectory: f(delta; beta) = sum_m f_m(beta) delta^m with
 * delta = O(beta). The series need no remainder, because each coefficient of the result depends on finitely many
 * coefficients of f. */
#ifndef COR_GEN_SERIES_JET_H
#define COR_GEN_SERIES_JET_H

#include "support/flint.h"

/* Allocates an array of `count` power series: rows of a trajectory or Taylor coefficients of a jet. */
arb_poly_struct *jet_new(slong count);
void jet_free(arb_poly_struct *f, slong count);

/* Computes df/ddelta: slope[m] = (m + 1) f[m + 1] for m < count - 1. */
void jet_derivative(arb_poly_struct *slope, const arb_poly_struct *f, slong count, slong prec);

/* Computes y = f(delta(beta); beta) up to beta^(n-1) from f[0..count-1]. Requires count >= n and delta(0) = 0. */
void jet_compose(arb_poly_t y, const arb_poly_struct *f, slong count, const arb_poly_t delta, slong n, slong prec);

/* Solves f(delta(beta); beta) = 0 up to beta^(n-1) with delta(0) = 0. Treats f_0(0) as exactly 0; f_1(0) must not
 * contain 0. */
void jet_solve(arb_poly_t delta, const arb_poly_struct *f, slong count, slong n, slong prec);

#endif
