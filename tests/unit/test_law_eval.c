/* SPDX-License-Identifier: MIT */
/* The parts of runtime/table/law.h that only headers of `corgen law` use, in closed form: the linear dashpot, and eps
 * that decreases with a power of beta. tests/law/run tests them with the tables of such headers. */
#include "check.h"

#include "runtime/table/law.h"

/* Stands in for a table, because a closed form reads no row. */
static const double *no_rows(int row)
{
    static const double zeros[16];
    fail_msg("row %d of a law without rows", row);
    return zeros;
}

static struct cor_inline_law_quantity without_rows(void)
{
    struct cor_inline_law_quantity q = cor_inline_law_quantity_of();
    q.near.rows = q.middle.rows = q.below.rows = q.tail.rows = q.far = q.fall = no_rows;
    return q;
}

static struct cor_inline_law_inverse inverse_without_rows(void)
{
    struct cor_inline_law_inverse inverse = cor_inline_law_inverse_of();
    inverse.near.rows = inverse.rows.rows = no_rows;
    return inverse;
}

/* Returns the quantity of x'' + beta x' + x = 0. */
static struct cor_inline_law_quantity linear(void)
{
    struct cor_inline_law_quantity q = without_rows();
    q.linear = 1;
    q.threshold.hi = 2;
    q.critical.hi = 4;
    return q;
}

/* eps = exp(-pi beta/sqrt(4 - beta^2)) */
TEST(linear_eps)
{
    const long double pi = acosl(-1);
    for (size_t i = 0; i < points(2000); i++) {
        const double beta = i % 2 == 0 ? random_log(&draw, 1e-300, 1.9) : random_uniform(&draw, 0, 1.9);
        const long double l = pi * beta / sqrtl((2 - (long double)beta) * (2 + (long double)beta));
        check_ulp(cor_inline_law_eps(linear(), beta), expl(-l), 1);
        check_ulp(cor_inline_law_loss(linear(), beta), -expm1l(-l), 1);
    }
    assert_true(cor_inline_law_eps(linear(), 0) == 1 && cor_inline_law_eps(linear(), 2) == 0);
    assert_true(cor_inline_law_loss(linear(), 0) == 0 && cor_inline_law_loss(linear(), 2) == 1);
}

/* beta = 2 L/sqrt(pi^2 + L^2), L = -ln(eps) */
TEST(linear_beta)
{
    const long double pi = acosl(-1);
    const struct cor_inline_law_inverse none = inverse_without_rows();
    for (size_t i = 0; i < points(2000); i++) {
        const double x = i % 2 == 0 ? random_log(&draw, 1e-300, 1) : random_uniform(&draw, 0, 1);
        const long double of_eps = -logl(x), of_loss = -log1pl(-(long double)x);
        check_ulp(cor_inline_law_beta(linear(), none, x), 2 * of_eps / sqrtl(pi * pi + of_eps * of_eps), 2);
        check_ulp(cor_inline_law_beta_of_loss(linear(), none, x), 2 * of_loss / sqrtl(pi * pi + of_loss * of_loss), 2);
    }
    assert_true(cor_inline_law_beta(linear(), none, 0) == 2 && cor_inline_law_beta(linear(), none, 1) == 0);
    for (int k = -1074; k < -1022; k++) /* subnormal */
        check(fabsl(cor_inline_law_beta_of_loss(linear(), none, ldexp(1, k)) - 2 / pi * ldexpl(1, k)) <= 0x1p-1074L,
              "beta of loss 2^%d", k);
}

/* Returns a constant row of 3/4 for the duration times eps^fading. */
static const double *rows_of_3_4(int row)
{
    static const double three_quarters[16] = {0.75};
    assert_true(row >= 0);
    return three_quarters;
}

TEST(fading_duration)
{
    const long double pi = acosl(-1);
    struct cor_inline_law_quantity q = linear();
    q.below = cor_inline_law_octaves(rows_of_3_4, cor_inline_octaves_of(0x1p-60, 3), 0);
    q.beyond = INFINITY;
    for (size_t i = 0; i < points(2000); i++) {
        const double beta = random_uniform(&draw, 0.01, 1.95);
        const long double l = pi * beta / sqrtl((2 - (long double)beta) * (2 + (long double)beta));
        q.fading.num = i % 2 == 0 ? 1 : 3;
        q.fading.den = i % 2 == 0 ? 5 : 1;
        check_ulp(cor_inline_law_value(q, beta), 0.75L * expl(l * q.fading.num / q.fading.den), 1);
    }
    assert_true(isinf(cor_inline_law_value(q, 2)) && isinf(cor_inline_law_value(q, nextafter(2, 0))));
}

/* eps = v_f beta^(-2/n) */
static const double *falling(int i)
{
    static const double v_f[2] = {1.5, 0x1.8p-54};
    return v_f + i;
}

TEST(falling_beta)
{
    const struct cor_inline_law_inverse none = inverse_without_rows();
    for (size_t i = 0; i < points(2000); i++) {
        struct cor_inline_law_quantity q = without_rows();
        q.far = falling;
        q.far_kind = 2;
        q.power.num = -2;
        q.power.den = i % 2 == 0 ? 1 : 3;
        const double eps = random_log(&draw, i % 2 == 0 ? 1e-310 : 1e-200, 0.5);
        check_ulp(cor_inline_law_beta(q, none, eps), powl((1.5L + 0x1.8p-54L) / eps, q.power.den / 2.0L), 2);
    }
}

/* A far duration with a term that falls: v_f (beta^(-1/2) + beta^(-3)) */
TEST(falling_duration)
{
    struct cor_inline_law_quantity q = without_rows();
    q.far = q.fall = falling;
    q.far_kind = 2;
    q.has_fall = 1;
    q.far_power.num = -1;
    q.far_power.den = 2;
    q.fall_power.num = -3;
    for (size_t i = 0; i < points(2000); i++) {
        const double beta = random_log(&draw, 0.1, 1e30);
        check_ulp(cor_inline_law_value(q, beta),
                  (1.5L + 0x1.8p-54L) * (1 / sqrtl(beta) + 1 / ((long double)beta * beta * beta)), 1);
    }
}

/* The sum of two scaled pairs is right for any exponents. A summand that is 200 octaves smaller is omitted. */
TEST(sums_of_scaled_pairs)
{
    for (size_t i = 0; i < points(2000); i++) {
        const double x = random_uniform(&draw, 1, 2), y = random_uniform(&draw, 1, 2);
        const int first = (int)random_uniform(&draw, -900, 900), less = (int)random_uniform(&draw, -300, 300);
        int exponent = first;
        const struct cor_inline_pair sum =
            cor_inline_pair_plus(cor_pair(x, 0x1p-60 * x), &exponent, cor_pair(y, 0x1p-60 * y), first + less);
        const long double total = ((long double)sum.hi + sum.lo) * powl(2, exponent - first);
        const long double exact = (x + y * powl(2, less)) * (1 + 0x1p-60L);
        check(fabsl(total / exact - 1) < 1e-18L, "%a and %a times 2^%d: %.20Lg, not %.20Lg", x, y, less, total, exact);
    }
}
