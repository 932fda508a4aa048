/* SPDX-License-Identifier: MIT */
/* Hunt and Crossley's law F = F_el(x) (1 + d x') and its restitution as a function of only beta = d g (docs/laws.md):
 *
 *     f(beta) = f(-h),  f(z) = z - ln(1 + z),  h = beta eps
 *     beta = y + c, h = y - c, c = y coth(y) - 1;   eps = h/beta, 1 - eps = 2 c/beta
 *
 * This file computes the values for which closed_form.h has no row: strong and negative damping. */
#ifndef COR_RUNTIME_LAW_HUNT_CROSSLEY_H
#define COR_RUNTIME_LAW_HUNT_CROSSLEY_H

#include "runtime/number/elementary.h"

/* Below this beta, three terms of the series are exact to the last bit. */
#define COR_HC_TINY 9.5367431640625e-07        /* 2^-20 */
#define COR_HC_APPROACH_LEAST COR_INLINE_2_M60 /* below it eps is 1 and the loss is beta/3 */

/* 1/3 and 2/3 as pairs */
#define COR_HC_THIRD 3.33333333333333314830e-01
#define COR_HC_THIRD_TAIL 1.85037170770859413132e-17

/* ---- polynomials: see runtime/number/elementary.h ---- */

/* (c/x - 1/3)/x with c = y coth(y) - 1 and x = y^2, 0 <= x <= 2.26: the error times x, relative to c/x, is below
 * 2^-55. */
static const double cor_hc_coth_polynomial[13] = {
    -0x1.6c16c16c16c17p-6,  0x1.1566abc011469p-9,  -0x1.bbd779333641ep-13, 0x1.66a8f2b7e28b9p-16,
    -0x1.22805c2f9c6f4p-19, 0x1.d6daf175b5705p-23, -0x1.7da14382a020fp-26, 0x1.3531fe34faddep-29,
    -0x1.f34856d9e737fp-33, 0x1.8b2880c34a954p-36, -0x1.21018f2ffb153p-39, 0x1.5026bf9341a53p-43,
    -0x1.b5fd4159b7fcdp-48,
};

/* ((atanh(s)/s - 1)/s^2 - 1/3)/s^2 in s^2, 0 <= s^2 <= 0.25: the error times s^2 is below 2^-55. */
static const double cor_hc_atanh_polynomial[13] = {
    0x1.999999999999cp-3, 0x1.24924924915c0p-3,  0x1.c71c71c8b9cc2p-4, 0x1.745d16b8b59b2p-4, 0x1.3b13ca2b8cd7ep-4,
    0x1.110e7464e2d34p-4, 0x1.e23b4de0e39f5p-5,  0x1.ab2e18804535ep-5, 0x1.a4c937c1e7826p-5, 0x1.8839e0c4ed244p-6,
    0x1.b6598f3bb947cp-4, -0x1.a952459125d8ap-4, 0x1.7bc13387f454dp-3,
};

/* ---- y from beta, up to y = 1.5 ---- */

/* For |y| <= 1.5: c = y coth(y) - 1 as a pair with relative error 2^-55, and slope = dc/dy = y - c (1 + c)/y,
 * rounded */
struct cor_hc_coth {
    struct cor_inline_pair c;
    double slope;
};

COR_KERNEL struct cor_hc_coth cor_hc_coth_near(double y)
{
    const double *p = cor_hc_coth_polynomial;
    const struct cor_inline_pair square = cor_inline_product(y, y);
    const double x = square.hi, x2 = x * x, x4 = x2 * x2;
    const double end = COR_POLYNOMIAL_4(p + 8, x, x2) + p[12] * x4;
    const double rest = x * (COR_POLYNOMIAL_8(p, x, x2, x4) + end * (x4 * x4)); /* c/x - 1/3 */
    const struct cor_inline_pair third = cor_inline_pair_times(square, cor_pair(COR_HC_THIRD, COR_HC_THIRD_TAIL));
    struct cor_hc_coth coth;
    coth.c = cor_inline_sum(third.hi, third.lo + x * rest);
    coth.slope = y * (1 - (COR_HC_THIRD + rest) * (1 + coth.c.hi));
    return coth;
}

/* ---- negative damping ---- */

/* h and beta - h as pairs */
struct cor_hc_speeds {
    struct cor_inline_pair rebound, lost;
};

