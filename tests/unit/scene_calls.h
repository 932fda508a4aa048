/* SPDX-License-Identifier: MIT */
/* Calls every function of scene.h in the list public_functions.inc; public_calls.h calls the other functions. The
 * arguments have the names of the parameters, and scene_arguments_draw draws them. */
#ifndef COR_TESTS_SCENE_CALLS_H
#define COR_TESTS_SCENE_CALLS_H

#include <time.h>

#include "public_calls.h"
#include "scene.h"

enum { SCENES = 4 };

struct scene_arguments {
    struct cor_scene scene;
    struct cor_scene_contact contact; /* the contact of the scene, or random numbers */
    double x[4], steps, tolerance;
    const struct cor_simulator_model *model;
    int end, number;
};
static struct arguments *sets;
static struct scene_arguments *scene_sets; /* SCENES scenes for each of sets[] */

/* Numbers of a scene: mostly ordinary ones from `low` to `high`, or not given */
static const struct {
    double low, high;
    unsigned given, of; /* the number is given in `given` out of `of` scenes */
} scene_numbers[COR_SCENE_NUMBERS] = {[COR_SCENE_YOUNG] = {1e6, 1e12, 1, 1},
                                      [COR_SCENE_POISSON] = {1e-3, 0.5, 1, 1},
                                      [COR_SCENE_RADIUS] = {1e-6, 1, 1, 1},
                                      [COR_SCENE_DENSITY] = {1, 1e5, 1, 1},
                                      [COR_SCENE_YOUNG_2] = {1e6, 1e12, 1, 2},
                                      [COR_SCENE_POISSON_2] = {1e-3, 0.5, 1, 2},
                                      [COR_SCENE_AT] = {1e-3, 10, 0, 1},
                                      [COR_SCENE_PLATE_THICKNESS] = {1e-4, 1, 0, 1},
                                      [COR_SCENE_GRAVITY] = {1, 100, 1, 8},
                                      [COR_SCENE_ADHESION] = {1e-3, 1, 1, 8},
                                      [COR_SCENE_YIELD_STRESS] = {1e6, 1e10, 1, 8},
                                      [COR_SCENE_LIQUID_VISCOSITY] = {1e-4, 1, 1, 8},
                                      [COR_SCENE_STIFFNESS] = {1, 1e9, 0, 1},
                                      [COR_SCENE_EFFECTIVE_MASS] = {1e-9, 1, 0, 1},
                                      [COR_SCENE_DISSIPATION_TIME] = {1e-9, 1e-2, 0, 1}};

static void scene_draw(struct cor_scene *scene, struct bit_source *r, const double *any)
{
    static const int ways[] = {COR_SCENE_DISSIPATION_TIME,    COR_SCENE_G_STAR, COR_SCENE_RESTITUTION,
                               COR_SCENE_DAMPING_COEFFICIENT, COR_SCENE_BETA,   COR_SCENE_ZETA};
    const enum cor_law law = (enum cor_law)draw_below(r, COR_LAW_LINEAR_ROOT);
    const int way = ways[draw_below(r, COUNT_OF(ways))], at = way == COR_SCENE_RESTITUTION || way == COR_SCENE_BETA;
    *scene = scene_without_numbers(law);
    scene->plate = law == COR_LAW_PLATE;
    scene->plastic = law == COR_LAW_ELASTIC_PLASTIC;
    scene->wall = draw_below(r, 2) && !scene->plate;
    scene->end = (int)draw_below(r, 3) - 1;
    scene->adhesion_model = (int)draw_below(r, 3);
    for (int k = 0; k < COR_SCENE_NUMBERS; k++) {
        const int spring = k == COR_SCENE_STIFFNESS || k == COR_SCENE_EFFECTIVE_MASS;
        const double low = scene_numbers[k].low,
                     ordinary = low > 0 ? draw_size(r, low, scene_numbers[k].high) : draw_size(r, 1e-4, 1);
        if (law == COR_LAW_LINEAR ? spring
                                  : scene_numbers[k].of && draw_below(r, scene_numbers[k].of) < scene_numbers[k].given)
            scene->number[k] = ordinary;
        if ((k == way && !scene->plate) || (k == COR_SCENE_AT && at) ||
            (k == COR_SCENE_PLATE_THICKNESS && scene->plate))
            scene->number[k] = ordinary;
        if (cor_scene_given(scene, k) && draw_below(r, 16) == 0)
            scene->number[k] = any[k];
    }
    if (scene->plastic)
        scene->number[way] = scene->number[COR_SCENE_AT] = NAN;
    if (!cor_scene_given(scene, COR_SCENE_ADHESION))
        scene->adhesion_model = COR_ADHESION_NONE;
    if (cor_scene_given(scene, COR_SCENE_LIQUID_VISCOSITY))
        scene_give(*scene, {COR_SCENE_GAP_OUTER, 1e-4}, {COR_SCENE_GAP_INNER, draw_size(r, 1e-8, 2e-4)});
}

