/* SPDX-License-Identifier: MIT */
/* A contact in SI units: its damping, and its impacts by the functions of libcor or by the caller's solver */
#include "cor/scene.h"

#include <math.h>

#include "cor/law.h"
#include "cor/sphere.h"
#include "runtime/law/functions.h"
#include "runtime/scene/exponents.h"
#include "runtime/scene/motion.h"

/* True if no sum or product of two exponents overflows an integer */
int cor_law_is_sound(const struct cor_exponents *law)
{
    enum { MOST = 1 << 20 };
    return law->denominator > 0 && law->denominator < MOST && law->elastic > 0 && law->elastic < MOST &&
           law->damping >= 0 && law->damping < MOST;
}

int cor_contact_is_sound(const struct cor_scene_contact *contact)
{
    const double known[] = {contact->mass_kg, contact->stiffness, contact->radius_m},
                 none[] = {contact->force_n, contact->adhesion_j_m2, contact->yield_speed_m_s,
                           contact->liquid_speed_m_s};
    int sound = cor_law_is_sound(&contact->law) && !isinf(contact->damping) && !isless(contact->damping, 0);
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        sound = sound && (isnan(known[i]) || known[i] == 0 || cor_si_in_range(known[i]));
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        sound = sound && (none[i] == 0 || cor_si_in_range(none[i]));
    return sound && !(contact->force_n + contact->adhesion_j_m2 > 0 && isnan(contact->mass_kg + contact->stiffness)) &&
           !(contact->adhesion_j_m2 > 0 && isnan(contact->radius_m));
}

double cor_scene_speed_exponent(const struct cor_scene_contact *contact)
{
    const struct cor_exponents *const law = &contact->law;
    return (double)(2 * law->damping - law->elastic + law->denominator) / (double)(law->elastic + law->denominator);
}

#define LAW(law, array) COR_LAW_##law,

/* Returns the law that has these exponents and functions of its own, or COR_LAWS if none has. */
static enum cor_law law_named(const struct cor_exponents *law)
{
    static const enum cor_law with_functions[] = {COR_LAWS_WITH_FUNCTIONS(LAW)};
    for (size_t i = 0; i < sizeof with_functions / sizeof *with_functions; i++)
        if (cor_law_is_same(law, &cor_law_exponents[with_functions[i]]))
            return with_functions[i];
    return COR_LAWS;
}

/* Returns a law whose functions give eps, or COR_LAWS. For q = 0, eps is the same function of zeta for all
 * exponents. */
static enum cor_law law_of_eps(const struct cor_exponents *law)
{
    return cor_law_is_constant(law)        ? COR_LAW_LINEAR
           : cor_law_is_hunt_crossley(law) ? COR_LAW_HUNT_CROSSLEY
                                           : law_named(law);
}

int cor_scene_has_end(const struct cor_scene_contact *contact, int end)
{
    if (contact->plate || end != COR_END_APPROACH_ONLY)
        return end == COR_END_ZERO_OVERLAP || (!contact->plate && end == COR_END_ZERO_FORCE);
    return !contact->plastic && contact->force_n + contact->adhesion_j_m2 + contact->liquid_speed_m_s == 0 &&
           cor_law_function(law_of_eps(&contact->law), end, COR_EPS);
}

int cor_scene_ends_differ(const struct cor_scene_contact *contact)
{
    return !contact->plate && !contact->plastic &&
           (isgreater(contact->adhesion_j_m2, 0) || contact->law.elastic > contact->law.damping);
}

const char *cor_scene_end_name(const struct cor_scene_contact *contact, int end)
{
    static const char *const names[][COR_SCENE_ENDS] = {
        {"zero_overlap", "zero_force"}, {"zero_overlap", "surface"}, {"tail", "largest_pull"}};
    return names[isgreater(contact->adhesion_j_m2, 0) ? 2 : isgreater(contact->force_n, 0)][end == COR_END_ZERO_FORCE];
}

/* ---- the damping ---- */

/* Returns (m/K)^(1/(a+1)), the unit of time at the speed 1 m/s. */
static double time_factor(const struct cor_scene_contact *contact)
{
    return cor_quiet_power(cor_quiet_quotient(contact->mass_kg, contact->stiffness),
                           1 / (cor_elastic(&contact->law) + 1));
}

