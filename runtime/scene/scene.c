/* SPDX-License-Identifier: MIT */
/* Makes the contact of a scene: first mass and stiffness from bodies or a spring, then the damping */
#include "cor/scene.h"

#include <math.h>

#include "cor/status.h"
#include "runtime/scene/exponents.h"
#include "runtime/scene/motion.h"

static int refuse_scene(struct cor_scene_fault *fault, int what, int number, int other)
{
    *fault = (struct cor_scene_fault){what, number, other, COR_OK};
    return what;
}

/* A fault, and the condition for it */
struct rule {
    int broken, fault, number, other;
};

/* Sets the fault of the first broken rule. The last rule is {0}. */
static int refuse_first(struct cor_scene_fault *fault, const struct rule *rule)
{
    while (!rule->broken && rule->fault != COR_FAULT_NONE)
        rule++;
    return rule->broken ? refuse_scene(fault, rule->fault, rule->number, rule->other) : COR_FAULT_NONE;
}

/* ---- bodies, or a spring ---- */

/* True if a number of a body, other than its dissipation, is given. A wall counts too, unless a spring is given. */
static int has_bodies(const struct cor_scene *scene)
{
    const int spring = cor_scene_given(scene, COR_SCENE_STIFFNESS) ||
                       cor_scene_given(scene, COR_SCENE_EFFECTIVE_MASS) || cor_scene_given(scene, COR_SCENE_DURATION);
    int any = (scene->wall && !spring) || cor_scene_given(scene, COR_SCENE_PLATE_THICKNESS);
    for (int number = COR_SCENE_YOUNG; number < COR_SCENE_DISSIPATION_TIME; number++)
        any = any || cor_scene_given(scene, number) || cor_scene_given(scene, number + COR_SCENE_BODY);
    return any;
}

static int check_bodies(struct cor_scene_fault *fault, const struct cor_scene *scene)
{
    const int thick = cor_scene_given(scene, COR_SCENE_PLATE_THICKNESS), plate = scene->plate;
    const int dense = cor_scene_given(scene, COR_SCENE_DENSITY_2) || cor_scene_given(scene, COR_SCENE_DENSITY);
    const int sphere_2 = cor_scene_given(scene, COR_SCENE_RADIUS_2) || cor_scene_given(scene, COR_SCENE_MASS_2);
    const struct rule rules[] = {
        {thick && !plate, COR_FAULT_PLATE_LAW, COR_SCENE_PLATE_THICKNESS, 0},
        {plate && (!thick || sphere_2 || scene->wall), COR_FAULT_PLATE_NUMBERS, COR_SCENE_PLATE_THICKNESS, 0},
        {plate && !dense, COR_FAULT_PLATE_DENSITY, COR_SCENE_DENSITY_2, 0},
        {0}};
    return cor_scene_check_bodies(fault, scene, 0) != COR_FAULT_NONE ? fault->fault : refuse_first(fault, rules);
}

/* Returns the index of the viscosity of a body. Body 2 without its own viscosity has the viscosity of body 1. -1: none
 * is given. */
static int viscosity_of(const struct cor_scene *scene, int body)
{
    if (body == 2 && cor_scene_given(scene, COR_SCENE_VISCOSITY_2))
        return COR_SCENE_VISCOSITY_2;
    return cor_scene_given(scene, COR_SCENE_VISCOSITY) ? COR_SCENE_VISCOSITY : -1;
}

struct cor_body cor_scene_body(const struct cor_scene *scene, int body)
{
    const int viscosity = viscosity_of(scene, body);
    const double time = cor_scene_of_body(scene, COR_SCENE_DISSIPATION_TIME, body);
    struct cor_body b = {cor_scene_of_body(scene, COR_SCENE_YOUNG, body),
                         cor_scene_of_body(scene, COR_SCENE_POISSON, body), isnan(time) ? 0 : time, INFINITY, INFINITY};
    if (body == 1 || !scene->wall) {
        b.radius_m = cor_scene_of_body(scene, COR_SCENE_RADIUS, body);
        b.mass_kg = cor_scene_mass_is_given(scene, body)
                        ? cor_scene_of_body(scene, COR_SCENE_MASS, body)
                        : cor_quiet_product(4 * COR_PI / 3 * cor_quiet_power(b.radius_m, 3),
                                            cor_scene_of_body(scene, COR_SCENE_DENSITY, body));
    }
    if (viscosity >= 0)
        b.dissipation_time_s = cor_dissipation_time_viscous_s(scene->number[viscosity], scene->number[viscosity + 1],
                                                              b.young_modulus_pa, b.poisson_ratio);
    return b;
}

