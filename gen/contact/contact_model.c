/* SPDX-License-Identifier: MIT */
#include "contact/contact_model.h"

#include <math.h>

#include "contact/contact_force.h"
#include "cor/hertz_dashpot.h"
#include "cor/law.h"
#include "cor/sphere.h"
#include "enclosure/collision.h"
#include "support/console.h"

enum { MODEL_BITS = 64 };

static double ratio_value(struct ratio x)
{
    return (double)x.num / (double)x.den;
}

static bool law_is(const struct law *law, slong a2, slong b2)
{
    return law->a.num * 2 == a2 * law->a.den && law->b.num * 2 == b2 * law->b.den;
}

static bool is_hertz_dashpot(const struct law *law)
{
    return law_is(law, 3, 0);
}

struct contact_model contact_model_of_law(const struct law *law)
{
    return (struct contact_model){
        .law = *law, .mass_kg = (double)NAN, .stiffness = (double)NAN, .radius_m = (double)NAN, .damping = (double)NAN};
}

double contact_model_speed_exponent(const struct contact_model *model)
{
    return ratio_value(law_speed_exponent(&model->law));
}

bool contact_model_is_constant(const struct contact_model *model)
{
    return law_is_linear(&model->law);
}

bool contact_model_has_scales(const struct contact_model *model)
{
    return model->mass_kg > 0 && model->stiffness > 0;
}

bool contact_model_has_end(const struct contact_model *model, enum contact_end end)
{
    return end == END_ZERO_OVERLAP || !model->plate;
}

bool contact_model_ends_differ(const struct contact_model *model)
{
    return !model->plate && law_force_ends(&model->law);
}

/* ---- the damping ---- */

/* (m/K)^(1/(a+1)), the unit of time at the speed 1 m/s */
static double time_factor(const struct contact_model *model)
{
    return pow(model->mass_kg / model->stiffness, 1 / (ratio_value(model->law.a) + 1));
}

/* beta/zeta where q = 0; 1 elsewhere, where the damping is beta at 1 m/s */
static double beta_per_damping(const struct contact_model *model)
{
    return contact_model_is_constant(model) ? sqrt(2 * (ratio_value(model->law.a) + 1)) : 1;
}

double contact_model_beta(const struct contact_model *model, double speed_m_s)
{
    const double beta = model->damping * beta_per_damping(model);
    if (contact_model_is_constant(model))
        return beta;
    if (law_is_sphere(&model->law))
        return beta * pow(speed_m_s, 0.2);
    return beta * pow(speed_m_s, contact_model_speed_exponent(model));
}

void contact_model_set_beta(struct contact_model *model, double beta, double speed_m_s)
{
    model->damping = contact_model_is_constant(model) ? beta / beta_per_damping(model)
                                                      : beta * pow(speed_m_s, -contact_model_speed_exponent(model));
}

double contact_model_zeta(const struct contact_model *model)
{
    return contact_model_is_constant(model) ? model->damping : (double)NAN;
}

/* beta g^-q of C = 1 */
static double beta_per_coefficient(const struct contact_model *model)
{
    return pow(time_factor(model), ratio_value(model->law.b) + 1) / model->mass_kg;
}

void contact_model_set_coefficient(struct contact_model *model, double coefficient)
{
    model->damping = coefficient * beta_per_coefficient(model) / beta_per_damping(model);
}

double contact_model_coefficient(const struct contact_model *model)
{
    return model->damping * beta_per_damping(model) / beta_per_coefficient(model);
}

void contact_model_set_dissipation_time(struct contact_model *model, double dissipation_time_s)
{
    contact_model_set_coefficient(model, 1.5 * dissipation_time_s * model->stiffness);
}

double contact_model_dissipation_time_s(const struct contact_model *model)
{
    return law_is_sphere(&model->law) ? contact_model_coefficient(model) / (1.5 * model->stiffness) : (double)NAN;
}

