/* SPDX-License-Identifier: MIT */
/* The largest force of a collision */
#include <math.h>

#include "cor/scene.h"
#include "runtime/scene/exponents.h"
#include "runtime/scene/series.h"

/* ---- q = 0: u = x^((a+1)/2) obeys u'' + 2 zeta w u' + w^2 u = 0 with w^2 = (a+1)/2 ----
 *
 * In the phase theta of the damped oscillation, with cos(phi) = zeta and p = (a-1)/(a+1), the force is
 *
 *     [(w/sin(phi)) exp(-theta cot(phi))]^(1+p) sin(theta)^p sin(2 phi - theta)
 *
 * Its derivative vanishes where (1+p) cos(3 phi - 2 theta) = p cos(phi) + cos(3 phi). Beyond zeta = 1 the angles are
 * imaginary and the functions hyperbolic. */

/* theta/phi at zeta = 1, the limit of both branches */
static double phase_limit(double p)
{
    return (3 - sqrt((p + 9) / (p + 1))) / 2;
}

static double force_linear(const struct cor_exponents *law, double zeta)
{
    const double a = cor_elastic(law), p = (a - 1) / (a + 1), root = sqrt((a + 1) / 2);
    if (p == 0 && zeta >= 0.5)
        return 2 * zeta; /* at the first moment */
    const double sine = sqrt(fabs((1 - zeta) * (1 + zeta)));
    if (sine == 0) {
        const double r = phase_limit(p);
        return pow(root * exp(-r), 1 + p) * pow(r, p) * (2 - r);
    }
    const int over = zeta > 1;
    const double phi = over ? asinh(sine) : atan2(sine, zeta);
    /* cos(3 phi - 2 theta) = 1 - 2 s^2: the form in half angles keeps its relative accuracy where phi is small */
    const double h1 = over ? sinh(phi / 2) : sin(phi / 2), h3 = over ? sinh(1.5 * phi) : sin(1.5 * phi);
    const double s = sqrt((p * h1 * h1 + h3 * h3) / (1 + p));
    const double theta = over ? 1.5 * phi - asinh(s) : 1.5 * phi - asin(fmin(s, 1));
    const double rise = over ? sinh(theta) : sin(theta), fall = over ? sinh(2 * phi - theta) : sin(2 * phi - theta);
    /* products of the two hyperbolic sines and the exponential stay in range by logarithms */
    return exp((1 + p) * (log(root / sine) - theta * zeta / sine) + p * log(rise) + log(fall));
}

/* ---- a = b: v dv/(1 + beta v) = -x^a dx ---- */

/* z - ln(1 + z) with relative accuracy */
static double log_rest(double z)
{
    if (fabs(z) > 0.1)
        return z - log1p(z);
    double sum = 0;
    for (int k = 18; k >= 2; k--)
        sum = 1.0 / k - z * sum;
    return z * z * sum;
}

/* The force is largest where a v = beta x^(a+1); with z = beta v that is a z + (a+1) f(z) = (a+1) f(beta), f =
 * log_rest. */
static double force_hunt_crossley(const struct cor_exponents *law, double beta)
{
    const double a = cor_elastic(law), wanted = (a + 1) * log_rest(beta);
    if (beta == 0)
        return pow((a + 1) / 2, a / (a + 1));
    double z = fmin(wanted / a, beta); /* convex and increasing: Newton's steps fall to the root from above */
    for (int k = 0; k < 100; k++) {
        const double step = (a * z + (a + 1) * log_rest(z) - wanted) / (a + (a + 1) * z / (1 + z));
        z -= step;
        if (fabs(step) <= 0x1p-52 * z)
            break;
    }
    return pow(a * (z / beta) / beta, a / (a + 1)) * (1 + z);
}

/* ---- other exponents ----
 *
 * With x = w^d and dt = d w^(d-1) ds the law is the polynomial system
 *
 *     dw/ds = v,     dv/ds = -d w^(d-1) F,     F = elastic w^(a d) + damper w^(b d) v
 *
 * which is regular at x = 0 and at the turning point v = 0. */

struct force_system {
    double elastic, damper;
    int d, ad, bd;
};

static double system_force(const struct force_system *system, const double y[2])
{
    return system->elastic * whole_power(y[0], system->ad) + system->damper * whole_power(y[0], system->bd) * y[1];
}

static void system_slope(double slope[2], const struct force_system *system, const double y[2])
{
    slope[0] = y[1];
    slope[1] = -(double)system->d * whole_power(y[0], system->d - 1) * system_force(system, y);
}

/* dF/ds */
static double force_slope(const struct force_system *system, const double y[2])
{
    double slope[2];
    system_slope(slope, system, y);
    double sum = system->damper * whole_power(y[0], system->bd) * slope[1];
    if (system->ad > 0)
        sum += system->elastic * (double)system->ad * whole_power(y[0], system->ad - 1) * slope[0];
    if (system->bd > 0)
        sum += system->damper * (double)system->bd * whole_power(y[0], system->bd - 1) * slope[0] * y[1];
    return sum;
}

