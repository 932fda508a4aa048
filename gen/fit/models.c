/* SPDX-License-Identifier: MIT */
#include "fit/models.h"

#include <math.h>
#include <string.h>

#include <cor/law.h>
#include <cor/scene.h>
#include <cor/sphere.h>

/* ---- curves ---- */

/* of_beta: eps is a function of beta, that of a law and an end. A curve with a loss has a dry one and x. */
enum loss { LOSS_NONE, LOSS_ADHESION, LOSS_LIQUID };
static const struct {
    double exponent; /* q */
    bool of_beta;
    enum cor_law law;
    enum cor_end end;
    enum loss loss;
    enum fit_curve dry;
} curves[FIT_CURVES] = {
    [FIT_SPHERE_ZERO_OVERLAP] = {.exponent = 0.2, .of_beta = true, .law = COR_LAW_VISCOELASTIC},
    [FIT_SPHERE_ZERO_FORCE] = {.exponent = 0.2, .of_beta = true, .end = COR_END_ZERO_FORCE},
    [FIT_HUNT_CROSSLEY] = {.exponent = 1, .of_beta = true, .law = COR_LAW_HUNT_CROSSLEY},
    [FIT_HERTZ_DASHPOT_ZERO_OVERLAP] = {.exponent = -0.2, .of_beta = true, .law = COR_LAW_HERTZ_DASHPOT},
    [FIT_HERTZ_DASHPOT_ZERO_FORCE] = {.exponent = -0.2,
                                      .of_beta = true,
                                      .law = COR_LAW_HERTZ_DASHPOT,
                                      .end = COR_END_ZERO_FORCE},
    [FIT_ADHESIVE] = {.loss = LOSS_ADHESION, .dry = FIT_CONSTANT},
    [FIT_ADHESIVE_SPHERE_ZERO_OVERLAP] = {.loss = LOSS_ADHESION, .dry = FIT_SPHERE_ZERO_OVERLAP},
    [FIT_ADHESIVE_SPHERE_ZERO_FORCE] = {.loss = LOSS_ADHESION, .dry = FIT_SPHERE_ZERO_FORCE},
    [FIT_WET] = {.loss = LOSS_LIQUID, .dry = FIT_CONSTANT},
    [FIT_WET_SPHERE_ZERO_OVERLAP] = {.loss = LOSS_LIQUID, .dry = FIT_SPHERE_ZERO_OVERLAP},
    [FIT_WET_SPHERE_ZERO_FORCE] = {.loss = LOSS_LIQUID, .dry = FIT_SPHERE_ZERO_FORCE},
};

int fit_curve_parameters(enum fit_curve curve)
{
    return curves[curve].loss != LOSS_NONE || curve == FIT_POWER_LAW ? 2 : 1;
}

enum fit_curve fit_curve_dry(enum fit_curve curve)
{
    return curves[curve].loss == LOSS_NONE ? curve : curves[curve].dry;
}

bool fit_coordinate_is_logarithm(enum fit_curve curve, int parameter)
{
    return parameter == 0 ? fit_curve_dry(curve) != FIT_CONSTANT : curve != FIT_POWER_LAW;
}

enum { BLOCK = 256 };

/* At most BLOCK values */
static void lossy_eps(enum fit_curve curve, const double *theta, const double *log_speed, double *eps, size_t n)
{
    const double x = exp(theta[1]);
    double at[BLOCK];
    for (size_t i = 0; i < n; i++) {
        const double left = exp(log_speed[i]) - x;
        at[i] = curves[curve].loss == LOSS_ADHESION ? log_speed[i] : left > 0 ? log(left) : log_speed[i];
    }
    fit_curve_eps(curves[curve].dry, theta, at, eps, n);
    for (size_t i = 0; i < n; i++) {
        const double ratio = exp(theta[1] - log_speed[i]);
        eps[i] = curves[curve].loss == LOSS_ADHESION ? sqrt(fmax((eps[i] - ratio) * (eps[i] + ratio), 0))
                                                     : cor_wet_eps(eps[i], 1, ratio);
    }
}

void fit_curve_eps(enum fit_curve curve, const double *theta, const double *log_speed, double *eps, size_t n)
{
    double beta[BLOCK];
    for (size_t first = 0; first < n; first += BLOCK) {
        const size_t count = n - first < BLOCK ? n - first : BLOCK;
        const double *const place = log_speed + first;
        if (curves[curve].loss != LOSS_NONE) {
            lossy_eps(curve, theta, place, eps + first, count);
            continue;
        }
        for (size_t i = 0; i < count; i++)
            beta[i] = curve == FIT_CONSTANT          ? theta[0]
                      : curve == FIT_POWER_LAW       ? exp(fmin(theta[0] + theta[1] * place[i], 0))
                      : curve == FIT_ELASTIC_PLASTIC ? cor_elastic_plastic_eps(exp(place[i] - theta[0]))
                                                     : exp(theta[0] + curves[curve].exponent * place[i]);
        if (curves[curve].of_beta)
            cor_law_array(curves[curve].law, curves[curve].end, COR_EPS, beta, eps + first, count);
        else
            memcpy(eps + first, beta, count * sizeof *beta);
    }
}

