/* SPDX-License-Identifier: MIT */
/* Saves the caller's floating-point environment and sets the default: rounding to nearest, no traps, no flushing of
 * subnormal numbers. Code between the two calls gives the same bits in every mode of the caller. It changes neither the
 * caller's exceptions nor errno.
 *
 *     const struct cor_environment caller = cor_environment_enter();
 *     ... a call that a compiler cannot look into, or operands and results in volatile variables ...
 *     cor_environment_leave(&caller);
 *
 * Compilers move arithmetic across the two calls, because they do not know that it depends on the environment. */
#ifndef COR_RUNTIME_ENVIRONMENT_H
#define COR_RUNTIME_ENVIRONMENT_H

#include <errno.h>
#include <stddef.h>

/* On 32 bits the C library computes in x87, which has its own control register. fenv.h sets both registers. */
#if defined(__x86_64__) && defined(__GNUC__)
#include <xmmintrin.h>

struct cor_environment {
    unsigned control;
    int error;
};

static inline struct cor_environment cor_environment_enter(void)
{
    /* all exceptions masked, rounding to nearest, no flushing to zero; the low six bits record the raised exceptions */
    const unsigned ordinary = 0x1f80, raised = 0x3f;
    const struct cor_environment caller = {_mm_getcsr(), errno};
    if ((caller.control & ~raised) != ordinary)
        _mm_setcsr(ordinary);
    return caller;
}

static inline void cor_environment_leave(const struct cor_environment *caller)
{
    if (_mm_getcsr() != caller->control)
        _mm_setcsr(caller->control);
    errno = caller->error;
}
#else
#include <fenv.h>

struct cor_environment {
    fenv_t state;
    int error;
};

static inline struct cor_environment cor_environment_enter(void)
{
    struct cor_environment caller;
    caller.error = errno;
    fegetenv(&caller.state);
    fesetenv(FE_DFL_ENV);
    return caller;
}

static inline void cor_environment_leave(const struct cor_environment *caller)
{
    fesetenv(&caller->state);
    errno = caller->error;
}
#endif

/* Returns function(x) in the default environment. The pointer is volatile, so that no compiler inlines the function. */
static inline double cor_in_environment(double (*function)(double), double x)
{
    double (*const volatile in_environment)(double) = function;
    const struct cor_environment caller = cor_environment_enter();
    const volatile double value = in_environment(x);
    cor_environment_leave(&caller);
    return value;
}

/* Returns function(context, x) in the default environment. */
static inline double cor_in_environment_with(double (*function)(const void *context, double x), const void *context,
                                             double x)
{
    double (*const volatile in_environment)(const void *, double) = function;
    const struct cor_environment caller = cor_environment_enter();
    const volatile double value = in_environment(context, x);
    cor_environment_leave(&caller);
    return value;
}

/* Sets y[i] to formula(x[i]) in the default environment. A volatile pointer keeps the reads of x after
 * cor_environment_enter. */
static inline void cor_array_in_environment(double (*formula)(double), const double *x, double *y, size_t n)
{
    const struct cor_environment caller = cor_environment_enter();
    const double *const volatile pointer = x;
    const double *const in = pointer;
    for (size_t i = 0; i < n; i++)
        y[i] = formula(in[i]);
    cor_environment_leave(&caller);
}

#endif
