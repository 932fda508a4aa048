/* SPDX-License-Identifier: MIT */
#include "cor/contact.h"

#include <float.h>
#include <math.h>

#include "cor/sphere.h"
#include "cor/status.h"
#include "runtime/sphere/eval.h"

/* x^5, rounded once but for what is lost below 2^-100; NaN where that is no normal double. */
static double fifth_power(double x)
{
    if (!(x > 1e-60 && x < 1e60))
        return NAN;
    const struct cor_inline_pair square = cor_inline_product(x, x), one = {x, 0};
    const struct cor_inline_pair power = cor_inline_pair_times(cor_inline_pair_times(square, square), one);
    return power.hi;
}

static void contact_clear(struct cor_sphere_contact *contact)
{
    contact->effective_mass_kg = NAN;
    contact->effective_radius_m = NAN;
    contact->elastic_constant_n_m15 = NAN;
    contact->dissipation_time_s = NAN;
    contact->beta_per_root = NAN;
    contact->scale = NAN;
    contact->beta5_per_speed = NAN;
}

/* Every comparison is written so that NaN fails it. */
static int body_status(const struct cor_body *body)
{
    if (!(body->young_modulus_pa > 0))
        return COR_ERROR_YOUNG_MODULUS;
    if (!(body->poisson_ratio > -1 && body->poisson_ratio <= 0.5))
        return COR_ERROR_POISSON_RATIO;
    if (!(body->dissipation_time_s >= 0) || isinf(body->dissipation_time_s))
        return COR_ERROR_DISSIPATION_TIME;
    if (!(body->radius_m > 0))
        return COR_ERROR_RADIUS;
    if (!(body->mass_kg > 0))
        return COR_ERROR_MASS;
    return COR_OK;
}

static int pair_status(const struct cor_body *body_1, const struct cor_body *body_2)
{
    if (isinf(body_1->radius_m) && isinf(body_2->radius_m))
        return COR_ERROR_BOTH_FLAT;
    if (isinf(body_1->mass_kg) && isinf(body_2->mass_kg))
        return COR_ERROR_BOTH_FIXED;
    if (isinf(body_1->young_modulus_pa) && isinf(body_2->young_modulus_pa))
        return COR_ERROR_BOTH_RIGID;
    return COR_OK;
}

/* x y/(x + y), also where the product would overflow and where one of them is infinite */
static double half_harmonic_mean(double x, double y)
{
    const double small = x < y ? x : y, large = x < y ? y : x;
    return small / (1 + small / large);
}

/* (1 - nu^2)/Y, with no cancellation near nu = -1 */
static double compliance(const struct cor_body *body)
{
    return (1 - body->poisson_ratio) * (1 + body->poisson_ratio) / body->young_modulus_pa;
}

static int in_range(double x)
{
    return x >= DBL_MIN && x <= DBL_MAX;
}

int cor_sphere_contact_init(struct cor_sphere_contact *contact, const struct cor_body *body_1,
                            const struct cor_body *body_2)
{
    if (contact == NULL)
        return COR_ERROR_NULL;
    contact_clear(contact);
    if (body_1 == NULL || body_2 == NULL)
        return COR_ERROR_NULL;
    int status = body_status(body_1);
    if (status == COR_OK)
        status = body_status(body_2);
    if (status == COR_OK)
        status = pair_status(body_1, body_2);
    if (status != COR_OK)
        return status;

    const double c1 = compliance(body_1), c2 = compliance(body_2), c = c1 + c2;
    const double mass = half_harmonic_mean(body_1->mass_kg, body_2->mass_kg);
    const double radius = half_harmonic_mean(body_1->radius_m, body_2->radius_m);
    const double rho = 4 * sqrt(radius) / (3 * c);
    if (!in_range(c) || !in_range(mass) || !in_range(radius) || !in_range(rho))
        return COR_ERROR_RANGE;
    /* weights first: they are exactly 1/2 for equal materials, and nothing can overflow */
    const double a1 = body_1->dissipation_time_s, a2 = body_2->dissipation_time_s;
    const double a = 0.0 + a1 * (c1 / c) + a2 * (c2 / c); /* 0.0: two times of -0 are no dissipation either */
    /* roots first: rho/m may overflow, their quotient cannot */
    const double root = cor_inline_fifth_root(rho) / cor_inline_fifth_root(mass);
    const double beta_per_root = 1.5 * a * (root * root), scale = 1 / (root * root);
    const int dissipates = (a1 > 0 && c1 > 0) || (a2 > 0 && c2 > 0);
    if (!in_range(scale) || (dissipates && !(in_range(a) && in_range(beta_per_root))))
        return COR_ERROR_RANGE;

    contact->effective_mass_kg = mass;
    contact->effective_radius_m = radius;
    contact->elastic_constant_n_m15 = rho;
    contact->dissipation_time_s = a;
    contact->beta_per_root = beta_per_root;
    contact->scale = scale;
    contact->beta5_per_speed = fifth_power(beta_per_root);
    return COR_OK;
}

