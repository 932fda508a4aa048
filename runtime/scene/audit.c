/* SPDX-License-Identifier: MIT */
/* From the contacts of an input to what they realise: cor_simulators has every formula. */
#include "runtime/scene/audit.h"

#include <math.h>
#include <string.h>

#include "cor/status.h"
#include "runtime/scene/exponents.h"
#include "runtime/scene/simulators.h"

const char *const cor_audit_simulators[] = {"lammps", "liggghts", "yade", "kratos", "mfix", "mujoco", NULL};

/* ---- what readers say ---- */

static struct cor_audit_finding empty_finding(const struct audit *a)
{
    const struct cor_audit_finding none = {a->text.name, a->line,     a->simulator, NULL,        "", (double)NAN,
                                           -1,           (double)NAN, (double)NAN,  (double)NAN, -1, (double)NAN,
                                           (double)NAN,  (double)NAN, (double)NAN,  -1,          "", ""};
    return none;
}

static void report_line(struct audit *a, const char *sentence, const char *word, int as_asked)
{
    struct cor_audit_finding finding = empty_finding(a);
    a->advice[0] = '\0';
    audit_append(a->advice, sizeof a->advice, word ? "$ $" : "$", sentence, word);
    finding.advice = a->advice;
    finding.as_asked = as_asked;
    a->options->report(a->options->context, &finding);
}

void audit_remark(struct audit *a, const char *sentence, const char *word)
{
    a->unsettled++;
    report_line(a, sentence, word, 0);
}

void audit_note(struct audit *a, const char *sentence, const char *word)
{
    report_line(a, sentence, word, -1);
}

struct audit_contact *audit_add(struct audit *a, const char *text)
{
    if (a->contacts == AUDIT_CONTACTS) {
        if (!a->is_full)
            audit_remark(a, "more contacts than can be read; not judged from here on", NULL);
        a->is_full = 1;
        a->contacts--;
    }
    struct audit_contact *const contact = &a->contact[a->contacts++];
    memset(contact, 0, sizeof *contact);
    contact->file = a->text.name;
    contact->text = audit_keep(a, text, strlen(text));
    contact->line = a->line;
    contact->word[0] = contact->word[1] = -1;
    contact->number = contact->stiffness = contact->speed = (double)NAN;
    return contact;
}

void audit_between(struct audit_contact *contact, int i, int j)
{
    contact->first[0] = contact->last[0] = i;
    contact->first[1] = contact->last[1] = j;
}

/* Whether the contact is one of the types i and j, in either order */
int audit_covers(const struct audit_contact *c, int i, int j)
{
    return (c->first[0] <= i && i <= c->last[0] && c->first[1] <= j && j <= c->last[1]) ||
           (c->first[0] <= j && j <= c->last[0] && c->first[1] <= i && i <= c->last[1]);
}

void audit_unknown(struct audit_contact *contact, const char *reason)
{
    contact->unknown = 1;
    contact->fault = reason;
}

void audit_clear_types(struct audit *a)
{
    for (struct audit_type *type = a->type; type < a->type + AUDIT_TYPES; type++)
        type->radius[0] = type->radius[1] = type->density = type->young = type->poisson = (double)NAN;
}

void audit_set_time_step(struct audit *a, double step_s)
{
    if (isnan(a->options->time_step_s))
        a->time_step = step_s;
}

void audit_add_speed(struct audit *a, double speed)
{
    for (int i = 0; i < a->speeds; i++)
        if (a->speed[i] == speed)
            return;
    if (a->speeds < AUDIT_SPEEDS && speed > 0 && isfinite(speed))
        a->speed[a->speeds++] = speed;
}

/* ---- one contact ---- */

static const struct cor_simulator_model *model_named(const char *simulator, const char *name)
{
    for (int id = 0; id < COR_SIMULATOR_MODELS; id++) {
        const enum cor_simulator_model_id of = (enum cor_simulator_model_id)id;
        if (audit_is(cor_simulator_of(of)->name, simulator) && audit_is(cor_simulator_model(of)->model, name))
            return cor_simulator_model(of);
    }
    return NULL;
}