double cor_scene_rayleigh_step_s(const struct cor_scene *scene)
{
    double least = INFINITY;
    for (int k = 1; k <= (scene->wall || scene->plate ? 1 : 2); k++) {
        const struct cor_body b = cor_scene_body(scene, k);
        const double volume = cor_quiet_product(4 * COR_PI / 3, cor_quiet_power(b.radius_m, 3)),
                     shear_modulus_pa = cor_quiet_quotient(b.young_modulus_pa, 2 * (1 + b.poisson_ratio)),
                     square = cor_quiet_quotient(cor_quiet_product(shear_modulus_pa, volume), b.mass_kg),
                     wave = (0.1631 * b.poisson_ratio + 0.8766) * (isgreater(square, 0) ? sqrt(square) : (double)NAN),
                     step = cor_quiet_quotient(cor_quiet_product(COR_PI, b.radius_m), wave);
        least = isless(step, least) || isnan(step) ? step : least;
    }
    return least;
}

/* Sets mass, stiffness and radius, and the damping of the materials themselves. */
static int set_materials(struct cor_scene_contact *contact, struct cor_scene_fault *fault,
                         const struct cor_scene *scene)
{
    struct cor_sphere_contact sphere;
    if (check_bodies(fault, scene) != COR_FAULT_NONE)
        return fault->fault;
    for (int body = 1; body <= (scene->plate ? 1 : 2); body++) {
        const int eta = viscosity_of(scene, body);
        if (eta >= 0 && !(isgreaterequal(scene->number[eta], 0) && isless(scene->number[eta], INFINITY) &&
                          isgreaterequal(scene->number[eta + 1], 0) && isless(scene->number[eta + 1], INFINITY)))
            return refuse_scene(fault, COR_FAULT_VISCOSITY, eta, 0);
    }
    const struct cor_body body_1 = cor_scene_body(scene, 1), body_2 = cor_scene_body(scene, 2);
    const struct cor_plate plate = {body_2.young_modulus_pa, body_2.poisson_ratio,
                                    cor_scene_of_body(scene, COR_SCENE_DENSITY, 2),
                                    scene->number[COR_SCENE_PLATE_THICKNESS]};
    fault->status = scene->plate ? cor_plate_contact_init(&sphere, &body_1, &plate)
                                 : cor_sphere_contact_init(&sphere, &body_1, &body_2);
    if (fault->status != COR_OK)
        return fault->fault = COR_FAULT_MATERIAL;
    contact->mass_kg = sphere.effective_mass_kg;
    contact->stiffness = sphere.elastic_constant_n_m15;
    contact->radius_m = sphere.effective_radius_m;
    contact->damping = sphere.beta_per_root;
    return COR_FAULT_NONE;
}

/* Returns which input determines the stiffness at a known effective mass: C, A or the duration. Another input must then
 * determine the damping. -1: the stiffness is given, or no input determines it. */
static int source_of_stiffness(const struct cor_scene *scene)
{
    static const int ratios[] = {COR_SCENE_G_STAR, COR_SCENE_RESTITUTION, COR_SCENE_BETA, COR_SCENE_ZETA};
    const int timed = cor_scene_given(scene, COR_SCENE_DURATION);
    int scaled = timed;
    for (size_t i = 0; i < sizeof ratios / sizeof *ratios; i++)
        scaled = scaled || cor_scene_given(scene, ratios[i]);
    if (has_bodies(scene) || cor_scene_given(scene, COR_SCENE_STIFFNESS) || !scaled ||
        !cor_scene_given(scene, COR_SCENE_EFFECTIVE_MASS))
        return -1;
    if (cor_scene_given(scene, COR_SCENE_DAMPING_COEFFICIENT))
        return COR_SCENE_DAMPING_COEFFICIENT;
    if (cor_law_is(&scene->law, 3, 1) && cor_scene_given(scene, COR_SCENE_DISSIPATION_TIME) &&
        !cor_scene_given(scene, COR_SCENE_DISSIPATION_TIME_2))
        return COR_SCENE_DISSIPATION_TIME;
    return timed ? COR_SCENE_DURATION : -1;
}

