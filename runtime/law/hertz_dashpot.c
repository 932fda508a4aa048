/* SPDX-License-Identifier: MIT */
#include "cor/hertz_dashpot.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* If one function of the evaluator stays a call, the constants of the law are copied, which takes five times as
 * long. */
#ifdef __GNUC__
#define COR_INLINE static inline __attribute__((always_inline))
#endif

#include "runtime/law/dashpot_array.h"
#include "runtime/law/hertz_dashpot_approach_only.h"
#include "runtime/number/environment.h"
#include "runtime/table/row_loops.h"

/* ---- tables of the loops ---- */

static const double *first_row(struct cor_inline_law_table table)
{
    return table.kind ? table.rows(0) : NULL;
}

/* The least beta > 0 of a product with beta; rows near 0 in a cube root of beta are left to the scalar function. */
static inline struct cor_row_table table_of_quantity(struct cor_inline_law_quantity q, enum cor_row_value value)
{
    const int has_near = q.near.root == 1, has_below = has_near && q.below.kind != 0;
    const struct cor_row_table table = {.kind = has_near ? COR_ROW_PARTS : COR_ROW_OCTAVES,
                                        .value = has_near || value == COR_ROW_LOSS ? value : COR_ROW_SUM,
                                        .least = !has_near              ? q.near.end
                                                 : value == COR_ROW_SUM ? 0
                                                                        : COR_INLINE_2_M900,
                                        .end = has_below ? q.threshold.hi : q.middle.end,
                                        .also = has_near ? 0 : q.near.end,
                                        .near = first_row(q.near),
                                        .middle = first_row(q.middle),
                                        .below = first_row(q.below),
                                        .step = q.near.grid.step,
                                        .per_unit = q.near.grid.per_unit,
                                        .near_end = q.near.end,
                                        .middle_end = q.middle.end,
                                        .octaves = q.middle.octaves,
                                        .below_octaves = q.below.octaves,
                                        .threshold = q.threshold};
    return table;
}

#define GRID(quantity, QUANTITY, value, least)                                                                         \
    COR_ROW_TABLE_OF_GRID(cor_rows_hertz_dashpot_##quantity, COR_ROWS_HERTZ_DASHPOT_##QUANTITY, COR_ROW_GRID, value,   \
                          least, 0)
