/* SPDX-License-Identifier: MIT */
/* The laws whose restitution is a function of only the damping ratio zeta: the linear dashpot, Tsuji's damping, and
 * every law (a, b) with b = (a-1)/2 (docs/laws.md). L is -ln(eps) for an end of contact. All functions below use
 *
 *     A(zeta) = acos(zeta)/sqrt(1 - zeta^2),   1 for zeta = 1,   acosh(zeta)/sqrt(zeta^2 - 1) for zeta > 1
 *     L = 2 zeta A(zeta) at zero force, zeta A(zeta) with damping during the approach only, pi zeta/sqrt(1 - zeta^2) at
 *     zero overlap; L of the limited damper is below
 *
 * This file computes the times, and eps and its inverse at arguments for which closed_form.h has no row. Kernels, named
 * ..._near, are valid on an interval and have neither jumps nor calls, so that the array loops can use them. The other
 * functions accept every double and give the same bits. */
#ifndef COR_RUNTIME_LAW_DAMPING_RATIO_H
#define COR_RUNTIME_LAW_DAMPING_RATIO_H

#include "runtime/number/elementary.h"

/* 1/(2 sqrt(2)) as a pair */
#define COR_RATIO_FAR_LIMITED 3.53553390593273786369e-01
#define COR_RATIO_FAR_LIMITED_TAIL (-2.41682332836322825930e-17)

/* Below this zeta, products lose bits to underflow, and eps is 1 - L to the last bit. */
#define COR_RATIO_TINY COR_INLINE_2_M900
/* The kernels of A(zeta) are valid up to this zeta. */
#define COR_RATIO_FORCE_NEAR 3.0
#define COR_RATIO_BELOW_ONE 0.99999999999999988898

/* ---- polynomials: see runtime/number/elementary.h ---- */

/* (atan(sqrt(x))/sqrt(x) - 1)/x for |x| <= 0.1717, with atanh(sqrt(-x))/sqrt(-x) in place of atan(...) for negative x:
 * the error times x is below 2^-57. */
static const double cor_ratio_phase_polynomial[15] = {
    -0x1.5555555555555p-2, 0x1.99999999999afp-3,  -0x1.24924924924a7p-3, 0x1.c71c71c70f323p-4,  -0x1.745d1745c4f4ap-4,
    0x1.3b13b14dfe309p-4,  -0x1.11111122e99c3p-4, 0x1.e1e1ca19159f1p-5,  -0x1.af285559e06b4p-5, 0x1.86200a4ff267fp-5,
    -0x1.6433bf55059f4p-5, 0x1.465d4d647d49dp-5,  -0x1.2e2a9afa53366p-5, 0x1.37a54854bab11p-5,  -0x1.23c3ceb732c8fp-5,
};

/* ---- A(zeta), up to zeta = 3 ---- */

/* Returns numerator h(u)/(c (1 + c)), with a relative error of 2^-55 for zeta <= COR_RATIO_FORCE_NEAR. If the
 * numerator is 2, the result is A(zeta).
 *
 * c = sqrt((1 + zeta)/2) is the cosine of half the phase at the turning point, u = (1 - c)/(1 + c) = (c - c^2)/(c +
 * c^2) is between -0.172 and 0.172, and h(u) = atan(sqrt(u))/sqrt(u) is analytic at zeta = 1, where u = 0. */
COR_KERNEL struct cor_inline_pair cor_ratio_phase_near(struct cor_inline_pair zeta, struct cor_inline_pair numerator)
{
    const double *p = cor_ratio_phase_polynomial;
    const double sum = 1 + zeta.hi; /* the rounding error is a double for every zeta.hi below 2^53 */
    const struct cor_inline_pair square = cor_pair(0.5 * sum, 0.5 * ((zeta.hi - (sum - 1)) + zeta.lo));
    const double c = sqrt(square.hi);
    struct cor_inline_pair d = cor_pair_two_sum(c, square.hi); /* c + c^2 */
    const double inverse = 1 / d.hi;
    const double c_lo = cor_pair_root_with(square, c, inverse * (1 + c)).lo;
    d.lo += c_lo + square.lo;

    const double u = ((c - square.hi) + (c_lo - square.lo)) * inverse, u2 = u * u, u4 = u2 * u2;
    const double end = COR_POLYNOMIAL_4(p + 8, u, u2) + ((p[12] + p[13] * u) + p[14] * u2) * u4;
    const double rest = u * (COR_POLYNOMIAL_8(p, u, u2, u4) + end * (u4 * u4)); /* h(u) - 1 */
    const struct cor_inline_pair q = cor_pair_over_with(numerator, d, inverse);
    return cor_inline_sum(q.hi, q.lo + q.hi * rest);
}