static int set_scales(struct cor_scene_contact *contact, struct cor_scene_fault *fault, const struct cor_scene *scene)
{
    const int bodies = has_bodies(scene), stiff = cor_scene_given(scene, COR_SCENE_STIFFNESS),
              massive = cor_scene_given(scene, COR_SCENE_EFFECTIVE_MASS),
              timed = cor_scene_given(scene, COR_SCENE_DURATION);
    const struct rule rules[] = {
        {bodies && (stiff || massive), COR_FAULT_TWO_CONTACTS, COR_SCENE_STIFFNESS, COR_SCENE_YOUNG},
        {scene->plate && !bodies, COR_FAULT_PLATE_BODIES, COR_SCENE_YOUNG, COR_SCENE_PLATE_THICKNESS},
        {bodies && !cor_law_is_hertz(&scene->law), COR_FAULT_NOT_HERTZ, COR_SCENE_YOUNG, COR_SCENE_STIFFNESS},
        {!bodies && (massive ? !stiff && source_of_stiffness(scene) < 0 : stiff || timed), COR_FAULT_SPRING,
         massive ? COR_SCENE_STIFFNESS : COR_SCENE_EFFECTIVE_MASS, 0},
        {0}};
    if (refuse_first(fault, rules) != COR_FAULT_NONE)
        return fault->fault;
    if (bodies)
        return set_materials(contact, fault, scene);
    contact->stiffness = scene->number[COR_SCENE_STIFFNESS];
    contact->mass_kg = scene->number[COR_SCENE_EFFECTIVE_MASS];
    return COR_FAULT_NONE;
}

/* Sets the constant force F = m G + 2 pi w R. */
static int set_force(struct cor_scene_contact *contact, struct cor_scene_fault *fault, const struct cor_scene *scene)
{
    const int heavy = cor_scene_given(scene, COR_SCENE_GRAVITY), sticky = cor_scene_given(scene, COR_SCENE_ADHESION),
              jkr = scene->adhesion_model == COR_ADHESION_JKR, cause = heavy ? COR_SCENE_GRAVITY : COR_SCENE_ADHESION;
    const int other_than_jkr = scene->plate || scene->plastic || heavy || !cor_jkr_has_law(&scene->law);
    const struct rule rules[] = {
        {sticky != (scene->adhesion_model != COR_ADHESION_NONE), COR_FAULT_ADHESION, COR_SCENE_ADHESION, 0},
        {jkr && other_than_jkr, COR_FAULT_ADHESION_MODEL, COR_SCENE_ADHESION, heavy ? COR_SCENE_GRAVITY : 0},
        {cor_scene_given(scene, COR_SCENE_DURATION), COR_FAULT_EXCLUDED, COR_SCENE_DURATION, cause},
        {source_of_stiffness(scene) >= 0, COR_FAULT_EXCLUDED, source_of_stiffness(scene), cause},
        {heavy && !scene->wall && !scene->plate, COR_FAULT_GRAVITY, COR_SCENE_GRAVITY, 0},
        {heavy && isnan(contact->mass_kg), COR_FAULT_NO_SCALES, COR_SCENE_GRAVITY, 0},
        {sticky && isnan(contact->radius_m), COR_FAULT_NO_BODIES, COR_SCENE_ADHESION, 0},
        {0}};
    if (!heavy && !sticky && !scene->adhesion_model)
        return COR_FAULT_NONE;
    if (refuse_first(fault, rules) != COR_FAULT_NONE)
        return fault->fault;
    if (heavy)
        contact->force_n += cor_quiet_product(contact->mass_kg, scene->number[COR_SCENE_GRAVITY]);
    if (jkr)
        contact->adhesion_j_m2 = scene->number[COR_SCENE_ADHESION];
    else if (sticky)
        contact->force_n += cor_quiet_product(2 * COR_PI * scene->number[COR_SCENE_ADHESION], contact->radius_m);
    return contact->force_n == 0 || cor_si_in_range(contact->force_n) ? COR_FAULT_NONE
                                                                      : refuse_scene(fault, COR_FAULT_RANGE, cause, 0);
}