void fit_curve_range(enum fit_curve curve, int parameter, double least_log_speed, double most_log_speed, double *low,
                     double *high)
{
    const double weakest = log(1e-9), strongest = log(1e9); /* beta */
    const enum fit_curve dry = fit_curve_dry(curve);
    const double a = curves[dry].exponent * least_log_speed, b = curves[dry].exponent * most_log_speed;
    if (parameter == 1 && curve != FIT_POWER_LAW) { /* from a loss of 1e-12 of eps at all speeds to all of it */
        *low = least_log_speed + (curves[curve].loss == LOSS_ADHESION ? log(1e-6) : log(1e-12));
        *high = most_log_speed;
    } else if (dry == FIT_ELASTIC_PLASTIC) { /* eps = 1.2 (v_y/g)^(1/4) */
        *low = least_log_speed + 4 * log(1e-9);
        *high = most_log_speed;
    } else if (dry == FIT_CONSTANT) {
        *low = 0;
        *high = 1;
    } else if (curve == FIT_POWER_LAW) {
        *high = parameter == 0 ? 1e4 : 100;
        *low = -*high;
    } else {
        *low = weakest - fmax(a, b);
        *high = strongest - fmin(a, b);
    }
}

/* ---- parameters ---- */

static double zeta_zero_overlap(double eps)
{
    return cor_law_value(COR_LAW_LINEAR, COR_END_ZERO_OVERLAP, COR_DAMPING_OF_EPS, eps);
}

static double zeta_zero_force(double eps)
{
    return cor_law_value(COR_LAW_LINEAR, COR_END_ZERO_FORCE, COR_DAMPING_OF_EPS, eps);
}

static double identity(double theta)
{
    return theta;
}

/* g* from beta at 1 m/s: a contact of the characteristic speed 1 m/s has the beta 1/|C_1| there */
static double g_star_m_s(double theta)
{
    struct cor_sphere_contact contact;
    cor_sphere_contact_init_g_star(&contact, 1);
    return pow(contact.beta_per_root / exp(theta), 5);
}

/* Zener's lambda = (2/3) beta at 1 m/s */
static double zener_lambda(double theta)
{
    return exp(theta) * 2 / 3;
}

/* The contact of two bodies with the dissipation time 1 s */
static struct cor_sphere_contact contact_of_unit_time(const struct fit_bodies *bodies)
{
    struct fit_bodies unit = *bodies;
    struct cor_sphere_contact contact;
    unit.body_1.dissipation_time_s = unit.body_2.dissipation_time_s = 1;
    cor_sphere_contact_init(&contact, &unit.body_1, &unit.body_2);
    return contact;
}

static double dissipation_time_s(double theta, const struct fit_bodies *bodies)
{
    return exp(theta) / contact_of_unit_time(bodies).beta_per_root;
}

/* Thickness h of the plate: beta = (3/2) (m/Z) (rho/m)^(2/5) is proportional to h^-2 */
static double plate_thickness_m(double theta, const struct fit_bodies *bodies)
{
    const struct cor_plate plate = {bodies->body_2.young_modulus_pa, bodies->body_2.poisson_ratio,
                                    bodies->density_2_kg_m3, 1};
    struct cor_body sphere = bodies->body_1;
    struct cor_sphere_contact contact;
    sphere.dissipation_time_s = 0;
    cor_plate_contact_init(&contact, &sphere, &plate);
    return sqrt(contact.beta_per_root / exp(theta));
}

/* C of the force K x^(3/2) + C x', N s/m: beta at 1 m/s is C/(m (K/m)^(2/5)) */
static double damping_coefficient_kg_s(double theta, const struct fit_bodies *bodies)
{
    const struct cor_sphere_contact contact = contact_of_unit_time(bodies);
    return exp(theta) * contact.effective_mass_kg / contact.scale;
}

/* The yield stress of the yield speed exp(theta) */
static double yield_stress_pa(double theta, const struct fit_bodies *bodies)
{
    const struct cor_sphere_contact sphere = contact_of_unit_time(bodies);
    const struct cor_scene_contact contact = {.law = cor_law_exponents[COR_LAW_ELASTIC_PLASTIC],
                                              .mass_kg = sphere.effective_mass_kg,
                                              .stiffness = sphere.elastic_constant_n_m15,
                                              .radius_m = sphere.effective_radius_m};
    return cor_scene_yield_stress(&contact, exp(theta));
}

/* ---- models ---- */

