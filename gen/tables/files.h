/* SPDX-License-Identifier: MIT */
/* The files of generated/ and the headers of corgen law: a function for each writes it to a stream, and returns
 * STATUS_OK, or another status after reporting the failure. */
#ifndef COR_GEN_TABLES_FILES_H
#define COR_GEN_TABLES_FILES_H

#include <stdio.h>

#include "series/law.h"

/* sphere_tables.h, the tables of the runtime; cor_sphere.h, the same tables and the same evaluator as one header to
 * embed; sphere_float_tables.h, those of float arithmetic. They share data that are computed once, until
 * sphere_tables_clear. */
int sphere_tables_write(FILE *file);
int sphere_header_write(FILE *file);
int sphere_float_tables_write(FILE *file);
void sphere_tables_clear(void);

/* eps and its inverse of the laws for which eps has a closed form */
int closed_form_tables_write(FILE *file);

/* Times of Tsuji's damping and of Hunt and Crossley's law without a closed form; contact time and load of the disk */
int tsuji_tables_write(FILE *file);
int hunt_crossley_tables_write(FILE *file);
int disk_law_tables_write(FILE *file);

/* The tables of the law (3/2, 0), and the header of any law x'' + beta x^b x' + x^a = 0, which needs no other file and
 * has functions NAME_eps_zero_overlap, ... The name is a C identifier of at most LAW_NAME_MAX characters. Both evaluate
 * tables of approximation/law_layout.h by runtime/table/law.h (docs/internals.md). */
enum { LAW_NAME_MAX = 48 };
int hertz_dashpot_tables_write(FILE *file);
int law_header_write(FILE *file, const struct law *law, const char *name);

/* J(nu), the share of a half-space's compliance that radiates waves (docs/laws.md). |J| is below WAVE_ELLIPSE_BOUND on
 * the ellipse with foci 0 and WAVE_TAU_END whose half axes add up to WAVE_ELLIPSE times half of WAVE_TAU_END, and J is
 * analytic inside: tests/gen/test_waves.c proves both, arc by arc. */
int wave_tables_write(FILE *file);
#define WAVE_TAU_END 1.75
#define WAVE_ELLIPSE 1.5
#define WAVE_ELLIPSE_BOUND 40.0

#endif
