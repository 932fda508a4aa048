/* SPDX-License-Identifier: MIT */
#include "reference_law.h"

#include <math.h>

/* acos(zeta)/sqrt(1 - zeta^2) and what it becomes beyond 1 */
static long double phase_time(long double zeta)
{
    const long double square = (1 - zeta) * (1 + zeta);
    if (square == 0)
        return 1;
    return square > 0 ? acosl(zeta) / sqrtl(square) : acoshl(zeta) / sqrtl(-square);
}

/* atan2(2 zeta om, 1 + 2 zeta^2)/om; beyond 1 the area tangent as a logarithm, since its argument is near 1 */
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

long double reference_ratio_exponent(enum law_end end, long double zeta)
{
    switch (end) {
    case LAW_ZERO_OVERLAP:
        return acosl(-1) * zeta / sqrtl((1 - zeta) * (1 + zeta));
    case LAW_ZERO_FORCE:
        return 2 * zeta * phase_time(zeta);
    case LAW_LIMITED:
        return zeta * (2 * phase_time(zeta) - limited_phase_time(zeta));
    default:
        return zeta * phase_time(zeta);
    }
}

/* z - ln(1 + z), z > -1 */
static long double energy(long double z)
{
    if (fabsl(z) > 0.3L)
        return z - log1pl(z);
    long double sum = 0;
    for (int k = 60; k >= 2; k--)
        sum = 1.0L / k - z * sum;
    return z * z * sum;
}

/* h = beta eps. Newton's method for f(-h) = f(beta) on the side of the root where f is convex towards it; where h is 1
 * but for its last bits, 1 - h = exp(-f - h) is iterated. */
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
    /* LAWS: the series of 1 - eps, exact fractions */
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
