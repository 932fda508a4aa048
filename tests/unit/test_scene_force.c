/* SPDX-License-Identifier: MIT */
/* Tests the largest force of a collision by its limits and by two methods that must agree. tests/gen/test_contact.c
 * integrates the force. */
#include "../reference/ode.h"
#include "scene.h"

/* Returns the largest force of Hunt and Crossley's law over many speeds v. The overlap x is from the integral of the
 * motion, x^(a+1) = (a+1) (f(beta) - f(beta v))/beta^2 with f(z) = z - ln(1 + z). */
static double crossley_force(double a, double beta)
{
    const double all = beta - log1p(beta);
    double most = 0;
    for (int i = 0; i <= 20000; i++) {
        const double z = beta * i / 20000;
        const double power = (a + 1) * (all - (z - log1p(z))) / (beta * beta);
        most = fmax(most, pow(fmax(power, 0), a / (a + 1)) * (1 + z));
    }
    return most;
}

TEST(forces)
{
    const struct cor_exponents linear = cor_law_exponents[COR_LAW_LINEAR], tsuji = cor_law_exponents[COR_LAW_TSUJI],
                               crossley = cor_law_exponents[COR_LAW_HUNT_CROSSLEY],
                               sphere = cor_law_exponents[COR_LAW_VISCOELASTIC];
    check_near(cor_law_force_max(&linear, 0), 1, 1e-15);
    check_near(cor_law_force_max(&tsuji, 0), pow(1.25, 0.6), 1e-15);
    check_near(cor_law_force_max(&crossley, 0), pow(1.25, 0.6), 1e-15);
    check_near(cor_law_force_max(&sphere, 0), pow(1.25, 0.6), 1e-12);
    /* linear: the largest force is exp(-zeta (3 phi - pi)/sin(phi)), phi = acos(zeta), up to zeta = 1/2; above, it is
     * 2 zeta, at the first moment */
    for (double zeta = 0.01; zeta < 0.5; zeta += 0.01) {
        const double phi = acos(zeta);
        check_near(cor_law_force_max(&linear, zeta), exp(-zeta * (3 * phi - 3.14159265358979323846) / sin(phi)), 1e-14);
    }
    check_near(cor_law_force_max(&linear, 0.7), 1.4, 1e-15);
    /* both branches of Tsuji's force, and the limit between them */
    const double middle = cor_law_force_max(&tsuji, 1);
    for (double gap = 1e-3; gap > 1e-15; gap /= 10)
        for (int sign = -1; sign <= 1; sign += 2)
            check(fabs(cor_law_force_max(&tsuji, 1 + sign * gap) / middle - 1) < 1.5 * gap + 4e-15, "gap %g: %.17g",
                  gap, cor_law_force_max(&tsuji, 1 + sign * gap));
    assert_true(cor_law_force_max(&tsuji, 1e8) > 1e6 && isfinite(cor_law_force_max(&tsuji, 1e8)));
    /* the integration for exponents next to (1, 0) and (3/2, 3/2), which have closed forms */
    const struct cor_exponents near = {6, 6, 4};
    check_near(cor_law_force_max(&near, 3), cor_law_force_max(&crossley, 3), 1e-15);
    for (double beta = 0.05; beta < 100; beta *= 3)
        check_near(cor_law_force_max(&crossley, beta), crossley_force(1.5, beta), 1e-6);
    /* Hunt and Crossley's law with small and large damping needs f(z) = z - ln(1 + z) for every size of z */
    check_near(cor_law_force_max(&crossley, 1e-9), pow(1.25, 0.6), 1e-8);
    check_near(cor_law_force_max(&crossley, 0.1), cor_law_force_max(&crossley, nextafter(0.1, 1)), 1e-14);
    check_nan(cor_law_force_max(&tsuji, -1), cor_law_force_max(&sphere, NAN), cor_law_force_max(&crossley, INFINITY));
    /* eps of a law without functions needs a solver */
    const struct cor_scene_contact contact = {.law = {2, 1, 1}, .mass_kg = 1, .stiffness = 1, .damping = 1};
    double eps = 0;
    assert_true(cor_scene_eps(&eps, &contact, 1, COR_END_ZERO_FORCE) == COR_FAULT_SOLVER && isnan(eps));
    /* exponents with too many powers are refused quickly */
    const struct cor_exponents many = {900000007, 700000001, 999999989};
    const double begin = processor_seconds();
    assert_true(isnan(cor_law_force_max(&many, 0.5)) && processor_seconds() - begin < 0.1);
    /* at strong damping, the spring does not affect the loading of a sphere: X'' + sqrt(X) X' = 0, and the speed is
     * V = 1 - (2/3) X^(3/2). The largest force beta^(2/3) sqrt(X) V is beta^(2/3) (3/4) (3/8)^(1/3). */
    check_near(cor_law_force_max(&sphere, 1e9), pow(1e9, 2.0 / 3) * 0.75 * cbrt(0.375), 1e-12);
}

/* Returns the largest force to first order in mu, for b > 0 (docs/theory.md, 9). The overlap is beta^(-1/(b+1)) X. */
static double strongly_damped(double a, double b, double mu)
{
    enum { STEPS = 400 };
    const double top = pow(b * (b + 1) / (2 * b + 1), 1 / (b + 1));
    double lost = 0; /* the speed lost to the spring: the integral of X^a/V by Simpson's rule in u, X = top u^4 */
    for (int i = 0; i <= STEPS; i++) {
        const double u = (double)i / (double)STEPS, x = top * u * u * u * u, speed = 1 - pow(x, b + 1) / (b + 1);
        lost += (i % STEPS == 0 ? 1 : 2 + 2 * (i % 2)) * pow(x, a) / speed * 4 * top * u * u * u / (3 * STEPS);
    }
    return (b + 1) / (2 * b + 1) * pow(top, b) + mu * (pow(top, a) - pow(top, b) * lost);
}

/* Hertz's spring, x = w^2, and a dashpot */
static long double dashpot_force(long double w, long double v, const void *beta)
{
    return w * w * w + *(const double *)beta * v;
}

/* For any damping, up to the largest doubles, the integration agrees with the limit without the spring. */
TEST(strong_damping)
{
    const struct cor_exponents dashpot = cor_law_exponents[COR_LAW_HERTZ_DASHPOT];
    const double weak = random_uniform(&draw, 0.1, 1.2);
    /* b = 0: the damping force is largest at first, but a later maximum may exceed it */
    const struct motion motion = {2, 0, dashpot_force, &weak, 0, 0};
    check_near(cor_law_force_max(&dashpot, weak), motion_course(&motion).force_max, 1e-11);
    for (size_t i = 0; i < points(2000); i++) {
        const size_t a4 = 1 + random_below(&draw, 40), b4 = random_below(&draw, 40);
        const double a = (double)a4 / 4, b = (double)b4 / 4, mu = random_log(&draw, 1e-22, 1e-8);
        const double beta = pow(mu, -(b + 1) / (a + 1)), strongest = random_log(&draw, 1, 1e308);
        const struct cor_exponents law = {(int)a4, (int)b4, 4};
        if (2 * b4 + 4 == a4 || a4 == b4 || !(beta < 1e300) || (b4 == 0 && a4 < 4))
            continue;
        check(cor_law_force_max(&law, strongest) > 0, "%g, %g: %g", a, b, strongest);
        const double scaled = cor_law_force_max(&law, beta) / pow(beta, 1 / (b + 1));
        check_near(scaled, b4 == 0 ? 1 : strongly_damped(a, b, mu), COR_LAW_FORCE_MAX_ERROR + 1e4 * mu * mu);
    }
}