static void scene_arguments_draw(struct scene_arguments *s, struct bit_source *r, const double *any)
{
    struct cor_scene_contact contacts[COR_SCENE_ENDS];
    struct cor_scene_fault fault;
    int count;
    scene_draw(&s->scene, r, any);
    cor_scene_contacts(contacts, &count, &fault, &s->scene);
    s->contact = contacts[0];
    s->contact.plastic = s->contact.plastic || (count == 0 && draw_below(r, 2)); /* filled at random, incomplete */
    for (int k = 0; k < 4; k++)
        s->x[k] = draw_below(r, 4) ? draw_size(r, 1e-5, 10) : any[COR_SCENE_NUMBERS + k];
    s->model = cor_simulator_model((enum cor_simulator_model_id)draw_below(r, COR_SIMULATOR_MODELS));
    s->end = (int)draw_below(r, 3);
    s->number = (int)draw_below(r, COR_SCENE_EPS_ZERO_FORCE + 1);
    s->tolerance = s->x[3] > 0 && s->x[3] <= 1e6 ? 2 : s->x[3]; /* smaller tolerances would be slow */
    s->steps = draw_below(r, 8) ? draw_size(r, 2, 60) : s->x[3] > 60 ? -1 : s->x[3];
    const clock_t start = clock();
    cor_scene_step_error(&(struct cor_step_error){0}, &s->contact, s->x[0], s->end, 4, s->number % COR_INTEGRATORS);
    if (clock() - start > CLOCKS_PER_SEC / 1000 || !(cor_scene_beta(&s->contact, s->x[0]) < 1))
        s->steps = 0; /* no time step, because a thousand steps would need milliseconds */
}

/* Draws the scenes that belong to sets[i], whose other arguments are already drawn. */
static void scene_sets_draw(size_t i, struct bit_source *source)
{
    for (size_t k = 0; k < SCENES; k++)
        scene_arguments_draw(&scene_sets[SCENES * i + k], source, sets[i].beta + 36 * k);
}

/* ---- the calls: each argument has the name of its parameter ---- */

static double speed_m_s, eps, damping, e, speed_ratio, yield_stress_pa, yield_speed_m_s, overlap_m, requested, value,
    liquid_speed_m_s, viscosity_pa_s, gap_outer_m, gap_inner_m, adhesion_j_m2, distance_m, tangential_eps, steps,
    tolerance, frequency, zeta, softness, gravity_m_s2, solimp[5], friction, tangent, stiffness, damping_coefficient;
static enum cor_tangential_id model_id;
static int end, number, integrator, body, same_law, options, equivalence;
static struct cor_scene spring[1];
static enum cor_law law;
static const struct cor_exponents *exponents;
static const struct cor_scene_option *option;
static const struct cor_simulator_model *model;
static const struct cor_simulator *named;
static const struct cor_scene *scene;
static const char *name, *law_name, *rule;
static enum cor_simulator_model_id id;
static char text[20000];
static const size_t size = sizeof text;
static struct cor_simulator_request request[1];
static struct cor_scene of_law;
static struct cor_material materials[3];
static struct cor_material_contact material_memory[9];
static struct cor_scene_contact contact[1], contacts[COR_SCENE_ENDS], corrected[1], hertz[1];
static struct cor_scene_fault fault[1];
static enum cor_simulator_status status[1];
static struct cor_tangential tangential[1];
static int count[1];
static struct { /* output of the functions */
    struct cor_scene_impact impact;
    struct cor_step_error error;
    struct cor_oblique_impact oblique;
    double number[6];
} out;
static struct cor_scene_impact *const impact = &out.impact;
static struct cor_step_error *const error = &out.error;
static struct cor_oblique_impact *const oblique = &out.oblique;
static double *const eps_at_end = &out.number[0], *const least_steps = &out.number[1], *const least = &out.number[2],
                     *const most = &out.number[3], *const stiffness_n_m = &out.number[4],
                     *const damping_n_s_m = &out.number[5];

