/* SPDX-License-Identifier: MIT */
/* Points of the path of integration (rayleigh_parts.h) and t there, without calls, so that loops vectorise. */
#ifndef COR_RUNTIME_DISK_RAYLEIGH_PATH_H
#define COR_RUNTIME_DISK_RAYLEIGH_PATH_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "runtime/number/elementary.h"

struct cor_leg_path {
    int from_zero;            /* 1 if the base is 0, 0 if it is pi/2 - i Theta */
    double tilt, q0, pi;      /* q0, pi: terms of q (rough_q); both 0 for the base pi/2 - i Theta */
    double tanh_theta, scale; /* scale: cosh(Theta) for this base, 1 for the base 0 */
};

struct sine_cosine {
    double sine, cosine;
};

/* Computes sin(x) and cos(x) for |x| < 2^20. pi/2 has three parts of 33 bits, so that k times the first two is exact.
 * Taylor's series has terms down to 2^-55 at pi/4. The absolute error is below 2^-52 + 2^-53 |x|. */
COR_KERNEL struct sine_cosine kernel_sincos(double x)
{
    const double k = (x * 0.63661977236758134 + COR_KERNEL_INTEGER) - COR_KERNEL_INTEGER;
    const double r = ((x - k * 0x1.921fb544p+0) - k * 0x1.0b4611a6p-34) - k * 0x1.3198a2e037073p-69;
    const double z = r * r;
    const double s =
        r + r * z *
                (-1.0 / 6 +
                 z * (1.0 / 120 + z * (-1.0 / 5040 +
                                       z * (1.0 / 362880 + z * (-1.0 / 39916800 + z * (1.0 / 6227020800 +
                                                                                       z * (-1.0 / 1307674368000)))))));
    const double c =
        1 - z * (0.5 - z * (1.0 / 24 -
                            z * (1.0 / 720 -
                                 z * (1.0 / 40320 - z * (1.0 / 3628800 -
                                                         z * (1.0 / 479001600 - z * (1.0 / 87178291200 -
                                                                                     z * (1.0 / 20922789888000))))))));
    /* the quadrant, -2 to 2 */
    const double m = k - 4 * ((0.25 * k + COR_KERNEL_INTEGER) - COR_KERNEL_INTEGER);
    const int odd = m * m == 1, sine_turns = (m == 2) | (m == -2) | (m == -1),
              cosine_turns = (m == 2) | (m == -2) | (m == 1);
    struct sine_cosine result = {odd ? c : s, odd ? s : c};
    result.sine = sine_turns ? -result.sine : result.sine;
    result.cosine = cosine_turns ? -result.cosine : result.cosine;
    return result;
}

/* Returns exp(-x), x > -700; 0 for x >= 700. */
COR_KERNEL double kernel_decay(double x)
{
    const double e = cor_kernel_exp(x < 700 ? -x : -700);
    return x < 700 ? e : 0;
}

/* ---- complex numbers: <complex.h> would check every product for infinities ---- */

struct cx {
    double re, im;
};

COR_KERNEL struct cx cx_of(double re, double im)
{
    const struct cx z = {re, im};
    return z;
}

COR_KERNEL struct cx cx_plus(struct cx x, struct cx y)
{
    return cx_of(x.re + y.re, x.im + y.im);
}

COR_KERNEL struct cx cx_minus(struct cx x, struct cx y)
{
    return cx_of(x.re - y.re, x.im - y.im);
}

COR_KERNEL struct cx cx_times(struct cx x, struct cx y)
{
    return cx_of(x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re);
}

COR_KERNEL struct cx cx_scaled(double c, struct cx x)
{
    return cx_of(c * x.re, c * x.im);
}

COR_KERNEL double cx_norm(struct cx x)
{
    return x.re * x.re + x.im * x.im;
}

COR_KERNEL struct cx cx_over(struct cx x, struct cx y)
{
    return cx_scaled(1 / cx_norm(y), cx_times(x, cx_of(y.re, -y.im)));
}

/* Returns the square root of x != 0 that has Re >= 0. */
COR_KERNEL struct cx cx_root(struct cx x)
{
    const double half = sqrt(0.5 * (sqrt(cx_norm(x)) + fabs(x.re))), other = 0.5 * x.im / half;
    const double re = x.re >= 0 ? half : fabs(other), im = x.re >= 0 ? other : x.im < 0 ? -half : half;
    return cx_of(re, im);
}

/* Return ln(x) for a normal x, and arg(x), with an absolute error of 1e-5, as start values. They use the series of
 * atanh, and Abramowitz and Stegun 4.4.49. */
