/* SPDX-License-Identifier: MIT */
/* Collisions of spheres at strong damping: series in mu = beta^(-5/3) with the logarithm u = ln(beta), proved for every
 * u >= FAR_MOTION_LEAST_U (docs/theory.md, 8). With K = EXPANSION_ORDER, a quantity without its power of beta is
 *
 *     sum_k mu^k order_k(u) + error,   |error| <= rest + rest_per_u u,   k <= K,
 *
 * where order_k is a polynomial of degree k or, for a time, k + 1. */
#ifndef COR_GEN_ENCLOSURE_FAR_MOTION_H
#define COR_GEN_ENCLOSURE_FAR_MOTION_H

#include <stdbool.h>

#include "enclosure/expansion.h"

#define FAR_MOTION_LEAST_U 9.5

struct far_series {
    arb_poly_struct order[EXPANSION_ORDER + 1];
    mag_t rest, rest_per_u;
};

struct far_motion {
    struct far_series max_overlap;         /* x_max beta^(2/3) */
    struct far_series time_of_max_overlap; /* t_max beta^(2/3) */
    struct far_series eps_zero_force;      /* eps beta^(5/3) at zero force */
    struct far_series duration_zero_force; /* duration beta^(2/3) at zero force */
};

/* Computes and proves the series. Returns false if a step of the proof fails. Call far_motion_clear in either case. */
bool far_motion_init(struct far_motion *m);
void far_motion_clear(struct far_motion *m);

/* Encloses a quantity at u >= FAR_MOTION_LEAST_U. */
void far_series_value(arb_t y, const struct far_series *s, const arb_t u, slong prec);

#endif
