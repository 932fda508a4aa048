/* SPDX-License-Identifier: MIT */
#include "cor/contact.h"

#include <float.h>
#include <math.h>

#include "cor/sphere.h"
#include "cor/status.h"
#include "runtime/number/environment.h"
#include "runtime/sphere/contact_parts.h"
#include "runtime/sphere/eval.h"

/* x^5, rounded once except for errors below 2^-100; NaN if the result is not a normal double. */
static double fifth_power(double x)
{
    if (!(x > 1e-60 && x < 1e60))
        return NAN;
    const struct cor_inline_pair square = cor_inline_product(x, x), one = {x, 0};
    const struct cor_inline_pair power = cor_inline_pair_times(cor_inline_pair_times(square, square), one);
    return power.hi;
}

static const struct cor_sphere_contact no_contact = {NAN, NAN, NAN, NAN, NAN, NAN, NAN};

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

/* x y/(x + y), also where the product would overflow and where x or y is infinite */
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

/* A function of a contact and of one or two numbers */
typedef double contact_formula(const struct cor_sphere_contact *contact, double x, double y);

/* The formula where intermediate results may leave the range of doubles. Volatile operands: see environment.h. */
static double in_environment(contact_formula *formula, const struct cor_sphere_contact *contact, double x, double y)
{
    const struct cor_environment caller = cor_environment_enter();
    const volatile double first = x, second = y;
    const volatile double value = formula(contact, first, second);
    cor_environment_leave(&caller);
    return value;
}