/* Returns 2/3 beta - 4/9 beta^2 + 44/135 beta^3, |beta| < COR_HC_TINY. */
COR_INLINE double cor_hc_loss_tiny(double beta)
{
    const double b = beta * COR_INLINE_2_200;
    const struct cor_inline_pair p = cor_inline_product(b, 2 * COR_HC_THIRD);
    const double more = b * (2 * COR_HC_THIRD_TAIL - beta * (4.0 / 9 - beta * (44.0 / 135)));
    return (p.hi + (p.lo + more)) * COR_INLINE_2_M200;
}

/* Computes a collision with negative damping, beta = -b. y solves y - c = b, and b eps is y + c. Newton's method starts
 * from y = b. The function is valid up to b = 0.7, where y = 1.1. */
COR_INLINE struct cor_hc_speeds cor_hc_speeds_pumped_near(double b)
{
    double y = b, step = 0;
    for (int k = 0; k < 30; k++) {
        const struct cor_hc_coth at = cor_hc_coth_near(y);
        step = (((b - y) + at.c.hi) + at.c.lo) / (1 - at.slope);
        if (fabs(step) < 1e-9 * y * y)
            break;
        y += step;
    }
    struct cor_hc_speeds speeds;
    speeds.rebound = cor_pair_two_sum(2 * y - b, 2 * step);
    speeds.lost = cor_pair_two_sum(2 * (b - y), -2 * step);
    return speeds;
}

/* Returns z - ln(1 + z) as a pair, for z > -1 that is not near 0. */
COR_INLINE struct cor_inline_pair cor_hc_energy(double z)
{
    return cor_pair_plus(cor_pair(z, 0), cor_kernel_minus_log(cor_pair_two_sum(1, z)));
}

/* Computes the same collision for larger b. t = b eps solves f(t) = f(-b). Newton's method starts above the root of the
 * convex f. */
COR_INLINE struct cor_hc_speeds cor_hc_speeds_pumped_far(double b)
{
    const struct cor_inline_pair wanted = cor_hc_energy(-b);
    double t = 2 * wanted.hi + 1, step = 0;
    for (int k = 0; k < 30; k++) {
        const struct cor_inline_pair at = cor_hc_energy(t);
        step = ((wanted.hi - at.hi) + (wanted.lo - at.lo)) * (1 + t) / t;
        if (fabs(step) < 1e-9 * t)
            break;
        t += step;
    }
    struct cor_hc_speeds speeds;
    speeds.rebound = cor_pair_two_sum(t, step);
    speeds.lost = cor_pair_two_sum(b - t, -step);
    return speeds;
}

COR_INLINE struct cor_hc_speeds cor_hc_speeds_pumped(double b)
{
    return b < 0.7 ? cor_hc_speeds_pumped_near(b) : cor_hc_speeds_pumped_far(b);
}

/* ---- eps, 1 - eps and beta beyond the rows ---- */

COR_INLINE double cor_crossley_eps_beyond(double beta)
{
    if (!(beta > -1))
        return (double)NAN;
    if (beta >= 0)
        return beta == 0 ? 1 : isinf(beta) ? 0 : 1 / beta;
    if (beta > -COR_HC_TINY)
        return 1 - cor_hc_loss_tiny(beta);
    return cor_pair_over(cor_hc_speeds_pumped(-beta).rebound, cor_pair(-beta, 0)).hi;
}

COR_INLINE double cor_crossley_loss_beyond(double beta)
{
    if (!(beta > -1))
        return (double)NAN;
    if (beta >= 0)
        return beta == 0 ? 0 : isinf(beta) ? 1 : 1 - 1 / beta;
    if (beta > -COR_HC_TINY)
        return cor_hc_loss_tiny(beta);
    return cor_pair_over(cor_hc_speeds_pumped(-beta).lost, cor_pair(-beta, 0)).hi;
}

COR_INLINE double cor_crossley_beta_beyond(double eps)
{
    if (!(eps >= 0 && eps <= 1))
        return (double)NAN;
    return eps <= 5.56268464626800345772e-309 ? (double)INFINITY : 1 / eps; /* 2^-1024 */
}

/* ---- damping during the approach only ----
 *
 * eps = sqrt(2 f(beta))/beta. With s = beta/(2 + beta), 1 - eps^2 = s (1 + (1 - s)^2 K(s^2)), K(s^2) = (atanh(s)/s -
 * 1)/s^2. */

