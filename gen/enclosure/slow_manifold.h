/* SPDX-License-Identifier: MIT */
/* Unloading at strong damping, spheres only: z'' + sqrt(z) z' + z^(3/2) = 0 falls onto a slow manifold.
 *
 * With x = beta^-4 z, t = beta t', p = -z'/z and r = z^(-1/2), the fall is
 *
 *   N(p) = 1 - p + r p^2 - r^2 p p'/2 = 0,   dt' = 2 dr/(r p),   p = 1 + r + 3/2 r^2 + ...,
 *
 * a divergent series with terms about n! (-r/2)^n. Where a formal sum P leaves |N(P)| <= nu, every trajectory
 * that is within eta >= 4 nu of P stays there, so times and end speeds are enclosed without integrating the
 * stiff part. */
#ifndef COR_GEN_ENCLOSURE_SLOW_MANIFOLD_H
#define COR_GEN_ENCLOSURE_SLOW_MANIFOLD_H

#include "support/flint.h"

#include <stdbool.h>

struct slow_manifold {
    arb_poly_t p;        /* the formal sum, degree about 1/r1 */
    arb_poly_t inverse;  /* the formal sum of 1/p */
    arb_t r1;            /* everything below holds for 0 < r <= r1 */
    arb_t nu;            /* bound of |N(P)| */
    arb_t inverse_error; /* bound of the integral of |1/P - inverse| 2/r over (0, r1] */
    slong prec;
    arb_t h_star_5; /* end speed of every trajectory within eta at r1: beta^5 eps */
    arb_t t_fall;   /* its time t' from r1 to z = 0 */
};

/* Chooses r1 so that eta is below 2^-bits. False where the enclosure did not close at this precision. */
bool slow_manifold_init(struct slow_manifold *m, slong bits, slong prec);
void slow_manifold_clear(struct slow_manifold *m);

/* Time t' from r to r1 for a trajectory that passes r < r1 with the given p; false where p is not within
 * 2^-bits of the formal sum. */
bool slow_manifold_time(arb_t time, const struct slow_manifold *m, const arb_t r, const arb_t p, slong bits);

/* |p - P(r)| < 2^-bits, certainly. */
bool slow_manifold_reached(const struct slow_manifold *m, const arb_t r, const arb_t p, slong bits);

#endif
