/* SPDX-License-Identifier: MIT */
/* Hunt and Crossley's law F = F_el(x) (1 + d x') and its restitution as a function of beta = d g alone (docs/laws.md):
 *
 *     f(beta) = f(-h),  f(z) = z - ln(1 + z),  h = beta eps
 *     beta = y + c, h = y - c, c = y coth(y) - 1;   eps = h/beta, 1 - eps = 2 c/beta
 *
 * As in runtime/law/damping_ratio.h, kernels hold on an interval, and the other functions take every double. */
#ifndef COR_RUNTIME_LAW_HUNT_CROSSLEY_H
#define COR_RUNTIME_LAW_HUNT_CROSSLEY_H

#include "runtime/number/elementary.h"

/* Below this beta, three terms of the series are exact to the last bit. */
#define COR_HC_TINY 9.5367431640625e-07 /* 2^-20 */
/* y = 1.5, and its beta and eps */
#define COR_HC_ROOT_NEAR 1.5
#define COR_HC_BETA_NEAR 2.157
#define COR_HC_EPS_NEAR 0.3908
/* Largest beta of the kernels */
#define COR_HC_LARGEST 1e300
/* Damping during the approach only: the largest beta of the polynomial in s = beta/(2 + beta), and its eps */
#define COR_HC_APPROACH_NEAR 2.0
#define COR_HC_APPROACH_LEAST 8.67361737988403547206e-19 /* 2^-60: below it eps is 1 and the loss is beta/3 */
#define COR_HC_EPS_APPROACH_NEAR 0.6714

/* 1/3 and 2/3 as pairs */
#define COR_HC_THIRD 3.33333333333333314830e-01
#define COR_HC_THIRD_TAIL 1.85037170770859413132e-17

/* ---- polynomials: see runtime/number/elementary.h ---- */

/* ((y coth(y) - 1)/x - 1/3)/x with x = y^2, 0 <= x <= 2.26: the error times x, relative to c/x, is below 2^-55. */
static const double cor_hc_coth_polynomial[13] = {
    -0x1.6c16c16c16c17p-6,  0x1.1566abc011469p-9,  -0x1.bbd779333641ep-13, 0x1.66a8f2b7e28b9p-16,
    -0x1.22805c2f9c6f4p-19, 0x1.d6daf175b5705p-23, -0x1.7da14382a020fp-26, 0x1.3531fe34faddep-29,
    -0x1.f34856d9e737fp-33, 0x1.8b2880c34a954p-36, -0x1.21018f2ffb153p-39, 0x1.5026bf9341a53p-43,
    -0x1.b5fd4159b7fcdp-48,
};

/* c/beta^2 in s = beta/(2 + beta), 0 <= beta <= 2.16: relative error 2^-29 */
static const double cor_hc_start_polynomial[10] = {
    0x1.555555534806cp-2,  -0x1.c71c6eb205e37p-2, 0x1.a8c3b273d761ap-3,  -0x1.57b7c3ea05f25p-3, 0x1.f3456c8e8bfd9p-4,
    -0x1.95e44796c10a7p-4, 0x1.fe15fecdf0dfep-5,  -0x1.94694b3d6be60p-7, -0x1.ef2b7a597340bp-6, 0x1.db87d8e68157cp-6,
};

/* (-W_0(-x)/x - 1)/x, 0 <= x <= 0.135: the error times x^2, relative to 1 + W_0(-x), is below 2^-55. */
static const double cor_hc_lambert_polynomial[15] = {
    0x1.0000000000002p+0,  0x1.7ffffffffe654p+0,   0x1.555555570f668p+1,  0x1.4d55549a2bf0fp+2,   0x1.5999c2f1eb096p+3,
    0x1.7577adb9817afp+4,  0x1.a0929e80cb316p+5,   0x1.d36e6078cd390p+6,  0x1.38bf938e4e4d7p+8,   0x1.79f82334eeacbp+6,
    0x1.d0e722d7549fcp+12, -0x1.3735f570ab0dfp+15, 0x1.b825e1f6eae70p+17, -0x1.36d5e50e9e83fp+19, 0x1.fa52e8bf026e7p+19,
};

