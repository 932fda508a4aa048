/* SPDX-License-Identifier: MIT */
/* The functions of the linear dashpot and of Tsuji's damping. eps, loss and their inverses are the same for both.
 * Tsuji's durations and the time of his largest overlap come from generated/tsuji_tables.h. */
#include "generated/tsuji_tables.h"
#include "runtime/law/closed_form.h"
#include "runtime/law/linear.h"
#include "runtime/number/fifth_root.h"
#include "runtime/table/hertz_approach_only.h"
#include "runtime/table/row.h"

/* End of the rows in ln(1 + zeta): zeta = exp(12.25) - 1 */
#define TSUJI_FAR 208980.0
/* End of the rows in zeta^(1/5): 1.3125^5 is 3.895 */
#define TSUJI_STRONG 3.89
/* Below this zeta a duration is the elastic one to the last bit: the next term is of order zeta^(4/5). */
#define TSUJI_LEAST COR_INLINE_2_M200

static double tsuji_row(struct cor_inline_grid grid, const double *(*rows)(int), struct cor_inline_pair y)
{
    return cor_grid_value(grid, rows, y).hi;
}

/* Returns zeta^(-4/5) (c_0 + c_1 u + mu (...)), u = ln(zeta), mu = 1/zeta^2, for zeta >= TSUJI_FAR. */
static double tsuji_far(double zeta, const double *c)
{
    const struct cor_inline_pair minus = cor_kernel_minus_log(cor_pair(zeta, 0));
    const struct cor_inline_pair four_fifths = cor_pair(0.8, -4.44089209850062616169e-17);
    const struct cor_inline_pair u = cor_pair(-minus.hi, -minus.lo);
    const struct cor_inline_pair power = cor_kernel_exp_minus_pair(cor_inline_pair_times(u, four_fifths));
    const double inverse = 1 / zeta, v = u.hi;
    struct cor_inline_pair sum = cor_inline_pair_times(u, cor_pair(c[2], c[3]));
    sum = cor_pair_plus(sum, cor_pair(c[0], c[1]));
    sum.lo += inverse * (inverse * (c[4] + v * (c[5] + v * c[6])));
    return cor_inline_pair_times(power, sum).hi;
}

static double tsuji_at_time_of_max_overlap(double zeta)
{
    if (!(zeta >= 0))
        return NAN;
    if (zeta < TSUJI_FAR)
        return tsuji_row(COR_INLINE_GRID(COR_ROWS_TSUJI_TIME_OF_MAX_OVERLAP), cor_rows_tsuji_time_of_max_overlap,
                         cor_kernel_log_plus_1(zeta));
    return isinf(zeta) ? 0 : tsuji_far(zeta, cor_rows_tsuji_far_time_of_max_overlap(0));
}

/* Returns the value from the rows in zeta^(1/5). The first row also contains zeta = 0. */
static double tsuji_weak(struct cor_inline_grid grid, const double *(*rows)(int), double zeta)
{
    return tsuji_row(grid, rows, zeta < TSUJI_LEAST ? cor_pair(0, 0) : cor_inline_fifth_root_parts(zeta));
}

static double tsuji_at_duration_zero_force(double zeta)
{
    if (!(zeta >= 0))
        return NAN;
    if (zeta < TSUJI_STRONG)
        return tsuji_weak(COR_INLINE_GRID(COR_ROWS_TSUJI_DURATION_ZERO_FORCE_WEAK),
                          cor_rows_tsuji_duration_zero_force_weak, zeta);
    if (zeta < TSUJI_FAR)
        return tsuji_row(COR_INLINE_GRID(COR_ROWS_TSUJI_DURATION_ZERO_FORCE), cor_rows_tsuji_duration_zero_force,
                         cor_kernel_log_plus_1(zeta));
    return isinf(zeta) ? 0 : tsuji_far(zeta, cor_rows_tsuji_far_duration_zero_force(0));
}

