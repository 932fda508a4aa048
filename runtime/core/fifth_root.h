/* SPDX-License-Identifier: MIT */
/* x^(1/5) without pow, branches or table, so that a loop over it vectorises. */
#ifndef COR_RUNTIME_FIFTH_ROOT_H
#define COR_RUNTIME_FIFTH_ROOT_H

#include "runtime/core/exact.h"

/* x^(1/5) = head + tail for 2^-1000 <= x <= 2^1000; the head has 26 bits, |tail/head| < 2^-12. Relative error of the
 * sum, before it is rounded: 0.5 2^-53, measured in tests/unit/test_fifth_root.c. */
COR_INLINE struct cor_inline_pair cor_inline_fifth_root_parts(double x)
{
    /* A fifth of the exponent and of the fraction, taken from the bits as one whole number: within 3.4 %.
     * 2^52 + n as a double holds the whole number n in its low bits. */
    const double two52 = 4503599627370496.0;
    const uint64_t top = (cor_inline_bits(x) >> 32) | UINT64_C(0x4330000000000000);
    const double fifth = cor_inline_from_bits(top) * 0.2 + (0.8 * two52 + 858116000.0);
    const double seed = cor_inline_from_bits(cor_inline_bits(fifth) << 32);

    /* Halley's step for r^5 = x: the relative error becomes twice its cube, 8e-5. */
    const double seed2 = seed * seed, seed5 = seed2 * seed2 * seed;
    const double halley = seed + seed * ((x - seed5) / (2 * x + 3 * seed5));

    /* Cut to 26 bits, r^2 is exact, and r^5 is off by two roundings, of which a fifth reaches the root. x - r^5 is
     * exact. */
    const double r = cor_inline_head(halley), r2 = r * r, r5 = COR_INLINE_KEEP(r2 * r2 * r);
    const double d = (x - r5) / r5;
    /* (1 + d)^(1/5) - 1 up to d^4; |d| < 4e-4, and the next term is below 2^-59. */
    struct cor_inline_pair root;
    root.hi = r;
    root.lo = r * (d * ((0.2 - 0.08 * d) + (d * d) * (0.048 - 0.0336 * d)));
    return root;
}

/* The same rounded: relative error 1.5 2^-53 */
COR_INLINE double cor_inline_fifth_root_normal(double x)
{
    const struct cor_inline_pair root = cor_inline_fifth_root_parts(x);
    return root.hi + root.lo;
}

/* Over the whole range: 0, +inf and NaN are returned as they are, and so are negative numbers. */
COR_INLINE double cor_inline_fifth_root(double x)
{
    /* the bits of a positive finite x are 1 to INFINITY_BITS - 1 */
    if (cor_inline_bits(x) - 1 >= COR_INLINE_INFINITY_BITS - 1)
        return x;
    if (x < COR_INLINE_2_M900)
        return cor_inline_fifth_root_normal(x * COR_INLINE_2_200) * COR_INLINE_2_M40;
    if (x > COR_INLINE_2_900)
        return cor_inline_fifth_root_normal(x * COR_INLINE_2_M200) * COR_INLINE_2_40;
    return cor_inline_fifth_root_normal(x);
}

#endif