/* y/t where coth(y) - 1/y = t, in t^2, 0 <= t <= 0.4387: relative error 2^-28 */
static const double cor_hc_langevin_polynomial[7] = {
    0x1.8000000bd96ccp+1, 0x1.cccc9dc67dde8p+0, 0x1.b2871070fdc8cp+0, 0x1.c0770bacb2f26p+0,
    0x1.f902ddfd1e4b4p+0, 0x1.46d7a3430da90p+0, 0x1.1f72aed10eca8p+2,
};

/* 1 - beta eps in eps, 0 <= eps <= 0.395: error below 2^-13 */
static const double cor_hc_limit_polynomial[9] = {
    0x1.882f1ac73cc80p-15, -0x1.3286b9fbfa929p-6, 0x1.1b1cfd4ab5fcap+0, -0x1.5b456325dd99fp+4, 0x1.4dba223953fefp+7,
    -0x1.c14a9d66174eap+8, 0x1.52fa4cec1d494p+8,  0x1.e080fe12750edp+8, -0x1.5f1088449fdf0p+9,
};

/* ((atanh(s)/s - 1)/s^2 - 1/3)/s^2 in s^2, 0 <= s^2 <= 0.25: the error times s^2 is below 2^-55. */
static const double cor_hc_atanh_polynomial[13] = {
    0x1.999999999999cp-3, 0x1.24924924915c0p-3,  0x1.c71c71c8b9cc2p-4, 0x1.745d16b8b59b2p-4, 0x1.3b13ca2b8cd7ep-4,
    0x1.110e7464e2d34p-4, 0x1.e23b4de0e39f5p-5,  0x1.ab2e18804535ep-5, 0x1.a4c937c1e7826p-5, 0x1.8839e0c4ed244p-6,
    0x1.b6598f3bb947cp-4, -0x1.a952459125d8ap-4, 0x1.7bc13387f454dp-3,
};

/* s/x where 1 - eps^2 = x with damping during the approach only, 0 <= x <= 0.5494: relative error 2^-30 */
static const double cor_hc_approach_polynomial[9] = {
    0x1.7ffffffdad735p-1,  0x1.2000055608434p-2,  0x1.59919eabe74e3p-5, -0x1.83aa877d3790bp-6, -0x1.974af9a62df42p-6,
    -0x1.470a43c3b667dp-7, -0x1.c6293a827e49dp-7, 0x1.6160b738dccdfp-7, -0x1.39955dc23700cp-7,
};

/* ---- y from beta, up to y = 1.5 ---- */

/* c = y coth(y) - 1 as a pair, |y| <= 1.5: relative error 2^-55; and dc/dy = y - c (1 + c)/y, rounded */
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

/* y as head + step, where the head is a double within 2^-28 beta^2 of y */
struct cor_hc_root {
    double head, step;
};

/* 2^-30 <= beta <= 2.157. The start value is beta - c with a relative error of 2^-29 in c, so that beta - y has the
 * same relative error. */
COR_KERNEL struct cor_hc_root cor_hc_root_near(double beta)
{
    const double *p = cor_hc_start_polynomial;
    const double s = beta / (2 + beta), s2 = s * s, s4 = s2 * s2;
    struct cor_hc_root y;
    y.head = beta - beta * beta * (COR_POLYNOMIAL_8(p, s, s2, s4) + (p[8] + p[9] * s) * (s4 * s4));
    const struct cor_hc_coth at = cor_hc_coth_near(y.head);
    y.step = (((beta - y.head) - at.c.hi) - at.c.lo) / (1 + at.slope);
    return y;
}