static double tsuji_at_duration_limited(double zeta)
{
    if (!(zeta >= 0))
        return NAN;
    if (zeta < TSUJI_STRONG)
        return tsuji_weak(COR_INLINE_GRID(COR_ROWS_TSUJI_DURATION_LIMITED_WEAK), cor_rows_tsuji_duration_limited_weak,
                          zeta);
    if (zeta < TSUJI_FAR)
        return tsuji_row(COR_INLINE_GRID(COR_ROWS_TSUJI_DURATION_LIMITED), cor_rows_tsuji_duration_limited,
                         cor_kernel_log_plus_1(zeta));
    const double *c = cor_rows_tsuji_far_duration_limited(0);
    if (isinf(zeta))
        return c[0];
    const double mu = 1 / zeta, u = -cor_kernel_minus_log(cor_pair(zeta, 0)).hi;
    return c[0] + (c[1] + mu * ((c[2] + c[4] * u) + mu * (mu * (c[5] + u * (c[6] + u * c[7])))));
}

/* Returns the duration. Beyond the rows it is exp(2 pi y) (1 - zeta^2)^(-2/5) V(y), y = zeta/(10 sqrt(1 - zeta^2)). For
 * y above 10 it is exp(2 pi y) (zeta/10)^(-4/5) times a series in 1/y^2. For y above 112.9 the duration overflows. */
static double tsuji_at_duration_zero_overlap(double zeta)
{
    if (!(zeta >= 0))
        return NAN;
    if (zeta < COR_ROWS_TSUJI_DURATION_ZERO_OVERLAP_END)
        return cor_inline_row_value(cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_TSUJI_DURATION_ZERO_OVERLAP), zeta,
                                                          cor_rows_tsuji_duration_zero_overlap));
    if (zeta >= 1)
        return INFINITY;
    const struct cor_inline_pair ten = cor_pair(10, 0), two_fifths = cor_pair(0.4, -2.22044604925031308085e-17);
    const struct cor_inline_pair ratio = cor_ratio_over_omega(zeta, cor_pair(zeta, 0)), y = cor_pair_over(ratio, ten);
    if (y.hi > 112.9)
        return INFINITY;
    const struct cor_inline_pair two_pi = cor_pair(2 * COR_PI, 2 * COR_PI_TAIL);
    const struct cor_inline_pair growth = cor_inline_pair_times(two_pi, y);
    struct cor_inline_pair factor, exponent;
    if (y.hi < COR_ROWS_TSUJI_OVERLAP_FACTOR_END) {
        struct cor_inline_place place = cor_inline_octaves_place(COR_INLINE_OCTAVES(COR_ROWS_TSUJI_OVERLAP_FACTOR),
                                                                 y.hi, cor_rows_tsuji_overlap_factor);
        place.s = place.t += y.lo * cor_inline_power_of_two(-cor_inline_exponent(y.hi));
        factor = cor_inline_sum(place.row[0], cor_inline_row(place));
        exponent = cor_inline_pair_times(two_fifths, cor_kernel_minus_log(cor_ratio_omega_square(zeta)));
    } else {
        const double *c = cor_rows_tsuji_far_overlap_factor(0), x = 1 / (y.hi * y.hi);
        const double rest = c[2] + x * (c[3] + x * (c[4] + x * (c[5] + x * (c[6] + x * (c[7] + x * c[8])))));
        factor = cor_inline_sum(c[0], c[1] + x * rest);
        const struct cor_inline_pair tenth = cor_kernel_minus_log(cor_pair_over(cor_pair(zeta, 0), ten));
        exponent = cor_pair_scaled(cor_inline_pair_times(two_fifths, tenth), 2);
    }
    /* units of 2^8, so that only the result can overflow; the power is applied in two halves */
    const struct cor_inline_pair half = cor_pair_scaled(cor_pair_plus(growth, exponent), -0.5);
    const struct cor_inline_pair root = cor_kernel_exp_minus_pair(half);
    const double scaled =
        cor_inline_pair_times(cor_inline_pair_times(root, factor), cor_pair_scaled(root, 1.0 / 256)).hi;
    return scaled < 7.02223880805592105e+305 ? scaled * 256 : INFINITY; /* 2^1016 */
}

