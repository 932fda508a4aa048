/* SPDX-License-Identifier: MIT */
#include "laws.h"

#include <math.h>

/* Returns acos(zeta)/sqrt(1 - zeta^2) and its continuation above 1. */
static long double phase_time(long double zeta)
{
    const long double square = (1 - zeta) * (1 + zeta);
    if (square == 0)
        return 1;
    return square > 0 ? acosl(zeta) / sqrtl(square) : acoshl(zeta) / sqrtl(-square);
}

/* Returns atan2(2 zeta om, 1 + 2 zeta^2)/om. Well above zeta = 1, the argument of atanh would be too near 1. */
static long double limited_phase_time(long double zeta)
{
    const long double square = (1 - zeta) * (1 + zeta), om = sqrtl(fabsl(square)), below = 1 + 2 * zeta * zeta;
    if (square == 0)
        return 2 / below;
    if (square > 0)
        return atan2l(2 * zeta * om, below) / om;
    if (zeta < 1.5L)
        return atanhl(2 * zeta * om / below) / om;
    return (logl(below + 2 * zeta * om) - logl(1 + 8 * zeta * zeta) / 2) / om;
}

long double reference_ratio_exponent(enum cor_end end, long double zeta)
{
    switch (end) {
    case COR_END_ZERO_OVERLAP:
        return acosl(-1) * zeta / sqrtl((1 - zeta) * (1 + zeta));
    case COR_END_ZERO_FORCE:
        return 2 * zeta * phase_time(zeta);
    case COR_END_LIMITED:
        return zeta * (2 * phase_time(zeta) - limited_phase_time(zeta));
    default:
        return zeta * phase_time(zeta);
    }
}

/* Returns z - ln(1 + z), z > -1. */
static long double energy(long double z)
{
    if (fabsl(z) > 0.3L)
        return z - log1pl(z);
    long double sum = 0;
    for (int k = 60; k >= 2; k--)
        sum = 1.0L / k - z * sum;
    return z * z * sum;
}

/* Returns h = beta eps, the root of f(-h) = f(beta), by Newton's method. f is convex, so from the second iterate on all
 * are on one side of the root. If h is near 1, iterates 1 - h = exp(-f - h) instead. */
static long double rebound(long double beta)
{
    const long double wanted = energy(beta);
    if (beta > 30) {
        long double rest = 0;
        for (int k = 0; k < 20; k++)
            rest = expl(rest - 1 - wanted);
        return 1 - rest;
    }
    long double z = beta > 0 ? -beta / (1 + beta) : beta > -0.1L ? -beta : 2 * wanted + 1;
    for (int k = 0; k < 100; k++) {
        const long double step = (energy(z) - wanted) * (1 + z) / z, next = z - step;
        if (fabsl(step) < 3e-19L * fabsl(z))
            break;
        z = next > -1 ? next : (z - 1) / 2;
    }
    return -z;
}

long double reference_hunt_crossley_eps(long double beta)
{
    return rebound(beta) / beta;
}

long double reference_hunt_crossley_loss(long double beta)
{
    /* the series of 1 - eps, with exact fractions */
    static const long double c[] = {
        2.0L / 3,         -4.0L / 9,       44.0L / 135,        -104.0L / 405,           40.0L / 189,
        -7648.0L / 42525, 2848.0L / 18225, -31712.0L / 229635, 23429344.0L / 189448875, -89072576.0L / 795685275};
    if (fabsl(beta) > 0.01L)
        return 1 - rebound(beta) / beta;
    long double sum = 0;
    for (int k = (int)(sizeof c / sizeof *c) - 1; k >= 0; k--)
        sum = c[k] + beta * sum;
    return beta * sum;
}

long double reference_hunt_crossley_approach_eps(long double beta)
{
    return sqrtl(2 * energy(beta)) / fabsl(beta);
}

long double reference_hunt_crossley_approach_loss(long double beta)
{
    if (fabsl(beta) > 0.1L)
        return 1 - reference_hunt_crossley_approach_eps(beta);
    long double sum = 0; /* 1 - eps^2 */
    for (int k = 40; k >= 1; k--)
        sum = 2.0L / (k + 2) - beta * sum;
    sum *= beta;
    return sum / (1 + sqrtl(1 - sum));
}

/* ---- times ---- */

/* Returns the integral from 0 to 1 of a function of x and 1 - x. It may be singular at both ends, up to x^-0.991. */
static long double quadrature(long double (*f)(long double x, long double below, const long double *parameters),
                              const long double *parameters)
{
    const long double pi = acosl(-1), step = 0.02L;
    long double sum = 0;
    for (int j = -410; j <= 410; j++) {
        const long double t = j * step, q = expl(-pi * sinhl(t)), x = 1 / (1 + q), below = q / (1 + q);
        const long double weight = pi * coshl(t) * x * below;
        if (weight > 0 && x > 0 && below > 0)
            sum += weight * f(x, below, parameters);
    }
    return sum * step;
}