/* ---- the damping ---- */

/* The numbers that give the damping, in the order in which a refusal names them */
static const int ways[] = {COR_SCENE_DISSIPATION_TIME,    COR_SCENE_VISCOSITY, COR_SCENE_G_STAR, COR_SCENE_RESTITUTION,
                           COR_SCENE_DAMPING_COEFFICIENT, COR_SCENE_BETA,      COR_SCENE_ZETA,   COR_SCENE_DURATION};
enum { WAYS = sizeof ways / sizeof *ways };

static int is_material(int way)
{
    return way == COR_SCENE_DISSIPATION_TIME || way == COR_SCENE_VISCOSITY;
}

/* Sets *found to the given number in ways[] that is not the source of the stiffness, or to -1 if none is given. */
static int find_way(int *found, struct cor_scene_fault *fault, const struct cor_scene *scene)
{
    *found = -1;
    for (int i = 0; i < WAYS; i++) {
        if ((!cor_scene_given(scene, ways[i]) &&
             !(is_material(ways[i]) && cor_scene_given(scene, ways[i] + COR_SCENE_BODY))) ||
            ways[i] == source_of_stiffness(scene))
            continue;
        if (*found >= 0)
            return refuse_scene(fault, COR_FAULT_TWO_WAYS, *found, ways[i]);
        *found = ways[i];
    }
    return *found < 0 && !scene->plate ? refuse_scene(fault, COR_FAULT_NO_WAY, 0, 0) : COR_FAULT_NONE;
}

/* Checks that `way`, the number that gives the damping, suits the law, and that the numbers it needs are given. */
static int check_way(struct cor_scene_fault *fault, const struct cor_scene *scene,
                     const struct cor_scene_contact *contact, int way)
{
    const int constant = cor_law_is_constant(&scene->law), bodies = has_bodies(scene), material = is_material(way);
    const int needs_at = way == COR_SCENE_RESTITUTION || way == COR_SCENE_BETA;
    const int at = cor_scene_given(scene, COR_SCENE_AT), timed = cor_scene_given(scene, COR_SCENE_DURATION);
    const int scaled = isgreater(contact->mass_kg, 0) && isgreater(contact->stiffness, 0);
    const int second = material && cor_scene_given(scene, way + COR_SCENE_BODY);
    const struct rule rules[] = {
        {scene->plate && way >= 0 && !material, COR_FAULT_PLATE_DAMPING, way, 0},
        {material && !cor_law_is(&scene->law, 3, 1), COR_FAULT_NOT_SPHERE, way, constant ? 0 : COR_SCENE_AT},
        {way == COR_SCENE_G_STAR && constant, COR_FAULT_CONSTANT, way, 0},
        {way == COR_SCENE_ZETA && !constant, COR_FAULT_NOT_CONSTANT, way, 0},
        {way == COR_SCENE_VISCOSITY && !bodies, COR_FAULT_NO_BODIES, way, 0},
        {(way == COR_SCENE_DISSIPATION_TIME || way == COR_SCENE_DAMPING_COEFFICIENT) && !scaled, COR_FAULT_NO_SCALES,
         way, 0},
        {needs_at && !constant && !at, COR_FAULT_NO_SPEED, way, COR_SCENE_AT},
        {timed && scene->law.elastic != scene->law.denominator && !at, COR_FAULT_NO_SPEED, COR_SCENE_DURATION,
         COR_SCENE_AT},
        {at && !needs_at && !timed, COR_FAULT_SPEED_ALONE, COR_SCENE_AT, 0},
        {cor_scene_given(scene, COR_SCENE_VISCOSITY_2) && !cor_scene_given(scene, COR_SCENE_VISCOSITY),
         COR_FAULT_FIRST_MISSING, COR_SCENE_VISCOSITY_2, COR_SCENE_VISCOSITY},
        {cor_scene_given(scene, COR_SCENE_DISSIPATION_TIME_2) && !cor_scene_given(scene, COR_SCENE_DISSIPATION_TIME),
         COR_FAULT_FIRST_MISSING, COR_SCENE_DISSIPATION_TIME_2, COR_SCENE_DISSIPATION_TIME},
        {second && (!bodies || scene->plate), COR_FAULT_NO_SECOND_BODY, way + COR_SCENE_BODY, 0},
        {0}};
    return refuse_first(fault, rules);
}

