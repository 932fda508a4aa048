/* SPDX-License-Identifier: MIT */
/* One collision, enclosed, at any precision and for any damping (docs/derivation.md, 6 and 9). */
#ifndef COR_GEN_ENCLOSURE_COLLISION_H
#define COR_GEN_ENCLOSURE_COLLISION_H

#include "enclosure/events.h"

/* Encloses every field to at least `bits` relative bits for an exact or ball beta >= 0 (a wide ball
 * beta limits what can be reached). An overdamped law that never parts has eps_zero_overlap exactly 0 and
 * t_zero_overlap = +inf. Returns 0, or 1 after saying on stderr what failed. */
int collision_solve(struct collision *c, const arb_t beta, const struct law *law, slong bits);

/* The same for x_max, t_max, eps_zero_overlap and t_zero_overlap alone; the other fields are not to be used. */
int collision_solve_overlap(struct collision *c, const arb_t beta, const struct law *law, slong bits);

/* The same for x_max, t_max, eps_zero_force and t_zero_force alone. Where a > b that needs no unloading to the end and
 * is cheap however strong the damping is; otherwise the two ends coincide. beta > 0. */
int collision_solve_force(struct collision *c, const arb_t beta, const struct law *law, slong bits);

/* q > 0: v_f = lim beta^(1/q) eps_zero_overlap for large beta. */
int collision_final_speed(arb_t v_f, const struct law *law, slong bits);

/* h* = v_f^q for spheres: eps_zero_overlap -> (h_star/beta)^5. */
int collision_h_star(arb_t h_star, slong bits);

/* q < 0: beta_c, from which on the bodies never part at zero overlap, and C* = beta_c^(2/n) x_max there. */
int collision_threshold(arb_t beta_c, arb_t c_star, const struct law *law, slong bits);

/* The series in beta by a second route, the ODE carried in power series of beta: y_k, tau_k and C_k for
 * k = 0..order, computed with prec bits. Returns 0, or 1 after saying what failed. */
int collision_series(arb_poly_t y, arb_poly_t tau, arb_poly_t c, slong order, const struct law *law, slong prec);

#endif
