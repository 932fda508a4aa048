/* SPDX-License-Identifier: MIT */
/* The loops of Rayleigh's energy over nodes and over modes, free of calls; gcc 12 vectorises all of them, in the
 * portable set too (-fopt-info-vec). rayleigh_kernel.c makes functions of them. No set may fuse a multiplication with
 * an addition, and sums have sixteen parts for every width of a vector. All sets therefore give the same bits. */
#ifndef COR_RUNTIME_DISK_RAYLEIGH_KERNEL_H
#define COR_RUNTIME_DISK_RAYLEIGH_KERNEL_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "runtime/core/kernel_exp.h"
#include "runtime/disk/rayleigh_spectrum.h"

struct pair_of_numbers {
    double sine, cosine;
};

/* sin(x) and cos(x) for |x| < 2^20. pi/2 has three parts of 33 bits, so that k times the first two is exact. Taylor's
 * series has terms down to 2^-55 at pi/4. The absolute error is below 2^-52 + 2^-53 |x|. */
KERNEL struct pair_of_numbers kernel_sincos(double x)
{
    const double k = (x * 0.63661977236758134 + ROUND_TO_INTEGER) - ROUND_TO_INTEGER;
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
    const double m = k - 4 * ((0.25 * k + ROUND_TO_INTEGER) - ROUND_TO_INTEGER);
    const int odd = m * m == 1, sine_turns = (m == 2) | (m == -2) | (m == -1),
              cosine_turns = (m == 2) | (m == -2) | (m == 1);
    struct pair_of_numbers result = {odd ? c : s, odd ? s : c};
    result.sine = sine_turns ? -result.sine : result.sine;
    result.cosine = cosine_turns ? -result.cosine : result.cosine;
    return result;
}

/* exp(-x), x > -700; 0 beyond 700 */
KERNEL double kernel_decay(double x)
{
    const double e = kernel_exp(x < 700 ? -x : -700);
    return x < 700 ? e : 0;
}

/* ---- complex numbers: <complex.h> would check every product for infinities ---- */

struct number {
    double re, im;
};

KERNEL struct number number(double re, double im)
{
    const struct number z = {re, im};
    return z;
}

KERNEL struct number plus(struct number x, struct number y)
{
    return number(x.re + y.re, x.im + y.im);
}

KERNEL struct number minus(struct number x, struct number y)
{
    return number(x.re - y.re, x.im - y.im);
}

KERNEL struct number times(struct number x, struct number y)
{
    return number(x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re);
}

KERNEL struct number scaled(double c, struct number x)
{
    return number(c * x.re, c * x.im);
}

KERNEL double square_modulus(struct number x)
{
    return x.re * x.re + x.im * x.im;
}

KERNEL struct number divided(struct number x, struct number y)
{
    return scaled(1 / square_modulus(y), times(x, number(y.re, -y.im)));
}

/* The square root of x != 0 that has Re >= 0 */
KERNEL struct number root(struct number x)
{
    const double half = sqrt(0.5 * (sqrt(square_modulus(x)) + fabs(x.re))), other = 0.5 * x.im / half;
    const double re = x.re >= 0 ? half : fabs(other), im = x.re >= 0 ? other : x.im < 0 ? -half : half;
    return number(re, im);
}

/* ln(x) for a normal x, and arg(x), with an absolute error of 1e-5, as start values: the series of atanh; Abramowitz
 * and Stegun 4.4.49 */
KERNEL double rough_log(double x)
{
    uint64_t bits, exponent;
    double m, k;
    memcpy(&bits, &x, sizeof bits);
    exponent = (bits >> 52) | 0x4330000000000000; /* 2^52 + the exponent's bits */
    bits = (bits & 0x000fffffffffffff) | 0x3ff0000000000000;
    memcpy(&m, &bits, sizeof m);
    memcpy(&k, &exponent, sizeof k);
    const double f = (m - 1.4142135623730951) / (m + 1.4142135623730951), z = f * f;
    return (k - 4503599627370496.0 - 1022.5) * 0.69314718055994531 + 2 * f * (1 + z * (1.0 / 3 + z * (1.0 / 5)));
}