/* 1 - beta eps = -W_0(-x), x = (1 + beta) exp(-1 - beta), beta >= 2.157: error 2^-54 */
COR_KERNEL double cor_hc_rest(double beta)
{
    const double *p = cor_hc_lambert_polynomial;
    const double b = cor_kernel_min(beta, 800), plus = 1 + b; /* past 800 x is 0 */
    const double x = plus * cor_kernel_exp_minus(cor_pair(plus, b - (plus - 1))), x2 = x * x, x4 = x2 * x2;
    const double end = COR_POLYNOMIAL_4(p + 8, x, x2) + ((p[12] + p[13] * x) + p[14] * x2) * x4;
    return x + x2 * (COR_POLYNOMIAL_8(p, x, x2, x4) + end * (x4 * x4));
}

/* ---- eps and 1 - eps ---- */

/* h and beta - h as pairs */
struct cor_hc_speeds {
    struct cor_inline_pair rebound, lost;
};

/* COR_HC_TINY <= beta < COR_HC_BETA_NEAR, from y = cor_hc_root_near(beta) */
COR_KERNEL struct cor_hc_speeds cor_hc_speeds_weak(struct cor_hc_root y, double beta)
{
    struct cor_hc_speeds speeds;
    speeds.rebound = cor_pair(2 * y.head - beta, 2 * y.step);
    speeds.lost = cor_pair(2 * (beta - y.head), -2 * y.step);
    return speeds;
}

/* COR_HC_BETA_NEAR <= beta <= COR_HC_LARGEST, from rest = cor_hc_rest(beta) */
COR_KERNEL struct cor_hc_speeds cor_hc_speeds_strong(double rest, double beta)
{
    struct cor_hc_speeds speeds;
    speeds.rebound = cor_pair(1, -rest);
    speeds.lost = cor_pair_two_sum(beta, -1);
    speeds.lost.lo += rest;
    return speeds;
}

/* Which of the two functions holds. Array loops divide their numbers accordingly. */
COR_KERNEL int cor_hc_is_weak(double beta)
{
    return beta < COR_HC_BETA_NEAR;
}

COR_KERNEL double cor_hc_eps_of(struct cor_hc_speeds speeds, double beta)
{
    return cor_pair_over(speeds.rebound, cor_pair(beta, 0)).hi;
}

COR_KERNEL double cor_hc_loss_of(struct cor_hc_speeds speeds, double beta)
{
    return cor_pair_over(speeds.lost, cor_pair(beta, 0)).hi;
}

COR_KERNEL struct cor_hc_speeds cor_hc_speeds(double beta)
{
    return cor_hc_is_weak(beta) ? cor_hc_speeds_weak(cor_hc_root_near(beta), beta)
                                : cor_hc_speeds_strong(cor_hc_rest(beta), beta);
}

/* 2/3 beta - 4/9 beta^2 + 44/135 beta^3, |beta| < COR_HC_TINY */
COR_INLINE double cor_hc_loss_tiny(double beta)
{
    const double b = beta * COR_INLINE_2_200;
    const struct cor_inline_pair p = cor_inline_product(b, 2 * COR_HC_THIRD);
    const double more = b * (2 * COR_HC_THIRD_TAIL - beta * (4.0 / 9 - beta * (44.0 / 135)));
    return (p.hi + (p.lo + more)) * COR_INLINE_2_M200;
}

/* A collision with negative damping, beta = -b: y - c = b, and b eps is y + c. The function holds up to b = 0.7, y =
 * 1.1, and applies Newton's method from y = b. */
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

/* z - ln(1 + z) as a pair, for z > -1 away from 0 */
COR_INLINE struct cor_inline_pair cor_hc_energy(double z)
{
    return cor_pair_plus(cor_pair(z, 0), cor_kernel_minus_log(cor_pair_two_sum(1, z)));
}

/* For larger b, t = b eps has the same energy as -b. Newton's method starts from above, where the function is
 * convex. */
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