/* Returns L at zero force. */
COR_KERNEL struct cor_inline_pair cor_ratio_force_near(double zeta)
{
    return cor_ratio_phase_near(cor_pair(zeta, 0), cor_pair(4 * zeta, 0));
}

/* ---- A(zeta) beyond 3 ---- */

/* With zeta = cosh(theta): theta and decay = exp(-theta) = zeta - sqrt(zeta^2 - 1) as pairs, and excess = theta
 * (coth(theta) - 1), which is small, as a rounded double. L at zero force is 2 (theta + excess). */
struct cor_ratio_far {
    struct cor_inline_pair decay, theta, root; /* root: sqrt(zeta^2 - 1) */
    double excess;
};

/* Fills the struct for 2.8 <= zeta <= 2^500. */
COR_INLINE struct cor_ratio_far cor_ratio_far(struct cor_inline_pair zeta)
{
    struct cor_ratio_far far;
    const struct cor_inline_pair one = cor_pair(1, 0);
    if (zeta.hi < COR_INLINE_2_100) {
        const struct cor_inline_pair square = cor_pair_plus(cor_inline_pair_times(zeta, zeta), cor_pair(-1, 0));
        far.root = cor_pair_root(square);
        far.decay = cor_pair_over(one, cor_pair_plus(zeta, far.root));
    } else {
        far.root = zeta;
        far.decay = cor_pair_over(cor_pair(0.5, 0), zeta);
    }
    far.theta = cor_kernel_minus_log(far.decay);
    const double square = far.decay.hi * far.decay.hi;
    far.excess = far.theta.hi * (2 * square / (1 - square));
    return far;
}

/* The functions ..._beyond accept every double for which the tables of closed_form.h have no row. */

/* Returns eps at zero force, zeta >= 3. Beyond 2^540 it is below half the smallest double. */
COR_INLINE double cor_ratio_eps_force_far(double zeta)
{
    if (zeta > COR_INLINE_2_100) { /* eps is 1/(4 zeta^2) to the last bit, computed in units of 2^-800 */
        if (zeta > COR_INLINE_2_500 * COR_INLINE_2_40)
            return 0;
        const double scaled = zeta * (COR_INLINE_2_M200 * COR_INLINE_2_M200);
        const struct cor_inline_pair half = cor_pair_over(cor_pair(0.5, 0), cor_pair(scaled, 0));
        return cor_inline_pair_times(half, half).hi * (COR_INLINE_2_M200 * COR_INLINE_2_M200) *
               (COR_INLINE_2_M200 * COR_INLINE_2_M200);
    }
    const struct cor_ratio_far far = cor_ratio_far(cor_pair(zeta, 0));
    const struct cor_inline_pair correction = cor_kernel_exp_minus_pair(cor_pair(2 * far.excess, 0));
    return cor_inline_pair_times(cor_inline_pair_times(far.decay, far.decay), correction).hi;
}

COR_INLINE double cor_ratio_eps_beyond_zero_force(double zeta)
{
    return zeta > 0 ? cor_ratio_eps_force_far(zeta) : zeta == 0 ? 1 : (double)NAN;
}

