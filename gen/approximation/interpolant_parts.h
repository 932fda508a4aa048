/* SPDX-License-Identifier: MIT */
/* Declarations shared by the parts of the interpolant. Each part calls only the parts before it: samples
 * (interpolant_samples.c), continuation of the last interval (interpolant_far.c), construction and values
 * (interpolant_values.c), inverse functions (interpolant_inverse.c). */
#ifndef COR_GEN_APPROXIMATION_INTERPOLANT_PARTS_H
#define COR_GEN_APPROXIMATION_INTERPOLANT_PARTS_H

#include "approximation/interpolant.h"

enum {
    INTERPOLANT_BITS = 320 /* working precision */,
    INTERPOLANT_GUARD = 96,     /* bits lost by cancellation in powers of t */
    INTERPOLANT_NODE_BITS = 640 /* bits of the nodes; divided differences lose many */
};

static inline bool has_quantity(const struct interval *interval, enum quantity quantity)
{
    return interval->set & 1u << quantity;
}

/* Computes an exact beta near the value x of an interval's variable, and the variable at this beta. beta is exact
 * because a strongly damped collision would widen an uncertainty of beta a thousandfold. */
void interpolant_place(arb_t beta, arb_t variable, const struct interpolant *f, const struct interval *interval,
                       double x);
void samples_init(struct samples *s, slong count);
void samples_clear(struct samples *s, slong count);
/* Computes the collision at the beta of each known sample. Sets the sample's values in the form that the interval
 * stores, rounded to the bits of the interval; they count as exact. */
int samples_collide(struct samples *s, int intervals, const struct interpolant *f, const struct interval *interval,
                    const char *step);

/* Computes beta^power at beta = exp(u). */
void interpolant_power(arb_t y, const arb_t u, struct ratio power, slong prec);
/* Computes beta from the value x of a variable. */
void interpolant_beta(arb_t beta, const struct interpolant *f, enum interval_variable variable, const arb_t x,
                      slong prec);
/* Returns the quantity, or its counterpart at zero overlap if a <= b, because the two ends then coincide. */
enum quantity interpolant_end(const struct interpolant *f, enum quantity quantity);

/* Returns the largest value of a variable at which the quantity is sampled, or -HUGE_VAL if it never is. */
double interpolant_last(const struct interpolant *f, enum quantity quantity, enum interval_variable variable);

/* Fits the far coefficients to an equal number of samples. */
int interpolant_make_far(struct interpolant *f);
/* Computes the quantity at beta = exp(u) from the far coefficients. */
void interpolant_far_value(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t u, slong prec);

#endif