int cor_sphere_contact_init_g_star(struct cor_sphere_contact *contact, double g_star_m_s)
{
    if (contact == NULL)
        return COR_ERROR_NULL;
    contact_clear(contact);
    if (!(g_star_m_s > 0))
        return COR_ERROR_G_STAR;
    contact->beta_per_root = 1 / (-COR_SPHERE_C1 * cor_inline_fifth_root(g_star_m_s));
    contact->beta5_per_speed = fifth_power(contact->beta_per_root);
    return COR_OK;
}

double cor_contact_g_star_m_s(const struct cor_sphere_contact *contact)
{
    const double root = 1 / (-COR_SPHERE_C1 * contact->beta_per_root), square = root * root;
    return square * square * root;
}

double cor_contact_beta(const struct cor_sphere_contact *contact, double speed_m_s)
{
    double factor = contact->beta_per_root, g = speed_m_s, unit = 1;
    if (!(g >= 0) || isnan(factor))
        return NAN;
    /* without dissipation an infinite speed is no 0 times inf */
    if (factor == 0 || g == 0)
        return 0;
    if (isinf(g))
        return g;
    /* powers of 32, to where the parts of the root are */
    if (g < COR_INLINE_2_M900) {
        g *= COR_INLINE_2_200;
        unit = COR_INLINE_2_M40;
    } else if (g > COR_INLINE_2_900) {
        g *= COR_INLINE_2_M200;
        unit = COR_INLINE_2_40;
    }
    /* and of 2, so that nothing overflows before the result does */
    if (factor > COR_INLINE_2_500) {
        factor *= COR_INLINE_2_M500;
        unit *= COR_INLINE_2_500;
    }
    const struct cor_inline_pair root = cor_inline_fifth_root_parts(g);
    const double head = cor_inline_head(factor), tail = factor - head;
    return (root.hi * head + (root.hi * tail + root.lo * factor)) * unit;
}

/* Where x = beta^5 is between 2^-900 and 2^900, or 0 because a speed of 0 or an underflow made it so (eps is 1), the
 * two roundings in it cost beta less than the root's own; elsewhere the long way. */
static int power_is_good(double x, double speed)
{
    return speed >= 0 && x < COR_INLINE_2_900; /* -0 may be an underflow, NaN is not less */
}

double cor_contact_eps_zero_overlap(const struct cor_sphere_contact *contact, double speed_m_s)
{
    const double x = contact->beta5_per_speed * speed_m_s;
    return power_is_good(x, speed_m_s) ? cor_inline_eps_zero_overlap_root(x)
                                       : cor_inline_eps_zero_overlap(cor_contact_beta(contact, speed_m_s));
}

double cor_contact_eps_zero_force(const struct cor_sphere_contact *contact, double speed_m_s)
{
    const double x = contact->beta5_per_speed * speed_m_s;
    return power_is_good(x, speed_m_s) ? cor_inline_eps_zero_force_root(x)
                                       : cor_inline_eps_zero_force(cor_contact_beta(contact, speed_m_s));
}

