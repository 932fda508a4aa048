/* SPDX-License-Identifier: MIT */
#include "contact/contact_request.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "cor/contact.h"
#include "cor/status.h"
#include "support/console.h"

const char *const contact_law_names[] = {[EMBED_VISCOELASTIC] = "viscoelastic",
                                         [EMBED_LINEAR] = "linear",
                                         [EMBED_TSUJI] = "tsuji",
                                         [EMBED_HUNT_CROSSLEY] = "hunt-crossley",
                                         [EMBED_HERTZ_DASHPOT] = "hertz-dashpot",
                                         [CONTACT_LAW_PLATE] = "plate",
                                         NULL};

static bool has(const struct contact_request *request, enum embed_number which)
{
    return embed_given(&request->scene, which);
}

static double number(const struct contact_request *request, enum embed_number which)
{
    return embed_number(&request->scene, which);
}

static bool is_plate(const struct contact_request *request)
{
    return request->law == CONTACT_LAW_PLATE;
}

/* ---- bodies ---- */

#define BODY_RULE                                                                                                      \
    "a contact of bodies has --young, --poisson, --radius and --density or --mass, as --young 7e10 --poisson 0.17 "    \
    "--radius 1e-3 --density 1600; -2 for the second body, or --wall"

static bool has_bodies(const struct contact_request *request)
{
    bool any = request->scene.wall || request->number[CONTACT_PLATE_THICKNESS].text != NULL;
    for (enum embed_number which = EMBED_YOUNG; which <= EMBED_MASS_2; which++)
        any = any || (which != EMBED_DISSIPATION_TIME && has(request, which));
    return any;
}

static int check_bodies(const struct contact_request *request)
{
    static const enum embed_number needed[] = {EMBED_YOUNG, EMBED_POISSON, EMBED_RADIUS};
    for (size_t i = 0; i < sizeof needed / sizeof *needed; i++)
        if (!has(request, needed[i]))
            return usage_error("--%s is missing: " BODY_RULE, embed_number_names[needed[i]]);
    if (has(request, EMBED_DENSITY) == has(request, EMBED_MASS))
        return usage_error("--density and --mass: give one of them; " BODY_RULE);
    if (has(request, EMBED_DENSITY_2) && has(request, EMBED_MASS_2))
        return usage_error("--density-2 and --mass-2 exclude each other");
    if (request->scene.wall &&
        (has(request, EMBED_RADIUS_2) || has(request, EMBED_DENSITY_2) || has(request, EMBED_MASS_2)))
        return usage_error("--wall is flat and held fast: no --radius-2, --density-2 or --mass-2");
    const bool thickness = request->number[CONTACT_PLATE_THICKNESS].text != NULL;
    if (!is_plate(request))
        return thickness ? usage_error("--plate-thickness needs --law plate") : STATUS_OK;
    if (!thickness || has(request, EMBED_RADIUS_2) || has(request, EMBED_MASS_2) || request->scene.wall)
        return usage_error(
            "--law plate is a sphere on a plate of --plate-thickness H, as 3e-3, and, where they differ from "
            "the sphere's, --young-2, --poisson-2 and --density-2; no --radius-2, --mass-2 or --wall");
    return has(request, EMBED_DENSITY_2) || has(request, EMBED_DENSITY)
               ? STATUS_OK
               : usage_error("--density-2 is missing: the density of the plate in kg/m^3, as 2500");
}

static double number_of_body(const struct contact_request *request, enum embed_number which, int body)
{
    return decimal_value(embed_number_of_body(&request->scene, which, body));
}

/* "ETA1,ETA2", both not negative */
static int parse_viscosity(double eta[2], const char *option, const char *text)
{
    char part[2][64];
    const char *const comma = strchr(text, ',');
    bool good = comma && (size_t)(comma - text) < sizeof part[0] && strlen(comma + 1) < sizeof part[1];
    if (good) {
        snprintf(part[0], sizeof part[0], "%.*s", (int)(comma - text), text);
        snprintf(part[1], sizeof part[1], "%s", comma + 1);
    }
    for (int i = 0; good && i < 2; i++) {
        struct decimal x = {0};
        good = decimal_parse(&x, part[i], DECIMAL_EXPONENT_DIGITS) && x.forms == DECIMAL_PLAIN;
        if (good) {
            eta[i] = decimal_value(&x);
            good = isfinite(eta[i]);
        }
        decimal_clear(&x);
    }
    return good ? STATUS_OK
                : usage_error("--%s: '%s' is not two numbers, 0 or more, with a comma between them: ETA1,ETA2 in Pa s, "
                              "as 1e3,2e3",
                              option, text);
}

