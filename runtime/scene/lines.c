/* SPDX-License-Identifier: MIT */
/* The input lines for a contact in a simulator: the active model, its realised e, and other models as comments */
#include "cor/scene.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "cor/status.h"
#include "runtime/scene/exponents.h"
#include "runtime/scene/simulators.h"

enum { INPUT_DIGITS = 12, TEXT_DIGITS = 6, NUMBER = 32, WORD = 16, SENTENCE = 800 };
#define DEFAULT_STEPS 50

/* ---- names and versions ---- */

/* Returns the length of the common prefix, ignoring case. name is lower case. */
static size_t common_letters(const char *text, const char *name)
{
    size_t length = 0;
    while (name[length] && (text[length] | (text[length] >= 'A' && text[length] <= 'Z' ? 0x20 : 0)) == name[length])
        length++;
    return length;
}

const struct cor_simulator *cor_simulator_named(const char *name)
{
    for (size_t i = 0; i < cor_simulator_count; i++) {
        const char *const own = cor_simulators[i].name;
        const size_t length = common_letters(name, own);
        if (cor_simulators[i].comment && name[length] == '\0' && length > 0 &&
            (own[length] == '\0' || own[length] == '-'))
            return &cor_simulators[i];
    }
    return NULL;
}

/* Reads up to 8 digits. Returns the character after them. */
static const char *read_digits(long *value, const char *text)
{
    const char *const most = text + 8;
    for (*value = 0; text < most && *text >= '0' && *text <= '9'; text++)
        *value = 10 * *value + (*text - '0');
    return text;
}

/* Returns a date as a number, or 0 if it is not a date. text: month and year, which follow the day. */
static long date_of(long day, const char *text)
{
    static const char *const months[] = {"january", "february", "march",     "april",   "may",      "june",
                                         "july",    "august",   "september", "october", "november", "december"};
    for (long month = 1; month <= 12; month++) {
        long year;
        const size_t letters = common_letters(text, months[month - 1]);
        const char *const from = text + letters + strspn(text + letters, " -"), *const end = read_digits(&year, from);
        if (letters >= 3 && day >= 1 && day <= 31 && end == from + 4 && *end == '\0')
            return year * 10000 + month * 100 + day;
    }
    return 0;
}

long cor_simulator_version(const char *text)
{
    static const char more[] = "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.+~_-";
    long part[3] = {0};
    const char *end = read_digits(&part[0], text);
    const long date = date_of(part[0], end + strspn(end, " -"));
    if (end == text || date > 0)
        return end == text ? 0 : date;
    const int alone = *end != '.';
    for (int i = 1; i < 3 && *end == '.'; i++)
        end = read_digits(&part[i], end + 1);
    if (end[strspn(end, more)] != '\0' || (*end >= '0' && *end <= '9'))
        return 0;
    return alone && part[0] >= 10000000 ? part[0] : part[0] * 10000 + part[1] * 100 + part[2];
}

/* ---- text in a buffer ---- */

struct text {
    char *to;
    size_t size, length;
    const struct cor_simulator *simulator;
    int commented; /* each line becomes a comment */
    int at_start;  /* the next character begins a line */
    int known;     /* 0 if the line so far has an unknown number */
};

static void put_raw(struct text *t, const char *from)
{
    for (; *from; from++) {
        if (t->length + 1 < t->size)
            t->to[t->length] = *from;
        t->length++;
    }
    if (t->size > 0)
        t->to[t->length < t->size ? t->length : t->size - 1] = '\0';
}

static void put_text(struct text *t, const char *from)
{
    for (; *from; from++) {
        const char one[] = {*from, '\0'};
        if (t->commented && *t->simulator->comment_end && from[0] == '-' && from[1] == '-') {
            from++; /* XML comments must not contain --: leave it out */
            continue;
        }
        if (t->commented && t->at_start && *from != '\n')
            put_raw(t, t->simulator->comment);
        if (t->commented && !t->at_start && *from == '\n')
            put_raw(t, t->simulator->comment_end);
        put_raw(t, one);
        t->at_start = *from == '\n';
    }
}

/* Writes a comment of one line. */
static void put_comment(struct text *t, const char *format, ...)
{
    char line[SENTENCE];
    va_list list;
    va_start(list, format);
    vsnprintf(line, sizeof line, format, list);
    va_end(list);
    t->commented++;
    put_text(t, line);
    put_text(t, "\n");
    t->commented--;
}

/* Formats a number as text, with a decimal point in every locale. */
struct number {
    char text[NUMBER];
};
static struct number number_text(double value, int digits)
{
    struct number n;
    snprintf(n.text, sizeof n.text, "%.*g", digits, value);
    char *const comma = strchr(n.text, ',');
    if (comma)
        *comma = '.';
    return n;
}
#define TEXT(value) number_text(value, TEXT_DIGITS).text
#define INPUT(value) number_text(value, INPUT_DIGITS).text
#define EXACT(value) number_text(value, 15).text

/* ---- the request to a simulator ---- */

/* PAIR: bodies 1 and 2. LIKE_1: two copies of body 1. LIKE_2: two copies of body 2. The others: a body and a wall,
 * for time steps */
enum { PAIR, LIKE_1, LIKE_2, PAIRS, CONTACTS = PAIRS + 4 };
static const struct {
    int body, other, wall;
} between[CONTACTS] = {{1, 2, 0}, {1, 1, 0}, {2, 2, 0}, {1, 1, 1}, {1, 2, 1}, {2, 1, 1}, {2, 2, 1}};

struct task {
    const struct cor_simulator_request *request;
    const struct cor_simulator *simulator;
    int types;    /* types of bodies: 2 for two different bodies, or a body and a wall */
    int has_law;  /* some model has the law of the contact */
    int pressed;  /* gravity presses the bodies together; eps depends on it */
    int slides;   /* some contact has friction */
    int same_eps; /* fill_block keeps the requested eps at the model's end, even if a damping was given */
    /* one version for each end at which the restitution may have been measured */
    struct cor_scene_contact contact[CONTACTS][COR_SCENE_ENDS];
    struct cor_simulator_target target[CONTACTS];
    struct cor_simulator_request own; /* changed copy of the request: for soft walls, or for one of several contacts */
    size_t i, j;                      /* types of this contact, from 0 */
    struct cor_scene_contact soft[COR_SCENE_ENDS];
    double k1, hardening, depth;        /* for put_luding: k_1, k_p/k_1, plasticity depth */
    char law[NUMBER];                   /* name of the law */
    char refusal[COR_SIMULATOR_REASON]; /* "": none yet */
};

#define UNDER_FORCE(task) ((task)->pressed ? " under gravity" : "")

/* Stores the reason for the refusal. Returns 0. */
static int refuse_task(struct task *task, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vsnprintf(task->refusal, sizeof task->refusal, format, list);
    va_end(list);
    return 0;
}

/* True for a wall. Types are numbered in the order of the request, first the types of balls, then the walls. */
static int is_wall(const struct cor_material *material)
{
    return cor_is_infinity(material->body.mass_kg);
}

static size_t count_balls(const struct cor_simulator_request *request)
{
    size_t balls = 0;
    for (size_t k = 0; k < request->material_count; k++)
        balls += !is_wall(&request->materials[k]);
    return balls;
}

static const struct cor_material *material_of(const struct cor_simulator_request *request, size_t type)
{
    const struct cor_material *m = request->materials;
    const size_t balls = count_balls(request), before = type < balls ? type : type - balls;
    for (size_t found = 0; is_wall(m) != (type >= balls) || found++ < before;)
        m++;
    return m;
}

/* Returns the contact of two types in any order. For two walls, which never touch, returns the contact of the first
 * ball and the second wall. */
static struct cor_material_contact *contact_of(const struct cor_simulator_request *request, size_t i, size_t j)
{
    const size_t first = i < j ? i : j, last = i < j ? j : i;
    return &request->memory[(first < count_balls(request) ? first : 0) * request->material_count + last];
}

/* A model with its numbers for each pair */
struct block {
    const struct cor_simulator_model *model;
    double number[CONTACTS];
    double damping, speed_m_s; /* damping of the pair in the request, and the speed at which it holds */
    double time_step_s;        /* NaN: not known */
    int same_eps;              /* the model has the requested eps at its own end, not at the requested one */
    char reason[SENTENCE];     /* why the model has no numbers, or no corrected numbers */
};

/* Returns the type whose elasticity this type has: the type named `made_of`, or itself if `made_of` is NULL.
 * Returns the number of types if the name is unknown. */
static size_t source_of(const struct cor_simulator_request *request, size_t type)
{
    const char *const name = material_of(request, type)->made_of;
    size_t source = name ? 0 : type;
    while (name && source < request->material_count && strcmp(material_of(request, source)->name, name) != 0)
        source++;
    return source;
}

/* Returns a body of a type, with the elasticity of the type that source_of returns. */
static struct cor_body body_of(const struct cor_simulator_request *request, size_t type)
{
    const struct cor_body source = material_of(request, source_of(request, type))->body;
    struct cor_body body = material_of(request, type)->body;
    body.young_modulus_pa = source.young_modulus_pa;
    body.poisson_ratio = source.poisson_ratio;
    return body;
}

/* Turns task->own into a request for the contact of two types. */
static const struct cor_material_contact *own_contact(struct task *task, size_t i, size_t j)
{
    const struct cor_material_contact *const c = contact_of(task->request, i, j);
    task->own = *task->request;
    task->own.contacts = c->contact;
    task->own.friction = c->friction;
    task->own.tangential_stiffness = c->tangential_stiffness;
    task->request = &task->own;
    task->i = i;
    task->j = j;
    return c;
}

/* Makes the contact of types i and j the source of the numbers in the lines. */
static void turn_to_contact(struct task *task, struct block *block, size_t i, size_t j)
{
    const struct cor_material_contact *const c = own_contact(task, i, j);
    task->target[PAIR].scene = &c->scene;
    task->target[PAIR].contacts = c->contact;
    block->number[PAIR] = c->number;
}

/* True if the request has two different spheres */
static int bodies_differ(const struct cor_scene *scene)
{
    if (scene->wall || scene->plate || !cor_scene_given(scene, COR_SCENE_YOUNG))
        return 0;
    const struct cor_body one = cor_scene_body(scene, 1), two = cor_scene_body(scene, 2);
    return cor_scene_materials_differ(scene) || one.mass_kg != two.mass_kg ||
           one.dissipation_time_s != two.dissipation_time_s;
}

/* True if the damping is known for each material, not only for the pair */
static int has_own_damping(const struct cor_scene *scene)
{
    return cor_scene_given(scene, COR_SCENE_DISSIPATION_TIME) || cor_scene_given(scene, COR_SCENE_VISCOSITY);
}

/* Changes the contact of the pair into another contact of the same materials. The new damping comes from the
 * dissipation times of the materials, if they are known. Otherwise zeta (if q = 0) or C/K stays the same. */
