/* SPDX-License-Identifier: MIT */
/* Roots, exponentials and logarithms of pairs hi + lo without a call, a jump or a table. Compilers vectorise loops over
 * them, and every processor, compiler and C library gives the same bits. */
#ifndef COR_RUNTIME_ELEMENTARY_H
#define COR_RUNTIME_ELEMENTARY_H

#include "runtime/number/pair.h"

/* A function call in a loop would prevent the vectorisation of the loop. */
#ifdef __GNUC__
#define COR_KERNEL static inline __attribute__((always_inline))
#else
#define COR_KERNEL static inline
#endif

/* For |x| < 2^51, x + 1.5 2^52 - 1.5 2^52 is x rounded to an integer k. The last bits of k + 1.5 2^52 are k. */
#define COR_KERNEL_INTEGER 6755399441055744.0

/* ln(2) in two parts. The head has 32 bits, so that its product with an integer below 2^20 is exact. The tail completes
 * it to 2^-87. */
#define COR_KERNEL_LN2_HEAD 6.93147180369123816490e-01
#define COR_KERNEL_LN2_TAIL 1.90821492927058770002e-10

/* Polynomials in x with coefficients c[0], c[1], ...; x2, x4, ... are powers of x. The chains of dependent operations
 * are short. */
#define COR_POLYNOMIAL_4(c, x, x2) (((c)[0] + (c)[1] * (x)) + ((c)[2] + (c)[3] * (x)) * (x2))
#define COR_POLYNOMIAL_8(c, x, x2, x4) (COR_POLYNOMIAL_4(c, x, x2) + COR_POLYNOMIAL_4((c) + 4, x, x2) * (x4))

/* Every polynomial of the kernels interpolates its function at the Chebyshev points of its interval, with coefficients
 * rounded once. tests/accuracy/test_polynomials.c proves the stated errors. */

/* (e^x - 1 - x)/x^2 for |x| <= 0.3467: the error times x^2 is below 2^-60. */
static const double cor_kernel_exp_polynomial[11] = {
    0x1.0p-1,
    0x1.5555555555557p-3,
    0x1.5555555555556p-5,
    0x1.11111111100d3p-7,
    0x1.6c16c16c162cfp-10,
    0x1.a01a01abeccc3p-13,
    0x1.a01a01a6db488p-16,
    0x1.71de02225a2f3p-19,
    0x1.27e4db5bb725ap-22,
    0x1.af4e092e1705bp-26,
    0x1.1f7315649f2d7p-29,
};

/* (atanh(s) - s)/s^3 times 2 in x = s^2, 0 <= x <= 0.02945: the error times x/2 is below 2^-59. */
static const double cor_kernel_log_polynomial[8] = {
    0x1.5555555555555p-1, 0x1.9999999999a38p-2, 0x1.2492492476ba1p-2, 0x1.c71c72017a15cp-3,
    0x1.745cf8f6c9119p-3, 0x1.3b1c38474d3eep-3, 0x1.0fbe478772696p-3, 0x1.0c06cf14c641bp-3,
};

/* ---- pairs ---- */

/* x + y, relative error 2^-104 where both have the same sign */
COR_KERNEL struct cor_inline_pair cor_pair_plus(struct cor_inline_pair x, struct cor_inline_pair y)
{
    const struct cor_inline_pair sum = cor_pair_two_sum(x.hi, y.hi);
    return cor_inline_sum(sum.hi, sum.lo + (x.lo + y.lo));
}

COR_KERNEL struct cor_inline_pair cor_pair_scaled(struct cor_inline_pair x, double power_of_two)
{
    return cor_pair(x.hi * power_of_two, x.lo * power_of_two);
}

/* sqrt(x) from the double `root` and a rough 1/root: relative error 2^-100 */
COR_KERNEL struct cor_inline_pair cor_pair_root_with(struct cor_inline_pair x, double root, double about_inverse)
{
    const struct cor_inline_pair square = cor_inline_product(root, root);
    return cor_pair(root, 0.5 * (((x.hi - square.hi) - square.lo) + x.lo) * about_inverse);
}

/* sqrt(x), x.hi > 0 */
COR_KERNEL struct cor_inline_pair cor_pair_root(struct cor_inline_pair x)
{
    const double root = sqrt(x.hi);
    return cor_pair_root_with(x, root, 1 / root);
}

/* x/d from `inverse`, which is 1/d within a few units of the last place: relative error 2^-100 */
COR_KERNEL struct cor_inline_pair cor_pair_over_with(struct cor_inline_pair x, struct cor_inline_pair d, double inverse)
{
    const double q = x.hi * inverse;
    const struct cor_inline_pair p = cor_inline_product(q, d.hi);
    return cor_inline_sum(q, (((x.hi - p.hi) - p.lo) + (x.lo - q * d.lo)) * inverse);
}

COR_KERNEL struct cor_inline_pair cor_pair_over(struct cor_inline_pair x, struct cor_inline_pair d)
{
    return cor_pair_over_with(x, d, 1 / d.hi);
}

/* The smaller and the larger of two numbers, neither of them NaN. Compilers vectorise these selections. */
COR_KERNEL double cor_kernel_min(double x, double y)
{
    return x < y ? x : y;
}

COR_KERNEL double cor_kernel_max(double x, double y)
{
    return x > y ? x : y;
}

