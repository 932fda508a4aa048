/* SPDX-License-Identifier: MIT */
/* Encloses unloading at strong damping for n = 2b - a + 1 > 0: z'' + z^b z' + z^a = 0 approaches a slow manifold.
 *
 * With x = beta^(-2/n) z, time in beta^((a-1)/n), p = -z'/z^(a-b) and y = z^-n the unloading obeys (docs/theory.md, 9)
 *
 *   N(p) = 1 - p + (a-b) y p^2 - n y^2 p dp/dy = 0,    dt' = dy/(n y^(1+kappa) p),   kappa = (b-a+1)/n.
 *
 * Its solution is a divergent series p = 1 + (a-b) y + ... with terms of about m! (-n y)^m. If a formal sum P has
 * |N(P)| <= nu, every trajectory within eta >= 4 nu of P stays within eta of P. Times and end speeds are therefore
 * enclosed without integrating the stiff part. */
#ifndef COR_GEN_ENCLOSURE_SLOW_MANIFOLD_H
#define COR_GEN_ENCLOSURE_SLOW_MANIFOLD_H

#include <stdbool.h>

#include "series/law.h"

struct slow_manifold {
    struct cor_exponents law;
    struct ratio n, kappa;
    slong prec;
    arb_poly_t p;       /* the formal sum */
    arb_poly_t inverse; /* the formal sum of 1/p */
    arb_t last;         /* all fields below hold for 0 < y <= last */
    arb_t nu;           /* bound of |N(P)| */
    arb_t time_error;   /* bound of the integral of |1/P - inverse|/(n y^(1+kappa)) over (0, last] */
    arb_t final_speed;  /* speed at z = 0 of every trajectory within eta at `last`: v_f = lim beta^(1/q) eps */
    arb_t t_fall;       /* time t' of every such trajectory from `last` to z = 0 */
    slong bits;
    bool closed;                /* the precision sufficed */
    struct slow_manifold *next; /* next manifold in the list of stored ones */
};

/* Returns the manifold with eta below 2^(1-bits), computed with at least `prec` bits, or NULL if this precision does
 * not suffice. Thousands of collisions of a law need the same manifold, so each one is computed once and stored until
 * the process ends. Any thread may call the function. */
const struct slow_manifold *slow_manifold_of(const struct cor_exponents *law, slong bits, slong prec);

/* Returns the depth 1/(n last): the motion from `last` contracts by exp(-depth). */
double slow_manifold_depth(const struct cor_exponents *law, slong bits);

/* Computes the time t' from y to `last` for a trajectory that passes y < last with the given p. Returns false if p is
 * not proved to be within 2^-bits of the formal sum. */
bool slow_manifold_time(arb_t time, const struct slow_manifold *m, const arb_t y, const arb_t p, slong bits);

/* True if |p - P(y)| < 2^-bits is proved. */
bool slow_manifold_reached(const struct slow_manifold *m, const arb_t y, const arb_t p, slong bits);

#endif