/* ---- two numbers of a contact give its stiffness and its damping ---- */

/* Returns (K/m)^(1/(a+1)) from the damping and `value`, which is C or A, by beta g^-q = (C/m) (m/K)^((b+1)/(a+1)). */
static double rate_of_damping(const struct cor_scene_contact *contact, int source, double value)
{
    const double beta = cor_scene_beta(contact, 1), a = cor_elastic(&contact->law), b = cor_damping(&contact->law);
    return source == COR_SCENE_DISSIPATION_TIME
               ? cor_quiet_power(cor_quiet_quotient(beta, 1.5 * value), 1 / (a - b))
               : cor_quiet_power(cor_quiet_quotient(value, cor_quiet_product(beta, contact->mass_kg)), 1 / (b + 1));
}

/* Sets *rate to the (K/m)^(1/(a+1)) with which this contact lasts for duration_s. With m = K = 1 the contact lasts
 * `rate` times as long. */
static int rate_of_duration(double *rate, const struct cor_scene_contact *contact, double duration_s, double speed_m_s,
                            int end)
{
    struct cor_scene_contact unit = *contact;
    struct cor_scene_impact impact;
    if (end > COR_END_ZERO_FORCE)
        return COR_FAULT_NO_STIFFNESS;
    unit.mass_kg = unit.stiffness = 1;
    impact.duration_s[end] = cor_scene_elastic_duration_s(&unit, speed_m_s);
    const int status = isgreater(contact->damping, 0) ? cor_scene_impact(&impact, &unit, speed_m_s) : COR_FAULT_NONE;
    *rate = cor_quiet_quotient(impact.duration_s[end], duration_s);
    return status;
}

static int set_stiffness(struct cor_scene_contact *contact, double rate)
{
    contact->stiffness = cor_quiet_product(contact->mass_kg, cor_quiet_power(rate, cor_elastic(&contact->law) + 1));
    return cor_si_in_range(contact->stiffness) ? COR_FAULT_NONE : COR_FAULT_NO_STIFFNESS;
}

/* Sets the damping with which a contact of given C, A or (source = -1) K lasts for duration_s, by the Illinois method
 * on the logarithms. Damping prolongs a contact of given C, and a contact of given K that ends at zero overlap. It
 * shortens a contact of given K or A that ends at zero force. Two contacts of given A that end at zero overlap can have
 * the same duration. */
static int set_damping_of_duration(struct cor_scene_contact *contact, int source, double value, double duration_s,
                                   double speed_m_s, int end)
{
    enum { MOST_STEPS = 400 };
    const int falls = source == COR_SCENE_DISSIPATION_TIME ||
                      (source < 0 && end == COR_END_ZERO_FORCE && cor_scene_ends_differ(contact));
    const double given =
        cor_quiet_power(cor_quiet_quotient(contact->stiffness, contact->mass_kg), 1 / (cor_elastic(&contact->law) + 1));
    struct cor_bracket bracket = {0, 0, 0, 0, 0};
    double needed, x = -2;
    if (source == COR_SCENE_DISSIPATION_TIME && end == COR_END_ZERO_OVERLAP)
        return COR_FAULT_TWO_DURATIONS;
    contact->damping = 0;
    if (source < 0) {
        rate_of_duration(&needed, contact, duration_s, speed_m_s, end);
        if (!(falls ? needed > given : needed < given))
            return needed == given ? COR_FAULT_NONE : COR_FAULT_NO_DURATION;
    }
    for (int k = 0; k < MOST_STEPS; k++) {
        contact->damping = exp(x);
        const int status = rate_of_duration(&needed, contact, duration_s, speed_m_s, end);
        if (status != COR_FAULT_NONE)
            return status;
        const double rate = source < 0 ? given : rate_of_damping(contact, source, value),
                     ratio = cor_quiet_quotient(rate, needed), /* 0: the bodies never part */
            rest = (falls ? -1 : 1) * log(fmax(1e-300, fmin(1e300, ratio)));
        if (isnan(ratio))
            return COR_FAULT_RANGE;
        if (!(fabs(rest) > 1e-15) ||
            (cor_is_bracketed(&bracket) && bracket.high - bracket.low < 1e-15 * fmax(1, fabs(x))))
            return source < 0 ? COR_FAULT_NONE : set_stiffness(contact, rate);
        x = cor_next_place(&bracket, x, rest, rest > 0 ? x + 1 : x - 1);
    }
    return COR_FAULT_NO_DURATION;
}

