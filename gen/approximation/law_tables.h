/* SPDX-License-Identifier: MIT */
/* All numbers of a law's tables, cut from one interpolant: the rows of a layout (law_layout.h) and the coefficients
 * beyond the rows (form: docs/internals.md). */
#ifndef COR_GEN_APPROXIMATION_LAW_TABLES_H
#define COR_GEN_APPROXIMATION_LAW_TABLES_H

#include "approximation/law_layout.h"

enum { LAW_TABLE_NAME_MAX = 192, FAR_COLUMNS = INTERPOLANT_FAR + 2, INVERSE_COLUMNS = INTERPOLANT_FAR_INVERSE + 1 };

struct law_tables {
    struct law_layout layout; /* owned */
    struct interpolant *f;
    double error;                     /* error of the interpolant, sampled */
    char (*name)[LAW_TABLE_NAME_MAX]; /* of each table of the layout */
};

/* Computes the tables of t->layout, which the caller has initialised; a table's name is PREFIX_STEM. Adds samples if
 * the interpolant is off by more than 4e-18. Returns 0, or 1 after reporting the failure; call law_tables_clear in
 * either case. */
int law_tables_make(struct law_tables *t, const char *prefix);
void law_tables_clear(struct law_tables *t);

/* Writes all rows, of doubles or of floats. This function and those below return 0, or 1 after reporting an interval
 * that is too wide. */
int law_tables_emit(struct emit *e, const struct law_tables *t, bool floats);

/* Writes the rows of eps, loss, duration and inverse with damping during the approach only; sampled. */
int law_tables_emit_approach(struct emit *e, const struct law_tables *t, const char *prefix);

/* Whether the quantity has coefficients beyond the rows, and whether it has a further term there
 * (`fall` of interpolant.h) */
bool law_tables_have_far(const struct law_tables *t, enum quantity quantity);
bool law_tables_have_fall(const struct law_tables *t, enum quantity quantity);

/* The numbers of one row, and how many: FAR_COLUMNS, the coefficients a_0, a_0', a_1, a_1', a_2, ... of a quantity,
 * where a dash marks the remainder of a double; of eps at zero overlap v_f, as two doubles; INVERSE_COLUMNS for
 * BETA_ZERO_FORCE, beyond the rows: a, a', b_0, ... (interpolant_far_inverse). */
slong law_tables_far_row(arb_ptr row, const struct law_tables *t, enum quantity quantity);

/* Write such a row; the further term as two doubles. */
int law_tables_emit_far(struct emit *e, const struct law_tables *t, enum quantity quantity, const char *name);
int law_tables_emit_fall(struct emit *e, const struct law_tables *t, const char *name);

#endif