KERNEL double rough_argument(struct number x)
{
    const double a = fabs(x.re), b = fabs(x.im), r = a > b ? b / a : a / b, z = r * r;
    const double t = r * (0.9998660 + z * (-0.3302995 + z * (0.1801410 + z * (-0.0851330 + z * 0.0208351))));
    const double first = a > b ? t : 1.5707963267948966 - t, upper = x.re < 0 ? 3.1415926535897932 - first : first;
    return x.im < 0 ? -upper : upper;
}

KERNEL struct number rough_complex_log(struct number x)
{
    return number(0.5 * rough_log(square_modulus(x)), rough_argument(x));
}

/* ---- the path ---- */

/* sin(x + i y) and cos(x + i y), |y| < 350 */
struct pair_of_complex {
    struct number sine, cosine;
    struct pair_of_numbers turn; /* sin(x) and cos(x) */
};

KERNEL struct pair_of_complex kernel_complex_sincos(struct number x)
{
    const struct pair_of_numbers turn = kernel_sincos(x.re);
    const double down = kernel_decay(x.im), up = 1 / down, cosh_im = 0.5 * (up + down), z = x.im * x.im;
    const double series =
        x.im * (1 + z * (1.0 / 6 +
                         z * (1.0 / 120 +
                              z * (1.0 / 5040 + z * (1.0 / 362880 + z * (1.0 / 39916800 + z * (1.0 / 6227020800)))))));
    const double sinh_im = z < 0.25 ? series : 0.5 * (up - down);
    const struct pair_of_complex result = {number(turn.sine * cosh_im, turn.cosine * sinh_im),
                                           number(turn.cosine * cosh_im, -turn.sine * sinh_im), turn};
    return result;
}

/* h(rho) = -i rho exp(-i tilt rho/(1 + rho)): the path starts straight down and then turns to the left, where
 * exp(-omega p) decays without oscillation. The struct holds h, its derivative, and sin(theta), divided by cosh(Theta)
 * at the base pi/2 - i Theta. */
struct path_point {
    struct number h, slope, sine, beyond_one; /* beyond_one = sine - 1 */
    struct pair_of_numbers turn;              /* sin and cos of Re(h) */
};

KERNEL struct path_point kernel_path(const struct cor_leg_path *path, int from_zero, double rho)
{
    struct path_point point;
    const double inverse = 1 / (1 + rho), angle = path->tilt * rho * inverse, turn = angle * inverse;
    const struct pair_of_numbers a = kernel_sincos(angle);
    const struct number down = number(-a.sine, -a.cosine);
    point.h = scaled(rho, down);
    point.slope = times(down, number(1, -turn));
    if (from_zero) {
        const struct pair_of_complex whole = kernel_complex_sincos(point.h);
        point.sine = whole.sine;
        point.turn = whole.turn;
        point.beyond_one = number(point.sine.re - 1, point.sine.im);
    } else {
        /* sin(theta)/cosh(Theta) = cos(h) + i tanh(Theta) sin(h) */
        const struct pair_of_complex half = kernel_complex_sincos(scaled(0.5, point.h));
        const struct number square = times(half.sine, half.sine),
                            full = scaled(2 * path->tanh_theta, times(half.sine, half.cosine));
        point.beyond_one = number(-2 * square.re - full.im, -2 * square.im + full.re);
        point.sine = number(1 + point.beyond_one.re, point.beyond_one.im);
        point.turn.sine = 2 * half.turn.sine * half.turn.cosine;
        point.turn.cosine = 1 - 2 * half.turn.sine * half.turn.sine;
    }
    return point;
}