static int contact_init(struct cor_sphere_contact *contact, const struct cor_body *body_1,
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

    const double c1 = compliance(body_1), c2 = compliance(body_2), c = c1 + c2;
    const double mass = half_harmonic_mean(body_1->mass_kg, body_2->mass_kg);
    const double radius = half_harmonic_mean(body_1->radius_m, body_2->radius_m);
    const double rho = 4 * sqrt(radius) / (3 * c);
    if (!in_range(c) || !in_range(mass) || !in_range(radius) || !in_range(rho))
        return COR_ERROR_RANGE;
    /* the weights come first: they are exactly 1/2 for equal materials, and nothing can overflow */
    const double a1 = body_1->dissipation_time_s, a2 = body_2->dissipation_time_s;
    const double a = 0.0 + a1 * (c1 / c) + a2 * (c2 / c); /* adding 0.0 turns two times of -0 into 0 */
    /* the roots come first: rho/m may overflow, the quotient of the roots cannot */
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

/* Intermediate results may leave the range of doubles. */
COR_IN_ENVIRONMENT(int, cor_sphere_contact_init, contact_init,
                   (struct cor_sphere_contact * contact, const struct cor_body *body_1, const struct cor_body *body_2),
                   (contact, body_1, body_2))

static double beta_per_root_of(double g_star)
{
    return 1 / (-COR_SPHERE_C1 * cor_inline_fifth_root(g_star));
}

int cor_sphere_contact_init_g_star(struct cor_sphere_contact *contact, double g_star_m_s)
{
    if (contact == NULL)
        return COR_ERROR_NULL;
    *contact = no_contact;
    if (cor_inline_is_refused(g_star_m_s) || g_star_m_s == 0)
        return COR_ERROR_G_STAR;
    contact->beta_per_root = cor_in_environment(beta_per_root_of, g_star_m_s);
    contact->beta5_per_speed = cor_in_environment(fifth_power, contact->beta_per_root);
    return COR_OK;
}

static double g_star(const struct cor_sphere_contact *contact)
{
    const double root = 1 / (-COR_SPHERE_C1 * contact->beta_per_root), square = root * root;
    return square * square * root;
}

COR_IN_ENVIRONMENT(double, cor_contact_g_star_m_s, g_star, (const struct cor_sphere_contact *contact), (contact))

static double beta_anywhere(const struct cor_sphere_contact *contact, double speed, double unused)
{
    double factor = contact->beta_per_root, g = speed, unit = 1;
    (void)unused;
    if (!(g >= 0) || isnan(factor))
        return NAN;
    /* without dissipation, an infinite speed must not give 0 times inf */
    if (factor == 0 || g == 0)
        return 0;
    if (isinf(g))
        return g;
    /* powers of 32 bring g into the range of cor_inline_fifth_root_parts */
    if (g < COR_INLINE_2_M900) {
        g *= COR_INLINE_2_200;
        unit = COR_INLINE_2_M40;
    } else if (g > COR_INLINE_2_900) {
        g *= COR_INLINE_2_M200;
        unit = COR_INLINE_2_40;
    }
    /* powers of 2 keep the factor from overflowing before the result does */
    if (factor > COR_INLINE_2_500) {
        factor *= COR_INLINE_2_M500;
        unit *= COR_INLINE_2_500;
    }
    return cor_contact_beta_of_root(factor, cor_inline_fifth_root_parts(g)) * unit;
}

double cor_contact_beta(const struct cor_sphere_contact *contact, double speed_m_s)
{
    if (cor_contact_is_ordinary_speed(speed_m_s) && cor_contact_is_ordinary(contact, 0))
        return cor_contact_beta_of_root(contact->beta_per_root, cor_inline_fifth_root_parts(speed_m_s));
    return in_environment(beta_anywhere, contact, speed_m_s, 0);
}

/* Whether to use x = beta5_per_speed speed. Its two rounding errors change beta less than the root's own. Where x might
 * leave the range of doubles or is unknown, eps is computed from beta. */
static int power_is_good(const struct cor_sphere_contact *contact, double speed)
{
    return cor_inline_bits(speed) < cor_contact_speed_limit(contact->beta5_per_speed);
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

/* y: 0, or beta where the formula needs one */
static double contact_value(contact_formula *formula, const struct cor_sphere_contact *contact, double speed, double y)
{
    if (cor_contact_is_ordinary_speed(speed) && cor_contact_is_ordinary(contact, 1) &&
        cor_inline_below(y, COR_INLINE_2_300))
        return formula(contact, speed, y);
    return in_environment(formula, contact, speed, y);
}

static double duration_zero_overlap(const struct cor_sphere_contact *contact, double speed, double unused)
{
    (void)unused;
    const double beta = cor_contact_beta(contact, speed);
    if (isinf(beta) && !isnan(contact->scale))
        return INFINITY; /* the duration grows like ln(g) */
    return cor_contact_duration_of(contact->scale, cor_inline_fifth_root(fabs(speed)),
                                   cor_inline_duration_zero_overlap(beta));
}

static double duration_zero_force(const struct cor_sphere_contact *contact, double speed, double unused)
{
    (void)unused;
    const double beta = cor_contact_beta(contact, speed);
    return cor_contact_duration_of(contact->scale, cor_inline_fifth_root(fabs(speed)),
                                   cor_inline_duration_zero_force(beta));
}

static double max_overlap(const struct cor_sphere_contact *contact, double speed, double unused)
{
    (void)unused;
    const double beta = cor_contact_beta(contact, speed);
    if (isinf(beta) && !isnan(contact->scale))
        return INFINITY; /* the overlap grows like g^(4/5 - 2/15) */
    return cor_contact_overlap_of(contact->scale, cor_inline_fifth_root(speed), cor_inline_max_overlap(beta));
}

static double dissipation_time(const struct cor_sphere_contact *contact, double speed, double beta)
{
    if (!(speed > 0) || isinf(speed))
        return NAN;
    return cor_contact_dissipation_of(contact->scale, cor_inline_fifth_root(speed), beta);
}

double cor_contact_duration_s_zero_overlap(const struct cor_sphere_contact *contact, double speed_m_s)
{
    return contact_value(duration_zero_overlap, contact, speed_m_s, 0);
}

double cor_contact_duration_s_zero_force(const struct cor_sphere_contact *contact, double speed_m_s)
{
    return contact_value(duration_zero_force, contact, speed_m_s, 0);
}

double cor_contact_max_overlap_m(const struct cor_sphere_contact *contact, double speed_m_s)
{
    return contact_value(max_overlap, contact, speed_m_s, 0);
}

double cor_contact_dissipation_time_s_zero_overlap(const struct cor_sphere_contact *contact, double speed_m_s,
                                                   double eps)
{
    return contact_value(dissipation_time, contact, speed_m_s, cor_inline_beta_zero_overlap(eps));
}

double cor_contact_dissipation_time_s_zero_force(const struct cor_sphere_contact *contact, double speed_m_s, double eps)
{
    return contact_value(dissipation_time, contact, speed_m_s, cor_inline_beta_zero_force(eps));
}

/* ---- materials ---- */

static double dissipation_time_of(double eta1_pa_s, double eta2_pa_s, double young_modulus_pa, double nu)
{
    if (!(eta1_pa_s >= 0 && eta1_pa_s <= DBL_MAX && eta2_pa_s >= 0 && eta2_pa_s <= DBL_MAX && young_modulus_pa > 0 &&
          young_modulus_pa <= DBL_MAX && nu > -1 && nu <= 0.5 && nu != 0))
        return NAN;
    if (eta1_pa_s == 0 && eta2_pa_s == 0) /* 0/0 has this limit from every direction */
        return 0;
    /* powers of two are kept apart, so that only the result can overflow or underflow */
    int eta_exponent, young_exponent, nu_exponent;
    frexp(eta1_pa_s > eta2_pa_s ? eta1_pa_s : eta2_pa_s, &eta_exponent);
    const double eta1 = ldexp(eta1_pa_s, -eta_exponent), eta2 = ldexp(eta2_pa_s, -eta_exponent);
    const double young = frexp(young_modulus_pa, &young_exponent), small_nu = frexp(nu, &nu_exponent);
    const double difference = 3 * eta2 - eta1;
    const double viscosity = difference * (difference / (3 * eta2 + 2 * eta1));
    const double poisson_factor = (1 - nu) * (1 + nu) * (1 - 2 * nu) / (small_nu * small_nu);
    return ldexp(viscosity / (3 * young) * poisson_factor, eta_exponent - young_exponent - 2 * nu_exponent);
}

COR_IN_ENVIRONMENT(double, cor_dissipation_time_s, dissipation_time_of,
                   (double eta1_pa_s, double eta2_pa_s, double young_modulus_pa, double poisson_ratio),
                   (eta1_pa_s, eta2_pa_s, young_modulus_pa, poisson_ratio))

static double kappa_of(double young_1, double nu_1, double young_2, double nu_2)
{
    if (!(young_1 > 0 && nu_1 > -1 && nu_1 <= 0.5 && young_2 > 0 && nu_2 > -1 && nu_2 <= 0.5))
        return NAN;
    /* 1/Y in units of the larger one, so that nothing overflows; two infinite moduli give NaN */
    const double young = young_1 < young_2 ? young_1 : young_2;
    const double weight_1 = young / young_1 * (1 + nu_1), weight_2 = young / young_2 * (1 + nu_2);
    const double sum = weight_1 * (1 - nu_1) + weight_2 * (1 - nu_2);
    return 10.5 * sum / (weight_1 * (2 - nu_1) + weight_2 * (2 - nu_2));
}

COR_IN_ENVIRONMENT(double, cor_tangential_kappa, kappa_of,
                   (double young_modulus_1_pa, double poisson_ratio_1, double young_modulus_2_pa,
                    double poisson_ratio_2),
                   (young_modulus_1_pa, poisson_ratio_1, young_modulus_2_pa, poisson_ratio_2))

static double stick_angle(double kappa, double friction)
{
    /* the quotient comes first: where it underflows or overflows the angle does */
    return kappa > 0 && friction >= 0 ? atan(3.5 * (friction / kappa)) : (double)NAN;
}

COR_IN_ENVIRONMENT(double, cor_tangential_stick_angle, stick_angle, (double kappa, double friction), (kappa, friction))

static double mass_of(double radius_m, double density_kg_m3)
{
    /* 4 pi/3, rounded to the nearest double; C99 has no pi */
    static const double volume_of_unit_sphere = 4.18879020478639098462;
    if (!(radius_m > 0 && density_kg_m3 > 0))
        return NAN;
    if (isinf(radius_m) || isinf(density_kg_m3))
        return INFINITY;
    /* powers of two are kept apart: the cube may be out of range where the mass is not */
    int radius_exponent, density_exponent;
    const double radius = frexp(radius_m, &radius_exponent), density = frexp(density_kg_m3, &density_exponent);
    return ldexp(volume_of_unit_sphere * (radius * radius * radius) * density, 3 * radius_exponent + density_exponent);
}

COR_IN_ENVIRONMENT(double, cor_sphere_mass_kg, mass_of, (double radius_m, double density_kg_m3),
                   (radius_m, density_kg_m3))