static void make_contact(struct cor_scene_contact *contact, const struct cor_scene *scene, int kind)
{
    struct cor_sphere_contact sphere;
    const struct cor_body one = cor_scene_body(scene, between[kind].body);
    struct cor_body two = cor_scene_body(scene, between[kind].other);
    const double ratio =
        cor_quiet_quotient(cor_scene_damping(contact, COR_SCENE_DAMPING_COEFFICIENT), contact->stiffness);
    if (between[kind].wall)
        two.radius_m = two.mass_kg = INFINITY;
    if (cor_sphere_contact_init(&sphere, &one, &two) != COR_OK)
        return;
    contact->force_n = 0; /* gravity presses only the contact of the request */
    contact->mass_kg = sphere.effective_mass_kg;
    contact->stiffness = sphere.elastic_constant_n_m15;
    contact->radius_m = sphere.effective_radius_m;
    if (has_own_damping(scene))
        contact->damping = sphere.beta_per_root;
    else if (!cor_law_is_constant(&contact->law))
        cor_scene_set_damping(contact, COR_SCENE_DAMPING_COEFFICIENT, cor_quiet_product(ratio, contact->stiffness), 0,
                              0);
}

/* Fills all contacts from the contact of the request, or from its replacement. */
static void fill_pairs(struct task *task, const struct cor_scene_contact *contacts, int count, double speed_m_s,
                       double eps)
{
    const struct cor_scene *const scene = task->request->scene;
    for (int pair = 0; pair < CONTACTS; pair++) {
        for (int i = 0; i < count; i++) {
            task->contact[pair][i] = contacts[i];
            if (task->types == 2 && pair != PAIR && (!scene->wall || pair == LIKE_1))
                make_contact(&task->contact[pair][i], scene, pair);
        }
        task->target[pair] = (struct cor_simulator_target){scene, task->contact[pair], count, speed_m_s, eps, 0};
    }
}

/* Returns the end of contact for which eps is requested. If both ends are requested, it is zero overlap. */
static int end_of(const struct cor_scene *scene)
{
    return scene->end == COR_BOTH_ENDS ? COR_END_ZERO_OVERLAP : scene->end;
}

/* True if the version of the request has the model */
static int is_requested(const struct cor_simulator_model *model, const struct task *task)
{
    const char *const version = task->request->version;
    return cor_model_has_version(model, version ? cor_simulator_version(version) : 0);
}

/* True if the model has lines for the request, provided that their numbers are known. */
static int model_suits(const struct cor_simulator_model *model, const struct task *task, int has_law)
{
    return (task->request->materials ? model->many != NULL
                                     : model->lines && (!task->request->scene->wall || model->wall_lines)) &&
           is_requested(model, task) && !(model->has_function && task->request->scene->end == COR_END_APPROACH_ONLY) &&
           (has_law ? cor_simulator_has_law(model, task->request->contacts)
                    : cor_simulator_has_one_eps(model, task->request->contacts));
}

/* True for a sphere with Hertz's force at a wall, if the simulator reduces the stiffness at walls */
static int has_soft_wall(const struct task *task)
{
    return task->simulator->wall_divides > 0 && task->request->scene->wall &&
           cor_law_is_hertz(&task->request->contacts->law);
}

/* ---- the realised e of a model ---- */

static double damping_of(const struct block *block, const struct task *task, int pair)
{
    const struct cor_simulator_model *const model = block->model;
    return model->has_function ? NAN
           : model->damping_of_e
               ? model->damping_of_e(block->number[pair])
               : model->damping_of_number(model, block->number[pair], task->target[pair].contacts, block->speed_m_s);
}

/* Returns the contact that the simulator computes from the lines of the model. */
static struct cor_scene_contact contact_made(const struct block *block, const struct task *task, int pair)
{
    return cor_model_contact(task->contact[pair][0], task->has_law ? NULL : &cor_law_exponents[block->model->law],
                             damping_of(block, task, pair), block->speed_m_s);
}

/* Returns eps at a speed; NaN: not known. */
static double realised_eps(const struct block *block, const struct task *task, double speed_m_s)
{
    const struct cor_simulator_model *const model = block->model;
    double eps = NAN;
    if (model->has_function)
        cor_scene_eps(&eps, task->request->contacts, speed_m_s, end_of(task->request->scene));
    else if (model->law == COR_LAW_IMPULSE || (!task->pressed && cor_law_is_constant(&cor_law_exponents[model->law])))
        eps = cor_law_eps(model->law, model->end, block->damping);
    else if (model->end == COR_END_ZERO_OVERLAP || model->end == COR_END_ZERO_FORCE) {
        const struct cor_scene_contact c = contact_made(block, task, PAIR);
        cor_scene_eps(&eps, &c, speed_m_s, (int)model->end);
    }
    return eps;
}

static int integrator_of(const struct task *task)
{
    const int own = task->simulator->integrator;
    return own == COR_NO_INTEGRATOR || task->request->integrator == COR_NO_INTEGRATOR ? own : task->request->integrator;
}

/* True if the lines of the model define this contact. For a sphere and a wall, lines with matrices or with one law also
 * define the contact of two equal spheres. */
static int has_contact(const struct block *block, const struct task *task, int pair)
{
    const enum cor_simulator_pairs pairs = block->model->pairs;
    return pair == PAIR ||
           (task->types == 2 && (!task->request->scene->wall ||
                                 (pair == LIKE_1 && (pairs == COR_PAIRS_MATRIX || pairs == COR_PAIRS_ONE_LAW))));
}

/* Returns the time step of one contact at a speed: its duration divided by the number of steps, or the largest step for
 * the tolerance. The result is infinite if the bodies never part, and NaN if it is not known. *steps: the requested
 * number. For PAIR it becomes the number that was used. Users may change the damping of other contacts. For them the
 * result is therefore the smallest of the steps for either end and for no damping. */
static double step_of(const struct cor_scene_contact *c, const struct task *task, int pair, int end, double speed,
                      double *steps)
{
    const double tolerance = task->request->step_tolerance, elastic = cor_scene_elastic_duration_s(c, speed);
    struct cor_scene_impact impact = {.duration_s = {elastic, elastic}};
    double own = *steps;
    if (tolerance > 0 ? pair < PAIRS && cor_scene_step_for(&own, c, speed, end, tolerance, integrator_of(task)) != 0
                      : cor_scene_impact(&impact, c, speed) != COR_FAULT_NONE)
        own = NAN;
    if (pair == PAIR)
        *steps = own;
    if (c->force_n > 0 && tolerance == 0) { /* the duration may be infinite, or include a flight */
        struct cor_scene_impact bounce = impact;
        struct cor_scene_contact undamped = *c;
        undamped.damping = 0;
        cor_scene_impact(&bounce, &undamped, speed);
        impact.duration_s[end] = fmin(impact.duration_s[end], bounce.duration_s[end]);
    }
    const double step = cor_quiet_quotient(impact.duration_s[end], own);
    return pair == PAIR ? step : fmin(step, cor_quiet_quotient(fmin(impact.duration_s[!end], elastic), *steps));
}

/* Returns the smallest step of all contacts of the block; NaN if the step of the pair is not known. */
static double time_step(const struct block *block, const struct task *task)
{
    const struct cor_simulator_request *const request = task->request;
    const struct cor_exponents *const law = &request->contacts->law;
    const int end = block->model->end == COR_END_ZERO_OVERLAP ? COR_END_ZERO_OVERLAP : COR_END_ZERO_FORCE;
    double least = INFINITY;
    if (request->time_step_s > 0)
        return request->time_step_s;
    if (block->model->law == COR_LAW_IMPULSE || isnan(request->contacts->mass_kg))
        return NAN;
    if (request->speeds == 0 && isnan(task->target[PAIR].speed_m_s) && law->elastic != law->denominator)
        return NAN; /* the duration depends on the speed */
    for (size_t i = 0; i < request->speeds || i == 0; i++) {
        double steps = request->steps > 0 ? request->steps : DEFAULT_STEPS;
        for (int pair = 0; pair < CONTACTS; pair++) {
            const struct cor_scene_contact c = contact_made(block, task, pair);
            if (!cor_law_has_spring_of(&c.law, law))
                return NAN; /* the model has another spring, whose stiffness the user chooses */
            if (has_contact(block, task, pair))
                least = fmin(least, step_of(&c, task, pair, end,
                                            request->speeds > 0 ? request->speed_m_s[i] : block->speed_m_s, &steps));
            if (isnan(steps))
                return NAN;
        }
    }
    return least > 0 && least < INFINITY ? least : NAN;
}

/* Corrects the numbers for the time step, at the only speed of the request. Returns 0 if that is not possible. */
static int correct_block(struct block *block, const struct task *task)
{
    enum cor_simulator_status status;
    double number[PAIRS];
    if (block->model->law == COR_LAW_IMPULSE)
        return 1;
    snprintf(block->reason, SENTENCE, "cor has no correction of its damping for the time step: %s",
             task->request->speeds != 1 ? "a correction holds at one impact speed; give one speed"
             : integrator_of(task) == COR_NO_INTEGRATOR
                 ? "its integrator is implicit, or chooses its own steps"
                 : "the time step is not known, or it is so long that no damping gives the requested mean eps");
    if (task->request->speeds != 1)
        return 0;
    for (int pair = PAIR; pair < PAIRS; pair++) {
        struct cor_simulator_target target = task->target[pair];
        struct cor_scene_contact c = *target.contacts;
        c.law = contact_made(block, task, PAIR).law;
        if (task->has_law || isnan(target.speed_m_s))
            target.speed_m_s = *task->request->speed_m_s;
        target.steps = cor_scene_elastic_duration_s(&c, target.speed_m_s) / block->time_step_s;
        number[pair] = target.steps > 0 ? cor_simulator_number(block->model, &target, task->has_law, &status) : NAN;
        if (isnan(number[pair]))
            return 0;
    }
    memcpy(block->number, number, sizeof number);
    block->damping = damping_of(block, task, PAIR);
    return 1;
}

/* True if an end was requested, eps depends on the end, and the model has the law but ends contacts at another end. */
static int ends_elsewhere(const struct cor_simulator_model *model, const struct task *task)
{
    const int end = task->request->scene->end;
    return end != COR_BOTH_ENDS && (int)model->end != end && model->law != COR_LAW_IMPULSE && task->has_law &&
           (end == COR_END_APPROACH_ONLY || cor_scene_ends_differ(task->request->contacts));
}

/* Sets *eps to the eps of the contact at the requested end. Changes the damping so that the contact has this eps at the
 * model's end. *speed_m_s: the speed at which this holds; NaN if eps does not depend on it. Returns 0 if eps is not
 * known or no damping gives it. */
static int meet_eps(struct cor_scene_contact *contact, double *eps, double *speed_m_s, const struct task *task,
                    const struct cor_simulator_model *model)
{
    const struct cor_simulator_request *const request = task->request;
    const double at = request->scene->number[COR_SCENE_AT];
    const int constant = !task->pressed && cor_law_is_constant(&contact->law);
    *speed_m_s = constant ? (double)NAN : !isnan(at) ? at : request->speeds > 0 ? request->speed_m_s[0] : (double)NAN;
    if ((isnan(*speed_m_s) && !constant) ||
        cor_scene_eps(eps, contact, constant ? 1 : *speed_m_s, request->scene->end) != COR_FAULT_NONE)
        return 0;
    const double closed = task->pressed ? (double)NAN : cor_law_damping(model->law, model->end, *eps);
    if (!isnan(closed))
        contact->damping = closed;
    return !isnan(closed) ||
           (model->end <= COR_END_ZERO_FORCE &&
            cor_scene_set_damping(contact, COR_SCENE_RESTITUTION, *eps, *speed_m_s, (int)model->end) == COR_FAULT_NONE);
}

