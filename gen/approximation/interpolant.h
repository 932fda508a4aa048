/* SPDX-License-Identifier: MIT */
/* Interpolates every quantity of a law's collision by polynomials of high degree through enclosed collisions
 * (collision.h). A value takes microseconds. corgen cuts the tables from these functions, compares the tables with
 * them, and inverts them.
 *
 * The samples are enclosed and correctly rounded. The rounded samples count as exact, so all later steps are arithmetic
 * and give the same result with every library. interpolant_check measures the error between the samples. A layout
 * defines the variables and intervals. The sphere's layout has z = sqrt(beta) up to beta = 17, in which both ends of
 * contact are analytic. For u = ln(beta) >= 2 the quantities are powers of beta times functions of mu = beta^(-5/3) and
 * mu ln(beta). law_layout.h has the layout of any law. */
#ifndef COR_GEN_APPROXIMATION_INTERPOLANT_H
#define COR_GEN_APPROXIMATION_INTERPOLANT_H

#include <stdbool.h>

#include "series/law.h"

/* Returns point j of the n Chebyshev points on [-1, 1] in ascending order, with the accuracy of a double. */
double chebyshev_point(slong j, slong n);

/* Computes t, which is linear in x, -1 at x = lo and 1 at x = hi. */
void unit_place(arb_t t, const arb_t x, double lo, double hi, slong prec);

/* Rounds the ball x to `bits` bits; the result counts as exact. Returns false if the ball is too wide to be rounded. */
bool sample_rounded(arb_t y, const arb_t x, slong bits);

enum quantity {
    EPS_ZERO_OVERLAP,
    EPS_ZERO_FORCE,
    DURATION_ZERO_OVERLAP,
    DURATION_ZERO_FORCE,
    MAX_OVERLAP,
    TIME_OF_MAX_OVERLAP,
    QUANTITIES,
    /* (1 - eps)/beta, computed from eps at the same end */
    LOSS_QUOTIENT_ZERO_OVERLAP = QUANTITIES,
    LOSS_QUOTIENT_ZERO_FORCE,
    /* the inverse functions: beta of eps, and beta/(1 - eps) of the loss 1 - eps */
    BETA_ZERO_OVERLAP,
    BETA_ZERO_FORCE,
    BETA_QUOTIENT_ZERO_OVERLAP,
    BETA_QUOTIENT_ZERO_FORCE,
    /* damping during the approach only; computed from the largest overlap and its time */
    EPS_APPROACH_ONLY,
    LOSS_QUOTIENT_APPROACH_ONLY,
    DURATION_APPROACH_ONLY,
    BETA_APPROACH_ONLY,
    BETA_QUOTIENT_APPROACH_ONLY
};

/* Sets of the sampled quantities, one bit for each */
enum {
    SET_LENGTHS = 1 << MAX_OVERLAP | 1 << TIME_OF_MAX_OVERLAP,
    SET_ZERO_OVERLAP = 1 << EPS_ZERO_OVERLAP | 1 << DURATION_ZERO_OVERLAP,
    SET_ZERO_FORCE = 1 << EPS_ZERO_FORCE | 1 << DURATION_ZERO_FORCE,
    SET_ALL = SET_LENGTHS | SET_ZERO_OVERLAP | SET_ZERO_FORCE
};

enum interval_variable {
    INTERVAL_ROOT, /* z = beta^(1/root) */
    INTERVAL_LOG,  /* u = ln(beta) */
    INTERVAL_BELOW /* v = ln(beta_c - beta), for laws whose zero overlap has a threshold beta_c */
};

/* The form in which a quantity is sampled */
enum interval_form {
    FORM_VALUE,
    FORM_QUOTIENT, /* (1 - eps)/beta instead of eps */
    FORM_LOG,      /* ln(eps) instead of eps, which may fall by many powers of ten */
    FORM_POWER     /* the quantity divided by its power of beta, interpolant_tail_power */
};

struct interval {
    enum interval_variable variable;
    double lo, hi;
    slong count, bits;
    enum interval_form form;
    unsigned set; /* set of quantities */
};

struct interpolant_layout {
    struct cor_exponents law;
    slong root;
    const struct interval *interval;
    int intervals;
    bool far; /* true to compute the far coefficients, for u beyond the last interval */
    /* NULL without a force, otherwise c: one contact under one constant force has f = c beta^(-2a/n) at every speed
     * (docs/theory.md, 24). All intervals are then in u and contain only eps at one end. */
    arb_srcptr press;
    double press_log; /* u of the sticking speed, where eps has a branch point */
};

/* The layout of spheres. row_proof.h proves its results. */
extern const struct interpolant_layout interpolant_sphere_proof;

/* Nodes and values of an interval, and the polynomials through them in t, -1 <= t <= 1. `known` is false if the
 * interval is outside beta_min to beta_max. */
struct samples {
    bool known;
    arb_ptr beta, node, value[QUANTITIES];
    arb_poly_struct polynomial[QUANTITIES];
};

