/* SPDX-License-Identifier: MIT */
/* The evaluator of any law's tables, x'' + beta x^b x' + x^a = 0: eps, 1 - eps, times, the largest overlap and beta of
 * eps, for every beta. Functions of the generated header fill structs with the constants of a law. A compiler therefore
 * omits the parts of each function that the law does not need.
 *
 * With increasing beta, these parts give a quantity (docs/theory.md, 9; form: docs/internals.md):
 *
 *   near     a row on a grid in beta or a root of it; eps is 1 minus the value of a row of the loss
 *   middle   a row by octaves of beta
 *   below    where there is a threshold beta_c of zero overlap, a row by octaves of beta_c - beta
 *   tail     a power of beta times a row by octaves of ln(beta)
 *   far      the same power times a series to second order in mu = beta^(-(a+1)/(b+1)), whose coefficients are
 *            polynomials in ln(beta); eps at zero overlap is v_f beta^(-1/q)
 *
 * The first coefficient of a row is a double-double and dominates, so the final addition causes nearly all of the
 * rounding error. No function raises FE_INVALID, FE_DIVBYZERO or FE_OVERFLOW or sets errno, whatever its argument. */
#ifndef COR_RUNTIME_TABLE_LAW_H
#define COR_RUNTIME_TABLE_LAW_H

#include "runtime/number/elementary.h"
#include "runtime/table/row.h"

/* Functions that take the structs below as arguments are COR_KERNEL, so that the structs are constants of each caller.
 * Otherwise copying them would cost several times the evaluation. */

/* ---- the data of a law ---- */

/* kind 0: no rows. kind 1: rows on a grid. kind 2: rows by octaves. end: the value of the variable where rows end */
struct cor_inline_law_table {
    int kind;
    const double *(*rows)(int);
    struct cor_inline_grid grid;
    struct cor_inline_octaves octaves;
    double end;
    int root; /* the variable of a grid is the root-th root of beta */
};

struct cor_inline_law_power {
    int num, den; /* den > 0, lowest terms */
};

/* One quantity of one law. For eps, `near` is (1 - eps)/beta. */
struct cor_inline_law_quantity {
    struct cor_inline_law_table near, middle, below, tail;
    const double *(*far)(int); /* a_0, a_0', a_1, a_1', a_2, ..., a_8; or, with far_kind 2, v_f and its remainder */
    int far_kind;              /* 0: no far part; 1: sum; 2: power */
    struct cor_inline_law_power power, far_power; /* powers of beta for the rows of the tail and for the far sum */
    struct cor_inline_law_power mu;               /* mu = beta^(-num/den) */
    const double *(*fall)(int);                   /* a term that the far duration at zero overlap adds */
    int has_fall;
    struct cor_inline_law_power fall_power;
    struct cor_inline_pair threshold;   /* beta_c; hi = 0 without a threshold */
    double beyond;                      /* value for beta >= the threshold */
    double infinite;                    /* value at beta = infinity */
    int linear;                         /* q = 0: eps at zero overlap is exp(-pi beta/sqrt(beta_c^2 - beta^2)) */
    struct cor_inline_pair critical;    /* beta_c^2 = 2 (a + 1) for q = 0 */
    struct cor_inline_law_power fading; /* (a - 1)/(a + 1) for q = 0: rows of `below` are duration times eps^fading */
};

/* The inverse of an eps: rows of beta/(1 - eps) near eps = 1, and rows of beta by octaves of eps */
struct cor_inline_law_inverse {
    struct cor_inline_law_table near, rows;
};

COR_KERNEL struct cor_inline_law_table cor_inline_law_none(void)
{
    struct cor_inline_law_table table;
    table.kind = 0;
    table.rows = 0;
    table.grid = cor_inline_grid_of(0, 1, 1);
    table.octaves = cor_inline_octaves_of(1, 0);
    table.end = 0;
    table.root = 1;
    return table;
}

COR_KERNEL struct cor_inline_law_table cor_inline_law_grid(const double *(*rows)(int), struct cor_inline_grid grid,
                                                           int root, double end)
{
    struct cor_inline_law_table table = cor_inline_law_none();
    table.kind = 1;
    table.rows = rows;
    table.grid = grid;
    table.root = root;
    table.end = end;
    return table;
}

