/* SPDX-License-Identifier: MIT */
/* The one evaluator of the sphere's tables: scalars, arrays and the header for embedding are made of it.
 *
 * Near beta = 0 to 8 (7 and 16 for eps at its two ends) a quantity is a row of a table, a short polynomial around
 * the nearest node of a uniform grid. Beyond, it is a power of beta times a function of ln(beta): rows again up to
 * beta = exp(10), and three orders in mu = beta^(-5/3), with their logarithms, from there to infinity. The first
 * coefficient of a row is a double-double and dominates, so the final addition causes nearly all of the rounding
 * error. */
#ifndef COR_RUNTIME_SPHERE_EVAL_H
#define COR_RUNTIME_SPHERE_EVAL_H

#include "generated/sphere_tables.h"
#include "runtime/core/fifth_root.h"
#include "runtime/core/row.h"

/* ---- eps as c_0 + rest, both ends, inside the tables ---- */

COR_INLINE struct cor_inline_pair cor_inline_eps_overlap_parts(double beta)
{
    const struct cor_inline_grid grid = COR_INLINE_GRID(COR_ROWS_EPS_ZERO_OVERLAP);
    const int i = cor_inline_grid_row(grid, beta);
    const double *c = cor_rows_eps_zero_overlap(i);
    const double t = cor_inline_grid_t(grid, beta, i);
    struct cor_inline_pair eps;
    eps.hi = c[0];
    eps.lo = cor_inline_row(c, t, t);
    return eps;
}

COR_INLINE struct cor_inline_pair cor_inline_eps_force_parts(double beta)
{
    const struct cor_inline_grid grid = COR_INLINE_GRID(COR_ROWS_EPS_ZERO_FORCE);
    const double z = sqrt(beta);
    const int i = cor_inline_grid_row(grid, z);
    const double *c = cor_rows_eps_zero_force(i);
    const double node = grid.first + i * grid.step, t = z - node, square = beta - node * node;
    /* Selected by bits: the processor would mispredict half of the jumps where beta scatters around 1/16. */
    const uint64_t plain = (uint64_t)0 - (uint64_t)(i < COR_ROWS_EPS_ZERO_FORCE_PLAIN_ROWS);
    const double s = cor_inline_from_bits((cor_inline_bits(t) & plain) | (cor_inline_bits(square) & ~plain));
    struct cor_inline_pair eps;
    eps.hi = c[0];
    eps.lo = cor_inline_row(c, s, t);
    return eps;
}

/* ---- tails ---- */

/* beta^(2/3) for 1 <= beta < 8 */
COR_INLINE struct cor_inline_pair cor_inline_two_thirds(double beta)
{
    const double r = cor_inline_head(cbrt(beta)), square = r * r;
    const struct cor_inline_pair cube = cor_inline_product(square, r);
    const double d = ((beta - cube.hi) - cube.lo) / beta; /* r^3 = beta (1 - d) */
    return cor_inline_sum(square, square * (d * (2.0 / 3 + d * (5.0 / 9))));
}

/* ln(beta) and what the double lacks, beta >= 8 and finite */
COR_INLINE struct cor_inline_pair cor_inline_log(double beta)
{
    struct cor_inline_pair u;
    u.hi = log(beta);
    u.lo = beta * exp(-u.hi) - 1;
    return u;
}

