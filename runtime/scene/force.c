/* SPDX-License-Identifier: MIT */
/* The largest force of a collision */
#include "cor/scene.h"

#include <math.h>

#include "runtime/scene/exponents.h"
#include "runtime/scene/motion.h"

/* ---- q = 0: u = x^((a+1)/2) obeys u'' + 2 zeta w u' + w^2 u = 0 with w^2 = (a+1)/2 ----
 *
 * At the phase theta of this damped oscillation, with cos(phi) = zeta and p = (a-1)/(a+1), the force is
 *
 *     [(w/sin(phi)) exp(-theta cot(phi))]^(1+p) sin(theta)^p sin(2 phi - theta)
 *
 * Its derivative vanishes where (1+p) cos(3 phi - 2 theta) = p cos(phi) + cos(3 phi). Beyond zeta = 1 the angles are
 * imaginary and the functions hyperbolic. */

static double force_linear(const struct cor_exponents *law, double zeta)
{
    const double a = cor_elastic(law), p = (a - 1) / (a + 1), root = sqrt((a + 1) / 2);
    if (p == 0 && zeta >= 0.5)
        return cor_quiet_product(2, zeta); /* the force is largest at the first moment */
    if (zeta > 1e100)
        return NAN;
    const double sine = sqrt(fabs((1 - zeta) * (1 + zeta)));
    if (sine == 0) {
        const double r = (3 - sqrt((p + 9) / (p + 1))) / 2; /* theta/phi at zeta = 1, the limit of both branches */
        return pow(root * exp(-r), 1 + p) * pow(r, p) * (2 - r);
    }
    const int over = zeta > 1;
    const double phi = over ? asinh(sine) : atan2(sine, zeta);
    /* cos(3 phi - 2 theta) = 1 - 2 s^2; half angles keep the relative accuracy for small phi */
    const double h1 = over ? sinh(phi / 2) : sin(phi / 2), h3 = over ? sinh(1.5 * phi) : sin(1.5 * phi);
    const double s = sqrt((p * h1 * h1 + h3 * h3) / (1 + p));
    const double theta = over ? 1.5 * phi - asinh(s) : 1.5 * phi - asin(fmin(s, 1));
    const double rise = over ? sinh(theta) : sin(theta), descent = over ? sinh(2 * phi - theta) : sin(2 * phi - theta);
    /* logarithms, because products of hyperbolic sines and the exponential could overflow */
    return exp((1 + p) * (log(root / sine) - theta * zeta / sine) + p * log(rise) + log(descent));
}

/* ---- a = b: v dv/(1 + beta v) = -x^a dx ---- */

/* Returns z - ln(1 + z) with relative accuracy. */
static double log_rest(double z)
{
    if (fabs(z) > 0.1)
        return z - log1p(z);
    double sum = 0;
    for (int k = 18; k >= 2; k--)
        sum = 1.0 / k - z * sum;
    return z * z * sum;
}

/* Returns the largest force, which occurs where a v = beta x^(a+1). z = beta v solves a z + (a+1) f(z) = (a+1) f(beta),
 * where f is log_rest. */
static double force_hunt_crossley(const struct cor_exponents *law, double beta)
{
    const double a = cor_elastic(law), wanted = (a + 1) * log_rest(beta);
    if (beta > 1e280)
        return NAN;
    if (beta < 1e-150)
        return pow((a + 1) / 2, a / (a + 1));
    double z = fmin(wanted / a, beta); /* a convex increasing function: Newton's steps fall to the root from above */
    for (int k = 0; k < 100; k++) {
        const double step = (a * z + (a + 1) * log_rest(z) - wanted) / (a + (a + 1) * z / (1 + z));
        z -= step;
        if (fabs(step) <= 0x1p-52 * z)
            break;
    }
    return cor_quiet_power(a * (z / beta) / beta, a / (a + 1)) * (1 + z);
}

/* ---- other exponents ---- */

#define FORCE_SPRING_LEAST 0x1p-48 /* below this mu the spring is neglected */

/* Returns the largest force. For beta >= 1 the damping sets the scales: x = beta^(-1/(b+1)) X, X'' + X^b X' + mu X^a =
 * 0. For mu = 0 the largest force is X^b (1 - X^(b+1)/(b+1)) at X^(b+1) = b (b+1)/(2 b + 1). The spring changes this
 * force by a relative 50 mu at most (docs/theory.md, 9). */
static double force_power(const struct cor_exponents *law, double beta)
{
    const double b1 = cor_damping(law) + 1, a1 = cor_elastic(law) + 1, b = b1 - 1,
                 mu = cor_quiet_power(fmax(beta, 1), -a1 / b1);
    const double without_spring = (b + 1) / (2 * b + 1) * cor_quiet_power(b * (b + 1) / (2 * b + 1), b / (b + 1));
    if (beta <= 1)
        return cor_pressed_force_max(law, 1, beta);
    return cor_quiet_product(cor_quiet_power(beta, 1 / b1),
                             mu < FORCE_SPRING_LEAST ? without_spring : cor_pressed_force_max(law, mu, 1));
}

double cor_law_force_max(const struct cor_exponents *law, double damping)
{
    if (!(isgreaterequal(damping, 0) && damping < INFINITY) || !cor_law_is_sound(law))
        return NAN;
    if (cor_law_is_constant(law))
        return force_linear(law, damping);
    return (cor_law_is_hunt_crossley(law) ? force_hunt_crossley : force_power)(law, damping);
}