/* Returns s (1 + (1 - s)^2 K(s^2)), |s.hi| <= 1/2: relative error 2^-54. */
COR_KERNEL struct cor_inline_pair cor_hc_square_loss(struct cor_inline_pair s)
{
    const double *p = cor_hc_atanh_polynomial;
    const double x = s.hi * s.hi, x2 = x * x, x4 = x2 * x2;
    const double end = COR_POLYNOMIAL_4(p + 8, x, x2) + p[12] * x4;
    const double rest = x * (COR_POLYNOMIAL_8(p, x, x2, x4) + end * (x4 * x4)); /* K - 1/3 */
    struct cor_inline_pair below = cor_pair_two_sum(1, -s.hi);
    below.lo -= s.lo;
    const struct cor_inline_pair square = cor_inline_pair_times(below, below);
    const struct cor_inline_pair third = cor_inline_pair_times(square, cor_pair(COR_HC_THIRD, COR_HC_THIRD_TAIL));
    struct cor_inline_pair share = cor_pair_two_sum(1, third.hi);
    share.lo += third.lo + square.hi * rest;
    return cor_inline_pair_times(s, share);
}

/* Returns 1 - eps^2, -2/3 <= beta < 0. */
COR_KERNEL struct cor_inline_pair cor_hc_approach_near(double beta)
{
    return cor_hc_square_loss(cor_pair_over(cor_pair(beta, 0), cor_pair_two_sum(2, beta)));
}

COR_KERNEL struct cor_inline_pair cor_hc_eps_of_square_loss(struct cor_inline_pair lost)
{
    struct cor_inline_pair square = cor_pair_two_sum(1, -lost.hi);
    square.lo -= lost.lo;
    return cor_pair_root(square);
}

/* Returns eps for -1 < beta < 0 and 1 < beta < inf: sqrt(2 f)/|beta|, except near beta = 0. Above 2^500 f is beta. */
COR_INLINE struct cor_inline_pair cor_hc_eps_approach_pair(double beta)
{
    if (fabs(beta) < COR_HC_APPROACH_LEAST)
        return cor_pair(1, -beta * COR_HC_THIRD);
    if (beta < 0 && beta >= -2.0 / 3)
        return cor_hc_eps_of_square_loss(cor_hc_approach_near(beta));
    if (beta <= COR_INLINE_2_500)
        return cor_pair_over(cor_pair_root(cor_pair_scaled(cor_hc_energy(beta), 2)), cor_pair(fabs(beta), 0));
    const double b = beta * COR_INLINE_2_M500;
    const struct cor_inline_pair scaled = cor_pair_over(cor_pair_root(cor_pair(2 * b, 0)), cor_pair(b, 0));
    return cor_pair_scaled(scaled, COR_INLINE_2_M500 * COR_INLINE_2_250);
}

COR_INLINE double cor_crossley_eps_beyond_approach_only(double beta)
{
    if (!(beta > -1))
        return (double)NAN;
    if (isinf(beta))
        return 0;
    const struct cor_inline_pair eps = cor_hc_eps_approach_pair(beta);
    return eps.hi + eps.lo;
}

COR_INLINE double cor_crossley_loss_beyond_approach_only(double beta)
{
    if (!(beta > -1))
        return (double)NAN;
    if (fabs(beta) < COR_HC_APPROACH_LEAST)
        return beta / 3;
    if (isinf(beta))
        return 1;
    const struct cor_inline_pair eps = cor_hc_eps_approach_pair(beta);
    const struct cor_inline_pair less = cor_pair_two_sum(1, -eps.hi);
    return less.hi + (less.lo - eps.lo);
}

/* Solves eps^2 beta^2/2 = beta - ln(1 + beta), a convex function, by Newton's method from 2/eps^2, above the root. */
COR_INLINE double cor_crossley_beta_beyond_approach_only(double value)
{
    const struct cor_inline_pair eps = cor_pair(value, 0);
    if (!(value >= 0 && value <= 1))
        return (double)NAN;
    if (eps.hi < 1.05476866148630004e-154) /* 2^-511.5 */
        return (double)INFINITY;
    if (eps.hi < COR_HC_APPROACH_LEAST) { /* beta is 2/eps^2 to the last bit */
        const struct cor_inline_pair over = cor_pair_over(cor_pair(1, 0), eps);
        return 2 * cor_inline_pair_times(over, over).hi;
    }
    const struct cor_inline_pair square = cor_pair_scaled(cor_inline_pair_times(eps, eps), 0.5);
    double beta = 1 / square.hi;
    for (int k = 0; k < 30; k++) {
        const struct cor_inline_pair b = cor_pair(beta, 0), energy = cor_hc_energy(beta);
        const struct cor_inline_pair wanted = cor_inline_pair_times(cor_inline_pair_times(b, b), square);
        const double off = (wanted.hi - energy.hi) + (wanted.lo - energy.lo);
        const double step = off / (2 * beta * square.hi - beta / (1 + beta));
        beta -= step;
        if (fabs(step) < 1e-9 * beta)
            break;
    }
    return beta;
}

#endif