double cor_contact_duration_s_zero_overlap(const struct cor_sphere_contact *contact, double speed_m_s)
{
    const double beta = cor_contact_beta(contact, speed_m_s);
    if (isinf(beta) && !isnan(contact->scale))
        return INFINITY;
    return contact->scale / cor_inline_fifth_root(fabs(speed_m_s)) * cor_inline_duration_zero_overlap(beta);
}

double cor_contact_duration_s_zero_force(const struct cor_sphere_contact *contact, double speed_m_s)
{
    const double beta = cor_contact_beta(contact, speed_m_s);
    return contact->scale / cor_inline_fifth_root(fabs(speed_m_s)) * cor_inline_duration_zero_force(beta);
}

double cor_contact_max_overlap_m(const struct cor_sphere_contact *contact, double speed_m_s)
{
    const double beta = cor_contact_beta(contact, speed_m_s), root = cor_inline_fifth_root(speed_m_s);
    if (isinf(beta) && !isnan(contact->scale))
        return INFINITY; /* it grows like g^(4/5 - 2/15) */
    return contact->scale * cor_inline_max_overlap(beta) * root * root * root * root;
}

static double dissipation_time(const struct cor_sphere_contact *contact, double speed, double beta)
{
    if (!(speed > 0) || isinf(speed))
        return NAN;
    return beta * contact->scale / (1.5 * cor_inline_fifth_root(speed));
}

double cor_contact_dissipation_time_s_zero_overlap(const struct cor_sphere_contact *contact, double speed_m_s,
                                                   double eps)
{
    return dissipation_time(contact, speed_m_s, cor_inline_beta_zero_overlap(eps));
}

double cor_contact_dissipation_time_s_zero_force(const struct cor_sphere_contact *contact, double speed_m_s, double eps)
{
    return dissipation_time(contact, speed_m_s, cor_inline_beta_zero_force(eps));
}

double cor_dissipation_time_s(double eta1_pa_s, double eta2_pa_s, double young_modulus_pa, double poisson_ratio)
{
    const double nu = poisson_ratio;
    if (!(eta1_pa_s >= 0 && eta1_pa_s <= DBL_MAX && eta2_pa_s >= 0 && eta2_pa_s <= DBL_MAX && young_modulus_pa > 0 &&
          young_modulus_pa <= DBL_MAX && nu > -1 && nu <= 0.5 && nu != 0))
        return NAN;
    if (eta1_pa_s == 0 && eta2_pa_s == 0) /* the limit of 0/0 from every direction */
        return 0;
    /* powers of two apart, so that only the result can overflow or underflow */
    int eta_exponent, young_exponent, nu_exponent;
    frexp(eta1_pa_s > eta2_pa_s ? eta1_pa_s : eta2_pa_s, &eta_exponent);
    const double eta1 = ldexp(eta1_pa_s, -eta_exponent), eta2 = ldexp(eta2_pa_s, -eta_exponent);
    const double young = frexp(young_modulus_pa, &young_exponent), small_nu = frexp(nu, &nu_exponent);
    const double difference = 3 * eta2 - eta1;
    const double viscosity = difference * (difference / (3 * eta2 + 2 * eta1));
    const double poisson_factor = (1 - nu) * (1 + nu) * (1 - 2 * nu) / (small_nu * small_nu);
    return ldexp(viscosity / (3 * young) * poisson_factor, eta_exponent - young_exponent - 2 * nu_exponent);
}

double cor_sphere_mass_kg(double radius_m, double density_kg_m3)
{
    /* 4 pi/3, rounded to the nearest double; C99 has no pi */
    static const double volume_of_unit_sphere = 4.18879020478639098462;
    if (!(radius_m > 0 && density_kg_m3 > 0))
        return NAN;
    if (isinf(radius_m) || isinf(density_kg_m3))
        return INFINITY;
    /* powers of two apart: the cube may be out of range where the mass is not */
    int radius_exponent, density_exponent;
    const double radius = frexp(radius_m, &radius_exponent), density = frexp(density_kg_m3, &density_exponent);
    return ldexp(volume_of_unit_sphere * (radius * radius * radius) * density, 3 * radius_exponent + density_exponent);
}