/* Finds the numbers of a model. Returns 1 if they exist. They realise a given restitution at the model's end. */
static int fill_block(struct block *block, struct task *task, const struct cor_simulator_model *model)
{
    enum cor_simulator_status status = COR_SIMULATOR_OK;
    const struct cor_simulator_target *const target = &task->target[PAIR];
    struct cor_scene_contact met = *task->request->contacts;
    double least, most, eps, speed;
    block->model = model;
    block->same_eps = (task->same_eps || cor_scene_given(task->request->scene, COR_SCENE_RESTITUTION)) &&
                      ends_elsewhere(model, task) && meet_eps(&met, &eps, &speed, task, model);
    fill_pairs(task, block->same_eps ? &met : task->request->contacts, block->same_eps ? 1 : task->request->count,
               target->speed_m_s, target->eps);
    block->speed_m_s = isnan(target->speed_m_s) ? 1 : target->speed_m_s;
    for (int pair = CONTACTS - 1; pair >= PAIR; pair--)
        block->number[pair] = cor_simulator_number(model, &task->target[pair], task->has_law, &status);
    const double requested = cor_simulator_damping(model, target, task->has_law), number = block->number[PAIR];
    if (status == COR_SIMULATOR_NO_CLOSED_FORM && task->pressed && !task->has_law) {
        snprintf(block->reason, SENTENCE,
                 "under gravity this model needs mass and stiffness: give bodies, or --stiffness and --effective-mass");
    } else if (status == COR_SIMULATOR_NO_CLOSED_FORM) {
        snprintf(
            block->reason, SENTENCE,
            "contacts of this model end at %s, where the damping has no closed form: give --damping-coefficient C, or "
            "--end with --restitution",
            cor_end_names[model->end]);
    } else if (status == COR_SIMULATOR_NO_SCALES) {
        snprintf(block->reason, SENTENCE, "it needs %s",
                 isnan(target->contacts->mass_kg)
                     ? "mass and stiffness: give bodies, or --stiffness and --effective-mass"
                     : "the effective radius of bodies: give bodies instead of --stiffness and --effective-mass");
    } else if (isnan(number)) {
        cor_simulator_reach(model, &least, &most);
        snprintf(block->reason, SENTENCE, "no e of this model realises eps = %s; allowed: %s to %s%s",
                 TEXT(cor_law_eps(model->law, model->end, requested)), TEXT(least), TEXT(most),
                 status == COR_SIMULATOR_TOO_SMALL && model->end == COR_END_ZERO_FORCE
                     ? ". Its formula assumes that contacts end at zero overlap, but they end at zero force, which "
                       "gives at least exp(-2) = 0.1353. Request a larger eps, or set its damping coefficient by "
                       "--stiffness and --effective-mass"
                     : "");
    }
    if (isnan(number))
        return 0;
    block->damping = damping_of(block, task, PAIR);
    block->time_step_s = time_step(block, task);
    return !task->request->step_corrected || correct_block(block, task);
}

/* ---- lines ---- */

/* Returns the index of the law if it has a name and is not a plate's, otherwise -1. */
static int law_with_name(const struct cor_exponents *law)
{
    for (int i = COR_LAW_PLATE - 1; i >= 0; i--)
        if (cor_law_is_same(law, &cor_law_exponents[i]))
            return i;
    return -1;
}

/* Writes the command for a header of this contact. g* gives the damping of every law whose eps depends on the speed. */
static void put_embed(struct text *t, const struct task *task)
{
    const struct cor_simulator_request *const request = task->request;
    const struct cor_exponents *const law = &request->scene->law;
    const int named = law_with_name(law);
    char line[SENTENCE], other[NUMBER * 2] = "", damping[200], scales[200] = "";
    double least = 1e-3, most = 100;
    for (size_t i = 0; i < request->speeds; i++) {
        least = i == 0 ? request->speed_m_s[i] : fmin(least, request->speed_m_s[i]);
        most = i == 0 ? request->speed_m_s[i] : fmax(most, request->speed_m_s[i]);
    }
    const double wider = least == most ? 10 : 1;
    const struct cor_scene_contact *const contact = request->contacts;
    if (named < 0)
        snprintf(other, sizeof other, " --elastic %d/%d --damping %d/%d", law->elastic, law->denominator, law->damping,
                 law->denominator);
    else if (named != COR_LAW_VISCOELASTIC)
        snprintf(other, sizeof other, " --law %s", cor_law_name((enum cor_law)named));
    snprintf(damping, sizeof damping, "%s --g-star %s", other, EXACT(cor_scene_damping(contact, COR_SCENE_G_STAR)));
    if (contact->plastic) /* any eps and its speed determine v_y */
        snprintf(damping, sizeof damping, " --law elastic-plastic --restitution 0.5 --at %s",
                 EXACT(contact->yield_speed_m_s * cor_elastic_plastic_speed_ratio(0.5)));
    if (task->pressed)
        snprintf(scales, sizeof scales, " --stiffness %s --effective-mass %s --wall --gravity %s",
                 EXACT(contact->stiffness), EXACT(contact->mass_kg), EXACT(request->scene->number[COR_SCENE_GRAVITY]));
    snprintf(line, sizeof line,
             "corgen embed%s%s --speed-min %s --speed-max %s --tolerance 1e-6 --end %s --name cor_eps "
             "--output cor_eps.h",
             damping, scales, TEXT(least / wider), TEXT(most * wider),
             request->scene->end != COR_END_ZERO_FORCE ? "zero-overlap"
             : task->pressed                           ? "surface"
                                                       : "zero-force");
    put_text(t, line);
}

/* Returns the number for a word; NaN if unknown. zeta and the natural frequency determine MuJoCo's time constant; the
 * contact time and e' determine YADE's numbers. For Simbody's stiffness s of each body, K = (4/3) sqrt(R) s/2^(3/2). */
static double word_number(const char *word, const struct block *block, const struct task *task, int pair)
{
    const struct cor_simulator_target *const target = &task->target[pair];
    const struct cor_simulator_request *const r = task->request;
    const struct cor_body one = r->materials ? body_of(r, task->i) : cor_scene_body(target->scene, 1),
                          two = cor_scene_body(target->scene, 2);
    const double i = (double)task->i, j = (double)task->j,
                 types = r->materials ? (double)r->material_count : task->types;
    const int known = cor_is_moderate(target->contacts, 1);
    const double k = known ? target->contacts->stiffness : (double)NAN,
                 m = known ? target->contacts->mass_kg : (double)NAN,
                 radius = known ? target->contacts->radius_m : (double)NAN, kn = cor_quiet_quotient(k, sqrt(radius)),
                 number = block->number[pair];
    const double positive = isgreater(number, 0) ? number : (double)NAN, l = log(positive);
    const int hertz = cor_law_is_hertz(&r->contacts->law);
    const double kt =
        r->friction > 0 ? cor_quiet_product(cor_quiet_quotient(r->tangential_stiffness, r->contacts->stiffness), k) : 0;
    const double ct = r->tangential_damping * sqrt(k / r->contacts->stiffness * m / r->contacts->mass_kg);
    const double nu = one.poisson_ratio,
                 density = !r->materials         ? cor_scene_body_density(target->scene, 1)
                           : isinf(one.radius_m) ? (double)NAN
                                                 : cor_scene_body_density(&contact_of(r, task->i, task->i)->scene, 1);
    const int alike = r->materials ||
                      (!cor_scene_materials_differ(target->scene) && one.dissipation_time_s == two.dissipation_time_s);
    const struct {
        const char *word;
        double value;
    } words[] = {{"n", number},
                 {"n/2", number / 2},
                 {"nR", number * radius},
                 {"root", sqrt(number)},
                 {"K", k},
                 {"2K", 2 * k},
                 {"K/m", k / m},
                 {"K/R", k / radius},
                 {"R", radius},
                 {"kn", kn},
                 {"stiffness", cor_law_is(&task->request->contacts->law, 2, 0) ? k : kn},
                 {"E", 0.75 * k / sqrt(radius)},
                 {"2m", 2 * m},
                 {"tc", sqrt(m / k * (COR_PI * COR_PI + l * l))},
                 {"timeconst", cor_quiet_quotient(sqrt(m / k), positive)},
                 {"simbody", sqrt(4.5) * k / sqrt(radius)},
                 {"young", one.young_modulus_pa},
                 {"poisson", nu},
                 {"youngpair", isless(fabs(nu), 1) ? 2 * (1 - nu * nu) * 0.75 * k / sqrt(radius) : (double)NAN},
                 {"young2", two.young_modulus_pa},
                 {"poisson2", two.poisson_ratio},
                 {"density", density},
                 {"density2", cor_scene_body_density(target->scene, 2)},
                 {"rho", alike ? density : (double)NAN},
                 {"k1", task->k1},
                 {"kp", cor_quiet_product(task->hardening, task->k1)},
                 {"kp/k1", task->hardening},
                 {"depth", task->depth},
                 {"mu", task->slides ? r->friction : (double)NAN},
                 {"phi", atan(r->friction)},
                 {"kt", hertz ? cor_quiet_quotient(kt, sqrt(radius)) : kt},
                 {"kt0", r->friction > 0 ? kt : (double)NAN},
                 {"2kt", 2 * kt},
                 {"ct", ct},
                 {"2ct", 2 * ct},
                 {"et", r->friction > 0 ? exp(-sqrt(3.5 * kt / k * (COR_PI * COR_PI + l * l) - COR_PI * COR_PI)) : 1},
                 {"dt", block->time_step_s},
                 {"erp", block->time_step_s * k / (block->time_step_s * k + number)},
                 {"cfm", 1 / (block->time_step_s * k + number)},
                 {"types", types},
                 {"i", i + 1},
                 {"j", j + 1},
                 {"k", i * ((r->materials ? (double)count_balls(r) : 0) - (i + 1) / 2) + j + 1},
                 {"0", 0},
                 {"1", 1}};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(words[i].word, word) == 0)
            return words[i].value;
    return NAN;
}

/* Returns the text that replaces a word; NULL if a number replaces it. */
static const char *word_text(const char *word, const struct task *task, int pair)
{
    static const char *const pairs[] = {"1 2", "1 1", "2 2"};
    const int hooke = cor_law_is(&task->request->contacts->law, 2, 0), two = task->types == 2;
    const struct {
        const char *word, *text;
    } words[] = {{"model", hooke ? "hooke" : "hertz"},
                 {"Model", hooke ? "Hooke" : "Hertz"},
                 {"pair", two && pair < PAIRS ? pairs[pair] : "* *"},
                 {"nofriction", task->slides ? "" : " Friction is 0 in these lines; add yours."},
                 {"undamped", task->slides ? " tangential_damping off" : ""},
                 {"s", two || task->request->material_count > 1 ? "s" : ""}};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(words[i].word, word) == 0)
            return words[i].text;
    return NULL;
}

