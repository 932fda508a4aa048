/* SPDX-License-Identifier: MIT */
/* Bounds the sphere's quantities on Bernstein ellipses around the intervals of the interpolant (docs/theory.md, 8). The
 * ellipse of [lo, hi] has the foci lo and hi and the semi-axes (hi - lo)/4 (rho +- 1/rho). */
#ifndef COR_GEN_APPROXIMATION_ELLIPSE_BOUND_H
#define COR_GEN_APPROXIMATION_ELLIPSE_BOUND_H

#include "approximation/interpolant.h"

struct ellipse_bound {
    double rho;
    double modulus[QUANTITIES]; /* upper bound of the numbers that the interval stores */
};

/* Radii rho and bounds for the intervals of interpolant_sphere_proof. An interval with rho = 0 has no proof, because
 * two others cover it. Each rho is close to the largest for which the proof succeeds. The stated bounds are one per
 * cent above the computed bounds. `corgen tables` proves them each time it writes the tables. */
enum { ELLIPSES = 9 };
extern const struct ellipse_bound ellipse_stated[ELLIPSES];

/* Proves that the quantities of ellipse_bound_set, in the form that the interval stores, are analytic in the ellipse,
 * and bounds their moduli. Encloses collisions in balls that cover the ellipse. Returns 0, or 1 after reporting on
 * stderr that the ellipse is too large to be covered. */
int ellipse_bound_make(struct ellipse_bound *bound, const struct interval *interval, double rho);

/* Bounds eps at one end of contact for another law in the same way. The other moduli are 0. Returns false without a
 * message if the cover fails, and always for eps at zero force in intervals that are not in ln(beta). */
bool ellipse_bound_of_law(struct ellipse_bound *bound, const struct interpolant *f, const struct interval *interval,
                          enum quantity eps, double rho);

/* Returns the interval's quantities. For an interval of ln(beta), omits the duration at zero overlap. */
unsigned ellipse_bound_set(const struct interval *interval);

#endif
