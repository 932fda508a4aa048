/* SPDX-License-Identifier: MIT */
/* Makes enclosed Taylor steps in the polynomial form of the equation of motion (docs/theory.md, 6),
 *
 *   x = w^d, dt = w^(d-1) dsigma:   dw/dsigma = v/d,  dv/dsigma = -w^(d-1) (c1 w^(bd) v + c2 w^(ad) - c3),
 *                                   dt/dsigma = w^(d-1).
 *
 * Every number is an interval (Arb ball) that contains the exact one. The constant force c3 is 0 unless the caller sets
 * it, which requires d > 1. */
#ifndef COR_GEN_ENCLOSURE_TAYLOR_H
#define COR_GEN_ENCLOSURE_TAYLOR_H

#include "series/law.h"

struct taylor {
    struct cor_exponents law;
    slong degree, prec;
    arb_t c1, c2, c3;
    arb_ptr one, w, v, t;                /* arrays of degree + 1 Taylor coefficients */
    arb_ptr force, whole_force;          /* c1 w^(bd-m) v + c2 w^(ad-m), m = min(ad, bd); force times w^(d-1+m) */
    arb_ptr time_slope, elastic, damped; /* w^(d-1), w^(ad-m), w^(bd-m) v */
    struct taylor_product *product;      /* the products in the order of their computation */
    int products;
    mag_t error_w, error_v, error_t; /* remainders on [0, step] */
    arb_t step;                      /* longest step for which the remainders are proved */
};

void taylor_init(struct taylor *y, const struct cor_exponents *law, slong degree, slong prec);
void taylor_clear(struct taylor *y);

/* Computes all Taylor coefficients of w, v and t from w[0], v[0] and t[0], the values at sigma = 0. */
void taylor_expand(struct taylor *y);

/* Chooses a step and proves the remainders on it. Returns false if it finds no step, because the state is too wide. */
bool taylor_choose_step(struct taylor *y);

/* TAYLOR_FORCE is the force divided by w^min(ad, bd). TAYLOR_FORCE_SLOPE is its derivative by sigma, divided by the
 * power of w that all terms share. Where b = 0 and a > 1, TAYLOR_DAMPING_EXCESS is positive while the damping force
 * exceeds a/(a - 1) times the elastic force. */
enum taylor_component { TAYLOR_W, TAYLOR_V, TAYLOR_T, TAYLOR_FORCE, TAYLOR_FORCE_SLOPE, TAYLOR_DAMPING_EXCESS };

/* Computes a component at sigma = s in [0, step], remainder included. */
void taylor_value(arb_t value, const struct taylor *y, enum taylor_component component, const arb_t s);

/* Advances the state to sigma = s. */
void taylor_advance(struct taylor *y, const arb_t s);

/* Finds whether a component, positive at begin, is negative at end <= step. If so, encloses its zero, which must be the
 * only one. */
enum taylor_crossing { TAYLOR_NOT_YET, TAYLOR_CROSSED, TAYLOR_UNDECIDED };
enum taylor_crossing taylor_crosses(arb_t root, const struct taylor *y, enum taylor_component component,
                                    const arb_t begin, const arb_t end);

/* Makes steps until a component falls to zero, and encloses the zero in the last step. Returns false if intervals do
 * not decide. what: the text of the progress line */
bool taylor_follow(arb_t root, struct taylor *y, enum taylor_component component, const char *what);

/* Returns the degree of the Taylor polynomials for prec bits. */
slong taylor_degree(slong prec);

/* Largest number of steps of a motion */
enum { TAYLOR_MAX_STEPS = 200000 };

#endif
