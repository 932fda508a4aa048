/* SPDX-License-Identifier: MIT */
/* The laws whose restitution is a function of the damping ratio zeta alone: the linear dashpot, Tsuji's damping, and
 * every law (a, b) with b = (a-1)/2 (docs/laws.md). L is -ln(eps) for an end of contact. All functions below use
 *
 *     A(zeta) = acos(zeta)/sqrt(1 - zeta^2), acosh(zeta)/sqrt(zeta^2 - 1) beyond 1, analytic in between, A(1) = 1
 *     L = 2 zeta A(zeta) at zero force, zeta A(zeta) with damping during the approach only, pi zeta/sqrt(1 - zeta^2) at
 *     zero overlap; L of the limited damper is below
 *
 * Kernels, cor_ratio_..._near, hold on an interval and have neither jumps nor calls; the array loops consist of them.
 * The other functions take every double and give the same bits. */
#ifndef COR_RUNTIME_LAW_DAMPING_RATIO_H
#define COR_RUNTIME_LAW_DAMPING_RATIO_H

#include "runtime/number/elementary.h"

/* pi and pi/2, each as a pair */
#define COR_RATIO_PI 3.14159265358979311600
#define COR_RATIO_PI_TAIL 1.22464679914735317723e-16
#define COR_RATIO_HALF_PI 1.57079632679489655800
#define COR_RATIO_HALF_PI_TAIL 6.12323399573676588613e-17
/* 1/(2 sqrt(2)) as a pair */
#define COR_RATIO_FAR_LIMITED 3.53553390593273786369e-01
#define COR_RATIO_FAR_LIMITED_TAIL (-2.41682332836322825930e-17)

/* Below this zeta, products lose bits to underflow, and eps is 1 - L to the last bit. */
#define COR_RATIO_TINY 1.18305218616677471e-271 /* 2^-900 */
/* Ends of the kernels' intervals. The polynomial ends at zeta = 3, where 2 zeta A(zeta) is 3.7394 and eps is 0.0238, or
 * 0.1541 with damping during the approach only. At zeta = 11 the limited damper's C is 2.87 and its eps 0.0319. */
#define COR_RATIO_FORCE_NEAR 3.0
#define COR_RATIO_LIMITED_NEAR 11.0
#define COR_RATIO_EPS_FORCE_NEAR 0.02385
#define COR_RATIO_EPS_APPROACH_NEAR 0.1545
#define COR_RATIO_EPS_LIMITED_NEAR 0.0319
/* The largest double below 1 */
#define COR_RATIO_BELOW_ONE 0.99999999999999988898

/* ---- polynomials: see runtime/number/elementary.h ---- */

/* (atan(sqrt(x))/sqrt(x) - 1)/x, atanh(sqrt(-x))/sqrt(-x) where x is negative, |x| <= 0.1717: the error times x is
 * below 2^-57. */
static const double cor_ratio_phase_polynomial[15] = {
    -0x1.5555555555555p-2, 0x1.99999999999afp-3,  -0x1.24924924924a7p-3, 0x1.c71c71c70f323p-4,  -0x1.745d1745c4f4ap-4,
    0x1.3b13b14dfe309p-4,  -0x1.11111122e99c3p-4, 0x1.e1e1ca19159f1p-5,  -0x1.af285559e06b4p-5, 0x1.86200a4ff267fp-5,
    -0x1.6433bf55059f4p-5, 0x1.465d4d647d49dp-5,  -0x1.2e2a9afa53366p-5, 0x1.37a54854bab11p-5,  -0x1.23c3ceb732c8fp-5,
};