static void put_number(struct text *t, const char *word, const struct block *block, const struct task *task, int pair)
{
    const double value = word_number(word, block, task, pair);
    t->known = t->known && !isnan(value);
    put_text(t, number_text(value, strcmp(word, "dt") == 0 ? TEXT_DIGITS : INPUT_DIGITS).text);
}

/* Writes the density of a body as an argument, if it is known. Body 2 needs it only if the materials differ. */
static void put_density(struct text *t, const char *word, const struct block *block, const struct task *task)
{
    const double density = word_number(word, block, task, PAIR);
    t->known = t->known && (word[strlen("density")] == '\0' || cor_scene_materials_differ(task->request->scene));
    put_text(t, isnan(density) ? "" : "density=");
    put_text(t, isnan(density) ? "" : INPUT(density));
    put_text(t, isnan(density) ? "" : ", ");
}

/* Writes a word. {contact}: the types of the contact, i or i_j. {plane}: the variable with the plane of wall j. */
static void put_types(struct text *t, const char *word, const struct task *task)
{
    const int plane = strcmp(word, "plane") == 0;
    put_text(t, plane ? "${cor_wall_" : "");
    put_text(t, plane ? "" : TEXT((double)task->i + 1));
    put_text(t, plane || task->i == task->j ? "" : "_");
    put_text(t, plane || task->i != task->j ? TEXT((double)task->j + 1) : "");
    put_text(t, plane ? "}" : "");
}

/* Writes the tangential force of LAMMPS or LIGGGHTS. LAMMPS uses the ratio of the damper to the normal damper and, with
 * Hertz's force, the stiffness per contact radius. */
static void put_tangential(struct text *t, const struct block *block, const struct task *task, int pair)
{
    const struct cor_simulator_request *const r = task->request;
    const struct cor_tangential_model *const model = &cor_tangential_models[r->tangential];
    const int lammps = task->simulator->tangential >> COR_LAMMPS_MINDLIN & 1;
    const double normal = cor_scene_damping(r->contacts, COR_SCENE_DAMPING_COEFFICIENT);
    if (!(r->friction > 0) || !lammps) {
        put_text(t, lammps ? "linear_nohistory 0 0" : task->slides ? "history" : "off");
        return;
    }
    put_text(t, model->name);
    if (model->memory != COR_REMEMBERS_NOTHING) {
        put_text(t, " ");
        put_number(t, model->constant_stiffness ? "kt0" : "kt", block, task, pair);
    }
    put_text(t, " ");
    put_text(t, INPUT(normal > 0 ? r->tangential_damping / normal : 0));
    put_text(t, " ");
    put_number(t, "mu", block, task, pair);
}

/* Writes the replacement of a word for the pair. Sets t->known to 0 if the number is not known. {X[]} is the matrix of
 * X for all pairs of types, {X[,]} this matrix with commas, {X[i]} the list of X of all bodies. */
static void put_word(struct text *t, const char *word, const struct block *block, const struct task *task, int pair)
{
    static const int order[] = {LIKE_1, PAIR, PAIR, LIKE_2};
    const int two = task->types == 2, many = task->request->materials != NULL, name = (int)strcspn(word, "["),
              matrix = word[name] && word[name + 1] != 'i';
    const size_t types = many ? task->request->material_count : two ? 2 : 1;
    const char *const text = word_text(word, task, pair);
    char of_two[WORD + 1];
    if (text) {
        put_text(t, text);
    } else if (strcmp(word, "contact") == 0 || strcmp(word, "plane") == 0) {
        put_types(t, word, task);
    } else if (strcmp(word, "embed") == 0) {
        put_embed(t, task);
    } else if (strcmp(word, "tangential") == 0) {
        put_tangential(t, block, task, pair);
    } else if (strncmp(word, "density", strlen("density")) == 0) {
        put_density(t, word, block, task);
    } else if (word[name] == '\0') {
        put_number(t, word, block, task, pair);
    } else {
        for (size_t i = 0; i < types * (matrix ? types : 1); i++) {
            struct task of_types = *task;
            struct block number = *block;
            snprintf(of_two, sizeof of_two, "%.*s%s", name, word, !many && !matrix && i > 0 ? "2" : "");
            if (many)
                turn_to_contact(&of_types, &number, matrix ? i / types : i, matrix ? i % types : i);
            put_text(t, i == 0 ? "" : word[name + 1] == ',' ? ", " : " ");
            put_number(t, of_two, &number, &of_types, matrix && two ? order[i] : PAIR);
        }
    }
}

/* Writes one line of a template for a pair. Returns the next line. */
static const char *put_line(struct text *t, const char *from, const struct block *block, const struct task *task,
                            int pair)
{
    while (*from && *from != '\n') {
        const char *const close = strchr(from, '}');
        const size_t length = close ? (size_t)(close - from) : 0;
        char word[WORD];
        /* Braces of a template enclose one word. Braces of the simulator's language enclose a line break. */
        if (*from == '{' && length > 1 && length < sizeof word && !memchr(from, '\n', length)) {
            memcpy(word, from + 1, length - 1);
            word[length - 1] = '\0';
            put_word(t, word, block, task, pair);
            from = close + 1;
        } else {
            const char one[] = {*from++, '\0'};
            put_text(t, one);
        }
    }
    put_text(t, "\n");
    return *from ? from + 1 : from;
}

static int line_has(const char *line, const char *word)
{
    const char *const found = strstr(line, word), *const end = strchr(line, '\n');
    return found && (!end || found < end);
}

/* Writes the lines of a template. Returns 1 if all numbers are known. */
static int put_template(struct text *t, const char *template, const struct block *block, const struct task *task)
{
    static const int order[] = {LIKE_1, LIKE_2, PAIR};
    int all_known = 1;
    while (*template) {
        const struct text before = *t;
        const int optional = *template == '?';
        const char *next = template;
        t->known = 1;
        for (int i = task->types == 2 && line_has(template, "{pair}") ? 0 : 2; i < PAIRS; i++) {
            put_text(t, order[i] == PAIR ? "" : task->simulator->comment);
            next = put_line(t, template + (optional || *template == '-'), block, task, order[i]);
        }
        if (!t->known && optional)
            *t = before;
        all_known = all_known && (t->known || optional);
        template = next;
    }
    return all_known;
}

/* ---- comments of a block ---- */

/* Returns the factor by which the number grows if the mass grows by the factor `masses`. If q = 0, eps stays the same,
 * otherwise the material stays the same. */
static double mass_factor(const struct block *block, const struct task *task, double masses)
{
    const struct cor_simulator_model *const model = block->model;
    struct cor_scene_contact c = task->contact[PAIR][0];
    if (!model->number_of_damping || model->mass == COR_MASS_PER_UNIT || isnan(c.mass_kg))
        return 1;
    const struct cor_exponents *const law = &cor_law_exponents[model->law];
    const double power = (cor_damping(law) + 1) / (cor_elastic(law) + 1) - 1;
    c.mass_kg *= masses;
    const double damping = block->damping * (cor_law_is_constant(law) ? 1 : pow(masses, power));
    return cor_quiet_quotient(model->number_of_damping(model, damping, &c, block->speed_m_s), block->number[PAIR]);
}

static int needs_mass(const struct block *block, const struct task *task)
{
    return isgreater(fabs(mass_factor(block, task, 2) - 1), 1e-9) || block->model->mass == COR_MASS_IN_LINES;
}

/* States which number depends on the mass, and how to change it for other masses. */
static void put_mass(struct text *t, const struct block *block, const struct task *task)
{
    const int whole = block->model->mass == COR_MASS_IN_LINES, wall = task->request->scene->wall;
    const double factor = mass_factor(block, task, 2), square = mass_factor(block, task, 4);
    const int known = isgreater(factor, 0) && isgreater(square, 0);
    const double power = known ? log2(factor) : (double)NAN;
    char name[NUMBER * 2], reason[NUMBER * 4];
    if (block->model->law == COR_LAW_IMPULSE)
        return;
    if (!needs_mass(block, task)) {
        put_comment(t, "Holds for every mass.");
        return;
    }
    snprintf(name, sizeof name, "%.*s", (int)strcspn(block->model->parameter, ","), block->model->parameter);
    if (whole)
        snprintf(reason, sizeof reason, "the last argument is 2 m");
    else if (known && fabs(log2(square) - 2 * power) < 1e-6)
        snprintf(reason, sizeof reason, "%s is proportional to m^%s", name, number_text(power, 3).text);
    else
        snprintf(reason, sizeof reason, "%s depends on m", name);
    put_comment(t, "Right only for the effective mass m = %s kg: %s. %s", TEXT(task->contact[PAIR][0].mass_kg), reason,
                task->types == 2 && !wall ? "Each pair of types has its own number."
                : wall                    ? "If masses differ, each group of one mass needs its own wall."
                                          : "If masses differ, each pair of types needs its own number.");
}

/* States the pairs of different bodies for which the lines hold, and the replacements for other pairs. */
static void put_pairs(struct text *t, const struct block *block, const struct task *task)
{
    const enum cor_simulator_pairs pairs = block->model->pairs;
    const struct cor_scene *const scene = task->request->scene;
    const char *const numbers =
        has_own_damping(scene) ? "the given damping of their materials"
                               : "the damping of the pair 1 2, which is right only if both bodies are of one material";
    if (task->types == 1 || scene->wall || block->model->has_function)
        return;
    if (pairs == COR_PAIRS_LINES)
        put_comment(
            t,
            "Only the line for 1 2 is active, and your own lines for 1 1 and 2 2 remain valid. If your input has no "
            "such lines, use the lines in the comments, with %s.",
            numbers);
    else if (pairs == COR_PAIRS_MATRIX)
        put_comment(t,
                    "The first and the last number of a matrix are for the pairs 1 1 and 2 2, with %s. Replace them by "
                    "your own numbers, and leave out your own lines of the same properties.",
                    numbers);
    else if (pairs == COR_PAIRS_ONE_LAW)
        put_comment(
            t,
            "All contacts have one law: the pairs 1 1 and 2 2 and walls also use the %.*s of the pair 1 2. If a pair "
            "needs another number N, replace the number by MatchMaker(matches=((i, j, N), ...)), with i and j the ids "
            "of the materials.",
            (int)strcspn(block->model->parameter, ","), block->model->parameter);
    else
        put_comment(
            t,
            "These numbers are for the pair 1 2, with the densities %s and %s kg/m^3. The pairs 1 1 and 2 2 need "
            "their own lines.",
            TEXT(cor_scene_body_density(scene, 1)), TEXT(cor_scene_body_density(scene, 2)));
}

/* Writes the realised eps, with the effect of the time step. */
static void put_stepped(struct text *t, const struct block *block, const struct task *task, double speed_m_s,
                        double eps)
{
    struct cor_step_error error;
    const struct cor_scene_contact c = contact_made(block, task, PAIR);
    const double steps = cor_scene_elastic_duration_s(&c, speed_m_s) / block->time_step_s;
    if (cor_scene_step_error(&error, &c, speed_m_s, (int)block->model->end, steps, integrator_of(task)) ==
        COR_FAULT_NONE)
        put_comment(
            t,
            "realises eps = %s at %s m/s%s with this time step, in the mean; standard deviation %s; %s with short "
            "steps",
            number_text(eps + error.bias, 5).text, TEXT(speed_m_s), UNDER_FORCE(task),
            number_text(error.scatter, 2).text, TEXT(eps));
    else
        put_comment(t, "realises eps = %s at %s m/s%s with short steps; the time step of the simulator is not known",
                    TEXT(eps), TEXT(speed_m_s), UNDER_FORCE(task));
}