/* Returns the duration. The elastic rebound to the speed eps takes half the elastic duration times eps^(-1/5). */
static double tsuji_at_duration_approach_only(double zeta)
{
    if (!(zeta >= 0))
        return NAN;
    if (isinf(zeta))
        return INFINITY;
    const struct cor_inline_pair fifth = cor_pair(0.2, -1.11022302462515654042e-17);
    /* L at zero force is twice the L of this end */
    const struct cor_inline_pair part = cor_inline_pair_times(fifth, cor_ratio_force_exponent(zeta));
    const struct cor_inline_pair growth = cor_kernel_exp_minus_pair(cor_pair_scaled(part, -0.5));
    const struct cor_inline_pair rebound =
        cor_inline_pair_times(growth, cor_pair(COR_HERTZ_HALF_DURATION, COR_HERTZ_HALF_DURATION_TAIL));
    return cor_pair_plus(rebound, cor_pair(tsuji_at_time_of_max_overlap(zeta), 0)).hi;
}

/* Returns (5/4 eps)^(2/5) with eps at zero force. */
static double tsuji_at_max_overlap(double zeta)
{
    if (!(zeta >= 0))
        return (double)NAN;
    if (zeta < ratio_zero_force.eps.end) { /* the fifth root of (25/16) eps^2 */
        const double eps = closed_eps(&ratio_zero_force, zeta);
        return cor_inline_fifth_root_normal(eps * eps * 1.5625);
    }
    if (isinf(zeta))
        return 0;
    const struct cor_inline_pair two_fifths = cor_pair(0.4, -2.22044604925031308085e-17);
    const struct cor_inline_pair log_5_4 = cor_pair(-8.92574205256839031675e-02, 8.60950677367028016675e-19);
    const struct cor_inline_pair part = cor_inline_pair_times(two_fifths, cor_ratio_force_exponent(zeta));
    const struct cor_inline_pair sum = cor_pair_two_sum(part.hi, log_5_4.hi);
    return cor_kernel_exp_minus_pair(cor_pair(sum.hi, sum.lo + (part.lo + log_5_4.lo))).hi;
}

/* ---- the functions of the table: x is zeta, eps or 1 - eps ---- */

static void run_loop(enum cor_law_loop loop, double (*one)(double), const double *x, double *y, size_t n)
{
#ifdef COR_WITHOUT_LOOPS
    (void)loop;
    cor_array_in_environment(one, x, y, n);
#else
    const struct cor_environment caller = cor_environment_enter();
    cor_law_loops(cor_array_set())->run(loop, one, x, y, n);
    cor_environment_leave(&caller);
#endif
}

/* clang-format off */
static double eps_zero_overlap(double x) { return closed_value(&ratio_zero_overlap, COR_EPS, x); }
static double loss_zero_overlap(double x) { return closed_value(&ratio_zero_overlap, COR_LOSS, x); }
static double zeta_zero_overlap(double x) { return closed_value(&ratio_zero_overlap, COR_DAMPING_OF_EPS, x); }
static double zeta_of_loss_zero_overlap(double x)
{ return closed_value_of_loss(&ratio_zero_overlap, zeta_zero_overlap, x); }
static double eps_zero_force(double x) { return closed_value(&ratio_zero_force, COR_EPS, x); }
static double loss_zero_force(double x) { return closed_value(&ratio_zero_force, COR_LOSS, x); }
static double zeta_zero_force(double x) { return closed_value(&ratio_zero_force, COR_DAMPING_OF_EPS, x); }
static double zeta_of_loss_zero_force(double x) { return closed_value_of_loss(&ratio_zero_force, zeta_zero_force, x); }
static double eps_limited(double x) { return closed_value(&ratio_limited, COR_EPS, x); }
static double loss_limited(double x) { return closed_value(&ratio_limited, COR_LOSS, x); }
static double zeta_limited(double x) { return closed_value(&ratio_limited, COR_DAMPING_OF_EPS, x); }
static double zeta_of_loss_limited(double x) { return closed_value_of_loss(&ratio_limited, zeta_limited, x); }
static double eps_approach_only(double x) { return closed_value(&ratio_approach_only, COR_EPS, x); }
static double loss_approach_only(double x) { return closed_value(&ratio_approach_only, COR_LOSS, x); }
static double zeta_approach_only(double x) { return closed_value(&ratio_approach_only, COR_DAMPING_OF_EPS, x); }
static double zeta_of_loss_approach_only(double x)
{ return closed_value_of_loss(&ratio_approach_only, zeta_approach_only, x); }
static double linear_duration_zero_overlap(double x) { return law_value(cor_linear_inline_duration_zero_overlap, x); }
static double linear_duration_zero_force(double x) { return law_value(cor_linear_inline_duration_zero_force, x); }
static double linear_duration_limited(double x) { return law_value(cor_linear_inline_duration_limited, x); }
static double linear_duration_approach_only(double x) { return law_value(cor_linear_inline_duration_approach_only, x); }
static double linear_time_of_max_overlap(double x) { return law_value(cor_linear_inline_time_of_max_overlap, x); }
static double tsuji_duration_zero_overlap(double x) { return law_value(tsuji_at_duration_zero_overlap, x); }
static double tsuji_duration_zero_force(double x) { return law_value(tsuji_at_duration_zero_force, x); }
static double tsuji_duration_limited(double x) { return law_value(tsuji_at_duration_limited, x); }
static double tsuji_duration_approach_only(double x) { return law_value(tsuji_at_duration_approach_only, x); }
static double tsuji_max_overlap(double x) { return law_value(tsuji_at_max_overlap, x); }
static double tsuji_time_of_max_overlap(double x) { return law_value(tsuji_at_time_of_max_overlap, x); }

