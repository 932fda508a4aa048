/* SPDX-License-Identifier: MIT */
#include "approximation/law_layout.h"

#include <math.h>
#include <stdlib.h>

#include "support/console.h"
#include "support/local.h"

enum { ATTEMPTS = 3, SPLIT_BITS = 192 };

/* Largest relative error of an interpolant that is the reference for the errors of rows */
#define INTERPOLANT_LIMIT 4e-18

/* Makes the interpolant of the layout. Adds samples while it is not accurate enough. */
static int interpolant_make(struct law_tables *t)
{
    for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
        if (attempt > 0) {
            interpolant_free(t->f); /* free the interpolant before its layout changes */
            law_layout_refine(&t->layout);
        }
        t->f = interpolant_new(&t->layout.interpolant, 0, INFINITY);
        if (!t->f || (t->layout.check_points > 0 && interpolant_check(&t->error, t->f, t->layout.check_points)))
            return STATUS_FAILED;
        if (t->error <= INTERPOLANT_LIMIT)
            return STATUS_OK;
    }
    return fail("the interpolant of the collision has an error of %.1e", t->error);
}

int law_tables_make(struct law_tables *t, const char *prefix)
{
    const struct law_layout *const layout = &t->layout;
    t->f = NULL;
    t->error = 0;
    t->name = xmalloc((size_t)layout->tables * sizeof *t->name);
    int status = interpolant_make(t);
    for (int i = 0; i < layout->tables && status == STATUS_OK; i++) {
        struct law_table *const table = &layout->table[i];
        struct pieces *const p = &table->rows;
        progress("tables", i, layout->tables);
        snprintf(t->name[i], sizeof t->name[i], "%s_%s", prefix, table->stem);
        p->name = t->name[i];
        p->title = table->title;
        if (isnan(p->first))
            p->first = law_layout_inverse_octave(layout, t->f, table->serves);
        status = (p->rows > 0 ? pieces_make : pieces_fit)(p, pieces_of_collision(t->f));
    }
    progress_end();
    return status;
}

void law_tables_clear(struct law_tables *t)
{
    for (int i = 0; t->layout.table && i < t->layout.tables; i++)
        pieces_clear(&t->layout.table[i].rows);
    free(t->name);
    interpolant_free(t->f);
    law_layout_clear(&t->layout);
}

int law_tables_emit(struct emit *e, const struct law_tables *t, bool floats)
{
    for (int i = 0; i < t->layout.tables; i++) {
        const struct pieces *const p = &t->layout.table[i].rows;
        if (p->floats == floats && pieces_emit(e, p))
            return STATUS_FAILED;
    }
    return STATUS_OK;
}

/* ---- damping during the approach only ---- */

/* The rows are in beta from 0 to 8, in 1 - eps up to 1/2, and in eps from there down to 1/64, with 16 cells to an
 * octave. If a function multiplies the row by its argument, c_0 has HEAD_BITS bits, so that its products with the two
 * parts of a split double are exact. */
enum { HEAD_BITS = 26, BETA_ROWS = 65, LOSS_ROWS = 17, EPS_FIRST = -6, EPS_ROWS = 80 };
#define IN_BETA(of, head)                                                                                              \
    .quantity = (of), .variable = VARIABLE_BETA, .step = 0.125, .end = 8, .rows = BETA_ROWS, .head_bits = (head)
static const struct {
    const char *stem, *title;
    struct pieces rows;
} approach_tables[] = {
    {"eps", "eps", {IN_BETA(EPS_APPROACH_ONLY, 0)}},
    {"loss", "(1 - eps)/beta", {IN_BETA(LOSS_QUOTIENT_APPROACH_ONLY, HEAD_BITS)}},
    {"duration", "duration", {IN_BETA(DURATION_APPROACH_ONLY, 0)}},
    {"near_beta",
     "beta/(1 - eps)",
     {.quantity = BETA_QUOTIENT_APPROACH_ONLY,
      .variable = VARIABLE_LOSS,
      .step = 0.03125,
      .end = 0.5,
      .rows = LOSS_ROWS,
      .head_bits = HEAD_BITS}},
    {"beta",
     "beta",
     {.quantity = BETA_APPROACH_ONLY,
      .variable = VARIABLE_EPS_OCTAVES,
      .first = EPS_FIRST,
      .end = 0.5,
      .octave_bits = 4,
      .rows = EPS_ROWS}},
};

int law_tables_emit_approach(struct emit *e, const struct law_tables *t, const char *prefix)
{
    int status = STATUS_OK;
    for (size_t i = 0; i < sizeof approach_tables / sizeof *approach_tables && status == STATUS_OK; i++) {
        struct pieces p = approach_tables[i].rows;
        char name[LAW_TABLE_NAME_MAX], title[LAW_TABLE_NAME_MAX];
        snprintf(name, sizeof name, "%s_%s_approach_only", prefix, approach_tables[i].stem);
        snprintf(title, sizeof title, "damped approach: %s", approach_tables[i].title);
        p.name = name;
        p.title = title;
        p.root = 1;
        p.plain = p.rows;
        p.degree = 10;
        p.least_bits = 55;
        status = pieces_write(e, &p, pieces_of_collision(t->f));
    }
    return status;
}

/* ---- beyond the rows ---- */

bool law_tables_have_far(const struct law_tables *t, enum quantity quantity)
{
    return !(is_of_overlap(quantity) && t->layout.threshold < HUGE_VAL) &&
           !(is_of_force(quantity) && !law_force_ends(&t->layout.interpolant.law));
}

bool law_tables_have_fall(const struct law_tables *t, enum quantity quantity)
{
    return quantity == DURATION_ZERO_OVERLAP && law_tables_have_far(t, quantity) && !arb_is_zero(t->f->fall);
}

/* Splits a value into its nearest double and the remainder. */
static void split_double(arb_t value, arb_t rest)
{
    arb_set_d(rest, ball_middle(value));
    arb_sub(rest, value, rest, SPLIT_BITS);
}

slong law_tables_far_row(arb_ptr row, const struct law_tables *t, enum quantity quantity)
{
    const bool speed = quantity == EPS_ZERO_OVERLAP, inverse = quantity == BETA_ZERO_FORCE;
    if (speed && law_is_hunt_crossley(&t->layout.interpolant.law)) {
        arb_one(row); /* v_f is exactly 1; an interval that contains 1 could not be split */
    } else if (speed) {
        arb_set(row, t->f->final_speed);
    } else if (inverse) {
        interpolant_far_inverse(row + 1, t->f);
        arb_set(row, row + 1);
    } else {
        const arb_srcptr far = interpolant_far(t->f, quantity);
        _arb_vec_set(row + 2, far, INTERPOLANT_FAR);
        arb_set(row, far);
        arb_set(row + 2, far + 1);
        split_double(row + 2, row + 3);
    }
    split_double(row, row + 1);
    return speed ? 2 : inverse ? INVERSE_COLUMNS : FAR_COLUMNS;
}

int law_tables_emit_far(struct emit *e, const struct law_tables *t, enum quantity quantity, const char *name)
{
    LOCAL_VECTOR(row, FAR_COLUMNS);
    return emit_one_row(e, name, row, law_tables_far_row(row, t, quantity));
}

int law_tables_emit_fall(struct emit *e, const struct law_tables *t, const char *name)
{
    LOCAL_VECTOR(row, 2);
    arb_set(row, t->f->fall);
    split_double(row, row + 1);
    return emit_one_row(e, name, row, 2);
}