/* The logarithmic factor of a tail: rows in u = ln(beta) up to u = end; then three orders in mu. */
COR_INLINE struct cor_inline_pair cor_inline_log_factor(double beta, struct cor_inline_grid grid, double end,
                                                        const double *(*rows)(int), const double *(*far)(int))
{
    const struct cor_inline_pair u = cor_inline_log(beta);
    if (u.hi < end) {
        const int i = cor_inline_grid_row(grid, u.hi);
        const double *c = rows(i);
        const double t = cor_inline_grid_t(grid, u.hi, i) + u.lo;
        return cor_inline_sum(c[0], cor_inline_row(c, t, t));
    }
    const double *c = far(0);
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

/* factor beta^(-2/3), or with `fifths` factor beta^(-5/3), as a pair times 2^exponent: nothing over- or underflows. */
COR_INLINE struct cor_inline_pair cor_inline_power_parts(double beta, struct cor_inline_pair factor, int fifths,
                                                         int *exponent)
{
    int e;
    double m = frexp(beta, &e) * 2; /* beta = m 2^(e - 1), 1 <= m < 2 */
    e--;
    m = ldexp(m, e % 3);
    struct cor_inline_pair power = cor_inline_two_thirds(m), whole;
    whole.hi = m;
    whole.lo = 0;
    if (fifths)
        power = cor_inline_pair_times(power, whole);
    *exponent = (fifths ? -5 : -2) * (e / 3);
    return cor_inline_pair_over(factor, power);
}

COR_INLINE double cor_inline_power_tail(double beta, struct cor_inline_pair factor, int fifths)
{
    int exponent;
    const struct cor_inline_pair value = cor_inline_power_parts(beta, factor, fifths, &exponent);
    return ldexp(value.hi, exponent);
}

/* h*^5 beta^-5 for beta >= 7 */
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
    const double eps = cor_inline_pair_over(h5, power).hi;
    return huge ? eps * COR_INLINE_2_M500 * COR_INLINE_2_M500 : eps;
}

COR_INLINE double cor_inline_eps_force_far(double beta)
{
    if (isinf(beta))
        return 0;
    return cor_inline_power_tail(beta, COR_INLINE_LOG_FACTOR(beta, eps_zero_force, COR_ROWS_TAIL_EPS_ZERO_FORCE), 1);
}

/* ---- eps and 1 - eps ---- */

COR_INLINE double cor_inline_eps_zero_overlap(double beta)
{
    if (beta >= 0 && beta < COR_ROWS_EPS_ZERO_OVERLAP_END) {
        const struct cor_inline_pair eps = cor_inline_eps_overlap_parts(beta);
        return eps.hi + eps.lo;
    }
    return beta >= 0 ? cor_inline_eps_overlap_far(beta) : (double)NAN;
}

COR_INLINE double cor_inline_eps_zero_force(double beta)
{
    if (beta >= 0 && beta < COR_ROWS_EPS_ZERO_FORCE_END) {
        const struct cor_inline_pair eps = cor_inline_eps_force_parts(beta);
        return eps.hi + eps.lo;
    }
    return beta >= 0 ? cor_inline_eps_force_far(beta) : (double)NAN;
}

/* eps at beta = x^(1/5), x being the product of an impact speed g with beta_per_root^5. Between 2^-40 and 2^14 or
 * 2^20 (beta = 1/256 and 7 or 16) no root is taken: rows in x itself, which its exponent and leading bits choose, and only a
 * fifth of the product's rounding error reaches beta. */
COR_INLINE double cor_inline_eps_zero_overlap_root(double x)
{
    if (x >= COR_ROWS_POWER_EPS_ZERO_OVERLAP_FIRST && x < COR_ROWS_POWER_EPS_ZERO_OVERLAP_END) {
        const struct cor_inline_octaves grid = COR_INLINE_OCTAVES(COR_ROWS_POWER_EPS_ZERO_OVERLAP);
        const double *c = cor_rows_power_eps_zero_overlap((int)cor_inline_octaves_row(grid, x));
        const double t = cor_inline_octaves_t(grid, x);
        return c[0] + cor_inline_row(c, t, t);
    }
    return cor_inline_eps_zero_overlap(cor_inline_fifth_root(x));
}

COR_INLINE double cor_inline_eps_zero_force_root(double x)
{
    if (x >= COR_ROWS_POWER_EPS_ZERO_FORCE_FIRST && x < COR_ROWS_POWER_EPS_ZERO_FORCE_END) {
        const struct cor_inline_octaves grid = COR_INLINE_OCTAVES(COR_ROWS_POWER_EPS_ZERO_FORCE);
        const double *c = cor_rows_power_eps_zero_force((int)cor_inline_octaves_row(grid, x));
        const double t = cor_inline_octaves_t(grid, x);
        return c[0] + cor_inline_row(c, t, t);
    }
    return cor_inline_eps_zero_force(cor_inline_fifth_root(x));
}

