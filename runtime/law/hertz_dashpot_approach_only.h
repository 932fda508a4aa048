/* SPDX-License-Identifier: MIT */
/* Hertz's contact with a constant dashpot and damping during the approach only. Tables have rows for beta below 8 and
 * for eps >= 2^-6. Beyond them the functions use the largest overlap Y (runtime/table/hertz_approach_only.h). */
#ifndef COR_RUNTIME_LAW_HERTZ_DASHPOT_APPROACH_ONLY_H
#define COR_RUNTIME_LAW_HERTZ_DASHPOT_APPROACH_ONLY_H

#include "generated/hertz_dashpot_tables.h"
#include "runtime/table/hertz_approach_only.h"

/* Returns Y 2^(-4 *fourth) as a pair, for finite beta beyond the rows. */
static inline struct cor_inline_pair cor_inline_hertz_dashpot_overlap(double beta, int *fourth)
{
    int exponent;
    const struct cor_inline_pair value = cor_inline_law_tail(cor_law_hertz_dashpot_max_overlap(), beta, &exponent);
    const int more = ((exponent % 4) + 4) % 4;
    *fourth = (exponent - more) / 4;
    return cor_pair_scaled(value, cor_kernel_power_of_two(more));
}

static double dashpot_time_of_max_overlap(double beta)
{
    return cor_inline_hertz_dashpot_time_of_max_overlap(beta);
}

#define DASHPOT_GRID(quantity, QUANTITY, value, least)                                                                 \
    COR_ROW_TABLE_OF_GRID(cor_rows_hertz_dashpot_##quantity, COR_ROWS_HERTZ_DASHPOT_##QUANTITY, COR_ROW_GRID, value,   \
                          least, 0)
#define DASHPOT_INVERSE(quantity, QUANTITY)                                                                            \
    COR_ROW_TABLE_OF_INVERSE(COR_ROW_INVERSE, cor_rows_hertz_dashpot_near_##quantity,                                  \
                             COR_ROWS_HERTZ_DASHPOT_NEAR_##QUANTITY, cor_rows_hertz_dashpot_##quantity,                \
                             COR_ROWS_HERTZ_DASHPOT_##QUANTITY)

static const struct cor_hertz_law dashpot_law = {
    DASHPOT_GRID(eps_approach_only, EPS_APPROACH_ONLY, COR_ROW_SUM, 0),
    DASHPOT_GRID(loss_approach_only, LOSS_APPROACH_ONLY, COR_ROW_PRODUCT, COR_INLINE_2_M900),
    DASHPOT_GRID(duration_approach_only, DURATION_APPROACH_ONLY, COR_ROW_SUM, 0),
    DASHPOT_INVERSE(beta_approach_only, BETA_APPROACH_ONLY),
    cor_inline_hertz_dashpot_overlap,
    dashpot_time_of_max_overlap,
};

/* Returns ln(eps(beta)/eps), from a short series where it is small. */
static inline double dashpot_excess(double beta, double eps)
{
    int fourth;
    const struct cor_inline_pair at = cor_hertz_eps_approach_only(cor_inline_hertz_dashpot_overlap(beta, &fourth));
    const double hi = ldexp(eps, -5 * fourth), ratio = at.hi / hi, x = ((at.hi - hi) + at.lo) / hi;
    return fabs(x) < 0x1p-10 ? x * (1 - x * (0.5 - x / 3)) : ratio < 0.5 || ratio > 2 ? log(ratio) : log1p(x);
}

/* beta/(eps^(-4/5) - 1) as a polynomial in s = eps^(4/5) < 0.965: relative error 9e-5, sampled */
static const double dashpot_start[] = {
    0.91452908576775, 0.93378330451653, -1.0635296993373,  1.2880808695525,
    -1.1209804198765, 0.57319227955735, -0.12671938740928,
};

/* Returns beta by Newton's method for ln(eps) as a function of ln(beta). The first slope comes from the polynomial,
 * later slopes from the last two values. The residual is computed with pairs. Three values suffice. */
static inline double dashpot_beta_of_eps(double eps)
{
    const double s = exp2(0.8 * log2(eps));
    double g = 0, derivative = 0, last_beta = 0, last = 0;
    for (int k = (int)(sizeof dashpot_start / sizeof *dashpot_start) - 1; k >= 0; k--) {
        derivative = g + s * derivative;
        g = dashpot_start[k] + s * g;
    }
    double beta = (1 / s - 1) * g, slope = -1.25 / (1 / (1 - s) - s * derivative / g);
    for (int k = 0; k < 40; k++) {
        const double off = dashpot_excess(beta, eps), step = (beta - last_beta) / beta;
        if (k > 0 && step != 0)
            slope = (off - last) / (step * (1 + step / 2));
        const double error = off * last; /* the relative error of the slope is about `last` */
        last = off;
        last_beta = beta;
        beta -= beta * (off / slope);
        if (off == 0 || (k > 0 && fabs(error) < 1e-17))
            break;
    }
    return beta;
}

static inline double dashpot_beta_beyond(double eps)
{
    if (!(eps >= 0 && eps <= 1))
        return NAN;
    return eps == 0 ? INFINITY : dashpot_beta_of_eps(eps);
}

static inline double dashpot_beta_approach_only(double eps)
{
    const struct cor_row_table *const rows = &dashpot_law.beta;
    if (cor_inline_between(eps, 0.5, 1) || cor_inline_bits(eps) == cor_inline_bits(1))
        return cor_hertz_beta_near(&dashpot_law, 1 - eps);
    if (cor_inline_between(eps, rows->octaves.first, 0.5))
        return cor_inline_row_value(cor_row_middle(rows, eps));
    return cor_in_environment(dashpot_beta_beyond, eps);
}

#endif