/* A of one body: as given, of its viscosities, or 0 */
static int set_dissipation_time(struct cor_body *cor, const struct contact_request *request, int body)
{
    const struct decimal *const given = embed_number_of_body(&request->scene, EMBED_DISSIPATION_TIME, body);
    const bool own = body == 2 && request->viscosity_2;
    const char *const viscosity = own ? request->viscosity_2 : request->viscosity;
    double eta[2];
    cor->dissipation_time_s = given->text ? decimal_value(given) : 0;
    if (!viscosity)
        return STATUS_OK;
    const int status = parse_viscosity(eta, own ? "viscosity-2" : "viscosity", viscosity);
    if (status == STATUS_OK)
        cor->dissipation_time_s =
            cor_dissipation_time_viscous_s(eta[0], eta[1], cor->young_modulus_pa, cor->poisson_ratio);
    return status;
}

static int set_body(struct cor_body *cor, const struct contact_request *request, int body)
{
    static const double pi = 3.14159265358979323846;
    cor->young_modulus_pa = number_of_body(request, EMBED_YOUNG, body);
    cor->poisson_ratio = number_of_body(request, EMBED_POISSON, body);
    cor->radius_m = cor->mass_kg = INFINITY;
    if (body == 1 || !request->scene.wall) {
        cor->radius_m = number_of_body(request, EMBED_RADIUS, body);
        cor->mass_kg = embed_mass_is_given(&request->scene, body)
                           ? number_of_body(request, EMBED_MASS, body)
                           : 4 * pi / 3 * pow(cor->radius_m, 3) * number_of_body(request, EMBED_DENSITY, body);
    }
    return set_dissipation_time(cor, request, body);
}

/* Sets mass, stiffness and radius, and the damping that the materials themselves have. */
static int set_materials(struct contact_model *model, const struct contact_request *request)
{
    struct cor_body body[2];
    struct cor_sphere_contact contact;
    int status = check_bodies(request);
    if (status == STATUS_OK)
        status = set_body(&body[0], request, 1);
    if (status == STATUS_OK && !is_plate(request))
        status = set_body(&body[1], request, 2);
    if (status != STATUS_OK)
        return status;
    const struct cor_plate plate = {number_of_body(request, EMBED_YOUNG, 2), number_of_body(request, EMBED_POISSON, 2),
                                    number_of_body(request, EMBED_DENSITY, 2),
                                    decimal_value(&request->number[CONTACT_PLATE_THICKNESS])};
    const int wrong = is_plate(request) ? cor_plate_contact_init(&contact, &body[0], &plate)
                                        : cor_sphere_contact_init(&contact, &body[0], &body[1]);
    if (wrong != COR_OK)
        return usage_error("these bodies make no contact: %s", cor_status_text(wrong));
    model->mass_kg = contact.effective_mass_kg;
    model->stiffness = contact.elastic_constant_n_m15;
    model->radius_m = contact.effective_radius_m;
    model->damping = contact.beta_per_root;
    return STATUS_OK;
}

static int set_stiffness(struct contact_model *model, const struct contact_request *request)
{
    if (!has(request, EMBED_STIFFNESS) || !has(request, EMBED_EFFECTIVE_MASS))
        return usage_error("--%s is missing: a spring has --stiffness K in N/m^a and --effective-mass m_1 m_2/(m_1 + "
                           "m_2) in kg, as --stiffness 1e5 --effective-mass 1e-3",
                           has(request, EMBED_STIFFNESS) ? "effective-mass" : "stiffness");
    model->stiffness = number(request, EMBED_STIFFNESS);
    model->mass_kg = number(request, EMBED_EFFECTIVE_MASS);
    return STATUS_OK;
}

