/* SPDX-License-Identifier: MIT */
/* The only evaluator of the sphere's tables, for scalar functions, array functions and the header for embedding.
 *
 * For beta from 0 to 8 (eps: to 7 at zero overlap, to 16 at zero force) a row of a table gives a quantity. A row is a
 * short polynomial around the nearest node of a uniform grid. For larger beta a quantity is a power of beta times a
 * function of ln(beta). Rows give this function up to beta = exp(10). Beyond exp(10) it is a series to second order in
 * mu = beta^(-5/3), whose coefficients are polynomials in ln(beta). The first coefficient of a row is a double-double
 * and dominates, so the final addition causes nearly all of the rounding error.
 *
 * Errors are in units of the last place (ulp) of the exact value. "Worst known" is the largest error, and its argument,
 * that tests/accuracy/test_accuracy --points 1e9 found. tests/unit/test_sphere.c tests these arguments.
 *
 * No function raises FE_INVALID, FE_DIVBYZERO or FE_OVERFLOW or sets errno, whatever its argument; FE_UNDERFLOW and
 * FE_INEXACT may be raised. Arguments that may be NaN are compared by their bits (number/pair.h). */
#ifndef COR_RUNTIME_SPHERE_EVAL_H
#define COR_RUNTIME_SPHERE_EVAL_H

#include "generated/sphere_rows.h"
#include "runtime/number/fifth_root.h"
#include "runtime/table/row.h"

/* ---- tails ---- */

/* Arguments outside a table: beta = -0 counts as 0; negative numbers and NaN give NaN. */

/* Returns beta^(2/3) for 1 <= beta < 8. Relative error below 2^-69. */
COR_INLINE struct cor_inline_pair cor_inline_two_thirds(double beta)
{
    /* r has 26 bits, so its square is exact; |d| < 2^-23 if the error of cbrt is below 2^-27 */
    const double r = cor_inline_head(cbrt(beta)), square = r * r;
    const struct cor_inline_pair cube = cor_inline_product(square, r);
    const double d = (COR_INLINE_KEEP(beta - cube.hi) - cube.lo) / beta; /* r^3 = beta (1 - d) */
    return cor_inline_sum(square, square * (d * (2.0 / 3 + d * (5.0 / 9))));
}

/* Returns the logarithmic factor of a tail. Up to u = end, rows in u = ln(beta) give this factor; its error is the
 * error of u times the slope. For larger u, a series to second order in mu = beta^(-5/3) gives it. */
