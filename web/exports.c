/* SPDX-License-Identifier: MIT */
/* The functions that web/cor.js calls. A text that is returned is valid until the next call. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "runtime/core/laws.h"
#include "runtime/scene/simulators.h"
#include "web/web.h"

/* ---- text ---- */

/* The largest text, of 64 speeds for 8 materials, has less than 200,000 characters. */
static char text[1 << 20];
static size_t length;

__attribute__((format(printf, 1, 2))) static void put(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    const size_t more = (size_t)vsnprintf(text + length, sizeof text - length, format, list);
    length += more < sizeof text - length ? more : 0;
    va_end(list);
}

static void clear_text(void)
{
    length = 0;
    text[0] = '\0';
}

static void put_number(double x, int digits)
{
    if (isnan(x))
        put("nan"); /* printf may add a sign */
    else
        put("%.*g", digits, x);
}

static void put_cell(char before, double x, int digits)
{
    put("%c", before);
    put_number(x, digits);
}

/* Writes the fewest digits, at least 15, that read back to the same double. */
static void put_exact(double x)
{
    char exact[40];
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(exact, sizeof exact, "%.*g", digits, x);
        if (strtod(exact, NULL) == x)
            break;
    }
    put("%s", exact);
}

/* ---- the contact ---- */

/* Returns the name of an end of the contact, as in columns. 0: "zero_overlap". 1: "zero_force" or "surface". */
WEB_EXPORT(web_end) const char *web_end(int end)
{
    return cor_scene_end_name(&web_now.contact[0], end);
}

/* Returns csv: the name and the unit of every number that a request may have */
WEB_EXPORT(web_options) const char *web_options(void)
{
    clear_text();
    for (int i = 0; i < COR_SCENE_NUMBERS; i++)
        put("%s,%s\n", cor_scene_options[i].name, cor_scene_options[i].unit);
    put("speed,m/s\nspeed-min,m/s\nspeed-max,m/s\n");
    return text;
}

static void put_quantity(const char *name, const char *end, const double value[COR_SCENE_ENDS], const char *unit,
                         int digits)
{
    if (isnan(value[0]))
        return;
    put("%s%s", name, end);
    for (int k = 0; k < web_now.count; k++)
        put_cell(',', value[k], digits);
    put(",%s\n", unit);
}

/* Returns the csv of corgen contact without --speed. */
WEB_EXPORT(web_summary) const char *web_summary(int digits)
{
    const struct cor_scene_contact *const c = web_now.contact;
    const double step = cor_scene_rayleigh_step_s(&web_now.scene);
    const double tabor = cor_scene_tabor_number(c, web_now.scene.number[COR_SCENE_ADHESION], COR_TABOR_DISTANCE_M);
    clear_text();
    put(web_now.count == 1 ? "quantity,value,unit\n" : "quantity,value_%s,value_%s,unit\n", web_end(0), web_end(1));
    for (int i = 0; i < COR_SCENE_QUANTITIES; i++) {
        const int number = cor_scene_quantities[i].number, second = number == COR_SCENE_STICKING_ZERO_FORCE;
        const int sticking = second || number == COR_SCENE_STICKING_ZERO_OVERLAP;
        const double value[] = {cor_scene_quantity(&c[0], number), cor_scene_quantity(&c[web_now.count - 1], number)};
        put_quantity(sticking ? "sticking_speed_" : cor_scene_quantities[i].name, sticking ? web_end(second) : "",
                     value, cor_scene_quantities[i].unit, digits);
    }
    put_quantity("rayleigh_time_step", "", (double[]){step, step}, "s", digits);
    put_quantity("tabor_number", "", (double[]){tabor, tabor}, "1", digits);
    return text;
}

/* Writes an end of the contact as an option: "zero-overlap", "zero-force" or "surface". */
static void put_end(int end)
{
    for (const char *c = web_end(end); *c; c++)
        put("%c", *c == '_' ? '-' : *c);
}

/* A curve of eps as a function of the speed: the number of its contact, and its end of contact */
struct curve {
    int contact, end;
};

