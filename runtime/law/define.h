/* SPDX-License-Identifier: MIT */
/* Macros that define the four public forms of a function of law.h from the inline function. */
#ifndef COR_RUNTIME_LAW_DEFINE_H
#define COR_RUNTIME_LAW_DEFINE_H

#include "runtime/law/array.h"

/* Float arrays call the double loop, so that each result is rounded once. */
static inline void law_arrayf(cor_law_array_function *loop, const float *x, float *y, size_t n)
{
    enum { CHUNK = 512 };
    double wide[CHUNK];
    for (size_t i = 0; i < n; i += CHUNK) {
        const size_t m = n - i < CHUNK ? n - i : CHUNK;
        for (size_t j = 0; j < m; j++)
            wide[j] = (double)x[i + j];
        loop(wide, wide, m);
        for (size_t j = 0; j < m; j++)
            y[i + j] = (float)wide[j];
    }
}

/* Defines cor_<function> from the inline function `name`, which is a row of COR_LAW_LOOPS. */
#define LAW_DEFINE(function, name)                                                                                     \
    double cor_##function(double x)                                                                                    \
    {                                                                                                                  \
        return cor_##name(x);                                                                                          \
    }                                                                                                                  \
    float cor_##function##f(float x)                                                                                   \
    {                                                                                                                  \
        return (float)cor_##name((double)x);                                                                           \
    }                                                                                                                  \
    void cor_##function##_array(const double *x, double *y, size_t n)                                                  \
    {                                                                                                                  \
        cor_law_best_loops()[COR_LAW_##name](x, y, n);                                                                 \
    }                                                                                                                  \
    void cor_##function##_arrayf(const float *x, float *y, size_t n)                                                   \
    {                                                                                                                  \
        law_arrayf(cor_law_best_loops()[COR_LAW_##name], x, y, n);                                                     \
    }

/* The same without a loop of its own: array functions compute one number after the other. */
#define LAW_DEFINE_ONE_BY_ONE(function, name)                                                                          \
    double cor_##function(double x)                                                                                    \
    {                                                                                                                  \
        return cor_##name(x);                                                                                          \
    }                                                                                                                  \
    float cor_##function##f(float x)                                                                                   \
    {                                                                                                                  \
        return (float)cor_##name((double)x);                                                                           \
    }                                                                                                                  \
    void cor_##function##_array(const double *x, double *y, size_t n)                                                  \
    {                                                                                                                  \
        for (size_t i = 0; i < n; i++)                                                                                 \
            y[i] = cor_##name(x[i]);                                                                                   \
    }                                                                                                                  \
    void cor_##function##_arrayf(const float *x, float *y, size_t n)                                                   \
    {                                                                                                                  \
        for (size_t i = 0; i < n; i++)                                                                                 \
            y[i] = (float)cor_##name((double)x[i]);                                                                    \
    }

/* The same for a function of beta and the elastic exponent a */
#define LAW_DEFINE_WITH_EXPONENT(function, name)                                                                       \
    double cor_##function(double beta, double elastic_exponent)                                                        \
    {                                                                                                                  \
        return cor_##name(beta, elastic_exponent);                                                                     \
    }                                                                                                                  \
    float cor_##function##f(float beta, float elastic_exponent)                                                        \
    {                                                                                                                  \
        return (float)cor_##name((double)beta, (double)elastic_exponent);                                              \
    }                                                                                                                  \
    void cor_##function##_array(const double *beta, double elastic_exponent, double *y, size_t n)                      \
    {                                                                                                                  \
        for (size_t i = 0; i < n; i++)                                                                                 \
            y[i] = cor_##name(beta[i], elastic_exponent);                                                              \
    }                                                                                                                  \
    void cor_##function##_arrayf(const float *beta, float elastic_exponent, float *y, size_t n)                        \
    {                                                                                                                  \
        for (size_t i = 0; i < n; i++)                                                                                 \
            y[i] = (float)cor_##name((double)beta[i], (double)elastic_exponent);                                       \
    }

#endif