/* ---- yield, and a liquid ---- */

/* Sets v_y, if a yield stress or the restitution of elastic-plastic spheres is given. */
static int set_yield(struct cor_scene_contact *contact, struct cor_scene_fault *fault, const struct cor_scene *scene)
{
    const double *const number = scene->number;
    const int stress = cor_scene_given(scene, COR_SCENE_YIELD_STRESS), at = cor_scene_given(scene, COR_SCENE_AT);
    int way;
    if (stress && isnan(contact->radius_m))
        return refuse_scene(fault, COR_FAULT_NO_BODIES, COR_SCENE_YIELD_STRESS, 0);
    if (stress)
        contact->yield_speed_m_s = cor_scene_yield_speed(contact, number[COR_SCENE_YIELD_STRESS]);
    if (!scene->plastic)
        return COR_FAULT_NONE;
    if (find_way(&way, fault, scene) == COR_FAULT_TWO_WAYS)
        return fault->fault;
    const struct rule rules[] = {
        {way >= 0 && way != COR_SCENE_RESTITUTION, COR_FAULT_YIELD_DAMPING, way, 0},
        {cor_scene_given(scene, COR_SCENE_DURATION), COR_FAULT_YIELD_DAMPING, COR_SCENE_DURATION, 0},
        {contact->force_n > 0 || contact->adhesion_j_m2 > 0, COR_FAULT_PRESSED_LAW, COR_SCENE_YIELD_STRESS, 0},
        {way >= 0 && stress, COR_FAULT_EXCLUDED, COR_SCENE_YIELD_STRESS, way},
        {way < 0 && !stress, COR_FAULT_NO_YIELD, COR_SCENE_YIELD_STRESS, COR_SCENE_RESTITUTION},
        {at && way < 0, COR_FAULT_SPEED_ALONE, COR_SCENE_AT, COR_SCENE_AT},
        {!at && way >= 0, COR_FAULT_NO_SPEED, way, COR_SCENE_AT},
        {0}};
    if (refuse_first(fault, rules) != COR_FAULT_NONE)
        return fault->fault;
    if (at)
        contact->yield_speed_m_s =
            cor_quiet_quotient(number[COR_SCENE_AT], cor_elastic_plastic_speed_ratio(number[way]));
    refuse_scene(fault, COR_FAULT_NONE, 0, 0);
    contact->plastic = 1;
    contact->damping = 0;
    return cor_si_in_range(contact->yield_speed_m_s) ? COR_FAULT_NONE : refuse_scene(fault, COR_FAULT_RANGE, 0, 0);
}

static int set_liquid(struct cor_scene_contact *contact, struct cor_scene_fault *fault, const struct cor_scene *scene)
{
    const double outer = scene->number[COR_SCENE_GAP_OUTER], inner = scene->number[COR_SCENE_GAP_INNER];
    int given = 0, missing = 0;
    for (int number = COR_SCENE_LIQUID_VISCOSITY; number <= COR_SCENE_GAP_INNER; number++)
        *(cor_scene_given(scene, number) ? &given : &missing) = number;
    const struct rule rules[] = {
        {missing, COR_FAULT_LIQUID, missing, 0},
        {isnan(contact->radius_m), COR_FAULT_NO_BODIES, COR_SCENE_LIQUID_VISCOSITY, 0},
        {contact->force_n > 0 || contact->adhesion_j_m2 > 0, COR_FAULT_PRESSED_LAW, COR_SCENE_LIQUID_VISCOSITY, 0},
        {!isgreater(outer, inner), COR_FAULT_GAPS, COR_SCENE_GAP_OUTER, COR_SCENE_GAP_INNER},
        {0}};
    if (!given)
        return COR_FAULT_NONE;
    if (refuse_first(fault, rules) != COR_FAULT_NONE)
        return fault->fault;
    contact->liquid_speed_m_s =
        cor_scene_liquid_speed(contact, scene->number[COR_SCENE_LIQUID_VISCOSITY], outer, inner);
    return isless(contact->liquid_speed_m_s, INFINITY) ? COR_FAULT_NONE : refuse_scene(fault, COR_FAULT_RANGE, 0, 0);
}