/* The same model in another version */
static const struct cor_simulator_model *other_version(const struct cor_simulator_model *model)
{
    static const char *const pairs[][2] = {{"granular hertz, damping tsuji, releases to July 2026",
                                            "granular hertz, damping tsuji, source after July 2026"},
                                           {"granular hooke, damping tsuji, releases to July 2026",
                                            "granular hooke, damping tsuji, source after July 2026"},
                                           {"Mindlin, en (2023 and later)", "Mindlin, en (before 2023); SudoDEM"}};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        if (audit_is(pairs[i][0], model->model))
            return model_named(cor_simulator_of(model->id)->name, pairs[i][1]);
    return NULL;
}

/* Mass, stiffness and radius of two bodies of the types i and j, the least or the largest of each; NaN: not known. A
 * mass that cancels, as where all numbers are per unit of mass, is 1. */
static struct cor_scene_contact scales_of(const struct audit *a, const struct audit_contact *contact, int i, int j,
                                          int largest)
{
    const struct audit_type *const type[2] = {&a->type[i], &a->type[j]};
    double radius = 0, mass = 0, compliance = 0;
    for (int k = 0; k < 2; k++) {
        const double r = type[k]->radius[largest];
        compliance += (1 - type[k]->poisson * type[k]->poisson) / type[k]->young;
        radius += k && contact->wall ? 0 : 1 / r;
        mass += k && contact->wall ? 0 : 1 / (4 * COR_PI / 3 * pow(r, 3) * type[k]->density);
    }
    struct cor_scene_contact scene = {.mass_kg = 1 / mass, .radius_m = 1 / radius, .damping = (double)NAN};
    const double root = sqrt(scene.radius_m), modulus = 1 / compliance, l = log(contact->number);
    switch (contact->spring) {
    case AUDIT_HOOKE:
        scene.stiffness = contact->stiffness;
        break;
    case AUDIT_HERTZ:
        scene.stiffness = contact->stiffness * root;
        break;
    case AUDIT_MATERIAL:
        scene.stiffness = 4.0 / 3 * modulus * root;
        break;
    case AUDIT_CHARACTERISTIC: {
        const double elastic = 16.0 / 15 * root * modulus;
        scene.stiffness = elastic * pow(scene.mass_kg * contact->speed * contact->speed / elastic, 0.2);
        break;
    }
    case AUDIT_CONTACT_TIME:
        scene.mass_kg = isnan(scene.mass_kg) ? 1 : scene.mass_kg;
        scene.stiffness = scene.mass_kg * (COR_PI * COR_PI + l * l) / (contact->stiffness * contact->stiffness);
        break;
    case AUDIT_PER_MASS:
        scene.mass_kg = 1;
        scene.stiffness = contact->stiffness;
        break;
    case AUDIT_NO_SPRING:
        scene.stiffness = (double)NAN;
        break;
    }
    return scene;
}

static int is_linear(const struct audit_contact *contact)
{
    return contact->spring != AUDIT_HERTZ && contact->spring != AUDIT_MATERIAL;
}

/* eps where MuJoCo's impedance d grows with the overlap x from dmin to dmax at the width, by a parabola and its mirror
 * image: x'' = -d/dmax (2 zeta w x' + d/dmax w^2 x), to the zero of the force. The method of Runge and Kutta; NaN where
 * it takes too many steps. */
static double eps_of_impedance(const double impedance[3], double frequency, double zeta, double speed)
{
    enum { MOST = 200000 };
    const double h = fmin(2e-3 / frequency, 0.02 * impedance[2] / speed);
    double x = 0, v = speed;
    for (int n = 0; n < MOST; n++) {
        double at = x, rate = v, moved = 0, gained = 0, force = 0;
        for (int k = 0; k < 4; k++) {
            static const double weight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}, part[4] = {0.5, 0.5, 1, 0};
            const double y = fmin(fabs(at) / impedance[2], 1), rest = 1 - y;
            const double d = impedance[0] + (impedance[1] - impedance[0]) * (y < 0.5 ? 2 * y * y : 1 - 2 * rest * rest);
            const double share = d / impedance[1];
            force = share * frequency * (2 * zeta * rate + share * frequency * at);
            if (k == 0 && n > 0 && !(force > 0))
                return fmin(-v / speed, 1);
            moved += weight[k] * h * rate;
            gained -= weight[k] * h * force;
            at = x + part[k] * h * rate;
            rate = v - part[k] * h * force;
        }
        x += moved;
        v += gained;
    }
    return (double)NAN;
}

