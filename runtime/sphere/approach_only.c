/* SPDX-License-Identifier: MIT */
/* The sphere with damping during the approach only. Tables have rows for beta below 8 and for eps >= 2^-6. Beyond them
 * the functions compute the largest overlap Y as a pair, and the rest from Y (runtime/table/hertz_approach_only.h). */
#include "cor/sphere.h"
#include "runtime/sphere/eval.h"
#include "runtime/table/hertz_approach_only.h"

/* Returns Y for finite beta beyond the rows. */
static inline struct cor_inline_pair sphere_overlap(double beta, int *fourth)
{
    int exponent;
    const struct cor_inline_pair value =
        cor_inline_power_parts(beta, COR_INLINE_LOG_FACTOR(beta, max_overlap, COR_ROWS_TAIL_MAX_OVERLAP), 0, &exponent);
    *fourth = 0;
    return cor_pair_scaled(value, cor_kernel_power_of_two(exponent));
}

#define GRID(quantity, NAME, value, least)                                                                             \
    COR_ROW_TABLE_OF_GRID(cor_rows_##quantity, COR_ROWS_##NAME, COR_ROW_GRID, value, least, 0)
static const struct cor_hertz_law sphere_law = {
    GRID(eps_approach_only, EPS_APPROACH_ONLY, COR_ROW_SUM, 0),
    GRID(loss_approach_only, LOSS_APPROACH_ONLY, COR_ROW_PRODUCT, COR_INLINE_2_M900),
    GRID(duration_approach_only, DURATION_APPROACH_ONLY, COR_ROW_SUM, 0),
    COR_ROW_TABLE_OF_INVERSE(COR_ROW_INVERSE, cor_rows_near_beta_approach_only, COR_ROWS_NEAR_BETA_APPROACH_ONLY,
                             cor_rows_beta_approach_only, COR_ROWS_BETA_APPROACH_ONLY),
    sphere_overlap,
    cor_sphere_time_of_max_overlap,
};

/* Returns beta of an eps below the rows, by Newton's method: eps beta^(5/6) varies little there. The residual is
 * computed with pairs. */
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
        beta += beta * (off * 1.2); /* -d ln(beta)/d ln(eps) is 1.2 within a few percent */
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

/* ---- the functions ---- */

double cor_sphere_eps_approach_only(double beta)
{
    return cor_hertz_eps(&sphere_law, beta);
}

double cor_sphere_loss_approach_only(double beta)
{
    return cor_hertz_loss(&sphere_law, beta);
}

double cor_sphere_duration_approach_only(double beta)
{
    return cor_hertz_duration(&sphere_law, beta);
}

double cor_sphere_beta_approach_only(double eps)
{
    if (cor_inline_between(eps, COR_ROWS_BETA_APPROACH_ONLY_FIRST, 1) || cor_inline_bits(eps) == cor_inline_bits(1))
        return cor_inline_inverse(eps, COR_INLINE_GRID(COR_ROWS_NEAR_BETA_APPROACH_ONLY), 0,
                                  cor_rows_near_beta_approach_only, COR_INLINE_OCTAVES(COR_ROWS_BETA_APPROACH_ONLY),
                                  cor_rows_beta_approach_only);
    return cor_in_environment(beta_beyond, eps);
}

double cor_sphere_beta_of_loss_approach_only(double loss)
{
    return cor_hertz_beta_of_loss(&sphere_law, cor_sphere_beta_approach_only, loss);
}

/* ---- arrays ---- */

void cor_sphere_eps_approach_only_array(const double *beta, double *y, size_t n)
{
    cor_row_array(&sphere_law.eps, cor_sphere_eps_approach_only, beta, y, n);
}

void cor_sphere_loss_approach_only_array(const double *beta, double *y, size_t n)
{
    cor_row_array(&sphere_law.loss, cor_sphere_loss_approach_only, beta, y, n);
}

void cor_sphere_duration_approach_only_array(const double *beta, double *y, size_t n)
{
    cor_row_array(&sphere_law.duration, cor_sphere_duration_approach_only, beta, y, n);
}

void cor_sphere_beta_approach_only_array(const double *eps, double *y, size_t n)
{
    cor_row_array(&sphere_law.beta, cor_sphere_beta_approach_only, eps, y, n);
}

void cor_sphere_beta_of_loss_approach_only_array(const double *loss, double *y, size_t n)
{
    cor_array_in_environment(cor_sphere_beta_of_loss_approach_only, loss, y, n);
}
