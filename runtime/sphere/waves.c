/* SPDX-License-Identifier: MIT */
/* The energy that a collision with a massive block loses to elastic waves, to first order. */
#include <math.h>

#include "cor/contact.h"
#include "generated/wave_tables.h"
#include "runtime/number/si_range.h"
#include "runtime/sphere/contact_parts.h"

/* 2 |C_1| (9/4)/(2 pi), where C_1 = -(4/5) (5/4)^(4/5) B(4/5, 3/2) belongs to x'' + beta x x' + x^(3/2) = 0 */
#define WAVES_FIRST_ORDER 0.605718214220582471607
/* WAVES_FIRST_ORDER times 2^(3/2) (2/3)^(6/5) (4 pi/3)^(-1/5), for a sphere and a half-space of one material */
#define WAVES_ONE_MATERIAL 0.790839575029895332403

static int is_material(double nu)
{
    return isgreater(nu, -1) && islessequal(nu, 0.5);
}

/* Uses Clenshaw's recurrence. */
double cor_half_space_wave_factor(double poisson_ratio)
{
    if (!is_material(poisson_ratio))
        return NAN;
    const double tau = sqrt(1 - 2 * poisson_ratio), x = 2 * (tau / COR_WAVE_FACTOR_END) - 1;
    const double *c = cor_rows_wave_factor(0);
    double next = 0, after = 0;
    for (int k = COR_WAVE_FACTOR_TERMS - 1; k > 0; k--) {
        const double sum = c[k] + (2 * x * next - after);
        after = next;
        next = sum;
    }
    return c[0] + (x * next - after);
}

/* Computes (1 + nu)^(3/2) (1 - nu^2)^(-6/5) as (1 + nu)^(3/10) (1 - nu)^(-6/5). */
double cor_half_space_wave_coefficient(double poisson_ratio)
{
    const double nu = poisson_ratio;
    if (!is_material(nu))
        return NAN;
    const double plus = cor_inline_fifth_root(1 + nu), minus = cor_inline_fifth_root(1 - nu),
                 cube = minus * minus * minus;
    return WAVES_ONE_MATERIAL * cor_half_space_wave_factor(nu) * (plus * sqrt(plus)) / (cube * cube);
}

/* Returns the significand of x > 0 in [1/2, 1), and adds `power` times the exponent to *sum. */
static double significand_of(double x, int power, int *sum)
{
    int exponent;
    const double significand = frexp(x, &exponent);
    *sum += power * exponent;
    return significand;
}

double cor_contact_wave_loss(const struct cor_sphere_contact *contact, const struct cor_half_space *half_space,
                             double speed_m_s)
{
    const double nu = half_space->poisson_ratio, young = half_space->young_modulus_pa,
                 density = half_space->density_kg_m3;
    if (!is_material(nu) || !cor_si_in_range(young) || !cor_si_in_range(density) ||
        !cor_si_in_range(contact->elastic_constant_n_m15) || !cor_si_in_range(contact->effective_mass_kg))
        return NAN;
    if (!cor_si_in_range(speed_m_s))
        return speed_m_s == 0 ? 0 : cor_is_infinity(speed_m_s) ? 1 : (double)NAN;
    /* K^(6/5) m^(-1/5) (g/c_s)^(3/5)/(rho c_s^(12/5)); with c_s^2 = mu/rho this is K^(6/5) m^(-1/5) g^(3/5) rho^(1/2)
     * mu^(-3/2). Any of the factors may leave the range of doubles, so their exponents are added up, in tenths. */
    int tenths = 0;
    const double stiffness = cor_inline_fifth_root(significand_of(contact->elastic_constant_n_m15, 12, &tenths));
    const double mass = cor_inline_fifth_root(significand_of(contact->effective_mass_kg, -2, &tenths));
    const double speed = cor_inline_fifth_root(significand_of(speed_m_s, 6, &tenths));
    const double mu = significand_of(young, -15, &tenths) / significand_of(2 * (1 + nu), 15, &tenths);
    const double root = sqrt(significand_of(density, 5, &tenths) / mu), square = stiffness * stiffness;
    const double rest = sqrt(cor_inline_fifth_root(cor_inline_power_of_two(tenths % 10)));
    const double significands = WAVES_FIRST_ORDER * cor_half_space_wave_factor(nu) * (square * square * square / mass) *
                                (speed * speed * speed) * (root / mu);
    const double loss = tenths > 500 ? 1 : cor_inline_scaled(significands * rest, tenths / 10);
    return loss < 1 ? loss : 1;
}
