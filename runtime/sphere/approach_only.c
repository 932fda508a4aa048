/* SPDX-License-Identifier: MIT */
/* The sphere with damping during the approach only: rows for beta below 8 and for eps from 2^-6 on. Beyond them the
 * largest overlap Y is a pair, from which the rest follows (runtime/table/hertz_approach_only.h). */
#include "cor/sphere.h"
#include "runtime/sphere/eval.h"
#include "runtime/sphere/float_exceptions.h"
#include "runtime/table/hertz_approach_only.h"

/* Y for finite beta beyond the rows */
static inline struct cor_inline_pair sphere_overlap(double beta, int *fourth)
{
    int exponent;
    const struct cor_inline_pair value =
        cor_inline_power_parts(beta, COR_INLINE_LOG_FACTOR(beta, max_overlap, COR_ROWS_TAIL_MAX_OVERLAP), 0, &exponent);
    *fourth = 0;
    return cor_pair_scaled(value, cor_kernel_power_of_two(exponent));
}

COR_HERTZ_APPROACH_ONLY(sphere, cor_rows, COR_ROWS, cor_sphere_time_of_max_overlap)

/* beta from an eps below the rows by Newton's method: eps beta^(5/6) changes little there. The residual is computed
 * with pairs. */
static double beta_far(double eps)
{
    /* Y is about (3/2)^(2/3) beta^(-2/3) */
    const double log_y = -cor_kernel_minus_log(cor_pair(cor_hertz_overlap_of_eps(eps), 0)).hi;
    double beta = 1.5 * cor_kernel_exp_minus_pair(cor_pair(0.75 * log_y, 0)).hi;
    beta = beta * cor_kernel_exp_minus_pair(cor_pair(0.75 * log_y, 0)).hi;
    int unused;
    for (int k = 0; k < 40; k++) {
        const struct cor_inline_pair at = cor_hertz_eps_approach_only(sphere_overlap(beta, &unused));
        const double off = ((at.hi - eps) + at.lo) / eps;
        beta += beta * (off * 1.2); /* -d ln(beta)/d ln(eps), wrong by some percent */
        if (fabs(off) < 1e-15)
            break;
    }
    return beta;
}

/* Below this eps, beta is beyond the largest double. */
#define SPHERE_LEAST_EPS 1.65713570994383150e-257

static double beta_beyond(double eps)
{
    if (!(eps >= 0 && eps <= 1))
        return NAN;
    return eps < SPHERE_LEAST_EPS ? INFINITY : beta_far(eps);
}

static inline double sphere_beta_approach_only(double eps)
{
    if (cor_inline_between(eps, COR_ROWS_BETA_APPROACH_ONLY_FIRST, 1) || cor_inline_bits(eps) == cor_inline_bits(1))
        return cor_inline_inverse(eps, COR_INLINE_GRID(COR_ROWS_NEAR_BETA_APPROACH_ONLY), 0,
                                  cor_rows_near_beta_approach_only, COR_INLINE_OCTAVES(COR_ROWS_BETA_APPROACH_ONLY),
                                  cor_rows_beta_approach_only);
    return cor_in_environment(beta_beyond, eps);
}

#define SPHERE_APPROACH_ONLY(quantity)                                                                                 \
    COR_SPHERE_SCALARS(quantity##_approach_only, sphere_##quantity##_approach_only, cor_inline_narrow)
SPHERE_APPROACH_ONLY(eps)
SPHERE_APPROACH_ONLY(loss)
SPHERE_APPROACH_ONLY(beta)
SPHERE_APPROACH_ONLY(beta_of_loss)
SPHERE_APPROACH_ONLY(duration)

/* The other arrays are in array_kernel.c. */
COR_ARRAY_IN_ENVIRONMENT(double, cor_sphere_beta_of_loss_approach_only_array, sphere_beta_of_loss_approach_only)
COR_ARRAY_IN_ENVIRONMENT(float, cor_sphere_beta_of_loss_approach_only_arrayf, cor_sphere_beta_of_loss_approach_onlyf)