/* |C_1| = (2/(a+1)) X_0^(b+1) B((b+1)/(a+1), 3/2), X_0 = ((a+1)/2)^(1/(a+1)): docs/derivation.md, 9 */
static double first_coefficient(const struct law *law)
{
    const double a1 = ratio_value(law->a) + 1, s = (ratio_value(law->b) + 1) / a1;
    return 2 / a1 * pow(a1 / 2, s) * tgamma(s) * tgamma(1.5) / tgamma(s + 1.5);
}

void contact_model_set_g_star(struct contact_model *model, double g_star_m_s)
{
    model->damping = contact_model_is_constant(model)
                         ? (double)NAN
                         : pow(g_star_m_s, -contact_model_speed_exponent(model)) / first_coefficient(&model->law);
}

double contact_model_g_star_m_s(const struct contact_model *model)
{
    return contact_model_is_constant(model)
               ? (double)NAN
               : pow(model->damping * first_coefficient(&model->law), -1 / contact_model_speed_exponent(model));
}

/* ---- enclosed collisions ---- */

struct scaled_impact {
    double eps[CONTACT_ENDS], duration[CONTACT_ENDS], max_overlap;
};

static double nearest(const arb_t x)
{
    return arf_get_d(arb_midref(x), ARF_RND_NEAR);
}

typedef int collision_solver(struct collision *c, const arb_t beta, const struct law *law, slong bits);

#define ENCLOSED_BETA_MAX 1e12 /* beyond, the bits and the seconds of an enclosure grow without use */

static int enclose(struct scaled_impact *impact, const struct law *law, double beta, collision_solver *solve)
{
    if (!(beta <= ENCLOSED_BETA_MAX))
        return usage_error("beta is %g at an impact; allowed for x'' + beta x^(%ld/%ld) x' + x^(%ld/%ld) = 0: up to %g",
                           beta, (long)law->b.num, (long)law->b.den, (long)law->a.num, (long)law->a.den,
                           ENCLOSED_BETA_MAX);
    arb_t x;
    struct collision c;
    arb_init(x);
    collision_init(&c);
    arb_set_d(x, beta);
    const int status = solve(&c, x, law, MODEL_BITS);
    *impact = (struct scaled_impact){{nearest(c.eps_zero_overlap), nearest(c.eps_zero_force)},
                                     {nearest(c.t_zero_overlap), nearest(c.t_zero_force)},
                                     nearest(c.x_max)};
    collision_clear(&c);
    arb_clear(x);
    return status == 0 ? STATUS_OK : STATUS_FAILED;
}

/* ---- laws of the library ---- */

/* The functions of the damping parameter by the ends of contact; `beta` is the inverse of eps. */
struct library_law {
    double (*eps[CONTACT_ENDS])(double damping);
    double (*duration[CONTACT_ENDS])(double damping);
    double (*max_overlap)(double damping);
    double (*damping[CONTACT_ENDS])(double eps);
};

static const struct library_law sphere = {{cor_sphere_eps_zero_overlap, cor_sphere_eps_zero_force},
                                          {cor_sphere_duration_zero_overlap, cor_sphere_duration_zero_force},
                                          cor_sphere_max_overlap,
                                          {cor_sphere_beta_zero_overlap, cor_sphere_beta_zero_force}},
                                linear = {{cor_linear_eps_zero_overlap, cor_linear_eps_zero_force},
                                          {cor_linear_duration_zero_overlap, cor_linear_duration_zero_force},
                                          cor_linear_max_overlap,
                                          {cor_linear_zeta_zero_overlap, cor_linear_zeta_zero_force}},
                                tsuji = {{cor_tsuji_eps_zero_overlap, cor_tsuji_eps_zero_force},
                                         {cor_tsuji_duration_zero_overlap, cor_tsuji_duration_zero_force},
                                         cor_tsuji_max_overlap,
                                         {cor_tsuji_zeta_zero_overlap, cor_tsuji_zeta_zero_force}},
                                dashpot = {{cor_hertz_dashpot_eps_zero_overlap, cor_hertz_dashpot_eps_zero_force},
                                           {cor_hertz_dashpot_duration_zero_overlap,
                                            cor_hertz_dashpot_duration_zero_force},
                                           cor_hertz_dashpot_max_overlap,
                                           {cor_hertz_dashpot_beta_zero_overlap, cor_hertz_dashpot_beta_zero_force}},
                                /* durations and overlap depend on the elastic exponent, too */
    hunt_crossley = {{cor_hunt_crossley_eps, cor_hunt_crossley_eps},
                     {NULL, NULL},
                     NULL,
                     {cor_hunt_crossley_beta, cor_hunt_crossley_beta}},
                                /* eps of q = 0 is that of zeta, whatever the exponents are */
    constant = {{cor_linear_eps_zero_overlap, cor_linear_eps_zero_force},
                {NULL, NULL},
                NULL,
                {cor_linear_zeta_zero_overlap, cor_linear_zeta_zero_force}};