/* Sets what a contact realises at one speed, in the units of the text: its end, law, damping, eps and duration. Returns
 * the contact. */
static struct cor_scene_contact solve(struct cor_audit_finding *f, const struct audit *a,
                                      const struct cor_simulator_model *model, const struct audit_contact *contact,
                                      struct cor_scene_contact scene, double speed)
{
    scene.law = cor_law_exponents[model->law];
    scene.solver = a->options->solver;
    f->end = contact->limited ? COR_END_ZERO_FORCE : (int)model->end;
    f->law = (int)model->law;
    if (model->law == COR_LAW_TSUJI && contact->spring != AUDIT_NO_SPRING && is_linear(contact))
        scene.law = cor_law_exponents[COR_LAW_LINEAR];
    if (!model->damping_of_e)
        f->damping = model->damping_of_number(contact->number, &scene, speed);
    else if (contact->number >= model->least && contact->number <= model->most)
        f->damping = model->damping_of_e(contact->number);
    const double damping = f->damping, at = isnan(speed) ? 1 : speed;
    if (!(damping >= 0 && damping < INFINITY) || (isnan(speed) && !cor_law_is_constant(&scene.law)))
        return scene;
    if (contact->impedance[2] > 0) {
        if (!isnan(speed))
            f->realised = eps_of_impedance(contact->impedance, sqrt(scene.stiffness), damping, speed);
        f->damping = (double)NAN; /* it depends on the overlap */
        return scene;
    }
    scene = cor_model_contact(scene, NULL, damping, speed);
    if (f->end >= (int)COR_SCENE_ENDS) {
        f->realised = cor_law_eps(model->law, model->end, damping);
        return scene;
    }
    struct cor_scene_impact impact;
    if (cor_scene_impact(&impact, &scene, at) == COR_OK) {
        f->realised = impact.eps[f->end];
        /* without a speed only a linear spring has one duration */
        f->duration_s = isnan(speed) && !is_linear(contact) ? (double)NAN : impact.duration_s[f->end];
    } else {
        cor_scene_eps(&f->realised, &scene, at, f->end);
    }
    return scene;
}

/* ---- advice ---- */

/* The text of a contact with its e replaced */
static void write_instead(struct audit *a, const struct audit_contact *contact, double e)
{
    int word = 0;
    for (const char *at = contact->text; *at;) {
        const size_t blank = strspn(at, " ");
        audit_append(a->instead, sizeof a->instead, blank ? " " : "");
        at += blank;
        const size_t size = strcspn(at, " "), used = strlen(a->instead), left = sizeof a->instead - used;
        if (word == contact->word[0] || word == contact->word[1])
            audit_append(a->instead, sizeof a->instead, "%", e);
        else
            audit_append(a->instead + used, size + 1 < left ? size + 1 : left, "$", at);
        at += size;
        word++;
    }
}

static void advise_asked(struct audit *a, const struct cor_simulator_model *model, const struct audit_contact *contact,
                         double realised)
{
    enum cor_simulator_status status;
    struct cor_simulator_model ended = *model;
    if (contact->limited)
        ended.end = COR_END_ZERO_FORCE;
    const double e = cor_simulator_e(&ended, contact->number, &status);
    if (isnan(realised))
        audit_say(a, "$ accepts e from % to %.", a->simulator, model->least, model->most);
    else
        audit_say(a, "e = % realises %.", contact->number, realised);
    if (!isnan(e) && contact->word[0] >= 0)
        write_instead(a, contact, e);
    else if (isnan(e))
        audit_say(a, "No e realises it here.");
}

/* What is missing for eps, or for the duration */
static void advise_missing(struct audit *a, const struct cor_scene_contact *scene, double speed)
{
    const int scales = !(scene->mass_kg > 0 && scene->stiffness > 0);
    audit_say(a, scales && isnan(scene->radius_m)  ? "The radius is not in the text: give --radius."
                 : scales && isnan(scene->mass_kg) ? "The density is not in the text: give --density."
                 : scales                          ? "The stiffness could not be read."
                 : isnan(speed)                    ? "eps depends on the impact speed: give --speed."
                                                   : "This law has no function in libcor.");
}

