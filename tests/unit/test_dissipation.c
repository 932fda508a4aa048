/* SPDX-License-Identifier: MIT */
/* Tests the dissipation time of a Kelvin-Voigt solid and its limits against the complex contact modulus, which defines
 * it. Also tests it against the hereditary integral of viscoelastic contact at finite rates. */
#include "check.h"

#include <cor/cor.h>

/* Returns Y/(1 - nu^2) from shear modulus mu and bulk modulus k. */
static long double contact_modulus(long double mu, long double k)
{
    return 4 * mu * (mu + 3 * k) / (4 * mu + 3 * k);
}

struct material {
    double eta1, eta2, young, nu;
};

static struct material random_material(void)
{
    return (struct material){random_log(&draw, 1e-6, 1e9), random_log(&draw, 1e-6, 1e9), random_log(&draw, 1e3, 1e12),
                             random_uniform(&draw, -0.99, 0.5)};
}

static double time_of(struct material m)
{
    return cor_dissipation_time_viscous_s(m.eta1, m.eta2, m.young, m.nu);
}

/* A is d ln(E*)/ds at s = 0, where mu + s eta_1/2 and k + s eta_2 replace the moduli mu and k. A central difference
 * gives six digits. */
TEST(derivative_of_the_modulus)
{
    for (size_t i = 0; i < points(20000); i++) {
        const struct material m = random_material();
        const long double mu = m.young / (2 * (1 + (long double)m.nu)), k = m.young / (3 * (1 - 2 * (long double)m.nu));
        const long double s = 1e-6L * fminl(mu / m.eta1, k / m.eta2);
        const long double up = contact_modulus(mu + s * m.eta1 / 2, k + s * m.eta2);
        const long double down = contact_modulus(mu - s * m.eta1 / 2, k - s * m.eta2);
        const long double exact = (logl(up) - logl(down)) / (2 * s);
        check_near(time_of(m), exact, 1e-7);
    }
}

TEST(rounding)
{
    for (size_t i = 0; i < points(100000); i++) {
        const struct material m = random_material();
        const long double nu = m.nu, volume = 1 - 2 * nu;
        const long double exact =
            (1 + nu) / ((1 - nu) * m.young) * (2 * (1 - nu + nu * nu) / 3 * m.eta1 + volume * volume * m.eta2);
        check_ulp(time_of(m), exact, COR_CONTACT_MAX_ULP);
    }
}

/* If viscous constants are proportional to the moduli, the stress is (1 + tau d/dt) times the elastic one. A is tau in
 * both formulas. */
TEST(proportional_constants)
{
    for (size_t i = 0; i < points(2000); i++) {
        const double nu = random_uniform(&draw, 0.05, 0.45), young = random_log(&draw, 1e3, 1e12), tau = 1e-4;
        const double eta1 = tau * young / (1 + nu), eta2 = tau * young / (3 * (1 - 2 * nu));
        check_near(cor_dissipation_time_viscous_s(eta1, eta2, young, nu), tau, 1e-14);
        check_near(cor_dissipation_time_s(eta1, eta2, young, nu), tau, 1e-11);
    }
}

/* Computes the force while a sphere is loaded at a finite rate. E*(s) is c0 + c1 s + c2/(s + c3) by partial fractions.
 * So with x^(3/2) = p(t), F/(4/3 sqrt(R)) = c0 p + c1 p' + c2 int exp(-c3 (t - t')) p(t') dt' (Lee and Radok, J. Appl.
 * Mech. 27, 438 (1960)). The error of E* (p + A p') is of the order of the rate squared. */
