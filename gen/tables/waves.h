/* SPDX-License-Identifier: MIT */
/* generated/wave_tables.h: J(nu), the share of a half-space's compliance that radiates waves (docs/laws.md). */
#ifndef COR_GEN_TABLES_WAVES_H
#define COR_GEN_TABLES_WAVES_H

#include <stdio.h>

#include "support/flint.h"
#include "tables/disk.h"

int wave_tables_write(FILE *file, const struct disk_table *none);

/* J as a function of tau = sqrt(1 - 2 nu), in which it is analytic on 0 <= tau <= sqrt(3) and around it, enclosed for every tau of
 * the ball; not finite where the ball is too wide. */
void wave_factor(acb_t j, const acb_t tau, slong prec);

/* The same along the real axis, singular at tau = 1, or along a path in the complex plane, which begins at a branch point where
 * tau is small. */
enum wave_route { WAVE_BY_AXIS, WAVE_BY_PATH };
void wave_factor_by(acb_t j, enum wave_route route, const acb_t tau, slong prec);

/* |J| is below WAVE_ELLIPSE_BOUND on the ellipse with foci 0 and WAVE_TAU_END whose half axes add up to WAVE_ELLIPSE times half of
 * WAVE_TAU_END, and J is analytic inside: tests/gen/test_waves.c proves both, arc by arc. */
#define WAVE_TAU_END 1.75
#define WAVE_ELLIPSE 1.5
#define WAVE_ELLIPSE_BOUND 40.0

#endif