/* Fills the curves: the requested ends, or one end if eps is the same at both. Returns their number. */
static int find_curves(struct curve curve[COR_SCENE_ENDS])
{
    int count = 0;
    for (int end = 0; web_now.count > 0 && end < COR_SCENE_ENDS; end++) {
        const struct curve here = {web_now.count > 1 ? end : 0, end};
        const struct cor_scene_contact *const contact = &web_now.contact[here.contact];
        if ((web_now.scene.end == COR_BOTH_ENDS || web_now.scene.end == end) && cor_scene_has_end(contact, end) &&
            (count == 0 || cor_scene_ends_differ(contact)))
            curve[count++] = here;
    }
    return count;
}

/* ---- impacts ---- */

enum { BETA, EPS, DURATION = EPS + COR_SCENE_ENDS, OVERLAP = DURATION + COR_SCENE_ENDS, FORCE, TIME_STEP, COLUMNS };

/* Returns the contact. Mass and stiffness are 1 if they are not known. */
static struct cor_scene_contact timed(int contact)
{
    struct cor_scene_contact c = web_now.contact[contact];
    if (isnan(c.mass_kg))
        c.mass_kg = c.stiffness = 1;
    return c;
}

/* Returns the time step in the units of timed(): the shortest duration divided by the number of steps. */
static double step_of(const double *speed_m_s, size_t n)
{
    double least = INFINITY;
    for (int k = 0; k < web_now.count; k++)
        for (size_t i = 0; i < n; i++) {
            const struct cor_scene_contact c = timed(k);
            struct cor_scene_impact impact;
            cor_scene_impact(&impact, &c, speed_m_s[i]);
            least = fmin(least, fmin(impact.duration_s[0], impact.duration_s[1]));
        }
    return least / web_now.steps;
}

/* Fills `y` with columns of n numbers: beta, eps at both ends, durations, largest overlap and force, time step. The
 * columns of a second contact follow. The time step is the shortest duration divided by the number of steps. */
WEB_EXPORT(web_impacts) void web_impacts(const double *speed_m_s, double *y, size_t n)
{
    const double step = isnan(web_now.contact[0].mass_kg) ? (double)NAN : step_of(speed_m_s, n);
    for (int k = 0; k < web_now.count; k++) {
        double *const column = y + (size_t)(k * COLUMNS) * n;
        for (size_t i = 0; i < n; i++) {
            struct cor_scene_impact impact;
            cor_scene_impact(&impact, &web_now.contact[k], speed_m_s[i]);
            column[BETA * n + i] = impact.beta;
            column[OVERLAP * n + i] = impact.max_overlap_m;
            column[FORCE * n + i] = cor_scene_force_max_n(&web_now.contact[k], speed_m_s[i]);
            column[TIME_STEP * n + i] = isinf(step) ? (double)NAN : step;
            for (size_t end = 0; end < COR_SCENE_ENDS; end++) {
                column[(EPS + end) * n + i] = impact.eps[end];
                column[(DURATION + end) * n + i] = impact.duration_s[end];
            }
        }
    }
}

static int integrator(void)
{
    return web_now.simulator ? web_now.simulator->integrator : COR_VERLET_HALF_STEP;
}

#define STEPS_ON_PAGE 2e4 /* steps in a contact; more would block the page for seconds */

/* Computes bias and scatter of eps at time_step_s; NaN: at the step of the request, but not above STEPS_ON_PAGE steps.
 * y receives n of each for every curve. */
WEB_EXPORT(web_step_errors)
void web_step_errors(const double *speed_m_s, double *y, size_t n, double time_step_s)
{
    struct curve curve[COR_SCENE_ENDS];
    const int count = find_curves(curve);
    const double most = isnan(time_step_s) ? STEPS_ON_PAGE * (1 + 1e-9) : (double)INFINITY;
    const double time_step = isnan(time_step_s) ? step_of(speed_m_s, n) : time_step_s;
    for (int k = 0; k < count; k++, y += 2 * n)
        for (size_t i = 0; i < n; i++) {
            const struct cor_scene_contact contact =
                isnan(time_step_s) ? timed(curve[k].contact) : web_now.contact[curve[k].contact];
            const double steps = cor_scene_elastic_duration_s(&contact, speed_m_s[i]) / time_step;
            struct cor_step_error error = {NAN, NAN, NAN, NAN};
            struct cor_scene_impact impact;
            cor_scene_impact(&impact, &contact, speed_m_s[i]);
            if (integrator() != COR_NO_INTEGRATOR && steps > 0 && impact.duration_s[curve[k].end] / time_step <= most)
                cor_scene_step_error(&error, &contact, speed_m_s[i], curve[k].end, steps, integrator());
            y[i] = error.bias;
            y[n + i] = error.scatter;
        }
}