static void put_realised(struct text *t, const struct block *block, const struct task *task)
{
    const struct cor_simulator_request *const request = task->request;
    const enum cor_law law = block->model->law;
    const int constant = law == COR_LAW_IMPULSE ? !block->model->has_function
                                                : !task->pressed && cor_law_is_constant(&cor_law_exponents[law]);
    const double *const speed = request->speeds > 0 ? request->speed_m_s : &task->target[PAIR].speed_m_s;
    const size_t speeds = request->speeds > 0 ? request->speeds : (size_t)!isnan(*speed);
    for (size_t i = 0; i < speeds; i++) {
        const double eps = realised_eps(block, task, speed[i]);
        /* Implicit methods damp strongly even with 50 steps in a contact, so their error is always printed. */
        const int implicit = integrator_of(task) == COR_IMPLICIT_EULER && !isnan(block->time_step_s);
        if (!isnan(eps) && (request->step_errors || implicit) && block->model->law != COR_LAW_IMPULSE)
            put_stepped(t, block, task, speed[i], eps);
        else if (!isnan(eps) || task->pressed)
            put_comment(t, "realises eps = %s at %s m/s%s", isnan(eps) ? "(not known)" : TEXT(eps), TEXT(speed[i]),
                        UNDER_FORCE(task));
    }
    if (speeds == 0 && constant)
        put_comment(t, "realises eps = %s at every speed", TEXT(realised_eps(block, task, 1)));
    else if (!task->has_law && !request->materials)
        put_comment(t, "Right only at %s m/s: %s does not have the law of the contact.", TEXT(block->speed_m_s),
                    task->simulator->title);
    else if (speeds == 0)
        put_comment(t,
                    "eps depends on the impact speed, as eps of the given contact does; add --speed LIST to print eps");
}

/* Writes the tangential restitution at each angle or tangential speed of the request. */
static void put_oblique(struct text *t, const struct block *block, const struct task *task)
{
    const struct cor_simulator_request *const r = task->request;
    const struct cor_scene_contact c = contact_made(block, task, PAIR);
    const int by_et = block->model == cor_simulator_model(COR_YADE_TC_EN); /* et and tc give spring and damper */
    const double et = word_number("et", block, task, PAIR), tc = word_number("tc", block, task, PAIR),
                 damping = by_et ? -4.0 / 7 * log(et) * c.mass_kg / tc : r->tangential_damping;
    for (size_t i = 0; i < r->speeds * r->obliques; i++) {
        const double speed = r->speed_m_s[i / r->obliques], given = r->oblique[i % r->obliques],
                     tangent = r->in_degrees ? tan(given * COR_PI / 180) : given / speed;
        struct cor_tangential tangential;
        struct cor_oblique_impact impact;
        const int end = block->model->end == COR_END_ZERO_FORCE;
        if (cor_scene_tangential_scaled(&tangential, &c, r->tangential, r->tangential_stiffness, damping, speed) ==
                COR_OK &&
            cor_scene_oblique(&impact, &c, &tangential, r->friction, speed, tangent, end) == COR_OK)
            put_comment(t, "tangential restitution = %s at %s degrees and %s m/s%s%s%s", TEXT(-impact.restitution),
                        TEXT(atan(tangent) * 180 / COR_PI), TEXT(speed),
                        cor_is_infinity(impact.time_step_s) ? "" : ", with time steps up to about ",
                        cor_is_infinity(impact.time_step_s) ? "" : TEXT(impact.time_step_s),
                        cor_is_infinity(impact.time_step_s) ? "" : " s");
    }
}

/* Explains the number, if it is an e that differs from the realised e. */
static void put_own_e(struct text *t, const struct block *block, const struct task *task)
{
    const double eps = cor_law_eps(block->model->law, block->model->end, block->damping);
    if (task->pressed || !block->model->damping_of_e || block->model->has_function ||
        fabs(block->number[PAIR] - eps) < 1e-7)
        return;
    const double back = cor_simulator_realised(block->model, eps);
    put_comment(t,
                isnan(back) ? "In %s this eps needs e = %s; the simulator refuses e = %s."
                            : "In %s this eps needs e = %s; e = %s would realise %s.",
                task->simulator->title, TEXT(block->number[PAIR]), TEXT(eps), TEXT(back));
}

static void put_setup(struct text *t, const struct block *block, const struct task *task)
{
    const struct cor_simulator *const s = task->simulator;
    t->commented++;
    put_template(t, s->setup, block, task);
    t->commented--;
    if (!task->request->version && !cor_model_has_version(block->model, s->packaged))
        put_comment(t, "%s %s of Debian 12 lacks this model; --simulator-version %s selects a model that it has.",
                    s->title, s->version, s->version);
}

/* Writes a model's comments, lines and time step. Returns 1 if the numbers are known. */
static int put_block(struct text *t, const struct block *block, const struct task *task, const char *instead)
{
    const struct cor_simulator_model *const model = block->model;
    put_comment(t, "%s%s, %s (%s): contacts end at %s", instead, task->simulator->title, model->model, model->version,
                cor_end_names[model->end]);
    put_realised(t, block, task);
    put_oblique(t, block, task);
    if (has_soft_wall(task))
        put_comment(t, "%s%s", task->simulator->wall, task->pressed ? " This eps holds for the wall." : "");
    if (task->pressed)
        put_comment(t, "The simulator adds gravity; eps is the rebound speed at %s over the impact speed.",
                    model->end == COR_END_ZERO_OVERLAP ? "zero overlap" : "the surface");
    put_comment(t, "%s", model->advice);
    put_own_e(t, block, task);
    put_mass(t, block, task);
    put_pairs(t, block, task);
    if (task->simulator->density && isnan(cor_scene_body_density(task->request->scene, 1)))
        put_comment(t, "%s", task->simulator->density);
    if (!*instead)
        put_setup(t, block, task);
    t->commented += *instead != '\0';
    const int known = put_template(t, task->request->scene->wall ? model->wall_lines : model->lines, block, task);
    if (!isnan(block->time_step_s) && task->simulator->time_step)
        put_template(t, task->simulator->time_step, block, task);
    t->commented -= *instead != '\0';
    if (!isnan(block->time_step_s) && !task->simulator->time_step)
        put_comment(t, "time step: at most %s s", TEXT(block->time_step_s));
    if (model->has_function)
        put_comment(t, "Outside these speeds cor_eps returns the value at the nearer end of their range.");
    put_text(t, "\n");
    return known;
}

/* ---- spheres that yield ---- */

/* Writes Luding's contact. It loads with k_1 and unloads with k_2(x) = k_1 + (k_p - k_1) x/x_p, where x is the largest
 * overlap. Then eps = sqrt(k_1/k_2). k_1 gives the same largest overlap as the request's contact at speed_m_s; x_p is
 * twice this overlap. */
static void put_luding(struct text *t, struct task *task, double speed_m_s, double eps)
{
    const struct cor_scene_contact *const contact = task->request->contacts;
    const struct block block = {.time_step_s = NAN};
    struct cor_scene_impact impact;
    if (isnan(contact->mass_kg) || isnan(contact->radius_m) ||
        (task->simulator->wall_divides > 0 && task->request->scene->wall) ||
        cor_scene_impact(&impact, contact, speed_m_s) != COR_FAULT_NONE || !isless(eps, 1))
        return;
    const double x = impact.max_overlap_m, ratio = cor_quiet_quotient(2, eps * eps) - 1;
    task->hardening = ratio;
    task->k1 = cor_quiet_quotient(contact->mass_kg * speed_m_s * speed_m_s, x * x);
    task->depth = x * (1 - 1 / ratio) / contact->radius_m;
    put_comment(t, "Instead, %s (run): Luding's linear hysteresis loads with k_1 and unloads with k_2,",
                task->simulator->luding);
    put_comment(
        t, "eps = sqrt(k_1/k_2). These numbers of the pair realise eps = %s and the largest overlap, %s m, at %s m/s.",
        TEXT(eps), TEXT(x), TEXT(speed_m_s));
    put_comment(
        t,
        "At an impact speed of g m/s, up to twice that speed, eps = (1 + %s g)^(-1/2). It falls faster with the "
        "speed than eps of the spheres.",
        TEXT(cor_quiet_quotient(cor_quiet_quotient(1, eps * eps) - 1, speed_m_s)));
    t->commented++;
    put_template(t, task->simulator->luding_lines, &block, task);
    t->commented--;
}

/* Prints the simulator's model for spheres that yield, in addition to the lines that hold at one speed. */
static void put_yielding(struct text *t, struct task *task)
{
    if (task->simulator->yielding)
        put_comment(t, "%s", task->simulator->yielding);
    else if (task->simulator->luding)
        put_luding(t, task, task->target[PAIR].speed_m_s, task->target[PAIR].eps);
    else if (!task->has_law) /* if the model has the law, its lines call a function of the speed */
        put_comment(t, "cor knows no model of %s for spheres that yield.", task->simulator->title);
}

/* ---- choice ---- */

/* Returns the rank of a model: 2 if it has the requested end, plus 1 if the packaged version has the model. */
static int rank_model(const struct cor_simulator_model *model, const struct task *task)
{
    const int end = task->request->scene->end;
    return 2 * (end == COR_BOTH_ENDS || (int)model->end == end || model->law == COR_LAW_IMPULSE) +
           cor_model_has_version(model, task->simulator->packaged);
}

/* States which eps the active lines have, if they end contacts at another end than requested. If a damping was given,
 * also prints lines with the requested eps. */
static void put_other_end(struct text *t, const struct block *active, struct task *task)
{
    const struct cor_simulator_request *const request = task->request;
    struct cor_scene_contact met = *request->contacts;
    struct block block;
    char instead[SENTENCE];
    double eps, speed;
    if (!ends_elsewhere(active->model, task))
        return;
    put_comment(t, "%s has no contacts of this law that end at %s%s. The lines above give %s.", task->simulator->title,
                cor_end_names[request->scene->end], request->version ? " in this version" : "",
                active->same_eps ? "the requested eps at the other end" : "the damping of the contact");
    if (active->same_eps || !meet_eps(&met, &eps, &speed, task, active->model))
        return;
    snprintf(instead, sizeof instead, isnan(speed) ? "For eps = %s: " : "For eps = %s at %s m/s: ", TEXT(eps),
             TEXT(speed));
    const struct text before = *t;
    task->same_eps = 1;
    if (fill_block(&block, task, active->model) && !put_block(t, &block, task, instead))
        *t = before;
    task->same_eps = 0;
}