COR_INLINE double cor_ratio_eps_beyond_approach_only(double zeta)
{
    if (!(zeta > 0))
        return zeta == 0 ? 1 : (double)NAN;
    if (zeta > COR_INLINE_2_100)
        return 0.5 / zeta;
    const struct cor_ratio_far far = cor_ratio_far(cor_pair(zeta, 0));
    return cor_inline_pair_times(far.decay, cor_kernel_exp_minus_pair(cor_pair(far.excess, 0))).hi;
}

/* ---- zero overlap ---- */

/* Returns 1 - zeta^2 as (1 - zeta)(1 + zeta), both factors exact: relative error 2^-104 however close zeta is to 1. */
COR_KERNEL struct cor_inline_pair cor_ratio_omega_square(double zeta)
{
    const double minus = 1 - zeta, plus = 1 + zeta;
    return cor_inline_pair_times(cor_pair(minus, (1 - minus) - zeta), cor_pair(plus, zeta - (plus - 1)));
}

/* Returns numerator/omega from omega^2. */
COR_KERNEL struct cor_inline_pair cor_ratio_over_root(struct cor_inline_pair numerator, struct cor_inline_pair square)
{
    const double root = sqrt(square.hi), inverse = 1 / root;
    return cor_pair_over_with(numerator, cor_pair_root_with(square, root, inverse), inverse);
}

/* Returns numerator/sqrt(1 - zeta^2), zeta < 1. */
COR_KERNEL struct cor_inline_pair cor_ratio_over_omega(double zeta, struct cor_inline_pair numerator)
{
    return cor_ratio_over_root(numerator, cor_ratio_omega_square(zeta));
}

/* Returns L, but at most 1400, because eps is 0 there. For smaller L, 1 - zeta^2 exceeds 2^-18, so its error of 2^-104
 * is negligible. */
COR_KERNEL struct cor_inline_pair cor_ratio_overlap_near(double zeta)
{
    const struct cor_inline_pair square = cor_inline_product(zeta, zeta);
    const double less = 1 - square.hi;
    struct cor_inline_pair rest = cor_inline_sum(less, ((1 - less) - square.hi) - square.lo), phase;
    rest.hi = cor_kernel_max(rest.hi, 1.0 / 262144);
    phase = cor_inline_product(COR_PI, zeta);
    phase.lo += COR_PI_TAIL * zeta;
    struct cor_inline_pair exponent = cor_ratio_over_root(phase, rest);
    exponent.hi = cor_kernel_min(exponent.hi, 1400);
    return exponent;
}

COR_INLINE double cor_ratio_eps_beyond_zero_overlap(double zeta)
{
    if (zeta > 0 && zeta < 1)
        return cor_kernel_exp_minus(cor_ratio_overlap_near(zeta));
    return zeta == 0 ? 1 : zeta >= 1 ? 0 : (double)NAN;
}

/* Returns L/sqrt(pi^2 + L^2). */
COR_KERNEL double cor_ratio_of_overlap(struct cor_inline_pair exponent)
{
    const struct cor_inline_pair pi = cor_pair(COR_PI, COR_PI_TAIL);
    const struct cor_inline_pair square =
        cor_pair_plus(cor_inline_pair_times(pi, pi), cor_inline_pair_times(exponent, exponent));
    const double root = sqrt(square.hi), inverse = 1 / root;
    return cor_pair_over_with(exponent, cor_pair_root_with(square, root, inverse), inverse).hi;
}

COR_INLINE double cor_ratio_zeta_beyond_zero_overlap(double eps)
{
    if (eps >= COR_RATIO_TINY && eps <= 1)
        return cor_ratio_of_overlap(cor_kernel_minus_log(cor_pair(eps, 0)));
    if (!(eps >= 0 && eps <= 1))
        return (double)NAN;
    if (eps == 0)
        return 1;
    struct cor_inline_pair exponent = cor_kernel_minus_log(cor_pair(eps * COR_INLINE_2_200, 0));
    exponent = cor_pair_plus(exponent, cor_pair(200 * COR_KERNEL_LN2_HEAD, 200 * COR_KERNEL_LN2_TAIL));
    return cor_ratio_of_overlap(exponent);
}

