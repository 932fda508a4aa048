/* SPDX-License-Identifier: MIT */
/* What web/cor.js calls. A text that is returned is valid until the next call. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "runtime/core/laws.h"
#include "runtime/scene/simulators.h"
#include "web/web.h"

/* ---- text ---- */

static char *text;
static size_t size, length;

void web_text_clear(void)
{
    length = 0;
    web_put("%s", "");
}

void web_put(const char *format, ...)
{
    va_list list, again;
    va_start(list, format);
    va_copy(again, list);
    const int more = vsnprintf(text ? text + length : NULL, size - length, format, list);
    if (length + (size_t)more >= size) {
        char *const larger = realloc(text, 2 * (length + (size_t)more + 1));
        if (larger) {
            text = larger;
            size = 2 * (length + (size_t)more + 1);
            vsnprintf(text + length, size - length, format, again);
        }
    }
    length += length + (size_t)more < size ? (size_t)more : 0;
    va_end(again);
    va_end(list);
}

void web_put_number(double x, int digits)
{
    if (isnan(x))
        web_put("nan"); /* of either sign */
    else
        web_put("%.*g", digits, x);
}

void web_put_cell(char before, double x, int digits)
{
    web_put("%c", before);
    web_put_number(x, digits);
}

const char *web_text(void)
{
    return text ? text : "";
}

/* The digits, 15 or more, that read back to the same double */
static void put_exact(double x)
{
    char exact[40];
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(exact, sizeof exact, "%.*g", digits, x);
        if (strtod(exact, NULL) == x)
            break;
    }
    web_put("%s", exact);
}

/* ---- the contact ---- */

/* The second end of the contact: "zero_force", or "surface" under a constant force */
WEB_EXPORT(web_end) const char *web_end(void)
{
    return cor_scene_end_name(&web_now.contact[0], COR_END_ZERO_FORCE);
}

/* The csv of corgen contact without --speed */
WEB_EXPORT(web_summary) const char *web_summary(int digits)
{
    web_text_clear();
    web_put(web_now.count == 1 ? "quantity,value,unit\n" : "quantity,value_zero_overlap,value_%s,unit\n", web_end());
    for (int i = 0; i < COR_SCENE_QUANTITIES; i++) {
        if (isnan(cor_scene_quantity(&web_now.contact[0], cor_scene_quantities[i].number)))
            continue;
        if (cor_scene_quantities[i].number == COR_SCENE_STICKING_ZERO_FORCE)
            web_put("sticking_speed_%s", web_end());
        else
            web_put("%s", cor_scene_quantities[i].name);
        for (int k = 0; k < web_now.count; k++)
            web_put_cell(',', cor_scene_quantity(&web_now.contact[k], cor_scene_quantities[i].number), digits);
        web_put(",%s\n", cor_scene_quantities[i].unit);
    }
    return web_text();
}

/* ---- impacts ---- */

enum { BETA, EPS, DURATION = EPS + COR_SCENE_ENDS, OVERLAP = DURATION + COR_SCENE_ENDS, FORCE, TIME_STEP, COLUMNS };

/* The contact, in units of its own where mass and stiffness are not known */
static struct cor_scene_contact timed(int contact)
{
    struct cor_scene_contact c = web_now.contact[contact];
    if (isnan(c.mass_kg))
        c.mass_kg = c.stiffness = 1;
    return c;
}

/* The time step in these units: the shortest duration over the steps */
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

/* Fills `y` with columns of n numbers: beta, eps at both ends, durations, largest overlap and force, time step; for the
 * second contact, if there is one, again. The time step is the shortest of all durations over the steps. */
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

/* Whether the error of the time step is that of an end: of the one that is given or measured, otherwise of both */
static int is_step_end(int contact, int end)
{
    if (web_now.count > 1)
        return end == contact;
    if (web_now.scene.end != COR_BOTH_ENDS)
        return end == web_now.scene.end;
    return end == COR_END_ZERO_OVERLAP || cor_scene_ends_differ(&web_now.contact[0]);
}

WEB_EXPORT(web_step_ends) int web_step_ends(void)
{
    return is_step_end(0, COR_END_ZERO_OVERLAP) + is_step_end(0, COR_END_ZERO_FORCE);
}

