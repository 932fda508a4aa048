/* SPDX-License-Identifier: MIT */
/* Tests the loss to elastic waves by known values, by another contour for J(nu), and for a sphere and a half-space of
 * one material or of two. */
#include "check.h"

#include <complex.h>

#include <cor/cor.h>

TEST(known_values)
{
    check_ulp(cor_half_space_wave_factor(0.25), 0.930752601914437910L, 8);
    check_near(cor_half_space_wave_coefficient(0.2), 1.0966459, 5e-8);
    check_near(cor_half_space_wave_coefficient(0.33), 1.1475532, 5e-8);
    check_nan(cor_half_space_wave_factor(-1), cor_half_space_wave_factor(0.5000001), cor_half_space_wave_factor(NAN),
              cor_half_space_wave_coefficient(-1), cor_half_space_wave_coefficient(INFINITY));
    /* Rayleigh waves carry 67 % at nu = 1/4 (Miller and Pursey); the rest, the integral over body waves, is positive */
    assert_true(cor_half_space_wave_factor(0.5) > 0.65 && cor_half_space_wave_factor(-0.999999) < 3.84);
}

/* Returns J = Im int x a/R dx over a half circle from 0 to 2 above the branch points and the Rayleigh pole. Uses the
 * trapezoidal rule after a substitution that flattens both ends. */
static long double factor_by_contour(long double nu)
{
    const long double pi = acosl(-1), g2 = (1 - 2 * nu) / (2 * (1 - nu)), end = 3.4L, step = 0.004L;
    long double sum = 0;
    for (int j = -(int)(end / step); j <= (int)(end / step); j++) {
        const long double t = j * step, u = 1 / (1 + expl(-pi * sinhl(t))), below = 1 / (1 + expl(pi * sinhl(t)));
        const long double du = pi * coshl(t) * u * below, angle = pi * below;
        /* x = 1 - cos(pi u) + i sin(pi u) = 1 + exp(i pi (1 - u)) */
        const long double complex x = 1 + cexpl(I * angle), dx = -I * pi * cexpl(I * angle), x2 = x * x;
        /* the roots that are positive for large real x, without a cut above the real axis */
        const long double root_g = sqrtl(g2);
        const long double complex a = csqrtl(x - root_g) * csqrtl(x + root_g), b = csqrtl(x - 1) * csqrtl(x + 1);
        const long double complex d = (2 * x2 - 1) * (2 * x2 - 1) - 4 * x2 * a * b;
        sum += cimagl(x * a / d * dx) * du;
    }
    return sum * step;
}

TEST(another_contour)
{
    for (size_t i = 0; i < points(40); i++) {
        const double nu = i == 0 ? 0.5 : i == 1 ? 0 : random_uniform(&draw, -0.99, 0.5);
        check_ulp(cor_half_space_wave_factor(nu), factor_by_contour(nu), 8);
    }
}

static struct cor_body sphere_of(double young, double nu, double density, double radius)
{
    return (struct cor_body){young, nu, 0, radius, cor_sphere_mass_kg(radius, density)};
}