COR_INLINE struct cor_inline_pair cor_inline_log_factor(double beta, struct cor_inline_grid grid, double end,
                                                        const double *(*rows)(int), const double *(*far)(int))
{
    const struct cor_inline_pair u = cor_inline_log(beta);
    if (u.hi < end) {
        const int i = cor_inline_grid_row(grid, u.hi);
        const double *c = rows(i);
        return cor_inline_sum(c[0], cor_inline_row(cor_inline_place_of(c, cor_inline_grid_t(grid, u.hi, i) + u.lo)));
    }
    const double *c = far(0);
    /* mu < 6e-8, so its error is negligible, even if cbrt has an error of 2^-46 */
    const double root = cbrt(beta), mu = 1 / beta / (root * root), v = u.hi;
    const double orders = mu * ((c[4] + v * (c[5] + v * c[6])) + mu * (c[7] + v * (c[8] + v * (c[9] + v * c[10]))));
    const struct cor_inline_pair slope = cor_inline_product(c[2], v);
    const double more = ((slope.lo + c[2] * u.lo) + c[3] * v) + (c[1] + orders);
    const struct cor_inline_pair sum =
        slope.hi > fabs(c[0]) ? cor_inline_sum(slope.hi, c[0]) : cor_inline_sum(c[0], slope.hi);
    return cor_inline_sum(sum.hi, sum.lo + more);
}
#define COR_INLINE_LOG_FACTOR(beta, quantity, table)                                                                   \
    cor_inline_log_factor(beta, COR_INLINE_GRID(table), table##_END, cor_rows_tail_##quantity, cor_rows_far_##quantity)

/* Returns factor beta^(-2/3) as a pair times 2^exponent, without overflow or underflow. fifths: true for beta^(-5/3).
 * The relative error is the error of the factor plus 2^-65. */
COR_INLINE struct cor_inline_pair cor_inline_power_parts(double beta, struct cor_inline_pair factor, int fifths,
                                                         int *exponent)
{
    const int e = cor_inline_exponent(beta); /* beta = m 2^(e - e mod 3), 1 <= m < 8 */
    struct cor_inline_pair whole, power;
    whole.hi = cor_inline_significand(beta) * (1 << (e % 3));
    whole.lo = 0;
    power = cor_inline_two_thirds(whole.hi);
    if (fifths)
        power = cor_inline_pair_times(power, whole);
    *exponent = (fifths ? -5 : -2) * (e / 3);
    return cor_pair_over(factor, power);
}

/* Returns the same power, rounded to a double; 0 for an infinite beta. */
COR_INLINE double cor_inline_power_tail(double beta, struct cor_inline_pair factor, int fifths)
{
    int exponent;
    const struct cor_inline_pair value = cor_inline_power_parts(beta, factor, fifths, &exponent);
    return cor_inline_scaled(value.hi, exponent);
}

/* ---- eps ---- */

/* Below this beta, eps is 1 to the last bit. The branch is necessary: if products that underflow are rounded upward, a
 * row exceeds 1. */
#define COR_INLINE_EPS_LEAST COR_INLINE_2_M60

/* Returns h*^5 beta^-5 for beta >= 7. The next order is below 2^-75. The power and the quotient are double-doubles, so
 * only the final rounding counts: 0.5 ulp. */
COR_INLINE double cor_inline_eps_overlap_far(double beta)
{
    const double *h = cor_rows_h_star_5(0);
    const int huge = beta > COR_INLINE_2_100;
    if (beta > COR_INLINE_2_250)
        return 0;
    struct cor_inline_pair b, power, h5;
    b.hi = huge ? beta * COR_INLINE_2_M200 : beta;
    b.lo = 0;
    power = cor_inline_product(b.hi, b.hi);
    power = cor_inline_pair_times(cor_inline_pair_times(power, power), b);
    h5.hi = h[0];
    h5.lo = h[1];
    const double eps = cor_pair_over(h5, power).hi;
    return huge ? eps * COR_INLINE_2_M500 * COR_INLINE_2_M500 : eps;
}

/* Returns the same eps at beta = x^(1/5), x >= 2^14. Error 0.75 ulp, because h*^5 is rounded to one double. */
COR_INLINE double cor_inline_eps_overlap_far_root(double x)
{
    return cor_rows_h_star_5(0)[0] / x;
}

COR_INLINE double cor_inline_eps_force_far(double beta)
{
    if (!cor_inline_is_finite(beta))
        return 0;
    return cor_inline_power_tail(beta, COR_INLINE_LOG_FACTOR(beta, eps_zero_force, COR_ROWS_TAIL_EPS_ZERO_FORCE), 1);
}

COR_INLINE double cor_inline_eps_zero_overlap(double beta)
{
    if (cor_inline_between(beta, COR_INLINE_EPS_LEAST, COR_ROWS_EPS_ZERO_OVERLAP_END))
        return cor_inline_row_value(
            cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_EPS_ZERO_OVERLAP), beta, cor_rows_eps_zero_overlap));
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    return beta < COR_INLINE_EPS_LEAST ? 1 : cor_inline_eps_overlap_far(beta);
}

COR_INLINE double cor_inline_eps_zero_force(double beta)
{
    if (cor_inline_between(beta, COR_INLINE_EPS_LEAST, COR_ROWS_EPS_ZERO_FORCE_END))
        return cor_inline_row_value(cor_inline_grid_place_of_root(COR_INLINE_GRID(COR_ROWS_EPS_ZERO_FORCE),
                                                                  COR_ROWS_EPS_ZERO_FORCE_PLAIN_ROWS, beta,
                                                                  cor_rows_eps_zero_force));
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    return beta < COR_INLINE_EPS_LEAST ? 1 : cor_inline_eps_force_far(beta);
}

