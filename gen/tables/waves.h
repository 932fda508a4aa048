/* SPDX-License-Identifier: MIT */
/* generated/wave_tables.h: J(nu), the share of a half-space's compliance that radiates waves (docs/laws.md). */
#ifndef COR_GEN_TABLES_WAVES_H
#define COR_GEN_TABLES_WAVES_H

#include <stdio.h>

int wave_tables_write(FILE *file);

/* |J| is below WAVE_ELLIPSE_BOUND on the ellipse with foci 0 and WAVE_TAU_END whose half axes add up to WAVE_ELLIPSE
 * times half of WAVE_TAU_END, and J is analytic inside: tests/gen/test_waves.c proves both, arc by arc. */
#define WAVE_TAU_END 1.75
#define WAVE_ELLIPSE 1.5
#define WAVE_ELLIPSE_BOUND 40.0

#endif
