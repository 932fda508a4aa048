/* SPDX-License-Identifier: MIT */
/* Parts common to the functions of law.h: each law's part of the table, and the evaluation at any argument. */
#ifndef COR_RUNTIME_LAW_FUNCTIONS_H
#define COR_RUNTIME_LAW_FUNCTIONS_H

#include "cor/law.h"
#include "runtime/number/environment.h"
#include "runtime/number/pair.h"
#include "runtime/number/sets.h"

/* The functions of a law by end of contact; `value` is NULL where a function does not exist. */
typedef struct cor_law_function cor_law_functions[COR_END_APPROACH_ONLY + 1][COR_QUANTITIES];
/* The laws that have functions: row(ENUMERATOR, array) */
#define COR_LAWS_WITH_FUNCTIONS(row)                                                                                   \
    row(VISCOELASTIC, cor_viscoelastic_functions) row(LINEAR, cor_linear_functions) row(TSUJI, cor_tsuji_functions)    \
        row(HUNT_CROSSLEY, cor_hunt_crossley_functions) row(HERTZ_DASHPOT, cor_hertz_dashpot_functions)
#define COR_DECLARE_FUNCTIONS(law, array) extern const cor_law_functions array;
COR_LAWS_WITH_FUNCTIONS(COR_DECLARE_FUNCTIONS)

/* A row of the table, made from a function and its array function. The row has no function of floats. */
#define COR_LAW_ROW(name, function, least, largest, max_ulp)                                                           \
    {                                                                                                                  \
        name, function, function##_array, NULL, least, largest, max_ulp                                                \
    }

/* True if 2^-900 <= |x| < 2^900. For such numbers no function raises an exception except underflow and inexact; other
 * numbers are computed in the default environment. */
static inline int law_is_ordinary(double x)
{
    return cor_inline_between(cor_inline_from_bits(cor_inline_bits(x) & ~COR_INLINE_SIGN_BIT), COR_INLINE_2_M900,
                              COR_INLINE_2_900);
}

static inline double law_value(double (*formula)(double), double x)
{
    return law_is_ordinary(x) ? formula(x) : cor_in_environment(formula, x);
}

struct law_of_exponent {
    double (*formula)(double beta, double exponent);
    double exponent;
};

static inline double law_at_exponent(const void *law, double beta)
{
    const struct law_of_exponent *const of = law;
    return of->formula(beta, of->exponent);
}

static inline double law_value_of_exponent(double (*formula)(double, double), double beta, double exponent)
{
    const struct law_of_exponent law = {formula, exponent};
    return law_is_ordinary(beta) && law_is_ordinary(exponent) ? formula(beta, exponent)
                                                              : cor_in_environment_with(law_at_exponent, &law, beta);
}

/* Sets y[i] to formula(beta[i], exponent) like cor_array_in_environment. */
static inline void law_array_of_exponent(double (*formula)(double, double), const double *beta, double exponent,
                                         double *y, size_t n)
{
    const struct cor_environment caller = cor_environment_enter();
    const double *const volatile pointer = beta;
    const double *const in = pointer;
    for (size_t i = 0; i < n; i++)
        y[i] = formula(in[i], exponent);
    cor_environment_leave(&caller);
}

/* Loops of formulas without rows, for one instruction set (array_kernel.c); `one` is the scalar function. */
enum cor_law_loop { COR_LINEAR_DURATION_ZERO_OVERLAP, COR_LINEAR_DURATION_ZERO_FORCE, COR_LINEAR_TIME_OF_MAX_OVERLAP };
struct cor_law_loops {
    void (*run)(enum cor_law_loop loop, double (*one)(double), const double *x, double *y, size_t n);
};
COR_TABLES(struct cor_law_loops, cor_law_loops, cor_law_loops)

#endif
