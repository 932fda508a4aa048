/* SPDX-License-Identifier: MIT */
/* The range of numbers in SI units, and arithmetic that gives NaN beyond it without an exception */
#ifndef COR_RUNTIME_SI_RANGE_H
#define COR_RUNTIME_SI_RANGE_H

#include <stdlib.h>

#include "cor/contact.h"
#include "runtime/number/pair.h"

COR_INLINE int cor_si_in_range(double x)
{
    return cor_inline_between(x, COR_SI_LEAST, COR_SI_MOST);
}

/* True if x == INFINITY. Clang would compare with >= instead, which raises FE_INVALID for a NaN. */
COR_INLINE int cor_is_infinity(double x)
{
    return cor_inline_bits(x) == COR_INLINE_INFINITY_BITS;
}

/* Return x y, x/y and x 2^k of positive numbers, or NaN outside 2^-831 to 2^831, about the range of SI numbers. */
COR_INLINE double cor_si_product(double x, double y)
{
    return abs(cor_inline_exponent(x) + cor_inline_exponent(y)) < 831 ? x * y : cor_inline_nan();
}

COR_INLINE double cor_si_quotient(double x, double y)
{
    return y != 0 && abs(cor_inline_exponent(x) - cor_inline_exponent(y)) < 831 ? x / y : cor_inline_nan();
}

COR_INLINE double cor_si_scaled(double x, int k)
{
    return abs(cor_inline_exponent(x) + k) < 831 ? cor_inline_scaled(x, k) : cor_inline_nan();
}

/* Compute with nonnegative numbers as IEEE 754 does, except that a result above 2^1022 may be infinite. They raise only
 * underflow and inexact, and do not set errno. */
COR_INLINE double cor_quiet_product(double x, double y)
{
    if (x == 0 || y == 0)
        return cor_inline_is_finite(x) && cor_inline_is_finite(y) ? 0 : cor_inline_nan();
    const int overflows = cor_inline_exponent(x) + cor_inline_exponent(y) > 1022;
    return overflows ? x + y + cor_inline_infinity() : x * y; /* NaN remains */
}

COR_INLINE double cor_quiet_quotient(double x, double y)
{
    if (y == 0 || cor_is_infinity(y))
        return x == y ? cor_inline_nan() : y == 0 ? x + cor_inline_infinity() : cor_quiet_product(x, 0);
    if (cor_inline_exponent(y) == -1023) /* subnormal */
        return cor_quiet_product(cor_quiet_quotient(x, y * 0x1p100), 0x1p100);
    const int overflows = cor_inline_exponent(x) - cor_inline_exponent(y) > 1022;
    return overflows ? x + y + cor_inline_infinity() : x / y;
}

/* Returns pow(x, y), but 0 below 2^-1020, and NaN where y is NaN or x < 0. */
COR_INLINE double cor_quiet_power(double x, double y)
{
    if (cor_inline_is_refused(x) || isnan(y) || y == 0)
        return y == 0 ? 1 : cor_inline_nan();
    if (x == 0 || cor_is_infinity(x))
        return (x == 0) == (y > 0) ? 0 : cor_inline_infinity();
    if (fabs(y) * (abs(cor_inline_exponent(x)) + 1) > 1020) {
        const double power = y * log2(x);
        if (fabs(power) > 1020)
            return power < 0 ? 0 : cor_inline_infinity();
    }
    return pow(x, y);
}

#endif