/* 2^k for a whole number -1022 <= k <= 1023 */
COR_KERNEL double cor_kernel_power_of_two(double k)
{
    return cor_inline_from_bits(cor_inline_bits(k + (1023 + COR_KERNEL_INTEGER)) << 52);
}

/* ---- exp ----
 *
 * Errors stated from here on are bounds on samples: `COR_TEST_MULTIPLIER=50 test_law` takes 10^6 pairs (found: exp 0.69
 * ulp, 2^-54.7 as a pair; 1 - exp 1.13 ulp; -ln 2^-54.4). */

/* exp(-x) = 2^-k (1 + (r + q)), |r| <= ln(2)/2, |q| < |r|/4. r is exact except for the lower half of x; q is
 * rounded. */
struct cor_kernel_decay {
    double k, r, q;
};

/* Domain: |x.hi| <= 1400 */
COR_KERNEL struct cor_kernel_decay cor_kernel_decay(struct cor_inline_pair x)
{
    const double *c = cor_kernel_exp_polynomial;
    const double nearest = (x.hi * 1.4426950408889634 + COR_KERNEL_INTEGER) - COR_KERNEL_INTEGER;
    const double k = fabs(x.hi) < 0.34 ? 0 : nearest;   /* 0 in every rounding mode, so that 1 - exp(-x) does not
                                                       * cancel */
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

/* exp(-x), 0 <= x.hi <= 1400: 0.75 ulp, or 1.1 where the result is subnormal */
COR_KERNEL double cor_kernel_exp_minus(struct cor_inline_pair x)
{
    const struct cor_kernel_decay d = cor_kernel_decay(x);
    const double one = 1 + d.r, value = one + ((d.r - (one - 1)) + d.q);
    const double first = cor_kernel_min(d.k, 1000);
    return (value * cor_kernel_power_of_two(-first)) * cor_kernel_power_of_two(first - d.k);
}

/* exp(-x) as a pair, |x.hi| <= 700: relative error 2^-54.5 */
COR_KERNEL struct cor_inline_pair cor_kernel_exp_minus_pair(struct cor_inline_pair x)
{
    const struct cor_kernel_decay d = cor_kernel_decay(x);
    const double one = 1 + d.r;
    return cor_pair_scaled(cor_inline_sum(one, (d.r - (one - 1)) + d.q), cor_kernel_power_of_two(-d.k));
}

/* 1 - exp(-x), 0 <= x.hi <= 1400: 1.2 ulp, also where a subtraction would cancel */
COR_KERNEL double cor_kernel_one_minus_exp_minus(struct cor_inline_pair x)
{
    const struct cor_kernel_decay d = cor_kernel_decay(x);
    const double power = cor_kernel_power_of_two(-cor_kernel_min(d.k, 1000));
    return (1 - power) - power * (d.r + d.q);
}

/* ---- ln ---- */

/* A number as 2^k (1 + (f + lo)), sqrt(1/2) <= 1 + f < sqrt(2), |lo| of the order of the last place of 1 + f */
struct cor_kernel_split {
    double k, f, lo;
};

/* x = hi + lo, hi a normal double */
COR_KERNEL struct cor_kernel_split cor_kernel_split(struct cor_inline_pair x)
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

/* -ln of the number: relative error 2^-54.2, also near 1.
 * ln(1 + f) = f - f^2/2 + s (f^2/2 + R(s^2)), s = f/(2 + f). */
COR_KERNEL struct cor_inline_pair cor_kernel_minus_log_of(struct cor_kernel_split x)
{
    const double f = x.f, s = f / (2 + f), z = s * s, z2 = z * z, z4 = z2 * z2;
    const struct cor_inline_pair square = cor_inline_product(f, f);
    const double series = z * COR_POLYNOMIAL_8(cor_kernel_log_polynomial, z, z2, z4);
    const double rest = s * (0.5 * square.hi + series) - 0.5 * square.lo + x.lo * (1 - f + f * f);
    const struct cor_inline_pair head = cor_inline_sum(f, -0.5 * square.hi);
    const struct cor_inline_pair sum = cor_pair_two_sum(x.k * COR_KERNEL_LN2_HEAD, head.hi);
    return cor_inline_sum(-sum.hi, -(sum.lo + (head.lo + (rest + x.k * COR_KERNEL_LN2_TAIL))));
}

/* -ln(x) for x = hi + lo, hi a normal double */
COR_KERNEL struct cor_inline_pair cor_kernel_minus_log(struct cor_inline_pair x)
{
    return cor_kernel_minus_log_of(cor_kernel_split(x));
}

/* ln(1 + x), 1 + x > 0 a normal double: the relative error of cor_kernel_minus_log */
COR_INLINE struct cor_inline_pair cor_kernel_log_plus_1(double x)
{
    const struct cor_inline_pair minus = cor_kernel_minus_log(cor_pair_two_sum(1, x));
    return cor_pair(-minus.hi, -minus.lo);
}

/* -ln(1 - loss), 0 <= loss < 1. For a small loss f = -loss exactly, in every rounding mode. */
COR_KERNEL struct cor_inline_pair cor_kernel_minus_log_one_minus(double loss)
{
    const double eps = 1 - loss;
    const int small = loss < 0.25;
    struct cor_kernel_split split = cor_kernel_split(cor_pair(eps, (1 - eps) - loss));
    split.k = small ? 0 : split.k;
    split.f = small ? -loss : split.f;
    split.lo = small ? 0 : split.lo;
    return cor_kernel_minus_log_of(split);
}

#endif
