/* SPDX-License-Identifier: MIT */
/* Interface of row_kernel.c: array functions that evaluate a row of a table (row.h) for each number. A table is data,
 * so all quantities and laws share the loops. */
#ifndef COR_RUNTIME_ROW_LOOPS_H
#define COR_RUNTIME_ROW_LOOPS_H

#include <stddef.h>

#include "runtime/number/sets.h"
#include "runtime/table/float_lanes.h"
#include "runtime/table/row.h"

/* Kinds of tables. `near`, `middle` and `below` are the parts of a table, each with rows on a grid or by octaves. */
enum cor_row_kind {
    COR_ROW_NONE,         /* no rows: the value is x */
    COR_ROW_GRID,         /* `near` is on the grid of x */
    COR_ROW_ROOT,         /* `near` is on the grid of sqrt(x) */
    COR_ROW_ROOT_S,       /* as COR_ROW_ROOT, with s = x - node^2 in rows whose node is at least near_end */
    COR_ROW_OCTAVES,      /* middle: by octaves of x */
    COR_ROW_INVERSE,      /* x >= 1/2: `near`, on the grid of 1 - x. x < 1/2: `middle`, by octaves of x */
    COR_ROW_INVERSE_ROOT, /* as COR_ROW_INVERSE, with the grid of sqrt(1 - x) */
    COR_ROW_PARTS         /* `near` is on the grid of x up to near_end, `middle` by octaves of x up to middle_end, and
                           * `below` by octaves of threshold - x. `near` and `below` may be missing: NULL. */
};

/* The value of a row. SUM: c_0 + row. PRODUCT: m (c_0 + row), where m is x for grids and the near part, 1 - x for the
 * near rows of an inverse, and 1 for other rows. EPS and LOSS: the near part has rows of the loss 1 - eps, the other
 * parts have rows of eps; EPS gives eps and LOSS the loss for every x. */
enum cor_row_value { COR_ROW_SUM, COR_ROW_PRODUCT, COR_ROW_EPS, COR_ROW_LOSS };

/* The table contains every x from `least` to below `end`, and the number `also`, which is a float. */
struct cor_row_table {
    enum cor_row_kind kind;
    enum cor_row_value value;
    double least, end, also;
    const double *near, *middle, *below; /* first rows */
    double step, per_unit;               /* step of the grid, whose first node is 0, and 1/step */
    double near_end, middle_end;
    struct cor_inline_octaves octaves, below_octaves;
    struct cor_inline_pair threshold;
};

#define COR_ROW_OCTAVES_(ROWS)                                                                                         \
    {                                                                                                                  \
        ROWS##_FIRST, ROWS##_OCTAVE_BITS                                                                               \
    }
#define COR_ROW_TABLE_OF_GRID(rows, ROWS, of_kind, of_value, from, from_s)                                             \
    {                                                                                                                  \
        .kind = of_kind, .value = of_value, .least = from, .end = ROWS##_END, .near = rows##_row[0],                   \
        .step = ROWS##_STEP, .per_unit = ROWS##_PER_UNIT, .near_end = from_s                                           \
    }
#define COR_ROW_TABLE_OF_OCTAVES(rows, ROWS, of_value)                                                                 \
    {                                                                                                                  \
        .kind = COR_ROW_OCTAVES, .value = of_value, .least = ROWS##_FIRST, .end = ROWS##_END, .also = ROWS##_FIRST,    \
        .middle = rows##_row[0], .octaves = COR_ROW_OCTAVES_(ROWS)                                                     \
    }
#define COR_ROW_TABLE_OF_PARTS(near_rows, NEAR, rows, ROWS, of_value, from)                                            \
    {                                                                                                                  \
        .kind = COR_ROW_PARTS, .value = of_value, .least = from, .end = ROWS##_END, .near = near_rows##_row[0],        \
        .middle = rows##_row[0], .step = NEAR##_STEP, .per_unit = NEAR##_PER_UNIT, .near_end = NEAR##_END,             \
        .middle_end = ROWS##_END, .octaves = COR_ROW_OCTAVES_(ROWS)                                                    \
    }
#define COR_ROW_TABLE_OF_INVERSE(of_kind, near_rows, NEAR, rows, ROWS)                                                 \
    {                                                                                                                  \
        .kind = of_kind, .value = COR_ROW_PRODUCT, .least = ROWS##_FIRST, .end = 1, .also = 1,                         \
        .near = near_rows##_row[0], .middle = rows##_row[0], .step = NEAR##_STEP, .per_unit = NEAR##_PER_UNIT,         \
        .near_end = 0.5, .octaves = COR_ROW_OCTAVES_(ROWS)                                                             \
    }

/* One block of m elements that starts at index i. in: the caller's values. x: arguments of the table. taken: a copy of
 * x with other numbers in place of the `outside` elements that the table does not contain. */
struct cor_row_block {
    size_t i, m, outside;
    const double *in, *x, *taken;
};

/* For each block, `before` makes the arguments of the table from m numbers. If always_after is true, or an argument is
 * not in the table, `after` completes the values. Without `after`, `one` computes the numbers that are not in the
 * table. */
struct cor_row_call {
    const struct cor_row_table *table;
    double (*one)(double x);
    void *context;
    void (*before)(void *context, const double *in, double *x, size_t m); /* NULL: the numbers themselves */
    void (*after)(void *context, const struct cor_row_block *block, double *value);
    int always_after;
};

/* The loops of an instruction set. doubles: in double arithmetic. floats: in float arithmetic. block: computes the
 * values of at most COR_ROW_BLOCK numbers x; the arrays have this length. Where the table does not contain a number,
 * `taken` differs from x, and the value is undefined. */
enum { COR_ROW_BLOCK = 256 };
struct cor_row_loops {
    const char *name;
    void (*doubles)(const struct cor_row_call *call, const double *in, double *out, size_t n);
    void (*floats)(const struct float_table *table, double (*one)(double x), const float *in, float *out, size_t n);
    void (*block)(const struct cor_row_table *table, const double *x, double *taken, double *value, size_t m);
};
COR_TABLES(struct cor_row_loops, cor_row_loops, cor_row_loops)

/* Sets y[i] to the function of x[i] by the rows of a table, in the default environment. `one` computes numbers that the
 * table does not contain. With COR_WITHOUT_LOOPS, for a small module (web/run), `one` computes every number. */
void cor_row_array(const struct cor_row_table *table, double (*one)(double x), const double *x, double *y, size_t n);

/* Returns the instruction set of the array functions: the widest of this processor. A test defines its own version. */
int cor_array_set(void);

/* Return the place of x in the near and in the middle rows of a table, for the scalar functions. */
COR_KERNEL struct cor_inline_place cor_row_near(const struct cor_row_table *table, double x)
{
    const struct cor_inline_grid grid = {0, table->step, table->per_unit};
    const int i = cor_inline_grid_row(grid, x);
    return cor_inline_place_of(table->near + i * COR_INLINE_COLUMNS, cor_inline_grid_t(grid, x, i));
}

COR_KERNEL struct cor_inline_place cor_row_middle(const struct cor_row_table *table, double x)
{
    return cor_inline_place_of(table->middle + cor_inline_octaves_row(table->octaves, x) * COR_INLINE_COLUMNS,
                               cor_inline_octaves_t(table->octaves, x));
}

#endif