/* NULL: not a law of the library */
static const struct library_law *library_law_of(const struct law *law)
{
    if (law_is_sphere(law))
        return &sphere;
    if (is_hertz_dashpot(law))
        return &dashpot;
    if (law_is_linear(law))
        return law_is(law, 2, 0) ? &linear : law->a.num * 2 == law->a.den * 3 ? &tsuji : &constant;
    return law_is_hunt_crossley(law) ? &hunt_crossley : NULL;
}

bool contact_model_is_enclosed(const struct contact_model *model)
{
    const struct library_law *const f = library_law_of(&model->law);
    return !f || f == &constant;
}

/* The parameter of the library's functions: zeta where q = 0, beta elsewhere */
static double damping_parameter(const struct contact_model *model, double speed_m_s)
{
    return contact_model_is_constant(model) ? model->damping : contact_model_beta(model, speed_m_s);
}

static int scaled_impact(struct scaled_impact *impact, const struct contact_model *model, double parameter)
{
    const struct library_law *const f = library_law_of(&model->law);
    const double a = ratio_value(model->law.a);
    if (!f)
        return enclose(impact, &model->law, parameter, collision_solve);
    for (int end = 0; end < CONTACT_ENDS; end++)
        impact->eps[end] = f->eps[end](parameter);
    if (f == &constant) {
        struct scaled_impact times;
        const int status = enclose(&times, &model->law, parameter * beta_per_damping(model), collision_solve);
        for (int end = 0; end < CONTACT_ENDS; end++)
            impact->duration[end] = times.duration[end];
        impact->max_overlap = times.max_overlap;
        return status;
    }
    for (int end = 0; end < CONTACT_ENDS; end++)
        impact->duration[end] =
            f == &hunt_crossley ? cor_hunt_crossley_duration(parameter, a) : f->duration[end](parameter);
    impact->max_overlap = f == &hunt_crossley ? cor_hunt_crossley_max_overlap(parameter, a) : f->max_overlap(parameter);
    return STATUS_OK;
}

static int eps_of_parameter(double *eps, const struct law *law, double parameter, enum contact_end end)
{
    const struct library_law *const f = library_law_of(law);
    if (f) {
        *eps = f->eps[end](parameter);
        return STATUS_OK;
    }
    struct scaled_impact impact = {.eps = {1, 1}};
    const bool force = end == END_ZERO_FORCE && law_force_ends(law);
    const int status = parameter > 0
                           ? enclose(&impact, law, parameter, force ? collision_solve_force : collision_solve_overlap)
                           : STATUS_OK;
    *eps = impact.eps[force ? END_ZERO_FORCE : END_ZERO_OVERLAP];
    return status;
}

int contact_model_eps(double *eps, const struct contact_model *model, double speed_m_s, enum contact_end end)
{
    *eps = (double)NAN;
    return contact_model_has_end(model, end)
               ? eps_of_parameter(eps, &model->law, damping_parameter(model, speed_m_s), end)
               : STATUS_OK;
}