/* Return eps at beta = x^(1/5), where x is the product of an impact speed g and beta_per_root^5. From x = 2^-40 (beta =
 * 1/256), rows in x give eps without a root, up to x = 2^14 (beta = 7) at zero overlap and 2^20 (beta = 16) at zero
 * force. Only a fifth of the relative rounding error of x reaches beta. For larger x, eps at zero overlap is h*^5/x. */
COR_INLINE double cor_inline_eps_zero_overlap_root(double x)
{
    const struct cor_inline_octaves grid = COR_INLINE_OCTAVES(COR_ROWS_POWER_EPS_ZERO_OVERLAP);
    if (cor_inline_between(x, grid.first, COR_ROWS_POWER_EPS_ZERO_OVERLAP_END))
        return cor_inline_row_value(cor_inline_octaves_place(grid, x, cor_rows_power_eps_zero_overlap));
    if (cor_inline_between(x, COR_ROWS_POWER_EPS_ZERO_OVERLAP_END, COR_INLINE_2_900))
        return cor_inline_eps_overlap_far_root(x);
    return cor_inline_eps_zero_overlap(cor_inline_fifth_root(x));
}

COR_INLINE double cor_inline_eps_zero_force_root(double x)
{
    const struct cor_inline_octaves grid = COR_INLINE_OCTAVES(COR_ROWS_POWER_EPS_ZERO_FORCE);
    if (cor_inline_between(x, grid.first, COR_ROWS_POWER_EPS_ZERO_FORCE_END))
        return cor_inline_row_value(cor_inline_octaves_place(grid, x, cor_rows_power_eps_zero_force));
    return cor_inline_eps_zero_force(cor_inline_fifth_root(x));
}

/* ---- 1 - eps = beta (c_0 + row) ---- */

/* Returns beta (c_0 + row). A tiny beta is scaled, because parts of the products would be subnormal. */
COR_INLINE double cor_inline_loss_product(struct cor_inline_place place, double beta)
{
    if (cor_inline_below(beta, COR_INLINE_2_M900))
        return cor_inline_row_product(place, beta * COR_INLINE_2_200) * COR_INLINE_2_M200;
    return cor_inline_row_product(place, beta);
}

COR_INLINE double cor_inline_loss_zero_overlap(double beta)
{
    if (cor_inline_below(beta, COR_ROWS_LOSS_ZERO_OVERLAP_END))
        return cor_inline_loss_product(
            cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_LOSS_ZERO_OVERLAP), beta, cor_rows_loss_zero_overlap), beta);
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    return cor_inline_is_zero(beta) ? 0 : 1 - cor_inline_eps_overlap_far(beta);
}

COR_INLINE double cor_inline_loss_zero_force(double beta)
{
    if (cor_inline_below(beta, COR_ROWS_LOSS_ZERO_FORCE_END))
        return cor_inline_loss_product(cor_inline_grid_place_of_root(COR_INLINE_GRID(COR_ROWS_LOSS_ZERO_FORCE),
                                                                     COR_ROWS_LOSS_ZERO_FORCE_PLAIN_ROWS, beta,
                                                                     cor_rows_loss_zero_force),
                                       beta);
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    return cor_inline_is_zero(beta) ? 0 : 1 - cor_inline_eps_force_far(beta);
}

/* ---- times and the largest overlap ---- */

/* Returns the product of beta and factor, or infinity if it exceeds the largest double. */
COR_INLINE double cor_inline_linear_tail(double beta, struct cor_inline_pair factor)
{
    const int huge = beta > COR_INLINE_2_1000;
    const double b = huge ? beta * COR_INLINE_2_M60 : beta;
    const struct cor_inline_pair product = cor_inline_product(b, factor.hi);
    const double value = product.hi + (product.lo + b * factor.lo);
    if (!huge)
        return value;
    return value >= COR_INLINE_2_964 ? cor_inline_infinity() : value * COR_INLINE_2_60;
}