/* Returns the csv of corgen contact with the speeds of the request; `errors`: with the columns of --steps. */
WEB_EXPORT(web_table) const char *web_table(int digits, int errors)
{
    enum { STEP_DIGITS = 4 };
    static double y[COR_SCENE_ENDS * COLUMNS * WEB_SPEEDS], error[2 * COR_SCENE_ENDS * WEB_SPEEDS];
    struct curve curve[COR_SCENE_ENDS];
    const size_t ends = (size_t)find_curves(curve);
    const size_t n = web_now.speeds, contacts = (size_t)web_now.count, more = errors ? 2 * ends / contacts : 0;
    const int spheres = !isnan(web_now.contact[0].radius_m) && !(web_now.contact[0].adhesion_j_m2 > 0);
    clear_text();
    put("speed_m_s,beta,eps_%s,eps_%s,duration_s_%s,duration_s_%s,max_overlap_m,max_force_n,time_step_s", web_end(0),
        web_end(1), web_end(0), web_end(1));
    for (int end = 0; more == 4 && end < COR_SCENE_ENDS; end++)
        put(",step_bias_%s,step_scatter_%s", web_end(end), web_end(end));
    put("%s%s%s\n", more == 2 ? ",step_bias,step_scatter" : "", contacts > 1 ? ",measured_end" : "",
        spheres ? ",contact_radius_m,max_pressure_pa" : "");
    if (n > 0)
        web_impacts(web_now.speed_m_s, y, n);
    if (n > 0 && errors)
        web_step_errors(web_now.speed_m_s, error, n, (double)NAN);
    for (size_t row = 0; row < contacts * n; row++) {
        const size_t k = row / n, i = row % n;
        put_exact(web_now.speed_m_s[i]);
        for (size_t c = 0; c < COLUMNS; c++)
            put_cell(',', y[(k * COLUMNS + c) * n + i], digits);
        for (size_t c = 0; c < more; c++)
            put_cell(',', error[(more * k + c) * n + i], STEP_DIGITS);
        if (contacts > 1) {
            put(",");
            put_end((int)k);
        }
        if (spheres) {
            const double overlap = y[(k * COLUMNS + OVERLAP) * n + i];
            put_cell(',', cor_scene_contact_radius(&web_now.contact[k], overlap), digits);
            put_cell(',', cor_scene_pressure(&web_now.contact[k], overlap), digits);
        }
        put("\n");
    }
    return text;
}

/* Computes eps of contact 0 or 1 at one end. */
WEB_EXPORT(web_eps) void web_eps(const double *speed_m_s, double *y, size_t n, int contact, int end)
{
    for (size_t i = 0; i < n; i++)
        cor_scene_eps(&y[i], &web_now.contact[contact], speed_m_s[i], end);
}

/* ---- simulators ---- */

/* The speed, the end and the eps that a user would set as e */
struct asked {
    double speed_m_s, eps;
    int end;
};

static struct asked find_asked(const struct web_request *r)
{
    const double at = r->scene.number[COR_SCENE_AT], given = r->scene.number[COR_SCENE_RESTITUTION];
    struct asked a = {!isnan(at)      ? at
                      : r->speeds > 0 ? r->speed_m_s[0]
                                      : 1,
                      given, r->scene.end == COR_BOTH_ENDS ? COR_END_ZERO_OVERLAP : r->scene.end};
    if (isnan(given))
        cor_scene_eps(&a.eps, &r->contact[0], a.speed_m_s, a.end);
    return a;
}

