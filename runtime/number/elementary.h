/* SPDX-License-Identifier: MIT */
/* Roots, exponentials and logarithms of pairs hi + lo, without calls, jumps or tables. Compilers vectorise loops over
 * them, and every processor, compiler and C library gives the same bits. */
#ifndef COR_RUNTIME_ELEMENTARY_H
#define COR_RUNTIME_ELEMENTARY_H

#include "runtime/number/pair.h"

/* For |x| < 2^51, x + 1.5 2^52 - 1.5 2^52 is x rounded to an integer k. The last bits of k + 1.5 2^52 are k. */
#define COR_KERNEL_INTEGER 6755399441055744.0

/* pi, ln(2) and sqrt(2), rounded to doubles; COR_PI_TAIL: pi - COR_PI */
#define COR_PI 3.14159265358979312
#define COR_PI_TAIL 1.22464679914735321e-16
#define COR_LN2 0.69314718055994531
#define COR_ROOT_2 1.4142135623730951

/* ln(2) in two parts. The head has 32 bits, so that its product with an integer below 2^20 is exact. With the tail the
 * error is 2^-87. */
#define COR_KERNEL_LN2_HEAD 6.93147180369123816490e-01
#define COR_KERNEL_LN2_TAIL 1.90821492927058770002e-10

/* Polynomials in x with coefficients c[0], c[1], ...; x2, x4, ... are powers of x. Chains of dependent operations are
 * short. */
#define COR_POLYNOMIAL_4(c, x, x2) (((c)[0] + (c)[1] * (x)) + ((c)[2] + (c)[3] * (x)) * (x2))
#define COR_POLYNOMIAL_8(c, x, x2, x4) (COR_POLYNOMIAL_4(c, x, x2) + COR_POLYNOMIAL_4((c) + 4, x, x2) * (x4))

/* Each polynomial of the kernels interpolates its function at the Chebyshev points of its interval. Its coefficients
 * are rounded once. tests/accuracy/test_polynomials.c proves the stated errors. Headers of corgen law contain this
 * file. C++11 needs decimal constants, and functions of GPUs need local arrays. */

/* (e^x - 1 - x)/x^2 for |x| <= 0.3467: the error times x^2 is below 2^-60. */
#define COR_KERNEL_EXP_POLYNOMIAL                                                                                      \
    {                                                                                                                  \
        0.5, 0.1666666666666667, 0.04166666666666667, 0.00833333333332612, 0.0013888888888883737,                      \
            0.00019841269874873975, 2.480158732558584e-05, 2.755725533255441e-06, 2.7557273594799413e-07,              \
            2.510524515390137e-08, 2.0914707069612355e-09                                                              \
    }

/* 2 (atanh(s) - s)/s^3 as a function of x = s^2, 0 <= x <= 0.02945: the error times x/2 is below 2^-59. */
#define COR_KERNEL_LOG_POLYNOMIAL                                                                                      \
    {                                                                                                                  \
        0.6666666666666666, 0.4000000000000088, 0.28571428570801954, 0.22222222392089008, 0.18181795600060793,         \
            0.15386241881938595, 0.13268714792348096, 0.1308723619665962                                               \
    }

/* ---- pairs ---- */

/* Returns x + y, with relative error 2^-104 if both have the same sign. */
COR_KERNEL struct cor_inline_pair cor_pair_plus(struct cor_inline_pair x, struct cor_inline_pair y)
{
    const struct cor_inline_pair sum = cor_pair_two_sum(x.hi, y.hi);
    return cor_inline_sum(sum.hi, sum.lo + (x.lo + y.lo));
}

COR_KERNEL struct cor_inline_pair cor_pair_scaled(struct cor_inline_pair x, double power_of_two)
{
    return cor_pair(x.hi * power_of_two, x.lo * power_of_two);
}

/* Returns sqrt(x) from the double `root` and a rough 1/root: relative error 2^-100. */
COR_KERNEL struct cor_inline_pair cor_pair_root_with(struct cor_inline_pair x, double root, double about_inverse)
{
    const struct cor_inline_pair square = cor_inline_product(root, root);
    return cor_pair(root,
                    0.5 * (COR_INLINE_KEEP(COR_INLINE_KEEP(x.hi - square.hi) - square.lo) + x.lo) * about_inverse);
}

/* Returns sqrt(x), x.hi > 0. */
COR_KERNEL struct cor_inline_pair cor_pair_root(struct cor_inline_pair x)
{
    const double root = sqrt(x.hi);
    return cor_pair_root_with(x, root, 1 / root);
}

