/* SPDX-License-Identifier: MIT */
/* Tables of rows (runtime/table/row.h): each row and the next one give the same number where their cells meet. This
 * detects a wrong number in any row, without a reference. */
#include "check.h"

#include "generated/disk_law_tables.h"
#include "generated/hertz_dashpot_tables.h"
#include "generated/hunt_crossley_tables.h"
#include "generated/sphere_rows.h"
#include "generated/tsuji_tables.h"
#include "runtime/law/closed_form.h"
#include "runtime/table/row.h"

#define MOST 2 /* units of DBL_EPSILON: two roundings, and the errors of two rows */

struct table {
    const char *name;
    const double *(*rows)(int);
    int count, roots; /* roots: first row in s = z^2 - node^2 */
    double first, step;
};

#define TABLE(name, NAME, roots, ...)                                                                                  \
    {                                                                                                                  \
#name, cor_rows_##name, COR_ROWS_##NAME##_ROWS, COR_ROWS_##NAME##_##roots, __VA_ARGS__                         \
    }
#define AT(NAME) COR_ROWS_##NAME##_FIRST, COR_ROWS_##NAME##_STEP
#define GRID(name, NAME) TABLE(name, NAME, ROWS, AT(NAME))
#define ROOT_GRID(name, NAME) TABLE(name, NAME, PLAIN_ROWS, AT(NAME))
/* all octaves have the same cells */
#define OCTAVES(name, NAME) TABLE(name, NAME, ROWS, 0, 1.0 / (1 << COR_ROWS_##NAME##_OCTAVE_BITS))
#define TAILED(name, NAME) GRID(name, NAME), GRID(tail_##name, TAIL_##NAME)
#define NEAR(name, NAME) GRID(hertz_dashpot_near_##name, HERTZ_DASHPOT_NEAR_##NAME)
#define FAR(name, NAME) OCTAVES(hertz_dashpot_##name, HERTZ_DASHPOT_##NAME)
#define DASHPOT(name, NAME, last, LAST)                                                                                \
    NEAR(name, NAME), FAR(middle_##name, MIDDLE_##NAME), FAR(last##_##name, LAST##_##NAME)

#define CLOSED_FORM(law, x, end, LAW, X, END)                                                                          \
    GRID(law##_loss##end, LAW##_LOSS##END), OCTAVES(law##_eps##end, LAW##_EPS##END),                                   \
        GRID(law##_near_##x##end, LAW##_NEAR_##X##END), OCTAVES(law##_##x##end, LAW##_##X##END),

static const struct table tables[] = {
    CLOSED_FORM(ratio, zeta, _zero_overlap, RATIO, ZETA, _ZERO_OVERLAP)
        CLOSED_FORM(ratio, zeta, _zero_force, RATIO, ZETA, _ZERO_FORCE)
            CLOSED_FORM(ratio, zeta, _limited, RATIO, ZETA, _LIMITED)
                CLOSED_FORM(ratio, zeta, _approach_only, RATIO, ZETA, _APPROACH_ONLY)
                    CLOSED_FORM(crossley, beta, , CROSSLEY, BETA, )
                        CLOSED_FORM(crossley, beta, _approach_only, CROSSLEY, BETA, _APPROACH_ONLY)
                            GRID(eps_zero_overlap, EPS_ZERO_OVERLAP),
    ROOT_GRID(eps_zero_force, EPS_ZERO_FORCE),
    OCTAVES(power_eps_zero_overlap, POWER_EPS_ZERO_OVERLAP),
    OCTAVES(power_eps_zero_force, POWER_EPS_ZERO_FORCE),
    GRID(loss_zero_overlap, LOSS_ZERO_OVERLAP),
    ROOT_GRID(loss_zero_force, LOSS_ZERO_FORCE),
    GRID(tail_eps_zero_force, TAIL_EPS_ZERO_FORCE),
    TAILED(duration_zero_overlap, DURATION_ZERO_OVERLAP),
    TAILED(duration_zero_force, DURATION_ZERO_FORCE),
    TAILED(max_overlap, MAX_OVERLAP),
    TAILED(time_of_max_overlap, TIME_OF_MAX_OVERLAP),
    GRID(near_beta_zero_overlap, NEAR_BETA_ZERO_OVERLAP),
    GRID(near_beta_zero_force, NEAR_BETA_ZERO_FORCE),
    OCTAVES(beta_zero_overlap, BETA_ZERO_OVERLAP),
    OCTAVES(beta_zero_force, BETA_ZERO_FORCE),
    NEAR(loss_zero_overlap, LOSS_ZERO_OVERLAP),
    FAR(middle_eps_zero_overlap, MIDDLE_EPS_ZERO_OVERLAP),
    FAR(below_eps_zero_overlap, BELOW_EPS_ZERO_OVERLAP),
    NEAR(beta_zero_overlap, BETA_ZERO_OVERLAP),
    FAR(beta_zero_overlap, BETA_ZERO_OVERLAP),
    NEAR(loss_zero_force, LOSS_ZERO_FORCE),
    FAR(middle_eps_zero_force, MIDDLE_EPS_ZERO_FORCE),
    FAR(tail_eps_zero_force, TAIL_EPS_ZERO_FORCE),
    NEAR(beta_zero_force, BETA_ZERO_FORCE),
    FAR(beta_zero_force, BETA_ZERO_FORCE),
    DASHPOT(duration_zero_overlap, DURATION_ZERO_OVERLAP, below, BELOW),
    DASHPOT(duration_zero_force, DURATION_ZERO_FORCE, tail, TAIL),
    DASHPOT(max_overlap, MAX_OVERLAP, tail, TAIL),
    DASHPOT(time_of_max_overlap, TIME_OF_MAX_OVERLAP, tail, TAIL),
    GRID(crossley_time_of_max_overlap_1, CROSSLEY_TIME_OF_MAX_OVERLAP_1),
    GRID(crossley_time_of_max_overlap_3_2, CROSSLEY_TIME_OF_MAX_OVERLAP_3_2),
    GRID(crossley_duration_1, CROSSLEY_DURATION_1),
    GRID(crossley_duration_3_2, CROSSLEY_DURATION_3_2),
    GRID(tsuji_time_of_max_overlap, TSUJI_TIME_OF_MAX_OVERLAP),
    GRID(tsuji_duration_zero_force_weak, TSUJI_DURATION_ZERO_FORCE_WEAK),
    GRID(tsuji_duration_zero_force, TSUJI_DURATION_ZERO_FORCE),
    GRID(tsuji_duration_limited_weak, TSUJI_DURATION_LIMITED_WEAK),
    GRID(tsuji_duration_limited, TSUJI_DURATION_LIMITED),
    GRID(tsuji_duration_zero_overlap, TSUJI_DURATION_ZERO_OVERLAP),
    OCTAVES(tsuji_overlap_factor, TSUJI_OVERLAP_FACTOR),
    OCTAVES(disk_contact_time, DISK_CONTACT_TIME),
    OCTAVES(disk_load_factor, DISK_LOAD_FACTOR),
};

/* Returns the value of row i at half a cell from its node, to one side. */
static double end_of(const struct table *t, int i, double side)
{
    const double at = side * t->step / 2, node = t->first + i * t->step;
    struct cor_inline_place place = cor_inline_place_of(t->rows(i), at);
    if (i >= t->roots) {
        place.s = at * (2 * node + at);
        place.has_s = 1;
    }
    return cor_inline_row_value(place);
}

TEST(rows_join)
{
    for (size_t k = 0; k < COUNT_OF(tables); k++) {
        const struct table *const t = &tables[k];
        for (int i = 0; i + 1 < t->count; i++) {
            const double end = end_of(t, i, 1), next = end_of(t, i + 1, -1);
            check(fabs(next - end) <= MOST * DBL_EPSILON * fabs(end), "%s: rows %d and %d meet in %.17g and %.17g",
                  t->name, i, i + 1, end, next);
        }
    }
}