/* The unit of time at a speed */
static double time_unit(const struct contact_model *model, double speed_m_s)
{
    const double a = ratio_value(model->law.a);
    return time_factor(model) * pow(speed_m_s, (1 - a) / (1 + a));
}

int contact_model_eps_duration(double *eps, double *duration_s, const struct contact_model *model, double speed_m_s,
                               enum contact_end end)
{
    struct scaled_impact scaled;
    const int status = scaled_impact(&scaled, model, damping_parameter(model, speed_m_s));
    const bool defined = status == STATUS_OK && contact_model_has_end(model, end);
    *eps = defined ? scaled.eps[end] : (double)NAN;
    *duration_s = defined ? scaled.duration[end] * time_unit(model, speed_m_s) : (double)NAN;
    return status;
}

int contact_model_impact(struct contact_impact *impact, const struct contact_model *model, double speed_m_s)
{
    struct scaled_impact scaled;
    const double parameter = damping_parameter(model, speed_m_s), time = time_unit(model, speed_m_s);
    const int status = scaled_impact(&scaled, model, parameter);
    if (status != STATUS_OK)
        return status;
    impact->beta = contact_model_beta(model, speed_m_s);
    for (int end = 0; end < CONTACT_ENDS; end++) {
        const bool has = contact_model_has_end(model, (enum contact_end)end);
        impact->eps[end] = has ? scaled.eps[end] : (double)NAN;
        impact->duration_s[end] = has ? scaled.duration[end] * time : (double)NAN;
    }
    impact->max_overlap_m = scaled.max_overlap * speed_m_s * time;
    /* The plate takes up K x^a; the other term of the equation of motion is its own motion. */
    const double force =
        model->plate ? pow(scaled.max_overlap, ratio_value(model->law.a)) : contact_force_max(&model->law, parameter);
    impact->max_force_n = model->mass_kg * speed_m_s / time * force;
    return STATUS_OK;
}

/* ---- the damping from eps ---- */

/* Solves eps(beta) = eps where eps falls with beta, by the Illinois method on ln(beta) and ln(eps). */
static int enclosed_beta(double *beta, const struct law *law, double eps, enum contact_end end)
{
    enum { MOST_STEPS = 400 };
    const double wanted = log(eps);
    double low = 0, high = 0, above = 0, below = 0, last = 0, x = log(fmax(1 - eps, 1e-16) / first_coefficient(law));
    for (int k = 0; k < MOST_STEPS; k++) {
        double got;
        *beta = exp(x);
        if (eps_of_parameter(&got, law, *beta, end) != STATUS_OK)
            return STATUS_FAILED;
        const double rest = got > 0 ? log(got) - wanted : -1;
        const bool bracketed = below < 0 && above > 0;
        if (fabs(rest) < 1e-15 * fmax(1, fabs(wanted)) || (bracketed && high - low < 1e-15 * fmax(1, fabs(x))))
            return STATUS_OK;
        if (rest > 0) {
            below *= last > 0 ? 0.5 : 1;
            low = x;
            above = rest;
        } else {
            above *= last < 0 ? 0.5 : 1;
            high = x;
            below = rest;
        }
        last = rest;
        if (below < 0 && above > 0)
            x = (low * below - high * above) / (below - above);
        else
            x += above > 0 ? 1 : -1;
    }
    return fail("no damping found for which eps is %g", eps);
}

int contact_model_set_eps(struct contact_model *model, double eps, double speed_m_s, enum contact_end end)
{
    const struct library_law *const f = library_law_of(&model->law);
    double parameter = 0;
    if (f)
        parameter = f->damping[end](eps);
    else if (eps < 1 && enclosed_beta(&parameter, &model->law, eps, end) != STATUS_OK)
        return STATUS_FAILED;
    if (contact_model_is_constant(model))
        model->damping = parameter;
    else
        contact_model_set_beta(model, parameter, speed_m_s);
    return STATUS_OK;
}