/* ---- the time step ---- */

enum { PHASES = 128, PHASES_LEAST = 16, STEPS_OF_PHASES = 1 << 20 }; /* of cor_scene_step_error */
#define STEPS_IN_ALL 2e8                                             /* some seconds */
#define STEPS_OF_SEARCH 2e7                                          /* of cor_scene_step_for, with this tolerance */
#define LEAST_SEARCHED 1e-4

/* Adds the error of the time step. Returns whether eps stays as near as the tolerance allows to what is asked, or, if
 * nothing is, to what a time step of zero realises. */
static int add_step(struct audit *a, struct cor_audit_finding *f, const struct cor_scene_contact *scene, double speed)
{
    const double at = isnan(speed) ? 1 : speed, step = a->time_step / a->time;
    const double elastic = cor_scene_elastic_duration_s(scene, at), steps = elastic / step;
    const double collision = f->duration_s / step, wished = isnan(f->asked) ? f->realised : f->asked;
    const double allowed = a->options->tolerance * wished;
    struct cor_step_error error;
    /* without a speed the duration is NaN where the number of steps depends on it */
    if (a->integrator == COR_NO_INTEGRATOR || !(collision > 0 && collision < INFINITY))
        return 1;
    if (steps < COR_SCENE_STEPS_MIN) {
        audit_say(a, "The contact takes less than two time steps: eps is left to chance.");
        return 0;
    }
    const double cost = fmax(PHASES_LEAST * collision, fmin(PHASES * collision, STEPS_OF_PHASES));
    if (cost > a->steps_left || cor_scene_step_error(&error, scene, at, f->end, steps, a->integrator) != COR_OK)
        return 1;
    a->steps_left -= cost;
    f->step_bias = error.bias;
    f->step_scatter = error.scatter;
    if (fabs(f->realised + error.bias - wished) <= allowed && error.scatter <= allowed)
        return 1;
    if (fabs(error.bias) <= allowed && error.scatter <= allowed)
        return 0; /* it is not the step that is to blame */
    audit_say(a, "The time step makes eps % in the mean, with the standard deviation %.", f->realised + error.bias,
              error.scatter);
    double least;
    if (allowed >= LEAST_SEARCHED && a->steps_left >= STEPS_OF_SEARCH) {
        a->steps_left -= STEPS_OF_SEARCH;
        if (cor_scene_step_for(&least, scene, at, f->end, allowed, a->integrator) == COR_OK)
            audit_say(a, "A time step of % or less keeps both errors below %.", elastic / least, allowed);
    }
    return 0;
}

/* ---- reports ---- */

static void report(struct audit *a, const struct audit_contact *contact, struct cor_scene_contact scene, double speed)
{
    const struct cor_simulator_model *model = contact->model ? model_named(a->simulator, contact->model) : NULL;
    const struct cor_simulator_model *other = model ? other_version(model) : NULL;
    const long version = a->options->version;
    if (other && !cor_model_has_version(model, version))
        model = other;
    const double speed_here = speed * a->time / a->length; /* in the units of the text */
    struct cor_audit_finding f = empty_finding(a);
    f.file = contact->file;
    f.line = contact->line;
    f.pair = a->pair;
    f.speed_m_s = speed;
    f.time_step_s = a->time_step;
    a->advice[0] = a->instead[0] = a->model[0] = '\0';
    audit_append(a->model, sizeof a->model, "$$",
                 model            ? model->model
                 : contact->model ? contact->model
                                  : "",
                 model && contact->limited ? ", limit_damping" : "");
    if (contact->impedance[2] > 0) {
        a->model[strcspn(a->model, "=")] = '\0';
        audit_append(a->model, sizeof a->model, "$", "< dmax");
    }
    f.model = a->model;
    if (contact->fault)
        audit_say(a, contact->fault);
    f.as_asked = 0;
    if (model && !cor_model_has_version(model, version))
        audit_say(a, "This version does not have the model.");
    if (model && model->damping_of_e)
        f.asked = contact->number;
    if (model && !contact->unknown) {
        scene = solve(&f, a, model, contact, scene, speed_here);
        if (model->damping_of_e) {
            f.as_asked = fabs(f.realised - f.asked) <= a->options->tolerance * f.asked;
            if (!f.as_asked)
                advise_asked(a, model, contact, f.realised);
            f.as_asked = add_step(a, &f, &scene, speed_here) && f.as_asked;
            if (other && version == 0)
                audit_say(a, "The model $ realises %.", other->model, cor_simulator_realised(other, contact->number));
        } else if (isnan(f.realised)) {
            advise_missing(a, &scene, speed);
        } else {
            f.as_asked = -1;
            add_step(a, &f, &scene, speed_here);
            if (!cor_law_is_constant(&scene.law))
                audit_say(a, model->advice);
        }
        f.duration_s *= a->time;
    }
    a->found++;
    a->unsettled += f.as_asked == 0;
    f.advice = a->advice;
    f.instead = a->instead;
    a->options->report(a->options->context, &f);
}

