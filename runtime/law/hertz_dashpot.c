/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdint.h>
#include <string.h>

/* All functions of the evaluator must be inlined: otherwise the constants of the law are copied, which takes five times
 * as long. */
#ifdef __GNUC__
#define COR_INLINE static inline __attribute__((always_inline))
#endif

#include "runtime/law/functions.h"
#include "runtime/law/hertz_dashpot_approach_only.h"

/* ---- tables of the loops ---- */

COR_INLINE const double *first_row(struct cor_inline_law_table table)
{
    return table.kind ? table.rows(0) : NULL;
}

/* Returns the table for the loops. If the function is beta times a row, the table begins at a beta > 0. If the variable
 * of the rows near 0 is a cube root of beta, the table omits them, and the scalar function evaluates them. */
COR_INLINE struct cor_row_table table_of_quantity(struct cor_inline_law_quantity q, enum cor_row_value value)
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

static const struct cor_row_table beta_rows_zero_overlap = DASHPOT_INVERSE(beta_zero_overlap, BETA_ZERO_OVERLAP),
                                  /* this table omits the rows for eps >= 1/2, whose variable is a cube root */
    beta_rows_zero_force = COR_ROW_TABLE_OF_OCTAVES(cor_rows_hertz_dashpot_beta_zero_force,
                                                    COR_ROWS_HERTZ_DASHPOT_BETA_ZERO_FORCE, COR_ROW_SUM);

/* This function must be inlined, so that the table consists of constants. */
COR_INLINE void quantity_array(struct cor_inline_law_quantity quantity, enum cor_row_value value, double (*one)(double),
                               const double *x, double *y, size_t n)
{
    const struct cor_row_table table = table_of_quantity(quantity, value);
    cor_row_array(&table, one, x, y, n);
}

/* ---- the functions of the table: x is beta, eps or 1 - eps ---- */

/* clang-format off */
static double eps_zero_overlap(double x) { return cor_inline_hertz_dashpot_eps_zero_overlap(x); }
static double loss_zero_overlap(double x) { return cor_inline_hertz_dashpot_loss_zero_overlap(x); }
static double beta_zero_overlap(double x) { return cor_inline_hertz_dashpot_beta_zero_overlap(x); }
static double beta_of_loss_zero_overlap(double x) { return cor_inline_hertz_dashpot_beta_of_loss_zero_overlap(x); }
static double duration_zero_overlap(double x) { return cor_inline_hertz_dashpot_duration_zero_overlap(x); }
static double eps_zero_force(double x) { return cor_inline_hertz_dashpot_eps_zero_force(x); }
static double loss_zero_force(double x) { return cor_inline_hertz_dashpot_loss_zero_force(x); }
static double beta_zero_force(double x) { return cor_inline_hertz_dashpot_beta_zero_force(x); }
static double beta_of_loss_zero_force(double x) { return cor_inline_hertz_dashpot_beta_of_loss_zero_force(x); }
static double duration_zero_force(double x) { return cor_inline_hertz_dashpot_duration_zero_force(x); }
static double max_overlap(double x) { return cor_inline_hertz_dashpot_max_overlap(x); }
static double time_of_max_overlap(double x) { return cor_inline_hertz_dashpot_time_of_max_overlap(x); }
static double eps_approach_only(double x) { return cor_hertz_eps(&dashpot_law, x); }
static double loss_approach_only(double x) { return cor_hertz_loss(&dashpot_law, x); }
static double duration_approach_only(double x) { return cor_hertz_duration(&dashpot_law, x); }
static double beta_approach_only(double x) { return dashpot_beta_approach_only(x); }
static double beta_of_loss_approach_only(double x)
{ return cor_hertz_beta_of_loss(&dashpot_law, dashpot_beta_approach_only, x); }

