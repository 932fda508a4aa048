/* SPDX-License-Identifier: MIT */
#include "contact/oblique.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/contact.h"
#include "support/console.h"

#define DEGREE 0.017453292519943295
enum { NAMES = 512 };

/* Returns the tangential model of that name. For a simulator's name, returns its model for the contact's normal spring,
 * linear or not. -1 after a message */
static int model_of(const char *name, const struct cor_scene_contact *contact)
{
    const struct cor_simulator *const simulator = cor_simulator_named(name);
    const bool linear = contact->law.elastic == contact->law.denominator;
    char names[NAMES] = "";
    for (int id = 0; id < COR_TANGENTIAL_MODELS; id++) {
        const struct cor_tangential_model *const model = &cor_tangential_models[id];
        const size_t length = strlen(names);
        const bool has = simulator && (simulator->tangential >> id & 1U) != 0;
        if (strcmp(model->name, name) == 0 ||
            (has && (linear == (model->constant_stiffness != 0) || simulator->tangential >> id == 1)))
            return id;
        snprintf(names + length, sizeof names - length, "%s, ", model->name);
    }
    return usage_error("--tangential: '%s' is not a model of a tangential force; allowed: %sor the name of a "
                       "simulator: lammps, liggghts, yade, mercurydpm",
                       name, names),
           -1;
}

/* Computes spring and damper of a contact at an end, in SI units. Returns STATUS_OK, or STATUS_USAGE after a
 * message. */
static int spring_of(double *spring, double *damper, const struct contacts *contacts, int k, int end, int id,
                     const struct oblique_request *request)
{
    const struct cor_scene_contact *const c = &contacts->contact[k];
    const struct cor_tangential_model *const model = &cor_tangential_models[id];
    const bool nothing = model->memory == COR_REMEMBERS_NOTHING,
               hertz = !isnan(c->radius_m) && !model->constant_stiffness;
    const double ratio = isnan(request->damping_ratio) ? (nothing ? 1 : 0) : request->damping_ratio;
    *damper = ratio * cor_scene_damping(c, COR_SCENE_DAMPING_COEFFICIENT);
    *spring = nothing ? 0 : request->stiffness;
    if (!isnan(request->restitution))
        return contact_status(cor_scene_tangential(spring, damper, c, request->restitution, end));
    if (!isnan(*spring))
        return STATUS_OK;
    if (!hertz)
        return usage_error("--tangential %s needs --tangential-stiffness KT in N/m%s", model->name,
                           c->law.elastic == c->law.denominator ? ", or --tangential-restitution E" : "");
    const struct cor_body one = cor_scene_body(&contacts->scene, 1), two = cor_scene_body(&contacts->scene, 2);
    *spring = c->stiffness / 3.5 *
              cor_tangential_kappa(one.young_modulus_pa, one.poisson_ratio, two.young_modulus_pa, two.poisson_ratio);
    return STATUS_OK;
}

/* Computes the impact at one speed and one tangent of the angle, and sets the remark. least: the least time step of all
 * impacts */
static int impact_of(struct cor_oblique_impact *impact, double *least, const struct contacts *contacts, int k, int end,
                     int id, struct oblique_request *request, double speed, double tangent)
{
    const struct cor_scene_contact *const c = &contacts->contact[k];
    struct cor_tangential tangential;
    double spring, damper;
    int status = spring_of(&spring, &damper, contacts, k, end, id, request);
    if (status != STATUS_OK)
        return status;
    status = cor_scene_tangential_scaled(&tangential, c, (enum cor_tangential_id)id, spring, damper, speed);
    if (status == COR_FAULT_NONE)
        status = cor_scene_oblique(impact, c, &tangential, request->friction, speed, tangent, end);
    if (isless(impact->time_step_s, *least)) {
        *least = impact->time_step_s;
        snprintf(
            request->remark, sizeof request->remark,
            "The tangential damper exceeds the friction at the first touch. A simulation needs time steps of about "
            "%.2g s or less to agree within %g.",
            *least, COR_OBLIQUE_STEP_ERROR);
    }
    return status == COR_FAULT_NONE ? STATUS_OK
                                    : fail("cannot integrate the oblique impact at %g m/s with the tangential speed %g "
                                           "m/s: its numbers are out of range",
                                           speed, speed * tangent);
}

/* ---- Walton's three numbers ---- */

/* Returns the largest difference of `restitution` from max(-beta_0, 1 - slip/tangent). *mean: the mean difference */
static double largest_error(double *mean, const double *tangent, const double *restitution, size_t n, double slip,
                            double beta_0)
{
    double largest = 0;
    *mean = 0;
    for (size_t i = 0; i < n; i++) {
        const double error = fabs(fmax(-beta_0, 1 - slip / tangent[i]) - restitution[i]);
        largest = fmax(largest, error);
        *mean += error / (double)n;
    }
    return largest;
}

/* Minimises the largest error plus 1e-4 times the mean error, on grids that shrink around the best pair. The mean error
 * decides between pairs with the same largest error. Returns the largest error. */
