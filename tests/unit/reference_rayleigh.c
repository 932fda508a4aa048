/* SPDX-License-Identifier: MIT */
/* Computes the cosine integral I of cor/disk.h for each mode, along the real axis,
 *
 *     I(omega) = int_0^(pi/2) sin(theta) cos(omega s(theta)) dtheta,     s(theta) = int_theta^(pi/2) sqrt(y/2) dtheta',
 *     y = 1 + t,     t - ln(1 + t) = 2 ln(v_limit/(v sin(theta))),
 *
 * by Gauss and Legendre's rule in long double. The panels shrink towards both ends, where the integrand has
 * singularities. This reference is independent of the library, whose path of integration leaves the real axis. */
#include <tgmath.h>

#include "reference_rayleigh.h"

typedef long double real;
enum { POINTS = 28, HALVINGS = 40 }; /* points of a panel; halvings towards each end, until only rounding remains */
#define PHASE 30                     /* a panel spans at most this phase omega s of the highest frequency */
#define NEAR 1e-11L                  /* Newton's method ends after a relative step below this; its square is rounding */

static const real pi = 3.14159265358979323846264338327950288L;

/* ---- the rule on [-1, 1], and its integrals from every point to 1 ---- */

struct rule {
    real x[POINTS], w[POINTS], from[POINTS][POINTS];
};

/* Computes P_0 to P_(POINTS + 1). */
static void legendre(real *p, real x)
{
    p[0] = 1;
    p[1] = x;
    for (int k = 2; k <= POINTS + 1; k++)
        p[k] = ((2 * k - 1) * x * p[k - 1] - (k - 1) * p[k - 2]) / k;
}

static void rule_init(struct rule *rule)
{
    const int n = POINTS;
    real p[POINTS][POINTS + 2];
    for (int i = 0; i < n; i++) {
        real x = -cos(pi * (real)(i + 0.75) / (real)(n + 0.5)), slope = 1;
        for (int k = 0; k < 6; k++) {
            legendre(p[i], x);
            slope = n * (x * p[i][n] - p[i][n - 1]) / (x * x - 1);
            x -= p[i][n] / slope;
        }
        legendre(p[i], x);
        rule->x[i] = x;
        rule->w[i] = 2 / ((1 - x * x) * slope * slope);
    }
    /* the Legendre coefficients of the interpolant are (2 k + 1)/2 sum_j w_j P_k(x_j) f_j; the integral of P_k from x
     * to 1 is (P_(k-1)(x) - P_(k+1)(x))/(2 k + 1) */
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            real sum = (1 - rule->x[i]) / 2;
            for (int k = 1; k < n; k++)
                sum += p[j][k] * (p[i][k - 1] - p[i][k + 1]) / 2;
            rule->from[i][j] = sum * rule->w[j];
        }
}

/* ---- the contact law ---- */

/* Computes t of q by Newton's method. It starts above the root and decreases without overshooting. */
static real lambert(real q)
{
    if (!(q > 0))
        return 0;
    const real root = sqrt(2 * q);
    real t = q < 1 ? root * (1 + root / 3 + q / 18) : q + log1p(q) + log1p(q) / q;
    for (int i = 0; i < 20; i++) {
        const real step = (t - log1p(t) - q) * (1 + t) / t;
        t -= step;
        if (!(fabs(step) > NEAR * t))
            break;
    }
    return t;
}

/* Returns ds/dtheta. at_end: x is the distance from theta = pi/2, otherwise from 0. q0 = 2 ln(v_limit/v). */
static real rate(int at_end, real x, real q0)
{
    const real sine = sin(x);
    return sqrt((1 + lambert(at_end ? q0 - log1p(-sine * sine) : q0 - 2 * log(sine))) / 2);
}

/* Adds the panel of x from low to high to the integral I of each mode. *half_time is s at the beginning of the panel
 * and becomes s at its end. s grows towards theta = 0. */
static void add_panel(real *integral, const struct cor_disk_mode *mode, size_t n, const struct rule *rule, int at_end,
                      real low, real high, real q0, real *half_time)
{
    real slope[POINTS];
    const real half = (high - low) / 2, middle = (high + low) / 2, start = *half_time;
    /* theta grows with rule->x at both ends */
    const real sign = at_end ? -1 : 1;
    for (int i = 0; i < POINTS; i++) {
        slope[i] = half * rate(at_end, middle + sign * half * rule->x[i], q0);
        *half_time += rule->w[i] * slope[i];
    }
    for (int i = 0; i < POINTS; i++) {
        const real x = middle + sign * half * rule->x[i], w = half * rule->w[i] * (at_end ? cos(x) : sin(x));
        real s = start;
        for (int j = 0; j < POINTS; j++)
            s += rule->from[i][j] * slope[j];
        for (size_t k = 0; k < n; k++)
            integral[k] += w * cos((real)mode[k].omega * s);
    }
}

long double reference_rayleigh(const struct cor_disk_mode *mode, size_t n, double nu, enum cor_disk_datum datum,
                               double speed, long double *fraction)
{
    struct rule rule;
    const real b = datum == COR_DISK_DATUM_CENTRE_OF_MASS ? -2 * log((real)2) - (1 + (real)nu) / 4 /* of (57) */
                   : datum == COR_DISK_DATUM_DIAMETER     ? -1
                                                          : -1 - (real)nu;
    const real q0 = fmax(2 * ((real)1.5 * log((real)2) + b - 1 - log((real)speed)), (real)0);
    const real most_time = PHASE / (real)mode[n - 1].omega;
    real half_time = 0;
    rule_init(&rule);
    for (size_t i = 0; i < n; i++)
        fraction[i] = 0;
    for (int at_end = 1; at_end >= 0; at_end--)
        for (int i = 0; i <= HALVINGS; i++) {
            const int halved = at_end ? HALVINGS - i : i;
            const real high = ldexp(pi / 4, -halved), low = halved == HALVINGS ? 0 : high / 2;
            const int parts = 1 + (int)((high - low) * rate(at_end, at_end || low == 0 ? high : low, q0) / most_time);
            for (int j = 0; j < parts; j++) {
                const int k = at_end ? j : parts - 1 - j;
                const real from = low + (high - low) * k / parts, to = low + (high - low) * (k + 1) / parts;
                add_panel(fraction, mode, n, &rule, at_end, from, to, q0, &half_time);
            }
        }
    for (size_t i = 0; i < n; i++)
        fraction[i] = pow(2 * (real)mode[i].c * fraction[i], 2);
    return 2 * half_time;
}
