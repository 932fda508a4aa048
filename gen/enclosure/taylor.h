/* SPDX-License-Identifier: MIT */
/* Enclosed Taylor steps on the polynomial form of the equation of motion (docs/derivation.md, 6),
 *
 *   x = w^d, dt = w^(d-1) dsigma:   dw/dsigma = v/d,  dv/dsigma = -w^(d-1) (c1 w^(bd) v + c2 w^(ad)),
 *                                   dt/dsigma = w^(d-1),
 *
 * for numbers (jets = 1) or power series of `jets` terms in a parameter, which c1 and c2 may contain. Every number is
 * an interval (Arb ball) that contains the exact one. */
#ifndef COR_GEN_ENCLOSURE_TAYLOR_H
#define COR_GEN_ENCLOSURE_TAYLOR_H

#include "series/law.h"

struct taylor_power; /* one product of the chain that computes the powers of w */

/* The factors of the equations are nodes: index of a power, w itself, or the number 1. */
enum { TAYLOR_NODE_W = -1, TAYLOR_NODE_ONE = -2 };

struct taylor {
    struct law law;
    slong jets, degree, prec;
    mag_t weight;           /* weight of the parameter in the norm sum |z_l| weight^l of a series */
    arb_ptr c1, c2;         /* jets each */
    arb_ptr w, v, t;        /* jets x (degree + 1) Taylor coefficients, [l * (degree + 1) + n] */
    arb_ptr force, product; /* c1 w^(bd-m) v + c2 w^(ad-m), m = min(ad, bd); and times w^(d-1+m) */
    struct taylor_power *power;
    int powers;
    int node_t, node_outer, node_damping, node_elastic;
    arb_ptr damped;                  /* w^(bd-m) v if bd > m */
    mag_t error_w, error_v, error_t; /* remainders on [0, step], in the norm */
    arb_t step;                      /* longest step for which they are proved */
};

void taylor_init(struct taylor *y, const struct law *law, slong jets, slong degree, slong prec);
void taylor_clear(struct taylor *y);

/* Computes all Taylor coefficients of w, v, t from their coefficients 0, the values at sigma = 0. */
void taylor_expand(struct taylor *y);

/* Chooses a step and proves the remainders on it. Returns false if no step was found, because the state is too wide. */
bool taylor_choose_step(struct taylor *y);

enum taylor_component { TAYLOR_W, TAYLOR_V, TAYLOR_T, TAYLOR_FORCE };

/* Component at sigma = s in [0, step], jet l, remainder included. */
void taylor_value(arb_t value, const struct taylor *y, enum taylor_component component, slong l, const arb_t s);

/* Replaces the state by the one at s. */
void taylor_advance(struct taylor *y, const arb_t s);

/* Encloses the zero of jet 0 of a component in [begin, end], end <= step, where the component falls from positive to
 * negative and is known to have only one zero. */
bool taylor_root(arb_t root, const struct taylor *y, enum taylor_component component, const arb_t begin,
                 const arb_t end);

/* Degree of the Taylor polynomials for prec bits */
slong taylor_degree(slong prec);

/* Largest number of steps of a motion */
enum { TAYLOR_MAX_STEPS = 200000 };

#endif
