/* SPDX-License-Identifier: MIT */
/* Lambert's t of q (runtime/number/lambert_w.h) against long double. tests/accuracy/test_disk_law.c compares it with
 * balls. */
#include "check.h"

#include "runtime/number/lambert_w.h"

static const long double slack = LDBL_MANT_DIG >= 64 ? 0.01L : 4;

/* Returns t - ln(1 + t), t >= 0. With z = t/(2 + t) it is t z - 2 (z^3/3 + z^5/5 + ...). */
static long double q_exact(long double t)
{
    if (t > 0.6L)
        return t - log1pl(t);
    const long double z = t / (2 + t), square = z * z;
    long double sum = 0;
    for (int k = 41; k >= 3; k -= 2)
        sum = square * (sum + 2.0L / k);
    return z * (t - sum);
}

/* Returns the error of t: the error of q(t) divided by the slope t/(1 + t). The exact q is q0 + q1. */
static long double t_off(struct cor_inline_pair t, long double q0, long double q1)
{
    const long double whole = (long double)t.hi + t.lo;
    return ((q_exact(whole) - q0) - q1) * (1 + whole) / whole;
}

/* All magnitudes of q, and both sides of the places where the method changes. The second part of q is not lost. */
TEST(t_of_q)
{
    static const double boundary[] = {0x1p-500, 0.1, 3, 0x1p400};
    for (size_t i = 0; i < points(100000); i++) {
        const double edge = boundary[i / 3 % 4];
        const double hi = i < 12       ? nextafter(edge, edge + (double)(i % 3) - 1)
                          : i % 3 == 0 ? random_log(&draw, 1e-300, 1e4)
                          : i % 3 == 1 ? random_log(&draw, 0.01, 100)
                                       : random_log(&draw, 1e-30, 1e3);
        const double lo = i % 3 == 2 && i >= 12 ? hi * random_uniform(&draw, -0x1p-53, 0x1p-53) : 0;
        const struct cor_inline_pair q = {hi, lo}, t = cor_lambert_t_pair(q);
        const long double off = t_off(t, hi, lo), whole = (long double)t.hi + t.lo;
        const long double rounded = lo == 0 ? fabsl(cor_lambert_t(hi) - (whole - off)) / ulp(whole) : 0,
                          relative = fabsl(off) / (1 + whole) * 0x1p53L;
        check(rounded <= 2 + slack, "t(%a) = %a: %Lg ulp", hi, cor_lambert_t(hi), rounded);
        check(relative <= 1 + slack, "1 + t(%a + %a): %Lg 2^-53", hi, lo, relative);
        /* for small q only the terms of the series after the first are rounded; their sum is below t/60 */
        const long double bound = hi < 1e-3 ? 0x1p-57L : 1.5L * 0x1p-52L;
        check(hi < 1e-30 || hi > 1e3 || fabsl(off) <= (bound + slack * 0x1p-53L) * whole, "t(%a + %a): %Lg", hi, lo,
              off / whole);
    }
}

TEST(series)
{
    assert_true(cor_lambert_t(0) == 0);
    /* t is sqrt(2 q) (1 + sqrt(2 q)/3), because the next term is negligible */
    for (int exponent = -1074; exponent < -120; exponent++) {
        const long double q = ldexpl(1, exponent), p = sqrtl(2 * q);
        check(ulp_error(cor_lambert_t((double)q), p * (1 + p / 3)) <= 0.6L + slack, "2^%d", exponent);
    }
    check_nan(cor_lambert_t(-0x1p-1074), cor_lambert_t(-1), cor_lambert_t(NAN));
}

/* Tests ln(a/x), computed from x, a and ln(a). */
TEST(log_ratios)
{
    const struct cor_logarithm pi = {{3.14159265358979312, 1.22464679914735321e-16},
                                     {1.14472988584940016, 1.02659511627078262e-17}};
    const long double exact_pi = 3.14159265358979323846264338327950288L;
    for (size_t i = 0; i < points(50000); i++) {
        const double x = i % 2 ? random_log(&draw, 1e-323, 3) : random_uniform(&draw, 1, 3.14159265358979311);
        const struct cor_inline_pair far = cor_log_ratio_far(pi.log, x), q = cor_log_ratio(&pi, x);
        const long double exact = x > 1.5 ? -log1pl(((long double)x - exact_pi) / exact_pi) : logl(exact_pi / x);
        check(fabsl(far.hi + (far.lo - exact)) <= (1 + slack) * (0x1p-54L + 0x1p-62L * exact), "far, %a", x);
        check(fabsl(q.hi + (q.lo - exact)) <= (1 + slack) * 0x1p-52L * exact + 0x1p-64L, "%a", x);
    }
    /* pi exceeds its double by 1.22e-16 */
    const struct cor_inline_pair last = cor_log_ratio(&pi, pi.number.hi);
    assert_true(fabs(last.hi / (1.22464679914735321e-16 / 3.14159265358979312) - 1) < 1e-15);
    check_nan(cor_log_ratio(&pi, nextafter(pi.number.hi, 4)).hi, cor_log_ratio(&pi, INFINITY).hi,
              cor_log_ratio(&pi, NAN).hi);
}