static int integrator(void)
{
    return web_now.simulator ? web_now.simulator->integrator : COR_VERLET_HALF_STEP;
}

/* The name of the integrator for which web_step_errors holds; "": it has none of ours, and the errors are NaN */
WEB_EXPORT(web_integrator) const char *web_integrator(void)
{
    return integrator() == COR_NO_INTEGRATOR ? "" : cor_integrator_names[integrator()];
}

#define STEPS_ON_PAGE 2e4 /* in a contact; more would take the page from its reader for seconds */

/* Bias and scatter of eps at the time step; NaN: that of the request, where up to STEPS_ON_PAGE are tried. n of each:
 * of the end that is given or measured, or of both ends; for the second contact, if there is one, again. */
WEB_EXPORT(web_step_errors)
void web_step_errors(const double *speed_m_s, double *y, size_t n, double time_step_s)
{
    const double most = isnan(time_step_s) ? STEPS_ON_PAGE : (double)INFINITY;
    const double time_step = isnan(time_step_s) ? step_of(speed_m_s, n) : time_step_s;
    for (int k = 0; k < web_now.count; k++)
        for (int end = 0; end < COR_SCENE_ENDS; end++) {
            const struct cor_scene_contact contact = isnan(time_step_s) ? timed(k) : web_now.contact[k];
            if (!is_step_end(k, end))
                continue;
            for (size_t i = 0; i < n; i++) {
                const double steps = cor_scene_elastic_duration_s(&contact, speed_m_s[i]) / time_step;
                struct cor_step_error error = {NAN, NAN, NAN, NAN};
                struct cor_scene_impact impact;
                cor_scene_impact(&impact, &contact, speed_m_s[i]);
                if (integrator() != COR_NO_INTEGRATOR && steps > 0 && impact.duration_s[end] / time_step <= most)
                    cor_scene_step_error(&error, &contact, speed_m_s[i], end, steps, integrator());
                y[i] = error.bias;
                y[n + i] = error.scatter;
            }
            y += 2 * n;
        }
}

/* The csv of corgen contact with the speeds of the request; with `errors` that of --steps */
WEB_EXPORT(web_table) const char *web_table(int digits, int errors)
{
    enum { STEP_DIGITS = 4 };
    static double y[COR_SCENE_ENDS * COLUMNS * WEB_SPEEDS], error[2 * COR_SCENE_ENDS * WEB_SPEEDS];
    const size_t n = web_now.speeds, contacts = (size_t)web_now.count, more = errors ? 2 * (size_t)web_step_ends() : 0;
    const int spheres = !isnan(web_now.contact[0].radius_m);
    web_text_clear();
    web_put("speed_m_s,beta,eps_zero_overlap,eps_%s,duration_s_zero_overlap,duration_s_%s,"
            "max_overlap_m,max_force_n,time_step_s",
            web_end(), web_end());
    if (more == 4)
        web_put(",step_bias_zero_overlap,step_scatter_zero_overlap,step_bias_%s,step_scatter_%s", web_end(), web_end());
    web_put("%s%s%s\n", more == 2 ? ",step_bias,step_scatter" : "", contacts > 1 ? ",measured_end" : "",
            spheres ? ",contact_radius_m,max_pressure_pa" : "");
    if (n > 0)
        web_impacts(web_now.speed_m_s, y, n);
    if (n > 0 && errors)
        web_step_errors(web_now.speed_m_s, error, n, (double)NAN);
    for (size_t row = 0; row < contacts * n; row++) {
        const size_t k = row / n, i = row % n;
        put_exact(web_now.speed_m_s[i]);
        for (size_t c = 0; c < COLUMNS; c++)
            web_put_cell(',', y[(k * COLUMNS + c) * n + i], digits);
        for (size_t c = 0; c < more; c++)
            web_put_cell(',', error[(more * k + c) * n + i], STEP_DIGITS);
        web_put("%s", contacts == 1 ? "" : ",");
        web_put("%s", contacts == 1 ? "" : web_end_option(&web_now, (int)k));
        if (spheres) {
            const double overlap = y[(k * COLUMNS + OVERLAP) * n + i];
            web_put_cell(',', cor_scene_contact_radius(&web_now.contact[k], overlap), digits);
            web_put_cell(',', cor_scene_pressure(&web_now.contact[k], overlap), digits);
        }
        web_put("\n");
    }
    return web_text();
}

