/* SPDX-License-Identifier: MIT */
/* Computes the time of a sphere from zero force to zero overlap at strong damping, by a divergent series whose
 * remainder is bounded for every beta (docs/theory.md, 8).
 *
 * Let x = beta^-4 z, t = beta t', k = -z'/z and r = z^(-1/2). The unloading begins at k = 1 and r = 1/Y, where
 * Y = beta^2 sqrt(x) at zero force, and
 *
 *     k' = 2 (1/k - 1 + k r)/r^2,   dt' = 2 dr/(k r)
 *
 *     t' = 2 ln(Y) + C + a_1/Y + a_2/Y^2 + ... + a_n/Y^n + remainder.
 *
 * C is the same number for every Y. The remainder of order n decreases with Y. */
#ifndef COR_GEN_ENCLOSURE_CREEP_SERIES_H
#define COR_GEN_ENCLOSURE_CREEP_SERIES_H

#include "support/flint.h"

enum { CREEP_SERIES_ORDER = 30, CREEP_SERIES_LEAST_Y = 34 };

struct creep_series {
    arb_ptr a;           /* a_j, 1 <= j <= CREEP_SERIES_ORDER */
    arb_t start, factor; /* constants in the bound of the remainder */
};

/* Computes a_j with `prec` bits, and the constants in the bound. */
void creep_series_init(struct creep_series *s, slong prec);
void creep_series_clear(struct creep_series *s);

/* Bounds the remainder for every Y >= 1/r. The bound is infinite if 1/r < CREEP_SERIES_LEAST_Y. */
void creep_series_remainder(arb_t bound, const struct creep_series *s, const arb_t r);

#endif