/* Writes the eps that the simulator realises if a user sets the requested eps as e. */
static void put_own_maps(struct text *t, const struct task *task)
{
    const double eps = task->target[PAIR].eps;
    for (int i = 0; i < task->simulator->model_count && !isnan(eps) && !task->pressed; i++) {
        const struct cor_simulator_model *const model = &task->simulator->models[i];
        const double own = cor_simulator_realised(model, eps);
        if (model->damping_of_e && !model->has_function && is_requested(model, task))
            put_comment(t, "If e = %s is set by hand: %s (%s) %s%s.", TEXT(eps), model->model, model->version,
                        isnan(own) ? "refuses it" : "realises ", isnan(own) ? "" : TEXT(own));
    }
}

/* Prints all models that have the contact. If no model has it, returns 0 and refuses with the reason of the first
 * model. */
static int put_all(struct text *t, struct task *task)
{
    struct block block, active = {.model = NULL};
    char instead[SENTENCE];
    for (int wanted = 3; wanted >= 0 && !active.model; wanted--)
        for (int i = 0; i < task->simulator->model_count && !active.model; i++) {
            const struct cor_simulator_model *const model = &task->simulator->models[i];
            const struct text before = *t;
            if (!model_suits(model, task, task->has_law) || rank_model(model, task) != wanted)
                continue;
            const int filled = fill_block(&block, task, model);
            if (filled && put_block(t, &block, task, "")) {
                active = block;
                continue;
            }
            *t = before;
            if (!*task->refusal)
                refuse_task(task, "%s, %s: %s", task->simulator->name, model->model,
                            !filled ? block.reason
                            : cor_law_is_hertz(&task->request->contacts->law)
                                ? "it needs bodies, or --stiffness and --effective-mass"
                                : "its force is Hertz's: give bodies, and leave out --law, or write --law tsuji");
        }
    if (!active.model)
        return 0;
    put_other_end(t, &active, task);
    for (int i = 0; i < task->simulator->model_count; i++) {
        const struct cor_simulator_model *const model = &task->simulator->models[i];
        const struct text before = *t;
        if (!model_suits(model, task, task->has_law) || model == active.model)
            continue;
        const int other_version = !task->request->version && !cor_model_has_version(model, task->simulator->packaged),
                  other_end = !other_version && model->end != active.model->end;
        snprintf(instead, sizeof instead, "Instead, %s%s: ",
                 other_version                                      ? "in another version"
                 : other_end                                        ? "if contacts must end at "
                 : model->damping_of_e && needs_mass(&active, task) ? "if masses differ"
                                                                    : "the same damping, set by another parameter",
                 other_end ? cor_end_names[model->end] : "");
        if (!fill_block(&block, task, model)) {
            put_comment(t, "Not possible: %s: %s.", model->model, block.reason);
            put_text(t, "\n");
        } else if (!put_block(t, &block, task, instead))
            *t = before;
    }
    put_own_maps(t, task);
    return 1;
}

/* ---- the text ---- */

/* Gives the contact the reduced stiffness of the simulator's walls. Under gravity eps depends on the stiffness. */
static void soften_wall(struct task *task)
{
    const double *const number = task->request->scene->number;
    const int end = task->request->scene->end, measured = !isnan(number[COR_SCENE_RESTITUTION] * number[COR_SCENE_AT]);
    if (!task->pressed || !has_soft_wall(task))
        return;
    for (int i = 0; i < task->request->count; i++) {
        task->soft[i] = task->request->contacts[i];
        task->soft[i].stiffness /= task->simulator->wall_divides;
        if (measured)
            cor_scene_set_damping(&task->soft[i], COR_SCENE_RESTITUTION, number[COR_SCENE_RESTITUTION],
                                  number[COR_SCENE_AT], end == COR_BOTH_ENDS ? i : end);
    }
    task->own = *task->request;
    task->own.contacts = task->soft;
    task->request = &task->own;
}

/* Finds the speed at which the lines hold, and eps at this speed, for a simulator without the law of the contact.
 * Returns 0 if the request does not determine them. */
static int find_speed(struct task *task)
{
    const struct cor_simulator_request *const request = task->request;
    const struct cor_scene *const scene = request->scene;
    const int constant = cor_law_is_constant(&request->contacts->law) &&
                         !(task->pressed && (!task->has_law || cor_scene_given(scene, COR_SCENE_AT)));
    const double at = scene->number[COR_SCENE_AT], speed = request->speeds == 1 ? request->speed_m_s[0] : at;
    double eps = NAN;
    if (!task->has_law && isnan(speed))
        return refuse_task(task,
                           "%s does not have the law %s, so its lines hold at one impact speed: give one speed, for "
                           "example --speed 1",
                           task->simulator->name, task->law);
    if (cor_scene_given(scene, COR_SCENE_RESTITUTION) && (constant || speed == at)) {
        eps = scene->number[COR_SCENE_RESTITUTION];
    } else if (scene->end == COR_BOTH_ENDS && cor_scene_ends_differ(request->contacts)) {
        if (!task->has_law && !constant)
            return refuse_task(task,
                               "eps of this contact differs between its two ends; give the end whose eps %s must "
                               "realise: --end zero-overlap or %s",
                               task->simulator->name, task->pressed ? "surface" : "zero-force");
    } else if ((!isnan(speed) || constant) &&
               cor_scene_eps(&eps, request->contacts, isnan(speed) ? 1 : speed, end_of(scene)) != COR_FAULT_NONE) {
        return refuse_task(
            task, "eps of the law %s needs a solver, which the library does not have; use corgen contact", task->law);
    }
    soften_wall(task);
    fill_pairs(task, task->request->contacts, request->count, speed, eps);
    return 1;
}

/* True if a simulator has lines for the request: for two bodies or for several materials. */
static int has_lines(const struct cor_simulator *simulator, const struct task *task)
{
    int many = task->request->materials == NULL;
    for (int i = 0; i < simulator->model_count; i++)
        many = many || simulator->models[i].many;
    return simulator->comment && many;
}

/* Finds the simulator. Refuses a name without lines. */
static int find_simulator(struct task *task)
{
    task->simulator = cor_simulator_named(task->request->simulator);
    if (task->simulator && has_lines(task->simulator, task))
        return 1;
    struct text t = {task->refusal, sizeof task->refusal, 0, NULL, 0, 0, 1};
    put_text(&t, "'");
    put_text(&t, task->request->simulator);
    put_text(&t, "' is not a simulator that cor has lines for");
    put_text(&t, task->request->materials ? " with several materials; allowed: " : "; allowed: ");
    for (size_t i = 0, named = 0; i < cor_simulator_count; i++)
        if (has_lines(&cor_simulators[i], task)) {
            put_text(&t, named++ ? ", " : "");
            put_text(&t, cor_simulators[i].name);
        }
    return 0;
}

static int check_friction(struct task *task)
{
    const struct cor_simulator_request *const r = task->request;
    const struct cor_tangential_model *const model = &cor_tangential_models[r->tangential];
    const int lammps = task->simulator->tangential >> COR_LAMMPS_MINDLIN & 1,
              linear = cor_law_is(&r->contacts->law, 2, 0);
    task->slides = r->friction > 0;
    for (size_t k = 0; k < r->pair_count; k++)
        task->slides = task->slides || r->pairs[k].friction > 0;
    if (!task->slides)
        return 1;
    const int history = r->tangential == COR_LIGGGHTS_HISTORY || model->memory == COR_REMEMBERS_NOTHING;
    if ((task->simulator->tangential >> r->tangential & 1) == 0 ||
        (!history && model->constant_stiffness != linear && !(lammps && !linear)))
        return refuse_task(
            task,
            "cor has no model of the tangential force '%s' of %s for this normal force. --friction has lines for "
            "lammps, liggghts and yade, and for mercurydpm with --law linear. For other simulators leave out "
            "--friction, and add friction to your input",
            model->name, task->simulator->title);
    if (task->types == 2 && !r->scene->wall)
        return refuse_task(task, "lines with --friction need two bodies of the same material and size, or a wall; "
                                 "for others give --materials FILE");
    return lammps || r->tangential == COR_YADE_VISCEL || r->tangential == COR_MERCURYDPM_SLIDING_FRICTION ||
           !(r->tangential_damping > 0) ||
           refuse_task(task, "only LAMMPS, and YADE and MercuryDPM with --law linear, have lines with a tangential "
                             "damping; leave out --tangential-damping");
}

static int check_task(struct task *task)
{
    const struct cor_simulator_request *const request = task->request;
    const struct cor_scene_contact *const contact = request->contacts;
    if (!find_simulator(task))
        return 0;
    const struct cor_exponents *const law = &request->scene->law;
    const int named = request->scene->plastic ? COR_LAW_ELASTIC_PLASTIC : law_with_name(law);
    int has_wall = 0;
    if (request->version && cor_simulator_version(request->version) == 0)
        return refuse_task(task, "'%.100s' is not a version of %s: write it as 29 Sep 2021 or as 3.8.1",
                           request->version, task->simulator->title);
    task->pressed = contact->force_n > 0;
    if (cor_scene_given(request->scene, COR_SCENE_ADHESION) || contact->adhesion_j_m2 > 0)
        return refuse_task(task, "none of the models in these lines has adhesion; leave out --adhesion "
                                 "(docs/contact.md gives eps with adhesion)");
    if (contact->liquid_speed_m_s > 0)
        return refuse_task(task, "no simulator has lines for a contact in a liquid; corgen sample writes a table of "
                                 "its eps, for simulators that call a function of the speed");
    if (named >= 0)
        snprintf(task->law, NUMBER, "%s", cor_law_name((enum cor_law)named));
    else
        snprintf(task->law, NUMBER, "x^(%d/%d), x^(%d/%d) x'", law->elastic, law->denominator, law->damping,
                 law->denominator);
    task->types = !request->materials && (request->scene->wall || bodies_differ(request->scene)) ? 2 : 1;
    for (int i = 0; i < task->simulator->model_count; i++) {
        task->has_law = task->has_law || model_suits(&task->simulator->models[i], task, 1);
        has_wall = has_wall || task->simulator->models[i].wall_lines;
    }
    return !request->scene->wall || has_wall || request->materials ||
           refuse_task(task, "no model of %s has lines for a wall; leave out --wall", task->simulator->title);
}

/* If no model has the law, replaces it with a linear spring. Its undamped contact has the same duration T at the speed:
 * K = m (pi/T)^2. Returns 0 if the simulator has no linear model, the mass is not known, eps is not known or above 1,
 * or the new scene has a fault. Also returns 0 for constant forces, plates and plastic bodies. */