/* Returns exp(zeta s/5) (sin(om s)/om)^(-1/5) at s = end x. Parameters: zeta, om, end, 1 if sinh replaces sin, and pi -
 * om end, which is more accurate if om s is near pi. */
static long double tsuji_integrand(long double x, long double below, const long double *p)
{
    const long double s = p[2] * x;
    const long double sine = p[3] != 0      ? sinhl(p[1] * s)
                             : p[1] * s < 2 ? sinl(p[1] * s)
                                            : sinl(p[4] + p[1] * p[2] * below);
    return expl(p[0] * s / 5) * powl(p[1] == 0 ? s : sine / p[1], -0.2L);
}

/* Returns the integral up to `end`. short_of: pi - om end. */
static long double tsuji_integral(long double zeta, long double end, long double short_of)
{
    const long double square = (1 - zeta) * (1 + zeta);
    const long double p[] = {zeta, sqrtl(fabsl(square)), end, square < 0, short_of};
    return powl(1.25L, -0.6L) * end * quadrature(tsuji_integrand, p);
}

/* Returns the integrand of (5/8)^(2/5) int_0^M (1 - X^(5/2))^(-1/2) dX, M = m^(2/5), in x = X/M. Parameters: (5
 * m/8)^(2/5) and 1 - m. */
static long double limited_integrand(long double x, long double below, const long double *p)
{
    (void)x;
    const long double deficit = -expm1l(2.5L * log1pl(-below)) * (1 - p[1]) + p[1];
    return p[0] / sqrtl(deficit);
}

long double reference_tsuji_time(enum cor_end end, long double zeta)
{
    const long double pi = acosl(-1), om = sqrtl(fabsl((1 - zeta) * (1 + zeta))), a = phase_time(zeta);
    const long double twice = zeta < 1 ? 2 * asinl(zeta) : 0;
    switch (end) {
    case COR_END_APPROACH_ONLY:
        return tsuji_integral(zeta, a, zeta < 1 ? pi - acosl(zeta) : 0);
    case COR_END_ZERO_FORCE:
        return tsuji_integral(zeta, 2 * a, twice);
    case COR_END_ZERO_OVERLAP:
        return tsuji_integral(zeta, pi / om, 0);
    default:
        break;
    }
    const long double square = 8 * zeta * zeta, rest = 1 / (1 + square), phase = limited_phase_time(zeta);
    const long double p[] = {powl(0.625L * square * rest, 0.4L), rest};
    const long double first = quadrature(limited_integrand, p);
    const long double second = tsuji_integral(zeta, 2 * a, twice) - tsuji_integral(zeta, phase, pi - om * phase);
    return first + expl(-zeta * phase / 5) * second;
}

/* Returns the integrand for the loading (b = beta) or rebound (b = -h) of Hunt and Crossley's law. tau = ln((1 + b)/(1
 * + beta v)) is from 0 to ln(1 + b), where the speed v is 0. The overlap X has X^(a+1)/(a+1) = energy_left/beta^2. p:
 * a, b, 1 + b, ln(1 + b), beta */
static long double crossley_integrand(long double x, long double below, const long double *p)
{
    const long double tau = p[3] * x, gone = -expm1l(-tau);
    const long double energy_left = fabsl(tau) < 0.5L ? p[1] * gone - energy(-gone)
                                    : tau > 0         ? p[2] * gone - tau
                                                      : p[2] - expl(p[3] * below) - tau;
    return fabsl(p[3] / p[4]) * powl((p[0] + 1) * energy_left / (p[4] * p[4]), -p[0] / (p[0] + 1));
}

long double reference_crossley_time_of_max_overlap(long double a, long double beta)
{
    return quadrature(crossley_integrand, (const long double[]){a, beta, 1 + beta, log1pl(beta), beta});
}

long double reference_crossley_duration(long double a, long double beta)
{
    const long double h = rebound(beta);
    long double rest = 1 - h; /* here 1 - h may have lost all digits */
    for (int k = 0; k < 200 && beta >= 2; k++)
        rest = expl(rest - 1 - energy(beta));
    const long double p[] = {a, -h, rest, beta < 2 ? log1pl(-h) : rest - 1 - energy(beta), beta};
    return reference_crossley_time_of_max_overlap(a, beta) + quadrature(crossley_integrand, p);
}

long double reference_crossley_elastic_half(long double a)
{
    const long double share = 1 / (a + 1);
    return powl((a + 1) / 2, share) * sqrtl(acosl(-1)) * tgammal(1 + share) / tgammal(0.5L + share);
}

long double reference_crossley_duration_approach_only(long double a, long double beta)
{
    return reference_crossley_time_of_max_overlap(a, beta) +
           reference_crossley_elastic_half(a) * powl(reference_hunt_crossley_approach_eps(beta), (1 - a) / (1 + a));
}