/* ---- the limited damper: the damping force is at most the elastic one ----
 *
 * Let v = x' and u = x^((a+1)/2). While beta v > u, the force is twice the elastic force. From beta v = u onward the
 * law holds unchanged. The force vanishes after another phase psi, where cos(psi) = (4 zeta^2 - 1)/R and R = sqrt(1 + 8
 * zeta^2). Then L = zeta psi/sqrt(1 - zeta^2). In terms of psi/2 this is
 *
 *     L = (R + 1)/(R + 3) 2 C A(C),     C = cos(psi/2) = zeta sqrt(2 (R + 3)/(R (R + 1)))
 */

struct cor_ratio_limited {
    struct cor_inline_pair c, slope, share, root; /* C, C/zeta, (R + 1)/(R + 3), R */
};

/* Fills the struct for zeta <= 2^64. */
COR_KERNEL struct cor_ratio_limited cor_ratio_limited_parts(double zeta)
{
    const struct cor_inline_pair p = cor_inline_product(zeta, zeta);
    struct cor_inline_pair square = cor_pair_two_sum(1, 8 * p.hi); /* R^2 */
    square.lo += 8 * p.lo;
    const double r = sqrt(square.hi);
    const struct cor_inline_pair root = cor_pair_root_with(square, r, 1 / r);
    const struct cor_inline_pair plus_1 = cor_pair_plus(root, cor_pair(1, 0)),
                                 plus_3 = cor_pair_plus(root, cor_pair(3, 0));
    const struct cor_inline_pair below = cor_pair_plus(square, root); /* R (R + 1) */
    const double inverse = 1 / (below.hi * plus_3.hi);
    const struct cor_inline_pair ratio =
        cor_pair_over_with(cor_pair_scaled(plus_3, 2), below, inverse * plus_3.hi); /* (C/zeta)^2 */
    const double slope = sqrt(ratio.hi);
    struct cor_ratio_limited parts;
    parts.slope = cor_pair_root_with(ratio, slope, 0.5 * slope * below.hi * (below.hi * inverse));
    parts.c = cor_inline_pair_times(parts.slope, cor_pair(zeta, 0));
    parts.share = cor_pair_over_with(plus_1, plus_3, inverse * below.hi);
    parts.root = root;
    return parts;
}

/* Returns eps for zeta > 11 as a pair; above 2^64 it is 1/(2 sqrt(2) zeta). L is 2 C A(C) (1 - 2/(R + 3)). */
COR_INLINE struct cor_inline_pair cor_ratio_eps_limited_far(double zeta)
{
    if (zeta > COR_INLINE_2_40 * 16777216.0) {
        const int huge = zeta > COR_INLINE_2_900; /* scaling prevents underflow of the pair's lower half */
        const double z = huge ? zeta * COR_INLINE_2_M200 : zeta;
        return cor_pair_scaled(
            cor_pair_over(cor_pair(COR_RATIO_FAR_LIMITED, COR_RATIO_FAR_LIMITED_TAIL), cor_pair(z, 0)),
            huge ? COR_INLINE_2_M200 : 1);
    }
    const struct cor_ratio_limited parts = cor_ratio_limited_parts(zeta);
    const struct cor_ratio_far far = cor_ratio_far(parts.c);
    const double gain = 4 * (far.theta.hi + far.excess) / (parts.root.hi + 3) - 2 * far.excess;
    return cor_inline_pair_times(cor_inline_pair_times(far.decay, far.decay),
                                 cor_kernel_exp_minus_pair(cor_pair(-gain, 0)));
}

COR_INLINE double cor_ratio_eps_beyond_limited(double zeta)
{
    if (zeta > 0 && !isinf(zeta))
        return cor_ratio_eps_limited_far(zeta).hi;
    return zeta == 0 ? 1 : zeta > 0 ? 0 : (double)NAN;
}

COR_INLINE double cor_ratio_loss_beyond_zero_overlap(double zeta)
{
    return zeta == 0 ? 0 : 1 - cor_ratio_eps_beyond_zero_overlap(zeta);
}