/* A step of Halley's method on (1 + t) exp(q - t) = 1, exp(q - q0) = power; no step if move is 0 instead of 1. */
KERNEL struct number kernel_halley(double q0, struct number power, double move, struct number t)
{
    const struct number one = number(1, 0), six = number(6, 0), y = plus(one, t);
    const struct pair_of_numbers turn = kernel_sincos(t.im);
    const double size = kernel_decay(t.re - q0);
    const struct number d = minus(times(times(y, power), number(size * turn.cosine, -size * turn.sine)), one);
    /* f = ln(1 + d) = d (6 + d)/(6 + 4 d) + O(d^4), e = -f/f', t -= e/(1 - e f''/(2 f')) */
    const struct number f = divided(times(d, plus(six, d)), plus(six, scaled(4, d))), e = divided(times(f, y), t);
    const struct number step = divided(e, plus(one, divided(scaled(0.5, e), times(t, y))));
    return plus(t, scaled(move, step));
}

/* The solution t of t - ln(1 + t) = q = q0 - 2 ln(sin(theta)) on the sheet where Im(t) > 0 for Im(q) > 0. Returns a
 * start value for Halley's method, or t itself with *move = 0. */
KERNEL struct number kernel_guess(const struct cor_leg_path *path, int from_zero, const struct path_point *point,
                                  double *move)
{
    const double pi = 3.14159265358979323846;
    /* sin(theta) = exp(i theta)/(2 i) (1 - exp(-2 i theta)), Im(theta) < 0: this form gives its argument without a jump
     * at any distance */
    const struct number back =
        from_zero ? number(point->turn.sine, point->turn.cosine) : number(point->turn.cosine, -point->turn.sine);
    const double turned = rough_argument(times(point->sine, back));
    const double q0 = from_zero ? path->q0 : 0, q_im = (from_zero ? pi : 0) - 2 * (point->h.re + turned);
    const struct number one = number(1, 0);
    const struct number rough = number(q0 - rough_log(square_modulus(point->sine)), q_im > 0 ? q_im : 0);
    /* for theta near the branch point */
    const struct number m = point->beyond_one;
    struct number log_series = plus(scaled(-1.0 / 6, m), number(1.0 / 5, 0));
    log_series = plus(times(log_series, m), number(-1.0 / 4, 0));
    log_series = plus(times(log_series, m), number(1.0 / 3, 0));
    log_series = plus(times(log_series, m), number(-1.0 / 2, 0));
    log_series = plus(times(log_series, m), one);
    const int near = !from_zero && square_modulus(m) < 6e-6;
    const struct number exact = scaled(-2, times(log_series, m));
    const struct number q = number(near ? exact.re : rough.re, near ? exact.im : rough.im);
    /* the series at the branch point, with the coefficients of DLMF 5.11.3; below |s| = 0.1 its next term is 2^-60 */
    const struct number s = root(scaled(2, q)), up = number(s.im < 0 ? -s.re : s.re, fabs(s.im));
    struct number series = number(-139.0 / 5443200, 0);
    series = plus(times(series, up), number(1.0 / 17010, 0));
    series = plus(times(series, up), number(1.0 / 4320, 0));
    series = plus(times(series, up), number(-1.0 / 270, 0));
    series = plus(times(series, up), number(1.0 / 36, 0));
    series = plus(times(series, up), number(1.0 / 3, 0));
    series = times(plus(times(series, up), one), up);
    /* for theta far from the branch point */
    const struct number far = plus(q, rough_complex_log(plus(plus(one, q), rough_complex_log(plus(one, q)))));
    const int outside = square_modulus(s) > 5;
    *move = near ? 0 : 1;
    return number(outside ? far.re : series.re, outside ? far.im : series.im);
}

/* Number of steps from a start value to y with relative error 2^-48, sampled at q0 = 0 to 1400, for the second base to
 * 30 */
enum { STEPS_FROM_ZERO = 2, STEPS_FROM_OTHER = 3 };

KERNEL struct number kernel_solve(const struct cor_leg_path *path, double rho)
{
    double move;
    const struct path_point point = kernel_path(path, path->from_zero, rho);
    const struct number power = divided(number(1, 0), times(point.sine, point.sine));
    struct number t = kernel_guess(path, path->from_zero, &point, &move);
    for (int k = 0; k < (path->from_zero ? STEPS_FROM_ZERO : STEPS_FROM_OTHER); k++)
        t = kernel_halley(path->from_zero ? path->q0 : 0, power, move, t);
    return t;
}