/* Far coefficients, for u beyond the last interval. Except for terms of order mu^3, mu = beta^(-(a+1)/(b+1)), the
 * scaled quantity is a linear combination of 1, u; mu, mu u, mu u^2; mu^2, ..., mu^2 u^3. For other laws the duration
 * at zero overlap is this sum times beta^(a/(b+1)) plus `fall` times beta^((a-1)/n). `fall` is 0 if a - b = 1 or n = 1
 * - a, because the sum then contains that term (docs/theory.md, 9). */
enum { INTERPOLANT_FAR = 9 };

struct interpolant {
    const struct interpolant_layout *layout;
    struct samples *samples; /* samples of each interval */
    arb_ptr far[QUANTITIES]; /* INTERPOLANT_FAR coefficients each */
    arb_t fall;
    arb_t threshold, final_speed;       /* beta_c for q <= 0, otherwise infinite; v_f for q > 0, otherwise 0 */
    arb_poly_t backward, backward_time; /* series G and T (restitution.h), if they give zero force near beta = 0 */
};

static inline bool is_eps(enum quantity quantity)
{
    return quantity == EPS_ZERO_OVERLAP || quantity == EPS_ZERO_FORCE;
}

static inline bool is_of_force(enum quantity quantity)
{
    return quantity == EPS_ZERO_FORCE || quantity == DURATION_ZERO_FORCE;
}

static inline bool is_of_overlap(enum quantity quantity)
{
    return quantity == EPS_ZERO_OVERLAP || quantity == DURATION_ZERO_OVERLAP;
}

/* Returns the sampled quantity from which another quantity is computed. */
static inline enum quantity sampled_quantity(enum quantity quantity)
{
    return quantity < QUANTITIES           ? quantity
           : quantity >= EPS_APPROACH_ONLY ? MAX_OVERLAP
           : (quantity - QUANTITIES) % 2   ? EPS_ZERO_FORCE
                                           : EPS_ZERO_OVERLAP;
}

/* Computes the interpolant for arguments between beta_min and beta_max, which may be INFINITY. The layout must outlive
 * the interpolant. Returns NULL after reporting the failure on stderr. */
struct interpolant *interpolant_new(const struct interpolant_layout *layout, double beta_min, double beta_max);
void interpolant_free(struct interpolant *f);

/* Computes the polynomial in t through the current samples of a quantity. */
void interpolant_through_samples(arb_poly_t p, const struct samples *s, const struct interval *interval,
                                 enum quantity quantity);

/* Returns beta, as a double, at the value x of an interval's variable. */
double interpolant_beta_near(const struct interpolant *f, const struct interval *interval, double x);

/* Returns the power -2a/n of beta in the constant force of a layout (`press`). */
struct ratio interpolant_press_power(const struct cor_exponents *law);

/* Computes the quantity at x, a value of a variable that has an interval for it. (1 - eps)/beta keeps its accuracy near
 * eps = 1. For spheres intervals in z end at beta = 8.25 for quantities of zero overlap and at 17 for the others. */
void interpolant_at(arb_t y, const struct interpolant *f, enum quantity quantity, enum interval_variable variable,
                    const arb_t x, slong prec);

/* Computes the quantity at beta, in any variable that has an interval for it. */
void interpolant_at_beta(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t beta, slong prec);

/* Computes the number that an interval of FORM_POWER stores; in an interval of another form, computes the quantity. In
 * u this number is the quantity divided by its power of beta, interpolant_tail_power. For spheres 2 <= u <= 10, and eps
 * at zero overlap is h*^5 beta^-5 there. In v, for q = 0, the number is the duration at zero overlap times
 * eps^((a-1)/(a+1)), which is regular at beta_c. */
void interpolant_tail(arb_t y, const struct interpolant *f, enum quantity quantity, enum interval_variable variable,
                      const arb_t x, slong prec);
struct ratio interpolant_tail_power(const struct cor_exponents *law, enum quantity quantity);

/* Computes an inverse function at an exact x. For BETA_... x is eps, for spheres from 2^-13 (zero overlap) or 2^-23.6
 * (zero force) to 1. For BETA_QUOTIENT_... x is the loss, 0 to 3/4. Returns 0, or 1 after reporting the failure. */
int interpolant_inverse(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t x, slong prec);

/* Returns the far coefficients of a quantity. */
arb_srcptr interpolant_far(const struct interpolant *f, enum quantity quantity);

/* Computes a; b_0, b_1, b_2; c_0, ..., c_4 of the inverse of eps at zero force beyond the last u, for spheres:
 *
 *     beta = (a/eps)^(3/5) (1 + e (b_0 + ... + b_2 v^2) + e^2 (c_0 + ... + c_4 v^4)),   e = eps/a,   v = -(3/5) ln(e)
 *
 * up to terms in e^3. The coefficients follow by formal inversion of the sum of interpolant_far, whose coefficient of u
 * is 0. */
enum { INTERPOLANT_FAR_INVERSE = 9 };
void interpolant_far_inverse(arb_ptr coefficient, const struct interpolant *f);

/* Sets *error to the largest relative difference from enclosed collisions, at `points` >= 2 places of each interval. */
int interpolant_check(double *error, const struct interpolant *f, int points);

#endif
