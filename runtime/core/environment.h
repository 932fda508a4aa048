/* SPDX-License-Identifier: MIT */
/* The floating-point environment of the caller, put aside: rounding to nearest, no traps, subnormal numbers kept. What
 * runs in between gives the same bits in whatever mode the caller is, and leaves no exception and no errno behind.
 *
 *     const struct cor_environment caller = cor_environment_enter();
 *     ... a call that a compiler cannot look into, or operands and results in volatile variables ...
 *     cor_environment_leave(&caller);
 *
 * Compilers move arithmetic across the two calls, for they do not know that it depends on them. */
#ifndef COR_RUNTIME_ENVIRONMENT_H
#define COR_RUNTIME_ENVIRONMENT_H

#include <errno.h>

#if defined(__SSE2__) && defined(__GNUC__)
#include <xmmintrin.h>

struct cor_environment {
    unsigned control;
    int error;
};

static inline struct cor_environment cor_environment_enter(void)
{
    /* exceptions masked, nearest, no flushing to zero; the low six bits are exceptions raised so far */
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

#endif