static int replace_law(struct cor_simulator_request *request, struct cor_scene *scene,
                       struct cor_scene_contact contacts[COR_SCENE_ENDS], const struct task *task)
{
    const struct cor_scene_contact *const contact = task->request->contacts;
    const struct cor_simulator_target *const target = &task->target[PAIR];
    struct cor_scene_fault fault;
    int has_linear = 0;
    for (int i = 0; i < task->simulator->model_count; i++)
        has_linear =
            has_linear || (task->simulator->models[i].lines && task->simulator->models[i].law == COR_LAW_LINEAR);
    if (!has_linear || !isgreater(contact->mass_kg, 0) || task->pressed || contact->plastic || contact->plate ||
        !islessequal(target->eps, 1))
        return 0;
    const double duration = cor_scene_elastic_duration_s(contact, target->speed_m_s);
    *scene = (struct cor_scene){.law = cor_law_exponents[COR_LAW_LINEAR],
                                .wall = task->request->scene->wall,
                                .end = COR_BOTH_ENDS,
                                .solver = task->request->scene->solver};
    for (int i = 0; i < COR_SCENE_NUMBERS; i++)
        scene->number[i] = NAN;
    scene->number[COR_SCENE_EFFECTIVE_MASS] = contact->mass_kg;
    scene->number[COR_SCENE_STIFFNESS] =
        cor_quiet_product(contact->mass_kg, cor_quiet_power(cor_quiet_quotient(COR_PI, duration), 2));
    scene->number[COR_SCENE_RESTITUTION] = target->eps;
    *request = *task->request;
    request->scene = scene;
    request->contacts = contacts;
    return cor_scene_contacts(contacts, &request->count, &fault, scene) == COR_FAULT_NONE;
}

static int check_numbers(struct task *task)
{
    const struct cor_simulator_request *const request = task->request;
    int moderate = !isnan(request->time_step_s + request->steps + request->step_tolerance);
    for (int i = 0; i < request->count; i++)
        moderate = moderate && cor_is_moderate(&request->contacts[i], 1);
    for (size_t i = 0; i < request->speeds; i++)
        moderate = moderate && cor_is_moderate(&request->contacts[0], request->speed_m_s[i]);
    return moderate || refuse_task(task, "a number of these lines is out of range; allowed: 1e-48 to 1e48 in SI units");
}

/* ---- several materials ---- */

/* Returns the scene of two types with their smallest or their largest balls, without damping. Only j may be a wall. */
static struct cor_scene scene_of_types(const struct cor_simulator_request *request, size_t i, size_t j, int largest)
{
    struct cor_scene scene = *request->scene;
    for (int body = 0; body < 2; body++) {
        const struct cor_material *const m = material_of(request, body ? j : i);
        double *const number = scene.number + body * COR_SCENE_BODY;
        const double radius = m->body.radius_m, ratio = largest ? cor_quiet_quotient(m->radius_max_m, radius) : 1;
        number[COR_SCENE_YOUNG] = body_of(request, body ? j : i).young_modulus_pa;
        number[COR_SCENE_POISSON] = body_of(request, body ? j : i).poisson_ratio;
        scene.wall = is_wall(m);
        if (scene.wall)
            continue;
        number[COR_SCENE_RADIUS] = isnan(ratio) ? radius : cor_quiet_product(radius, ratio);
        number[COR_SCENE_MASS] =
            isnan(ratio) ? m->body.mass_kg : cor_quiet_product(m->body.mass_kg, cor_quiet_power(ratio, 3));
    }
    return scene;
}

/* Returns the dissipation time of a type, or the time that follows from the measured contact of two of its balls; NaN
 * if neither is known. Sets *ends to 2 if the time depends on the unknown end of contact of the measurement. */
static double dissipation_time(const struct cor_simulator_request *request, size_t type, int end, int *ends)
{
    const double own = material_of(request, type)->body.dissipation_time_s;
    const size_t source = source_of(request, type);
    const struct cor_material *const m = material_of(request, source);
    const struct cor_material_contact *const like = contact_of(request, source, source);
    if (!isnan(own) || !isnan(m->body.dissipation_time_s) || is_wall(m) || !like->measured)
        return isnan(own) ? m->body.dissipation_time_s : own;
    *ends = like->count > *ends ? like->count : *ends;
    return cor_scene_damping(&like->contact[like->count > 1 ? end : 0], COR_SCENE_DISSIPATION_TIME);
}

static int refuse_contact(struct task *task, size_t i, size_t j, const char *why)
{
    return refuse_task(task, "%s and %s: %s", material_of(task->request, i)->name, material_of(task->request, j)->name,
                       why);
}

static int find_contact(struct task *task, size_t i, size_t j)
{
    const struct cor_simulator_request *const r = task->request;
    const struct cor_material *const one = material_of(r, i), *const two = material_of(r, j);
    struct cor_material_contact *const c = contact_of(r, i, j);
    double *const number = c->scene.number;
    struct cor_scene_contact found[COR_SCENE_ENDS];
    struct cor_scene_fault fault;
    char text[COR_SCENE_FAULT_TEXT];
    int ends = 1;
    c->scene = scene_of_types(r, i, j, 0);
    c->measured = NULL;
    c->friction = r->friction;
    for (const struct cor_material_pair *p = r->pairs; p < r->pairs + r->pair_count; p++)
        if ((&r->materials[p->a] == one && &r->materials[p->b] == two) ||
            (&r->materials[p->a] == two && &r->materials[p->b] == one)) {
            c->measured = isnan(p->restitution) ? NULL : p;
            c->friction = isnan(p->friction) ? r->friction : p->friction;
        }
    for (int end = 0; end < ends; end++) {
        if (c->measured) {
            number[COR_SCENE_RESTITUTION] = c->measured->restitution;
            number[COR_SCENE_AT] = c->measured->at_m_s;
            c->scene.end = c->measured->end == COR_BOTH_ENDS ? c->scene.end : c->measured->end;
        } else {
            number[COR_SCENE_DISSIPATION_TIME] = dissipation_time(r, i, end, &ends);
            number[COR_SCENE_DISSIPATION_TIME_2] = dissipation_time(r, j, end, &ends);
            if (isnan(number[COR_SCENE_DISSIPATION_TIME] + number[COR_SCENE_DISSIPATION_TIME_2]))
                return refuse_contact(
                    task, i, j,
                    "the damping of their contact is missing; give a row of --pairs for these two, or give each "
                    "material a dissipation time or a viscoelastic row of --pairs with itself");
        }
        const int status = cor_scene_contacts(found, &c->count, &fault, &c->scene);
        if (status != COR_FAULT_NONE) {
            cor_scene_fault_text(text, sizeof text, &fault, "of the request", NULL);
            return refuse_contact(task, i, j,
                                  status < 0 ? "not solved"
                                  : fault.fault != COR_FAULT_NOT_HERTZ
                                      ? text
                                      : "the law of materials must have Hertz's force; allowed: viscoelastic, tsuji, "
                                        "hertz-dashpot, hunt-crossley");
        }
        memcpy(c->contact + end, found, sizeof *found * (size_t)c->count);
    }
    const struct cor_body a = cor_scene_body(&c->scene, 1), b = cor_scene_body(&c->scene, 2);
    c->tangential_stiffness =
        c->contact->stiffness / 3.5 *
        cor_tangential_kappa(a.young_modulus_pa, a.poisson_ratio, b.young_modulus_pa, b.poisson_ratio);
    c->count = c->measured ? c->count : ends;
    if (c->measured && r->scene->end != COR_BOTH_ENDS && c->scene.end != r->scene->end) { /* eps is for the other end */
        number[COR_SCENE_RESTITUTION] = number[COR_SCENE_AT] = NAN;
        c->scene.end = r->scene->end;
    }
    return 1;
}

static int check_name(struct task *task, const char *name)
{
    static const char letters[] = "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ _-.";
    const char *c = name;
    while (*c && (strchr(letters, *c) || (unsigned char)*c > 127))
        c++;
    return (*c == '\0' && c > name && c - name < NUMBER) ||
           refuse_task(task, "'%.40s' is not a name of a material; allowed: up to %d letters, digits, blanks, _ - .",
                       name, NUMBER - 1);
}

/* Checks the materials and their pairs, and finds all contacts. */
static int check_materials(struct task *task)
{
    const struct cor_simulator_request *const r = task->request;
    const size_t types = r->material_count, balls = count_balls(r);
    for (const struct cor_material *m = r->materials; m < r->materials + types; m++) {
        if (!check_name(task, m->name))
            return 0;
        if (is_wall(m) ? !isinf(m->body.radius_m) || !isnan(m->radius_max_m)
                       : isless(m->radius_max_m, m->body.radius_m))
            return refuse_task(task, is_wall(m) ? "%s: a wall has no radius" : "%s: its largest radius is too small",
                               m->name);
        for (const struct cor_material *other = r->materials; other < m; other++)
            if (strcmp(m->name, other->name) == 0)
                return refuse_task(task, "%s: two materials have this name; give each its own", m->name);
    }
    for (size_t k = 0; k < types; k++) {
        const struct cor_material *const m = material_of(r, k);
        const size_t source = source_of(r, k);
        if (m->made_of && (source == types || source == k || material_of(r, source)->made_of))
            return refuse_task(task, "%s: made of '%.40s', which is not another material with its own elasticity",
                               m->name, m->made_of);
    }
    if (balls == 0)
        return refuse_task(task, "no material has balls; give at least one row with a radius that is not a wall");
    if (task->simulator->one_wall && types > balls + 1)
        return refuse_task(task, "%s has one material for all walls; leave out the wall %s", task->simulator->title,
                           material_of(r, balls + 1)->name);
    for (const struct cor_material_pair *p = r->pairs; p < r->pairs + r->pair_count; p++) {
        if (p->a >= types || p->b >= types)
            return refuse_task(task, "a pair names a material that is not in the list of materials");
        const struct cor_material *const a = &r->materials[p->a], *const b = &r->materials[p->b];
        if (is_wall(a) && is_wall(b))
            return refuse_task(task, "%s and %s: two walls never touch; leave out this pair", a->name, b->name);
        for (const struct cor_material_pair *other = r->pairs; other < p; other++)
            if ((p->a == other->a && p->b == other->b) || (p->a == other->b && p->b == other->a))
                return refuse_task(task, "%s and %s: two pairs of these materials; leave out one", a->name, b->name);
    }
    /* turn 0: contacts of two balls of one type, if it has no `made_of`. turn 1: the same if it has `made_of`, because
     * it may use the damping of the type it names. turn 2: contacts of two types. */
    for (int turn = 0; turn < 3; turn++)
        for (size_t i = 0; i < balls; i++)
            for (size_t j = i; j < types; j++)
                if (turn == (i != j ? 2 : material_of(r, i)->made_of != NULL) && !find_contact(task, i, j))
                    return 0;
    return 1;
}

/* Starts the task of one contact. Returns 0 after a refusal of the whole request. */
static int start_contact(struct task *own, struct task *task, size_t i, size_t j)
{
    *own = (struct task){.request = task->request, .slides = task->slides};
    const struct cor_material_contact *const c = own_contact(own, i, j);
    own->own.scene = &c->scene;
    own->own.count = c->count;
    if (check_numbers(own) && check_task(own) && find_speed(own)) {
        memcpy(task->law, own->law, sizeof task->law);
        task->has_law = own->has_law;
        return 1;
    }
    return refuse_contact(task, i, j, own->refusal);
}

/* Finds the numbers of a model for all contacts. *shortest: the contact with the smallest time step, or with an unknown
 * time step (NaN). Returns the rank of the model, or -1 if it is unsuitable. */
