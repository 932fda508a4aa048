/* SPDX-License-Identifier: MIT */
#include "runtime/sphere/array.h"

#include "cor/sphere.h"
#include "runtime/sphere/eval.h"

#define ARRAY_ROW(set)                                                                                                 \
    {#set, cor_array_eps_zero_overlap_##set, cor_array_eps_zero_force_##set, cor_array_speed_zero_overlap_##set,       \
     cor_array_speed_zero_force_##set},

const struct cor_array_set *cor_array_set(int i)
{
    static const struct cor_array_set sets[] = {COR_EACH_SET(ARRAY_ROW)};
    return cor_processor_has(i) ? &sets[i] : NULL;
}

const struct cor_array_set *cor_array_best_set(void)
{
    return cor_array_set(cor_widest_set());
}

void cor_sphere_eps_zero_overlap_array(const double *beta, double *eps, size_t n)
{
    cor_array_best_set()->eps_zero_overlap(NULL, beta, eps, n);
}

void cor_sphere_eps_zero_force_array(const double *beta, double *eps, size_t n)
{
    cor_array_best_set()->eps_zero_force(NULL, beta, eps, n);
}

void cor_contact_eps_zero_overlap_array(const struct cor_sphere_contact *contact, const double *speed_m_s, double *eps,
                                        size_t n)
{
    cor_array_best_set()->speed_zero_overlap(contact, speed_m_s, eps, n);
}

void cor_contact_eps_zero_force_array(const struct cor_sphere_contact *contact, const double *speed_m_s, double *eps,
                                      size_t n)
{
    cor_array_best_set()->speed_zero_force(contact, speed_m_s, eps, n);
}

/* Floats go through the double arrays, so that they are rounded once. */
static void eps_arrayf(cor_array_function *function, const float *beta, float *eps, size_t n)
{
    enum { CHUNK = 512 };
    double wide[CHUNK];
    for (size_t i = 0; i < n; i += CHUNK) {
        const size_t m = n - i < CHUNK ? n - i : CHUNK;
        for (size_t j = 0; j < m; j++)
            wide[j] = (double)beta[i + j];
        function(NULL, wide, wide, m);
        for (size_t j = 0; j < m; j++)
            eps[i + j] = (float)wide[j];
    }
}

void cor_sphere_eps_zero_overlap_arrayf(const float *beta, float *eps, size_t n)
{
    eps_arrayf(cor_array_best_set()->eps_zero_overlap, beta, eps, n);
}

void cor_sphere_eps_zero_force_arrayf(const float *beta, float *eps, size_t n)
{
    eps_arrayf(cor_array_best_set()->eps_zero_force, beta, eps, n);
}

/* The others: one number after the other. */
#define ARRAY_FUNCTION(quantity)                                                                                       \
    void cor_sphere_##quantity##_array(const double *x, double *y, size_t n)                                           \
    {                                                                                                                  \
        for (size_t i = 0; i < n; i++)                                                                                 \
            y[i] = cor_inline_##quantity(x[i]);                                                                        \
    }                                                                                                                  \
    void cor_sphere_##quantity##_arrayf(const float *x, float *y, size_t n)                                            \
    {                                                                                                                  \
        for (size_t i = 0; i < n; i++)                                                                                 \
            y[i] = (float)cor_inline_##quantity((double)x[i]);                                                         \
    }

ARRAY_FUNCTION(loss_zero_overlap)
ARRAY_FUNCTION(loss_zero_force)
ARRAY_FUNCTION(beta_zero_overlap)
ARRAY_FUNCTION(beta_zero_force)
ARRAY_FUNCTION(duration_zero_overlap)
ARRAY_FUNCTION(duration_zero_force)
ARRAY_FUNCTION(max_overlap)
ARRAY_FUNCTION(time_of_max_overlap)