/* Returns beta/zeta if q = 0, otherwise 1: contact->damping is zeta if q = 0, otherwise beta at 1 m/s. */
static double beta_per_damping(const struct cor_scene_contact *contact)
{
    return cor_law_is_constant(&contact->law) ? sqrt(2 * (cor_elastic(&contact->law) + 1)) : 1;
}

/* Returns beta g^-q for C = 1. */
static double beta_per_coefficient(const struct cor_scene_contact *contact)
{
    return cor_quiet_quotient(cor_quiet_power(time_factor(contact), cor_damping(&contact->law) + 1), contact->mass_kg);
}

/* Returns |C_1| of eps = 1 + C_1 beta + ... (docs/theory.md, 9): (2/(a+1)) ((a+1)/2)^s B(s, 3/2), s = (b+1)/(a+1). */
static double first_coefficient(const struct cor_exponents *law)
{
    const double a1 = cor_elastic(law) + 1, s = (cor_damping(law) + 1) / a1;
    if (s > 168) /* tgamma would overflow */
        return NAN;
    return 2 / a1 * cor_quiet_power(a1 / 2, s) * tgamma(s) * tgamma(1.5) / tgamma(s + 1.5);
}

double cor_scene_beta(const struct cor_scene_contact *contact, double speed_m_s)
{
    if (!cor_contact_is_sound(contact) || !cor_si_in_range(speed_m_s))
        return NAN;
    const double beta = cor_quiet_product(contact->damping, beta_per_damping(contact));
    return cor_law_is_constant(&contact->law)
               ? beta
               : cor_quiet_product(beta, cor_quiet_power(speed_m_s, cor_scene_speed_exponent(contact)));
}

double cor_scene_damping(const struct cor_scene_contact *contact, int number)
{
    const int constant = cor_law_is_constant(&contact->law);
    if (contact->plastic || !cor_contact_is_sound(contact))
        return NAN;
    const double coefficient = cor_quiet_quotient(cor_quiet_product(contact->damping, beta_per_damping(contact)),
                                                  beta_per_coefficient(contact));
    switch (number) {
    case COR_SCENE_DAMPING_COEFFICIENT:
        return coefficient;
    case COR_SCENE_DISSIPATION_TIME:
        return cor_law_is(&contact->law, 3, 1) ? cor_quiet_quotient(coefficient, 1.5 * contact->stiffness) : NAN;
    case COR_SCENE_ZETA:
        return constant ? contact->damping : NAN;
    case COR_SCENE_BETA:
        return constant ? NAN : contact->damping;
    case COR_SCENE_G_STAR:
        return constant ? NAN
                        : cor_quiet_power(cor_quiet_product(contact->damping, first_coefficient(&contact->law)),
                                          -1 / cor_scene_speed_exponent(contact));
    default:
        return NAN;
    }
}

const struct cor_scene_quantity cor_scene_quantities[COR_SCENE_QUANTITIES] = {
    {"effective_mass", COR_SCENE_EFFECTIVE_MASS, "kg"},
    {"effective_radius", COR_SCENE_RADIUS, "m"},
    {"stiffness", COR_SCENE_STIFFNESS, "N/m^a"},
    {"dissipation_time", COR_SCENE_DISSIPATION_TIME, "s"},
    {"damping_coefficient", COR_SCENE_DAMPING_COEFFICIENT, "N s/m^(b+1)"},
    {"g_star", COR_SCENE_G_STAR, "m/s"},
    {"zeta", COR_SCENE_ZETA, "1"},
    {"beta_factor", COR_SCENE_BETA, "(m/s)^(-q)"},
    {"q", COR_SCENE_NUMBERS, "1"},
    {"eps_zero_overlap", COR_SCENE_EPS_ZERO_OVERLAP, "1"},
    {"eps_zero_force", COR_SCENE_EPS_ZERO_FORCE, "1"},
    {"pressing_force", COR_SCENE_PRESSING_FORCE, "N"},
    {"sticking_speed_zero_overlap", COR_SCENE_STICKING_ZERO_OVERLAP, "m/s"},
    {"sticking_speed_zero_force", COR_SCENE_STICKING_ZERO_FORCE, "m/s"},
    {"yield_speed", COR_SCENE_YIELD_STRESS, "m/s"},
    {"liquid_speed", COR_SCENE_LIQUID_VISCOSITY, "m/s"}};