static int set_scales(struct contact_model *model, const struct contact_request *request)
{
    const bool bodies = has_bodies(request),
               spring = has(request, EMBED_STIFFNESS) || has(request, EMBED_EFFECTIVE_MASS);
    if (bodies && spring)
        return usage_error("--stiffness with --effective-mass and bodies exclude each other; " BODY_RULE);
    if (is_plate(request) && !bodies)
        return usage_error("--law plate needs a sphere and a plate: --young, --poisson, --radius, --density or --mass, "
                           "--plate-thickness, and -2 of the plate, as --young 7e10 --poisson 0.24 --radius 5e-3 "
                           "--density 2500 --plate-thickness 3e-3");
    if (bodies && model->law.a.num * 2 != model->law.a.den * 3)
        return usage_error("two bodies have Hertz's force, x^(3/2); the law %s needs --stiffness K in N/m^a and "
                           "--effective-mass M in kg, as --stiffness 1e5 --effective-mass 1e-3",
                           law_equation(&model->law).text);
    if (bodies)
        return set_materials(model, request);
    return spring ? set_stiffness(model, request) : STATUS_OK;
}

/* ---- the damping ---- */

enum way { WAY_TIME, WAY_VISCOSITY, WAY_G_STAR, WAY_RESTITUTION, WAY_COEFFICIENT, WAY_BETA, WAY_ZETA, WAYS };
static const char *const way_names[WAYS] = {"dissipation-time",    "viscosity", "g-star", "restitution",
                                            "damping-coefficient", "beta",      "zeta"};

#define WAY_RULE                                                                                                       \
    "the dissipation is one of --dissipation-time A (s), --viscosity ETA1,ETA2 (Pa s), --g-star G (m/s), "             \
    "--restitution E --at SPEED (as --restitution 0.9 --at 1), --damping-coefficient C, --beta B --at SPEED, --zeta Z"

static bool way_is_given(const struct contact_request *request, enum way way)
{
    switch (way) {
    case WAY_TIME:
        return has(request, EMBED_DISSIPATION_TIME) || has(request, EMBED_DISSIPATION_TIME_2);
    case WAY_VISCOSITY:
        return request->viscosity || request->viscosity_2;
    case WAY_G_STAR:
        return has(request, EMBED_G_STAR);
    case WAY_RESTITUTION:
        return request->number[CONTACT_RESTITUTION].text != NULL;
    case WAY_COEFFICIENT:
        return has(request, EMBED_DAMPING_COEFFICIENT);
    case WAY_BETA:
        return has(request, EMBED_BETA);
    default:
        return request->number[CONTACT_ZETA].text != NULL;
    }
}

static int find_way(enum way *found, const struct contact_request *request)
{
    *found = WAYS;
    for (enum way way = 0; way < WAYS; way++) {
        if (!way_is_given(request, way))
            continue;
        if (*found != WAYS)
            return usage_error("--%s and --%s exclude each other: " WAY_RULE, way_names[*found], way_names[way]);
        *found = way;
    }
    return *found == WAYS && !is_plate(request) ? usage_error("no dissipation: " WAY_RULE) : STATUS_OK;
}

/* Whether this way suits the law and has the numbers that it needs */
static int check_way(const struct contact_request *request, const struct contact_model *model, enum way way)
{
    const bool constant = contact_model_is_constant(model), scales = contact_model_has_scales(model);
    if (is_plate(request) && way != WAYS && way != WAY_TIME && way != WAY_VISCOSITY)
        return usage_error("the plate dissipates by its own motion: --law plate takes no --%s, only the "
                           "--dissipation-time or --viscosity of the sphere",
                           way_names[way]);
    if ((way == WAY_TIME || way == WAY_VISCOSITY) && !law_is_sphere(&model->law))
        return usage_error("--%s is that of viscoelastic spheres, not of the law %s: give --restitution E%s or "
                           "--damping-coefficient C",
                           way_names[way], law_equation(&model->law).text, constant ? "" : " --at SPEED");
    if (way == WAY_G_STAR && constant)
        return usage_error(
            "--g-star: eps of the law %s is the same at every speed; give --restitution E or --zeta Z, as --zeta 0.1",
            law_equation(&model->law).text);
    if (way == WAY_ZETA && !constant)
        return usage_error("--zeta is the damping ratio of the laws linear and tsuji; the law %s takes --restitution E "
                           "--at SPEED or --damping-coefficient C",
                           law_equation(&model->law).text);
    if (way == WAY_VISCOSITY && !has_bodies(request))
        return usage_error("--viscosity needs bodies, whose elasticity divides it: " BODY_RULE);
    if ((way == WAY_TIME || way == WAY_COEFFICIENT) && !scales)
        return usage_error("--%s needs bodies, or --stiffness and --effective-mass: " BODY_RULE, way_names[way]);
    const bool speed = !constant && (way == WAY_RESTITUTION || way == WAY_BETA);
    if (speed && !has(request, EMBED_AT))
        return usage_error("--%s needs --at SPEED in m/s, as --at 1: eps of the law %s depends on the speed (that of "
                           "linear and tsuji does not)",
                           way_names[way], law_equation(&model->law).text);
    if (has(request, EMBED_AT) && way != WAY_RESTITUTION && way != WAY_BETA)
        return usage_error("--at is the speed of --restitution or --beta, and neither is given");
    if (request->viscosity_2 && !request->viscosity)
        return usage_error("--viscosity-2 needs --viscosity, that of the first body");
    if (has(request, EMBED_DISSIPATION_TIME_2) && !has(request, EMBED_DISSIPATION_TIME))
        return usage_error("--dissipation-time-2 needs --dissipation-time, that of the first body");
    if ((request->viscosity_2 || has(request, EMBED_DISSIPATION_TIME_2)) && (!has_bodies(request) || is_plate(request)))
        return usage_error("--%s-2 needs a second body that is viscoelastic", way_names[way]);
    return STATUS_OK;
}