/* eps at one end, of contact 0 or 1 */
WEB_EXPORT(web_eps) void web_eps(const double *speed_m_s, double *y, size_t n, int contact, int end)
{
    for (size_t i = 0; i < n; i++)
        cor_scene_eps(&y[i], &web_now.contact[contact], speed_m_s[i], end);
}

/* ---- simulators ---- */

struct web_asked web_asked(const struct web_request *r)
{
    const double at = r->scene.number[COR_SCENE_AT], given = r->scene.number[COR_SCENE_RESTITUTION];
    struct web_asked a = {!isnan(at)      ? at
                          : r->speeds > 0 ? r->speed_m_s[0]
                                          : 1,
                          given, r->scene.end == COR_BOTH_ENDS ? COR_END_ZERO_OVERLAP : r->scene.end};
    if (isnan(given))
        cor_scene_eps(&a.eps, &r->contact[0], a.speed_m_s, a.end);
    return a;
}

const struct cor_simulator_model *web_model(const struct web_request *r, int *next)
{
    const long version = *r->version ? cor_simulator_version(r->version) : 0;
    while (r->simulator && *next < r->simulator->model_count) {
        const struct cor_simulator_model *const model = &r->simulator->models[(*next)++];
        if (model->damping_of_e && !model->has_function && cor_model_has_version(model, version))
            return model;
    }
    return NULL;
}