COR_INLINE double cor_hc_eps(double beta)
{
    if (beta >= COR_HC_TINY && beta <= COR_HC_LARGEST)
        return cor_hc_eps_of(cor_hc_speeds(beta), beta);
    if (!(beta > -1))
        return (double)NAN;
    if (fabs(beta) < COR_HC_TINY)
        return 1 - cor_hc_loss_tiny(beta);
    if (beta > 0)
        return isinf(beta) ? 0 : 1 / beta;
    return cor_pair_over(cor_hc_speeds_pumped(-beta).rebound, cor_pair(-beta, 0)).hi;
}

COR_INLINE double cor_hc_loss(double beta)
{
    if (beta >= COR_HC_TINY && beta <= COR_HC_LARGEST)
        return cor_hc_loss_of(cor_hc_speeds(beta), beta);
    if (!(beta > -1))
        return (double)NAN;
    if (fabs(beta) < COR_HC_TINY)
        return cor_hc_loss_tiny(beta);
    return beta > 0 ? 1 : cor_pair_over(cor_hc_speeds_pumped(-beta).lost, cor_pair(-beta, 0)).hi;
}

/* ---- the inverse ---- */

/* beta from eps and loss = 1 - eps, both as pairs, eps >= COR_HC_EPS_NEAR: coth(y) - 1/y = loss/(1 + eps) = t. The
 * function solves c = t y, and beta = 2 y/(1 + eps). */
COR_KERNEL struct cor_inline_pair cor_hc_of_langevin(struct cor_inline_pair eps, struct cor_inline_pair loss)
{
    const double *p = cor_hc_langevin_polynomial;
    struct cor_inline_pair plus = cor_pair_two_sum(1, eps.hi);
    plus.lo += eps.lo;
    const double inverse = 1 / plus.hi;
    const struct cor_inline_pair t = cor_pair_over_with(loss, plus, inverse);
    const double x = t.hi * t.hi, x2 = x * x;
    const double y = t.hi * (COR_POLYNOMIAL_4(p, x, x2) + ((p[4] + p[5] * x) + p[6] * x2) * (x2 * x2));
    const struct cor_hc_coth at = cor_hc_coth_near(y);
    const struct cor_inline_pair wanted = cor_inline_product(t.hi, y);
    const double off = (wanted.hi - at.c.hi) + ((wanted.lo - at.c.lo) + t.lo * y);
    return cor_pair_over_with(cor_pair(2 * y, 2 * (off / (at.slope - t.hi))), plus, inverse);
}

/* A step of Newton's method for beta eps + w = 1, w = -W_0(-x) = cor_hc_rest(beta), w' = -w/(1-w) beta/(1+beta) */
COR_KERNEL double cor_hc_limit_step(double beta, double w, struct cor_inline_pair eps)
{
    const double slope = eps.hi - (w / (1 - w)) * (beta / (1 + beta));
    const struct cor_inline_pair p = cor_inline_product(beta, eps.hi);
    return (((p.hi - 1) + w) + (p.lo + beta * eps.lo)) / slope;
}

/* About beta from eps, 2^-900 <= eps <= COR_HC_EPS_NEAR, for a step at beta or, if more, at COR_HC_LIMIT_LEAST */
#define COR_HC_LIMIT_LEAST 2.15
COR_KERNEL double cor_hc_limit_start(double eps)
{
    const double *p = cor_hc_limit_polynomial;
    const double e2 = eps * eps, e4 = e2 * e2;
    return (1 - (COR_POLYNOMIAL_8(p, eps, e2, e4) + p[8] * (e4 * e4))) / eps;
}

/* beta from such an eps */
COR_INLINE double cor_hc_of_limit(struct cor_inline_pair eps)
{
    double beta = cor_hc_limit_start(eps.hi), at = cor_kernel_max(beta, COR_HC_LIMIT_LEAST);
    for (int k = 0; k < 2; k++) {
        beta -= cor_hc_limit_step(at, cor_hc_rest(at), eps);
        at = beta;
    }
    return beta;
}

/* Whether the first function holds for this eps */
COR_KERNEL int cor_hc_is_langevin(double eps)
{
    return eps >= COR_HC_EPS_NEAR;
}