/* Returns the next model of the request's simulator and version that has an input e, or NULL. *next: 0 at first */
static const struct cor_simulator_model *next_model(const struct web_request *r, int *next)
{
    const long version = *r->version ? cor_simulator_version(r->version) : 0;
    while (r->simulator && *next < r->simulator->model_count) {
        const struct cor_simulator_model *const model = &r->simulator->models[(*next)++];
        if (model->damping_of_e && !model->has_function && cor_model_has_version(model, version))
            return model;
    }
    return NULL;
}

/* Returns eps at a speed if the requested eps is set as e; NaN if the model refuses this e. */
static double find_realised(const struct cor_simulator_model *model, const struct web_request *r, double speed_m_s)
{
    const struct asked asked = find_asked(r);
    const double own = cor_simulator_realised(model, asked.eps);
    double eps = NAN;
    if (model->law == COR_LAW_IMPULSE || isnan(own) || cor_law_is_constant(&cor_law_exponents[model->law]))
        return own;
    const struct cor_scene_contact c = cor_model_contact(r->contact[0], &cor_law_exponents[model->law],
                                                         model->damping_of_e(asked.eps), asked.speed_m_s);
    if (model->end == COR_END_ZERO_OVERLAP || model->end == COR_END_ZERO_FORCE)
        cor_scene_eps(&eps, &c, speed_m_s, (int)model->end);
    return eps;
}

/* Returns csv with a row for each law and each simulator: the option (law or for), its word, and a name for readers. A
 * simulator's row ends with the integrator that web_step_errors uses, or "" if its errors are NaN. */
WEB_EXPORT(web_choices) const char *web_choices(void)
{
    static const char *const labels[] = {COR_CONTACT_LAWS(COR_LAW_LABEL)};
    clear_text();
    for (int law = 0; law <= COR_LAW_PLATE; law++)
        put("law,%s,%s\n", cor_law_name((enum cor_law)law), labels[law]);
    put("for,,choose one,%s\n", cor_integrator_names[COR_VERLET_HALF_STEP]);
    for (size_t i = 0; i < cor_simulator_count; i++)
        if (cor_simulators[i].comment)
            put("for,%s,%s,%s\n", cor_simulators[i].name, cor_simulators[i].title,
                cor_simulators[i].integrator == COR_NO_INTEGRATOR ? ""
                                                                  : cor_integrator_names[cor_simulators[i].integrator]);
    return text;
}

/* Returns the requested eps, its speed and end. Then follow the models of the simulator: number, name, version, law,
 * end, the realised eps, and the e that gives the requested eps. Tabs separate the columns. */
WEB_EXPORT(web_models) const char *web_models(int digits)
{
    const struct asked asked = find_asked(&web_now);
    clear_text();
    put_number(asked.eps, digits);
    put_cell('\t', asked.speed_m_s, digits);
    put("\t%s\n", cor_end_names[asked.end]);
    int next = 0, row = 0;
    for (const struct cor_simulator_model *model; (model = next_model(&web_now, &next));) {
        enum cor_simulator_status status;
        put("%d\t%s\t%s\t%s\t%s", ++row, model->model, model->version ? model->version : "", cor_law_name(model->law),
            cor_end_names[model->end]);
        put_cell('\t', find_realised(model, &web_now, asked.speed_m_s), digits);
        put_cell('\t', cor_simulator_e(model, asked.eps, &status), digits);
        put("\n");
    }
    return text;
}

static struct cor_simulator_request request_of(const struct cor_scene *scene)
{
    const struct web_request *const r = &web_now;
    return (struct cor_simulator_request){.simulator = r->simulator ? r->simulator->name : "",
                                          .version = *r->version ? r->version : NULL,
                                          .scene = scene,
                                          .speed_m_s = r->speed_m_s,
                                          .speeds = r->speeds,
                                          .steps = r->steps,
                                          .integrator = COR_NO_INTEGRATOR};
}

static const char *put_lines(const struct cor_simulator_request *lines)
{
    const long all = cor_simulator_lines(web_wrong.text, sizeof web_wrong.text, lines);
    snprintf(web_wrong.option, sizeof web_wrong.option, lines->materials ? "materials" : "for");
    if (all < 0 || all >= (long)sizeof text)
        return NULL;
    cor_simulator_lines(text, sizeof text, lines);
    return text;
}