static int set_restitution(struct contact_models *models, const struct contact_request *request)
{
    const double eps = decimal_value(&request->number[CONTACT_RESTITUTION]);
    const double speed = has(request, EMBED_AT) ? number(request, EMBED_AT) : 1;
    const bool both = request->end == CONTACT_BOTH_ENDS && contact_model_ends_differ(&models->model[0]);
    models->count = both ? CONTACT_ENDS : 1;
    models->model[1] = models->model[0];
    int status = STATUS_OK;
    for (int i = 0; i < models->count && status == STATUS_OK; i++) {
        models->measured_end[i] = (enum contact_end)(both || request->end == CONTACT_BOTH_ENDS ? i : request->end);
        status = contact_model_set_eps(&models->model[i], eps, speed, models->measured_end[i]);
    }
    return status;
}

static int set_damping(struct contact_models *models, const struct contact_request *request)
{
    struct contact_model *const model = &models->model[0];
    enum way way;
    int status = find_way(&way, request);
    if (status == STATUS_OK)
        status = check_way(request, model, way);
    if (status != STATUS_OK)
        return status;
    switch (way) {
    case WAY_TIME:
        if (!has_bodies(request))
            contact_model_set_dissipation_time(model, number(request, EMBED_DISSIPATION_TIME));
        return STATUS_OK;
    case WAY_G_STAR:
        contact_model_set_g_star(model, number(request, EMBED_G_STAR));
        return STATUS_OK;
    case WAY_COEFFICIENT:
        contact_model_set_coefficient(model, number(request, EMBED_DAMPING_COEFFICIENT));
        return STATUS_OK;
    case WAY_BETA:
        contact_model_set_beta(model, number(request, EMBED_BETA),
                               has(request, EMBED_AT) ? number(request, EMBED_AT) : 1);
        return STATUS_OK;
    case WAY_ZETA:
        model->damping = decimal_value(&request->number[CONTACT_ZETA]);
        return STATUS_OK;
    case WAY_RESTITUTION:
        return set_restitution(models, request);
    default:
        return STATUS_OK; /* set_materials has set it */
    }
}

int contact_request_models(struct contact_models *models, const struct contact_request *request)
{
    struct embed_request scene = request->scene;
    struct law law;
    scene.law = is_plate(request) ? EMBED_VISCOELASTIC : (enum embed_law)request->law;
    int status = embed_request_law(&law, &scene);
    if (status != STATUS_OK)
        return status;
    if (is_plate(request) && request->end == END_ZERO_FORCE)
        return usage_error(
            "--end zero-force: a plate has the end zero-overlap alone; its contact force is never attractive");
    *models = (struct contact_models){.count = 1, .model = {contact_model_of_law(&law)}};
    models->model[0].plate = is_plate(request);
    status = set_scales(&models->model[0], request);
    if (status == STATUS_OK)
        status = set_damping(models, request);
    for (int i = 0; i < models->count && status == STATUS_OK; i++)
        if (!(models->model[i].damping >= 0 && models->model[i].damping < INFINITY))
            status = usage_error("the damping of this contact is beyond a double: the numbers of its bodies or of its "
                                 "dissipation are too far apart");
    return status;
}