double web_realised(const struct cor_simulator_model *model, const struct web_request *r, double speed_m_s)
{
    const struct web_asked asked = web_asked(r);
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

/* csv of the laws of a contact: name,label */
WEB_EXPORT(web_laws) const char *web_laws(void)
{
    static const char *const labels[] = {COR_CONTACT_LAWS(COR_LAW_LABEL)};
    web_text_clear();
    for (int law = 0; law <= COR_LAW_PLATE; law++)
        web_put("%s,%s\n", cor_law_name((enum cor_law)law), labels[law]);
    return web_text();
}

/* csv of the simulators: name,title */
WEB_EXPORT(web_simulators) const char *web_simulators(void)
{
    web_text_clear();
    for (size_t i = 0; i < cor_simulator_count; i++)
        if (cor_simulators[i].comment)
            web_put("%s,%s\n", cor_simulators[i].name, cor_simulators[i].title);
    return web_text();
}

/* What the chosen simulator makes of e, as csv with tabs: model, version, e set by hand, eps realised, e to be set; a
 * line before says what is asked. */
WEB_EXPORT(web_models) const char *web_models(int digits)
{
    const struct web_asked asked = web_asked(&web_now);
    web_text_clear();
    web_put_number(asked.eps, digits);
    web_put_cell('\t', asked.speed_m_s, digits);
    web_put("\t%s\n", cor_end_names[asked.end]);
    int next = 0;
    for (const struct cor_simulator_model *model; (model = web_model(&web_now, &next));) {
        enum cor_simulator_status status;
        web_put("%s\t%s\t%s\t%s", model->model, model->version ? model->version : "", cor_law_name(model->law),
                cor_end_names[model->end]);
        web_put_cell('\t', web_realised(model, &web_now, asked.speed_m_s), digits);
        web_put_cell('\t', cor_simulator_e(model, asked.eps, &status), digits);
        web_put("\n");
    }
    return web_text();
}

/* The text of corgen contact --for, or NULL with the reason in web_wrong_text */
WEB_EXPORT(web_lines) const char *web_lines(void)
{
    const struct web_request *const r = &web_now;
    const struct cor_simulator_request lines = {.simulator = r->simulator ? r->simulator->name : "",
                                                .version = *r->version ? r->version : NULL,
                                                .scene = &r->scene,
                                                .contacts = r->contact,
                                                .count = r->count,
                                                .speed_m_s = r->speed_m_s,
                                                .speeds = r->speeds,
                                                .steps = r->steps,
                                                .step_errors = r->steps_given,
                                                .integrator = COR_NO_INTEGRATOR};
    const long all = cor_simulator_lines(web_wrong.text, sizeof web_wrong.text, &lines);
    snprintf(web_wrong.option, sizeof web_wrong.option, "for");
    if (all < 0)
        return NULL;
    web_text_clear();
    web_put("%*s", (int)all, ""); /* makes room */
    cor_simulator_lines(text, size, &lines);
    return web_text();
}

/* ---- commands ---- */

/* A command of corgen with the options of the request, except those in `without`, a list that NULL ends */
static void put_command(const char *command, const char *const *without)
{
    web_put("corgen %s", command);
    for (const char *line = web_now.options; *line; line += strcspn(line, "\n"), line += *line == '\n') {
        const size_t name = strcspn(line, "="), all = strcspn(line, "\n");
        int skip = all <= name + 1;
        for (size_t i = 0; without[i]; i++)
            skip = skip || (strlen(without[i]) == name && memcmp(line, without[i], name) == 0);
        if (skip)
            continue;
        web_put(" --%.*s ", (int)name, line);
        for (size_t i = name + 1; i < all && strncmp(line, "wall", name) != 0; i++)
            if (line[i] != ' ')
                web_put("%c", line[i]);
        if (strncmp(line, "wall", name) == 0)
            length--;
    }
    text[length] = '\0';
}

/* The command line of corgen that prints the same numbers */
WEB_EXPORT(web_command) const char *web_command(void)
{
    static const char *const other[] = {"for", "simulator-version", "speed-min", "speed-max", "tolerance", "label",
                                        NULL};
    web_text_clear();
    put_command("contact", other);
    return web_text();
}

/* The command of a header of a contact under a constant force */
static void put_pressed_header(const struct web_request *r, int end)
{
    static const char *const other[] = {"for",   "simulator-version", "speed-min", "speed-max", "speed",
                                        "steps", "tolerance",         "label",     "end",       NULL};
    if (cor_law_is_constant(&r->contact[0].law)) {
        web_put("/* the law %s has no header under a constant force; see corgen plan */\n", cor_law_name(r->law));
        return;
    }
    put_command("embed", other);
    web_put(" --speed-min %.15g --speed-max %.15g --tolerance %.15g --end %s --output cor_scene_eps.h\n",
            r->speed_min_m_s, r->speed_max_m_s, r->tolerance, web_end_option(r, end));
}

/* The command that writes a C header of eps over the speeds; where eps is the same at every speed, the header */
WEB_EXPORT(web_header) const char *web_header(void)
{
    const struct web_request *const r = &web_now;
    web_text_clear();
    for (int end = 0; end < COR_SCENE_ENDS; end++) {
        const struct cor_scene_contact *const contact = &r->contact[r->count > 1 ? end : 0];
        const int wanted = r->scene.end == COR_BOTH_ENDS || r->scene.end == end;
        double eps;
        if (!wanted || !cor_scene_has_end(contact, end) || (length > 0 && !cor_scene_ends_differ(contact)))
            continue;
        web_put(length > 0 ? "\n" : "");
        if (contact->force_n > 0 && contact->damping > 0) {
            put_pressed_header(r, end);
        } else if (cor_law_is_constant(&contact->law)) {
            cor_scene_eps(&eps, contact, 1, end);
            web_put(
                "/* eps of the law %s, contact ends at %s */\nstatic inline double cor_scene_eps%s(double speed_m_s)\n"
                "{\n    (void)speed_m_s; /* the same at every speed */\n    return ",
                cor_law_name(r->law), cor_end_names[end],
                r->scene.end != COR_BOTH_ENDS ? ""
                : end                         ? "_zero_force"
                                              : "_zero_overlap");
            put_exact(eps);
            web_put(";\n}\n");
        } else if (contact->damping > 0) {
            web_put("corgen embed%s%s --g-star ", r->law == COR_LAW_VISCOELASTIC || contact->plate ? "" : " --law ",
                    r->law == COR_LAW_VISCOELASTIC || contact->plate ? "" : cor_law_name(r->law));
            web_put_number(cor_scene_damping(contact, COR_SCENE_G_STAR), 15);
            web_put(" --speed-min %.15g --speed-max %.15g --tolerance %.15g --end %s --output cor_scene_eps.h\n",
                    r->speed_min_m_s, r->speed_max_m_s, r->tolerance, web_end_option(r, end));
        } else {
            web_put("/* no dissipation: eps is 1 at every speed */\n");
        }
    }
    return web_text();
}