COR_KERNEL struct cor_inline_law_table cor_inline_law_octaves(const double *(*rows)(int),
                                                              struct cor_inline_octaves octaves, double end)
{
    struct cor_inline_law_table table = cor_inline_law_none();
    table.kind = 2;
    table.rows = rows;
    table.octaves = octaves;
    table.end = end;
    return table;
}

/* Returns a quantity without any table. */
COR_KERNEL struct cor_inline_law_quantity cor_inline_law_quantity_of(void)
{
    struct cor_inline_law_quantity q;
    q.near = q.middle = q.below = q.tail = cor_inline_law_none();
    q.far = q.fall = 0;
    q.far_kind = q.has_fall = q.linear = 0;
    q.power.num = q.far_power.num = q.mu.num = q.fall_power.num = 0;
    q.power.den = q.far_power.den = q.mu.den = q.fall_power.den = 1;
    q.threshold.hi = q.threshold.lo = q.critical.hi = q.critical.lo = q.beyond = q.infinite = 0;
    q.fading.num = 0;
    q.fading.den = 1;
    return q;
}

COR_KERNEL struct cor_inline_law_inverse cor_inline_law_inverse_of(void)
{
    struct cor_inline_law_inverse inverse;
    inverse.near = inverse.rows = cor_inline_law_none();
    return inverse;
}

/* ---- pairs ---- */

/* Returns x^n, n > 0. Relative error n 2^-102. */
COR_INLINE struct cor_inline_pair cor_inline_pair_power(struct cor_inline_pair x, int n)
{
    struct cor_inline_pair power = cor_pair(1, 0);
    while (n > 1) {
        if (n & 1)
            power = cor_inline_pair_times(power, x);
        x = cor_inline_pair_times(x, x);
        n >>= 1;
    }
    return cor_inline_pair_times(power, x);
}

/* Returns (hi + lo) 2^k, rounded once, for hi > 0 and any k. */
COR_INLINE double cor_inline_pair_scaled(struct cor_inline_pair x, int k)
{
    const int e = cor_inline_exponent(x.hi), total = e + k;
    const double unit = cor_inline_power_of_two(-e), y = x.hi * unit + x.lo * unit; /* from about 1 to about 2 */
    if (total < -1100)
        return 0;
    if (total < -960)
        return cor_inline_scaled(y, total);
    if (total > 1023 || (total == 1023 && y >= 2))
        return cor_inline_infinity();
    return y * 0.5 * cor_inline_power_of_two(total) * 2;
}

/* Returns the root-th root of x >= 0, within a few units of the last place. */
COR_INLINE double cor_inline_root_of(double x, int root)
{
    return root == 1 ? x : root == 2 ? sqrt(x) : root == 3 ? cbrt(x) : pow(x, 1.0 / root);
}

/* Returns (x 2^e)^(num/den) as a pair times 2^*exponent, 1 <= x.hi < 2. The first terms of (1 - d)^(-1/den),
 * d = (m - r^den)/m < 2^-22, correct the root r of 26 bits. The power of r and the quotient are double-doubles. The
 * relative error is below 2^-90 for exponents up to a few hundred. */
COR_INLINE struct cor_inline_pair cor_inline_rational_power(struct cor_inline_pair x, int e,
                                                            struct cor_inline_law_power power, int *exponent)
{
    const int n = power.num < 0 ? -power.num : power.num, den = power.den;
    const int whole = e >= 0 ? e / den : -((-e + den - 1) / den), rest = e - whole * den; /* 0 <= rest < den */
    const double unit = cor_inline_power_of_two(rest);
    struct cor_inline_pair y = cor_pair(x.hi * unit, x.lo * unit), result = cor_pair(1, 0);
    *exponent = whole * power.num;
    if (n == 0)
        return result;
    if (den > 1) {
        const struct cor_inline_pair r = cor_pair(cor_inline_head(cor_inline_root_of(y.hi, den)), 0);
        const struct cor_inline_pair back = cor_inline_pair_power(r, den);
        const double d = (COR_INLINE_KEEP(COR_INLINE_KEEP(y.hi - back.hi) - back.lo) + y.lo) / back.hi;
        /* y = r^den (1 + d) */
        const double c = 1.0 / den;
        y = cor_inline_sum(r.hi, r.hi * (d * (c + d * (c * (c - 1) / 2 + d * (c * (c - 1) * (c - 2) / 6)))));
    }
    result = cor_inline_pair_power(y, n);
    if (power.num < 0)
        result = cor_pair_over(cor_pair(1, 0), result);
    return result;
}