COR_INLINE double cor_ratio_loss_beyond_zero_force(double zeta)
{
    return zeta == 0 ? 0 : 1 - cor_ratio_eps_beyond_zero_force(zeta);
}

COR_INLINE double cor_ratio_loss_beyond_approach_only(double zeta)
{
    return zeta == 0 ? 0 : 1 - cor_ratio_eps_beyond_approach_only(zeta);
}

COR_INLINE double cor_ratio_loss_beyond_limited(double zeta)
{
    return zeta == 0 ? 0 : 1 - cor_ratio_eps_beyond_limited(zeta);
}

/* ---- inverses beyond the rows ---- */

/* Returns zeta with zeta A(zeta) = x > 1.8. decay: exp(-x) as a pair. zeta = cosh(theta) with theta = x - delta.
 * Newton's method solves delta = 2 x E/(1 + E), where E = exp(-2 theta) = exp(-2 x) exp(2 delta), starting from
 * delta = 2 x exp(-2 x) < 0.1. */
COR_INLINE double cor_ratio_of_phase_far(double x, struct cor_inline_pair decay)
{
    const double least = decay.hi * decay.hi;
    double delta = 2 * x * least;
    for (int k = 0; k < 6; k++) {
        const double e = least * cor_kernel_exp_minus_pair(cor_pair(-2 * delta, 0)).hi;
        const double next = 2 * x * (e / (1 + e)), step = (next - delta) / (1 - 2 * next / (1 + e));
        delta += step;
        if (fabs(step) < 1e-9)
            break;
    }
    /* exp(theta) (1 + E)/2 */
    const double e = delta / (2 * x - delta);
    const struct cor_inline_pair growth = cor_pair_over(cor_pair(0.5, 0), decay);
    struct cor_inline_pair correction = cor_kernel_exp_minus_pair(cor_pair(delta, 0));
    correction = cor_inline_sum(correction.hi, correction.lo + correction.hi * e);
    return cor_inline_pair_times(growth, correction).hi;
}

COR_INLINE double cor_ratio_zeta_beyond_zero_force(double eps)
{
    if (!(eps >= 0 && eps <= 1))
        return (double)NAN;
    if (eps == 0)
        return (double)INFINITY;
    /* exp(-x) is the square root of eps */
    const int tiny = eps < COR_RATIO_TINY;
    const struct cor_inline_pair e = cor_pair(tiny ? eps * (COR_INLINE_2_100 * COR_INLINE_2_100) : eps, 0);
    struct cor_inline_pair x = cor_kernel_minus_log(e);
    x.hi += tiny ? 200 * COR_LN2 : 0;
    const struct cor_inline_pair root = cor_pair_scaled(cor_pair_root(e), tiny ? 1 / COR_INLINE_2_100 : 1);
    return cor_ratio_of_phase_far(0.5 * x.hi, root);
}

COR_INLINE double cor_ratio_zeta_beyond_approach_only(double eps)
{
    if (!(eps >= 0 && eps <= 1))
        return (double)NAN;
    if (eps < COR_INLINE_2_M200) /* 1/(2 eps), which may overflow */
        return eps <= 2.78134232313400172885e-309 ? (double)INFINITY : 0.5 / eps;
    const struct cor_inline_pair e = cor_pair(eps, 0);
    return cor_ratio_of_phase_far(cor_kernel_minus_log(e).hi, e);
}

/* Returns L' = dL/dzeta of the limited damper from L, by W L' = L/zeta - N with W = 1 - zeta^2 and N = 4 zeta (1 + 2
 * zeta^2)/(1 + 8 zeta^2). */
COR_INLINE double cor_ratio_limited_slope(double zeta, double exponent)
{
    const double square = zeta * zeta;
    return (exponent / zeta - 4 * zeta * (1 + 2 * square) / (1 + 8 * square)) / ((1 - zeta) * (1 + zeta));
}