/* Computes a panel of a leg: p and weights at `steps` nodes, and p at the end. */
KERNEL void kernel_panel(const struct cor_leg_path *path, int from_zero, const struct cor_leg_rule *rule, int steps,
                         double top, struct cor_leg *restrict leg)
{
    enum { LANES = 16 };
    const double panel = steps * COR_LEG_STEP;
    double step_re[LANES], step_im[LANES], t_re[LANES], t_im[LANES], power_re[LANES], power_im[LANES], move[LANES];
    for (int i = 0; i < LANES; i++) {
        const double rho = kernel_decay(top - 0.5 * panel * (1 - rule->x[i]));
        const struct path_point point = kernel_path(path, from_zero, rho);
        const struct number step = scaled(0.5 * panel * rho, number(-point.slope.im, point.slope.re));
        const struct number t = kernel_guess(path, from_zero, &point, &move[i]);
        const struct number power = divided(number(1, 0), times(point.sine, point.sine));
        step_re[i] = step.re;
        step_im[i] = step.im;
        t_re[i] = t.re;
        t_im[i] = t.im;
        power_re[i] = power.re;
        power_im[i] = power.im;
    }
    for (int k = 0; k < (from_zero ? STEPS_FROM_ZERO : STEPS_FROM_OTHER); k++)
        for (int i = 0; i < LANES; i++) {
            const struct number t = kernel_halley(from_zero ? path->q0 : 0, number(power_re[i], power_im[i]), move[i],
                                                  number(t_re[i], t_im[i]));
            t_re[i] = t.re;
            t_im[i] = t.im;
        }
    for (int i = 0; i < LANES; i++) {
        const struct number half = number(0.5 * (1 + t_re[i]), 0.5 * t_im[i]);
        const struct number step = times(number(step_re[i], step_im[i]), root(half));
        step_re[i] = step.re;
        step_im[i] = step.im;
    }
    double re[LANES], im[LANES], *const w_re = leg->w_re + leg->n, *const w_im = leg->w_im + leg->n;
    for (int k = 0; k < LANES; k++) {
        re[k] = leg->end_re;
        im[k] = leg->end_im;
    }
    const double(*const row)[LANES] = steps == COR_LEG_STEPS ? rule->to_steps : rule->to_short;
    for (int i = 0; i < COR_LEG_GAUSS; i++)
        for (int k = 0; k < LANES; k++) {
            re[k] += row[i][k] * step_re[i];
            im[k] += row[i][k] * step_im[i];
        }
    memcpy(leg->p_re + leg->n, re, sizeof re);
    memcpy(leg->p_im + leg->n, im, sizeof im);
    const int weights = steps == COR_LEG_STEPS ? COR_LEG_STEPS : COR_LEG_SHORT;
    for (int k = 0; k < weights; k++) {
        const double rho = kernel_decay(top - k * COR_LEG_STEP);
        const struct path_point point = kernel_path(path, from_zero, rho);
        const struct number w = times(point.slope, scaled(COR_LEG_STEP * rho * path->scale, point.sine));
        w_re[k] = w.re;
        w_im[k] = w.im;
    }
    for (int i = 0; i < COR_LEG_GAUSS; i++) {
        leg->end_re += rule->w[i] * step_re[i];
        leg->end_im += rule->w[i] * step_im[i];
    }
    leg->n += steps;
}

/* ---- sums ---- */

KERNEL double kernel_total(const double part[COR_LEG_PART])
{
    double total = 0;
    for (int l = 0; l < COR_LEG_PART; l++)
        total += part[l];
    return total;
}

/* exp(-omega p) */
KERNEL void kernel_exponentials(int n, const double *restrict p_re, const double *restrict p_im, double omega,
                                double *restrict e_re, double *restrict e_im)
{
    for (int i = 0; i < n; i++) {
        const double size = kernel_decay(omega * p_re[i]);
        const struct pair_of_numbers turn = kernel_sincos(omega * p_im[i]);
        e_re[i] = size * turn.cosine;
        e_im[i] = -size * turn.sine;
    }
}