/* Returns the text of corgen contact --for, or NULL with the reason in web_why. step_errors: as with --steps */
WEB_EXPORT(web_lines) const char *web_lines(int step_errors)
{
    struct cor_simulator_request lines = request_of(&web_now.scene);
    lines.contacts = web_now.contact;
    lines.count = web_now.count;
    lines.step_errors = step_errors || web_now.steps_given;
    return put_lines(&lines);
}

/* Returns the lines of several materials in one block, or NULL like web_lines. names: one name in a line. number: for
 * each of the n/6 materials Young's modulus, Poisson's ratio, density, radius (NaN: a wall), eps (NaN: not known) and
 * its speed. eps is between two balls of the material, or between the wall and a ball of any material. */
WEB_EXPORT(web_block) const char *web_block(char *names, const double *number, size_t n)
{
    enum { MOST = 8, NUMBERS = 6 };
    static struct cor_material material[MOST];
    static struct cor_material_pair pair[MOST * MOST];
    static struct cor_material_contact memory[MOST * MOST];
    struct cor_scene scene = {.law = web_now.scene.law, .end = web_now.scene.end};
    const size_t count = n / NUMBERS < MOST ? n / NUMBERS : MOST;
    size_t pairs = 0;
    for (int i = 0; i < COR_SCENE_NUMBERS; i++)
        scene.number[i] = NAN;
    for (size_t i = 0; i < count; i++) {
        const double *const x = number + NUMBERS * i, radius = isnan(x[3]) ? (double)INFINITY : x[3];
        const double mass = isnan(x[3]) ? (double)INFINITY : cor_sphere_mass_kg(x[3], x[2]);
        material[i] =
            (struct cor_material){strtok(i == 0 ? names : NULL, "\n"), {x[0], x[1], NAN, radius, mass}, NAN, NULL};
        for (size_t ball = 0; ball < count && !isnan(x[4]); ball++)
            if (isnan(x[3]) ? !isnan(number[NUMBERS * ball + 3]) : ball == i)
                pair[pairs++] = (struct cor_material_pair){ball, i, x[4], x[5], COR_BOTH_ENDS, NAN};
    }
    struct cor_simulator_request lines = request_of(&scene);
    lines.materials = material;
    lines.pairs = pair;
    lines.material_count = count;
    lines.pair_count = pairs;
    lines.memory = memory;
    return put_lines(&lines);
}

/* ---- curves of eps as a function of the speed ---- */

/* Returns a line for each curve of the contact, with tabs. The first column is the end, or eps if both ends have the
 * same eps. The second is the end as an option. The third is eps, if it is the same at every speed. */
WEB_EXPORT(web_curves) const char *web_curves(void)
{
    struct curve curve[COR_SCENE_ENDS];
    const int count = find_curves(curve);
    clear_text();
    for (int i = 0; i < count; i++) {
        const struct cor_scene_contact *const contact = &web_now.contact[curve[i].contact];
        double eps;
        put("%s\t", cor_scene_ends_differ(&web_now.contact[0]) ? web_end(curve[i].end) : "eps");
        put_end(curve[i].end);
        put("\t");
        if ((contact->damping == 0 || (cor_law_is_constant(&contact->law) && !(contact->force_n > 0))) &&
            cor_scene_eps(&eps, contact, 1, curve[i].end) == 0)
            put_exact(eps);
        put("\n");
    }
    return text;
}

/* Fills eps of curve i at n speeds: of the contact, then of the models in the order of web_models. */
WEB_EXPORT(web_curve) void web_curve(const double *speed_m_s, double *y, size_t n, int i)
{
    struct curve curve[COR_SCENE_ENDS];
    int next = 0;
    const int count = find_curves(curve);
    const struct cor_simulator_model *model = NULL;
    for (int k = count; k <= i; k++)
        model = next_model(&web_now, &next);
    for (size_t k = 0; k < n; k++)
        if (i < count)
            cor_scene_eps(&y[k], &web_now.contact[curve[i].contact], speed_m_s[k], curve[i].end);
        else
            y[k] = model ? find_realised(model, &web_now, speed_m_s[k]) : (double)NAN;
}
