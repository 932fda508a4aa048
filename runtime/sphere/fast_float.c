/* SPDX-License-Identifier: MIT */
#include "runtime/sphere/fast_float.h"

#include "cor/sphere.h"
#include "runtime/number/environment.h"
#include "runtime/sphere/array.h"

#ifdef __AVX2__ /* a build for such a machine: one number in a vector */
#define ONE_FLOAT(table, x) _mm256_cvtss_f32(float_values(table, _mm256_set1_ps(x)))
#else
#define ONE_FLOAT(table, x) float_values(table, x)
#endif

#define SPHERE_FASTF(quantity)                                                                                         \
    float cor_sphere_##quantity##_fastf(float x)                                                                       \
    {                                                                                                                  \
        const struct float_table table = float_table_##quantity();                                                     \
        return float_is_outside(&table, x) ? cor_sphere_##quantity##f(x) : ONE_FLOAT(&table, x);                       \
    }                                                                                                                  \
    void cor_sphere_##quantity##_fast_arrayf(const float *x, float *y, size_t n)                                       \
    {                                                                                                                  \
        const struct float_table table = float_table_##quantity();                                                     \
        const struct cor_environment caller = cor_environment_enter();                                                 \
        cor_row_loops(cor_widest_set())->fast_floats(&table, cor_sphere_##quantity##f, x, y, n);                       \
        cor_environment_leave(&caller);                                                                                \
    }
COR_FLOAT_QUANTITIES(SPHERE_FASTF)