/* Returns the sum of w e, and squares e in place. n is a multiple of COR_LEG_PART. */
KERNEL void kernel_sum_and_square(int n, const double *restrict w_re, const double *restrict w_im,
                                  double *restrict e_re, double *restrict e_im, double *restrict sum_re,
                                  double *restrict sum_im)
{
    double re[COR_LEG_PART] = {0}, im[COR_LEG_PART] = {0};
    for (int i = 0; i < n; i += COR_LEG_PART)
        for (int l = 0; l < COR_LEG_PART; l++) {
            const double r = e_re[i + l], m = e_im[i + l];
            re[l] += w_re[i + l] * r - w_im[i + l] * m;
            im[l] += w_re[i + l] * m + w_im[i + l] * r;
            e_re[i + l] = r * r - m * m;
            e_im[i + l] = 2 * r * m;
        }
    *sum_re = kernel_total(re);
    *sum_im = kernel_total(im);
}

/* Doubling the frequency squares the exponential. */
KERNEL void kernel_octaves(const struct cor_leg *leg, double first, int octaves, double re[][COR_SPECTRUM_TERMS],
                           double im[][COR_SPECTRUM_TERMS])
{
    /* cos(pi k/32), down to 0; tanh(ln(2)/4) */
    static const double quarter[COR_SPECTRUM_TERMS + 1] = {1,
                                                           0.995184726672196886,
                                                           0.980785280403230449,
                                                           0.956940335732208865,
                                                           0.923879532511286756,
                                                           0.88192126434835503,
                                                           0.831469612302545237,
                                                           0.773010453362736961,
                                                           0.707106781186547524,
                                                           0.634393284163645498,
                                                           0.555570233019602225,
                                                           0.471396736825997649,
                                                           0.382683432365089772,
                                                           0.290284677254462368,
                                                           0.195090322016128268,
                                                           0.098017140329560602,
                                                           0};
    const double half_width = 3 - 2 * 1.4142135623730951;
    double e_re[COR_LEG_NODES], e_im[COR_LEG_NODES];
    for (int k = 0; k < octaves; k++)
        for (int j = 0; j < COR_SPECTRUM_TERMS; j++)
            re[k][j] = im[k][j] = 0;
    for (int j = 0; j < COR_SPECTRUM_TERMS; j++) {
        double cosine[COR_SPECTRUM_TERMS]; /* cos(pi k (j + 1/2)/TERMS) */
        for (int k = 0; k < COR_SPECTRUM_TERMS; k++) {
            const int turn = k * (2 * j + 1) % (4 * COR_SPECTRUM_TERMS), half = 2 * COR_SPECTRUM_TERMS,
                      up = turn < half ? turn : 2 * half - turn;
            cosine[k] = up <= half / 2 ? quarter[up] : -quarter[half - up];
        }
        const double x = half_width * cosine[1];
        double omega = first * 1.4142135623730951 * (1 + x) / (1 - x);
        int n = leg->n;
        kernel_exponentials(n, leg->p_re, leg->p_im, omega, e_re, e_im);
        for (int octave = 0; octave < octaves; octave++, omega *= 2) {
            double sum_re, sum_im;
            while (n > COR_LEG_PART && omega * leg->p_re[n - COR_LEG_PART] > 60) /* 2^-86 */
                n -= COR_LEG_PART;
            kernel_sum_and_square(n, leg->w_re, leg->w_im, e_re, e_im, &sum_re, &sum_im);
            const double factor = omega * omega / (double)COR_SPECTRUM_TERMS;
            for (int k = 0; k < COR_SPECTRUM_TERMS; k++) {
                const double c = (k == 0 ? factor : 2 * factor) * cosine[k];
                re[octave][k] += c * sum_re;
                im[octave][k] += c * sum_im;
            }
        }
    }
}