COR_INLINE double cor_inline_duration_zero_overlap(double beta)
{
    if (cor_inline_below(beta, COR_ROWS_DURATION_ZERO_OVERLAP_END) || cor_inline_is_zero(beta))
        return cor_inline_row_value(cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_DURATION_ZERO_OVERLAP), beta,
                                                          cor_rows_duration_zero_overlap));
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    if (!cor_inline_is_finite(beta))
        return beta;
    return cor_inline_linear_tail(
        beta, COR_INLINE_LOG_FACTOR(beta, duration_zero_overlap, COR_ROWS_TAIL_DURATION_ZERO_OVERLAP));
}

COR_INLINE double cor_inline_duration_zero_force(double beta)
{
    if (cor_inline_below(beta, COR_ROWS_DURATION_ZERO_FORCE_END) || cor_inline_is_zero(beta))
        return cor_inline_row_value(cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_DURATION_ZERO_FORCE), sqrt(beta),
                                                          cor_rows_duration_zero_force));
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    if (!cor_inline_is_finite(beta))
        return 0;
    return cor_inline_power_tail(
        beta, COR_INLINE_LOG_FACTOR(beta, duration_zero_force, COR_ROWS_TAIL_DURATION_ZERO_FORCE), 0);
}

COR_INLINE double cor_inline_max_overlap(double beta)
{
    if (cor_inline_below(beta, COR_ROWS_MAX_OVERLAP_END) || cor_inline_is_zero(beta))
        return cor_inline_row_value(
            cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_MAX_OVERLAP), beta, cor_rows_max_overlap));
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    if (!cor_inline_is_finite(beta))
        return 0;
    return cor_inline_power_tail(beta, COR_INLINE_LOG_FACTOR(beta, max_overlap, COR_ROWS_TAIL_MAX_OVERLAP), 0);
}

COR_INLINE double cor_inline_time_of_max_overlap(double beta)
{
    if (cor_inline_below(beta, COR_ROWS_TIME_OF_MAX_OVERLAP_END) || cor_inline_is_zero(beta))
        return cor_inline_row_value(
            cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_TIME_OF_MAX_OVERLAP), beta, cor_rows_time_of_max_overlap));
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    if (!cor_inline_is_finite(beta))
        return 0;
    return cor_inline_power_tail(
        beta, COR_INLINE_LOG_FACTOR(beta, time_of_max_overlap, COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP), 0);
}

/* ---- the inverse ---- */

/* Returns beta = m (c_0 + row). For eps >= 1/2, m = loss = 1 - eps, which is exact, and the rows contain beta/loss as a
 * function of loss or of its root. For eps < 1/2, m = 1, and the rows contain beta by octaves of eps. The function
 * computes both and selects one by bits, because the eps of many collisions scatter around 1/2. The error is the error
 * of the row plus one rounding; at zero force the rounded root adds up to 0.6 ulp. */
COR_INLINE double cor_inline_inverse(double eps, struct cor_inline_grid near_grid, int root,
                                     const double *(*near_rows)(int), struct cor_inline_octaves grid,
                                     const double *(*rows)(int))
{
    const int near = cor_inline_bits(eps) >= cor_inline_bits(0.5);
    const double loss = cor_inline_choose(near, 1 - eps, 0), y = root ? sqrt(loss) : loss;
    const int i = cor_inline_grid_row(near_grid, y);
    const int j = near ? 0 : (int)cor_inline_octaves_row(grid, eps);
    const double t = cor_inline_choose(near, cor_inline_grid_t(near_grid, y, i), cor_inline_octaves_t(grid, eps));
    return cor_inline_row_product(cor_inline_place_of(near ? near_rows(i) : rows(j), t),
                                  cor_inline_choose(near, loss, 1));
}

