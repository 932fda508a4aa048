/* SPDX-License-Identifier: MIT */
/* Contacts in a liquid, and spheres that yield. These follow Hertz's law up to the pressure p_y, then a linear spring
 * of stiffness pi R p_y. On the way back they follow Hertz's law with a larger radius (docs/theory.md, 21). With r =
 * v_y/v, let t be the ratio of the yield force to the largest force:
 *
 *     t = r sqrt(5/(6 - r^2))
 * Then eps^4 = 108 t/((t + 2) (t^2 + 5)^2), and 1 - eps^4 = (1 - t)^2 (t^3 + 4 t^2 + 17 t + 50)/(...) has no
 * cancellation. */
#include "cor/scene.h"

#include "runtime/scene/motion.h"

#include "runtime/scene/exponents.h"

/* ---- eps ---- */

/* Returns 1 - t from x = 1/r, by t^2 - 1 = 6 (r^2 - 1)/(6 - r^2). */
static double force_gap(double x, double t)
{
    const double r = 1 / x;
    return 6 * ((x - 1) / x) * (1 + r) / ((6 - r * r) * (1 + t));
}

static double force_ratio(double x)
{
    const double r = 1 / x;
    return r * sqrt(5 / (6 - r * r));
}

/* Returns (t + 2) (t^2 + 5)^2. */
static double eps_denominator(double t)
{
    const double square = t * t + 5;
    return (t + 2) * (square * square);
}

/* Returns (t^3 + 4 t^2 + 17 t + 50)/((t + 2) (t^2 + 5)^2). */
static double loss_factor(double t)
{
    return (((t + 4) * t + 17) * t + 50) / eps_denominator(t);
}

/* Returns 1 - eps^4. */
static double loss_of_fourth(double t, double gap)
{
    return gap * gap * loss_factor(t);
}

double cor_elastic_plastic_eps(double speed_ratio)
{
    if (!isgreater(speed_ratio, 1))
        return cor_inline_is_refused(speed_ratio) ? (double)NAN : 1;
    const double t = force_ratio(speed_ratio);
    if (t < 0.75)
        return sqrt(sqrt(108 * t / eps_denominator(t)));
    return sqrt(sqrt(1 - loss_of_fourth(t, force_gap(speed_ratio, t)))); /* at most 1, and exactly 1 next to v_y */
}

double cor_elastic_plastic_loss(double speed_ratio)
{
    if (!isgreater(speed_ratio, 1))
        return cor_inline_is_refused(speed_ratio) ? (double)NAN : 0;
    const double eps = cor_elastic_plastic_eps(speed_ratio);
    if (eps < 0.5)
        return 1 - eps;
    const double t = force_ratio(speed_ratio);
    return loss_of_fourth(t, force_gap(speed_ratio, t)) / ((1 + eps) * (1 + eps * eps));
}

/* Returns t for an eps by Newton's method. P/D is loss_factor. Near eps = 1 it solves sqrt(1 - eps^4) = u sqrt(P/D) for
 * u = 1 - t, elsewhere eps^4 = 108 t/D for ln t. Newton's method starts on the side from which it does not cross the
 * root. */
static double force_ratio_of_eps(double eps)
{
    const double fourth = eps * eps * (eps * eps);
    if (eps < 0.9) {
        double t = fourth * (50.0 / 108), step = 1;
        for (int i = 0; i < 60 && step > 0x1p-54 && t > 0; i++) {
            const double square = t * t + 5, slope = 2 * (1 - t) * ((2 * t + 5) * t + 5) / ((t + 2) * square);
            step = (fourth / (108 * t / eps_denominator(t)) - 1) / slope;
            t *= 1 + step;
        }
        return t;
    }
    const double root = sqrt((1 - eps) * (1 + eps) * (1 + eps * eps));
    double u = sqrt(1.5) * root, step = 1;
    for (int i = 0; i < 60 && step > 0x1p-54 * u; i++) {
        const double t = 1 - u, d = eps_denominator(t), factor = sqrt(loss_factor(t));
        step = (u * factor - root) * factor * (t + 2) * (t * t + 5) * d / (108 * ((2 * t + 5) * t + 5));
        u -= step;
    }
    return 1 - u;
}

double cor_elastic_plastic_speed_ratio(double eps)
{
    if (!(isgreaterequal(eps, 0) && eps <= 1))
        return NAN;
    const double t = force_ratio_of_eps(eps);
    return cor_quiet_quotient(sqrt((t * t + 5) / 6), t);
}

/* ---- v_y and the yield stress ---- */