static int same_number(double x, double y)
{
    return x == y || (isnan(x) && isnan(y));
}

static int same_type(const struct audit_type *x, const struct audit_type *y)
{
    return same_number(x->radius[0], y->radius[0]) && same_number(x->radius[1], y->radius[1]) &&
           same_number(x->density, y->density) && same_number(x->young, y->young) &&
           same_number(x->poisson, y->poisson);
}

/* Whether a later line says something else of this pair */
static int is_overridden(const struct audit *a, const struct audit_contact *contact, int i, int j)
{
    for (const struct audit_contact *next = contact + 1; next < a->contact + a->contacts; next++)
        if (!contact->wall && !next->wall && !contact->pair && !next->pair && audit_covers(next, i, j))
            return 1;
    return 0;
}

static void name_types(struct audit *a, const struct audit_contact *contact, int i, int j, const int all[2], int size)
{
    static const char *const sizes[] = {"", ", least", ", largest"};
    const int type[2] = {i, j};
    a->pair[0] = '\0';
    if (contact->pair) {
        audit_append(a->pair, sizeof a->pair, "$", contact->pair);
        return;
    }
    for (int k = 0; k < 2; k++) {
        const char *const name = k && contact->wall ? "wall" : all && all[k] ? "*" : a->type[type[k]].name;
        audit_append(a->pair, sizeof a->pair, k ? "-" : "");
        if (name)
            audit_append(a->pair, sizeof a->pair, "$", name);
        else
            audit_append(a->pair, sizeof a->pair, "%", (double)(type[k] + 1));
    }
    audit_append(a->pair, sizeof a->pair, "$", sizes[size]);
}

static void report_pair(struct audit *a, const struct audit_contact *contact, int i, int j, const int all[2])
{
    const int one_size = same_number(a->type[i].radius[0], a->type[i].radius[1]) &&
                         same_number(a->type[j].radius[0], a->type[j].radius[1]);
    const size_t given = a->options->speeds, speeds = given ? given : (size_t)a->speeds;
    for (int largest = 0; largest < (one_size ? 1 : 2); largest++) {
        const struct cor_scene_contact scales = scales_of(a, contact, i, j, largest);
        name_types(a, contact, i, j, all, one_size ? 0 : 1 + largest);
        for (size_t k = 0; k < (speeds > 0 ? speeds : 1); k++)
            report(a, contact, scales, speeds == 0 ? (double)NAN : given ? a->options->speed_m_s[k] : a->speed[k]);
    }
}

