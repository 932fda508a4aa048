/* SPDX-License-Identifier: MIT */
/* Errors in units of the last place of a double, also for subnormal and overflowing results. */
#ifndef COR_TESTS_ULP_H
#define COR_TESTS_ULP_H

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

static inline long double ulp(long double exact)
{
    int exponent;
    frexpl(exact, &exponent);
    return ldexpl(1, (exponent < DBL_MIN_EXP ? DBL_MIN_EXP : exponent) - DBL_MANT_DIG);
}

/* Infinity counts as the first number above the largest. NaN in place of a number is infinitely wrong. */
static inline double ulp_error(double computed, long double exact)
{
    if (isnan(computed))
        return isnan(exact) ? 0 : HUGE_VAL;
    if (isinf(exact))
        return (long double)computed == exact ? 0 : HUGE_VAL;
    const long double first_beyond = ldexpl(1, DBL_MAX_EXP), limited = fminl(exact, first_beyond);
    const long double value = computed > 0 && isinf(computed) ? first_beyond : (long double)computed;
    return (double)(fabsl(value - limited) / ulp(fminl(exact, first_beyond / 2)));
}

static inline uint64_t bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline double double_of(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static inline float float_of(uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static inline int same_bits(double x, double y)
{
    return bits_of(x) == bits_of(y);
}

/* True if both have the same bits, or both are NaN. */
static inline int same_number(double x, double y)
{
    return same_bits(x, y) || (isnan(x) && isnan(y));
}

#endif