/* Returns sqrt(pi^5/30) (p_y/E*)^2 sqrt(R^3 p_y/m), from K = (4/3) E* sqrt(R). */
double cor_scene_yield_speed(const struct cor_scene_contact *contact, double yield_stress_pa)
{
    if (!cor_contact_is_sound(contact) || !cor_si_in_range(yield_stress_pa))
        return NAN;
    const double pressure = COR_YIELD_PRESSURE * yield_stress_pa, radius = contact->radius_m;
    const double ratio = cor_si_quotient(pressure, cor_si_quotient(0.75 * contact->stiffness, sqrt(radius)));
    const double cube = cor_si_product(cor_si_product(radius, radius), radius);
    const double square = cor_si_quotient(cor_si_product(cube, pressure), contact->mass_kg);
    return cor_si_product(cor_si_product(COR_YIELD_FACTOR * ratio, ratio), sqrt(square));
}

/* ---- contact radius and pressure ---- */

double cor_scene_elastic_overlap(const struct cor_scene_contact *contact, double speed_m_s)
{
    if (!cor_contact_is_sound(contact) || !cor_si_in_range(speed_m_s))
        return speed_m_s == 0 ? 0 : (double)NAN;
    const double a = cor_elastic(&contact->law),
                 scale = cor_si_quotient((a + 1) / 2 * contact->mass_kg, contact->stiffness);
    return cor_quiet_power(cor_si_product(cor_si_product(scale, speed_m_s), speed_m_s), 1 / (a + 1));
}

/* True if a contact is sound and the number is in range or 0 */
static int in_range_or_zero(const struct cor_scene_contact *contact, double x)
{
    return cor_contact_is_sound(contact) && (x == 0 || cor_si_in_range(x));
}

double cor_scene_contact_radius(const struct cor_scene_contact *contact, double overlap_m)
{
    return in_range_or_zero(contact, overlap_m) ? sqrt(cor_quiet_product(contact->radius_m, overlap_m)) : (double)NAN;
}

/* Returns (3/2) K x^(3/2)/(pi R x), by Hertz. */
static double yield_pressure(const struct cor_scene_contact *contact, double overlap_m)
{
    if (!in_range_or_zero(contact, overlap_m))
        return NAN;
    return cor_quiet_quotient(cor_quiet_product(1.5 * contact->stiffness, sqrt(overlap_m)), COR_PI * contact->radius_m);
}

/* Returns the largest pressure at an overlap, at most the pressure at which the spheres yield. */
double cor_scene_pressure(const struct cor_scene_contact *contact, double overlap_m)
{
    const double yields = contact->plastic ? cor_scene_elastic_overlap(contact, contact->yield_speed_m_s) : INFINITY;
    return yield_pressure(contact, fmin(overlap_m, yields));
}

double cor_scene_yield_stress(const struct cor_scene_contact *contact, double yield_speed_m_s)
{
    return yield_pressure(contact, cor_scene_elastic_overlap(contact, yield_speed_m_s)) / COR_YIELD_PRESSURE;
}

/* ---- an impact above the yield speed ----
 *
 * In units of overlap, force and speed at the onset of yield: the largest force is 1/t and the largest overlap
 * (2 + t)/(3 t). Loading lasts for Hertz's time up to the onset and for acos(t)/sqrt(15/8) beyond it. Unloading lasts
 * half as long as an elastic contact at the rebound speed. */

enum { TERMS = 30 };

/* Returns the integral of (1 - r^2 u^(5/2))^(-1/2) from 0 to 1. With r u^(5/4) = sin(theta) it is (theta_1/r)^(4/5)
 * times sum c_k theta_1^(2k)/(5k/2 + 1), where sin(theta_1) = r. c_k are the coefficients of (sin(theta)/theta)^(-1/5)
 * in powers of theta^2; they decrease like pi^(-2k). */
static double hertz_time(double r, double gap)
{
    const double computed = COR_PI / 2 - 2 * asin(sqrt(gap / 2)), angle = computed > 0 ? computed : r,
                 square = angle * angle;
    double a[TERMS], c[TERMS], sum = 1, power = 1;
    a[0] = c[0] = 1;
    for (int n = 1; n < TERMS; n++) {
        a[n] = -a[n - 1] / (2 * n * (2 * n + 1));
        c[n] = 0;
        for (int k = 1; k <= n; k++)
            c[n] += (-0.2 * k - n + k) * a[k] * c[n - k];
        c[n] /= n;
        power *= square;
        sum += c[n] * power / (2.5 * n + 1);
    }
    return pow(angle / r, 0.8) * sum;
}

