/* SPDX-License-Identifier: MIT */
/* Tables and headers that corgen writes: the files of generated/ and the headers of corgen law and corgen pade. For
 * each file a function writes it to a stream and returns STATUS_OK, or another status after reporting the failure. A
 * new file of generated/ needs such a function and a row of files[] in directory.c. */
#ifndef COR_GEN_TABLES_FILES_H
#define COR_GEN_TABLES_FILES_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "approximation/pade.h"
#include "disk/modes.h"
#include "series/law.h"
#include "support/decimal.h"
#include "support/emit_c.h"

/* Write cor_sphere.h (the evaluator as a header to embed, which includes the tables), sphere_rows.h (these tables) and
 * sphere_float_tables.h (tables of float arithmetic). The tables share data that are computed once and freed by
 * sphere_tables_clear. */
int sphere_header_write(FILE *file);
int sphere_rows_write(FILE *file);
int sphere_float_tables_write(FILE *file);
void sphere_tables_clear(void);

/* Writes the tables of eps and its inverse for the laws whose eps has a closed form. */
int closed_form_tables_write(FILE *file);

/* Writes tables: times of Tsuji's damping and Hunt and Crossley's law, contact time and load of the disk. */
int tsuji_tables_write(FILE *file);
int hunt_crossley_tables_write(FILE *file);
int disk_law_tables_write(FILE *file);

/* Write the tables of the law (3/2, 0), and the header of any law x'' + beta x^b x' + x^a = 0. The header needs no
 * other file and has functions NAME_eps_zero_overlap, ... The name is a C identifier of at most LAW_NAME_MAX
 * characters. Both files contain tables of approximation/law_layout.h, which runtime/table/law.h evaluates
 * (docs/internals.md). */
enum { LAW_NAME_MAX = 48 };
int hertz_dashpot_tables_write(FILE *file);
int law_header_write(FILE *file, const struct cor_exponents *law, const char *name);

/* Writes the table of J(nu), the share of a half-space's compliance that radiates waves (docs/laws.md). An ellipse has
 * the foci 0 and WAVE_TAU_END, and half axes that add up to WAVE_ELLIPSE times half of WAVE_TAU_END. J is analytic
 * inside the ellipse, and |J| is below WAVE_ELLIPSE_BOUND on it. tests/gen/test_waves.c proves both statements, arc by
 * arc. */
int wave_tables_write(FILE *file);
#define WAVE_TAU_END 1.75
#define WAVE_ELLIPSE 1.5
#define WAVE_ELLIPSE_BOUND 40.0

/* ---- the modes of one material, the doubles nearest to the exact values, as a C header and as a file to load ---- */

enum { DISK_TABLE_MODES = 1800, DISK_TABLE_POISSON = 60 /* characters */, DISK_TABLE_NAME = 160 };

struct disk_table {
    struct decimal poisson; /* text of nu, not owned; file names and comments contain it unchanged */
    slong count;
    bool embed; /* a header for a user's program: decimal numbers, which C++ accepts */
    struct disk_modes modes;
};

/* Returns the table's name in C and in file names, as in disk_modes_nu033.h. */
const char *disk_table_name(char name[DISK_TABLE_NAME], const struct disk_table *table, const char *extension);

/* Compute and write the modes. table->modes must be {0} at first. Each function returns STATUS_OK, or STATUS_FAILED
 * after reporting the reason. Call disk_modes_clear(&table->modes) in either case. */
int disk_table_solve(struct disk_table *table);
int disk_header_write(FILE *file, const struct disk_table *table);
int disk_file_write(FILE *file, const struct disk_table *table);

/* ---- disk_limits.h, the table behind cor_disk_eps ----
 *
 * Collisions of disks with a rigid wall, with all modes, over cells of speed and Poisson's ratio. Cells are divided
 * until their polynomials are accurate enough. The collisions take a quarter of an hour of CPU time, so corgen is built
 * with a copy of them. */

#define DISK_LIMITS_FILE "disk_limits.h"

struct cor_disk_limit_piece;

/* These functions return STATUS_OK, or STATUS_FAILED after reporting the reason. */
int disk_limits_collide(void); /* computes all collisions */
/* True if a table is in memory. It is from disk_limits_collide, or else it is the table with which corgen was built. If
 * `piece` is not NULL, the table in memory becomes the built-in table with these pieces. With COR_BOOTSTRAP, corgen has
 * no built-in table. */
bool disk_limits_known(const struct cor_disk_limit_piece *piece);

int disk_limits_write(FILE *file);

/* Recompute collisions at some points of one cell, which the seed chooses, or at all points of all cells. Print the
 * difference of 1 - eps^2 on standard output. Return STATUS_FAILED also if the difference exceeds DISK_LIMITS_AGREE,
 * or if the error of a cell's polynomial between its points exceeds its uncertainty. */
#define DISK_LIMITS_AGREE 2.5e-7
int disk_limits_check_sample(uint64_t seed);
int disk_limits_check_all(void);

/* ---- a Padé approximant in a C header: two functions, their arrays, the bounds, and the origin of the bounds ---- */

struct pade_header {
    const char *name;  /* prefix of the arrays and, in capitals, of the macros */
    const char *title; /* first line of the header's comment */
    enum cor_end end;
    slong beta_max;                      /* the bounds hold up to this beta */
    const struct references *references; /* NULL: no approximation error is stated */
};

/* Emits name_p, name_q, name_l (ascending powers of z), NAME_P, NAME_Q, NAME_L, name_eps(beta) and name_loss(beta),
 * which need math.h. With references it also emits NAME_{EPS,LOSS}_{APPROXIMATION,EVALUATION,MAX}_REL up to
 * NAME_BETA_MAX. Returns 0, or 1 after reporting the reason. */
int pade_emit(struct emit *e, const struct pade_header *h, const struct pade *f, const struct pade_analysis *a);

/* ---- directory.c: all files of generated/, or the mode tables of one material. corgen writes them, or checks that it
 * would write the same bytes. ---- */

#define TABLES_MAX_SEED 1000000000

struct tables_request {
    struct decimal poisson; /* Poisson's ratio of the material; text NULL: files of generated/ */
    slong modes;            /* number of modes of that material; 0: DISK_TABLE_MODES */
    const char *directory;  /* NULL: generated, or the current directory for a material */
    bool check;             /* compare without writing */
    bool digits;            /* write the digits of the coefficients as csv to standard output, and no files */
    bool all;               /* compute all collisions of disk_limits.h again */
    slong seed;             /* chooses the points at which a check recomputes collisions; below 0: by the clock */
};

/* Returns STATUS_OK, or another status after a message. */
int tables_run(const struct tables_request *request);

#endif