/* Returns beta^(num/den) of a normal, finite beta > 0. */
COR_INLINE struct cor_inline_pair cor_inline_beta_power(double beta, struct cor_inline_law_power power, int *exponent)
{
    const int e = cor_inline_exponent(beta);
    return cor_inline_rational_power(cor_pair(cor_inline_significand(beta), 0), e, power, exponent);
}

/* ---- rows ---- */

/* Returns x times a row. A tiny x is scaled, because parts of the products would be subnormal. */
COR_INLINE double cor_inline_law_product(struct cor_inline_place place, double x)
{
    if (cor_inline_below(x, COR_INLINE_2_M900))
        return cor_inline_row_product(place, x * COR_INLINE_2_200) * COR_INLINE_2_M200;
    return cor_inline_row_product(place, x);
}

/* Returns the place of x in a table by octaves. */
COR_KERNEL struct cor_inline_place cor_inline_law_octave(struct cor_inline_law_table table, double x)
{
    return cor_inline_place_of(table.rows((int)cor_inline_octaves_row(table.octaves, x)),
                               cor_inline_octaves_t(table.octaves, x));
}

/* Returns the place of x in a table on a grid. */
COR_KERNEL struct cor_inline_place cor_inline_law_near(struct cor_inline_law_table table, double x)
{
    const double y = cor_inline_root_of(x, table.root);
    const int i = cor_inline_grid_row(table.grid, y);
    return cor_inline_place_of(table.rows(i), cor_inline_grid_t(table.grid, y, i));
}

/* Returns c_0 and the remainder of the row of x = hi + lo, in a table by octaves. */
COR_KERNEL struct cor_inline_pair cor_inline_law_octave_row(struct cor_inline_law_table table, struct cor_inline_pair x)
{
    struct cor_inline_place place = cor_inline_law_octave(table, x.hi);
    place.t += x.lo * cor_inline_power_of_two(-cor_inline_exponent(x.hi));
    return cor_pair(place.row[0], cor_inline_row(place));
}

/* Returns the terms of first and second order in mu = beta^(-num/den) at v = ln(beta). mu < 6e-8, so its rounding
 * errors are negligible. Below exp(-60) mu itself is negligible. */
COR_KERNEL double cor_inline_law_orders(struct cor_inline_law_quantity q, double v)
{
    const double *c = q.far(0);
    const double decay = v * q.mu.num / q.mu.den, mu = decay < 60 ? exp(-decay) : 0;
    return mu * ((c[4] + v * (c[5] + v * c[6])) + mu * (c[7] + v * (c[8] + v * (c[9] + v * c[10]))));
}

/* Returns the series to second order in mu at u = ln(beta), a_0 + a_1 u + ... */
COR_KERNEL struct cor_inline_pair cor_inline_law_far(struct cor_inline_law_quantity q, struct cor_inline_pair u)
{
    const double *c = q.far(0);
    if (q.far_kind == 2)
        return cor_pair(c[0], c[1]);
    const double v = u.hi, orders = cor_inline_law_orders(q, v);
    const struct cor_inline_pair slope = cor_inline_product(c[2], v), sum = cor_pair_two_sum(slope.hi, c[0]);
    return cor_inline_sum(sum.hi, sum.lo + (((slope.lo + c[2] * u.lo) + c[3] * v) + (c[1] + orders)));
}