COR_KERNEL double rough_log(double x)
{
    const double k = cor_inline_from_bits((cor_inline_bits(x) >> 52) | UINT64_C(0x4330000000000000)); /* + 2^52 */
    const double m = cor_inline_significand(x), f = (m - COR_ROOT_2) / (m + COR_ROOT_2), z = f * f;
    return (k - 4503599627370496.0 - 1022.5) * COR_LN2 + 2 * f * (1 + z * (1.0 / 3 + z * (1.0 / 5)));
}

COR_KERNEL double rough_argument(struct cx x)
{
    const double a = fabs(x.re), b = fabs(x.im), r = a > b ? b / a : a / b, z = r * r;
    const double t = r * (0.9998660 + z * (-0.3302995 + z * (0.1801410 + z * (-0.0851330 + z * 0.0208351))));
    const double first = a > b ? t : COR_PI / 2 - t, upper = x.re < 0 ? COR_PI - first : first;
    return x.im < 0 ? -upper : upper;
}

COR_KERNEL struct cx cx_rough_log(struct cx x)
{
    return cx_of(0.5 * rough_log(cx_norm(x)), rough_argument(x));
}

/* ---- the path ---- */

/* sin(x + i y) and cos(x + i y), |y| < 350 */
struct cx_sine_cosine {
    struct cx sine, cosine;
    struct sine_cosine turn; /* sin(x) and cos(x) */
};

COR_KERNEL struct cx_sine_cosine kernel_complex_sincos(struct cx x)
{
    const struct sine_cosine turn = kernel_sincos(x.re);
    const double down = kernel_decay(x.im), up = 1 / down, cosh_im = 0.5 * (up + down), z = x.im * x.im;
    const double series =
        x.im * (1 + z * (1.0 / 6 +
                         z * (1.0 / 120 +
                              z * (1.0 / 5040 + z * (1.0 / 362880 + z * (1.0 / 39916800 + z * (1.0 / 6227020800)))))));
    const double sinh_im = z < 0.25 ? series : 0.5 * (up - down);
    const struct cx_sine_cosine result = {cx_of(turn.sine * cosh_im, turn.cosine * sinh_im),
                                          cx_of(turn.cosine * cosh_im, -turn.sine * sinh_im), turn};
    return result;
}

/* h(rho) = -i rho exp(-i tilt rho/(1 + rho)): the path starts straight down and then turns to the left, where
 * exp(-omega p) decays without oscillation. slope: the derivative of h. sine: sin(theta), divided by cosh(Theta) at the
 * base pi/2 - i Theta. back: a number with the argument of i exp(-i theta), for rough_q. */
struct path_point {
    double h_re;
    struct cx slope, sine, back;
    struct cx beyond_one; /* sine - 1 for the base pi/2 - i Theta; 1 for the base 0 */
};

COR_KERNEL struct path_point kernel_path(const struct cor_leg_path *path, int from_zero, double rho)
{
    struct path_point point;
    const double inverse = 1 / (1 + rho), angle = path->tilt * rho * inverse, turn = angle * inverse;
    const struct sine_cosine a = kernel_sincos(angle);
    const struct cx down = cx_of(-a.sine, -a.cosine), h = cx_scaled(rho, down);
    point.h_re = h.re;
    point.slope = cx_times(down, cx_of(1, -turn));
    if (from_zero) {
        const struct cx_sine_cosine whole = kernel_complex_sincos(h);
        point.sine = whole.sine;
        point.back = cx_of(whole.turn.sine, whole.turn.cosine);
        point.beyond_one = cx_of(1, 0);
    } else {
        /* sin(theta)/cosh(Theta) = cos(h) + i tanh(Theta) sin(h) */
        const struct cx_sine_cosine half = kernel_complex_sincos(cx_scaled(0.5, h));
        const struct cx square = cx_times(half.sine, half.sine),
                        full = cx_scaled(2 * path->tanh_theta, cx_times(half.sine, half.cosine));
        point.beyond_one = cx_of(-2 * square.re - full.im, -2 * square.im + full.re);
        point.sine = cx_of(1 + point.beyond_one.re, point.beyond_one.im);
        point.back = cx_of(1 - 2 * half.turn.sine * half.turn.sine, -(2 * half.turn.sine * half.turn.cosine));
    }
    return point;
}

/* Makes a step of Halley's method towards the root t of (1 + t) exp(q - t) = 1, where exp(q - q0) = power. move: 1, or
 * 0 to make no step. */