TEST(collisions)
{
    for (size_t i = 0; i < points(2000); i++) {
        const double young = random_log(&draw, 1e6, 1e12), nu = random_uniform(&draw, -0.5, 0.5);
        const double density = random_log(&draw, 100, 2e4), radius = random_log(&draw, 1e-5, 10);
        const double sound = sqrt(young / density), speed = sound * random_log(&draw, 1e-12, 1e-4);
        const struct cor_body sphere = sphere_of(young, nu, density, radius), wall = {young, nu, 0, INFINITY, INFINITY};
        const struct cor_half_space block = {young, nu, density};
        struct cor_sphere_contact contact;
        assert_int_equal(cor_sphere_contact_init(&contact, &sphere, &wall), COR_OK);
        /* the general formula gives the formula for one material, in which radius and modulus cancel */
        check_near(cor_contact_wave_loss(&contact, &block, speed),
                   cor_half_space_wave_coefficient(nu) * powl(speed / sqrtl((long double)young / density), 0.6L),
                   5e-14);
    }
    /* a rigid sphere with the density of the block has the coefficient 2.553631 at nu = 1/4, and 2.600216 at 0.3 */
    for (int k = 0; k < 2; k++) {
        const double nu = k ? 0.3 : 0.25, wanted = k ? 2.600216 : 2.553631;
        const struct cor_body rigid = sphere_of(INFINITY, 0.2, 2000, 0.01), wall = {1e10, nu, 0, INFINITY, INFINITY};
        const struct cor_half_space block = {1e10, nu, 2000};
        struct cor_sphere_contact contact;
        assert_int_equal(cor_sphere_contact_init(&contact, &rigid, &wall), COR_OK);
        const struct cor_half_space no_density = {1e10, nu, 0}, no_ratio = {1e10, 0.6, 2000};
        check_near(cor_contact_wave_loss(&contact, &block, 1) / pow(1 / sqrt(1e10 / 2000), 0.6), wanted, 1e-6);
        assert_true(cor_contact_wave_loss(&contact, &block, 1e6) == 1);
        check_nan(cor_contact_wave_loss(&contact, &block, -1), cor_contact_wave_loss(&contact, &block, NAN),
                  cor_contact_wave_loss(&contact, &no_density, 1), cor_contact_wave_loss(&contact, &no_ratio, 1));
        cor_sphere_contact_init_g_star(&contact, 1);
        check_nan(cor_contact_wave_loss(&contact, &block, 1));
    }
}

/* Numbers of all magnitudes, so that most powers and quotients in the formula are out of the range of doubles. The
 * reference is the logarithm of the formula. One speed is 0. */
TEST(every_size)
{
    size_t moderate = 0;
    for (size_t i = 0; i < points(20000); i++) {
        const double nu =
            random_below(&draw, 4) == 0 ? -1 + random_log(&draw, 0x1p-53, 1e-3) : random_uniform(&draw, -0.99, 0.5);
        const struct cor_half_space block = {random_log(&draw, COR_SI_LEAST, COR_SI_MOST), nu,
                                             random_log(&draw, COR_SI_LEAST, COR_SI_MOST)};
        struct cor_sphere_contact contact;
        cor_sphere_contact_init_g_star(&contact, 1);
        contact.elastic_constant_n_m15 = random_log(&draw, COR_SI_LEAST, COR_SI_MOST);
        contact.effective_mass_kg = random_log(&draw, COR_SI_LEAST, COR_SI_MOST);
        const long double mu = (long double)block.young_modulus_pa / (2 * (1 + (long double)nu));
        const long double rest = log2l(0.605718214220582471607L) + log2l(cor_half_space_wave_factor(nu)) +
                                 1.2L * log2l(contact.elastic_constant_n_m15) - 1.5L * log2l(mu) +
                                 0.5L * log2l(block.density_kg_m3) - 0.2L * log2l(contact.effective_mass_kg);
        /* a speed of any magnitude, or one with a moderate loss */
        const double at = (double)exp2l((random_uniform(&draw, -60, 0) - rest) / 0.6L);
        const double speed =
            at >= COR_SI_LEAST && at < COR_SI_MOST && i % 2 == 0 ? at : random_log(&draw, COR_SI_LEAST, COR_SI_MOST);
        const long double exact = fminl(exp2l(rest + 0.6L * log2l(speed)), 1);
        const double loss = cor_contact_wave_loss(&contact, &block, speed);
        moderate += exact > 0x1p-60L && exact < 0.9L;
        check(exact < 0x1p-1074L ? loss <= 0x1p-1074 : ulp_error(loss, exact) <= COR_CONTACT_MAX_ULP + 16,
              "K = %a, m = %a, E = %a, nu = %a, density %a, speed %a: %g, not %Lg", contact.elastic_constant_n_m15,
              contact.effective_mass_kg, block.young_modulus_pa, nu, block.density_kg_m3, speed, loss, exact);
        assert_true(cor_contact_wave_loss(&contact, &block, 0) == 0 &&
                    cor_contact_wave_loss(&contact, &block, -0.0) == 0 &&
                    cor_contact_wave_loss(&contact, &block, INFINITY) == 1);
    }
    assert_true(moderate > 0);
}