/* Clenshaw's recurrence for lines of one octave, which begins at `start` */
KERNEL void kernel_lines(const struct cor_spectrum *spectrum, int octave, double start, int n,
                         const double *restrict omega, struct cor_lines *restrict lines)
{
    const double middle = 1.4142135623730951 * start, scale = 3 + 2 * 1.4142135623730951;
    const double *const c_re = spectrum->a_re[octave], *const c_im = spectrum->a_im[octave];
    for (int i = 0; i < n; i++) {
        const double x = scale * (omega[i] - middle) / (omega[i] + middle), inverse = 1 / (omega[i] * omega[i]);
        double r1 = c_re[COR_SPECTRUM_TERMS - 1], r2 = 0, m1 = c_im[COR_SPECTRUM_TERMS - 1], m2 = 0;
        for (int k = COR_SPECTRUM_TERMS - 2; k > 0; k--) {
            const double r = 2 * x * r1 - r2 + c_re[k], m = 2 * x * m1 - m2 + c_im[k];
            r2 = r1;
            r1 = r;
            m2 = m1;
            m1 = m;
        }
        const struct pair_of_numbers turn = kernel_sincos(omega[i] * spectrum->half_time);
        lines->re[i] = (x * r1 - r2 + c_re[0]) * inverse;
        lines->im[i] = (x * m1 - m2 + c_im[0]) * inverse;
        lines->cosine[i] = turn.cosine;
        lines->sine[i] = turn.sine;
        lines->other[i] = 0;
    }
    if (octave >= spectrum->edges)
        return;
    const double *const c = spectrum->b[octave];
    for (int i = 0; i < n; i++) {
        const double x = scale * (omega[i] - middle) / (omega[i] + middle), inverse = 1 / (omega[i] * omega[i]);
        double b1 = c[COR_SPECTRUM_TERMS - 1], b2 = 0;
        for (int k = COR_SPECTRUM_TERMS - 2; k > 0; k--) {
            const double b = 2 * x * b1 - b2 + c[k];
            b2 = b1;
            b1 = b;
        }
        lines->other[i] = (x * b1 - b2 + c[0]) * inverse * kernel_decay(omega[i] * spectrum->decay);
    }
}

/* ---- sums over modes ---- */

/* A smooth step from 0 to 1, whose first three derivatives vanish at both ends */
KERNEL double kernel_fade(double x)
{
    const double y = x < 0 ? 0 : x > 1 ? 1 : x, square = y * y;
    return square * square * (35 + y * (-84 + y * (70 - 20 * y)));
}

/* r(x), x = (omega/omega_max - 0.15)/0.85; r(0) = 0, r(1) = 1. With r = 1 beyond omega_max, an echo at T = tau + dT
 * contributes to the sum
 *
 *     F(u) = int r z^(-3 - 1/2) exp(i u z) dz,     z = omega/omega_max, u = omega_max dT,
 *
 * times a factor that is the same for all r. max |F| = |F(0)| = 0.290, and |F| < 0.09 from u = 15 on, 0.03 from 30. A
 * fade from 0.65 without a negative part has 0.66 instead of 0.29. No weight has less than about 0.18, the norm of the
 * Hankel operator (1 + x + y)^(-7/2); weights near this bound fall off more slowly. */
KERNEL double kernel_echo_weight(double x)
{
    const double y = x < 0 ? 0 : x, square = y * y;
    return square * square * y * (5 + y * (16 * y - 20));
}

KERNEL double kernel_bump(double omega, const double window[2])
{
    const double x = (omega - window[0]) / (window[1] - window[0]), y = 4 * x * (1 - x), inside = y < 0 ? 0 : y;
    const double square = inside * inside;
    return square * square;
}