static void scene_arguments_load(const struct scene_arguments *s)
{
    speed_m_s = eps = tangential_eps = damping = e = speed_ratio = requested = yield_stress_pa = yield_speed_m_s =
        overlap_m = s->x[0];
    value = adhesion_j_m2 = liquid_speed_m_s = viscosity_pa_s = s->x[1];
    gap_outer_m = distance_m = gravity_m_s2 = friction = s->x[2];
    tangent = damping_coefficient = s->x[3];
    stiffness = s->x[0] * 1e6;
    model_id = (enum cor_tangential_id)(s->number % COR_TANGENTIAL_MODELS);
    zeta = softness = s->x[1];
    frequency = s->number % 8 ? 1e3 : s->x[3];
    memcpy(solimp, (const double[]){0.5, 0.9, s->number % 8 ? 0.01 : s->x[2], 0.5, 2}, sizeof solimp);
    gap_inner_m = s->x[3];
    steps = s->steps;
    tolerance = s->tolerance;
    number = s->number;
    integrator = s->steps == 0 ? -1 : number % COR_INTEGRATORS;
    same_law = number % 2;
    equivalence = body = 1 + same_law;
    law = (enum cor_law)(number % COR_LAWS);
    option = &cor_scene_options[number % COR_SCENE_NUMBERS];
    model = s->model;
    named = NULL;
    scene = &s->scene;
    name = law_name = cor_simulator_of(id = model->id)->name;
    rule = same_law ? name : NULL;
    options = number % 4;
    fault[0] = (struct cor_scene_fault){number % COR_FAULT_GAPS, number % COR_SCENE_NUMBERS, 0, COR_OK};
    contact[0] = corrected[0] = contacts[0] = contacts[1] = s->contact;
    exponents = &contact->law;
    end = s->end % (contact->plate ? 1 : COR_SCENE_ENDS);
    request[0] = (struct cor_simulator_request){.simulator = name,
                                                .scene = scene,
                                                .contacts = contact,
                                                .count = 1,
                                                .speed_m_s = s->x,
                                                .speeds = 1,
                                                .steps = steps,
                                                .step_errors = s->end == 2 && steps > 0,
                                                .integrator = COR_NO_INTEGRATOR};
    tangential[0] = (struct cor_tangential){number % COR_TANGENTIAL_MEMORIES, same_law, number % 3, s->x[1], s->x[2]};
    if (s->number % 3 == 0) { /* three materials, one of them a wall */
        static const char *const many[] = {"lammps", "liggghts", "yade", "mercurydpm", "chrono", "mfix"};
        of_law = scene_without_numbers(COR_LAW_VISCOELASTIC);
        of_law.end = s->end == 2 ? COR_BOTH_ENDS : s->end;
        for (int i = 0; i < 3; i++) {
            const double radius = i == 1 ? INFINITY : 1e-3 * (i + 1);
            materials[i] = (struct cor_material){(const char *const[]){"a", "b", "c"}[i],
                                                 {1e9, 0.3, 1e-7, radius, 1e-2 * radius},
                                                 i ? (double)NAN : 2e-3,
                                                 i == 2 ? "a" : NULL};
        }
        request[0].simulator = many[s->number / 3 % 6];
        request[0].scene = &of_law;
        request[0].materials = materials;
        request[0].material_count = 3;
        request[0].friction = s->x[1];
        request[0].memory = material_memory;
    }
    memset(&out, 0, sizeof out);
}

/* Stores the result, and everything that a function may have written. */
static void scene_results_put(struct results *r, const char *type, const void *result, size_t bytes)
{
    const double numbers[] = {contact->damping, corrected->damping, contacts[0].damping, contacts[0].force_n};
    for (size_t k = 0; k < sizeof out / sizeof(double); k++)
        results_put(r, ((const double *)(const void *)&out)[k]);
    for (size_t k = 0; k < COUNT_OF(numbers); k++)
        results_put(r, numbers[k]);
    if (strcmp(type, "double") == 0)
        results_put(r, *(const double *)result);
    else
        for (size_t k = 0; k < bytes; k++)
            results_put(r, ((const unsigned char *)result)[k]);
}

#define SCENE_CALL(function, ...)                                                                                      \
    static void call_##function(const struct arguments *a, struct results *r)                                          \
    {                                                                                                                  \
        for (int i = 0; i < SCENES; i++) {                                                                             \
            scene_arguments_load(&scene_sets[SCENES * (a - sets) + i]);                                                \
            __VA_ARGS__;                                                                                               \
        }                                                                                                              \
    }
#define SCENE_FUNCTION(type, function, given)                                                                          \
    SCENE_CALL(function, type const result = function given; scene_results_put(r, #type, &result, sizeof result))
#define SCENE_PROCEDURE(function, given) SCENE_CALL(function, function given; scene_results_put(r, "void", NULL, 0))
#include "public_functions.inc"

#define SCENE_FUNCTION(type, function, given) {#function, call_##function, NULL, PUBLIC_several},
#define SCENE_PROCEDURE(function, given) {#function, call_##function, NULL, PUBLIC_several},
static const struct public_function scene_functions[] = {
#include "public_functions.inc"
};

/* The public functions, numbered 0 to function_count() - 1; scene.h comes last */
static inline size_t function_count(void)
{
    return public_function_count + COUNT_OF(scene_functions);
}

static inline const struct public_function *function_number(size_t k)
{
    return k < public_function_count ? &public_functions[k] : &scene_functions[k - public_function_count];
}

#endif