/* Returns x 2^*exponent + y 2^y_exponent as a pair times 2^*exponent, with the new *exponent. */
COR_INLINE struct cor_inline_pair cor_inline_pair_plus(struct cor_inline_pair x, int *exponent,
                                                       struct cor_inline_pair y, int y_exponent)
{
    const int less = y_exponent - *exponent;
    if (less <= -200)
        return x;
    if (less >= 200) {
        *exponent = y_exponent;
        return y;
    }
    const double unit = cor_inline_power_of_two(less);
    const struct cor_inline_pair sum = cor_pair_two_sum(x.hi, y.hi * unit);
    return cor_inline_sum(sum.hi, sum.lo + (x.lo + y.lo * unit));
}

/* Returns the quantity for beta beyond the middle rows. The result is a pair times 2^*exponent. */
COR_KERNEL struct cor_inline_pair cor_inline_law_tail(struct cor_inline_law_quantity q, double beta, int *exponent)
{
    const struct cor_inline_pair u = cor_inline_log(beta);
    if (q.tail.kind && u.hi < q.tail.end) {
        const struct cor_inline_pair row = cor_inline_law_octave_row(q.tail, u);
        return cor_inline_pair_times(cor_inline_sum(row.hi, row.lo), cor_inline_beta_power(beta, q.power, exponent));
    }
    const struct cor_inline_pair power = cor_inline_beta_power(beta, q.far_power, exponent);
    const struct cor_inline_pair value = cor_inline_pair_times(cor_inline_law_far(q, u), power);
    if (!q.has_fall)
        return value;
    int other;
    const double *c = q.fall(0);
    const struct cor_inline_pair fall_power = cor_inline_beta_power(beta, q.fall_power, &other);
    return cor_inline_pair_plus(value, exponent, cor_inline_pair_times(fall_power, cor_pair(c[0], c[1])), other);
}

/* Returns beta_c - beta for 0 < beta < beta_c. For larger beta the result is 0 or negative. */
COR_KERNEL struct cor_inline_pair cor_inline_law_below(struct cor_inline_law_quantity q, double beta)
{
    return cor_inline_below(beta, COR_INLINE_2_900) ? cor_pair_two_sum(q.threshold.hi - beta, q.threshold.lo)
                                                    : cor_pair(-1, 0); /* huge beta: the sum might overflow */
}

/* For q = 0, returns -ln(eps) at zero overlap, pi beta/sqrt(beta_c^2 - beta^2), 0 < beta < beta_c. The relative error
 * is 2^-90 where eps is not 0. Next to beta_c the result is 1e9. */
COR_KERNEL struct cor_inline_pair cor_inline_law_linear(struct cor_inline_law_quantity q, double beta)
{
    const struct cor_inline_pair pi = cor_pair(COR_PI, COR_PI_TAIL);
    const struct cor_inline_pair square = cor_inline_product(beta, beta);
    const struct cor_inline_pair difference = cor_pair_two_sum(q.critical.hi, -square.hi);
    const struct cor_inline_pair om2 = cor_inline_sum(difference.hi, difference.lo + (q.critical.lo - square.lo));
    if (!(om2.hi > 1e-18))
        return cor_pair(1e9, 0);
    const struct cor_inline_pair om = cor_pair_root(om2);
    if (beta < COR_INLINE_2_M300) { /* parts of a product would be subnormal */
        const struct cor_inline_pair slope = cor_pair_over(pi, om);
        const struct cor_inline_pair l = cor_inline_pair_times(slope, cor_pair(beta * COR_INLINE_2_500, 0));
        return cor_pair((l.hi + l.lo) / COR_INLINE_2_500, 0);
    }
    return cor_pair_over(cor_inline_pair_times(pi, cor_pair(beta, 0)), om);
}

/* ---- times and the largest overlap ---- */

