/* SPDX-License-Identifier: MIT */
#include "runtime/sphere/array.h"

#include "cor/sphere.h"
#include "runtime/number/environment.h"
#include "runtime/sphere/float_exceptions.h"

static const struct cor_array_set *widest(void)
{
    return cor_array_set(cor_widest_set());
}

/* The loops compute both sides of a condition and select one. The unused side may raise exceptions, which the
 * environment hides. */
#define SPHERE_ARRAY(quantity)                                                                                         \
    void cor_sphere_##quantity##_array(const double *x, double *y, size_t n)                                           \
    {                                                                                                                  \
        const struct cor_environment caller = cor_environment_enter();                                                 \
        widest()->sphere_##quantity(x, y, n);                                                                          \
        cor_environment_leave(&caller);                                                                                \
    }
#define CONTACT_ARRAY(quantity)                                                                                        \
    void cor_contact_##quantity##_array(const struct cor_sphere_contact *contact, const double *speed_m_s, double *y,  \
                                        size_t n)                                                                      \
    {                                                                                                                  \
        const struct cor_environment caller = cor_environment_enter();                                                 \
        widest()->contact_##quantity(contact, speed_m_s, y, n);                                                        \
        cor_environment_leave(&caller);                                                                                \
    }
#define DISSIPATION_ARRAY(quantity)                                                                                    \
    void cor_contact_##quantity##_array(const struct cor_sphere_contact *contact, const double *speed_m_s,             \
                                        const double *eps, double *y, size_t n)                                        \
    {                                                                                                                  \
        const struct cor_environment caller = cor_environment_enter();                                                 \
        widest()->contact_##quantity(contact, speed_m_s, eps, y, n);                                                   \
        cor_environment_leave(&caller);                                                                                \
    }
COR_SPHERE_QUANTITIES(SPHERE_ARRAY)
COR_CONTACT_QUANTITIES(CONTACT_ARRAY)
COR_DISSIPATION_QUANTITIES(DISSIPATION_ARRAY)

/* Float arrays call the double functions, so that each result is rounded once, but for the exceptions. */
static void rounded_once(cor_sphere_array *function, struct cor_float_exception exception, const float *x, float *y,
                         size_t n)
{
    enum { CHUNK = 512 };
    double wide[CHUNK];
    for (size_t i = 0; i < n; i += CHUNK) {
        const size_t m = n - i < CHUNK ? n - i : CHUNK;
        for (size_t j = 0; j < m; j++)
            wide[j] = (double)x[i + j];
        function(wide, wide, m);
        for (size_t j = 0; j < m; j++)
            y[i + j] = cor_float_corrected(exception, x[i + j], (float)wide[j]);
    }
}

#define SPHERE_ARRAYF(quantity)                                                                                        \
    void cor_sphere_##quantity##_arrayf(const float *x, float *y, size_t n)                                            \
    {                                                                                                                  \
        static const struct cor_float_exception exception = COR_FLOAT_EXCEPTION_##quantity;                            \
        const struct cor_environment caller = cor_environment_enter();                                                 \
        rounded_once(widest()->sphere_##quantity, exception, x, y, n);                                                 \
        cor_environment_leave(&caller);                                                                                \
    }
COR_SPHERE_QUANTITIES(SPHERE_ARRAYF)

#define SPHERE_FAST_ARRAYF(quantity)                                                                                   \
    void cor_sphere_##quantity##_fast_arrayf(const float *x, float *y, size_t n)                                       \
    {                                                                                                                  \
        const struct cor_environment caller = cor_environment_enter();                                                 \
        widest()->float_##quantity(x, y, n);                                                                           \
        cor_environment_leave(&caller);                                                                                \
    }
COR_FLOAT_QUANTITIES(SPHERE_FAST_ARRAYF)
