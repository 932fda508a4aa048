/* SPDX-License-Identifier: MIT */
/* The scaled collision X'' + sqrt(X) X' + mu X^(3/2) = 0, X' = 1 at first contact, integrated by Taylor steps in a
 * form of its own. With X = w^2, ds = w dsigma and the force over -sqrt(X), f = X' + mu X,
 *
 *     dw/dsigma = (f - mu w^2)/2,     df/dsigma = -w (w f - mu f + mu^2 w^2),     ds/dsigma = w
 *
 * so that f keeps its relative accuracy while it decays. Plain floating point of MOTION_BITS bits without error
 * bounds: the generator's balls are another route. */
#ifndef COR_TESTS_ACCURACY_MOTION_H
#define COR_TESTS_ACCURACY_MOTION_H

#include <stdbool.h>

#include "support/flint.h"

enum { MOTION_BITS = 128, MOTION_DEGREE = 32 };

struct motion {
    arb_t mu;
    arb_ptr w, f, s;         /* Taylor coefficients at the state in hand, MOTION_DEGREE + 1 of each */
    arb_ptr v, square, rest; /* X', w^2, w f - mu f + mu^2 w^2 */
    arb_t step;
};

void motion_init(struct motion *m, const arb_t mu); /* first contact: w = 0, f = 1, s = 0 */
void motion_clear(struct motion *m);

/* Expands at the state in hand and chooses the step. */
void motion_expand(struct motion *m);

/* A component's polynomial at sigma. */
void motion_value(arb_t value, arb_srcptr component, const arb_t sigma);

/* Moves the state on by sigma. */
void motion_advance(struct motion *m, const arb_t sigma);

/* The zero in [0, end] of a component that is positive at 0 and negative at the end. */
void motion_zero(arb_t sigma, arb_srcptr component, const arb_t end);

/* The slow manifold of the fall, which every strongly damped unloading joins: with z = X/mu^2, t' = mu s,
 * r = z^(-1/2) = mu/w and p = -dz/dt'/z it is p = P(r), a divergent series, here for r <= 1/FALL_DEGREE. */
enum { FALL_DEGREE = 40 };

struct fall {
    arb_ptr p;    /* FALL_DEGREE + 1 coefficients of P */
    arb_ptr time; /* t' from r to the end = constant - 2 ln r - sum of time[n] r^n, n >= 1 */
    arb_t constant;
    arb_t h_star_5; /* end speed -dz/dt', the limit of beta^5 eps */
};

void fall_init(struct fall *fall);
void fall_clear(struct fall *fall);

/* The state in hand has joined the manifold. */
bool fall_joined(const struct fall *fall, const struct motion *m);

/* t' from the state in hand to zero overlap. */
void fall_time(arb_t time, const struct fall *fall, const struct motion *m);

#endif
