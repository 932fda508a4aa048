/* SPDX-License-Identifier: MIT */
/* Tests the fifth root and the arithmetic of pairs that it uses (runtime/number/fifth_root.h, runtime/number/pair.h)
 * against long double. */
#include "check.h"

#include "runtime/number/fifth_root.h"

/* Returns x^(1/5) by a Newton step on powl, accurate to a unit of long double. */
static long double root_exact(long double x)
{
    long double r = powl(x, 0.2L);
    const long double r4 = r * r * r * r;
    r -= (r4 * r - x) / (5 * r4);
    return r;
}

/* Returns the relative error in units of 2^-53. */
static long double error_of(long double computed, long double exact)
{
    return fabsl(computed / exact - 1) / (DBL_EPSILON / 2);
}

static const long double slack = LDBL_MANT_DIG >= 64 ? 0.01L : 2;

TEST(whole_range)
{
    for (size_t i = 0; i < points(200000); i++) {
        const double x = i % 4 == 0 ? random_log(&draw, 5e-324, 1e-300) : random_log(&draw, DBL_MIN, DBL_MAX);
        const double root = cor_inline_fifth_root(x);
        check(error_of(root, root_exact(x)) <= 1.5L + slack, "%a -> %a", x, root);
    }
}

TEST(parts)
{
    for (size_t i = 0; i < points(200000); i++) {
        const double x = random_log(&draw, 0x1p-1000, 0x1p1000);
        const struct cor_inline_pair root = cor_inline_fifth_root_parts(x);
        assert_true(cor_inline_head(root.hi) == root.hi);
        assert_true(same_bits(cor_inline_fifth_root_normal(x), root.hi + root.lo));
        assert_true(fabs(root.lo) < 0x1p-12 * root.hi);
        const long double error = error_of((long double)root.hi + root.lo, root_exact(x));
        check(error <= 0.5L + slack, "%a -> %a + %a: %Lg", x, root.hi, root.lo, error);
    }
}

/* The pair has the bound 2^-58 before its sum is rounded. long double has 11 bits more than a double. */
TEST(of_pair)
{
    for (size_t i = 0; i < points(20000); i++) {
        const double x = random_log(&draw, 0x1p-1000, 0x1p1000);
        const struct cor_inline_pair pair = {x, x * random_uniform(&draw, -0x1p-54, 0x1p-54)};
        const struct cor_inline_pair root = cor_inline_fifth_root_of_pair(pair);
        const long double error = error_of((long double)root.hi + root.lo, root_exact((long double)pair.hi + pair.lo));
        check(error <= 0x1p-5L + slack, "%a + %a -> %a + %a: %Lg", pair.hi, pair.lo, root.hi, root.lo, error);
    }
}

/* The seed comes from a fifth of the bits of x, so its error repeats every five octaves. Tests all five densely. */
TEST(five_octaves)
{
    for (double x = 1; x < 32; x += 0x1p-12) {
        assert_true(error_of(cor_inline_fifth_root_normal(x), root_exact(x)) <= 1.5L + slack);
        assert_true(same_bits(cor_inline_fifth_root(x * 0x1p-500) * 0x1p100, cor_inline_fifth_root(x)));
    }
}

TEST(exact_powers)
{
    for (int k = 1; k < 1500; k++) {
        const double x = k, power = x * x * x * x * x;
        check(cor_inline_fifth_root(power) == x, "%d", k);
        check(cor_inline_fifth_root(ldexp(power, 900)) == ldexp(x, 180), "%d", k);
        check(cor_inline_fifth_root(ldexp(power, -1000)) == ldexp(x, -200), "%d", k);
    }
    for (int k = -1070; k <= 1020; k += 5)
        check(cor_inline_fifth_root(ldexp(1, k)) == ldexp(1, k / 5), "2^%d", k);
}

TEST(special_values)
{
    assert_true(same_bits(cor_inline_fifth_root(0.0), 0.0) && same_bits(cor_inline_fifth_root(-0.0), -0.0));
    assert_true(cor_inline_fifth_root(INFINITY) == INFINITY);
    assert_true(isnan(cor_inline_fifth_root(NAN)));
    assert_true(cor_inline_fifth_root(-32) == -32); /* this function accepts such numbers; its callers refuse them */
    EACH (edge, 0x1p-900, 0x1p900, DBL_MIN, DBL_MAX, 5e-324) {
        const double side[3] = {nextafter(*edge, 0), *edge, nextafter(*edge, DBL_MAX)};
        for (int k = 0; k < 3; k++)
            if (side[k] > 0)
                check(error_of(cor_inline_fifth_root(side[k]), root_exact(side[k])) <= 1.5L + slack, "%a", side[k]);
    }
}

/* Products and quotients of pairs agree with long double, which has 11 more bits. */
TEST(pairs)
{
    for (size_t i = 0; i < points(50000); i++) {
        const double x = random_log(&draw, 1e-100, 1e100), y = -random_log(&draw, 1e-100, 1e100);
        const struct cor_inline_pair p = cor_inline_product(x, y);
        assert_true(p.hi == x * y);
        const double head = cor_inline_head(x);
        assert_true(head + (x - head) == x && fabs(x - head) < 0x1p-25 * fabs(head));
        assert_true(cor_inline_product(head, head).lo == 0);
        /* the tails have 27 bits, so the product of two tails may lose one bit */
        assert_true(fabs(p.lo - fma(x, y, -p.hi)) <= 0x1p-104 * fabs(p.hi));
        const struct cor_inline_pair a = {x, x * 0x1p-54}, b = {y, -y * 0x1p-55}, q = cor_pair_over(a, b),
                                     back = cor_inline_pair_times(q, b);
        assert_true(fabs(q.lo) <= 0x1p-52 * fabs(q.hi));
        assert_true(fabs((back.hi - a.hi) + (back.lo - a.lo)) < 0x1p-98 * fabs(x));
        const struct cor_inline_pair sum = cor_inline_sum(x, x * 0.3);
        assert_true(sum.hi == x + x * 0.3 && sum.hi - x + sum.lo == x * 0.3);
    }
}
