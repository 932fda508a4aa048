/* SPDX-License-Identifier: MIT */
/* Bounds of the sphere's quantities on Bernstein ellipses around the intervals of the interpolant (docs/derivation.md,
 * 8). The ellipse of [lo, hi] has the foci lo and hi and the semi-axes (hi - lo)/4 (rho +- 1/rho). */
#ifndef COR_GEN_APPROXIMATION_ELLIPSE_BOUND_H
#define COR_GEN_APPROXIMATION_ELLIPSE_BOUND_H

#include "approximation/interpolant.h"

struct ellipse_bound {
    double rho;
    double modulus[QUANTITIES]; /* upper bound of the numbers that the interval stores */
    slong balls;                /* how many collisions were enclosed */
};

/* Proves that every number of the interval that ellipse_bound_set names is an analytic function in the ellipse, and
 * bounds its modulus: enclosed collisions cover the ellipse. Returns 0, or 1 after reporting on stderr that the cover
 * failed, because the ellipse is too large. */
int ellipse_bound_make(struct ellipse_bound *bound, const struct interval *interval, double rho);

/* All quantities of the interval but the duration at zero overlap as a function of ln(beta). */
unsigned ellipse_bound_set(const struct interval *interval);

#endif