/* Returns a/eps as a pair; if eps is tiny and the quotient might overflow, a/(2^500 eps). */
COR_INLINE struct cor_inline_pair cor_inline_over_eps(const double *a, double eps, int tiny)
{
    struct cor_inline_pair numerator, denominator;
    numerator.hi = a[0];
    numerator.lo = a[1];
    denominator.hi = tiny ? cor_inline_raised(eps, COR_INLINE_2_500) : eps;
    denominator.lo = 0;
    return cor_pair_over(numerator, denominator);
}

/* Returns beta = (h*^5/eps)^(1/5) for eps below the table. Error 0.6 ulp. */
COR_INLINE double cor_inline_beta_overlap_far(double eps)
{
    const int tiny = eps < COR_INLINE_2_M500;
    const struct cor_inline_pair root =
        cor_inline_fifth_root_of_pair(cor_inline_over_eps(cor_rows_h_star_5(0), eps, tiny));
    return (root.hi + root.lo) * (tiny ? COR_INLINE_2_100 : 1);
}

/* Returns beta = R (1 + e r_1(v) + e^2 r_2(v)), R = (a/eps)^(3/5), e = eps/a, v = ln(R), for eps below the table
 * (e < 1e-7). */
COR_INLINE double cor_inline_beta_force_far(double eps)
{
    const double *c = cor_rows_far_beta_zero_force(0);
    const int tiny = eps < COR_INLINE_2_M500;
    const struct cor_inline_pair root = cor_inline_fifth_root_of_pair(cor_inline_over_eps(c, eps, tiny));
    /* (hi + lo)^3; hi has 26 bits, and lo is below 2^-12 hi */
    const struct cor_inline_pair cube = cor_inline_product(root.hi * root.hi, root.hi);
    const double lo = cube.lo + root.lo * (3 * root.hi * root.hi + root.lo * (3 * root.hi + root.lo));
    /* below 2^-500 the orders in e are negligible */
    const double e = tiny ? 0 : eps / c[0], v = -0.6 * log(tiny ? 1 : e);
    const double r1 = c[2] + v * (c[3] + v * c[4]);
    const double r2 = c[5] + v * (c[6] + v * (c[7] + v * (c[8] + v * c[9])));
    const double beta = cube.hi + (lo + (cube.hi + lo) * (e * (r1 + e * r2)));
    return beta * (tiny ? COR_INLINE_2_300 : 1);
}

COR_INLINE double cor_inline_beta_zero_overlap(double eps)
{
    if (cor_inline_between(eps, COR_ROWS_BETA_ZERO_OVERLAP_FIRST, 1) || cor_inline_bits(eps) == cor_inline_bits(1))
        return cor_inline_inverse(eps, COR_INLINE_GRID(COR_ROWS_NEAR_BETA_ZERO_OVERLAP), 0,
                                  cor_rows_near_beta_zero_overlap, COR_INLINE_OCTAVES(COR_ROWS_BETA_ZERO_OVERLAP),
                                  cor_rows_beta_zero_overlap);
    if (cor_inline_is_zero(eps))
        return cor_inline_infinity();
    return cor_inline_below(eps, 1) ? cor_inline_beta_overlap_far(eps) : cor_inline_nan();
}

COR_INLINE double cor_inline_beta_zero_force(double eps)
{
    if (cor_inline_between(eps, COR_ROWS_BETA_ZERO_FORCE_FIRST, 1) || cor_inline_bits(eps) == cor_inline_bits(1))
        return cor_inline_inverse(eps, COR_INLINE_GRID(COR_ROWS_NEAR_BETA_ZERO_FORCE), 1, cor_rows_near_beta_zero_force,
                                  COR_INLINE_OCTAVES(COR_ROWS_BETA_ZERO_FORCE), cor_rows_beta_zero_force);
    if (cor_inline_is_zero(eps))
        return cor_inline_infinity();
    return cor_inline_below(eps, 1) ? cor_inline_beta_force_far(eps) : cor_inline_nan();
}

#endif