/* Return the smaller and the larger of two numbers, neither of them NaN. Compilers vectorise these selections. */
COR_KERNEL double cor_kernel_min(double x, double y)
{
    return x < y ? x : y;
}

COR_KERNEL double cor_kernel_max(double x, double y)
{
    return x > y ? x : y;
}

/* Returns 2^k for an integer -1022 <= k <= 1023. */
COR_KERNEL double cor_kernel_power_of_two(double k)
{
    return cor_inline_from_bits(cor_inline_bits(k + (1023 + COR_KERNEL_INTEGER)) << 52);
}

/* ---- exp ----
 *
 * The error bounds below are sampled, not proved. In 10^6 pairs, `COR_TEST_MULTIPLIER=50 test_law` finds these errors:
 * exp 0.69 ulp, exp as a pair 2^-54.7, 1 - exp 1.13 ulp, -ln 2^-54.4. */

/* exp(-x) = 2^-k (1 + (r + q)), |r| <= ln(2)/2, |q| < |r|/4. r is k ln(2) - x rounded to a double. q is the rounded
 * rest. */
struct cor_kernel_decay {
    double k, r, q;
};

/* Splits x, |x.hi| <= 2000. */
COR_KERNEL struct cor_kernel_decay cor_kernel_decay_of(struct cor_inline_pair x)
{
    static const double c[] = COR_KERNEL_EXP_POLYNOMIAL;
    const double nearest = COR_INLINE_KEEP(x.hi * 1.4426950408889634 + COR_KERNEL_INTEGER) - COR_KERNEL_INTEGER;
    const double k = fabs(x.hi) < 0.34 ? 0 : nearest;   /* 0 in every rounding mode: 1 - exp(-x) must not cancel */
    const double head = k * COR_KERNEL_LN2_HEAD - x.hi; /* exact */
    const struct cor_inline_pair r = cor_inline_sum(head, k * COR_KERNEL_LN2_TAIL - x.lo);
    const double s = r.hi, s2 = s * s, s4 = s2 * s2;
    const double rest = COR_POLYNOMIAL_8(c, s, s2, s4) + ((c[8] + c[9] * s) + c[10] * s2) * (s4 * s4);
    struct cor_kernel_decay decay;
    decay.k = k;
    decay.r = s;
    decay.q = r.lo + s2 * rest;
    return decay;
}

/* Returns exp(-x), 0 <= x.hi <= 1400: error 0.75 ulp, or 1.1 ulp if the result is subnormal. */
COR_KERNEL double cor_kernel_exp_minus(struct cor_inline_pair x)
{
    const struct cor_kernel_decay d = cor_kernel_decay_of(x);
    const double one = 1 + d.r, value = one + ((d.r - (one - 1)) + d.q);
    const double first = cor_kernel_min(d.k, 1000);
    return (value * cor_kernel_power_of_two(-first)) * cor_kernel_power_of_two(first - d.k);
}

/* Returns 1 + (r + q) as a pair: relative error 2^-54.5. */
COR_KERNEL struct cor_inline_pair cor_kernel_decay_sum(struct cor_kernel_decay d)
{
    const double one = COR_INLINE_KEEP(1 + d.r);
    return cor_inline_sum(one, (d.r - (one - 1)) + d.q);
}

/* Returns exp(-x) as a pair, |x.hi| <= 700: relative error 2^-54.5. */
COR_KERNEL struct cor_inline_pair cor_kernel_exp_minus_pair(struct cor_inline_pair x)
{
    const struct cor_kernel_decay d = cor_kernel_decay_of(x);
    return cor_pair_scaled(cor_kernel_decay_sum(d), cor_kernel_power_of_two(-d.k));
}

/* Returns 1 - exp(-x), 0 <= x.hi <= 1400: error 1.2 ulp, even where a subtraction would cancel. */
COR_KERNEL double cor_kernel_one_minus_exp_minus(struct cor_inline_pair x)
{
    const struct cor_kernel_decay d = cor_kernel_decay_of(x);
    const double power = cor_kernel_power_of_two(-cor_kernel_min(d.k, 1000));
    return (1 - power) - power * (d.r + d.q);
}

/* Returns exp(x) for |x| <= 700; the result is undefined beyond. The loops of runtime/disk use this function because it
 * needs fewer operations than exp of pairs. It is Taylor's series on |r| <= ln(2)/2 with terms down to 2^-55. */