COR_KERNEL double cor_inline_law_value(struct cor_inline_law_quantity q, double beta)
{
    if (cor_inline_below(beta, q.near.end) || beta == 0)
        return cor_inline_row_value(cor_inline_law_near(q.near, beta == 0 ? 0 : beta));
    if (cor_inline_below(beta, q.middle.end))
        return cor_inline_row_value(cor_inline_law_octave(q.middle, beta));
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    if (q.below.kind) {
        const struct cor_inline_pair d = cor_inline_law_below(q, beta);
        if (!(d.hi > 0))
            return q.beyond;
        const struct cor_inline_pair row = cor_inline_law_octave_row(q.below, d);
        if (!q.linear)
            return row.hi + row.lo;
        const struct cor_inline_pair faded =
            cor_pair_over(cor_inline_pair_times(cor_inline_law_linear(q, beta), cor_pair(q.fading.num, 0)),
                          cor_pair(q.fading.den, 0));
        if (!(faded.hi < 1500))
            return q.beyond;
        /* exp(faded) = 1/exp(-faded) */
        const struct cor_kernel_decay decay = cor_kernel_decay_of(faded);
        const struct cor_inline_pair power = cor_pair_over(cor_inline_sum(row.hi, row.lo), cor_kernel_decay_sum(decay));
        return cor_inline_pair_scaled(power, (int)decay.k);
    }
    if (!cor_inline_is_finite(beta))
        return q.infinite;
    int exponent;
    const struct cor_inline_pair value = cor_inline_law_tail(q, beta, &exponent);
    return cor_inline_pair_scaled(value, exponent);
}

/* ---- eps and 1 - eps ---- */

COR_KERNEL double cor_inline_law_near_loss(struct cor_inline_law_quantity q, double beta)
{
    return cor_inline_law_product(cor_inline_law_near(q.near, beta), beta);
}

/* Returns eps for beta beyond the near rows as a pair times 2^*exponent; hi = 0 if eps is 0. */
COR_KERNEL struct cor_inline_pair cor_inline_law_eps_parts(struct cor_inline_law_quantity q, double beta, int *exponent)
{
    *exponent = 0;
    if (cor_inline_below(beta, q.middle.end)) {
        const struct cor_inline_place place = cor_inline_law_octave(q.middle, beta);
        return cor_pair(place.row[0], cor_inline_row(place));
    }
    if (q.below.kind) {
        const struct cor_inline_pair d = cor_inline_law_below(q, beta);
        if (!(d.hi > 0))
            return cor_pair(0, 0);
        return cor_inline_law_octave_row(q.below, d);
    }
    if (!cor_inline_is_finite(beta))
        return cor_pair(0, 0);
    return cor_inline_law_tail(q, beta, exponent);
}

COR_KERNEL double cor_inline_law_eps(struct cor_inline_law_quantity q, double beta)
{
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    if (q.linear) {
        if (beta == 0 || !(beta < q.threshold.hi))
            return beta == 0;
        const struct cor_inline_pair l = cor_inline_law_linear(q, beta);
        if (l.hi > 800)
            return 0;
        const struct cor_kernel_decay decay = cor_kernel_decay_of(l);
        return cor_inline_pair_scaled(cor_kernel_decay_sum(decay), -(int)decay.k);
    }
    if (cor_inline_below(beta, q.near.end) || beta == 0)
        return 1 - cor_inline_law_near_loss(q, beta == 0 ? 0 : beta);
    int exponent;
    const struct cor_inline_pair eps = cor_inline_law_eps_parts(q, beta, &exponent);
    return exponent == 0 ? eps.hi + eps.lo : cor_inline_pair_scaled(eps, exponent);
}

/* Returns 1 - exp(-l), l > 0. */
COR_KERNEL double cor_inline_law_linear_loss(struct cor_inline_pair l)
{
    if (l.hi > 60)
        return 1;
    if (l.hi < 0.7) {
        /* l - l^2/2 as a pair, and the other terms, at most 9 % of the sum */
        const double x = l.hi; /* x^20/20! is below 2^-71 */
        const double c15 =
            1.0 / 1307674368000.0 -
            x * (1.0 / 20922789888000.0 -
                 x * (1.0 / 355687428096000.0 - x * (1.0 / 6402373705728000.0 - x * (1.0 / 121645100408832000.0))));
        const double c11 =
            1.0 / 39916800 - x * (1.0 / 479001600 - x * (1.0 / 6227020800.0 - x * (1.0 / 87178291200.0 - x * c15)));
        const double c7 = 1.0 / 5040 - x * (1.0 / 40320 - x * (1.0 / 362880 - x * (1.0 / 3628800 - x * c11)));
        const double c3 = 1.0 / 6 - x * (1.0 / 24 - x * (1.0 / 120 - x * (1.0 / 720 - x * c7)));
        const struct cor_inline_pair square = x < 1e-100 ? cor_pair(0, 0) : cor_inline_product(x, x);
        const struct cor_inline_pair sum = cor_pair_two_sum(x, -0.5 * square.hi);
        return sum.hi + (sum.lo + (l.lo * (1 - x) - 0.5 * square.lo + x * square.hi * c3));
    }
    const struct cor_kernel_decay decay = cor_kernel_decay_of(l);
    const struct cor_inline_pair eps = cor_kernel_decay_sum(decay);
    const double unit = cor_inline_power_of_two(-(int)decay.k);
    const struct cor_inline_pair loss = cor_pair_two_sum(1, -eps.hi * unit);
    return loss.hi + (loss.lo - eps.lo * unit);
}