/* zeta/x where zeta A(zeta) = x, 0 <= x <= 1.8697: relative error 2^-39; and d zeta/dx: relative error 2^-22 */
static const double cor_ratio_start_polynomial[11] = {
    0x1.45f306dc9acbep-1,  0x1.08345eb61d55ep-2,  0x1.483729ecb5cfcp-4,  0x1.4acfea6764ff4p-6,
    0x1.13afa898dea7fp-8,  0x1.7bf52e8f0ed5bp-11, 0x1.aa7026be58b57p-14, 0x1.8c49e36208fa0p-17,
    0x1.16cc00d33b9cdp-20, 0x1.4110162dae6eap-23, 0x1.e3a7e9abba374p-26,
};
static const double cor_ratio_slope_polynomial[8] = {
    0x1.45f301d8e7208p-1, 0x1.0835a69d2137ap-1, 0x1.ec1a3c89fe6fcp-3,  0x1.4ca90ce05f3c7p-4,
    0x1.4991db289d353p-6, 0x1.5e227312114bcp-8, 0x1.2189e77bf830dp-13, 0x1.05af44b844790p-12,
};

/* zeta/x where the limited damper has L = x, for 0 <= x <= 0.9, 0.9 <= x <= 1.9, 1.9 <= x <= 3.4483: relative error
 * 2^-24 */
static const double cor_ratio_limited_polynomial[3][11] = {
    {0x1.45f3071560939p-2, 0x1.0833e936f436ap-3, 0x1.6a6896bacba21p-4, 0x1.c51e864d4bd62p-5, 0x1.ba523e5cfcef7p-6,
     -0x1.70222224b7009p-7, -0x1.744c05a8ec1fap-7, 0x1.ae93497e480fap-5, -0x1.88ea5893dd912p-3, 0x1.95a2b93bf83d7p-3,
     -0x1.04f4a7ec035ecp-4},
    {0x1.40535628d139fp-4, 0x1.efd0b92338d74p+0, -0x1.74c1d44ab1feep+2, 0x1.6144eaa93f23cp+3, -0x1.97ca8b81c7f0ap+3,
     0x1.376c0996714eap+3, -0x1.42bf64a03196bp+2, 0x1.c411c9cf16106p+0, -0x1.9b51005730531p-2, 0x1.b8258a361fd3ap-5,
     -0x1.a53965cb9a887p-9},
    {0x1.a13469e3dbc0cp-2, -0x1.ab182374a9cc6p-2, 0x1.46215a4e0ee58p+0, -0x1.2df0888adf445p+0, 0x1.79c19fd48a81bp-1,
     -0x1.39394e6cd8e8dp-2, 0x1.6a860ce0210f1p-4, -0x1.1e9acbc5dad3fp-6, 0x1.2a563e8e40c5cp-9, -0x1.6ffa90348b279p-13,
     0x1.9b1ed1394860fp-18},
};

/* ---- A(zeta), up to zeta = 3 ---- */

/* numerator h(u)/(c (1 + c)), which is A(zeta) where numerator = 2, for zeta <= COR_RATIO_FORCE_NEAR: relative error
 * 2^-55.
 *
 * c = sqrt((1 + zeta)/2) is the cosine of half the phase at the turning point, u = (1 - c)/(1 + c) = (c - c^2)/(c +
 * c^2) is between -0.172 and 0.172, and h(u) = atan(sqrt(u))/sqrt(u) is analytic at zeta = 1, where u = 0. */
