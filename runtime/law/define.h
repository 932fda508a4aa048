/* SPDX-License-Identifier: MIT */
/* Macros that define the four public forms of a function of law.h from the inline function. */
#ifndef COR_RUNTIME_LAW_DEFINE_H
#define COR_RUNTIME_LAW_DEFINE_H

#include "runtime/law/array.h"
#include "runtime/number/environment.h"

/* Whether 2^-900 <= |x| < 2^900. For such numbers no function raises an exception but underflow and inexact; for the
 * others it is computed in the default environment. */
static inline int law_is_ordinary(double x)
{
    return cor_inline_between(cor_inline_from_bits(cor_inline_bits(x) & ~COR_INLINE_SIGN_BIT), COR_INLINE_2_M900,
                              COR_INLINE_2_900);
}

/* cor_<function> and its float form from the inline function `name` */
#define LAW_SCALARS_(function, name)                                                                                   \
    static COR_IN_ENVIRONMENT(double, anywhere_##function, cor_##name, (double x),                                     \
                              (x)) double cor_##function(double x)                                                     \
    {                                                                                                                  \
        return law_is_ordinary(x) ? cor_##name(x) : anywhere_##function(x);                                            \
    }                                                                                                                  \
    float cor_##function##f(float x)                                                                                   \
    {                                                                                                                  \
        return cor_inline_narrow(cor_##function((double)x));                                                           \
    }

/* Defines cor_<function> from the inline function `name`, which has a loop in array.h. */
#define LAW_DEFINE(function, name)                                                                                     \
    LAW_SCALARS_(function, name)                                                                                       \
    void cor_##function##_array(const double *x, double *y, size_t n)                                                  \
    {                                                                                                                  \
        cor_law_array_of_set(cor_widest_set(), COR_LAW_##name, x, y, n);                                               \
    }                                                                                                                  \
    void cor_##function##_arrayf(const float *x, float *y, size_t n)                                                   \
    {                                                                                                                  \
        cor_law_arrayf_of_set(cor_widest_set(), COR_LAW_##name, x, y, n);                                              \
    }

/* The same without a loop of its own: array functions compute one number after the other. */
#define LAW_DEFINE_ONE_BY_ONE(function, name)                                                                          \
    static float narrow_##function(float x)                                                                            \
    {                                                                                                                  \
        return (float)cor_##name((double)x);                                                                           \
    }                                                                                                                  \
    LAW_SCALARS_(function, name)                                                                                       \
    COR_ARRAY_IN_ENVIRONMENT(double, cor_##function##_array, cor_##name)                                               \
    COR_ARRAY_IN_ENVIRONMENT(float, cor_##function##_arrayf, narrow_##function)

/* The same for a function of beta and the elastic exponent a */
#define LAW_ARRAY_WITH_EXPONENT_(type, array, name)                                                                    \
    static void one_by_one_##array(const type *beta, type elastic_exponent, type *y, size_t n)                         \
    {                                                                                                                  \
        for (size_t i = 0; i < n; i++)                                                                                 \
            y[i] = (type)cor_##name((double)beta[i], (double)elastic_exponent);                                        \
    }                                                                                                                  \
    COR_RUN_IN_ENVIRONMENT(array, one_by_one_##array, (const type *beta, type elastic_exponent, type *y, size_t n),    \
                           (beta, elastic_exponent, y, n))
#define LAW_DEFINE_WITH_EXPONENT(function, name)                                                                       \
    static COR_IN_ENVIRONMENT(double, anywhere_##function, cor_##name, (double beta, double elastic_exponent),         \
                              (beta, elastic_exponent)) double cor_##function(double beta, double elastic_exponent)    \
    {                                                                                                                  \
        return law_is_ordinary(beta) && law_is_ordinary(elastic_exponent)                                              \
                   ? cor_##name(beta, elastic_exponent)                                                                \
                   : anywhere_##function(beta, elastic_exponent);                                                      \
    }                                                                                                                  \
    static float narrow_##function(float beta, float elastic_exponent)                                                 \
    {                                                                                                                  \
        return (float)cor_##name((double)beta, (double)elastic_exponent);                                              \
    }                                                                                                                  \
    COR_IN_ENVIRONMENT(float, cor_##function##f, narrow_##function, (float beta, float elastic_exponent),              \
                       (beta, elastic_exponent))                                                                       \
    LAW_ARRAY_WITH_EXPONENT_(double, cor_##function##_array, name)                                                     \
    LAW_ARRAY_WITH_EXPONENT_(float, cor_##function##_arrayf, name)

#endif