/* beta (c_0 + rest), rounded once */
COR_INLINE double cor_inline_small_loss(double beta, double c0, double rest)
{
    /* the product's lost half is itself lost where it is subnormal */
    const int tiny = beta < COR_INLINE_2_M900;
    const double b = tiny ? beta * COR_INLINE_2_200 : beta;
    const struct cor_inline_pair p = cor_inline_product(b, c0);
    const double loss = p.hi + (p.lo + b * rest);
    return tiny ? loss * COR_INLINE_2_M200 : loss;
}

/* 1 - (hi + lo), rounded once */
COR_INLINE double cor_inline_one_minus(struct cor_inline_pair eps)
{
    const double d = 1 - eps.hi;
    return d + (((1 - d) - eps.hi) - eps.lo);
}

COR_INLINE const double *cor_inline_loss_overlap_row(double beta, double *rest)
{
    const struct cor_inline_grid grid = COR_INLINE_GRID(COR_ROWS_LOSS_ZERO_OVERLAP);
    const int i = cor_inline_grid_row(grid, beta);
    const double *c = cor_rows_loss_zero_overlap(i);
    const double t = cor_inline_grid_t(grid, beta, i);
    *rest = cor_inline_row(c, t, t);
    return c;
}

COR_INLINE const double *cor_inline_loss_force_row(double beta, double *rest)
{
    const double z = sqrt(beta);
    const struct cor_inline_grid grid = COR_INLINE_GRID(COR_ROWS_LOSS_ZERO_FORCE);
    const int i = cor_inline_grid_row(grid, z);
    const double *c = cor_rows_loss_zero_force(i);
    const double t = cor_inline_grid_t(grid, z, i);
    *rest = cor_inline_row(c, t, t);
    return c;
}

COR_INLINE double cor_inline_loss_zero_overlap(double beta)
{
    if (!(beta >= 0))
        return (double)NAN;
    if (beta < COR_ROWS_LOSS_ZERO_OVERLAP_END) {
        double rest;
        const double *c = cor_inline_loss_overlap_row(beta, &rest);
        return cor_inline_small_loss(beta, c[0], rest);
    }
    if (beta < COR_ROWS_EPS_ZERO_OVERLAP_END)
        return cor_inline_one_minus(cor_inline_eps_overlap_parts(beta));
    return 1 - cor_inline_eps_overlap_far(beta);
}

COR_INLINE double cor_inline_loss_zero_force(double beta)
{
    if (!(beta >= 0))
        return (double)NAN;
    if (beta < COR_ROWS_LOSS_ZERO_FORCE_END) {
        double rest;
        const double *c = cor_inline_loss_force_row(beta, &rest);
        return cor_inline_small_loss(beta, c[0], rest);
    }
    if (beta < COR_ROWS_EPS_ZERO_FORCE_END)
        return cor_inline_one_minus(cor_inline_eps_force_parts(beta));
    return 1 - cor_inline_eps_force_far(beta);
}

/* ---- times and the largest overlap ---- */

/* A table at y, s = t in all of its rows */
COR_INLINE double cor_inline_grid_value(struct cor_inline_grid grid, double y, const double *(*rows)(int))
{
    const int i = cor_inline_grid_row(grid, y);
    const double *c = rows(i);
    const double t = cor_inline_grid_t(grid, y, i);
    return c[0] + cor_inline_row(c, t, t);
}

COR_INLINE double cor_inline_duration_zero_overlap(double beta)
{
    if (!(beta >= 0))
        return (double)NAN;
    if (beta < COR_ROWS_DURATION_ZERO_OVERLAP_END)
        return cor_inline_grid_value(COR_INLINE_GRID(COR_ROWS_DURATION_ZERO_OVERLAP), beta,
                                     cor_rows_duration_zero_overlap);
    if (isinf(beta))
        return beta;
    const struct cor_inline_pair factor =
        COR_INLINE_LOG_FACTOR(beta, duration_zero_overlap, COR_ROWS_TAIL_DURATION_ZERO_OVERLAP);
    const struct cor_inline_pair duration = cor_inline_product(beta, factor.hi);
    return isinf(duration.hi) ? duration.hi : duration.hi + (duration.lo + beta * factor.lo);
}