COR_KERNEL struct cx kernel_halley(double q0, struct cx power, double move, struct cx t)
{
    const struct cx one = cx_of(1, 0), six = cx_of(6, 0), y = cx_plus(one, t);
    const struct sine_cosine turn = kernel_sincos(t.im);
    const double size = kernel_decay(t.re - q0);
    const struct cx d = cx_minus(cx_times(cx_times(y, power), cx_of(size * turn.cosine, -size * turn.sine)), one);
    /* f is ln(1 + d), which is d (6 + d)/(6 + 4 d) + O(d^4). With e = -f/f', the step is e/(1 + e f''/(2 f')). */
    const struct cx f = cx_over(cx_times(d, cx_plus(six, d)), cx_plus(six, cx_scaled(4, d))),
                    e = cx_over(cx_times(f, y), t);
    const struct cx step = cx_over(e, cx_plus(one, cx_over(cx_scaled(0.5, e), cx_times(t, y))));
    return cx_plus(t, cx_scaled(move, step));
}

/* Returns q = q0 - 2 ln(sin(theta)), Im(q) >= 0, with an absolute error of 1e-5, as a start value. */
COR_KERNEL struct cx rough_q(const struct cor_leg_path *path, const struct path_point *point)
{
    /* sin(theta) is exp(i theta)/(2 i) times (1 - exp(-2 i theta)). For Im(theta) < 0 the argument of the second factor
     * has no jumps. */
    const double turned = rough_argument(cx_times(point->sine, point->back));
    const double q_im = path->pi - 2 * (point->h_re + turned);
    return cx_of(path->q0 - rough_log(cx_norm(point->sine)), q_im > 0 ? q_im : 0);
}

/* Returns q = -2 ln(1 + m) for theta near the branch point, where m = sin(theta) - 1 is small. */
COR_KERNEL struct cx near_q(struct cx m)
{
    struct cx series = cx_plus(cx_scaled(-1.0 / 6, m), cx_of(1.0 / 5, 0));
    series = cx_plus(cx_times(series, m), cx_of(-1.0 / 4, 0));
    series = cx_plus(cx_times(series, m), cx_of(1.0 / 3, 0));
    series = cx_plus(cx_times(series, m), cx_of(-1.0 / 2, 0));
    series = cx_plus(cx_times(series, m), cx_of(1, 0));
    return cx_scaled(-2, cx_times(series, m));
}

/* Returns t of s = sqrt(2 q) by the series at the branch point, with the coefficients of DLMF 5.11.3. For |s| < 0.1 the
 * next term is below 2^-60. */
COR_KERNEL struct cx near_t(struct cx s)
{
    const struct cx up = cx_of(s.im < 0 ? -s.re : s.re, fabs(s.im));
    struct cx series = cx_of(-139.0 / 5443200, 0);
    series = cx_plus(cx_times(series, up), cx_of(1.0 / 17010, 0));
    series = cx_plus(cx_times(series, up), cx_of(1.0 / 4320, 0));
    series = cx_plus(cx_times(series, up), cx_of(-1.0 / 270, 0));
    series = cx_plus(cx_times(series, up), cx_of(1.0 / 36, 0));
    series = cx_plus(cx_times(series, up), cx_of(1.0 / 3, 0));
    return cx_times(cx_plus(cx_times(series, up), cx_of(1, 0)), up);
}

/* Returns t of q far from the branch point. */
COR_KERNEL struct cx far_t(struct cx q)
{
    const struct cx one = cx_of(1, 0);
    return cx_plus(q, cx_rough_log(cx_plus(cx_plus(one, q), cx_rough_log(cx_plus(one, q)))));
}

/* Finds the solution t of t - ln(1 + t) = q on the sheet where Im(t) > 0 for Im(q) > 0. Returns a start value for
 * Halley's method with *move = 1, or t itself with *move = 0. */
COR_KERNEL struct cx kernel_guess(const struct cor_leg_path *path, const struct path_point *point, double *move)
{
    const int near = cx_norm(point->beyond_one) < 6e-6;
    const struct cx rough = rough_q(path, point), exact = near_q(point->beyond_one);
    const struct cx q = cx_of(near ? exact.re : rough.re, near ? exact.im : rough.im), s = cx_root(cx_scaled(2, q));
    const struct cx inside = near_t(s), outside = far_t(q);
    const int is_outside = cx_norm(s) > 5;
    *move = near ? 0 : 1;
    return cx_of(is_outside ? outside.re : inside.re, is_outside ? outside.im : inside.im);
}

/* Numbers of steps of Halley's method after which y has a relative error of 2^-48. Sampled from q0 = 0 to 1400 for the
 * base 0, and to 30 for the base pi/2 - i Theta. */
enum { STEPS_FROM_ZERO = 2, STEPS_FROM_OTHER = 3 };

#endif
