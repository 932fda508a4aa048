/* SPDX-License-Identifier: MIT */
/* One collision, enclosed, at any precision: the polynomial ODE of docs/derivation.md, 6. */
#ifndef COR_GEN_ENCLOSURE_COLLISION_H
#define COR_GEN_ENCLOSURE_COLLISION_H

#include "series/law.h"

struct collision {
    arb_t x_max, t_max;
    arb_t eps_zero_overlap, t_zero_overlap;
    arb_t eps_zero_force, t_zero_force;
};

void collision_init(struct collision *c);
void collision_clear(struct collision *c);

/* Encloses every field to at least `bits` relative bits for an exact or ball beta >= 0 (a wide ball
 * beta limits what can be reached). An overdamped law that never parts has eps_zero_overlap exactly 0 and
 * t_zero_overlap = +inf. Returns 0, or 1 after saying on stderr what failed. */
int collision_solve(struct collision *c, const arb_t beta, const struct law *law, slong bits);

/* The same for x_max, t_max, eps_zero_force and t_zero_force alone, which need no unloading to the end: cheap
 * however strong the damping is. beta > 0 and a > b; the other fields are not to be used. */
int collision_solve_force(struct collision *c, const arb_t beta, const struct law *law, slong bits);

/* h* = lim beta eps^(1/5), sphere only: eps_zero_overlap -> (h_star / beta)^5. */
int collision_h_star(arb_t h_star, slong bits);

/* The series in beta by a second route, the ODE carried in power series of beta: y_k, tau_k and C_k for
 * k = 0..order, computed with prec bits. Returns 0, or 1 after saying what failed. */
int collision_series(arb_poly_t y, arb_poly_t tau, arb_poly_t c, slong order, const struct law *law, slong prec);

#endif
