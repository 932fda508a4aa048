/* SPDX-License-Identifier: MIT */
/* Arguments x at which the float nearest to the double result is not the float y nearest to the function: the function
 * lies within 1/2 ulp of a double of the middle of two floats there. tests/accuracy/test_floats.c finds them. A
 * function without such an argument has NaN, which equals no argument. second_x is not in the function's table, so that
 * loops over rows watch for x alone. */
#ifndef COR_RUNTIME_SPHERE_FLOAT_EXCEPTIONS_H
#define COR_RUNTIME_SPHERE_FLOAT_EXCEPTIONS_H

#include <math.h>

struct cor_float_exception {
    float x, y, second_x, second_y;
};

#define COR_FLOAT_AT(x, y, second_x, second_y)                                                                         \
    {                                                                                                                  \
        x, y, second_x, second_y                                                                                       \
    }
#define COR_FLOAT_REGULAR COR_FLOAT_AT(NAN, NAN, NAN, NAN)
#define COR_FLOAT_EXCEPTION_eps_zero_overlap COR_FLOAT_REGULAR
#define COR_FLOAT_EXCEPTION_eps_zero_force COR_FLOAT_REGULAR
#define COR_FLOAT_EXCEPTION_loss_zero_overlap COR_FLOAT_REGULAR
#define COR_FLOAT_EXCEPTION_loss_zero_force COR_FLOAT_REGULAR
#define COR_FLOAT_EXCEPTION_beta_zero_overlap COR_FLOAT_REGULAR
#define COR_FLOAT_EXCEPTION_beta_zero_force COR_FLOAT_AT(0x1.c37b7p-13f, 0x1.74754ap+7f, NAN, NAN)
#define COR_FLOAT_EXCEPTION_duration_zero_overlap COR_FLOAT_AT(0x1.073138p-6f, 0x1.9caebap+1f, NAN, NAN)
#define COR_FLOAT_EXCEPTION_duration_zero_force COR_FLOAT_AT(0x1.2703aep+95f, 0x1.1646f6p-56f, NAN, NAN)
#define COR_FLOAT_EXCEPTION_max_overlap COR_FLOAT_REGULAR
#define COR_FLOAT_EXCEPTION_time_of_max_overlap                                                                        \
    COR_FLOAT_AT(0x1.511e64p-14f, 0x1.9be80ep+0f, 0x1.5b5bb8p+22f, 0x1.7b3fe6p-11f)

#define COR_FLOAT_EXCEPTION_eps_approach_only COR_FLOAT_REGULAR
#define COR_FLOAT_EXCEPTION_loss_approach_only                                                                         \
    COR_FLOAT_AT(0x1.47e06ep+16f, 0x1.fff30ap-1f, 0x1.4fe17ep+30f, 0x1.fffffep-1f)
#define COR_FLOAT_EXCEPTION_beta_approach_only                                                                         \
    COR_FLOAT_AT(0x1.fefc3ap-23f, 0x1.bc40f6p+26f, 0x1.d76bf4p-14f, 0x1.191072p+16f)
#define COR_FLOAT_EXCEPTION_beta_of_loss_approach_only COR_FLOAT_REGULAR
#define COR_FLOAT_EXCEPTION_duration_approach_only COR_FLOAT_REGULAR

/* The result at x, whose double result rounds to y */
static inline float cor_float_corrected(struct cor_float_exception exception, float x, float y)
{
    return x == exception.x ? exception.y : x == exception.second_x ? exception.second_y : y;
}

/* Defines cor_sphere_<quantity> and its float form from a function of doubles; `narrow` rounds a double to a float. */
#define COR_SPHERE_SCALARS(quantity, function, narrow)                                                                 \
    double cor_sphere_##quantity(double x)                                                                             \
    {                                                                                                                  \
        return function(x);                                                                                            \
    }                                                                                                                  \
    float cor_sphere_##quantity##f(float x)                                                                            \
    {                                                                                                                  \
        static const struct cor_float_exception exception = COR_FLOAT_EXCEPTION_##quantity;                            \
        return cor_float_corrected(exception, x, narrow(function((double)x)));                                         \
    }

#endif