COR_KERNEL double cor_inline_law_loss(struct cor_inline_law_quantity q, double beta)
{
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    if (q.linear) {
        if (beta == 0 || !(beta < q.threshold.hi))
            return beta != 0;
        const struct cor_inline_pair l = cor_inline_law_linear(q, beta);
        return cor_inline_law_linear_loss(l);
    }
    if (cor_inline_below(beta, q.near.end) || beta == 0)
        return cor_inline_law_near_loss(q, beta == 0 ? 0 : beta);
    int exponent;
    const struct cor_inline_pair eps = cor_inline_law_eps_parts(q, beta, &exponent);
    if (exponent != 0)
        return 1 - cor_inline_pair_scaled(eps, exponent);
    const struct cor_inline_pair loss = cor_pair_two_sum(1, -eps.hi);
    return loss.hi + (loss.lo - eps.lo);
}

/* ---- the inverse ---- */

/* Returns (c_0/eps)^s as a pair times 2^*exponent, where eps = c_0 beta^power and s = -1/power. */
COR_KERNEL struct cor_inline_pair cor_inline_law_beta_of_power(struct cor_inline_law_quantity q, double eps,
                                                               int *exponent)
{
    const double *c = q.far(0);
    const int tiny = eps < COR_INLINE_2_M900;
    const double scaled = tiny ? eps * COR_INLINE_2_200 : eps;
    const struct cor_inline_pair ratio = cor_pair_over(cor_pair(c[0], c[1]), cor_pair(scaled, 0));
    const int e = cor_inline_exponent(ratio.hi);
    const double unit = cor_inline_power_of_two(-e);
    struct cor_inline_law_power inverse;
    inverse.num = q.power.den;
    inverse.den = -q.power.num;
    return cor_inline_rational_power(cor_pair(ratio.hi * unit, ratio.lo * unit), e + (tiny ? 200 : 0), inverse,
                                     exponent);
}

/* Returns beta of an eps below the rows. At zero overlap eps is the power v_f beta^(-1/q). At zero force
 * eps = beta^power (a_0 + ...), so beta = R (1 + x)^s. R is beta without the other terms, and x is the sum of these
 * terms divided by a_0, below 1e-5. The loop iterates ln(beta) = ln(R) + s x. */
COR_KERNEL double cor_inline_law_beta_far(struct cor_inline_law_quantity q, double eps)
{
    int exponent;
    const struct cor_inline_pair root = cor_inline_law_beta_of_power(q, eps, &exponent);
    if (q.far_kind == 2)
        return cor_inline_pair_scaled(root, exponent);
    const double s = (double)q.power.den / -q.power.num, log_root = log(root.hi) + exponent * COR_LN2;
    double x = 0;
    for (int k = 0; k < 3; k++)
        x = cor_inline_law_orders(q, log_root + s * x) / q.far(0)[0];
    const double more = s * x * (1 + (s - 1) * x / 2);
    return cor_inline_pair_scaled(cor_inline_sum(root.hi, root.lo + root.hi * more), exponent);
}

/* Returns the smallest beta that has this eps, for eps <= 1/2. */
COR_KERNEL double cor_inline_law_beta_low(struct cor_inline_law_quantity q, struct cor_inline_law_inverse inverse,
                                          double eps)
{
    if (cor_inline_between(eps, inverse.rows.octaves.first, inverse.rows.end))
        return cor_inline_row_value(cor_inline_law_octave(inverse.rows, eps));
    if (q.threshold.hi > 0)
        return q.threshold.hi;
    if (eps == 0)
        return cor_inline_infinity();
    return cor_inline_law_beta_far(q, eps);
}