COR_INLINE double cor_inline_duration_zero_force(double beta)
{
    if (!(beta >= 0))
        return (double)NAN;
    if (beta < COR_ROWS_DURATION_ZERO_FORCE_END)
        return cor_inline_grid_value(COR_INLINE_GRID(COR_ROWS_DURATION_ZERO_FORCE), sqrt(beta),
                                     cor_rows_duration_zero_force);
    if (isinf(beta))
        return 0;
    return cor_inline_power_tail(
        beta, COR_INLINE_LOG_FACTOR(beta, duration_zero_force, COR_ROWS_TAIL_DURATION_ZERO_FORCE), 0);
}

COR_INLINE double cor_inline_max_overlap(double beta)
{
    if (!(beta >= 0))
        return (double)NAN;
    if (beta < COR_ROWS_MAX_OVERLAP_END)
        return cor_inline_grid_value(COR_INLINE_GRID(COR_ROWS_MAX_OVERLAP), beta, cor_rows_max_overlap);
    if (isinf(beta))
        return 0;
    return cor_inline_power_tail(beta, COR_INLINE_LOG_FACTOR(beta, max_overlap, COR_ROWS_TAIL_MAX_OVERLAP), 0);
}

COR_INLINE double cor_inline_time_of_max_overlap(double beta)
{
    if (!(beta >= 0))
        return (double)NAN;
    if (beta < COR_ROWS_TIME_OF_MAX_OVERLAP_END)
        return cor_inline_grid_value(COR_INLINE_GRID(COR_ROWS_TIME_OF_MAX_OVERLAP), beta, cor_rows_time_of_max_overlap);
    if (isinf(beta))
        return 0;
    return cor_inline_power_tail(
        beta, COR_INLINE_LOG_FACTOR(beta, time_of_max_overlap, COR_ROWS_TAIL_TIME_OF_MAX_OVERLAP), 0);
}

/* ---- the inverse ---- */

/* The beta with beta Q(beta) = loss, Q the loss's rows: Newton's method with the slope of Q taken from the row, then
 * once more as a quotient, which keeps nothing of the last iterate but its place. */
COR_INLINE double cor_inline_beta_of_loss(double loss, double end, const double *(*row)(double, double *))
{
    double rest, beta = loss * 0.8669653265572703; /* loss/|C_1| */
    const double *c = row(beta, &rest);
    for (int k = 0; k < 30; k++) {
        const double next = loss / (c[0] + rest);
        const double step = next - beta;
        beta = next;
        c = row(beta < end ? beta : end, &rest);
        if (fabs(step) < COR_INLINE_2_M56 * beta || step == 0)
            break;
    }
    return loss / (c[0] + rest);
}

/* A beta whose eps, as hi + lo, equals eps to more than a double: the secant method from the two nodes around it. */
COR_INLINE double cor_inline_beta_of_eps(double eps, double beta0, double beta1,
                                         struct cor_inline_pair (*parts)(double))
{
    struct cor_inline_pair p = parts(beta0);
    double f0 = (p.hi - eps) + p.lo;
    p = parts(beta1);
    double f1 = (p.hi - eps) + p.lo;
    for (int k = 0; k < 12 && f1 != f0 && f1 != 0; k++) {
        const double next = beta1 - f1 * ((beta1 - beta0) / (f1 - f0));
        if (next == beta1)
            break;
        beta0 = beta1;
        f0 = f1;
        beta1 = next;
        p = parts(beta1);
        f1 = (p.hi - eps) + p.lo;
    }
    return beta1;
}

/* The last row of lo..hi whose c_0 is not below eps; c_0 falls from row to row. */
COR_INLINE int cor_inline_row_of_eps(double eps, int lo, int hi, const double *(*rows)(int))
{
    while (hi - lo > 1) {
        const int middle = (lo + hi) / 2;
        if (rows(middle)[0] >= eps)
            lo = middle;
        else
            hi = middle;
    }
    return lo;
}