#define INVERSE(quantity, QUANTITY)                                                                                    \
    COR_ROW_TABLE_OF_INVERSE(COR_ROW_INVERSE, cor_rows_hertz_dashpot_near_##quantity,                                  \
                             COR_ROWS_HERTZ_DASHPOT_NEAR_##QUANTITY, cor_rows_hertz_dashpot_##quantity,                \
                             COR_ROWS_HERTZ_DASHPOT_##QUANTITY)

static struct cor_row_table dashpot_table(enum cor_dashpot_number function)
{
    static const struct cor_row_table of_eps_and_approach[] = {
        INVERSE(beta_zero_overlap, BETA_ZERO_OVERLAP),
        /* from 1/2 on the rows are in a cube root */
        COR_ROW_TABLE_OF_OCTAVES(cor_rows_hertz_dashpot_beta_zero_force, COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_FORCE,
                                 COR_ROW_SUM),
        GRID(eps_approach_only, EPS_APPROACH_ONLY, COR_ROW_SUM, 0),
        GRID(loss_approach_only, LOSS_APPROACH_ONLY, COR_ROW_PRODUCT, COR_INLINE_2_M900),
        GRID(duration_approach_only, DURATION_APPROACH_ONLY, COR_ROW_SUM, 0),
        INVERSE(beta_approach_only, BETA_APPROACH_ONLY)};
#define PARTS(function, tables, value)                                                                                 \
    case COR_DASHPOT_##function:                                                                                       \
        return table_of_quantity(cor_law_hertz_dashpot_##tables(), value);
    switch (function) {
        PARTS(eps_zero_overlap, eps_zero_overlap, COR_ROW_EPS)
        PARTS(eps_zero_force, eps_zero_force, COR_ROW_EPS)
        PARTS(loss_zero_overlap, eps_zero_overlap, COR_ROW_LOSS)
        PARTS(loss_zero_force, eps_zero_force, COR_ROW_LOSS)
        PARTS(duration_zero_overlap, duration_zero_overlap, COR_ROW_SUM)
        PARTS(duration_zero_force, duration_zero_force, COR_ROW_SUM)
        PARTS(max_overlap, max_overlap, COR_ROW_SUM)
        PARTS(time_of_max_overlap, time_of_max_overlap, COR_ROW_SUM)
    default:
        return of_eps_and_approach[function - COR_DASHPOT_beta_zero_overlap];
    }
}

/* ---- the functions of hertz_dashpot.h ---- */

#define SCALARS(quantity)                                                                                              \
    double cor_hertz_dashpot_##quantity(double x)                                                                      \
    {                                                                                                                  \
        return cor_inline_hertz_dashpot_##quantity(x);                                                                 \
    }                                                                                                                  \
    float cor_hertz_dashpot_##quantity##f(float x)                                                                     \
    {                                                                                                                  \
        return (float)cor_hertz_dashpot_##quantity((double)x);                                                         \
    }
COR_DASHPOT_LOOPS(SCALARS, SCALARS)

/* ---- arrays ---- */

#define SCALAR_(function) cor_hertz_dashpot_##function,
#define SCALARF_(function) cor_hertz_dashpot_##function##f,
static double (*const scalar[])(double) = {COR_DASHPOT_LOOPS(SCALAR_, SCALAR_)};
static float (*const scalarf[])(float) = {COR_DASHPOT_LOOPS(SCALARF_, SCALARF_)};

int cor_dashpot_array_of_set(int set, enum cor_dashpot_number function, const double *in, double *out, size_t n)
{
    const struct cor_row_loops *const loops = cor_row_loops(set);
    const struct cor_row_table table = dashpot_table(function);
    const struct cor_row_call call = {&table, scalar[function], NULL, NULL, NULL, 0};
    const struct cor_environment caller = cor_environment_enter();
    if (loops)
        loops->doubles(&call, in, out, n);
    cor_environment_leave(&caller);
    return loops != NULL;
}

static void dashpot_floats(enum cor_dashpot_number function, const float *in, float *out, size_t n)
{
    const struct cor_row_table table = dashpot_table(function);
    const struct cor_environment caller = cor_environment_enter();
    cor_row_loops(cor_widest_set())->floats(&table, scalarf[function], NAN, in, out, n);
    cor_environment_leave(&caller);
}

#define ARRAYS(function)                                                                                               \
    void cor_hertz_dashpot_##function##_array(const double *x, double *y, size_t n)                                    \
    {                                                                                                                  \
        cor_dashpot_array_of_set(cor_widest_set(), COR_DASHPOT_##function, x, y, n);                                   \
    }                                                                                                                  \
    void cor_hertz_dashpot_##function##_arrayf(const float *x, float *y, size_t n)                                     \
    {                                                                                                                  \
        dashpot_floats(COR_DASHPOT_##function, x, y, n);                                                               \
    }
COR_DASHPOT_LOOPS(ARRAYS, ARRAYS)

/* Arrays of these are computed one number after the other. */
#define ONE_BY_ONE(quantity)                                                                                           \
    SCALARS(quantity)                                                                                                  \
    COR_ARRAY_IN_ENVIRONMENT(double, cor_hertz_dashpot_##quantity##_array, cor_hertz_dashpot_##quantity)               \
    COR_ARRAY_IN_ENVIRONMENT(float, cor_hertz_dashpot_##quantity##_arrayf, cor_hertz_dashpot_##quantity##f)
ONE_BY_ONE(beta_of_loss_zero_overlap)
ONE_BY_ONE(beta_of_loss_zero_force)
ONE_BY_ONE(beta_of_loss_approach_only)