static void report_contact(struct audit *a, struct audit_contact *contact)
{
    int alike = 1, all[2];
    for (int k = 0; k < 2; k++) {
        const int most = a->types > 0 ? a->types - 1 : 0, many = contact->first[k] < contact->last[k];
        contact->first[k] = contact->first[k] < AUDIT_TYPES ? contact->first[k] : AUDIT_TYPES - 1;
        if (contact->last[k] > most)
            contact->last[k] = contact->first[k] > most ? contact->first[k] : most;
        all[k] = many && (a->types == 0 || contact->first[k] < contact->last[k]);
        for (int i = contact->first[k]; i <= contact->last[k]; i++)
            alike = alike && (!is_overridden(a, contact, i, contact->first[1 - k])) &&
                    same_type(&a->type[i], &a->type[contact->first[0]]);
    }
    if (alike) {
        report_pair(a, contact, contact->first[0], contact->first[1], all);
        return;
    }
    for (int i = contact->first[0]; i <= contact->last[0]; i++)
        for (int j = contact->first[1]; j <= contact->last[1]; j++) {
            const int twice = j < i && j >= contact->first[0] && i <= contact->last[1];
            if (!twice && !is_overridden(a, contact, i, j))
                report_pair(a, contact, i, j, NULL);
        }
}

void audit_flush(struct audit *a)
{
    const double length = a->length, density = a->mass / (length * length * length);
    /* bodies of which the text does not say enough are those of the options */
    for (struct audit_type *type = a->type; type < a->type + AUDIT_TYPES; type++) {
        if (isnan(type->radius[0]))
            type->radius[0] = type->radius[1] = a->options->radius_m / length;
        if (isnan(type->density))
            type->density = a->options->density_kg_m3 / density;
    }
    for (int i = 0; i < a->contacts; i++)
        report_contact(a, &a->contact[i]);
    a->contacts = 0;
}

/* ---- the whole text ---- */

static int contains(const struct cor_audit_text *text, const char *word)
{
    const size_t size = strlen(word);
    for (size_t i = 0; i + size <= text->size; i++)
        if (memcmp(text->text + i, word, size) == 0)
            return 1;
    return 0;
}

static const char *simulator_of(const struct cor_audit_text *text)
{
    static const char *const signs[][2] = {{"property/global", "liggghts"},
                                           {"particletemplate/", "liggghts"},
                                           {"pair_style gran model", "liggghts"},
                                           {"pair_style", "lammps"},
                                           {"wall/gran", "lammps"},
                                           {"O.engines", "yade"},
                                           {"Ip2_", "yade"},
                                           {"ViscElMat(", "yade"},
                                           {"<mujoco", "mujoco"},
                                           {"DES_EN_", "mfix"},
                                           {"des_en_", "mfix"},
                                           {"\"COEFFICIENT_OF_RESTITUTION\"", "kratos"},
                                           {"\"DAMPING_GAMMA\"", "kratos"}};
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++)
        if (contains(text, signs[i][0]))
            return signs[i][1];
    return NULL;
}

int cor_audit(struct cor_audit_memory *memory, const struct cor_audit_text *text,
              const struct cor_audit_options *options)
{
    typedef char audit_fits_into_its_memory[sizeof(struct audit) <= sizeof(struct cor_audit_memory) ? 1 : -1];
    static void (*const readers[])(struct audit *) = {audit_script, audit_script, audit_yade,
                                                      audit_kratos, audit_mfix,   audit_mujoco};
    struct audit *const a = (struct audit *)(void *)memory;
    (void)sizeof(audit_fits_into_its_memory);
    memset(a, 0, sizeof *a);
    a->options = options;
    a->text = *text;
    a->next_line = 1;
    a->time_step = options->time_step_s;
    a->steps_left = STEPS_IN_ALL;
    a->length = a->mass = a->time = 1;
    a->simulator = options->simulator ? options->simulator : simulator_of(text);
    audit_clear_types(a);
    if (text->size > 0 && memchr(text->text, '\0', text->size))
        return COR_AUDIT_NOT_TEXT;
    if (!a->simulator)
        return COR_AUDIT_UNKNOWN;
    a->integrator = COR_NO_INTEGRATOR;
    for (size_t i = 0; i < cor_simulator_count; i++)
        if (audit_is(cor_simulators[i].name, a->simulator))
            a->integrator = cor_simulators[i].integrator;
    for (size_t i = 0; cor_audit_simulators[i]; i++)
        if (audit_is(cor_audit_simulators[i], a->simulator))
            readers[i](a);
    audit_flush(a);
    if (a->found == 0)
        return COR_AUDIT_NO_CONTACT;
    return a->unsettled ? COR_AUDIT_NOT_AS_ASKED : COR_AUDIT_AS_ASKED;
}
