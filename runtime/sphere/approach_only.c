/* SPDX-License-Identifier: MIT */
/* The sphere with damping during the approach only: rows for beta below 8 and for eps from 2^-6 on. Beyond them the
 * largest overlap Y is a pair, from which the rest follows (runtime/core/hertz_approach_only.h). */
#include "cor/sphere.h"
#include "runtime/core/hertz_approach_only.h"
#include "runtime/number/environment.h"
#include "runtime/sphere/eval.h"
#include "runtime/sphere/float_exceptions.h"

/* Y for finite beta beyond the rows */
static struct cor_inline_pair overlap_far(double beta)
{
    int exponent;
    const struct cor_inline_pair value =
        cor_inline_power_parts(beta, COR_INLINE_LOG_FACTOR(beta, max_overlap, COR_ROWS_TAIL_MAX_OVERLAP), 0, &exponent);
    return cor_pair_scaled(value, cor_kernel_power_of_two(exponent));
}

#define ROW_AT(beta, quantity, QUANTITY)                                                                               \
    cor_inline_grid_place(COR_INLINE_GRID(COR_ROWS_##QUANTITY), beta, cor_rows_##quantity)

static double eps_beyond(double beta)
{
    if (cor_inline_is_refused(beta))
        return NAN;
    if (beta < COR_INLINE_EPS_LEAST)
        return 1;
    return isinf(beta) ? 0 : cor_hertz_eps_approach_only(overlap_far(beta)).hi;
}

static double eps_approach_only(double beta)
{
    if (cor_inline_between(beta, COR_INLINE_EPS_LEAST, COR_ROWS_EPS_APPROACH_ONLY_END))
        return cor_inline_row_value(ROW_AT(beta, eps_approach_only, EPS_APPROACH_ONLY));
    return cor_in_environment(eps_beyond, beta);
}

static double loss_beyond(double beta)
{
    if (cor_inline_is_refused(beta))
        return NAN;
    if (cor_inline_is_zero(beta) || isinf(beta))
        return beta > 0;
    const struct cor_inline_pair eps = cor_hertz_eps_approach_only(overlap_far(beta));
    return (1 - eps.hi) - eps.lo;
}

static double loss_approach_only(double beta)
{
    if (cor_inline_below(beta, COR_ROWS_LOSS_APPROACH_ONLY_END))
        return cor_inline_loss_product(ROW_AT(beta, loss_approach_only, LOSS_APPROACH_ONLY), beta);
    return cor_in_environment(loss_beyond, beta);
}

static double duration_beyond(double beta)
{
    if (cor_inline_is_refused(beta))
        return NAN;
    if (isinf(beta))
        return INFINITY;
    return cor_hertz_duration_approach_only(overlap_far(beta), cor_inline_time_of_max_overlap(beta));
}

static double duration_approach_only(double beta)
{
    if (cor_inline_below(beta, COR_ROWS_DURATION_APPROACH_ONLY_END) || cor_inline_is_zero(beta))
        return cor_inline_row_value(ROW_AT(beta, duration_approach_only, DURATION_APPROACH_ONLY));
    return cor_in_environment(duration_beyond, beta);
}

/* beta from an eps below the rows by Newton's method: eps beta^(5/6) changes little there. The residual is computed
 * with pairs. */
static double beta_far(double eps)
{
    /* Y is about (3/2)^(2/3) beta^(-2/3) */
    const double log_y = -cor_kernel_minus_log(cor_pair(cor_hertz_overlap_of_eps(eps), 0)).hi;
    double beta = 1.5 * cor_kernel_exp_minus_pair(cor_pair(0.75 * log_y, 0)).hi;
    beta = beta * cor_kernel_exp_minus_pair(cor_pair(0.75 * log_y, 0)).hi;
    for (int k = 0; k < 40; k++) {
        const struct cor_inline_pair at = cor_hertz_eps_approach_only(overlap_far(beta));
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

static double beta_approach_only(double eps)
{
    if (cor_inline_between(eps, COR_ROWS_BETA_APPROACH_ONLY_FIRST, 1) || cor_inline_bits(eps) == cor_inline_bits(1))
        return cor_inline_inverse(eps, COR_INLINE_GRID(COR_ROWS_NEAR_BETA_APPROACH_ONLY), 0,
                                  cor_rows_near_beta_approach_only, COR_INLINE_OCTAVES(COR_ROWS_BETA_APPROACH_ONLY),
                                  cor_rows_beta_approach_only);
    return cor_in_environment(beta_beyond, eps);
}

static double beta_of_loss_approach_only(double loss)
{
    if (cor_inline_below(loss, COR_ROWS_NEAR_BETA_APPROACH_ONLY_END))
        return cor_inline_loss_product(ROW_AT(loss, near_beta_approach_only, NEAR_BETA_APPROACH_ONLY), loss);
    if (cor_inline_is_zero(loss))
        return 0;
    return cor_inline_is_refused(loss) ? NAN : beta_approach_only(1 - loss); /* exact from 1/2 to 1 */
}

#define SPHERE_APPROACH_ONLY(quantity)                                                                                 \
    double cor_sphere_##quantity##_approach_only(double x)                                                             \
    {                                                                                                                  \
        return quantity##_approach_only(x);                                                                            \
    }                                                                                                                  \
    float cor_sphere_##quantity##_approach_onlyf(float x)                                                              \
    {                                                                                                                  \
        static const struct cor_float_exception exception = COR_FLOAT_EXCEPTION_##quantity##_approach_only;            \
        return cor_float_corrected(exception, x, cor_inline_narrow(quantity##_approach_only((double)x)));              \
    }

SPHERE_APPROACH_ONLY(eps)
SPHERE_APPROACH_ONLY(loss)
SPHERE_APPROACH_ONLY(beta)
SPHERE_APPROACH_ONLY(beta_of_loss)
SPHERE_APPROACH_ONLY(duration)

/* The other arrays are in array_kernel.c. */
COR_ARRAY_IN_ENVIRONMENT(double, cor_sphere_beta_of_loss_approach_only_array, beta_of_loss_approach_only)
COR_ARRAY_IN_ENVIRONMENT(float, cor_sphere_beta_of_loss_approach_only_arrayf, cor_sphere_beta_of_loss_approach_onlyf)