static double fit_walton(double *slip, double *beta_0, const double *tangent, const double *restitution, size_t n)
{
    enum { GRID = 40, ROUNDS = 12 };
    double best = INFINITY, largest = INFINITY, middle[2] = {*slip, 0}, half[2] = {0.9 * *slip, 1.2};
    for (int round = 0; round < ROUNDS; round++) {
        const double from[2] = {middle[0], middle[1]};
        for (int k = 0; k < (GRID + 1) * (GRID + 1); k++) {
            const double try[2] = {from[0] + half[0] * (2.0 * (k % (GRID + 1)) / GRID - 1),
                                   from[1] + half[1] * (2.0 * (k / (GRID + 1)) / GRID - 1)};
            double mean;
            const double error = largest_error(&mean, tangent, restitution, n, try[0], try[1]);
            if (error + 1e-4 * mean < best) {
                best = error + 1e-4 * mean;
                largest = error;
                memcpy(middle, try, sizeof middle);
            }
        }
        half[0] /= 4;
        half[1] /= 4;
    }
    *slip = middle[0];
    *beta_0 = middle[1];
    return largest;
}

/* ---- tables ---- */

int contact_oblique(struct table *table, const struct contacts *contacts, struct oblique_request *request, int digits)
{
    static const char *const regimes[] = {"rest", "stick", "slip", "both"};
    const bool damped = contacts->contact[0].damping > 0;
    const bool both = damped && (contacts->count > 1 || contact_end(contacts, 0) == COR_BOTH_ENDS);
    const int id = model_of(request->model ? request->model : "displacement", &contacts->contact[0]);
    const struct cor_body body = cor_scene_body(&contacts->scene, 1);
    double *const tangent = xmalloc(2 * request->count * sizeof *tangent), *const ratio = tangent + request->count;
    double least = INFINITY;
    char text[DECIMAL_TEXT], header[NAMES];
    int status = id < 0 ? STATUS_USAGE : STATUS_OK;
    snprintf(header, sizeof header, "speed_m_s,%s%s",
             request->walton ? "eps,friction,beta_0,largest_error"
                             : "angle_degrees,tangential_speed_m_s,tangential_restitution,rebound_angle_degrees,"
                               "spin_rad_s,regime",
             both ? ",end" : "");
    table_init(table, header, request->walton ? "tnnnnt" : "tnnnnntt");
    for (int end = 0; end < COR_SCENE_ENDS; end++)
        for (size_t i = 0; i < request->speeds; i++) {
            const int k = contacts->count > 1 ? end : 0;
            const double speed = request->speed_m_s[i];
            const char *const name = cor_scene_end_name(&contacts->contact[k], end);
            struct cor_oblique_impact impact = {NAN, NAN, NAN, NAN, NAN, 0};
            if (!both && end != (contact_end(contacts, 0) == COR_END_ZERO_FORCE))
                continue;
            for (size_t j = 0; j < request->count && status == STATUS_OK; j++) {
                const double given = request->given[j];
                tangent[j] = request->angles ? tan(given * DEGREE) : given / speed;
                status = impact_of(&impact, &least, contacts, k, end, id, request, speed, tangent[j]);
                ratio[j] = impact.restitution;
                if (request->walton || status != STATUS_OK)
                    continue;
                const double u = tangent[j] * speed;
                table_add_text(table, decimal_text(text, speed));
                table_add_number(table, request->angles ? given : atan(tangent[j]) / DEGREE, digits);
                table_add_number(table, u, digits);
                table_add_number(table, -ratio[j], digits);
                table_add_number(table, atan(impact.rebound_tangent) / DEGREE, digits);
                table_add_number(
                    table, 5.0 / 7 * u * (1 - ratio[j]) * contacts->contact[k].mass_kg / body.mass_kg / body.radius_m,
                    digits);
                table_add_text(table, regimes[impact.regime]);
                if (both)
                    table_add_text(table, name);
            }
            if (request->walton && status == STATUS_OK) {
                double slip = 3.5 * request->friction * (1 + impact.eps), beta_0;
                const double factor = 3.5 * (1 + impact.eps),
                             error = fit_walton(&slip, &beta_0, tangent, ratio, request->count);
                bool bounded = false; /* true if beta_0 matters at some angle */
                for (size_t j = 0; j < request->count; j++)
                    bounded = bounded || 1 - slip / tangent[j] < -beta_0;
                if (!bounded) {
                    beta_0 = NAN;
                    strcpy(request->remark,
                           "beta_0 is not determined: the contact slips to its end at every angle, so no "
                           "result depends on it.");
                }
                const double value[] = {impact.eps, slip / factor, beta_0, error};
                table_add_text(table, decimal_text(text, speed));
                for (size_t j = 0; j < sizeof value / sizeof *value; j++)
                    table_add_known(table, value[j], j == 3 ? 3 : CONTACT_DIGITS_TEXT);
                if (both)
                    table_add_text(table, name);
            }
        }
    free(tangent);
    return status;
}

int contact_oblique_lines(struct cor_simulator_request *lines, const struct contacts *contacts,
                          const struct oblique_request *request)
{
    const struct cor_scene_contact of_law = {.law = lines->scene->law};
    const bool known = contacts && cor_simulator_named(lines->simulator)->tangential;
    const char *const name = request->model ? request->model : known ? lines->simulator : "displacement";
    const int id = model_of(name, contacts ? &contacts->contact[0] : &of_law);
    if (id < 0)
        return STATUS_USAGE;
    lines->friction = request->friction;
    lines->tangential = (enum cor_tangential_id)id;
    lines->oblique = request->given;
    lines->obliques = request->count;
    lines->in_degrees = request->angles;
    if (!contacts) /* each contact of several materials has its own spring */
        return STATUS_OK;
    const int end = contact_end(contacts, 0) == COR_END_ZERO_FORCE;
    return spring_of(&lines->tangential_stiffness, &lines->tangential_damping, contacts, 0, end, id, request);
}
