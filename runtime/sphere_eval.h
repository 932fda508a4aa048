/* SPDX-License-Identifier: MIT */
/* The one evaluator of the sphere tables: scalars and arrays share it, so that they agree to the
 * bit. */
#ifndef COR_RUNTIME_SPHERE_EVAL_H
#define COR_RUNTIME_SPHERE_EVAL_H

#include <math.h>

#include "cor/sphere.h"
#include "sphere_pade.h"

/* c[0] + c[1] z + ... + c[n-1] z^(n-1) */
static inline double sphere_polynomial(const double *c, int n, double z)
{
    double y = c[n - 1];
    for (int i = n - 2; i >= 0; i--)
        y = y * z + c[i];
    return y;
}

static inline int sphere_in_domain(double beta)
{
    return beta >= 0 && beta <= COR_SPHERE_BETA_MAX;
}

static inline double sphere_eps_zero_overlap(double beta)
{
    if (!sphere_in_domain(beta))
        return NAN;
    return sphere_polynomial(cor_sphere_pade_zero_overlap_p, COR_SPHERE_PADE_ZERO_OVERLAP_P, beta) /
           sphere_polynomial(cor_sphere_pade_zero_overlap_q, COR_SPHERE_PADE_ZERO_OVERLAP_Q, beta);
}

static inline double sphere_eps_zero_force(double beta)
{
    if (!sphere_in_domain(beta))
        return NAN;
    const double z = sqrt(beta);
    return sphere_polynomial(cor_sphere_pade_zero_force_p, COR_SPHERE_PADE_ZERO_FORCE_P, z) /
           sphere_polynomial(cor_sphere_pade_zero_force_q, COR_SPHERE_PADE_ZERO_FORCE_Q, z);
}

/* 1 - P/Q = beta L/Q: the table's L = (Q - P)/beta was subtracted before it was rounded, so nothing
 * cancels here. */
static inline double sphere_loss_zero_overlap(double beta)
{
    if (!sphere_in_domain(beta))
        return NAN;
    return beta * (sphere_polynomial(cor_sphere_pade_zero_overlap_l, COR_SPHERE_PADE_ZERO_OVERLAP_L, beta) /
                   sphere_polynomial(cor_sphere_pade_zero_overlap_q, COR_SPHERE_PADE_ZERO_OVERLAP_Q, beta));
}

static inline double sphere_loss_zero_force(double beta)
{
    if (!sphere_in_domain(beta))
        return NAN;
    const double z = sqrt(beta);
    return beta * (sphere_polynomial(cor_sphere_pade_zero_force_l, COR_SPHERE_PADE_ZERO_FORCE_L, z) /
                   sphere_polynomial(cor_sphere_pade_zero_force_q, COR_SPHERE_PADE_ZERO_FORCE_Q, z));
}

#endif
