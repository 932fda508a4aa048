/* SPDX-License-Identifier: MIT */
#include "cor/sphere.h"
#include "runtime/sphere/eval.h"
#include "runtime/sphere/float_exceptions.h"

/* A function of sphere.h, for double and for float. `narrow` rounds a double to a float: NARROW_BOUNDED does for
 * functions that cannot exceed the largest float. */
#define NARROW_BOUNDED(x) ((float)(x))
#define SPHERE_FUNCTION(quantity, narrow)                                                                              \
    double cor_sphere_##quantity(double x)                                                                             \
    {                                                                                                                  \
        return cor_inline_##quantity(x);                                                                               \
    }                                                                                                                  \
    float cor_sphere_##quantity##f(float x)                                                                            \
    {                                                                                                                  \
        static const struct cor_float_exception exception = COR_FLOAT_EXCEPTION_##quantity;                            \
        return cor_float_corrected(exception, x, narrow(cor_inline_##quantity((double)x)));                            \
    }

SPHERE_FUNCTION(eps_zero_overlap, NARROW_BOUNDED)
SPHERE_FUNCTION(eps_zero_force, NARROW_BOUNDED)
SPHERE_FUNCTION(loss_zero_overlap, NARROW_BOUNDED)
SPHERE_FUNCTION(loss_zero_force, NARROW_BOUNDED)
SPHERE_FUNCTION(beta_zero_overlap, cor_inline_narrow)
SPHERE_FUNCTION(beta_zero_force, cor_inline_narrow)
SPHERE_FUNCTION(duration_zero_overlap, cor_inline_narrow)
SPHERE_FUNCTION(duration_zero_force, NARROW_BOUNDED)
SPHERE_FUNCTION(max_overlap, NARROW_BOUNDED)
SPHERE_FUNCTION(time_of_max_overlap, NARROW_BOUNDED)