static void eps_zero_overlap_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_zero_overlap.eps, eps_zero_overlap, x, y, n); }
static void loss_zero_overlap_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_zero_overlap.loss, loss_zero_overlap, x, y, n); }
static void zeta_zero_overlap_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_zero_overlap.damping_of_eps, zeta_zero_overlap, x, y, n); }
static void zeta_of_loss_zero_overlap_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_zero_overlap.damping_of_loss, zeta_of_loss_zero_overlap, x, y, n); }
static void eps_zero_force_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_zero_force.eps, eps_zero_force, x, y, n); }
static void loss_zero_force_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_zero_force.loss, loss_zero_force, x, y, n); }
static void zeta_zero_force_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_zero_force.damping_of_eps, zeta_zero_force, x, y, n); }
static void zeta_of_loss_zero_force_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_zero_force.damping_of_loss, zeta_of_loss_zero_force, x, y, n); }
static void eps_limited_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_limited.eps, eps_limited, x, y, n); }
static void loss_limited_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_limited.loss, loss_limited, x, y, n); }
static void zeta_limited_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_limited.damping_of_eps, zeta_limited, x, y, n); }
static void zeta_of_loss_limited_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_limited.damping_of_loss, zeta_of_loss_limited, x, y, n); }
static void eps_approach_only_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_approach_only.eps, eps_approach_only, x, y, n); }
static void loss_approach_only_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_approach_only.loss, loss_approach_only, x, y, n); }
static void zeta_approach_only_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_approach_only.damping_of_eps, zeta_approach_only, x, y, n); }
static void zeta_of_loss_approach_only_array(const double *x, double *y, size_t n)
{ cor_row_array(&ratio_approach_only.damping_of_loss, zeta_of_loss_approach_only, x, y, n); }
static void linear_duration_zero_overlap_array(const double *x, double *y, size_t n)
{ run_loop(COR_LINEAR_DURATION_ZERO_OVERLAP, linear_duration_zero_overlap, x, y, n); }
static void linear_duration_zero_force_array(const double *x, double *y, size_t n)
{ run_loop(COR_LINEAR_DURATION_ZERO_FORCE, linear_duration_zero_force, x, y, n); }
static void linear_duration_limited_array(const double *x, double *y, size_t n)
{ cor_array_in_environment(cor_linear_inline_duration_limited, x, y, n); }
static void linear_duration_approach_only_array(const double *x, double *y, size_t n)
{ cor_array_in_environment(cor_linear_inline_duration_approach_only, x, y, n); }
static void linear_time_of_max_overlap_array(const double *x, double *y, size_t n)
{ run_loop(COR_LINEAR_TIME_OF_MAX_OVERLAP, linear_time_of_max_overlap, x, y, n); }
static void tsuji_duration_zero_overlap_array(const double *x, double *y, size_t n)
{ cor_array_in_environment(tsuji_at_duration_zero_overlap, x, y, n); }
static void tsuji_duration_zero_force_array(const double *x, double *y, size_t n)
{ cor_array_in_environment(tsuji_at_duration_zero_force, x, y, n); }
static void tsuji_duration_limited_array(const double *x, double *y, size_t n)
{ cor_array_in_environment(tsuji_at_duration_limited, x, y, n); }
static void tsuji_duration_approach_only_array(const double *x, double *y, size_t n)
{ cor_array_in_environment(tsuji_at_duration_approach_only, x, y, n); }
static void tsuji_max_overlap_array(const double *x, double *y, size_t n)
{ cor_array_in_environment(tsuji_at_max_overlap, x, y, n); }
static void tsuji_time_of_max_overlap_array(const double *x, double *y, size_t n)
{ cor_array_in_environment(tsuji_at_time_of_max_overlap, x, y, n); }
/* clang-format on */