/* Returns eps if it is the same at every speed, otherwise NaN. */
static double only_eps(const struct cor_scene_contact *contact, int end)
{
    double eps = NAN;
    const int alone =
        !contact->plastic && !(contact->liquid_speed_m_s > 0 || contact->force_n > 0) && !(contact->adhesion_j_m2 > 0);
    if (cor_law_is_constant(&contact->law) && alone)
        cor_scene_eps(&eps, contact, 1, end);
    return eps;
}

double cor_scene_quantity(const struct cor_scene_contact *contact, int number)
{
    const double force = contact->force_n, liquid = contact->liquid_speed_m_s, yield = contact->yield_speed_m_s;
    if (!cor_contact_is_sound(contact))
        return NAN;
    const struct {
        int number;
        double value;
    } known[] = {{COR_SCENE_EFFECTIVE_MASS, contact->mass_kg},
                 {COR_SCENE_RADIUS, contact->radius_m},
                 {COR_SCENE_STIFFNESS, contact->stiffness},
                 {COR_SCENE_NUMBERS, contact->plastic ? NAN : cor_scene_speed_exponent(contact)},
                 {COR_SCENE_PRESSING_FORCE, force > 0 ? force : NAN},
                 {COR_SCENE_YIELD_STRESS, yield > 0 ? yield : NAN},
                 {COR_SCENE_LIQUID_VISCOSITY, liquid > 0 ? liquid : NAN}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (known[i].number == number)
            return known[i].value;
    if (number == COR_SCENE_EPS_ZERO_OVERLAP || number == COR_SCENE_EPS_ZERO_FORCE)
        return only_eps(contact, number - COR_SCENE_EPS_ZERO_OVERLAP);
    const int end = number - COR_SCENE_STICKING_ZERO_OVERLAP;
    if (end != COR_END_ZERO_OVERLAP && end != COR_END_ZERO_FORCE)
        return cor_scene_damping(contact, number);
    return force > 0 || liquid > 0 || contact->adhesion_j_m2 > 0 ? cor_scene_sticking_speed(contact, end) : NAN;
}

/* ---- collisions ---- */

/* law: the law of libcor's table that gives eps, from zeta if q = 0, otherwise from beta; COR_LAWS if no law does.
 * times: source of durations and overlap (the table, functions of the elastic exponent, or the solver). */
struct functions {
    enum cor_law law;
    enum { OF_TABLE, OF_EXPONENT, OF_SOLVER } times;
};

static double value_of(const struct functions *f, int end, enum cor_quantity quantity, double x)
{
    return cor_law_value(f->law, (enum cor_end)end, quantity, x);
}

static struct functions functions_of(const struct cor_exponents *law)
{
    const enum cor_law named = law_named(law), of_eps = law_of_eps(law);
    if (of_eps == COR_LAW_HUNT_CROSSLEY)
        return (struct functions){of_eps, OF_EXPONENT};
    return named != COR_LAWS && cor_law_function(named, COR_END_ZERO_OVERLAP, COR_DURATION)
               ? (struct functions){named, OF_TABLE}
               : (struct functions){of_eps, OF_SOLVER};
}

int cor_scene_needs_solver(const struct cor_scene_contact *contact)
{
    return !(contact->force_n > 0) && !(contact->adhesion_j_m2 > 0) && functions_of(&contact->law).times == OF_SOLVER;
}

static double parameter_of(const struct cor_scene_contact *contact, double speed_m_s)
{
    return cor_law_is_constant(&contact->law) ? contact->damping : cor_scene_beta(contact, speed_m_s);
}

static int solve_scaled(struct cor_scaled_impact *impact, const struct cor_scene_contact *contact, double beta, int end)
{
    if (!contact->solver)
        return COR_FAULT_SOLVER;
    return cor_inline_is_finite(beta) ? contact->solver(impact, &contact->law, beta, end) : COR_FAULT_RANGE;
}

static int scaled_impact(struct cor_full_impact *impact, const struct cor_scene_contact *contact, double parameter)
{
    const struct functions f = functions_of(&contact->law);
    const double a = cor_elastic(&contact->law);
    if (f.times == OF_SOLVER) {
        struct cor_scaled_impact solved;
        const double beta = cor_quiet_product(parameter, beta_per_damping(contact));
        const int status = solve_scaled(&solved, contact, beta, COR_BOTH_ENDS);
        if (status != COR_FAULT_NONE)
            return status;
        *impact = (struct cor_full_impact){
            {solved.eps[0], solved.eps[1]}, {solved.duration[0], solved.duration[1]}, solved.max_overlap, NAN};
        if (f.law == COR_LAWS)
            return status;
    }
    for (int end = 0; end < COR_SCENE_ENDS; end++) {
        impact->eps[end] = value_of(&f, end, COR_EPS, parameter);
        if (f.times == OF_TABLE)
            impact->duration[end] = value_of(&f, end, COR_DURATION, parameter);
        else if (f.times == OF_EXPONENT)
            impact->duration[end] = cor_hunt_crossley_duration(parameter, a);
    }
    if (f.times == OF_TABLE)
        impact->max_overlap = value_of(&f, COR_END_ZERO_OVERLAP, COR_MAX_OVERLAP, parameter);
    else if (f.times == OF_EXPONENT)
        impact->max_overlap = cor_hunt_crossley_max_overlap(parameter, a);
    return COR_FAULT_NONE;
}

/* Computes eps for a damping parameter, even at an end that the contact does not have. */
static int eps_of(double *eps, const struct cor_scene_contact *contact, double parameter, int end)
{
    const struct functions f = {law_of_eps(&contact->law), OF_SOLVER};
    if (f.law != COR_LAWS) {
        *eps = value_of(&f, end, COR_EPS, parameter);
        return COR_FAULT_NONE;
    }
    const int at = cor_scene_ends_differ(contact) ? end : COR_END_ZERO_OVERLAP;
    struct cor_scaled_impact impact = {{1, 1}, {0, 0}, 0};
    const int status = isgreater(parameter, 0) ? solve_scaled(&impact, contact, parameter, at) : COR_FAULT_NONE;
    *eps = status == COR_FAULT_NONE ? impact.eps[at] : (double)NAN;
    return status;
}

/* The units of a collision in SI units */
struct units {
    double length_m, time_s, force_n;
};

/* Returns the units in which mass, stiffness and impact speed are 1. */
static struct units units_of_speed(const struct cor_scene_contact *contact, double speed_m_s)
{
    const double a = cor_elastic(&contact->law),
                 time = cor_quiet_product(time_factor(contact), cor_quiet_power(speed_m_s, (1 - a) / (1 + a)));
    return (struct units){cor_quiet_product(speed_m_s, time), time,
                          cor_quiet_quotient(cor_quiet_product(contact->mass_kg, speed_m_s), time)};
}

/* Returns the units in which mass, stiffness and constant force are 1. Also sets the damping in these units. */
static struct units units_of_force(double *damping, const struct cor_scene_contact *contact)
{
    const double a = cor_elastic(&contact->law), b = cor_damping(&contact->law), force = contact->force_n;
    const double length = cor_quiet_power(cor_quiet_quotient(force, contact->stiffness), 1 / a),
                 time = sqrt(cor_quiet_product(contact->mass_kg, cor_quiet_quotient(length, force))),
                 coefficient = cor_scene_damping(contact, COR_SCENE_DAMPING_COEFFICIENT);
    *damping = cor_quiet_quotient(cor_quiet_product(coefficient, cor_quiet_power(length, b + 1)),
                                  cor_quiet_product(time, force));
    return (struct units){length, time, force};
}

/* True if the spheres yield at this speed */
static int does_yield(const struct cor_scene_contact *contact, double speed_m_s)
{
    return contact->plastic && speed_m_s > contact->yield_speed_m_s;
}

/* True if an impact involves yield, adhesion or a constant force in addition to its law */
static int is_full(const struct cor_scene_contact *contact, double speed_m_s)
{
    return does_yield(contact, speed_m_s) || contact->adhesion_j_m2 > 0 || contact->force_n > 0;
}

/* Computes the collision of a dry contact in SI units; unknown results are NaN. Sets `force_max` only for a plate or if
 * is_full is true. */
static int dry_impact(struct cor_full_impact *impact, const struct cor_scene_contact *contact, double speed_m_s)
{
    static const struct cor_full_impact none = {{NAN, NAN}, {NAN, NAN}, NAN, NAN};
    int status = COR_FAULT_NONE;
    *impact = none;
    if (!cor_contact_is_sound(contact) || !cor_si_in_range(speed_m_s))
        return COR_FAULT_RANGE;
    struct units unit = units_of_speed(contact, speed_m_s);
    if (does_yield(contact, speed_m_s)) {
        cor_plastic_impact(impact, contact, speed_m_s);
        return status;
    }
    if (contact->adhesion_j_m2 > 0)
        status = cor_jkr_impact(impact, contact, cor_scene_damping(contact, COR_SCENE_DAMPING_COEFFICIENT), speed_m_s);
    else if (contact->force_n > 0) {
        double damping;
        unit = units_of_force(&damping, contact);
        status = cor_pressed_solve(impact, &contact->law, damping,
                                   cor_quiet_product(speed_m_s, cor_quiet_quotient(unit.time_s, unit.length_m)));
    } else
        status = scaled_impact(impact, contact, parameter_of(contact, speed_m_s));
    if (status != COR_FAULT_NONE)
        *impact = none;
    if (status != COR_FAULT_NONE || contact->adhesion_j_m2 > 0)
        return status;
    if (contact->plate) /* the damping term describes the motion of the plate; the force is only K x^a */
        impact->force_max = cor_quiet_power(impact->max_overlap, cor_elastic(&contact->law));
    impact->force_max = cor_quiet_product(impact->force_max, unit.force_n);
    impact->max_overlap = cor_quiet_product(impact->max_overlap, unit.length_m);
    for (int end = 0; end < COR_SCENE_ENDS; end++)
        impact->duration[end] = cor_quiet_product(impact->duration[end], unit.time_s);
    return status;
}

/* Sets the speed that remains after a liquid film. Returns 0 if no speed remains. */
static int does_touch(double *at, const struct cor_scene_contact *contact, double speed_m_s)
{
    const double s = contact->liquid_speed_m_s;
    *at = s > 0 ? speed_m_s - s : speed_m_s;
    return !(s > 0) || *at > 0;
}

double cor_scene_sticking_speed(const struct cor_scene_contact *contact, int end)
{
    if (!cor_scene_has_end(contact, end) || !cor_contact_is_sound(contact))
        return NAN;
    if (contact->liquid_speed_m_s > 0)
        return cor_wet_sticking_speed(contact, end);
    if (contact->adhesion_j_m2 > 0)
        return cor_jkr_sticking_speed(contact, cor_scene_damping(contact, COR_SCENE_DAMPING_COEFFICIENT), end);
    if (!(contact->force_n > 0))
        return 0;
    double damping;
    const struct units unit = units_of_force(&damping, contact);
    return cor_quiet_product(cor_quiet_quotient(unit.length_m, unit.time_s),
                             cor_pressed_sticking_speed(&contact->law, damping, end));
}

int cor_scene_eps(double *eps, const struct cor_scene_contact *contact, double speed_m_s, int end)
{
    struct cor_full_impact impact;
    double at;
    int status = COR_FAULT_NONE;
    *eps = NAN;
    if (!cor_contact_is_sound(contact) || !cor_si_in_range(speed_m_s))
        return COR_FAULT_RANGE;
    if (!cor_scene_has_end(contact, end))
        return status;
    if (!does_touch(&at, contact, speed_m_s)) {
        *eps = 0;
    } else if (!is_full(contact, at)) {
        status = eps_of(eps, contact, parameter_of(contact, at), end);
    } else if (does_yield(contact, at)) { /* skips the duration, which takes longer to compute */
        *eps = cor_elastic_plastic_eps(cor_quiet_quotient(at, contact->yield_speed_m_s));
    } else {
        status = dry_impact(&impact, contact, at);
        *eps = impact.eps[end];
    }
    if (contact->liquid_speed_m_s > 0)
        *eps = cor_wet_eps(*eps, speed_m_s, contact->liquid_speed_m_s);
    return status;
}

int cor_scene_impact(struct cor_scene_impact *impact, const struct cor_scene_contact *contact, double speed_m_s)
{
    struct cor_full_impact full = {{0, 0}, {NAN, NAN}, 0, 0}; /* nothing touches */
    double at;
    const int in_range = cor_contact_is_sound(contact) && cor_si_in_range(speed_m_s);
    int status = COR_FAULT_NONE;
    impact->beta = NAN;
    if (!in_range || does_touch(&at, contact, speed_m_s)) {
        const double speed = in_range ? at : (double)NAN;
        status = dry_impact(&full, contact, speed);
        impact->beta = in_range && does_yield(contact, at) ? 0 : cor_scene_beta(contact, speed);
    }
    for (int end = 0; end < COR_SCENE_ENDS; end++) {
        const int has = cor_scene_has_end(contact, end);
        const double s = in_range ? contact->liquid_speed_m_s : 0;
        impact->eps[end] = !has ? (double)NAN : s > 0 ? cor_wet_eps(full.eps[end], speed_m_s, s) : full.eps[end];
        impact->duration_s[end] = has ? full.duration[end] : (double)NAN;
    }
    impact->max_overlap_m = full.max_overlap;
    return status;
}

double cor_scene_force_max_n(const struct cor_scene_contact *contact, double speed_m_s)
{
    struct cor_full_impact impact;
    double at;
    if (!cor_contact_is_sound(contact) || !cor_si_in_range(speed_m_s))
        return NAN;
    if (!does_touch(&at, contact, speed_m_s))
        return 0;
    if (!is_full(contact, at) && !contact->plate)
        return cor_quiet_product(units_of_speed(contact, at).force_n,
                                 cor_law_force_max(&contact->law, parameter_of(contact, at)));
    dry_impact(&impact, contact, at);
    return impact.force_max;
}

double cor_scene_tabor_number(const struct cor_scene_contact *contact, double adhesion_j_m2, double distance_m)
{
    if (!cor_contact_is_sound(contact) || !isgreater(contact->radius_m, 0) || !cor_si_in_range(adhesion_j_m2) ||
        !cor_si_in_range(distance_m))
        return NAN;
    const double modulus = 0.75 * contact->stiffness / sqrt(contact->radius_m),
                 ratio = cor_quiet_quotient(adhesion_j_m2, cor_quiet_product(modulus, distance_m)),
                 length = contact->radius_m / distance_m;
    return cor_quiet_power(cor_quiet_product(cor_quiet_product(ratio, ratio), length), 1.0 / 3);
}

int cor_scene_tangential(double *stiffness_n_m, double *damping_n_s_m, const struct cor_scene_contact *contact,
                         double tangential_eps, int end)
{
    struct cor_scene_impact impact;
    *stiffness_n_m = *damping_n_s_m = NAN;
    if (!cor_law_is(&contact->law, 2, 0) || contact->force_n + contact->adhesion_j_m2 + contact->liquid_speed_m_s > 0 ||
        !isgreater(tangential_eps, 0) || !islessequal(tangential_eps, 1))
        return COR_FAULT_RANGE;
    const int status = cor_scene_impact(&impact, contact, 1);
    const double loss = -log(tangential_eps), time = impact.duration_s[end], mass = 2 * contact->mass_kg / 7;
    if (status != COR_FAULT_NONE || !isless(time, INFINITY))
        return status != COR_FAULT_NONE ? status : COR_FAULT_RANGE;
    *stiffness_n_m = cor_quiet_quotient(cor_quiet_quotient(mass * (COR_PI * COR_PI + loss * loss), time), time);
    *damping_n_s_m = cor_quiet_quotient(2 * mass * loss, time);
    return status;
}

/* ---- the damping from other quantities ---- */

static int eps_at(double *eps, const struct cor_scene_contact *contact, double beta, double speed_m_s, int end)
{
    struct cor_scene_contact trial = *contact;
    struct cor_full_impact impact;
    if (!(contact->adhesion_j_m2 > 0 || contact->force_n > 0))
        return eps_of(eps, contact, beta, end);
    trial.damping = cor_quiet_product(beta / beta_per_damping(contact),
                                      cor_quiet_power(speed_m_s, -cor_scene_speed_exponent(contact)));
    trial.plastic = 0;
    const int status = dry_impact(&impact, &trial, speed_m_s);
    *eps = impact.eps[end];
    return status;
}

/* Solves eps(beta) = eps, a decreasing function, by the Illinois method on ln(beta) and ln(eps). */
static int solved_beta(double *beta, const struct cor_scene_contact *contact, double eps, double speed_m_s, int end)
{
    enum { MOST_STEPS = 400 };
    if (isnan(first_coefficient(&contact->law)))
        return COR_FAULT_NO_DAMPING;
    const double wanted = eps > 0 ? log(eps) : 0;
    struct cor_bracket bracket = {0, 0, 0, 0, 0};
    double x = log(fmax(1 - eps, 1e-16) / first_coefficient(&contact->law));
    for (int k = 0; k < MOST_STEPS; k++) {
        double got;
        *beta = exp(x);
        const int status = eps_at(&got, contact, *beta, speed_m_s, end);
        if (status != COR_FAULT_NONE)
            return status;
        const double rest = eps == 0            ? isgreater(got, 0)
                            : isgreater(got, 0) ? log(got) - wanted
                                                : -1; /* for eps = 0 the result is the smallest beta that gives it */
        if (fabs(rest) < 1e-15 * fmax(1, fabs(wanted)) ||
            (cor_is_bracketed(&bracket) && bracket.high - bracket.low < 1e-15 * fmax(1, fabs(x))))
            return COR_FAULT_NONE;
        x = cor_next_place(&bracket, x, rest, rest > 0 ? x + 1 : x - 1);
    }
    return COR_FAULT_NO_DAMPING;
}

int cor_scene_set_damping(struct cor_scene_contact *contact, int number, double value, double speed_m_s, int end)
{
    const int is_constant = cor_law_is_constant(&contact->law);
    struct cor_scene_contact undamped = *contact;
    undamped.damping = 0;
    contact->damping = NAN;
    if (!cor_contact_is_sound(&undamped) || cor_inline_is_refused(value))
        return COR_FAULT_RANGE;
    const int pressed = contact->force_n + contact->adhesion_j_m2 > 0 && !isnan(speed_m_s);
    const double q = cor_scene_speed_exponent(contact);
    const struct functions f = functions_of(&contact->law);
    double parameter = 0;
    int status = COR_FAULT_NONE;
    switch (number) {
    case COR_SCENE_DISSIPATION_TIME:
    case COR_SCENE_DAMPING_COEFFICIENT:
        if (number == COR_SCENE_DISSIPATION_TIME)
            value = cor_quiet_product(cor_quiet_product(1.5, value), contact->stiffness); /* C */
        contact->damping = cor_quiet_product(value, beta_per_coefficient(contact)) / beta_per_damping(contact);
        break;
    case COR_SCENE_G_STAR:
        contact->damping = is_constant ? NAN : cor_quiet_power(value, -q) / first_coefficient(&contact->law);
        break;
    case COR_SCENE_BETA:
        contact->damping =
            is_constant ? value / beta_per_damping(contact) : cor_quiet_product(value, cor_quiet_power(speed_m_s, -q));
        break;
    case COR_SCENE_RESTITUTION:
        if (end == COR_END_APPROACH_ONLY && !cor_scene_has_end(&undamped, end))
            return COR_FAULT_NO_DAMPING;
        if (f.law != COR_LAWS && !pressed)
            parameter = value_of(&f, end, COR_DAMPING_OF_EPS, value);
        else if (value < 1)
            status = solved_beta(&parameter, contact, value, speed_m_s, end);
        if (pressed && is_constant)
            parameter /= beta_per_damping(contact);
        contact->damping = is_constant ? parameter : cor_quiet_product(parameter, cor_quiet_power(speed_m_s, -q));
        break;
    default:
        contact->damping = number == COR_SCENE_ZETA && is_constant ? value : (double)NAN;
    }
    return status;
}
