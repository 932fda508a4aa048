/* SPDX-License-Identifier: MIT */
/* One collision, enclosed, at any precision and for any damping (docs/theory.md, 6 and 9). */
#ifndef COR_GEN_ENCLOSURE_COLLISION_H
#define COR_GEN_ENCLOSURE_COLLISION_H

#include "enclosure/motion.h"

/* Encloses every field to at least `bits` relative bits for an exact or inexact beta >= 0 (a wide interval of beta
 * limits the accuracy). For an overdamped collision whose bodies never part, eps_zero_overlap is exactly 0 and
 * t_zero_overlap = +inf. Returns 0, or 1 after reporting the failure on stderr. */
int collision_solve(struct collision *c, const arb_t beta, const struct cor_exponents *law, slong bits);

/* The same for x_max, t_max, eps_zero_overlap and t_zero_overlap alone; the other fields are undefined. */
int collision_solve_overlap(struct collision *c, const arb_t beta, const struct cor_exponents *law, slong bits);

/* The same at about `below` under the threshold, which tells how many bits the motion loses */
int collision_solve_below(struct collision *c, const arb_t beta, double below, const struct cor_exponents *law,
                          slong bits);

/* The same for x_max, t_max, eps_zero_force and t_zero_force alone, for beta > 0. For a > b the function needs no
 * complete unloading and is cheap for any damping; otherwise the two ends coincide. */
int collision_solve_force(struct collision *c, const arb_t beta, const struct cor_exponents *law, slong bits);

/* The collision x'' + beta x^b x' + x^a = force >= 0 (docs/theory.md, 24), at one end, an enum cor_end, or both,
 * -1; the fields of the other end are undefined. Under a force > 0, eps_zero_force and t_zero_force are those of the
 * surface: the bodies fly from zero force to x = 0. Bodies that stay together have eps exactly 0 and t = +inf, proved.
 * Under a force it fails too near to the threshold, and where the damping is too strong to be integrated. */
int collision_solve_pressed(struct collision *c, const arb_t beta, const arb_t force, const struct cor_exponents *law,
                            int end, slong bits);

/* The force from which on the bodies stay together, for beta > 0; for q >= 0 it is the only one, and falls with beta.
 * Fails where the bodies never part without a force, either. */
int collision_sticking_force(arb_t force, const arb_t beta, const struct cor_exponents *law, int end, slong bits);

/* The impact speed up to which the bodies stay together in x'' + damping x^b x' + x^a = 1. Fails where there is none
 * up to 1e9: they stay together at every speed. */
int collision_sticking_speed(arb_t speed, const arb_t damping, const struct cor_exponents *law, int end, slong bits);

/* The largest value of x^a + beta x^b x'. Fails for the few laws of which law_force_has_one_peak does not hold. */
int collision_force_max(arb_t force, const arb_t beta, const struct cor_exponents *law, slong bits);

/* q > 0: v_f = lim beta^(1/q) eps_zero_overlap for large beta. */
int collision_final_speed(arb_t v_f, const struct cor_exponents *law, slong bits);

/* h* = v_f^q for spheres: eps_zero_overlap -> (h_star/beta)^5. */
int collision_h_star(arb_t h_star, slong bits);

/* q <= 0: beta_c, from which on the bodies never part at zero overlap, and for q < 0 C* = beta_c^(2/n) x_max there. */
int collision_threshold(arb_t beta_c, arb_t c_star, const struct cor_exponents *law, slong bits);

#endif