/* Rows that both laws have */
#define EPS_ROWS(law, end)                                                                                             \
    COR_LAW_ROW(law "_eps_" #end, eps_##end, 0, INFINITY, 2),                                                          \
        COR_LAW_ROW(law "_loss_" #end, loss_##end, 0, INFINITY, 2),                                                    \
        COR_LAW_ROW(law "_damping_of_eps_" #end, zeta_##end, 0, 1, 2),                                                 \
        COR_LAW_ROW(law "_damping_of_loss_" #end, zeta_of_loss_##end, 0, 1, 2)
#define LINEAR_OVERLAP_ROWS                                                                                            \
    COR_LAW_ROW("linear_max_overlap", eps_approach_only, 0, INFINITY, 2),                                              \
        COR_LAW_ROW("linear_time_of_max_overlap", linear_time_of_max_overlap, 0, INFINITY, 2)
#define TSUJI_OVERLAP_ROWS                                                                                             \
    COR_LAW_ROW("tsuji_max_overlap", tsuji_max_overlap, 0, INFINITY, 2),                                               \
        COR_LAW_ROW("tsuji_time_of_max_overlap", tsuji_time_of_max_overlap, 0, INFINITY, 2)

/* In the order of enum cor_quantity */
const cor_law_functions cor_linear_functions = {
    [COR_END_ZERO_OVERLAP] = {EPS_ROWS("linear", zero_overlap),
                              COR_LAW_ROW("linear_duration_zero_overlap", linear_duration_zero_overlap, 0, INFINITY, 2),
                              LINEAR_OVERLAP_ROWS},
    [COR_END_ZERO_FORCE] = {EPS_ROWS("linear", zero_force),
                            COR_LAW_ROW("linear_duration_zero_force", linear_duration_zero_force, 0, INFINITY, 2),
                            LINEAR_OVERLAP_ROWS},
    [COR_END_LIMITED] = {EPS_ROWS("linear", limited),
                         COR_LAW_ROW("linear_duration_limited", linear_duration_limited, 0, INFINITY, 2)},
    [COR_END_APPROACH_ONLY] = {EPS_ROWS("linear", approach_only),
                               COR_LAW_ROW("linear_duration_approach_only", linear_duration_approach_only, 0, INFINITY,
                                           2),
                               LINEAR_OVERLAP_ROWS},
};

const cor_law_functions cor_tsuji_functions = {
    [COR_END_ZERO_OVERLAP] = {EPS_ROWS("tsuji", zero_overlap),
                              COR_LAW_ROW("tsuji_duration_zero_overlap", tsuji_duration_zero_overlap, 0, INFINITY, 2),
                              TSUJI_OVERLAP_ROWS},
    [COR_END_ZERO_FORCE] = {EPS_ROWS("tsuji", zero_force),
                            COR_LAW_ROW("tsuji_duration_zero_force", tsuji_duration_zero_force, 0, INFINITY, 2),
                            TSUJI_OVERLAP_ROWS},
    [COR_END_LIMITED] = {EPS_ROWS("tsuji", limited),
                         COR_LAW_ROW("tsuji_duration_limited", tsuji_duration_limited, 0, INFINITY, 2)},
    [COR_END_APPROACH_ONLY] = {EPS_ROWS("tsuji", approach_only),
                               COR_LAW_ROW("tsuji_duration_approach_only", tsuji_duration_approach_only, 0, INFINITY,
                                           2),
                               TSUJI_OVERLAP_ROWS},
};