COR_KERNEL struct cor_inline_pair cor_ratio_phase_near(struct cor_inline_pair zeta, struct cor_inline_pair numerator)
{
    const double *p = cor_ratio_phase_polynomial;
    const double sum = 1 + zeta.hi; /* its rounding error, which is a double for every zeta.hi below 2^53 */
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

/* L at zero force */
COR_KERNEL struct cor_inline_pair cor_ratio_force_near(double zeta)
{
    return cor_ratio_phase_near(cor_pair(zeta, 0), cor_pair(4 * zeta, 0));
}

/* L with damping during the approach only */
COR_KERNEL struct cor_inline_pair cor_ratio_approach_near(double zeta)
{
    return cor_ratio_phase_near(cor_pair(zeta, 0), cor_pair(2 * zeta, 0));
}

/* ---- A(zeta) beyond 3 ---- */

/* exp(-theta) = zeta - sqrt(zeta^2 - 1), zeta = cosh(theta), as a pair; theta; and excess = theta (coth(theta) - 1),
 * which is small and rounded. L at zero force is 2 (theta + excess). */
struct cor_ratio_far {
    struct cor_inline_pair decay, theta, root; /* root: sqrt(zeta^2 - 1) */
    double excess;
};

/* 2.8 <= zeta <= 2^500 */
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

/* eps at zero force, zeta > 3. Beyond 2^540 it is below half the smallest double. */
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

/* eps with damping during the approach only, zeta > 3 */
COR_INLINE double cor_ratio_eps_approach_far(double zeta)
{
    if (zeta > COR_INLINE_2_100)
        return 0.5 / zeta;
    const struct cor_ratio_far far = cor_ratio_far(cor_pair(zeta, 0));
    return cor_inline_pair_times(far.decay, cor_kernel_exp_minus_pair(cor_pair(far.excess, 0))).hi;
}

/* zeta times pi, or times pi/2 with share = 1/2: L and the loss of a tiny zeta at every end */
COR_INLINE double cor_ratio_tiny_loss(double zeta, double share)
{
    const double z = zeta * COR_INLINE_2_200;
    const struct cor_inline_pair p = cor_inline_product(z, COR_RATIO_PI);
    return (share * (p.hi + (p.lo + z * COR_RATIO_PI_TAIL))) * COR_INLINE_2_M200;
}

/* ---- eps and 1 - eps of an end with L = exponent(zeta) ---- */

#define COR_RATIO_KERNELS(end, exponent)                                                                               \
    COR_KERNEL double cor_ratio_eps_##end##_near(double zeta)                                                          \
    {                                                                                                                  \
        return cor_kernel_exp_minus(exponent(zeta));                                                                   \
    }                                                                                                                  \
    COR_KERNEL double cor_ratio_loss_##end##_near(double zeta)                                                         \
    {                                                                                                                  \
        return cor_kernel_one_minus_exp_minus(exponent(zeta));                                                         \
    }

/* The kernels hold up to `largest`, and eps beyond it is beyond(zeta). */
#define COR_RATIO_EPS(end, largest, beyond)                                                                            \
    COR_INLINE double cor_ratio_eps_##end(double zeta)                                                                 \
    {                                                                                                                  \
        if (zeta >= 0 && zeta <= (largest))                                                                            \
            return cor_ratio_eps_##end##_near(zeta);                                                                   \
        return zeta > 0 ? beyond(zeta) : (double)NAN;                                                                  \
    }

/* share: of pi, see cor_ratio_tiny_loss */
#define COR_RATIO_LOSS(end, largest, share, beyond)                                                                    \
    COR_INLINE double cor_ratio_loss_##end(double zeta)                                                                \
    {                                                                                                                  \
        if (zeta >= COR_RATIO_TINY && zeta <= (largest))                                                               \
            return cor_ratio_loss_##end##_near(zeta);                                                                  \
        if (zeta >= 0 && zeta < 1)                                                                                     \
            return cor_ratio_tiny_loss(zeta, share);                                                                   \
        return zeta > 0 ? 1 - beyond(zeta) : (double)NAN;                                                              \
    }

COR_RATIO_KERNELS(zero_force, cor_ratio_force_near)
COR_RATIO_EPS(zero_force, COR_RATIO_FORCE_NEAR, cor_ratio_eps_force_far)
COR_RATIO_LOSS(zero_force, COR_RATIO_FORCE_NEAR, 1, cor_ratio_eps_force_far)

COR_RATIO_KERNELS(approach_only, cor_ratio_approach_near)
COR_RATIO_EPS(approach_only, COR_RATIO_FORCE_NEAR, cor_ratio_eps_approach_far)
COR_RATIO_LOSS(approach_only, COR_RATIO_FORCE_NEAR, 0.5, cor_ratio_eps_approach_far)

/* ---- zero overlap ---- */

/* 1 - zeta^2 as (1 - zeta)(1 + zeta) with both factors exact: relative error 2^-104 arbitrarily near to zeta = 1 */
COR_KERNEL struct cor_inline_pair cor_ratio_omega_square(double zeta)
{
    const double minus = 1 - zeta, plus = 1 + zeta;
    return cor_inline_pair_times(cor_pair(minus, (1 - minus) - zeta), cor_pair(plus, zeta - (plus - 1)));
}

/* numerator/omega from omega^2 */
COR_KERNEL struct cor_inline_pair cor_ratio_over_root(struct cor_inline_pair numerator, struct cor_inline_pair square)
{
    const double root = sqrt(square.hi), inverse = 1 / root;
    return cor_pair_over_with(numerator, cor_pair_root_with(square, root, inverse), inverse);
}

/* numerator/sqrt(1 - zeta^2), zeta < 1 */
COR_KERNEL struct cor_inline_pair cor_ratio_over_omega(double zeta, struct cor_inline_pair numerator)
{
    return cor_ratio_over_root(numerator, cor_ratio_omega_square(zeta));
}

/* L, limited to 1400, where eps is 0. Up to this limit 1 - zeta^2 is above 2^-18, so that its error of 2^-104 is
 * negligible. */
COR_KERNEL struct cor_inline_pair cor_ratio_overlap_near(double zeta)
{
    const struct cor_inline_pair square = cor_inline_product(zeta, zeta);
    const double less = 1 - square.hi;
    struct cor_inline_pair rest = cor_inline_sum(less, ((1 - less) - square.hi) - square.lo), phase;
    rest.hi = cor_kernel_max(rest.hi, 1.0 / 262144);
    phase = cor_inline_product(COR_RATIO_PI, zeta);
    phase.lo += COR_RATIO_PI_TAIL * zeta;
    struct cor_inline_pair exponent = cor_ratio_over_root(phase, rest);
    exponent.hi = cor_kernel_min(exponent.hi, 1400);
    return exponent;
}

/* zeta >= 1 */
COR_INLINE double cor_ratio_eps_overlap_far(double zeta)
{
    (void)zeta;
    return 0;
}

COR_RATIO_KERNELS(zero_overlap, cor_ratio_overlap_near)
COR_RATIO_EPS(zero_overlap, COR_RATIO_BELOW_ONE, cor_ratio_eps_overlap_far)
COR_RATIO_LOSS(zero_overlap, COR_RATIO_BELOW_ONE, 1, cor_ratio_eps_overlap_far)

/* ---- the limited damper: the damping force is at most the elastic one ----
 *
 * Until beta v = u, u = x^((a+1)/2), the force is twice the elastic force. Then the law holds unchanged, and its force
 * vanishes at the phase psi later, cos(psi) = (4 zeta^2 - 1)/R, R = sqrt(1 + 8 zeta^2). L = zeta psi/sqrt(1 - zeta^2),
 * and with half the angle
 *
 *     L = (R + 1)/(R + 3) 2 C A(C),     C = cos(psi/2) = zeta sqrt(2 (R + 3)/(R (R + 1)))
 */

struct cor_ratio_limited {
    struct cor_inline_pair c, slope, share, root; /* C, C/zeta, (R + 1)/(R + 3), R */
};

/* zeta <= 2^64 */
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

/* L, zeta <= COR_RATIO_LIMITED_NEAR */
COR_KERNEL struct cor_inline_pair cor_ratio_limited_near(double zeta)
{
    const struct cor_ratio_limited parts = cor_ratio_limited_parts(zeta);
    return cor_inline_pair_times(parts.share, cor_ratio_phase_near(parts.c, cor_pair_scaled(parts.c, 4)));
}

/* eps for zeta > COR_RATIO_LIMITED_NEAR as a pair; past 2^64 it is 1/(2 sqrt(2) zeta). L is 2 C A(C) minus 2 C A(C)
 * (2/(R + 3)). */
COR_INLINE struct cor_inline_pair cor_ratio_eps_limited_far(double zeta)
{
    if (zeta > COR_INLINE_2_40 * 16777216.0) {
        const int huge = zeta > COR_INLINE_2_900; /* scaling keeps the pair's lower half from underflow */
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

COR_INLINE double cor_ratio_eps_limited_beyond(double zeta)
{
    return isinf(zeta) ? 0 : cor_ratio_eps_limited_far(zeta).hi;
}

COR_RATIO_KERNELS(limited, cor_ratio_limited_near)
COR_RATIO_LOSS(limited, COR_RATIO_LIMITED_NEAR, 1, cor_ratio_eps_limited_beyond)

COR_INLINE double cor_ratio_eps_limited(double zeta)
{
    if (zeta >= COR_RATIO_TINY && zeta <= COR_RATIO_LIMITED_NEAR)
        return cor_ratio_eps_limited_near(zeta);
    if (zeta >= 0 && zeta < 1)
        return 1;
    return zeta > 0 ? cor_ratio_eps_limited_beyond(zeta) : (double)NAN;
}

/* ---- inverses ----
 *
 * Each function solves for zeta from L, a pair. A polynomial gives the start value, and a step of Newton's method
 * (Halley's method for the limited damper) with the residual as a pair follows. */

/* About zeta with zeta A(zeta) = x, 0 <= x <= 1.8697, and d zeta/dx */
struct cor_ratio_start {
    double zeta, slope;
};

COR_KERNEL struct cor_ratio_start cor_ratio_phase_start(double x)
{
    const double *p = cor_ratio_start_polynomial;
    const double x2 = x * x, x4 = x2 * x2;
    struct cor_ratio_start start;
    start.zeta = x * (COR_POLYNOMIAL_8(p, x, x2, x4) + ((p[8] + p[9] * x) + p[10] * x2) * (x4 * x4));
    start.slope = COR_POLYNOMIAL_8(cor_ratio_slope_polynomial, x, x2, x4);
    return start;
}

/* zeta from that start, at = start A(start) */
COR_KERNEL double cor_ratio_phase_step(struct cor_ratio_start start, struct cor_inline_pair x,
                                       struct cor_inline_pair at)
{
    return start.zeta + start.slope * ((x.hi - at.hi) + (x.lo - at.lo));
}

COR_KERNEL double cor_ratio_of_phase_near(struct cor_inline_pair x)
{
    const struct cor_ratio_start start = cor_ratio_phase_start(x.hi);
    return cor_ratio_phase_step(start, x, cor_ratio_phase_near(cor_pair(start.zeta, 0), cor_pair(2 * start.zeta, 0)));
}

/* The same for larger x, also from exp(-x) as a pair: zeta = cosh(theta), theta = x - delta, where delta = 2 x E/(1 +
 * E), E = exp(-2 theta) = exp(-2 x) exp(2 delta), by Newton's method from delta = 2 x exp(-2 x) < 0.1. */
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

/* loss/pi, or twice that, for a tiny loss */
COR_INLINE double cor_ratio_of_tiny_loss(double loss, double share)
{
    const struct cor_inline_pair scaled = cor_pair(loss * (share * COR_INLINE_2_200), 0);
    return cor_pair_over(scaled, cor_pair(COR_RATIO_PI, COR_RATIO_PI_TAIL)).hi * COR_INLINE_2_M200;
}

/* The kernels of zeta from eps and from the loss at an end with zeta = of(L) */
#define COR_RATIO_INVERSE_KERNELS(end, of)                                                                             \
    COR_KERNEL double cor_ratio_zeta_##end##_near(double eps)                                                          \
    {                                                                                                                  \
        return of(cor_kernel_minus_log(cor_pair(eps, 0)));                                                             \
    }                                                                                                                  \
    COR_KERNEL double cor_ratio_zeta_of_loss_##end##_near(double loss)                                                 \
    {                                                                                                                  \
        return of(cor_kernel_minus_log_one_minus(loss));                                                               \
    }

/* near: the kernel or a function with its bits, up to the loss `largest`; share: see cor_ratio_of_tiny_loss */
#define COR_RATIO_OF_LOSS(end, near, largest, share)                                                                   \
    COR_INLINE double cor_ratio_zeta_of_loss_##end(double loss)                                                        \
    {                                                                                                                  \
        if (loss >= COR_RATIO_TINY && loss <= (largest))                                                               \
            return near(cor_kernel_minus_log_one_minus(loss));                                                         \
        if (!(loss >= 0 && loss <= 1))                                                                                 \
            return (double)NAN;                                                                                        \
        return loss > 0.5 ? cor_ratio_zeta_##end(1 - loss) : cor_ratio_of_tiny_loss(loss, share);                      \
    }

COR_KERNEL double cor_ratio_of_force(struct cor_inline_pair exponent)
{
    return cor_ratio_of_phase_near(cor_pair_scaled(exponent, 0.5));
}
COR_RATIO_INVERSE_KERNELS(zero_force, cor_ratio_of_force)

COR_INLINE double cor_ratio_zeta_zero_force(double eps)
{
    if (eps >= COR_RATIO_EPS_FORCE_NEAR && eps <= 1)
        return cor_ratio_zeta_zero_force_near(eps);
    if (!(eps >= 0 && eps <= 1))
        return (double)NAN;
    if (eps == 0)
        return (double)INFINITY;
    /* exp(-x) is the square root of eps */
    const int tiny = eps < COR_RATIO_TINY;
    const struct cor_inline_pair e = cor_pair(tiny ? eps * (COR_INLINE_2_100 * COR_INLINE_2_100) : eps, 0);
    struct cor_inline_pair x = cor_kernel_minus_log(e);
    x.hi += tiny ? 200 * 0.69314718055994531 : 0;
    const struct cor_inline_pair root = cor_pair_scaled(cor_pair_root(e), tiny ? 1 / COR_INLINE_2_100 : 1);
    return cor_ratio_of_phase_far(0.5 * x.hi, root);
}

COR_RATIO_OF_LOSS(zero_force, cor_ratio_of_force, 1 - COR_RATIO_EPS_FORCE_NEAR, 1)

COR_RATIO_INVERSE_KERNELS(approach_only, cor_ratio_of_phase_near)

COR_INLINE double cor_ratio_zeta_approach_only(double eps)
{
    if (eps >= COR_RATIO_EPS_APPROACH_NEAR && eps <= 1)
        return cor_ratio_zeta_approach_only_near(eps);
    if (!(eps >= 0 && eps <= 1))
        return (double)NAN;
    if (eps < COR_INLINE_2_M200) /* 1/(2 eps), which may overflow */
        return eps <= 2.78134232313400172885e-309 ? (double)INFINITY : 0.5 / eps;
    const struct cor_inline_pair e = cor_pair(eps, 0);
    return cor_ratio_of_phase_far(cor_kernel_minus_log(e).hi, e);
}

COR_RATIO_OF_LOSS(approach_only, cor_ratio_of_phase_near, 1 - COR_RATIO_EPS_APPROACH_NEAR, 2)

/* L/sqrt(pi^2 + L^2) */
COR_KERNEL double cor_ratio_of_overlap(struct cor_inline_pair exponent)
{
    const struct cor_inline_pair pi = cor_pair(COR_RATIO_PI, COR_RATIO_PI_TAIL);
    const struct cor_inline_pair square =
        cor_pair_plus(cor_inline_pair_times(pi, pi), cor_inline_pair_times(exponent, exponent));
    const double root = sqrt(square.hi), inverse = 1 / root;
    return cor_pair_over_with(exponent, cor_pair_root_with(square, root, inverse), inverse).hi;
}

COR_RATIO_INVERSE_KERNELS(zero_overlap, cor_ratio_of_overlap)

COR_INLINE double cor_ratio_zeta_zero_overlap(double eps)
{
    if (eps >= COR_RATIO_TINY && eps <= 1)
        return cor_ratio_zeta_zero_overlap_near(eps);
    if (!(eps >= 0 && eps <= 1))
        return (double)NAN;
    if (eps == 0)
        return 1;
    struct cor_inline_pair exponent = cor_kernel_minus_log(cor_pair(eps * COR_INLINE_2_200, 0));
    exponent = cor_pair_plus(exponent, cor_pair(200 * COR_KERNEL_LN2_HEAD, 200 * COR_KERNEL_LN2_TAIL));
    return cor_ratio_of_overlap(exponent);
}

COR_RATIO_OF_LOSS(zero_overlap, cor_ratio_of_overlap, COR_RATIO_BELOW_ONE, 1)

/* dL/dzeta and d^2L/dzeta^2 of the limited damper for known L. With W = 1 - zeta^2 and N = 4 zeta (1 + 2 zeta^2)/(1 + 8
 * zeta^2), W L' = L/zeta - N. Near zeta = 1 the code uses Taylor's series, with relative error 2^-32. */
struct cor_ratio_slopes {
    double first, second;
};

COR_KERNEL struct cor_ratio_slopes cor_ratio_limited_slopes(double zeta, double exponent)
{
    const double square = zeta * zeta, inverse = 1 / (1 + 8 * square), d = zeta - 1;
    const double n = 4 * zeta * (1 + 2 * square) * inverse;
    const double dn = 4 * (1 + square * (16 * square - 2)) * (inverse * inverse);
    const int close = fabs(d) < 1.0 / 65536;
    const double w = close ? 1 : (1 - zeta) * (1 + zeta), mean = exponent / zeta;
    struct cor_ratio_slopes slopes;
    slopes.first = close ? 56.0 / 81 + d * (-38.0 / 81 + d * (85.0 / 243)) : (mean - n) / w;
    slopes.second =
        close ? -38.0 / 81 + d * (170.0 / 243) : ((slopes.first - mean) / zeta - dn + 2 * zeta * slopes.first) / w;
    return slopes;
}

/* A step of Halley's method from zeta, where L is `at`, to where L is `exponent` */
COR_KERNEL double cor_ratio_limited_step(double zeta, struct cor_inline_pair at, struct cor_inline_pair exponent)
{
    const struct cor_ratio_slopes s = cor_ratio_limited_slopes(zeta, at.hi);
    const double residual = (at.hi - exponent.hi) + (at.lo - exponent.lo);
    return zeta - residual / (s.first - 0.5 * residual * s.second / s.first);
}

/* About zeta where L = exponent, 0 < exponent <= 3.4483, from the row of the polynomial for that L */
COR_KERNEL double cor_ratio_limited_start(double exponent, const double *p)
{
    const double t = exponent, t2 = t * t, t4 = t2 * t2;
    return t * (COR_POLYNOMIAL_8(p, t, t2, t4) + ((p[8] + p[9] * t) + p[10] * t2) * (t4 * t4));
}

/* The same; selects the row without branches, so that loops vectorise */
COR_KERNEL double cor_ratio_limited_start_near(double exponent)
{
    double p[11];
    for (int k = 0; k < 11; k++) {
        const double low = exponent > 0.9 ? cor_ratio_limited_polynomial[1][k] : cor_ratio_limited_polynomial[0][k];
        p[k] = exponent > 1.9 ? cor_ratio_limited_polynomial[2][k] : low;
    }
    return cor_ratio_limited_start(exponent, p);
}

/* zeta where L = exponent, 0 < exponent.hi <= 3.4483 */
COR_INLINE double cor_ratio_of_limited(struct cor_inline_pair exponent)
{
    const double x = exponent.hi,
                 start = cor_ratio_limited_start(x, cor_ratio_limited_polynomial[(x > 0.9) + (x > 1.9)]);
    return cor_ratio_limited_step(start, cor_ratio_limited_near(start), exponent);
}

/* The same for eps < COR_RATIO_EPS_LIMITED_NEAR. zeta eps 2 sqrt(2) tends to 1, so that Newton's method in ln(zeta)
 * converges quickly. */
COR_INLINE double cor_ratio_of_limited_far(double eps)
{
    if (eps < COR_INLINE_2_M200) { /* 1/(2 sqrt(2) eps) may overflow and is computed in units of 2^200 */
        if (eps == 0 || eps < 1.96670601748920e-309) /* the bound may count as 0 */
            return (double)INFINITY;
        const struct cor_inline_pair scaled = cor_pair(eps * (COR_INLINE_2_500), 0);
        return cor_pair_over(cor_pair(COR_RATIO_FAR_LIMITED, COR_RATIO_FAR_LIMITED_TAIL), scaled).hi * COR_INLINE_2_500;
    }
    double zeta = COR_RATIO_FAR_LIMITED / eps;
    for (int k = 0; k < 8; k++) {
        const struct cor_inline_pair at = cor_ratio_eps_limited_far(zeta);
        const double off = ((at.hi - eps) + at.lo) / at.hi; /* to first order ln(at/eps) */
        const double slope =
            zeta < COR_INLINE_2_40 ? zeta * cor_ratio_limited_slopes(zeta, cor_kernel_minus_log(at).hi).first : 1;
        zeta += zeta * (off * (1 + 0.5 * off) / slope);
        if (fabs(off) < 1e-9)
            break;
    }
    return zeta;
}

COR_INLINE double cor_ratio_zeta_limited(double eps)
{
    if (eps >= COR_RATIO_EPS_LIMITED_NEAR && eps < 1)
        return cor_ratio_of_limited(cor_kernel_minus_log(cor_pair(eps, 0)));
    if (!(eps >= 0 && eps <= 1))
        return (double)NAN;
    return eps == 1 ? 0 : cor_ratio_of_limited_far(eps);
}

COR_RATIO_OF_LOSS(limited, cor_ratio_of_limited, 1 - COR_RATIO_EPS_LIMITED_NEAR, 1)

/* ---- times and the largest overlap ---- */

/* theta for zeta > 3 up to the largest double; from 2^100 on it is ln(2 zeta) */
COR_INLINE struct cor_inline_pair cor_ratio_theta(double zeta)
{
    if (zeta < COR_INLINE_2_100)
        return cor_ratio_far(cor_pair(zeta, 0)).theta;
    const struct cor_inline_pair down = cor_kernel_minus_log(cor_pair(0.5 / (zeta * COR_INLINE_2_M500), 0));
    return cor_pair_plus(cor_pair(500 * COR_KERNEL_LN2_HEAD, 500 * COR_KERNEL_LN2_TAIL), down);
}

/* A(zeta) */
COR_INLINE struct cor_inline_pair cor_ratio_phase_time(double zeta)
{
    if (zeta <= COR_RATIO_FORCE_NEAR)
        return cor_ratio_phase_near(cor_pair(zeta, 0), cor_pair(2, 0));
    if (isinf(zeta))
        return cor_pair(0, 0);
    const struct cor_inline_pair z = cor_pair(zeta, 0);
    return cor_pair_over(cor_ratio_theta(zeta), zeta < COR_INLINE_2_100 ? cor_ratio_far(z).root : z);
}

/* L at zero force, below 1421, for every finite zeta. Below 2^-900 the relative accuracy is lost. */
COR_INLINE struct cor_inline_pair cor_ratio_force_exponent(double zeta)
{
    if (zeta <= COR_RATIO_FORCE_NEAR)
        return cor_ratio_force_near(zeta);
    struct cor_inline_pair half = cor_ratio_theta(zeta);
    if (zeta < COR_INLINE_2_100)
        half = cor_inline_sum(half.hi, half.lo + cor_ratio_far(cor_pair(zeta, 0)).excess);
    return cor_pair_scaled(half, 2);
}

/* L of the limited damper over zeta, zeta < 2^64, which is the time of its second part for the linear law */
COR_INLINE struct cor_inline_pair cor_ratio_limited_time(double zeta)
{
    const struct cor_ratio_limited parts = cor_ratio_limited_parts(zeta);
    if (zeta <= COR_RATIO_LIMITED_NEAR)
        return cor_inline_pair_times(parts.share, cor_ratio_phase_near(parts.c, cor_pair_scaled(parts.slope, 4)));
    const struct cor_ratio_far far = cor_ratio_far(parts.c);
    const struct cor_inline_pair half = cor_inline_sum(far.theta.hi, far.theta.lo + far.excess);
    return cor_pair_over(cor_inline_pair_times(parts.share, cor_pair_scaled(half, 2)), cor_pair(zeta, 0));
}

#endif
