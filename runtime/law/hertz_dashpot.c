/* SPDX-License-Identifier: MIT */
#include "cor/hertz_dashpot.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* If one function of the evaluator stays a call, the constants of the law are copied, which takes five times as
 * long. */
#ifdef __GNUC__
#define COR_INLINE static inline __attribute__((always_inline))
#endif

#include "generated/hertz_dashpot_tables.h"

/* A function of hertz_dashpot.h and its array forms, which compute one number after the other */
#define HERTZ_DASHPOT_FUNCTION(quantity)                                                                               \
    double cor_hertz_dashpot_##quantity(double x)                                                                      \
    {                                                                                                                  \
        return cor_inline_hertz_dashpot_##quantity(x);                                                                 \
    }                                                                                                                  \
    float cor_hertz_dashpot_##quantity##f(float x)                                                                     \
    {                                                                                                                  \
        return (float)cor_hertz_dashpot_##quantity((double)x);                                                         \
    }                                                                                                                  \
    void cor_hertz_dashpot_##quantity##_array(const double *x, double *y, size_t n)                                    \
    {                                                                                                                  \
        for (size_t i = 0; i < n; i++)                                                                                 \
            y[i] = cor_hertz_dashpot_##quantity(x[i]);                                                                 \
    }                                                                                                                  \
    void cor_hertz_dashpot_##quantity##_arrayf(const float *x, float *y, size_t n)                                     \
    {                                                                                                                  \
        for (size_t i = 0; i < n; i++)                                                                                 \
            y[i] = cor_hertz_dashpot_##quantity##f(x[i]);                                                              \
    }

HERTZ_DASHPOT_FUNCTION(eps_zero_overlap)
HERTZ_DASHPOT_FUNCTION(eps_zero_force)
HERTZ_DASHPOT_FUNCTION(loss_zero_overlap)
HERTZ_DASHPOT_FUNCTION(loss_zero_force)
HERTZ_DASHPOT_FUNCTION(beta_zero_overlap)
HERTZ_DASHPOT_FUNCTION(beta_zero_force)
HERTZ_DASHPOT_FUNCTION(beta_of_loss_zero_overlap)
HERTZ_DASHPOT_FUNCTION(beta_of_loss_zero_force)
HERTZ_DASHPOT_FUNCTION(duration_zero_overlap)
HERTZ_DASHPOT_FUNCTION(duration_zero_force)
HERTZ_DASHPOT_FUNCTION(max_overlap)
HERTZ_DASHPOT_FUNCTION(time_of_max_overlap)
