/* SPDX-License-Identifier: MIT */
/* Bits of doubles, and sums and products with their rounding errors.
 *
 * The functions classify arguments by their bits, as integers. Floating-point comparisons raise FE_INVALID for a NaN,
 * and -ffinite-math-only lets a compiler assume that no NaN occurs. Products split their factors by a bit mask.
 * Veltkamp's multiplication would give wrong results where a compiler fuses multiplications with additions. */
#ifndef COR_RUNTIME_PAIR_H
#define COR_RUNTIME_PAIR_H

#include "runtime/number/inline.h"

/* Powers of two, in decimal because hexadecimal constants need C++17 */
#define COR_INLINE_2_M900 1.18305218616677471e-271
#define COR_INLINE_2_M574 1.61726984478087796e-173
#define COR_INLINE_2_M500 3.05493636349960468e-151
#define COR_INLINE_2_M300 4.90909346529772656e-91
#define COR_INLINE_2_M200 6.22301527786114171e-61
#define COR_INLINE_2_M60 8.67361737988403547e-19
#define COR_INLINE_2_M40 9.09494701772928238e-13
#define COR_INLINE_2_40 1.09951162777600000e+12
#define COR_INLINE_2_60 1.15292150460684698e+18
#define COR_INLINE_2_100 1.26765060022822940e+30
#define COR_INLINE_2_200 1.60693804425899028e+60
#define COR_INLINE_2_250 1.80925139433306555e+75
#define COR_INLINE_2_300 2.03703597633448609e+90
#define COR_INLINE_2_500 3.27339060789614187e+150
#define COR_INLINE_2_600 4.14951556888099296e+180
#define COR_INLINE_2_900 8.45271249817064394e+270
#define COR_INLINE_2_964 1.55925024182399985e+290
#define COR_INLINE_2_1000 1.07150860718626732e+301

/* Keeps -ffast-math from rearranging a value: otherwise (a + b) - a becomes b. */
#if defined(__has_builtin) && !defined(__CUDACC__) && !defined(__HIPCC__)
#if __has_builtin(__builtin_assoc_barrier)
#define COR_INLINE_KEEP(x) __builtin_assoc_barrier(x)
#elif __has_builtin(__arithmetic_fence) && defined(__FAST_MATH__)
#define COR_INLINE_KEEP(x) __arithmetic_fence(x)
#endif
#endif
#ifndef COR_INLINE_KEEP
#define COR_INLINE_KEEP(x) (x)
#endif