/* Returns the round-off of the root of a loss. Without this correction beta/loss, which grows with the root, has an
 * error of two units of the last place next to loss = 1/2. A small loss needs no correction. */
COR_KERNEL double cor_inline_law_root_rest(double loss, int root)
{
    if (root == 1 || loss < 0.00390625)
        return 0;
    const double y = cor_inline_root_of(loss, root);
    const struct cor_inline_pair back = cor_inline_pair_power(cor_pair(y, 0), root);
    return y * (COR_INLINE_KEEP(COR_INLINE_KEEP(loss - back.hi) - back.lo) / (root * back.hi));
}

/* Returns the smallest beta that has this loss, for 0 <= loss <= 1/2. */
COR_KERNEL double cor_inline_law_beta_near(struct cor_inline_law_inverse inverse, double loss)
{
    struct cor_inline_place place = cor_inline_law_near(inverse.near, loss);
    place.t += cor_inline_law_root_rest(loss, inverse.near.root);
    return cor_inline_law_product(place, loss);
}

/* Returns beta_c loss/pi for a loss that may be subnormal. */
COR_KERNEL double cor_inline_law_linear_slope(struct cor_inline_law_quantity q, double loss)
{
    const struct cor_inline_pair pi = cor_pair(COR_PI, COR_PI_TAIL);
    const struct cor_inline_pair slope = cor_pair_over(q.threshold, pi);
    const struct cor_inline_pair beta = cor_inline_pair_times(slope, cor_pair(loss * COR_INLINE_2_200, 0));
    return (beta.hi + beta.lo) * COR_INLINE_2_M200;
}

/* For q = 0 at zero overlap, returns beta_c L/sqrt(pi^2 + L^2), L = -ln(eps). */
COR_KERNEL double cor_inline_law_beta_linear(struct cor_inline_law_quantity q, double eps, double loss)
{
    const struct cor_inline_pair pi2 = cor_pair(9.869604401089358, 6.265295508739711e-16);
    const double l = loss < 0.5 ? -log1p(-loss) : eps == 0 ? 1e9 : -log(eps);
    if (loss < 1e-100) /* L equals the loss, and its square underflows */
        return cor_inline_law_linear_slope(q, loss);
    const struct cor_inline_pair square = cor_inline_product(l, l), sum = cor_pair_two_sum(pi2.hi, square.hi);
    const struct cor_inline_pair root = cor_pair_root(cor_inline_sum(sum.hi, sum.lo + (pi2.lo + square.lo)));
    const struct cor_inline_pair ratio = cor_pair_over(cor_pair(l, 0), root);
    const struct cor_inline_pair beta = cor_inline_pair_times(ratio, q.threshold);
    return eps == 0 ? q.threshold.hi : beta.hi + beta.lo;
}

COR_KERNEL double cor_inline_law_beta(struct cor_inline_law_quantity q, struct cor_inline_law_inverse inverse,
                                      double eps)
{
    const double positive = eps == 0 ? 0 : eps; /* not -0 */
    if (cor_inline_bits(positive) > cor_inline_bits(1))
        return cor_inline_nan();
    if (q.linear)
        return cor_inline_law_beta_linear(q, positive, 1 - positive);
    return positive < 0.5 ? cor_inline_law_beta_low(q, inverse, positive)
                          : cor_inline_law_beta_near(inverse, 1 - positive);
}

COR_KERNEL double cor_inline_law_beta_of_loss(struct cor_inline_law_quantity q, struct cor_inline_law_inverse inverse,
                                              double loss)
{
    const double positive = loss == 0 ? 0 : loss; /* not -0 */
    if (cor_inline_bits(positive) > cor_inline_bits(1))
        return cor_inline_nan();
    if (q.linear)
        return cor_inline_law_beta_linear(q, 1 - positive, positive);
    return positive > 0.5 ? cor_inline_law_beta_low(q, inverse, 1 - positive)
                          : cor_inline_law_beta_near(inverse, positive);
}

#endif
