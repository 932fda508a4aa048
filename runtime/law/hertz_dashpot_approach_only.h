/* SPDX-License-Identifier: MIT */
/* Hertz's contact with a constant dashpot and damping while approaching only, from the largest overlap Y
 * (runtime/core/hertz_approach_only.h). */
#ifndef COR_RUNTIME_LAW_HERTZ_DASHPOT_APPROACH_ONLY_H
#define COR_RUNTIME_LAW_HERTZ_DASHPOT_APPROACH_ONLY_H

#include "generated/hertz_dashpot_tables.h"
#include "runtime/core/hertz_approach_only.h"

/* 1 - eps = a_1 beta + a_2 beta^2 + ..., beta < 1/16: from (Y/Y_0)^(5/4) with Y = sum y_k beta^k as
 * `corgen series --elastic 3/2 --damping 0` prints it; a_1 = |C_1|/2. What follows is below 2^-80 of the first term. */
#define DASHPOT_LOSS_END 0.0625
#define DASHPOT_LOSS_FIRST 8.93907072144178638240e-01
#define DASHPOT_LOSS_FIRST_TAIL (-3.64665022819206819441e-18)
static const double dashpot_loss[] = {
    -5.8528141361565022560142779e-01, 3.1522933147088516570022421e-01,  -1.4487216762933627367537781e-01,
    5.7317348085966092485765699e-02,  -1.9290227194934360388511863e-02, 5.2810232778576944590032127e-03,
    -1.0158664061217864086478224e-03, 3.5329941352194646887827784e-05,  7.4097510376513897752646931e-05,
    -3.7403401370311960261443723e-05, 9.6663458259147513190745471e-06,  -4.0686534308513632461599160e-07,
    -9.4389915307904042914412344e-07, 5.1615705838644407112722305e-07,
};

/* (1 - eps)/beta, beta < DASHPOT_LOSS_END */
static inline struct cor_inline_pair dashpot_loss_per_beta(double beta)
{
    double sum = 0;
    for (int k = (int)(sizeof dashpot_loss / sizeof *dashpot_loss) - 1; k >= 0; k--)
        sum = dashpot_loss[k] + beta * sum;
    return cor_inline_sum(DASHPOT_LOSS_FIRST, DASHPOT_LOSS_FIRST_TAIL + beta * sum);
}

/* Y = pair 2^(4 *fourth), beta finite */
static inline struct cor_inline_pair dashpot_overlap(double beta, int *fourth)
{
    const struct cor_inline_law_quantity q = cor_law_hertz_dashpot_max_overlap();
    *fourth = 0;
    if (beta < q.middle.end) {
        const struct cor_inline_place place =
            beta < q.near.end ? cor_inline_law_near(q.near, beta) : cor_inline_law_octave(q.middle, beta);
        return cor_inline_sum(place.row[0], cor_inline_row(place));
    }
    int exponent;
    const struct cor_inline_pair value = cor_inline_law_tail(q, beta, &exponent);
    const int more = ((exponent % 4) + 4) % 4;
    *fourth = (exponent - more) / 4;
    return cor_pair_scaled(value, cor_kernel_power_of_two(more));
}

/* eps = pair 2^*exponent, beta finite */
static inline struct cor_inline_pair dashpot_eps(double beta, int *exponent)
{
    const struct cor_inline_pair y = dashpot_overlap(beta, exponent);
    *exponent *= 5;
    return cor_hertz_eps_approach_only(y);
}

static inline double dashpot_eps_approach_only(double beta)
{
    if (!(beta >= 0))
        return NAN;
    if (isinf(beta))
        return 0;
    int exponent;
    const struct cor_inline_pair eps = dashpot_eps(beta, &exponent);
    return cor_inline_pair_scaled(eps, exponent);
}

static inline double dashpot_loss_approach_only(double beta)
{
    if (!(beta >= 0))
        return NAN;
    if (beta < DASHPOT_LOSS_END) { /* a tiny beta in units of 2^-200, so that the product loses no bits */
        const double unit = beta < COR_INLINE_2_M500 ? COR_INLINE_2_M200 : 1, scale = unit < 1 ? COR_INLINE_2_200 : 1;
        return cor_inline_pair_times(dashpot_loss_per_beta(beta), cor_pair(beta * scale, 0)).hi * unit;
    }
    if (isinf(beta))
        return 1;
    int exponent;
    struct cor_inline_pair eps = dashpot_eps(beta, &exponent);
    if (exponent < -200)
        return 1;
    eps = cor_pair_scaled(eps, ldexp(1, exponent));
    return (1 - eps.hi) - eps.lo;
}