/* One step of Dormand and Prince's method of order 5; returns the difference from its method of order 4. */
static double force_step(double next[2], const struct force_system *system, const double y[2], double h)
{
    static const double weight[7][6] = {{0},
                                        {1.0 / 5},
                                        {3.0 / 40, 9.0 / 40},
                                        {44.0 / 45, -56.0 / 15, 32.0 / 9},
                                        {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                                        {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                                        {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
    static const double error[7] = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                    -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
    double slope[7][2], difference[2] = {0, 0};
    for (int i = 0; i < 7; i++) {
        for (int c = 0; c < 2; c++) {
            double sum = 0;
            for (int k = 0; k < i; k++)
                sum += weight[i][k] * slope[k][c];
            next[c] = y[c] + h * sum;
        }
        system_slope(slope[i], system, next);
        for (int c = 0; c < 2; c++)
            difference[c] += h * error[i] * slope[i][c];
    }
    return fmax(fabs(difference[0]), fabs(difference[1]));
}

/* The largest force between y and the end of a step at which the force falls again: the zero of its slope */
static double force_in_step(const struct force_system *system, const double y[2], double h)
{
    double low = 0, high = h, at[2] = {y[0], y[1]};
    for (int k = 0; k < 60 && high - low > 1e-9 * h; k++) {
        const double middle = (low + high) / 2;
        force_step(at, system, y, middle);
        if (force_slope(system, at) > 0)
            low = middle;
        else
            high = middle;
    }
    return system_force(system, at);
}

/* No force between y and the turning point is larger: v falls, and dv/dx <= -damper x^b bounds the overlap. */
static double force_ahead(const struct force_system *system, const double y[2])
{
    const double b1 = (double)system->bd / (double)system->d + 1, a = (double)system->ad / (double)system->d;
    const double x = pow(whole_power(y[0], system->bd + system->d) + b1 * y[1] / system->damper, 1 / b1);
    return system->elastic * pow(x, a) + system->damper * pow(x, b1 - 1) * y[1];
}

#define FORCE_STEP_ERROR 1e-15 /* of w and v, whose scales are 1 */

/* Strong damping makes v fall exponentially; below FORCE_STEP_ERROR the method would not find the turning point. */
static double force_integrated(const struct force_system *system)
{
    double y[2] = {0, 1}, next[2], h = 1e-3, most = system_force(system, y);
    while (y[1] > 0 && !(force_ahead(system, y) < most)) {
        const double error = force_step(next, system, y, h);
        if (error > FORCE_STEP_ERROR && h > 1e-9) {
            h *= fmax(0.2, 0.9 * pow(FORCE_STEP_ERROR / error, 0.2));
            continue;
        }
        if (force_slope(system, next) < 0 && (y[0] == 0 || force_slope(system, y) > 0))
            most = fmax(most, force_in_step(system, y, h));
        y[0] = next[0];
        y[1] = next[1];
        h *= fmin(2, 0.9 * pow(FORCE_STEP_ERROR / fmax(error, 1e-20), 0.2));
    }
    return fmax(most, system_force(system, y));
}

/* The largest force where mu = 0: X^b (1 - X^(b+1)/(b+1)) at X^(b+1) = b (b+1)/(2 b + 1). The spring changes it by less
 * than 50 mu of itself (docs/theory.md, 9). */
static double force_overdamped(double b)
{
    return (b + 1) / (2 * b + 1) * pow(b * (b + 1) / (2 * b + 1), b / (b + 1));
}

#define FORCE_SPRING_LEAST 0x1p-48 /* of mu, below which the spring is left out */

/* From beta = 1 on the damping sets the scales: x = beta^(-1/(b+1)) X, X'' + X^b X' + mu X^a = 0. */
static double force_power(const struct cor_exponents *law, double beta)
{
    const double b1 = cor_damping(law) + 1, a1 = cor_elastic(law) + 1;
    if (beta <= 1)
        return force_integrated(&(struct force_system){1, beta, law->denominator, law->elastic, law->damping});
    const double mu = pow(beta, -a1 / b1);
    return pow(beta, 1 / b1) *
           (mu < FORCE_SPRING_LEAST
                ? force_overdamped(b1 - 1)
                : force_integrated(&(struct force_system){mu, 1, law->denominator, law->elastic, law->damping}));
}

double cor_law_force_max(const struct cor_exponents *law, double damping)
{
    if (!(damping >= 0 && damping < INFINITY))
        return NAN;
    if (cor_law_is_constant(law))
        return force_linear(law, damping);
    return (cor_law_is_hunt_crossley(law) ? force_hunt_crossley : force_power)(law, damping);
}