/* ---- a damping from measurements ---- */

/* Sets the damping. Makes one contact for each possible end if a restitution or a duration is given without its
 * end of contact. */
static int set_damping(struct cor_scene_contact contacts[COR_SCENE_ENDS], int *count, struct cor_scene_fault *fault,
                       const struct cor_scene *scene)
{
    int way, status = find_way(&way, fault, scene);
    if (status == COR_FAULT_NONE)
        status = check_way(fault, scene, &contacts[0], way);
    if (status != COR_FAULT_NONE || way < 0 || (is_material(way) && has_bodies(scene)))
        return status; /* already set by set_materials */
    /* For q = 0, a restitution given without a speed was measured without gravity and adhesion. */
    const double speed = cor_scene_given(scene, COR_SCENE_AT) ? scene->number[COR_SCENE_AT]
                         : way == COR_SCENE_RESTITUTION && (contacts[0].force_n > 0 || contacts[0].adhesion_j_m2 > 0)
                             ? (double)NAN
                             : 1;
    const int any = scene->end == COR_BOTH_ENDS, timed = cor_scene_given(scene, COR_SCENE_DURATION),
              source = source_of_stiffness(scene);
    const double value = source < 0 ? (double)NAN : scene->number[source],
                 duration_s = scene->number[COR_SCENE_DURATION];
    *count = (way == COR_SCENE_RESTITUTION || timed) && any && cor_scene_ends_differ(&contacts[0]) ? COR_SCENE_ENDS : 1;
    contacts[1] = contacts[0];
    for (int i = 0; i < *count && status == COR_FAULT_NONE; i++) {
        const int end = any ? i : scene->end;
        double rate = NAN;
        if (way == COR_SCENE_DURATION) {
            status = set_damping_of_duration(&contacts[i], source, value, duration_s, speed, end);
            continue;
        }
        status = cor_scene_set_damping(&contacts[i], way, scene->number[way], speed, end);
        if (status != COR_FAULT_NONE || source < 0)
            continue;
        if (source == COR_SCENE_DURATION)
            status = rate_of_duration(&rate, &contacts[i], duration_s, speed, end);
        else
            rate = rate_of_damping(&contacts[i], source, value);
        status = status == COR_FAULT_NONE ? set_stiffness(&contacts[i], rate) : status;
    }
    if (status > 0)
        refuse_scene(fault, status, way, COR_SCENE_AT);
    return status;
}

/* True if the absolute value of a finite nonzero number is out of range */
static int is_beyond(const struct cor_scene *scene, int number)
{
    const double size = fabs(scene->number[number]);
    return *cor_scene_options[number].unit && cor_inline_is_finite(size) && size != 0 && !cor_si_in_range(size);
}

