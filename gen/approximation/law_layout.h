/* SPDX-License-Identifier: MIT */
/* The sample intervals and the tables of any law (docs/theory.md, 9; form: docs/internals.md). The layout of spheres is
 * given as data (tables/sphere.c). The layout of another law is derived from its exponents:
 *
 *   near    beta < near_end, a power of two, at most an eighth of the radius of convergence of the series in beta: rows
 *           in beta and, at zero force, in beta^(1/root); for eps rows of (1 - eps)/beta
 *   middle  up to beta = 8, or to overlap_end if zero overlap then has rows in beta_c - beta: octaves of beta
 *   tail    powers of beta times rows by octaves of ln(beta), up to last_log
 *   far     the same powers times the far coefficients
 *   below   zero overlap just below a threshold beta_c: octaves of beta_c - beta
 *
 * The inverse has rows of beta/(1 - eps) in 1 - eps or its root, and of beta by octaves of eps. */
#ifndef COR_GEN_APPROXIMATION_LAW_LAYOUT_H
#define COR_GEN_APPROXIMATION_LAW_LAYOUT_H

#include "approximation/interpolant.h"
#include "approximation/pieces.h"

#define LAW_MIDDLE_END 8.0
#define LAW_TAIL_FIRST 2.0 /* ln(beta) */

/* Parts of the range of beta or eps; a table covers one part */
enum law_part { PART_NEAR, PART_MIDDLE, PART_TAIL, PART_BELOW, PART_INVERSE_NEAR, PART_INVERSE };

struct law_table {
    enum law_part part;       /* the part that the rows cover */
    enum quantity serves;     /* quantity of the functions that use the rows; derived layouts only */
    char stem[40], title[64]; /* end of the table's name; first line of its comment */
    struct pieces rows;       /* input of pieces_make; if rows = 0, input of pieces_fit. If first is NAN, the rows of
                               * an inverse begin at law_layout_inverse_octave(). */
};

struct law_layout {
    struct interpolant_layout interpolant; /* owns its intervals */
    slong root;                            /* root of beta and of 1 - eps in the near rows of eps at zero force */
    slong root_of_time;                    /* root of beta in the near rows of the duration at zero force; the
                                            * duration also has powers beta^(1/(a-b)) */
    double near_end, last_log;
    double overlap_end; /* beta where middle rows of zero overlap end and rows in beta_c - beta, if any, begin */
    double overlap_log; /* q > 0: ln(beta) at which the tail rows of eps at zero overlap end. 0: no such rows,
                         * because eps = v_f beta^(-1/q) for beta >= overlap_end */
    double below_first, below_end; /* range of beta_c - beta in these rows; it begins at the double below beta_c */
    double threshold;              /* beta_c, or infinity */
    struct law_table *table;       /* owned */
    int tables;
    int check_points; /* points in each interval for interpolant_check; 0: the polynomials are proved */
};

/* Derives the layout of a law. Returns 0, or 1 after reporting the failure or the reason why the law has no tables. */
int law_layout_init(struct law_layout *layout, const struct cor_exponents *law);
/* Initialises a layout whose samples and tables are data. */
void law_layout_init_given(struct law_layout *layout, const struct interpolant_layout *interpolant,
                           const struct law_table *table, int tables);
/* Adds points to every interval, for an interpolant that was not accurate enough. */
void law_layout_refine(struct law_layout *layout);
/* Reduces the layout to eps at one end, for beta_min and above, which needs fewer collisions. The interpolant then has
 * no other quantities. For zero force, adds intervals in ln(beta) near beta = 0, because the proof of law_proof.c
 * cannot use zero overlap. */
void law_layout_restrict(struct law_layout *layout, enum quantity eps, double beta_min);
void law_layout_clear(struct law_layout *layout);

/* Returns the octave at which the rows of the inverse of eps begin. */
double law_layout_inverse_octave(const struct law_layout *layout, const struct interpolant *f, enum quantity eps);

/* ---- law_tables.c: all numbers of a law's tables, cut from one interpolant: the rows of a layout and the coefficients
 * beyond the rows (form: docs/internals.md) ---- */

enum { LAW_TABLE_NAME_MAX = 192, FAR_COLUMNS = INTERPOLANT_FAR + 2, INVERSE_COLUMNS = INTERPOLANT_FAR_INVERSE + 1 };

struct law_tables {
    struct law_layout layout; /* owned */
    struct interpolant *f;
    double error;                     /* sampled error of the interpolant */
    char (*name)[LAW_TABLE_NAME_MAX]; /* name of each table of the layout */
};

/* Computes the tables of t->layout, which the caller has initialised. A table is named PREFIX_STEM. Adds samples if the
 * interpolant's error is above 4e-18. Returns 0, or 1 after reporting the failure. Call law_tables_clear in either
 * case. */
int law_tables_make(struct law_tables *t, const char *prefix);
void law_tables_clear(struct law_tables *t);

/* Writes all rows, as doubles or floats. This function and the emitting functions below return 0, or 1 after reporting
 * an interval that is too wide. */
int law_tables_emit(struct emit *e, const struct law_tables *t, bool floats);

/* Writes the rows of eps, loss, duration and inverse for damping during the approach only. Errors are sampled. */
int law_tables_emit_approach(struct emit *e, const struct law_tables *t, const char *prefix);

/* True if the quantity has coefficients beyond the rows */
bool law_tables_have_far(const struct law_tables *t, enum quantity quantity);
/* True if the quantity also has the coefficient `fall` (interpolant.h) */
bool law_tables_have_fall(const struct law_tables *t, enum quantity quantity);

/* Computes one row and returns its length. FAR_COLUMNS: the coefficients a_0, a_0', a_1, a_1', a_2, ... of a quantity,
 * where a' is the remainder of the double a. For eps at zero overlap: v_f as two doubles. INVERSE_COLUMNS, for
 * BETA_ZERO_FORCE beyond the rows: a, a', b_0, ... (interpolant_far_inverse). */
slong law_tables_far_row(arb_ptr row, const struct law_tables *t, enum quantity quantity);

/* Writes the row of law_tables_far_row. */
int law_tables_emit_far(struct emit *e, const struct law_tables *t, enum quantity quantity, const char *name);
/* Writes the coefficient `fall` as two doubles. */
int law_tables_emit_fall(struct emit *e, const struct law_tables *t, const char *name);

#endif