#define ZERO_OVERLAP(NAME) NAME, "zero-overlap", NAME " zero-overlap"
#define ZERO_FORCE(NAME) NAME, "zero-force", NAME " zero-force"
#define BOTH_ENDS(NAME) NAME, "both", NAME
/* One parameter, its function of the coordinate, and both where the bodies are known */
#define ONE(PARAMETER, VALUE) {PARAMETER}, NULL, VALUE, NULL
#define KNOWN(PARAMETER, VALUE, WITH_BODIES, VALUE_WITH_BODIES) {PARAMETER}, WITH_BODIES, VALUE, VALUE_WITH_BODIES
#define SPHERE KNOWN("g_star_m_s", g_star_m_s, "dissipation_time_s", dissipation_time_s)
#define SPHERE_AND(SECOND) {"g_star_m_s", SECOND}, "dissipation_time_s", g_star_m_s, dissipation_time_s
#define DASHPOT KNOWN("beta_at_1_m_s", exp, "damping_coefficient_n_s_m", damping_coefficient_kg_s)
const struct fit_model fit_models[] = {
    {ZERO_OVERLAP("viscoelastic"), FIT_SPHERE_ZERO_OVERLAP, SPHERE},
    {ZERO_FORCE("viscoelastic"), FIT_SPHERE_ZERO_FORCE, SPHERE},
    {ZERO_OVERLAP("plate"), FIT_SPHERE_ZERO_OVERLAP,
     KNOWN("zener_lambda_at_1_m_s", zener_lambda, "plate_thickness_m", plate_thickness_m)},
    {BOTH_ENDS("constant"), FIT_CONSTANT, ONE("eps", identity)},
    {ZERO_OVERLAP("linear"), FIT_CONSTANT, ONE("zeta", zeta_zero_overlap)},
    {ZERO_FORCE("linear"), FIT_CONSTANT, ONE("zeta", zeta_zero_force)},
    {ZERO_OVERLAP("tsuji"), FIT_CONSTANT, ONE("zeta", zeta_zero_overlap)},
    {ZERO_FORCE("tsuji"), FIT_CONSTANT, ONE("zeta", zeta_zero_force)},
    {BOTH_ENDS("hunt-crossley"), FIT_HUNT_CROSSLEY, ONE("dissipation_s_m", exp)},
    {ZERO_OVERLAP("hertz-dashpot"), FIT_HERTZ_DASHPOT_ZERO_OVERLAP, DASHPOT},
    {ZERO_FORCE("hertz-dashpot"), FIT_HERTZ_DASHPOT_ZERO_FORCE, DASHPOT},
    {BOTH_ENDS("power-law"), FIT_POWER_LAW, {"eps_at_1_m_s", "exponent"}, NULL, exp, NULL},
    {BOTH_ENDS("elastic-plastic"), FIT_ELASTIC_PLASTIC,
     KNOWN("yield_speed_m_s", exp, "yield_stress_pa", yield_stress_pa)},
    {BOTH_ENDS("adhesive"), FIT_ADHESIVE, {"eps_dry", "adhesion_speed_m_s"}, NULL, identity, NULL},
    {ZERO_OVERLAP("adhesive-viscoelastic"), FIT_ADHESIVE_SPHERE_ZERO_OVERLAP, SPHERE_AND("adhesion_speed_m_s")},
    {ZERO_FORCE("adhesive-viscoelastic"), FIT_ADHESIVE_SPHERE_ZERO_FORCE, SPHERE_AND("adhesion_speed_m_s")},
    {BOTH_ENDS("wet"), FIT_WET, {"eps_dry", "liquid_speed_m_s"}, NULL, identity, NULL},
    {ZERO_OVERLAP("wet-viscoelastic"), FIT_WET_SPHERE_ZERO_OVERLAP, SPHERE_AND("liquid_speed_m_s")},
    {ZERO_FORCE("wet-viscoelastic"), FIT_WET_SPHERE_ZERO_FORCE, SPHERE_AND("liquid_speed_m_s")},
};
const size_t fit_model_count = sizeof fit_models / sizeof *fit_models;

/* Whether the bodies determine another parameter. The thickness of a plate needs its density and a finite modulus. */
static bool bodies_matter(const struct fit_model *model, const struct fit_bodies *bodies)
{
    return bodies && model->parameter_with_bodies &&
           !(strcmp(model->name, "plate") == 0 &&
             (isnan(bodies->density_2_kg_m3) || isinf(bodies->body_2.young_modulus_pa)));
}

const char *fit_parameter_name(const struct fit_model *model, int parameter, const struct fit_bodies *bodies)
{
    return parameter == 0 && bodies_matter(model, bodies) ? model->parameter_with_bodies : model->parameter[parameter];
}

double fit_parameter_value(const struct fit_model *model, int parameter, double theta, const struct fit_bodies *bodies)
{
    if (parameter > 0)
        return fit_coordinate_is_logarithm(model->curve, parameter) ? exp(theta) : theta;
    return bodies_matter(model, bodies) ? model->value_with_bodies(theta, bodies) : model->value(theta);
}