#define HERTZ_TIME 1.4716375921623523 /* hertz_time for r = 1: (2/5) B(2/5, 1/2) */

void cor_plastic_impact(struct cor_full_impact *impact, const struct cor_scene_contact *contact, double speed_m_s)
{
    const double x = cor_quiet_quotient(speed_m_s, contact->yield_speed_m_s), t = force_ratio(x);
    const double overlap = cor_scene_elastic_overlap(contact, contact->yield_speed_m_s);
    const double eps = cor_elastic_plastic_eps(x);
    if (!(x < 1e300 && contact->yield_speed_m_s > 0))
        return;
    const double time = cor_quiet_quotient(overlap, contact->yield_speed_m_s);
    const double loading = hertz_time(1 / x, (x - 1) / x) / x + 2 * asin(sqrt(force_gap(x, t) / 2)) / sqrt(15.0 / 8);
    const double unloading = HERTZ_TIME * sqrt(3 / (t * (2 + t))) / (eps * x);
    impact->eps[0] = impact->eps[1] = eps;
    impact->duration[0] = impact->duration[1] = cor_quiet_product(time, loading + unloading);
    impact->max_overlap = cor_quiet_quotient(overlap * (2 + t), 3 * t);
    impact->force_max =
        cor_quiet_quotient(cor_quiet_product(cor_quiet_product(contact->stiffness, overlap), sqrt(overlap)), t);
}

/* ---- a liquid film around a dry contact ----
 *
 * Lubrication reduces the speed of the bodies equally on the way in and on the way out (docs/theory.md, 22). */

/* Integrates dv/dh = 6 pi eta R^2/(m h), which follows from m dv/dt = -6 pi eta R^2 v/h and dh/dt = -v. */
double cor_scene_liquid_speed(const struct cor_scene_contact *contact, double viscosity_pa_s, double gap_outer_m,
                              double gap_inner_m)
{
    if (!cor_contact_is_sound(contact) || !(viscosity_pa_s == 0 || cor_si_in_range(viscosity_pa_s)) ||
        !cor_si_in_range(gap_outer_m) || !cor_si_in_range(gap_inner_m) || gap_outer_m < gap_inner_m)
        return NAN;
    const double radius = contact->radius_m, gap = gap_outer_m - gap_inner_m;
    /* ln(1 + z) keeps its accuracy if the gaps are nearly equal */
    const double logarithm =
        gap < gap_inner_m ? log1p(gap / gap_inner_m) : log(cor_si_quotient(gap_outer_m, gap_inner_m));
    const double product = cor_quiet_product(cor_quiet_product(6 * COR_PI * viscosity_pa_s, radius), radius);
    return cor_quiet_quotient(product, contact->mass_kg) * logarithm;
}

double cor_wet_eps(double eps, double speed_m_s, double liquid_speed_m_s)
{
    if (!(isgreaterequal(eps, 0) && eps <= 1) || !(speed_m_s == 0 || cor_si_in_range(speed_m_s)) ||
        !(liquid_speed_m_s == 0 || cor_si_in_range(liquid_speed_m_s)))
        return NAN;
    if (liquid_speed_m_s == 0 || speed_m_s <= liquid_speed_m_s)
        return liquid_speed_m_s == 0 ? eps : 0;
    return fmax((eps * (speed_m_s - liquid_speed_m_s) - liquid_speed_m_s) / speed_m_s, 0);
}

double cor_wet_sticking_speed(const struct cor_scene_contact *contact, int end)
{
    /* Finds the speed from which the dry contact rebounds with the speed s. The rebound grows with the impact speed. */
    const double s = contact->liquid_speed_m_s;
    struct cor_scene_contact dry = *contact;
    double low, high = s, eps = 0, rebound = 0, last;
    dry.liquid_speed_m_s = 0;
    do { /* because eps <= 1, the rebound from `low` is not faster than s */
        low = high;
        high *= 2;
        last = rebound;
        if (cor_scene_eps(&eps, &dry, high, end) != COR_FAULT_NONE || isnan(eps))
            return NAN;
        rebound = eps * high;
    } while (rebound < s && (rebound == 0 || rebound > last * (1 + 1e-9)) && high < 1e30 * s);
    if (!(rebound >= s))
        return INFINITY;
    for (double middle; high - low > 0x1p-52 * high && cor_halve(&middle, low, high);) {
        if (cor_scene_eps(&eps, &dry, middle, end) != COR_FAULT_NONE)
            return NAN;
        *(eps * middle < s ? &low : &high) = middle;
    }
    return s + high;
}
