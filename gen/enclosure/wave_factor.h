/* SPDX-License-Identifier: MIT */
/* Encloses J(nu), the share of a half-space's compliance that radiates waves (docs/laws.md). */
#ifndef COR_GEN_ENCLOSURE_WAVE_FACTOR_H
#define COR_GEN_ENCLOSURE_WAVE_FACTOR_H

#include "support/flint.h"

/* J as a function of tau = sqrt(1 - 2 nu), analytic on and around 0 <= tau <= sqrt(3), enclosed for every tau of the
 * interval. The result is not finite if the interval is too wide. */
void wave_factor(acb_t j, const acb_t tau, slong prec);

/* The same by one of two routes: along the real axis, singular at tau = 1, or along a path in the complex plane, which
 * begins near a branch point for small tau. */
enum wave_route { WAVE_BY_AXIS, WAVE_BY_PATH };
void wave_factor_by(acb_t j, enum wave_route route, const acb_t tau, slong prec);

#endif