/* 1 - x as a pair, 0 <= x < 1 */
COR_KERNEL struct cor_inline_pair cor_hc_one_minus(double x)
{
    const double rest = 1 - x;
    return cor_pair(rest, (1 - rest) - x);
}

COR_INLINE double cor_hc_beta(double eps)
{
    if (eps >= COR_INLINE_2_M900 && eps < 1)
        return cor_hc_is_langevin(eps) ? cor_hc_of_langevin(cor_pair(eps, 0), cor_hc_one_minus(eps)).hi
                                       : cor_hc_of_limit(cor_pair(eps, 0));
    if (!(eps >= 0 && eps <= 1))
        return (double)NAN;
    if (eps == 1)
        return 0;
    return eps <= 5.56268464626800345772e-309 ? (double)INFINITY : 1 / eps; /* 2^-1024 */
}

COR_INLINE double cor_hc_beta_of_loss(double loss)
{
    if (loss >= COR_INLINE_2_M200 && loss < 1)
        return cor_hc_is_langevin(1 - loss) ? cor_hc_of_langevin(cor_hc_one_minus(loss), cor_pair(loss, 0)).hi
                                            : cor_hc_of_limit(cor_hc_one_minus(loss));
    if (!(loss >= 0 && loss <= 1))
        return (double)NAN;
    return loss == 1 ? (double)INFINITY : 1.5 * loss;
}

/* ---- damping during the approach only ----
 *
 * eps = sqrt(2 f(beta))/beta. With s = beta/(2 + beta), 1 - eps^2 = s (1 + (1 - s)^2 K(s^2)), K(s^2) = (atanh(s)/s -
 * 1)/s^2. */

/* s (1 + (1 - s)^2 K(s^2)), |s.hi| <= 1/2: relative error 2^-54 */
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

/* 1 - eps^2, -2/3 <= beta <= 2 */
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

COR_KERNEL double cor_hc_eps_approach_only_near(double beta)
{
    const struct cor_inline_pair eps = cor_hc_eps_of_square_loss(cor_hc_approach_near(beta));
    return eps.hi + eps.lo;
}

COR_KERNEL double cor_hc_loss_approach_only_near(double beta)
{
    const struct cor_inline_pair lost = cor_hc_approach_near(beta), eps = cor_hc_eps_of_square_loss(lost);
    return cor_pair_over(lost, cor_pair_plus(cor_pair(1, 0), eps)).hi;
}

/* eps as a pair, -1 < beta < inf: sqrt(2 f)/|beta| away from 0. Beyond 2^500 the logarithm in f is negligible. */
COR_INLINE struct cor_inline_pair cor_hc_eps_approach_pair(double beta)
{
    if (fabs(beta) < COR_HC_APPROACH_LEAST)
        return cor_pair(1, -beta * COR_HC_THIRD);
    if (fabs(beta) <= (beta < 0 ? 2.0 / 3 : COR_HC_APPROACH_NEAR))
        return cor_hc_eps_of_square_loss(cor_hc_approach_near(beta));
    if (beta <= COR_INLINE_2_500)
        return cor_pair_over(cor_pair_root(cor_pair_scaled(cor_hc_energy(beta), 2)), cor_pair(fabs(beta), 0));
    const double b = beta * COR_INLINE_2_M500;
    const struct cor_inline_pair scaled = cor_pair_over(cor_pair_root(cor_pair(2 * b, 0)), cor_pair(b, 0));
    return cor_pair_scaled(scaled, COR_INLINE_2_M500 * COR_INLINE_2_250);
}

COR_INLINE double cor_hc_eps_approach_only(double beta)
{
    if (!(beta > -1))
        return (double)NAN;
    if (isinf(beta))
        return 0;
    const struct cor_inline_pair eps = cor_hc_eps_approach_pair(beta);
    return eps.hi + eps.lo;
}

