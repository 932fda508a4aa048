/* SPDX-License-Identifier: MIT */
/* Errors in units of the last place of a format, subnormal and overflowing results included. */
#ifndef COR_TESTS_ACCURACY_ULP_H
#define COR_TESTS_ACCURACY_ULP_H

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

struct format {
    int digits, min_exponent, max_exponent;
};

static const struct format format_double = {DBL_MANT_DIG, DBL_MIN_EXP, DBL_MAX_EXP};
static const struct format format_float = {FLT_MANT_DIG, FLT_MIN_EXP, FLT_MAX_EXP};

static inline long double ulp_size(long double exact, struct format format)
{
    int exponent;
    frexpl(exact, &exponent);
    if (exponent < format.min_exponent)
        exponent = format.min_exponent;
    return ldexpl(1, exponent - format.digits);
}

/* Infinity counts as the first number beyond the largest one. A NaN where there is a number is infinitely wrong. */
static inline double ulp_error(double computed, long double exact, struct format format)
{
    if (isnan(computed))
        return isnan(exact) ? 0 : HUGE_VAL;
    if (isinf(exact))
        return (long double)computed == exact ? 0 : HUGE_VAL;
    const long double first_beyond = ldexpl(1, format.max_exponent);
    if (exact > first_beyond)
        exact = first_beyond;
    const long double value = computed > 0 && isinf(computed) ? first_beyond : (long double)computed;
    return (double)(fabsl(value - exact) / ulp_size(fminl(exact, first_beyond / 2), format));
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

static inline int same_bits(const void *x, const void *y, size_t size)
{
    return memcmp(x, y, size) == 0;
}

#endif