/* beta = loss/quotient, until the quotient no longer changes */
static inline double dashpot_beta_of_small_loss(struct cor_inline_pair loss)
{
    double beta = loss.hi / DASHPOT_LOSS_FIRST;
    for (int k = 0; k < 20; k++) {
        const double next = loss.hi / dashpot_loss_per_beta(beta).hi, step = next - beta;
        beta = next;
        if (fabs(step) <= 1e-17 * beta)
            break;
    }
    return cor_pair_over(loss, dashpot_loss_per_beta(beta)).hi;
}

/* ln(eps(beta)/eps) to first order where it is small; eps as a pair */
static inline double dashpot_excess(double beta, struct cor_inline_pair eps)
{
    int exponent;
    const struct cor_inline_pair at = dashpot_eps(beta, &exponent);
    const double hi = ldexp(eps.hi, -exponent), lo = ldexp(eps.lo, -exponent);
    const double ratio = at.hi / hi, x = ((at.hi - hi) + (at.lo - lo)) / hi;
    return fabs(x) < 0x1p-10 ? x * (1 - x * (0.5 - x / 3)) : ratio < 0.5 || ratio > 2 ? log(ratio) : log1p(x);
}

/* beta/(eps^(-4/5) - 1) as a polynomial in s = eps^(4/5) < 0.965: relative error 9e-5, sampled */
static const double dashpot_start[] = {
    0.91452908576775, 0.93378330451653, -1.0635296993373,  1.2880808695525,
    -1.1209804198765, 0.57319227955735, -0.12671938740928,
};

/* Newton's method for ln(eps) of ln(beta) with the slope of the polynomial, then of the last two values; the residual
 * is a pair's. Three values suffice. */
static inline double dashpot_beta_of_eps(struct cor_inline_pair eps)
{
    const double s = exp2(0.8 * log2(eps.hi));
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
        const double error = off * last; /* that of the slope is as large as the last residual */
        last = off;
        last_beta = beta;
        beta -= beta * (off / slope);
        if (off == 0 || (k > 0 && fabs(error) < 1e-17))
            break;
    }
    return beta;
}

/* eps and 1 - eps, both as pairs */
static inline double dashpot_beta_of_pairs(struct cor_inline_pair eps, struct cor_inline_pair loss)
{
    return loss.hi < 0.05 ? dashpot_beta_of_small_loss(loss) : dashpot_beta_of_eps(eps);
}

static inline double dashpot_beta_approach_only(double eps)
{
    if (!(eps >= 0 && eps <= 1))
        return NAN;
    if (eps == 0)
        return INFINITY;
    const double loss = 1 - eps;
    return eps == 1 ? 0 : dashpot_beta_of_pairs(cor_pair(eps, 0), cor_pair(loss, (1 - loss) - eps));
}

static inline double dashpot_beta_of_loss_approach_only(double loss)
{
    if (!(loss >= 0 && loss <= 1))
        return NAN;
    if (loss < COR_INLINE_2_M500) /* in units of 2^-200, so that the quotient's remainder loses no bits */
        return dashpot_beta_of_small_loss(cor_pair(loss * COR_INLINE_2_200, 0)) * COR_INLINE_2_M200;
    const double eps = 1 - loss;
    return loss == 1 ? INFINITY : dashpot_beta_of_pairs(cor_pair(eps, (1 - eps) - loss), cor_pair(loss, 0));
}

static inline double dashpot_duration_approach_only(double beta)
{
    if (!(beta >= 0))
        return NAN;
    if (isinf(beta))
        return INFINITY;
    int fourth; /* of Y's power of two: the duration of the rebound has Y^(-1/4) */
    const struct cor_inline_pair y = dashpot_overlap(beta, &fourth);
    const double time = cor_inline_hertz_dashpot_time_of_max_overlap(beta);
    return ldexp(cor_hertz_duration_approach_only(y, ldexp(time, fourth)), -fourth);
}

#endif