static int fill_contacts(struct task *task, const struct cor_simulator_model *model, struct block *shortest)
{
    const size_t types = task->request->material_count, balls = count_balls(task->request);
    int rank = 0;
    *shortest = (struct block){.model = model, .time_step_s = INFINITY};
    for (size_t k = 0; k < balls * types; k++) {
        const size_t i = k / types, j = k % types;
        struct task own;
        struct block block;
        if (j < i)
            continue;
        if (!start_contact(&own, task, i, j) || !model_suits(model, &own, own.has_law))
            return -1;
        if (!fill_block(&block, &own, model))
            return refuse_contact(task, i, j, block.reason) - 1;
        contact_of(task->request, i, j)->number = block.number[PAIR];
        rank += rank_model(model, &own);
        if (isnan(block.time_step_s) || isless(block.time_step_s, shortest->time_step_s))
            *shortest = block;
    }
    return rank;
}

/* Writes eps of a contact between the largest balls of both types, if the number depends on the mass. */
static void put_largest(struct text *t, const struct block *block, const struct task *own)
{
    const struct cor_simulator_model *const model = block->model;
    const struct cor_scene large = scene_of_types(own->request, own->i, own->j, 1);
    struct cor_scene_contact c = own->contact[PAIR][own->request->count > 1 ? (int)model->end : 0];
    const struct cor_scene_contact small = c;
    const double speed = own->request->speeds > 0 ? *own->request->speed_m_s : block->speed_m_s;
    double eps, wanted;
    make_contact(&c, &large, PAIR);
    if (!needs_mass(block, own) || !isgreater(c.mass_kg, small.mass_kg) || !model->damping_of_number)
        return;
    struct cor_scene_contact made = c;
    if (model->id == COR_CHRONO_HERTZ) { /* Chrono's lines contain one radius for all contacts */
        made.stiffness = small.stiffness;
        made.radius_m = small.radius_m;
    }
    made = cor_model_contact(made, own->has_law ? NULL : &cor_law_exponents[model->law],
                             model->damping_of_number(model, block->number[PAIR], &made, speed), speed);
    if (cor_scene_eps(&eps, &made, speed, (int)model->end) == 0 &&
        cor_scene_eps(&wanted, &c, speed, (int)model->end) == 0)
        put_comment(t, "between the largest balls this line realises eps = %s at %s m/s; the materials require %s",
                    TEXT(eps), TEXT(speed), TEXT(wanted));
}

/* Prints the source of a contact's damping, and the resulting eps. */
static void put_contact(struct text *t, const struct block *block, const struct task *own)
{
    const struct cor_simulator_request *const r = own->request;
    const struct cor_material_contact *const c = contact_of(r, own->i, own->j);
    const char *const one = material_of(r, own->i)->name, *const two = material_of(r, own->j)->name;
    const int i = (int)own->i + 1, j = (int)own->j + 1, end = block->model->end == COR_END_ZERO_FORCE;
    const int measured = c->measured && c->measured->end != COR_BOTH_ENDS ? c->measured->end : c->scene.end;
    int ends;
    if (c->measured)
        put_comment(t,
                    isnan(c->measured->at_m_s) ? "%d %d, %s and %s: measured at %s, eps = %s"
                                               : "%d %d, %s and %s: measured at %s, eps = %s at %s m/s",
                    i, j, one, two, measured == COR_BOTH_ENDS ? "this end" : cor_end_names[measured],
                    TEXT(c->measured->restitution), TEXT(c->measured->at_m_s));
    else
        put_comment(t, "%d %d, %s and %s: not measured; the damping follows from the dissipation times %s s and %s s",
                    i, j, one, two, TEXT(dissipation_time(r, own->i, end, &ends)),
                    TEXT(dissipation_time(r, own->j, end, &ends)));
    if (own->slides)
        put_comment(t, "friction %s", TEXT(r->friction));
    put_realised(t, block, own);
    put_oblique(t, block, own);
    put_largest(t, block, own);
    if (has_soft_wall(own))
        put_comment(t, "%s", own->simulator->wall);
}

/* True if a line of a template for several materials is written for types i and j. The first letter of the line selects
 * the types. m: each type; b: each ball; g: each ball, if the scene has a wall; v: each wall. p: each pair of balls; u:
 * each pair of different types; w: each pair of a ball and a wall. c: each contact; f: each contact, if some contact
 * has friction; F: once, if some contact has friction; -: once. */
static int repeats_line(char letter, size_t i, size_t j, size_t balls, size_t types, int slides)
{
    const int contact = i <= j && i < balls;
    return letter == 'm'   ? i == j
           : letter == 'b' ? i == j && i < balls
           : letter == 'g' ? i == j && i < balls && balls < types
           : letter == 'v' ? i == j && i >= balls
           : letter == 'p' ? contact && j < balls
           : letter == 'u' ? contact && i != j
           : letter == 'w' ? contact && j >= balls
           : letter == 'c' ? contact
           : letter == 'f' ? contact && slides
           : letter == 'F' ? i + j == 0 && slides
                           : i + j == 0;
}

static void put_many(struct text *t, const char *template, struct block *block, struct task *task)
{
    const size_t types = task->request->material_count, balls = count_balls(task->request);
    for (; *template; template = strchr(template, '\n') + 1)
        for (size_t k = 0; k < types * types; k++)
            if (repeats_line(*template, k / types, k % types, balls, types, task->slides)) {
                const struct text before = *t;
                turn_to_contact(task, block, k / types, k % types);
                t->known = 1;
                put_line(t, template + 1, block, task, PAIR);
                if (*template == '?' && !t->known)
                    *t = before;
            }
}

/* Prints the block of all contacts: comments, lines and the smallest time step. Returns 0 after a refusal. */
static int put_materials(struct text *t, struct task *task)
{
    const struct cor_simulator_request *const given = task->request;
    const size_t types = given->material_count, balls = count_balls(given);
    const struct cor_simulator *const s = task->simulator;
    struct block block, best = {.model = NULL};
    int rank = -1;
    own_contact(task, 0, 0);
    task->own.friction = given->friction;
    task->own.step_corrected = 0;
    for (int id = COR_TANGENTIAL_MODELS - 1; id > 0 && given->tangential == COR_TANGENTIAL_DISPLACEMENT; id--)
        if (s->tangential >> id & 1 && !(cor_tangential_models[id].constant_stiffness && task->own.tangential))
            task->own.tangential = (enum cor_tangential_id)id;
    if (!check_friction(task))
        return 0;
    for (int i = 0; i < s->model_count; i++) {
        const int suits = s->models[i].many ? fill_contacts(task, &s->models[i], &block) : -1;
        best = suits > rank ? block : best;
        rank = suits > rank ? suits : rank;
    }
    if (!best.model)
        return *task->refusal ? 0 : refuse_task(task, "%s has no model for the law %s", s->title, task->law);
    const struct cor_simulator_model *const model = best.model;
    task->own.step_corrected = given->step_corrected;
    task->own.time_step_s = isless(best.time_step_s, INFINITY) ? best.time_step_s : 0;
    if (fill_contacts(task, model, &block) < 0) /* again, with best.time_step_s for all contacts */
        return 0;
    put_comment(t, "%s, %s (%s): contacts end at %s", s->title, model->model, model->version,
                cor_end_names[model->end]);
    for (size_t k = 0; k < types; k++) {
        const struct cor_material *const m = material_of(given, k);
        put_comment(t,
                    k >= balls               ? "type %d: %s, a wall"
                    : isnan(m->radius_max_m) ? "type %d: %s, radius %s m"
                                             : "type %d: %s, radius %s to %s m",
                    (int)k + 1, m->name, TEXT(m->body.radius_m), TEXT(m->radius_max_m));
    }
    if (!task->has_law)
        put_comment(t, "%s does not have the law of the contacts: the lines hold at one speed.", s->title);
    put_comment(t, "%s", model->advice);
    turn_to_contact(task, &best, 0, 0);
    put_setup(t, &best, task);
    for (size_t k = 0; k < balls * types; k++) {
        struct task own;
        if (k % types >= k / types && start_contact(&own, task, k / types, k % types)) {
            fill_block(&block, &own, model);
            if (k == 0 && needs_mass(&block, &own))
                put_comment(t, "%.*s depends on the masses: each line holds for the radii of its two types.",
                            (int)strcspn(model->parameter, ","), model->parameter);
            put_contact(t, &block, &own);
        }
    }
    put_many(t, model->many, &best, task);
    if (task->own.time_step_s > 0 && s->time_step)
        put_template(t, s->time_step, &best, task);
    else if (task->own.time_step_s > 0)
        put_comment(t, "time step: at most %s s", TEXT(best.time_step_s));
    put_text(t, "\n");
    return 1;
}

long cor_simulator_lines(char *text, size_t size, const struct cor_simulator_request *request)
{
    struct task task = {.request = request};
    struct text t = {text, size, 0, NULL, 0, 1, 1};
    if (request->materials) {
        t.simulator = find_simulator(&task) ? task.simulator : NULL;
        if (t.simulator && check_materials(&task) && put_materials(&t, &task))
            return (long)t.length;
    } else if (find_simulator(&task) && check_numbers(&task) && check_task(&task) && check_friction(&task) &&
               find_speed(&task)) {
        struct cor_simulator_request linear;
        struct cor_scene scene;
        struct cor_scene_contact spring[COR_SCENE_ENDS];
        t.simulator = task.simulator;
        int found = put_all(&t, &task);
        if (!found && !*task.refusal && !(request->friction > 0) && replace_law(&linear, &scene, spring, &task)) {
            put_comment(&t,
                        "%s has no model for the law %s. These lines contain a linear spring instead, whose undamped "
                        "contact has "
                        "the same duration at %s m/s. eps and duration of the contact are right only at this speed.",
                        task.simulator->title, task.law, TEXT(task.target[PAIR].speed_m_s));
            task = (struct task){.request = &linear};
            found = check_task(&task) && find_speed(&task) && put_all(&t, &task);
        }
        if (found) {
            if (request->contacts[0].plastic)
                put_yielding(&t, &task);
            return (long)t.length;
        }
        if (!*task.refusal)
            refuse_task(&task, "%s has no model for the law %s%s", task.simulator->name, task.law,
                        request->version ? " in this version" : "");
    }
    snprintf(text, size, "%s", task.refusal);
    return -1;
}

long cor_simulator_list(char *text, size_t size, const struct cor_simulator *simulator)
{
    struct text t = {text, size, 0, NULL, 0, 1, 1};
    char line[SENTENCE];
    for (const struct cor_simulator *s = cor_simulators; s < cor_simulators + cor_simulator_count; s++) {
        int models = 0, walls = 0;
        for (const struct cor_simulator_model *model = s->models; model < s->models + s->model_count; model++) {
            models += model->lines != NULL;
            walls += model->wall_lines != NULL;
            snprintf(line, sizeof line, "%s (%s, ends at %s%s; %s)\n", model->model, cor_law_name(model->law),
                     cor_end_names[model->end], model->wall_lines ? ", walls too" : "", model->version);
            put_text(&t, model->lines && s == simulator ? line : "");
        }
        snprintf(line, sizeof line, "%-13s  %2d model%s%s%s%s\n", s->name, models, models > 1 ? "s" : "",
                 walls ? ", walls too" : "", s->version ? "; first those of " : "", s->version ? s->version : "");
        put_text(&t, simulator || !s->comment ? "" : line);
    }
    return (long)t.length;
}