static void eps_zero_overlap_array(const double *x, double *y, size_t n)
{ quantity_array(cor_law_hertz_dashpot_eps_zero_overlap(), COR_ROW_EPS, eps_zero_overlap, x, y, n); }
static void loss_zero_overlap_array(const double *x, double *y, size_t n)
{ quantity_array(cor_law_hertz_dashpot_eps_zero_overlap(), COR_ROW_LOSS, loss_zero_overlap, x, y, n); }
static void beta_zero_overlap_array(const double *x, double *y, size_t n)
{ cor_row_array(&beta_rows_zero_overlap, beta_zero_overlap, x, y, n); }
static void beta_of_loss_zero_overlap_array(const double *x, double *y, size_t n)
{ cor_array_in_environment(beta_of_loss_zero_overlap, x, y, n); }
static void duration_zero_overlap_array(const double *x, double *y, size_t n)
{ quantity_array(cor_law_hertz_dashpot_duration_zero_overlap(), COR_ROW_SUM, duration_zero_overlap, x, y, n); }
static void eps_zero_force_array(const double *x, double *y, size_t n)
{ quantity_array(cor_law_hertz_dashpot_eps_zero_force(), COR_ROW_EPS, eps_zero_force, x, y, n); }
static void loss_zero_force_array(const double *x, double *y, size_t n)
{ quantity_array(cor_law_hertz_dashpot_eps_zero_force(), COR_ROW_LOSS, loss_zero_force, x, y, n); }
static void beta_zero_force_array(const double *x, double *y, size_t n)
{ cor_row_array(&beta_rows_zero_force, beta_zero_force, x, y, n); }
static void beta_of_loss_zero_force_array(const double *x, double *y, size_t n)
{ cor_array_in_environment(beta_of_loss_zero_force, x, y, n); }
static void duration_zero_force_array(const double *x, double *y, size_t n)
{ quantity_array(cor_law_hertz_dashpot_duration_zero_force(), COR_ROW_SUM, duration_zero_force, x, y, n); }
static void max_overlap_array(const double *x, double *y, size_t n)
{ quantity_array(cor_law_hertz_dashpot_max_overlap(), COR_ROW_SUM, max_overlap, x, y, n); }
static void time_of_max_overlap_array(const double *x, double *y, size_t n)
{ quantity_array(cor_law_hertz_dashpot_time_of_max_overlap(), COR_ROW_SUM, time_of_max_overlap, x, y, n); }
static void eps_approach_only_array(const double *x, double *y, size_t n)
{ cor_row_array(&dashpot_law.eps, eps_approach_only, x, y, n); }
static void loss_approach_only_array(const double *x, double *y, size_t n)
{ cor_row_array(&dashpot_law.loss, loss_approach_only, x, y, n); }
static void duration_approach_only_array(const double *x, double *y, size_t n)
{ cor_row_array(&dashpot_law.duration, duration_approach_only, x, y, n); }
static void beta_approach_only_array(const double *x, double *y, size_t n)
{ cor_row_array(&dashpot_law.beta, beta_approach_only, x, y, n); }
static void beta_of_loss_approach_only_array(const double *x, double *y, size_t n)
{ cor_array_in_environment(beta_of_loss_approach_only, x, y, n); }
/* clang-format on */

#define ROWS(end, ulp)                                                                                                 \
    {                                                                                                                  \
        COR_LAW_ROW("hertz_dashpot_eps_" #end, eps_##end, 0, INFINITY, ulp),                                           \
            COR_LAW_ROW("hertz_dashpot_loss_" #end, loss_##end, 0, INFINITY, ulp),                                     \
            COR_LAW_ROW("hertz_dashpot_damping_of_eps_" #end, beta_##end, 0, 1, 2),                                    \
            COR_LAW_ROW("hertz_dashpot_damping_of_loss_" #end, beta_of_loss_##end, 0, 1, 2),                           \
            COR_LAW_ROW("hertz_dashpot_duration_" #end, duration_##end, 0, INFINITY, 2),                               \
            COR_LAW_ROW("hertz_dashpot_max_overlap", max_overlap, 0, INFINITY, 1),                                     \
            COR_LAW_ROW("hertz_dashpot_time_of_max_overlap", time_of_max_overlap, 0, INFINITY, 2)                      \
    }

/* In the order of enum cor_quantity */
const cor_law_functions cor_hertz_dashpot_functions = {
    [COR_END_ZERO_OVERLAP] = ROWS(zero_overlap, 1),
    [COR_END_ZERO_FORCE] = ROWS(zero_force, 1),
    [COR_END_APPROACH_ONLY] = ROWS(approach_only, 2),
};
