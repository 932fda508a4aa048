/* SPDX-License-Identifier: MIT */
/* One collision, enclosed, at any precision and for any damping (docs/theory.md, 6 and 9). */
#ifndef COR_GEN_ENCLOSURE_COLLISION_H
#define COR_GEN_ENCLOSURE_COLLISION_H

#include "enclosure/motion.h"

/* Encloses every field to at least `bits` relative bits for an exact or inexact beta >= 0. A wide interval of beta
 * limits the accuracy. If an overdamped collision never ends, eps_zero_overlap is exactly 0 and t_zero_overlap = +inf.
 * Returns 0, or 1 after reporting the failure on stderr. */
int collision_solve(struct collision *c, const arb_t beta, const struct cor_exponents *law, slong bits);

/* Solves like collision_solve, but sets only x_max, t_max, eps_zero_overlap and t_zero_overlap. */
int collision_solve_overlap(struct collision *c, const arb_t beta, const struct cor_exponents *law, slong bits);

/* Solves like collision_solve_overlap if beta is about `below` under the threshold. The closer beta is to the
 * threshold, the more bits are lost. */
int collision_solve_below(struct collision *c, const arb_t beta, double below, const struct cor_exponents *law,
                          slong bits);

/* Solves like collision_solve for beta > 0, but sets only x_max, t_max, eps_zero_force and t_zero_force. For a > b it
 * needs no complete unloading and is fast for any damping. Otherwise the two ends coincide. */
int collision_solve_force(struct collision *c, const arb_t beta, const struct cor_exponents *law, slong bits);

/* Solves x'' + beta x^b x' + x^a = force >= 0 (docs/theory.md, 24). end: an enum cor_end, or -1 for both ends. The
 * fields of an end that is not requested are undefined. Under a force > 0, eps_zero_force and t_zero_force are values
 * at the surface: the bodies fly from zero force to x = 0. Bodies that are proved to stay together have eps exactly 0
 * and t = +inf. Under a force > 0 the function fails very close to the threshold, and if the damping is too strong for
 * the integration. */
int collision_solve_pressed(struct collision *c, const arb_t beta, const arb_t force, const struct cor_exponents *law,
                            int end, slong bits);

/* Encloses the smallest force with which the bodies stay together, for beta > 0. For q >= 0 they also stay together
 * with any larger force, and the smallest force decreases with beta. Fails if the bodies stay together even without a
 * force. */
int collision_sticking_force(arb_t force, const arb_t beta, const struct cor_exponents *law, int end, slong bits);

/* Encloses the largest impact speed at which the bodies stay together in x'' + damping x^b x' + x^a = 1. Fails if they
 * stay together at every speed up to 1e9. */
int collision_sticking_speed(arb_t speed, const arb_t damping, const struct cor_exponents *law, int end, slong bits);

/* Encloses the largest value of x^a + beta x^b x'. Fails for the few laws without one peak (law_force_has_one_peak). */
int collision_force_max(arb_t force, const arb_t beta, const struct cor_exponents *law, slong bits);

/* Encloses v_f = lim beta^(1/q) eps_zero_overlap for large beta, for q > 0. */
int collision_final_speed(arb_t v_f, const struct cor_exponents *law, slong bits);

/* Encloses h* = v_f^q for spheres: for large beta, eps_zero_overlap tends to (h_star/beta)^5. */
int collision_h_star(arb_t h_star, slong bits);

/* Encloses beta_c, for q <= 0. At zero overlap, bodies part only if beta is below beta_c. If q < 0, also encloses C* =
 * beta_c^(2/n) x_max. */
int collision_threshold(arb_t beta_c, arb_t c_star, const struct cor_exponents *law, slong bits);

#endif