COR_INLINE double cor_hc_loss_approach_only(double beta)
{
    if (!(beta > -1))
        return (double)NAN;
    if (fabs(beta) < COR_HC_APPROACH_LEAST)
        return beta / 3;
    if (fabs(beta) <= (beta < 0 ? 2.0 / 3 : COR_HC_APPROACH_NEAR))
        return cor_hc_loss_approach_only_near(beta);
    if (isinf(beta))
        return 1;
    const struct cor_inline_pair eps = cor_hc_eps_approach_pair(beta), less = cor_pair_two_sum(1, -eps.hi);
    return less.hi + (less.lo - eps.lo);
}

/* beta from x = 1 - eps^2 as a pair, 0 < x.hi <= 0.5494: a step of Newton's method for s, dx/ds = 2 (2 s/(1 + s) -
 * x)/(s (1 - s)) */
COR_INLINE double cor_hc_of_approach_near(struct cor_inline_pair x)
{
    const double *p = cor_hc_approach_polynomial;
    const double t = x.hi, t2 = t * t, t4 = t2 * t2;
    const double s = t * (COR_POLYNOMIAL_8(p, t, t2, t4) + p[8] * (t4 * t4));
    const struct cor_inline_pair at = cor_hc_square_loss(cor_pair(s, 0));
    const double off = (x.hi - at.hi) + (x.lo - at.lo);
    const double step = off * s * (1 - s) / (2 * (2 * s / (1 + s) - t));
    const struct cor_inline_pair below = cor_pair_two_sum(1, -s);
    return cor_pair_over(cor_pair(2 * s, 2 * step), cor_pair(below.hi, below.lo - step)).hi;
}

/* beta from eps < COR_HC_EPS_APPROACH_NEAR: Newton's method for eps^2 beta^2/2 = beta - ln(1 + beta), from 2/eps^2,
 * which is above the root of a convex function. */
COR_INLINE double cor_hc_of_approach_far(struct cor_inline_pair eps)
{
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

/* Where eps is near 1, x = loss (1 + eps). */
COR_INLINE double cor_hc_of_approach(struct cor_inline_pair eps, struct cor_inline_pair loss)
{
    if (eps.hi < COR_HC_EPS_APPROACH_NEAR)
        return cor_hc_of_approach_far(eps);
    return cor_hc_of_approach_near(cor_inline_pair_times(loss, cor_pair_plus(cor_pair(1, 0), eps)));
}

COR_INLINE double cor_hc_beta_approach_only(double eps)
{
    if (!(eps >= 0 && eps <= 1))
        return (double)NAN;
    if (eps == 1)
        return 0;
    const double loss = 1 - eps;
    return cor_hc_of_approach(cor_pair(eps, 0), cor_pair(loss, (1 - loss) - eps));
}

COR_INLINE double cor_hc_beta_of_loss_approach_only(double loss)
{
    if (!(loss >= 0 && loss <= 1))
        return (double)NAN;
    if (loss < COR_INLINE_2_M200)
        return 3 * loss;
    const double eps = 1 - loss;
    return loss == 1 ? (double)INFINITY : cor_hc_of_approach(cor_pair(eps, (1 - eps) - loss), cor_pair(loss, 0));
}

/* ---- the largest overlap ---- */

/* ((a + 1)/2 eps^2)^(1/(a + 1)) with eps of damping during the approach only, 0 <= a < inf */
COR_INLINE double cor_hc_max_overlap(double beta, double elastic_exponent)
{
    const double a = elastic_exponent;
    if (!(beta > -1 && a >= 0) || isinf(a))
        return (double)NAN;
    if (isinf(beta))
        return 0;
    const struct cor_inline_pair plus = cor_pair_two_sum(1, a);
    const struct cor_inline_pair half = cor_kernel_minus_log(cor_pair_scaled(plus, 0.5));
    const struct cor_inline_pair eps = cor_kernel_minus_log(cor_hc_eps_approach_pair(beta));
    const struct cor_inline_pair x = cor_pair_over(cor_pair_plus(half, cor_pair_scaled(eps, 2)), plus);
    return cor_kernel_exp_minus_pair(x).hi;
}

#endif
