/* SPDX-License-Identifier: MIT */
/* Collisions of spheres that adhere as Johnson, Kendall and Roberts have it (docs/theory.md, 22), in the units
 *
 *     contact radius  c = c_0 u^2, c_0^3 = 2 pi w R^2/E*     overlap  (c_0^2/R) (u^4 - u)     force  pi w R
 *     time  T = (m c_0^2/(pi w R^2))^(1/2)                   speed  V = c_0^2/(R T)
 *
 * With x = u^4 - u the force is f = (8/3) u^6 - 4 u^3 and the motion x'' + kappa u^power x' + f = 0. The bodies touch
 * at x = 0 with the speed 1/V, where the contact jumps to u = 1. */
#ifndef COR_RUNTIME_SCENE_JKR_H
#define COR_RUNTIME_SCENE_JKR_H

#include "runtime/scene/motion.h"

/* The collision of a contact with adhesion_j_m2 > 0 and the damping coefficient C, in SI units, at a speed > 0. Returns
 * COR_OK, or COR_FAULT_PRESSED where the motion takes too many steps. */
int cor_jkr_impact(struct cor_full_impact *impact, const struct cor_scene_contact *contact, double coefficient,
                   double speed_m_s);

/* The speed up to which the bodies stay together, m/s; NaN where a motion takes too many steps */
double cor_jkr_sticking_speed(const struct cor_scene_contact *contact, double coefficient, int end);

/* Whether the damper of a law has a contact radius: exponents 0, 1/4, 1/2 and 3/2 of Hertz's laws */
int cor_jkr_has_law(const struct cor_exponents *law);

#endif