KERNEL void kernel_weigh(const struct cor_fading *fading, const double *restrict omega, const double *restrict beyond,
                         const double *restrict through, struct cor_mode_weights *restrict weights,
                         double *restrict low_strength, double *restrict high_strength)
{
    double all_low[COR_LINES], all_high[COR_LINES];
    for (int i = 0; i < COR_LINES; i++) {
        const double strength = weights->strength[i];
        weights->mean[i] = kernel_fade((omega[i] - fading->mean_from) / (fading->to - fading->mean_from)) * strength;
        weights->echo[i] = kernel_echo_weight((omega[i] - fading->echo_from) / (fading->to - fading->echo_from)) *
                           strength * beyond[i];
        all_low[i] = kernel_bump(omega[i], fading->low) * strength;
        all_high[i] = kernel_bump(omega[i], fading->high) * strength;
        weights->low[i] = all_low[i] * through[i];
        weights->high[i] = all_high[i] * through[i];
    }
    for (int i = 0; i < COR_LINES; i++) {
        *low_strength += all_low[i];
        *high_strength += all_high[i];
    }
}

/* part[l] += sum of x y over every COR_LEG_PART-th number */
KERNEL double kernel_dot(const double *restrict x, const double *restrict y)
{
    double part[COR_LEG_PART] = {0};
    for (int i = 0; i < COR_LINES; i += COR_LEG_PART)
        for (int l = 0; l < COR_LEG_PART; l++)
            part[l] += x[i + l] * y[i + l];
    return kernel_total(part);
}

KERNEL void kernel_sum(const struct cor_lines *restrict lines, const struct cor_mode_weights *restrict weights,
                       struct cor_mode_sums *restrict sums, double *restrict fraction)
{
    double mean[COR_LINES], more[COR_LINES], cosine[COR_LINES], sine[COR_LINES];
    for (int i = 0; i < COR_LINES; i++) {
        const double re = lines->re[i], im = lines->im[i], other = lines->other[i];
        const double c = lines->cosine[i], s = lines->sine[i], x = 2 * (c * re - s * im + other);
        fraction[i] = weights->strength[i] * (x * x);
        mean[i] = 2 * (re * re + im * im) + 4 * other * other;
        more[i] = x * x - mean[i];
        cosine[i] = c * c - s * s;
        sine[i] = 2 * c * s;
    }
    for (int i = 0; i < COR_LINES; i++) /* in sequence, as a caller would add them */
        sums->fraction += fraction[i];
    sums->faded += kernel_dot(weights->mean, mean) + kernel_dot(weights->echo, more);
    sums->low[0] += kernel_dot(weights->low, cosine);
    sums->low[1] += kernel_dot(weights->low, sine);
    sums->low[2] += kernel_dot(weights->low, lines->cosine);
    sums->low[3] += kernel_dot(weights->low, lines->sine);
    sums->high[0] += kernel_dot(weights->high, cosine);
    sums->high[1] += kernel_dot(weights->high, sine);
    sums->high[2] += kernel_dot(weights->high, lines->cosine);
    sums->high[3] += kernel_dot(weights->high, lines->sine);
}

/* Newton's interpolation in 1/n */
KERNEL double kernel_newton(const struct cor_surface_fit *fit, const double *c, double x)
{
    double value = c[COR_SURFACE_FITTED - 1];
    for (int i = COR_SURFACE_FITTED - 2; i >= 0; i--)
        value = value * (x - fit->node[i]) + c[i];
    return value;
}

KERNEL void kernel_surface(const struct cor_surface_fit *fit, int n, double *restrict omega, double *restrict strength)
{
    for (int i = 0; i < COR_LINES; i++) {
        const double number = n + i, x = 1 / number;
        omega[i] = fit->speed * number + kernel_newton(fit, fit->omega, x);
        strength[i] = omega[i] * kernel_newton(fit, fit->strength, x);
    }
}

KERNEL void kernel_blend(int nodes, const double *weight, const double *const *in, int count, double *out)
{
    for (int i = 0; i < count; i += COR_LEG_PART) {
        double sum[COR_LEG_PART] = {0};
        for (int k = 0; k < nodes; k++)
            for (int l = 0; l < COR_LEG_PART; l++)
                sum[l] += weight[k] * in[k][i + l];
        memcpy(out + i, sum, sizeof sum);
    }
}

#endif