int cor_scene_contacts(struct cor_scene_contact contacts[COR_SCENE_ENDS], int *count, struct cor_scene_fault *fault,
                       const struct cor_scene *scene)
{
    const struct cor_scene_contact none = {.law = scene->law,
                                           .plate = scene->plate,
                                           .mass_kg = NAN,
                                           .stiffness = NAN,
                                           .radius_m = NAN,
                                           .damping = NAN,
                                           .solver = scene->solver};
    static int (*const set[])(struct cor_scene_contact *, struct cor_scene_fault *,
                              const struct cor_scene *) = {set_scales, set_force, set_yield, set_liquid};
    int contacts_set = 1, status = COR_FAULT_NONE;
    refuse_scene(fault, COR_FAULT_NONE, 0, 0);
    contacts[0] = contacts[1] = none;
    for (int number = 0; number < COR_SCENE_NUMBERS && status == COR_FAULT_NONE; number++)
        if (is_beyond(scene, number))
            status = refuse_scene(fault, COR_FAULT_RANGE, number, 0);
    if (!cor_law_is_sound(&scene->law))
        status = refuse_scene(fault, COR_FAULT_RANGE, 0, 0);
    if (status == COR_FAULT_NONE && scene->plate && scene->end == COR_END_ZERO_FORCE)
        status = refuse_scene(fault, COR_FAULT_PLATE_END, 0, 0);
    for (size_t i = 0; i < sizeof set / sizeof *set && status == COR_FAULT_NONE; i++)
        status = set[i](&contacts[0], fault, scene);
    if (status == COR_FAULT_NONE && !scene->plastic)
        status = set_damping(contacts, &contacts_set, fault, scene);
    for (int i = 0; i < contacts_set && status == COR_FAULT_NONE; i++)
        if (isnan(contacts[i].damping) || !cor_contact_is_sound(&contacts[i]))
            status = refuse_scene(fault, COR_FAULT_RANGE, 0, 0);
    *count = status == COR_FAULT_NONE ? contacts_set : 0;
    return status;
}

/* ---- a linear spring in place of Hertz's ---- */

int cor_scene_equivalent(struct cor_scene *spring, struct cor_scene_contact *hertz, struct cor_scene_fault *fault,
                         const struct cor_scene *scene, int equivalence)
{
    static const int others[] = {COR_SCENE_PLATE_THICKNESS, COR_SCENE_ADHESION, COR_SCENE_YIELD_STRESS,
                                 COR_SCENE_LIQUID_VISCOSITY, COR_SCENE_DURATION};
    const double speed = scene->number[COR_SCENE_AT];
    struct cor_scene sphere = *scene;
    struct cor_scene_contact contacts[COR_SCENE_ENDS];
    int way, count, refused = !has_bodies(scene) || !cor_law_is(&scene->law, 2, 0) || isnan(speed);
    *spring = *scene;
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        refused = refused || cor_scene_given(scene, others[i]);
    if (find_way(&way, fault, scene) != COR_FAULT_NONE)
        return fault->fault;
    const int of_spheres = is_material(way) || way == COR_SCENE_G_STAR;
    if (refused || (of_spheres && scene->end == COR_BOTH_ENDS))
        return refuse_scene(fault, COR_FAULT_EQUIVALENT, 0, 0);
    sphere.law = cor_law_exponents[COR_LAW_VISCOELASTIC];
    sphere.number[COR_SCENE_AT] = NAN;
    if (!of_spheres) {
        sphere.number[way] = NAN;
        sphere.number[COR_SCENE_DISSIPATION_TIME] = 0;
    }
    int status = cor_scene_contacts(contacts, &count, fault, &sphere);
    if (status != COR_FAULT_NONE)
        return status;
    *hertz = contacts[0];
    for (int number = 0; number < COR_SCENE_BETA; number++)
        spring->number[number] = NAN;
    if (of_spheres)
        status = cor_scene_eps(&spring->number[COR_SCENE_RESTITUTION], hertz, speed, scene->end);
    else if (way == COR_SCENE_ZETA || way == COR_SCENE_DAMPING_COEFFICIENT)
        spring->number[COR_SCENE_AT] = NAN;
    const double rate = equivalence == COR_EQUIVALENT_DURATION
                            ? cor_quiet_quotient(COR_PI, cor_scene_elastic_duration_s(hertz, speed))
                            : cor_quiet_quotient(speed, cor_scene_elastic_overlap(hertz, speed));
    spring->number[COR_SCENE_EFFECTIVE_MASS] = hertz->mass_kg;
    spring->number[COR_SCENE_STIFFNESS] = cor_quiet_product(cor_quiet_product(hertz->mass_kg, rate), rate);
    hertz->damping = 0;
    return status == COR_FAULT_NONE ? status : refuse_scene(fault, status, COR_SCENE_AT, 0);
}
