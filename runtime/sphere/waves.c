/* SPDX-License-Identifier: MIT */
/* The energy that elastic waves take from a collision with a massive block, to first order. */
#include <float.h>
#include <math.h>

#include "cor/contact.h"
#include "generated/wave_tables.h"
#include "runtime/core/fifth_root.h"

/* 2 |C_1| (9/4)/(2 pi), C_1 = -(4/5) (5/4)^(4/5) B(4/5, 3/2) of x'' + beta x x' + x^(3/2) = 0 */
#define WAVES_FIRST_ORDER 0.605718214220582471607
/* (9/4) 2 |C_1|/(2 pi) 2^(3/2) (2/3)^(6/5) (4 pi/3)^(-1/5), of a sphere and a half-space of one material */
#define WAVES_ONE_MATERIAL 0.790839575029895332403

static int is_material(double nu)
{
    return nu > -1 && nu <= 0.5;
}

/* Clenshaw's recurrence */
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

/* x^(3/5) */
static double three_fifths(double x)
{
    const double root = cor_inline_fifth_root(x);
    return root * root * root;
}

/* (1 + nu)^(3/2) (1 - nu^2)^(-6/5) as (1 + nu)^(3/10) (1 - nu)^(-6/5) */
double cor_half_space_wave_coefficient(double poisson_ratio)
{
    const double nu = poisson_ratio;
    if (!is_material(nu))
        return NAN;
    const double plus = cor_inline_fifth_root(1 + nu), minus = cor_inline_fifth_root(1 - nu),
                 cube = minus * minus * minus;
    return WAVES_ONE_MATERIAL * cor_half_space_wave_factor(nu) * (plus * sqrt(plus)) / (cube * cube);
}

double cor_contact_wave_loss(const struct cor_sphere_contact *contact, const struct cor_half_space *half_space,
                             double speed_m_s)
{
    const double nu = half_space->poisson_ratio, young = half_space->young_modulus_pa,
                 density = half_space->density_kg_m3;
    if (!(speed_m_s >= 0) || !is_material(nu) || !(young > 0 && young <= DBL_MAX) ||
        !(density > 0 && density <= DBL_MAX) || isnan(contact->elastic_constant_n_m15))
        return NAN;
    if (isinf(speed_m_s))
        return 1;
    /* K^(6/5) m^(-1/5) (g/c_s)^(3/5)/(rho c_s^(12/5)); with c_s^2 = mu/rho the last factors are K^(6/5) (rho/m)^(1/5)
     * mu^(-6/5) */
    const double mu = young / (2 * (1 + nu)), shear_speed = sqrt(mu / density);
    const double ratio = three_fifths(contact->elastic_constant_n_m15 / mu); /* its square is (K/mu)^(6/5) */
    const double mass = cor_inline_fifth_root(density / contact->effective_mass_kg);
    const double loss = WAVES_FIRST_ORDER * cor_half_space_wave_factor(nu) * (ratio * ratio) * mass *
                        three_fifths(speed_m_s / shear_speed);
    return loss < 1 ? loss : 1;
}
