/* SPDX-License-Identifier: MIT */
#include "cor/sphere.h"
#include "sphere_eval.h"

void cor_sphere_eps_zero_overlap_array(const double *beta, double *eps, size_t n)
{
    for (size_t i = 0; i < n; i++)
        eps[i] = sphere_eps_zero_overlap(beta[i]);
}

void cor_sphere_eps_zero_force_array(const double *beta, double *eps, size_t n)
{
    for (size_t i = 0; i < n; i++)
        eps[i] = sphere_eps_zero_force(beta[i]);
}