/* Newton's method in ln(zeta) converges quickly, because zeta eps 2 sqrt(2) tends to 1. */
COR_INLINE double cor_ratio_zeta_beyond_limited(double eps)
{
    if (!(eps >= 0 && eps <= 1))
        return (double)NAN;
    if (eps < COR_INLINE_2_M200) { /* 1/(2 sqrt(2) eps) may overflow, so it is computed in units of 2^500 */
        if (eps == 0 || eps < 1.96670601748920e-309) /* the bound is subnormal, so the processor may take it as 0 */
            return (double)INFINITY;
        const struct cor_inline_pair scaled = cor_pair(eps * (COR_INLINE_2_500), 0);
        return cor_pair_over(cor_pair(COR_RATIO_FAR_LIMITED, COR_RATIO_FAR_LIMITED_TAIL), scaled).hi * COR_INLINE_2_500;
    }
    double zeta = COR_RATIO_FAR_LIMITED / eps;
    for (int k = 0; k < 8; k++) {
        const struct cor_inline_pair at = cor_ratio_eps_limited_far(zeta);
        const double off = ((at.hi - eps) + at.lo) / at.hi; /* to first order ln(at/eps) */
        const double slope =
            zeta < COR_INLINE_2_40 ? zeta * cor_ratio_limited_slope(zeta, cor_kernel_minus_log(at).hi) : 1;
        zeta += zeta * (off * (1 + 0.5 * off) / slope);
        if (fabs(off) < 1e-9)
            break;
    }
    return zeta;
}

/* ---- times and the largest overlap ---- */

/* Returns theta for zeta > 3 up to the largest double; for zeta >= 2^100 it is ln(2 zeta). */
COR_INLINE struct cor_inline_pair cor_ratio_theta(double zeta)
{
    if (zeta < COR_INLINE_2_100)
        return cor_ratio_far(cor_pair(zeta, 0)).theta;
    const struct cor_inline_pair down = cor_kernel_minus_log(cor_pair(0.5 / (zeta * COR_INLINE_2_M500), 0));
    return cor_pair_plus(cor_pair(500 * COR_KERNEL_LN2_HEAD, 500 * COR_KERNEL_LN2_TAIL), down);
}

/* Returns A(zeta). */
COR_INLINE struct cor_inline_pair cor_ratio_phase_time(double zeta)
{
    if (zeta <= COR_RATIO_FORCE_NEAR)
        return cor_ratio_phase_near(cor_pair(zeta, 0), cor_pair(2, 0));
    if (isinf(zeta))
        return cor_pair(0, 0);
    const struct cor_inline_pair z = cor_pair(zeta, 0);
    return cor_pair_over(cor_ratio_theta(zeta), zeta < COR_INLINE_2_100 ? cor_ratio_far(z).root : z);
}

/* Returns L at zero force, which is below 1421, for every finite zeta. Below 2^-900 the relative accuracy is lost. */
COR_INLINE struct cor_inline_pair cor_ratio_force_exponent(double zeta)
{
    if (zeta <= COR_RATIO_FORCE_NEAR)
        return cor_ratio_force_near(zeta);
    struct cor_inline_pair half = cor_ratio_theta(zeta);
    if (zeta < COR_INLINE_2_100)
        half = cor_inline_sum(half.hi, half.lo + cor_ratio_far(cor_pair(zeta, 0)).excess);
    return cor_pair_scaled(half, 2);
}

/* Returns L/zeta of the limited damper for zeta < 2^64. For the linear law this is the time of the second part of the
 * contact. */
COR_INLINE struct cor_inline_pair cor_ratio_limited_time(double zeta)
{
    const struct cor_ratio_limited parts = cor_ratio_limited_parts(zeta);
    if (zeta <= 11) /* C = 2.87 */
        return cor_inline_pair_times(parts.share, cor_ratio_phase_near(parts.c, cor_pair_scaled(parts.slope, 4)));
    const struct cor_ratio_far far = cor_ratio_far(parts.c);
    const struct cor_inline_pair half = cor_inline_sum(far.theta.hi, far.theta.lo + far.excess);
    return cor_pair_over(cor_inline_pair_times(parts.share, cor_pair_scaled(half, 2)), cor_pair(zeta, 0));
}

#endif