COR_INLINE uint64_t cor_inline_bits(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

COR_INLINE double cor_inline_from_bits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* True if 0 <= x < end; false for -0 and NaN. The bits of nonnegative doubles, read as integers, have the order of the
 * doubles. The bits of negative doubles are larger. */
COR_INLINE int cor_inline_below(double x, double end)
{
    return cor_inline_bits(x) < cor_inline_bits(end);
}

/* True if least <= x < end; false for NaN. The unsigned difference is huge for negative numbers and for numbers below
 * `least`. */
COR_INLINE int cor_inline_between(double x, double least, double end)
{
    return cor_inline_bits(x) - cor_inline_bits(least) < cor_inline_bits(end) - cor_inline_bits(least);
}

#define COR_INLINE_INFINITY_BITS UINT64_C(0x7ff0000000000000)
#define COR_INLINE_SIGN_BIT UINT64_C(0x8000000000000000)

COR_INLINE double cor_inline_infinity(void)
{
    return cor_inline_from_bits(COR_INLINE_INFINITY_BITS);
}

COR_INLINE double cor_inline_nan(void)
{
    return cor_inline_from_bits(UINT64_C(0x7ff8000000000000));
}

/* Returns the float nearest to x, without FE_OVERFLOW. A conditional is not used: clang would convert both sides. */
COR_INLINE float cor_inline_narrow(double x)
{
    const double beyond = 3.40282356779733662e+38; /* halfway between the largest float and 2^128 */
    const int fits = cor_inline_below(x, beyond) || cor_inline_bits(x) > COR_INLINE_INFINITY_BITS;
    return (float)(x * (fits ? 1 : cor_inline_infinity()));
}

COR_INLINE int cor_inline_is_zero(double x)
{
    return (cor_inline_bits(x) & ~COR_INLINE_SIGN_BIT) == 0;
}

COR_INLINE int cor_inline_is_finite(double x)
{
    return (cor_inline_bits(x) & ~COR_INLINE_SIGN_BIT) < COR_INLINE_INFINITY_BITS;
}

COR_INLINE int cor_inline_is_nan(double x)
{
    return (cor_inline_bits(x) & ~COR_INLINE_SIGN_BIT) > COR_INLINE_INFINITY_BITS;
}

/* True if x is negative or NaN; -0 is neither. */
COR_INLINE int cor_inline_is_refused(double x)
{
    return cor_inline_bits(x) > COR_INLINE_INFINITY_BITS && cor_inline_bits(x) != COR_INLINE_SIGN_BIT;
}

/* Returns if_true or if_false, selected by bits. A processor would mispredict half of the jumps for scattered
 * arguments. */
COR_INLINE double cor_inline_choose(int choice, double if_true, double if_false)
{
    const uint64_t mask = (uint64_t)0 - (uint64_t)(choice != 0);
    return cor_inline_from_bits((cor_inline_bits(if_true) & mask) | (cor_inline_bits(if_false) & ~mask));
}

/* Returns 2^k, -1022 <= k <= 1023. */
COR_INLINE double cor_inline_power_of_two(int k)
{
    return cor_inline_from_bits((uint64_t)(1023 + k) << 52);
}

/* Return the exponent e of a normal x, 2^e <= |x| < 2^(e+1), and |x| 2^-e. */
COR_INLINE int cor_inline_exponent(double x)
{
    return (int)((cor_inline_bits(x) >> 52) & 2047) - 1023;
}

COR_INLINE double cor_inline_significand(double x)
{
    return cor_inline_from_bits((cor_inline_bits(x) & UINT64_C(0xfffffffffffff)) | UINT64_C(0x3ff0000000000000));
}

/* Returns x > 0 times a power of two, which must give a normal number. The bits of a subnormal x count its units of
 * 2^-1074, even if the processor flushes such numbers to 0. */
COR_INLINE double cor_inline_raised(double x, double power)
{
    if (cor_inline_bits(x) >> 52 != 0)
        return x * power;
    return (double)cor_inline_bits(x) * COR_INLINE_2_M574 * (power * COR_INLINE_2_M500);
}

/* Returns x 2^k for 2^-60 < |x| < 2^60 and k <= 960, rounded once. Unlike ldexp, this function does not set errno. */
COR_INLINE double cor_inline_scaled(double x, int k)
{
    if (k >= -960)
        return x * cor_inline_power_of_two(k);
    /* the first product is a normal number, and exact */
    k += 900;
    return x * COR_INLINE_2_M900 * cor_inline_power_of_two(k < -1022 ? -1022 : k);
}

/* Returns the 26 leading bits of x. Products of two such numbers are exact. */
COR_INLINE double cor_inline_head(double x)
{
    return cor_inline_from_bits(cor_inline_bits(x) & UINT64_C(0xfffffffff8000000));
}

/* The unevaluated sum hi + lo; |lo| is of the order of hi's last place. */
struct cor_inline_pair {
    double hi, lo;
};

COR_INLINE struct cor_inline_pair cor_pair(double hi, double lo)
{
    struct cor_inline_pair x;
    x.hi = hi;
    x.lo = lo;
    return x;
}

/* Returns hi + lo as a pair, exact if |hi| >= |lo|. */
COR_INLINE struct cor_inline_pair cor_inline_sum(double hi, double lo)
{
    struct cor_inline_pair sum;
    sum.hi = COR_INLINE_KEEP(hi + lo);
    sum.lo = lo - COR_INLINE_KEEP(sum.hi - hi);
    return sum;
}

/* Returns x + y exactly, for x and y in any order. */
COR_INLINE struct cor_inline_pair cor_pair_two_sum(double x, double y)
{
    const double hi = COR_INLINE_KEEP(x + y), part = COR_INLINE_KEEP(hi - x);
    return cor_pair(hi, COR_INLINE_KEEP(x - COR_INLINE_KEEP(hi - part)) + COR_INLINE_KEEP(y - part));
}

/* Returns x y with relative error 2^-104, if nothing underflows. */
COR_INLINE struct cor_inline_pair cor_inline_product(double x, double y)
{
    const double xh = cor_inline_head(x), xl = x - xh, yh = cor_inline_head(y), yl = y - yh;
    struct cor_inline_pair product;
    product.hi = COR_INLINE_KEEP(x * y);
    product.lo = COR_INLINE_KEEP(COR_INLINE_KEEP(xh * yh - product.hi) + xh * yl + xl * yh) + xl * yl;
    return product;
}

/* Returns x y with a relative error of a few 2^-104. */
COR_INLINE struct cor_inline_pair cor_inline_pair_times(struct cor_inline_pair x, struct cor_inline_pair y)
{
    const struct cor_inline_pair p = cor_inline_product(x.hi, y.hi);
    return cor_inline_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}

/* Returns x/d with relative error 2^-100. inverse: 1/d within a few units of the last place. */
COR_KERNEL struct cor_inline_pair cor_pair_over_with(struct cor_inline_pair x, struct cor_inline_pair d, double inverse)
{
    const double q = x.hi * inverse;
    const struct cor_inline_pair p = cor_inline_product(q, d.hi);
    return cor_inline_sum(q, (COR_INLINE_KEEP(COR_INLINE_KEEP(x.hi - p.hi) - p.lo) + (x.lo - q * d.lo)) * inverse);
}

COR_KERNEL struct cor_inline_pair cor_pair_over(struct cor_inline_pair x, struct cor_inline_pair d)
{
    return cor_pair_over_with(x, d, 1 / d.hi);
}

/* Returns ln(x) of a normal, finite x >= 1. If log is within 1 ulp, the error is below 2^-53, or 2^-53 ln(x) for large
 * x. */
COR_INLINE struct cor_inline_pair cor_inline_log(double x)
{
    /* ln(2) in two parts; the first has 42 bits, so that its products with exponents are exact */
    const double ln2_hi = 0.69314718055989033, ln2_lo = 5.4979230187083712e-14;
    /* significands above sqrt(2) are halved, so that |ln(m)| < 0.35: error 2^-54 */
    const double half = cor_inline_significand(x);
    const int up = half > 1.4142135623730951, e = cor_inline_exponent(x) + up;
    return cor_inline_sum(e * ln2_hi, e * ln2_lo + log(up ? half * 0.5 : half));
}

#endif
