/* SPDX-License-Identifier: MIT */
/* eps of any law's collision at complex damping, enclosed for all beta in a ball at once (docs/theory.md, 9).
 *
 * With L = ln(x), kappa = -x'/x, the equation x'' + beta x^b x' + x^a = 0 is a scalar equation between fixed ends:
 *
 *     approach, x = s^4 from 0:  dv/ds = -4 (beta s^(4b+3) + s^(4a+3)/v),   v = 1 at s = 0
 *     about the turning point:   dL/dkappa = -kappa/(x^(a-1) - beta kappa x^b + kappa^2), kappa = -v/x to 0, then 1
 *     departure, x = X s^4, -x' = W exp(l), s from 1 to 0:
 *                                dl/ds = 4 (beta X^(b+1)/W s^(4b+3) exp(-l) - X^(a+1)/W^2 s^(4a+3) exp(-2 l))
 *     to zero force, k = beta kappa x^(b+1-a), from k = 0 to 1 (or ln(k), from its value at kappa = 1 to 0):
 *                                dL/dk = -k/N,   N = F (1 - k) + (a-b) k^2,   F = beta^2 x^n,   n = 2b+1-a
 *     creep, for n > 0:          n dk/dln(F) = -N/k, from k = 1/2 to F = 2
 *
 * A constant force f on the right side (docs/theory.md, 24) adds 4 f s^3/v to dv/ds and -f/x to the denominator of
 * dL/dkappa. It adds 4 f X/W^2 s^3 exp(-2 l) to dl/ds and -f beta^2 x^(n-a) to N. Under a force no path creeps. The
 * first speed v need not be 1: impacts of one contact at different speeds have the same beta and f in the same units.
 * eps is the last speed divided by v. The net work of f is 0, so this work of an uncertain f does not widen eps.
 *
 * At zero overlap eps is W exp(l), and at zero force x^(a-b)/beta. Under a force zero_force means the surface. The
 * flight to the surface multiplies eps by sqrt(1 - 2 f beta^2 x^(1-2(a-b))). The departure begins at kappa = 1 or after
 * the creep. The function is analytic in beta where the denominators have no zero along the path. */
#ifndef COR_GEN_ENCLOSURE_COMPLEX_LAW_H
#define COR_GEN_ENCLOSURE_COMPLEX_LAW_H

#include "enclosure/complex_ball.h"
#include "series/law.h"

/* The path of integration for a domain of beta. All collisions of the domain must use the same path, so that eps is one
 * function of beta. */
struct complex_law_path {
    double approach_end; /* x at the end of the approach */
    bool strong;         /* strong damping: k starts at 0, and the departure begins after the creep */
    double resolution;   /* resolution of complex_path.h */
};

/* Returns a path for all |beta| up to a bound, with resolution 1. */
struct complex_law_path complex_law_path(const struct cor_exponents *law, double largest_beta, bool strong);

/* A constant force, and ln(v) of the first speed. Both are 0 without a force. */
struct complex_law_pressing {
    struct complex_ball force, log_speed;
};

/* Encloses ln(eps) at zero overlap for all beta and v in balls. Returns false if they are too wide, or if ln(eps) is
 * not proved to be analytic there. The continuation from real beta may have an imaginary part above pi. */
bool complex_law_zero_overlap(struct complex_ball *log_eps, const struct cor_exponents *law, struct complex_ball beta,
                              const struct complex_law_pressing *pressing, const struct complex_law_path *path);

/* Enclose ln(eps) for all ln(beta) in a ball. The first function does so at zero force and requires a > b. The second
 * does so at zero overlap, by the path that creeps, and requires n > 0. */
bool complex_law_zero_force(struct complex_ball *log_eps, const struct cor_exponents *law, struct complex_ball log_beta,
                            const struct complex_law_pressing *pressing, const struct complex_law_path *path);
bool complex_law_creep(struct complex_ball *log_eps, const struct cor_exponents *law, struct complex_ball log_beta,
                       const struct complex_law_path *path);

#endif