COR_INLINE double cor_inline_beta_zero_overlap(double eps)
{
    if (!(eps >= 0 && eps <= 1))
        return (double)NAN;
    const struct cor_inline_grid grid = COR_INLINE_GRID(COR_ROWS_EPS_ZERO_OVERLAP);
    const int last = cor_inline_grid_row(grid, COR_ROWS_EPS_ZERO_OVERLAP_END);
    if (eps > cor_rows_eps_zero_overlap(cor_inline_grid_row(grid, COR_ROWS_LOSS_ZERO_OVERLAP_END))[0])
        return cor_inline_beta_of_loss(1 - eps, COR_ROWS_LOSS_ZERO_OVERLAP_END, cor_inline_loss_overlap_row);
    if (eps <= cor_rows_eps_zero_overlap(last)[0]) {
        if (eps == 0)
            return (double)INFINITY;
        /* (h*^5/eps)^(1/5); a power of 32 keeps the quotient in range */
        const int tiny = eps < COR_INLINE_2_M500;
        const double h5 = cor_rows_h_star_5(0)[0];
        return tiny ? cor_inline_fifth_root_normal(h5 / (eps * COR_INLINE_2_500)) * COR_INLINE_2_100
                    : cor_inline_fifth_root_normal(h5 / eps);
    }
    const int i = cor_inline_row_of_eps(eps, 0, last, cor_rows_eps_zero_overlap);
    return cor_inline_beta_of_eps(eps, i * grid.step, (i + 1) * grid.step, cor_inline_eps_overlap_parts);
}

/* eps = F(ln beta) beta^(-5/3): beta = (F/eps)^(3/5), where F changes little; then once Newton's step, against eps as a
 * pair. */
COR_INLINE double cor_inline_beta_force_far(double eps)
{
    const int tiny = eps < COR_INLINE_2_M500;
    const double scaled = tiny ? eps * COR_INLINE_2_500 : eps, unit = tiny ? COR_INLINE_2_300 : 1;
    struct cor_inline_pair factor;
    double beta = 0;
    factor.hi = 1.3;
    factor.lo = 0;
    for (int k = 0; k < 40; k++) {
        const double root = cor_inline_fifth_root_normal(factor.hi / scaled), next = root * root * root * unit;
        if (fabs(next - beta) <= 4 * COR_INLINE_2_M52 * beta)
            break;
        beta = next < COR_ROWS_EPS_ZERO_FORCE_END ? COR_ROWS_EPS_ZERO_FORCE_END : next;
        factor = COR_INLINE_LOG_FACTOR(beta, eps_zero_force, COR_ROWS_TAIL_EPS_ZERO_FORCE);
    }
    int exponent;
    const struct cor_inline_pair value = cor_inline_power_parts(beta, factor, 1, &exponent);
    const double same = ldexp(scaled, -exponent - (tiny ? 500 : 0));
    return beta + beta * (0.6 * (((value.hi - same) + value.lo) / same));
}

COR_INLINE double cor_inline_beta_zero_force(double eps)
{
    if (!(eps >= 0 && eps <= 1))
        return (double)NAN;
    const struct cor_inline_grid grid = COR_INLINE_GRID(COR_ROWS_EPS_ZERO_FORCE);
    const int last = cor_inline_grid_row(grid, sqrt(COR_ROWS_EPS_ZERO_FORCE_END));
    if (eps > cor_rows_eps_zero_force(cor_inline_grid_row(grid, sqrt(COR_ROWS_LOSS_ZERO_FORCE_END)))[0])
        return cor_inline_beta_of_loss(1 - eps, COR_ROWS_LOSS_ZERO_FORCE_END, cor_inline_loss_force_row);
    if (eps <= cor_rows_eps_zero_force(last)[0])
        return eps == 0 ? (double)INFINITY : cor_inline_beta_force_far(eps);
    const int i = cor_inline_row_of_eps(eps, 0, last, cor_rows_eps_zero_force);
    const double z0 = i * grid.step, z1 = (i + 1) * grid.step;
    return cor_inline_beta_of_eps(eps, z0 * z0, z1 * z1, cor_inline_eps_force_parts);
}

#endif
