/* SPDX-License-Identifier: MIT */
#include "cor/contact.h"

#include <float.h>
#include <math.h>

#include "cor/sphere.h"
#include "cor/status.h"
#include "runtime/number/si_range.h"
#include "runtime/sphere/contact_parts.h"
#include "runtime/sphere/eval.h"

/* Returns x^5, rounded once except for errors below 2^-100; NaN if the result is not a normal double. */
static double fifth_power(double x)
{
    if (!(x > 1e-60 && x < 1e60))
        return NAN;
    const struct cor_inline_pair square = cor_inline_product(x, x), one = {x, 0};
    const struct cor_inline_pair power = cor_inline_pair_times(cor_inline_pair_times(square, square), one);
    return power.hi;
}

static const struct cor_sphere_contact no_contact = {NAN, NAN, NAN, NAN, NAN, NAN, NAN};

static int is_positive(double x)
{
    return !cor_inline_is_refused(x) && x != 0;
}

static int is_poisson_ratio(double nu)
{
    return isgreater(nu, -1) && islessequal(nu, 0.5);
}

static int is_in_range_or_infinite(double x)
{
    return cor_si_in_range(x) || cor_is_infinity(x);
}

static int body_status(const struct cor_body *body)
{
    if (!is_positive(body->young_modulus_pa))
        return COR_ERROR_YOUNG_MODULUS;
    if (!is_poisson_ratio(body->poisson_ratio))
        return COR_ERROR_POISSON_RATIO;
    if (cor_inline_is_refused(body->dissipation_time_s) || cor_is_infinity(body->dissipation_time_s))
        return COR_ERROR_DISSIPATION_TIME;
    if (!is_positive(body->radius_m))
        return COR_ERROR_RADIUS;
    if (!is_positive(body->mass_kg))
        return COR_ERROR_MASS;
    const int fits = is_in_range_or_infinite(body->young_modulus_pa) && is_in_range_or_infinite(body->radius_m) &&
                     is_in_range_or_infinite(body->mass_kg) &&
                     (body->dissipation_time_s == 0 || cor_si_in_range(body->dissipation_time_s));
    return fits ? COR_OK : COR_ERROR_RANGE;
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

/* Returns x y/(x + y), even if the product would overflow or if x or y is infinite. */
static double half_harmonic_mean(double x, double y)
{
    const double small = x < y ? x : y, large = x < y ? y : x;
    return small / (1 + small / large);
}

/* Returns (1 - nu^2)/Y without cancellation near nu = -1. */
static double compliance_of(const struct cor_body *body)
{
    return (1 - body->poisson_ratio) * (1 + body->poisson_ratio) / body->young_modulus_pa;
}

int cor_sphere_contact_init(struct cor_sphere_contact *contact, const struct cor_body *body_1,
                            const struct cor_body *body_2)
{
    if (contact == NULL)
        return COR_ERROR_NULL;
    *contact = no_contact;
    if (body_1 == NULL || body_2 == NULL)
        return COR_ERROR_NULL;
    int status = body_status(body_1);
    if (status == COR_OK)
        status = body_status(body_2);
    if (status == COR_OK)
        status = pair_status(body_1, body_2);
    if (status != COR_OK)
        return status;

    const double c1 = compliance_of(body_1), c2 = compliance_of(body_2), c = c1 + c2;
    const double mass = half_harmonic_mean(body_1->mass_kg, body_2->mass_kg);
    const double radius = half_harmonic_mean(body_1->radius_m, body_2->radius_m);
    const double rho = cor_si_quotient(4 * sqrt(radius), 3 * c);
    if (!cor_si_in_range(mass) || !cor_si_in_range(radius) || !cor_si_in_range(rho))
        return COR_ERROR_RANGE;
    /* weights first: they are exactly 1/2 for equal materials, and nothing can overflow */
    const double a1 = body_1->dissipation_time_s, a2 = body_2->dissipation_time_s;
    const double a = 0.0 + a1 * (c1 / c) + a2 * (c2 / c); /* adding 0.0 turns two times of -0 into 0 */
    /* roots first: rho/m may overflow, but the quotient of the roots cannot */
    const double root = cor_inline_fifth_root(rho) / cor_inline_fifth_root(mass), square = root * root;
    const int dissipates = (a1 > 0 && c1 > 0) || (a2 > 0 && c2 > 0);
    const double beta_per_root = dissipates ? cor_si_product(1.5 * a, square) : 0;
    const struct cor_sphere_contact filled = {mass, radius, rho, a, beta_per_root, 1 / square, NAN};
    if (!cor_contact_is_ordinary(&filled, 1) || (dissipates && !cor_si_in_range(a)))
        return COR_ERROR_RANGE;
    *contact = filled;
    contact->beta5_per_speed = fifth_power(contact->beta_per_root);
    return COR_OK;
}

int cor_sphere_contact_init_g_star(struct cor_sphere_contact *contact, double g_star_m_s)
{
    if (contact == NULL)
        return COR_ERROR_NULL;
    *contact = no_contact;
    if (!is_in_range_or_infinite(g_star_m_s))
        return COR_ERROR_G_STAR;
    contact->beta_per_root = 1 / (-COR_SPHERE_C1 * cor_inline_fifth_root(g_star_m_s));
    contact->beta5_per_speed = fifth_power(contact->beta_per_root);
    return COR_OK;
}

double cor_contact_g_star_m_s(const struct cor_sphere_contact *contact)
{
    if (!cor_contact_is_ordinary(contact, 0))
        return NAN;
    if (contact->beta_per_root == 0)
        return INFINITY;
    const double root = 1 / (-COR_SPHERE_C1 * contact->beta_per_root), square = root * root;
    if (!(root > 1e-50 && root < 1e50))
        return root > 1 ? INFINITY : NAN;
    return square * square * root;
}

/* ---- eps at a speed ---- */

/* Returns the result at a speed that is not in range: 0, infinite, or invalid. */
static double at_end(double speed, double at_zero, double at_infinity)
{
    return speed == 0 ? at_zero : cor_is_infinity(speed) ? at_infinity : (double)NAN;
}

double cor_contact_beta(const struct cor_sphere_contact *contact, double speed_m_s)
{
    if (!cor_contact_is_ordinary(contact, 0))
        return NAN;
    if (!cor_si_in_range(speed_m_s))
        return at_end(speed_m_s, 0, contact->beta_per_root == 0 ? 0 : INFINITY);
    return cor_contact_beta_of_root(contact->beta_per_root, cor_inline_fifth_root_parts(speed_m_s));
}

/* True if eps should be computed from x = beta5_per_speed speed = beta^5, not from beta. The two rounding errors of x
 * change eps less than the rounding error of a fifth root. False if x might leave the range of doubles or is
 * unknown. */
static int power_is_good(const struct cor_sphere_contact *contact, double speed)
{
    return cor_si_in_range(speed) && cor_inline_bits(speed) < cor_contact_speed_limit(contact->beta5_per_speed);
}

double cor_contact_eps_zero_overlap(const struct cor_sphere_contact *contact, double speed_m_s)
{
    if (power_is_good(contact, speed_m_s))
        return cor_inline_eps_zero_overlap_root(contact->beta5_per_speed * speed_m_s);
    return cor_inline_eps_zero_overlap(cor_contact_beta(contact, speed_m_s));
}

double cor_contact_eps_zero_force(const struct cor_sphere_contact *contact, double speed_m_s)
{
    if (power_is_good(contact, speed_m_s))
        return cor_inline_eps_zero_force_root(contact->beta5_per_speed * speed_m_s);
    return cor_inline_eps_zero_force(cor_contact_beta(contact, speed_m_s));
}

/* ---- times, overlaps and A ---- */

double cor_contact_duration_s_zero_overlap(const struct cor_sphere_contact *contact, double speed_m_s)
{
    if (!cor_contact_is_ordinary(contact, 1))
        return NAN;
    if (!cor_si_in_range(speed_m_s)) /* with dissipation the duration grows like ln(g) */
        return at_end(speed_m_s, INFINITY, contact->beta_per_root == 0 ? 0 : INFINITY);
    return cor_contact_duration_of(contact->scale, cor_inline_fifth_root(speed_m_s),
                                   cor_inline_duration_zero_overlap(cor_contact_beta(contact, speed_m_s)));
}

double cor_contact_duration_s_zero_force(const struct cor_sphere_contact *contact, double speed_m_s)
{
    if (!cor_contact_is_ordinary(contact, 1))
        return NAN;
    if (!cor_si_in_range(speed_m_s))
        return at_end(speed_m_s, INFINITY, 0);
    return cor_contact_duration_of(contact->scale, cor_inline_fifth_root(speed_m_s),
                                   cor_inline_duration_zero_force(cor_contact_beta(contact, speed_m_s)));
}

double cor_contact_max_overlap_m(const struct cor_sphere_contact *contact, double speed_m_s)
{
    if (!cor_contact_is_ordinary(contact, 1))
        return NAN;
    if (!cor_si_in_range(speed_m_s))
        return at_end(speed_m_s, 0, INFINITY);
    const double root = cor_inline_fifth_root(speed_m_s),
                 overlap = cor_inline_max_overlap(cor_contact_beta(contact, speed_m_s));
    const int overflows = root > 1 && contact->scale * overlap * root * root * root > DBL_MAX / root;
    return overflows ? INFINITY : cor_contact_overlap_of(contact->scale, root, overlap);
}

static double dissipation_time(const struct cor_sphere_contact *contact, double speed, double beta)
{
    if (!cor_contact_is_ordinary(contact, 1) || !cor_si_in_range(speed) || cor_inline_is_refused(beta))
        return NAN;
    const double root = cor_inline_fifth_root(speed), time = cor_quiet_product(contact->scale, beta);
    return time < COR_SI_MOST * root || cor_is_infinity(beta) ? cor_contact_dissipation_of(contact->scale, root, beta)
                                                              : (double)NAN;
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

/* ---- materials ---- */

double cor_dissipation_time_s(double eta1_pa_s, double eta2_pa_s, double young_modulus_pa, double poisson_ratio)
{
    const double nu = poisson_ratio;
    if (!(eta1_pa_s == 0 || cor_si_in_range(eta1_pa_s)) || !(eta2_pa_s == 0 || cor_si_in_range(eta2_pa_s)) ||
        !cor_si_in_range(young_modulus_pa) || !is_poisson_ratio(nu) || nu == 0)
        return NAN;
    if (eta1_pa_s == 0 && eta2_pa_s == 0) /* (4) is 0/0 here; its limit is 0 from every direction */
        return 0;
    /* powers of two are handled separately, so that only the result can be out of range */
    int eta_exponent, young_exponent, nu_exponent;
    frexp(eta1_pa_s > eta2_pa_s ? eta1_pa_s : eta2_pa_s, &eta_exponent);
    const double eta1 = cor_inline_scaled(eta1_pa_s, -eta_exponent), eta2 = cor_inline_scaled(eta2_pa_s, -eta_exponent);
    const double young = frexp(young_modulus_pa, &young_exponent), small_nu = frexp(nu, &nu_exponent);
    const double difference = 3 * eta2 - eta1;
    const double viscosity = difference * (difference / (3 * eta2 + 2 * eta1));
    const double poisson_factor = (1 - nu) * (1 + nu) * (1 - 2 * nu) / (small_nu * small_nu);
    const double time = viscosity / (3 * young) * poisson_factor;
    return time == 0 ? 0 : cor_si_scaled(time, eta_exponent - young_exponent - 2 * nu_exponent);
}

double cor_tangential_kappa(double young_modulus_1_pa, double poisson_ratio_1, double young_modulus_2_pa,
                            double poisson_ratio_2)
{
    const double nu_1 = poisson_ratio_1, nu_2 = poisson_ratio_2;
    if (!is_in_range_or_infinite(young_modulus_1_pa) || !is_in_range_or_infinite(young_modulus_2_pa) ||
        !is_poisson_ratio(nu_1) || !is_poisson_ratio(nu_2))
        return NAN;
    /* 1/Y in units of the larger 1/Y, so that nothing overflows */
    const double young = young_modulus_1_pa < young_modulus_2_pa ? young_modulus_1_pa : young_modulus_2_pa;
    if (cor_is_infinity(young))
        return NAN;
    const double weight_1 = young / young_modulus_1_pa * (1 + nu_1), weight_2 = young / young_modulus_2_pa * (1 + nu_2);
    const double sum = weight_1 * (1 - nu_1) + weight_2 * (1 - nu_2);
    return 10.5 * sum / (weight_1 * (2 - nu_1) + weight_2 * (2 - nu_2));
}

double cor_tangential_stick_angle(double kappa, double friction)
{
    if (!is_positive(kappa) || cor_inline_is_refused(friction) || (cor_is_infinity(kappa) && cor_is_infinity(friction)))
        return NAN;
    /* if the quotient is above 2^60, the angle is pi/2 to the last bit */
    return friction * 0x1p-60 > kappa ? atan(INFINITY) : atan(3.5 * (friction / kappa));
}

double cor_sphere_mass_kg(double radius_m, double density_kg_m3)
{
    /* 4 pi/3, rounded to the nearest double; C99 has no pi */
    static const double volume_of_unit_sphere = 4.18879020478639098462;
    if (!is_in_range_or_infinite(radius_m) || !is_in_range_or_infinite(density_kg_m3))
        return NAN;
    if (isinf(radius_m) || isinf(density_kg_m3))
        return INFINITY;
    /* powers of two are handled separately: the cube may be out of range where the mass is not */
    int radius_exponent, density_exponent;
    const double radius = frexp(radius_m, &radius_exponent), density = frexp(density_kg_m3, &density_exponent);
    return cor_si_scaled(volume_of_unit_sphere * (radius * radius * radius) * density,
                         3 * radius_exponent + density_exponent);
}