static long double hereditary_force(const struct material *m, long double rate, long double *first_order)
{
    const long double mu = m->young / (2 * (1 + (long double)m->nu)), k = m->young / (3 * (1 - 2 * (long double)m->nu));
    const long double a = m->eta1 / 2, b = m->eta2;
    /* E* is 4 M (M + 3 K)/(4 M + 3 K) with M = mu + a s and K = k + b s; the denominator is q (s + pole) */
    const long double q = 4 * a + 3 * b, pole = (4 * mu + 3 * k) / q;
    const long double top2 = 4 * a * (a + 3 * b), top1 = 4 * (mu * (a + 3 * b) + a * (mu + 3 * k)),
                      top0 = 4 * mu * (mu + 3 * k);
    const long double c1 = top2 / q, c0 = (top1 - c1 * (4 * mu + 3 * k)) / q, c2 = (top0 - c0 * (4 * mu + 3 * k)) / q;
    /* p = (1 - cos(rate t)), at rate t = 1 */
    const long double t = 1 / rate, p = 1 - cosl(1), dp = rate * sinl(1);
    long double memory = 0;
    enum { STEPS = 4000 };
    for (int i = 0; i <= STEPS; i++) { /* Simpson, dense where exp(-pole (t - t')) is not small */
        const long double u = (long double)i / (double)STEPS, span = fminl(t, 60 / pole), back = span * u;
        const long double weight = (i == 0 || i == STEPS ? 1 : i % 2 ? 4 : 2) * span / (3 * STEPS);
        memory += weight * expl(-pole * back) * (1 - cosl(rate * (t - back)));
    }
    const long double modulus = contact_modulus(mu, k);
    *first_order = modulus * (p + time_of(*m) * dp);
    return c0 * p + c1 * dp + c2 * memory;
}

TEST(finite_rates)
{
    const struct material materials[] = {
        {3e4, 1e4, 1e7, 0.3}, {1e4, 5e5, 1e7, 0.1}, {2e4, 0, 1e6, 0.45}, {0, 3e4, 1e8, -0.3}};
    for (size_t i = 0; i < sizeof materials / sizeof *materials; i++) {
        const struct material *m = &materials[i];
        const long double tau = time_of(*m);
        long double off[3], first;
        for (int k = 0; k < 3; k++) {
            const long double rate = 0.02L / tau / (1 << k), force = hereditary_force(m, rate, &first);
            off[k] = fabsl(first / force - 1);
        }
        check(off[0] < 1e-3L && off[1] < off[0] / 3.7L + 1e-12L && off[2] < off[1] / 3.7L + 1e-12L, "%zu: %Lg %Lg %Lg",
              i, off[0], off[1], off[2]);
    }
}

TEST(limits)
{
    /* an incompressible solid has Y = 3 mu, and A is (shear viscosity)/mu with the shear modulus mu; (4) gives 0 */
    check_near(cor_dissipation_time_viscous_s(2e3, 7, 3e6, 0.5), 1e3 / 1e6L, 1e-15);
    assert_true(cor_dissipation_time_s(2e3, 7e3, 3e6, 0.5) == 0);
    /* nu = 0: (4) is singular */
    check_near(cor_dissipation_time_viscous_s(3, 5, 7, 0), 1.0L, 1e-15);
    assert_true(cor_dissipation_time_viscous_s(0, 0, 1, 0.3) == 0);
    check_nan(cor_dissipation_time_s(3, 5, 7, 0), cor_dissipation_time_viscous_s(-1, 0, 1, 0.3),
              cor_dissipation_time_viscous_s(1, NAN, 1, 0.3), cor_dissipation_time_viscous_s(1, 1, 0, 0.3),
              cor_dissipation_time_viscous_s(1, 1, INFINITY, 0.3), cor_dissipation_time_viscous_s(1, 1, 1, -1),
              cor_dissipation_time_viscous_s(1, 1, 1, 0.6), cor_dissipation_time_viscous_s(INFINITY, 1, 1, 0.3),
              cor_dissipation_time_viscous_s(1, INFINITY, 1, 0.3));
    /* only the result can leave the range */
    check_near(cor_dissipation_time_viscous_s(1e240, 1e240, 1e240, 0.25), cor_dissipation_time_viscous_s(1, 1, 1, 0.25),
               1e-15);
    check_nan(cor_dissipation_time_viscous_s(1e200, 1e200, 1e-200, 0.25),
              cor_dissipation_time_viscous_s(1e-200, 1e-200, 1e200, 0.25),
              cor_dissipation_time_viscous_s(1e251, 1, 1, 0.25), cor_dissipation_time_viscous_s(1, 1, 1e-251, 0.25));
}
