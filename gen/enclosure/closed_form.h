/* SPDX-License-Identifier: MIT */
/* Computes collisions in closed form (docs/theory.md, 9): laws with q = 0, whose u = x^((a+1)/2) obeys a linear
 * equation, and the law of Hunt and Crossley, a = b. Also computes an integral of docs/laws.md. */
#ifndef COR_GEN_ENCLOSURE_CLOSED_FORM_H
#define COR_GEN_ENCLOSURE_CLOSED_FORM_H

#include "enclosure/motion.h"

/* Computes A = acos(zeta)/sqrt(1 - zeta^2), continued through zeta = 1 to acosh(zeta)/sqrt(zeta^2 - 1); zeta > -1. */
void closed_form_angle(arb_t angle, const arb_t zeta, slong prec);

/* For q = 0 and beta > 0, computes x_max, both eps and t_zero_overlap, and for a = 1 also t_max and t_zero_force. For
 * zeta = beta/sqrt(2(a+1)) >= 1, eps at zero overlap is 0 and t_zero_overlap is +inf. */
void closed_form_linear(struct collision *c, const arb_t beta, const struct cor_exponents *law, slong prec);

/* For a = b and beta > 0, computes x_max and eps, which is equal at both ends. */
void closed_form_hunt_crossley(struct collision *c, const arb_t beta, const struct cor_exponents *law, slong prec);

/* ---- wave_factor.c: J(nu), the share of a half-space's compliance that radiates waves (docs/laws.md) ---- */

/* Computes J as a function of tau = sqrt(1 - 2 nu), analytic on and around 0 <= tau <= sqrt(3), enclosed for every tau
 * of the interval. The result is not finite if the interval is too wide. */
void wave_factor(acb_t j, const acb_t tau, slong prec);

/* Computes J by one of two routes. The route along the real axis is singular at tau = 1. The route along a path in the
 * complex plane begins near a branch point for small tau. */
enum wave_route { WAVE_BY_AXIS, WAVE_BY_PATH };
void wave_factor_by(acb_t j, enum wave_route route, const acb_t tau, slong prec);

#endif
