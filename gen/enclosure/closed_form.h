/* SPDX-License-Identifier: MIT */
/* Collisions in closed form (docs/theory.md, 9): laws with q = 0, whose u = x^((a+1)/2) obeys a linear equation,
 * and Hunt and Crossley's, a = b. */
#ifndef COR_GEN_ENCLOSURE_CLOSED_FORM_H
#define COR_GEN_ENCLOSURE_CLOSED_FORM_H

#include "enclosure/motion.h"

/* A(zeta) = acos(zeta)/sqrt(1 - zeta^2), analytic through zeta = 1 to acosh(zeta)/sqrt(zeta^2 - 1); zeta > -1. */
void closed_form_angle(arb_t angle, const arb_t zeta, slong prec);

/* For q = 0 and beta > 0: x_max, both eps and t_zero_overlap. From zeta = beta/sqrt(2(a+1)) = 1 on, eps at zero overlap
 * is 0 and t_zero_overlap +inf. For a = 1 also t_max and t_zero_force. */
void closed_form_linear(struct collision *c, const arb_t beta, const struct law *law, slong prec);

/* For a = b and beta > 0: x_max and eps, which is the same for both ends. */
void closed_form_hunt_crossley(struct collision *c, const arb_t beta, const struct law *law, slong prec);

#endif