COR_KERNEL double cor_kernel_exp(double x)
{
    const double shifted = x * 1.4426950408889634 + COR_KERNEL_INTEGER, k = shifted - COR_KERNEL_INTEGER;
    const double r = (x - k * COR_KERNEL_LN2_HEAD) - k * COR_KERNEL_LN2_TAIL;
    const double p =
        1.0 / 5040 +
        r * (1.0 / 40320 +
             r * (1.0 / 362880 +
                  r * (1.0 / 3628800 + r * (1.0 / 39916800 + r * (1.0 / 479001600 + r * (1.0 / 6227020800))))));
    const double e =
        1 + (r + r * r * (0.5 + r * (1.0 / 6 + r * (1.0 / 24 + r * (1.0 / 120 + r * (1.0 / 720 + r * p))))));
    return e * cor_inline_from_bits((cor_inline_bits(shifted) + 1023) << 52); /* the last bits hold the integer */
}

/* ---- ln ----
 *
 * Functions of a single number use log of the C library, which needs fewer operations. The bounds of cor_inline_log of
 * pair.h, for powers of beta, and of cor_log_ratio of lambert_w.h are proved from the error of log. */

/* A number as 2^k (1 + (f + lo)), sqrt(1/2) <= 1 + f < sqrt(2), |lo| of the order of the last place of 1 + f */
struct cor_kernel_split {
    double k, f, lo;
};

/* Splits x = hi + lo, where hi is a normal double. */
COR_KERNEL struct cor_kernel_split cor_kernel_split_of(struct cor_inline_pair x)
{
    const uint64_t root_half = UINT64_C(0x3fe6a09e667f3bcd), one = UINT64_C(0x3ff0000000000000);
    const uint64_t two52 = UINT64_C(0x4330000000000000);
    const uint64_t biased = (cor_inline_bits(x.hi) + (one - root_half)) >> 52; /* k + 1023 */
    struct cor_kernel_split s;
    s.k = cor_inline_from_bits(two52 | biased) - (4503599627370496.0 + 1023);
    s.f = cor_inline_from_bits(cor_inline_bits(x.hi) - (biased << 52) + one) - 1;
    s.lo = x.lo * (0.5 * cor_inline_from_bits((UINT64_C(2047) - biased) << 52)); /* k may be 1024 */
    return s;
}

/* Returns -ln of the number: relative error 2^-54.2, also near 1. ln(1 + f) = f - f^2/2 + s (f^2/2 + R(s^2)),
 * s = f/(2 + f). */
COR_KERNEL struct cor_inline_pair cor_kernel_minus_log_of(struct cor_kernel_split x)
{
    static const double c[] = COR_KERNEL_LOG_POLYNOMIAL;
    const double f = x.f, s = f / (2 + f), z = s * s, z2 = z * z, z4 = z2 * z2;
    const struct cor_inline_pair square = cor_inline_product(f, f);
    const double series = z * COR_POLYNOMIAL_8(c, z, z2, z4);
    const double rest = s * (0.5 * square.hi + series) - 0.5 * square.lo + x.lo * (1 - f + f * f);
    const struct cor_inline_pair head = cor_inline_sum(f, -0.5 * square.hi);
    const struct cor_inline_pair sum = cor_pair_two_sum(x.k * COR_KERNEL_LN2_HEAD, head.hi);
    return cor_inline_sum(-sum.hi, -(sum.lo + (head.lo + (rest + x.k * COR_KERNEL_LN2_TAIL))));
}

/* Returns -ln(x) for x = hi + lo, where hi is a normal double. */
COR_KERNEL struct cor_inline_pair cor_kernel_minus_log(struct cor_inline_pair x)
{
    return cor_kernel_minus_log_of(cor_kernel_split_of(x));
}

/* Returns ln(1 + x), where 1 + x > 0 is a normal double, with the relative error of cor_kernel_minus_log. */
COR_INLINE struct cor_inline_pair cor_kernel_log_plus_1(double x)
{
    const struct cor_inline_pair minus = cor_kernel_minus_log(cor_pair_two_sum(1, x));
    return cor_pair(-minus.hi, -minus.lo);
}

/* Returns -ln(1 - loss), 0 <= loss < 1. For a small loss, f = -loss exactly in every rounding mode. */
COR_KERNEL struct cor_inline_pair cor_kernel_minus_log_one_minus(double loss)
{
    const double eps = 1 - loss;
    const int small = loss < 0.25;
    struct cor_kernel_split split = cor_kernel_split_of(cor_pair(eps, (1 - eps) - loss));
    split.k = small ? 0 : split.k;
    split.f = small ? -loss : split.f;
    split.lo = small ? 0 : split.lo;
    return cor_kernel_minus_log_of(split);
}

#endif
