/* SPDX-License-Identifier: MIT */
/* x^(1/5) without pow, branches or a table, so that compilers vectorise loops */
#ifndef COR_RUNTIME_FIFTH_ROOT_H
#define COR_RUNTIME_FIFTH_ROOT_H

#include "runtime/number/pair.h"

/* Returns (1 + d)^(1/5) - 1 up to d^4 for |d| < 4e-4. The next term is below 2^-59. */
COR_INLINE double cor_inline_fifth_root_rest(double d)
{
    return d * ((0.2 - 0.08 * d) + (d * d) * (0.048 - 0.0336 * d));
}

/* Returns x^(1/5) = head + tail for 2^-1000 <= x <= 2^1000. The head has 26 bits, |tail/head| < 2^-12. Relative error
 * of the sum, before it is rounded: 0.5 2^-53, measured in tests/unit/test_fifth_root.c. */
COR_INLINE struct cor_inline_pair cor_inline_fifth_root_parts(double x)
{
    /* The bits as one integer, divided by five, give a fifth of the exponent and of the fraction: the seed is within
     * 3.4 %. The double 2^52 + n holds the integer n in its low bits. */
    const double two52 = 4503599627370496.0;
    const uint64_t top = (cor_inline_bits(x) >> 32) | UINT64_C(0x4330000000000000);
    const double fifth = cor_inline_from_bits(top) * 0.2 + (0.8 * two52 + 858116000.0);
    const double seed = cor_inline_from_bits(cor_inline_bits(fifth) << 32);

    /* A step of Halley's method for r^5 = x turns the relative error e into 2 e^3, 8e-5 here. */
    const double seed2 = seed * seed, seed5 = seed2 * seed2 * seed;
    const double halley = seed + seed * COR_INLINE_KEEP((x - seed5) / (2 * x + 3 * seed5));

    /* With r cut to 26 bits, r^2 is exact, and r^5 has two rounding errors, of which a fifth reaches the root. x - r^5
     * is exact. */
    const double r = cor_inline_head(halley), r2 = r * r, r5 = COR_INLINE_KEEP(r2 * r2 * r);
    struct cor_inline_pair root;
    root.hi = r;
    root.lo = r * cor_inline_fifth_root_rest(COR_INLINE_KEEP((x - r5) / r5));
    return root;
}

/* Returns the fifth root of a pair. The relative error is below 2^-58, because r^5 and the difference are pairs too. */
COR_INLINE struct cor_inline_pair cor_inline_fifth_root_of_pair(struct cor_inline_pair x)
{
    struct cor_inline_pair root = cor_inline_fifth_root_parts(x.hi), r, r5;
    r.hi = root.hi;
    r.lo = 0;
    r5 = cor_inline_pair_times(cor_inline_product(r.hi * r.hi, r.hi * r.hi), r);
    const double d = (COR_INLINE_KEEP(COR_INLINE_KEEP(x.hi - r5.hi) - r5.lo) + x.lo) / r5.hi;
    root.lo = r.hi * cor_inline_fifth_root_rest(d);
    return root;
}

/* Returns the rounded fifth root, with relative error 1.5 2^-53. */
COR_INLINE double cor_inline_fifth_root_normal(double x)
{
    const struct cor_inline_pair root = cor_inline_fifth_root_parts(x);
    return root.hi + root.lo;
}

/* Returns the fifth root of any double. It returns 0, +inf, NaN and negative numbers unchanged. */
COR_INLINE double cor_inline_fifth_root(double x)
{
    /* the bits of a positive finite x are 1 to INFINITY_BITS - 1 */
    if (cor_inline_bits(x) - 1 >= COR_INLINE_INFINITY_BITS - 1)
        return x;
    if (x < COR_INLINE_2_M900)
        return cor_inline_fifth_root_normal(cor_inline_raised(x, COR_INLINE_2_200)) * COR_INLINE_2_M40;
    if (x > COR_INLINE_2_900)
        return cor_inline_fifth_root_normal(x * COR_INLINE_2_M200) * COR_INLINE_2_40;
    return cor_inline_fifth_root_normal(x);
}

#endif
