/* SPDX-License-Identifier: MIT */
/* Collisions of spheres at complex damping, enclosed for all values in a ball at once (docs/theory.md, 8).
 *
 * Let y = sqrt(x), kappa = -v/x, zeta = kappa^(-1/2) and g = y/zeta, so that g^2 = |v| for real motion. The equation
 * x'' + c1 sqrt(x) x' + c2 x^(3/2) = 0 becomes a scalar rational equation between fixed ends:
 *
 *     loading, kappa < 0:    dg/dzeta = -zeta^2 C g^2/(1 + g zeta^3 C),   C = c2 zeta^2 + c1,   g = 1 at zeta = 0
 *     about the turning point, kappa = 0:   dy/dkappa = -kappa y/(2 N),   N = y (c2 - c1 kappa) + kappa^2
 *     unloading, kappa > 0: as loading with C = c2 zeta^2 - c1; zero force at zeta^2 = c1/c2, zero overlap at zeta = 0.
 *
 * All quantities are analytic in c1 and c2 where the denominators have no zero along the path (complex_path.h). */
#ifndef COR_GEN_ENCLOSURE_COMPLEX_COLLISION_H
#define COR_GEN_ENCLOSURE_COMPLEX_COLLISION_H

#include "enclosure/complex_ball.h"

struct complex_collision { /* fields as in struct collision */
    union {
        struct {
            struct complex_ball eps_zero_overlap, eps_zero_force, t_zero_overlap, t_zero_force, x_max, t_max;
        };
        struct complex_ball field[6];
    };
};

/* Encloses every quantity for all z = sqrt(beta) in a ball, by analytic continuation from z > 0. For z < 0 the fields
 * of zero force are continuations through z = 0. Without `overlap` the fields of zero overlap are undefined. Returns
 * false if the ball is too wide, or if a quantity is not analytic there. */
bool complex_collision_root(struct complex_collision *c, struct complex_ball z, bool overlap);

/* Encloses the quantities for all u = ln(beta) in a ball, in units that stay finite for large beta: eps_zero_force
 * times beta^(5/3), x_max and the times times beta^(2/3). The fields of zero overlap are undefined. */
bool complex_collision_log(struct complex_collision *c, struct complex_ball u);

#endif
