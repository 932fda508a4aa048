/* SPDX-License-Identifier: MIT */
/* Every quantity of the sphere's collision as a function that costs microseconds: polynomials of high degree
 * through enclosed collisions (collision.h). What is cut into pieces, sampled and searched is this.
 *
 * The samples are enclosed, rounded to 90 bits, 76 in u (proved) and from there on exact, so everything made
 * of them is a matter of arithmetic, the same with every library. Between them the error is sampled:
 * interpolant_check. Variables: z = sqrt(beta) up to beta = 17, in which both ends of contact are analytic, and
 * u = ln(beta) from u = 2 on, where the quantities are powers of beta times functions of mu = beta^(-5/3)
 * and mu ln(beta). */
#ifndef COR_GEN_APPROXIMATION_INTERPOLANT_H
#define COR_GEN_APPROXIMATION_INTERPOLANT_H

#include "series/law.h"

enum quantity {
    EPS_ZERO_OVERLAP,
    EPS_ZERO_FORCE,
    DURATION_ZERO_OVERLAP,
    DURATION_ZERO_FORCE,
    MAX_OVERLAP,
    TIME_OF_MAX_OVERLAP,
    QUANTITIES,
    /* (1 - eps)/beta, made of the eps of that end */
    LOSS_QUOTIENT_ZERO_OVERLAP = QUANTITIES,
    LOSS_QUOTIENT_ZERO_FORCE,
    /* the inverse functions: beta of eps, and beta/(1 - eps) of the loss 1 - eps */
    BETA_ZERO_OVERLAP,
    BETA_ZERO_FORCE,
    BETA_QUOTIENT_ZERO_OVERLAP,
    BETA_QUOTIENT_ZERO_FORCE
};

struct interpolant;

/* Point j of Chebyshev's n on [-1, 1], ascending, to the accuracy of a double: where to interpolate. */
double chebyshev_point(slong j, slong n);

/* For arguments between beta_min and beta_max only, INFINITY included: the rest is not computed. NULL after saying on
 * stderr what failed. */
struct interpolant *interpolant_new(double beta_min, double beta_max);
void interpolant_free(struct interpolant *f);

/* The quantity at z = sqrt(beta), up to beta = 8.25 for those of zero overlap, 17 for the others; (1 - eps)/beta without
 * cancellation. */
void interpolant_value(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t z, slong prec);

/* The quantity at beta = exp(u) divided by its power of beta, 2 <= u <= 10; not eps at zero overlap, which
 * is h*^5 beta^-5 there. The powers: */
void interpolant_tail(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t u, slong prec);
struct ratio interpolant_tail_power(enum quantity quantity);

/* An inverse function at an exact x: BETA_... at eps = x, from 2^-13 (zero overlap) or 2^-23.6 (zero force) to 1;
 * BETA_QUOTIENT_... at the loss x, 0 to 3/4. Returns 0, or 1 after saying what failed. */
int interpolant_inverse(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t x, slong prec);

/* Beyond: coefficients of 1, u; mu, mu u, mu u^2; mu^2, ..., mu^2 u^3, which the scaled quantity is up to terms in
 * mu^3. */
enum { INTERPOLANT_FAR = 9 };
void interpolant_far(arb_ptr coefficient, const struct interpolant *f, enum quantity quantity);

/* The inverse of eps at zero force there: a; b_0, b_1, b_2; c_0, ..., c_4 of
 *
 *     beta = (a/eps)^(3/5) (1 + e (b_0 + ... + b_2 v^2) + e^2 (c_0 + ... + c_4 v^4)),     e = eps/a,     v = -(3/5) ln(e)
 *
 * up to terms in e^3, by formal inversion of the above, whose coefficient of u is 0. */
enum { INTERPOLANT_FAR_INVERSE = 9 };
void interpolant_far_inverse(arb_ptr coefficient, const struct interpolant *f);

/* Largest relative error found at `points` places of each interval against collisions enclosed there. */
int interpolant_check(double *error, const struct interpolant *f, int points);

#endif
