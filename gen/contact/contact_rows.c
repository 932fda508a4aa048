/* SPDX-License-Identifier: MIT */
#include "contact/contact.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cor/law.h"
#include "cor/sphere.h"

#include "support/console.h"

enum { HEADER = 512 };

/* ---- the contact ---- */

static bool is_jkr(const struct contacts *contacts)
{
    return contacts->contact[0].adhesion_j_m2 > 0;
}

const char *contact_end_text(const struct cor_scene_contact *contact, int end)
{
    return contact->force_n > 0 && end == COR_END_ZERO_FORCE ? "the surface" : cor_end_names[end];
}

/* Returns the name of an end of contact, as a part of the name of a column. */
static const char *end_of(const struct contacts *contacts, int end)
{
    return cor_scene_end_name(&contacts->contact[0], end);
}

static double tabor_number(const struct contacts *contacts)
{
    return cor_scene_tabor_number(&contacts->contact[0], contacts->scene.number[COR_SCENE_ADHESION],
                                  COR_TABOR_DISTANCE_M);
}

void contact_print_ranges(FILE *file, const struct contacts *contacts, bool rows)
{
    const double step = cor_scene_rayleigh_step_s(&contacts->scene), tabor = tabor_number(contacts);
    if (rows && !isnan(step))
        fprintf(
            file,
            "\nRayleigh's time step is %.6g s, in which a surface wave travels half around the smaller sphere. Codes\n"
            "for particles use 0.1 to 0.3 of it at every speed, whereas time_step_s follows from this contact.\n",
            step);
    if (contacts->hertz.stiffness > 0)
        fprintf(file,
                "\nEquivalent at %g m/s only. At n times this speed Hertz's elastic contact has n^(-1/5) times the\n"
                "duration and n^(4/5) times the overlap, and with weak damping n^(1/5) times the loss 1 - eps. The\n"
                "spring has the same duration and eps, and n times the overlap.\n",
                contacts->at_m_s);
    if (!isnan(tabor))
        fprintf(file,
                "\nTabor's number is %.3g for surfaces %g m apart. The JKR model holds above about %g, DMT below %g.\n",
                tabor, COR_TABOR_DISTANCE_M, COR_TABOR_JKR, COR_TABOR_DMT);
}

/* Adds a row for a quantity that cor/scene.h does not have. If the value is NaN, adds no row. value: one for each
 * contact */
static void add_number(struct table *table, const struct contacts *contacts, const char *name,
                       const double value[COR_SCENE_ENDS], const char *unit, int digits)
{
    if (isnan(value[0]))
        return;
    table_add_text(table, name);
    for (int k = 0; k < contacts->count; k++)
        table_add_number(table, value[k], digits);
    table_add_text(table, unit);
}

void contact_summary(struct table *table, const struct contacts *contacts, double friction, double tangential,
                     int digits)
{
    const bool one = contacts->count == 1;
    char text[HEADER];
    snprintf(text, sizeof text, one ? "quantity,value,unit" : "quantity,value_%s,value_%s,unit", end_of(contacts, 0),
             end_of(contacts, 1));
    table_init(table, text, one ? "tnt" : "tnnt");
    for (int i = 0; i < COR_SCENE_QUANTITIES; i++) {
        const struct cor_scene_quantity *const q = &cor_scene_quantities[i];
        if (isnan(cor_scene_quantity(&contacts->contact[0], q->number)))
            continue;
        snprintf(text, sizeof text, "%s", q->name);
        for (int k = 0; k < COR_SCENE_ENDS; k++) {
            char *const at = strstr(text, k == COR_END_ZERO_FORCE ? "zero_force" : "zero_overlap");
            if (at)
                snprintf(at, sizeof text - (size_t)(at - text), "%s", end_of(contacts, k));
        }
        table_add_text(table, text);
        for (int k = 0; k < contacts->count; k++)
            table_add_number(table, cor_scene_quantity(&contacts->contact[k], q->number), digits);
        table_add_text(table, q->unit);
    }
    const double step = cor_scene_rayleigh_step_s(&contacts->scene), tabor = tabor_number(contacts);
    double spring[COR_SCENE_ENDS], dashpot[COR_SCENE_ENDS];
    for (int k = 0; k < contacts->count; k++)
        cor_scene_tangential(&spring[k], &dashpot[k], &contacts->contact[k], tangential, contact_end(contacts, k));
    add_number(table, contacts, "rayleigh_time_step", (double[]){step, step}, "s", digits);
    add_number(table, contacts, "tabor_number", (double[]){tabor, tabor}, "1", digits);
    add_number(table, contacts, "tangential_stiffness", spring, "N/m", digits);
    add_number(table, contacts, "tangential_damping", dashpot, "N s/m", digits);
    if (isnan(friction))
        return;
    const struct cor_body body[2] = {cor_scene_body(&contacts->scene, 1), cor_scene_body(&contacts->scene, 2)};
    const double degree = 57.29577951308232;
    const double kappa = cor_tangential_kappa(body[0].young_modulus_pa, body[0].poisson_ratio, body[1].young_modulus_pa,
                                              body[1].poisson_ratio);
    const struct {
        const char *name;
        double value;
        const char *unit;
    } row[] = {{"tangential_kappa", kappa, "1"},
               {"no_slip", cor_tangential_no_slip(kappa, 1.5), "1"},
               {"stick_angle", cor_tangential_stick_angle(kappa, friction) * degree, "degrees"}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        add_number(table, contacts, row[i].name, (double[]){row[i].value, row[i].value}, row[i].unit, digits);
}

/* ---- the time step ---- */

int contact_end(const struct contacts *contacts, int contact)
{
    if (contacts->count > 1)
        return contact;
    if (contacts->scene.end != COR_BOTH_ENDS)
        return contacts->scene.end;
    return cor_scene_ends_differ(&contacts->contact[0]) ? COR_BOTH_ENDS : COR_END_ZERO_OVERLAP;
}

/* A row. Times are in seconds, or in an arbitrary unit if mass and stiffness are unknown. */
struct row {
    struct cor_scene_contact contact;
    double speed_m_s, elastic_duration_s;
    int end;
    struct cor_scene_impact impact;
};

static bool is_end(const struct row *row, int end)
{
    return row->end == COR_BOTH_ENDS || row->end == end;
}

/* Computes the largest time step that meets a tolerance, rounded down to the three digits of cor_scene_step_for. */
static int step_for(double *time_step, const struct row *row, size_t rows, const struct cor_simulator_request *request)
{
    double least = INFINITY, n;
    for (size_t i = 0; i < COR_SCENE_ENDS * rows; i++) {
        const struct row *const r = &row[i / COR_SCENE_ENDS];
        const int end = (int)(i % COR_SCENE_ENDS);
        if (!is_end(r, end))
            continue;
        const int status =
            cor_scene_step_for(&n, &r->contact, r->speed_m_s, end, request->step_tolerance, request->integrator);
        if (status == COR_FAULT_STEP)
            return fail("found no time step that keeps bias and scatter of eps below %g at %g m/s; give a larger "
                        "--step-tolerance",
                        request->step_tolerance, r->speed_m_s);
        if (status != COR_FAULT_NONE)
            return contact_status(status);
        least = fmin(least, r->elastic_duration_s / n);
    }
    const double unit = pow(10, floor(log10(least)) - 2);
    *time_step = floor(least / unit) * unit;
    return STATUS_OK;
}

/* ---- the impacts ---- */

/* Returns the quantity that --step-corrected corrects; NULL for a contact without damping. */
static const struct cor_scene_quantity *corrected_quantity(const struct contacts *contacts)
{
    static const int wanted[] = {COR_SCENE_ZETA, COR_SCENE_DISSIPATION_TIME, COR_SCENE_DAMPING_COEFFICIENT,
                                 COR_SCENE_BETA};
    for (size_t k = 0; k < sizeof wanted / sizeof *wanted; k++)
        for (int i = 0; i < COR_SCENE_QUANTITIES; i++)
            if (cor_scene_quantities[i].number == wanted[k] &&
                !isnan(cor_scene_quantity(&contacts->contact[0], wanted[k])))
                return &cor_scene_quantities[i];
    return NULL;
}

/* Adds the columns of Hertz's contact: viscoelastic spheres with the eps of contact k at the speed of equivalence. */
static int add_hertz(struct table *table, const struct contacts *contacts, int k, double speed_m_s, int digits)
{
    const int given = contact_end(contacts, k), end = given == COR_BOTH_ENDS ? COR_END_ZERO_OVERLAP : given;
    struct cor_scene_contact hertz = contacts->hertz;
    struct cor_scene_impact impact;
    double eps;
    int status = cor_scene_eps(&eps, &contacts->contact[k], contacts->at_m_s, end);
    if (status == COR_FAULT_NONE)
        status = cor_scene_set_damping(&hertz, COR_SCENE_RESTITUTION, eps, contacts->at_m_s, end);
    if (status == COR_FAULT_NONE)
        status = cor_scene_impact(&impact, &hertz, speed_m_s);
    if (status == COR_FAULT_NONE)
        status = cor_scene_eps(&eps, &hertz, speed_m_s, end);
    if (status != COR_FAULT_NONE)
        return contact_status(status);
    const double approach_s = cor_sphere_duration_approach_only(impact.beta) / cor_sphere_duration_zero_overlap(0) *
                              cor_scene_elastic_duration_s(&hertz, speed_m_s);
    table_add_number(table, eps, digits);
    table_add_number(table, end < COR_SCENE_ENDS ? impact.duration_s[end] : approach_s, digits);
    table_add_number(table, impact.max_overlap_m, digits);
    return STATUS_OK;
}

enum { STEP_DIGITS = 4, CORRECTED_DIGITS = 6 };

/* Adds bias and scatter of a row, and the corrected damping. They are NaN if the step is too long or too short. */
static int add_step(struct table *table, const struct row *row, double time_step,
                    const struct cor_simulator_request *request, const struct cor_scene_quantity *quantity)
{
    const struct cor_scene_contact *const contact = &row->contact;
    const double speed = row->speed_m_s, steps = row->elastic_duration_s / time_step;
    struct cor_step_error error;
    struct cor_scene_contact corrected;
    for (int end = 0; end < COR_SCENE_ENDS; end++) {
        if (!is_end(row, end))
            continue;
        int status = cor_scene_step_error(&error, contact, speed, end, steps, request->integrator);
        if (status != COR_FAULT_NONE && status != COR_FAULT_STEP)
            return contact_status(status);
        table_add_number(table, error.bias, STEP_DIGITS);
        table_add_number(table, error.scatter, STEP_DIGITS);
        if (!request->step_corrected)
            continue;
        status = cor_scene_step_corrected(&corrected, contact, speed, end, steps, request->integrator);
        if (status < 0)
            return contact_status(status);
        const double factor = contact->damping > 0 ? corrected.damping / contact->damping : 1;
        table_add_number(table, factor, CORRECTED_DIGITS);
        table_add_number(table, cor_scene_quantity(contact, quantity->number) * factor, CORRECTED_DIGITS);
    }
    return STATUS_OK;
}

int contact_rows(struct table *table, const struct contacts *contacts, const struct cor_simulator_request *request,
                 int digits)
{
    const size_t speeds = request->speeds, rows = (size_t)contacts->count * speeds;
    const bool spheres = !isnan(contacts->contact[0].radius_m) && !is_jkr(contacts); /* of Hertz */
    const double known = isnan(contacts->contact[0].mass_kg) ? (double)NAN : 1;
    struct row *const row = xmalloc(rows * sizeof *row);
    double least = INFINITY; /* the shortest known duration */
    int status = STATUS_OK;
    for (size_t i = 0; i < rows && status == STATUS_OK; i++) {
        struct row *const r = &row[i];
        const double speed = request->speed_m_s[i % speeds];
        *r = (struct row){.contact = contacts->contact[i / speeds], .speed_m_s = speed};
        if (isnan(known))
            r->contact.mass_kg = r->contact.stiffness = 1;
        r->end = contact_end(contacts, (int)(i / speeds));
        r->elastic_duration_s = cor_scene_elastic_duration_s(&r->contact, speed);
        progress("impacts", (long)i, (long)rows);
        status = contact_status(cor_scene_impact(&r->impact, &r->contact, speed));
        least = fmin(least, fmin(r->impact.duration_s[0], r->impact.duration_s[1]));
    }
    double time_step = request->time_step_s > 0 ? request->time_step_s
                       : isinf(least)           ? (double)NAN
                                                : least / request->steps;
    if (status == STATUS_OK && request->step_tolerance > 0)
        status = step_for(&time_step, row, rows, request);
    const struct cor_scene_quantity *const quantity = corrected_quantity(contacts);
    const char *const end[] = {end_of(contacts, 0), end_of(contacts, 1)};
    const bool both = contact_end(contacts, 0) == COR_BOTH_ENDS,
               approach = contacts->scene.end == COR_END_APPROACH_ONLY;
    char header[HEADER], errors[HEADER / 4] = "", kinds[] = "nnnnnnnnnnnnnnnnnnn";
    if (contacts->count > 1)
        kinds[9 + (request->step_errors ? (both ? 4 : 2) : 0) + (request->step_corrected ? 2 : 0)] = 't';
    if (request->step_errors)
        snprintf(errors, sizeof errors,
                 both ? ",step_bias_%s,step_scatter_%s,step_bias_%s,step_scatter_%s" : ",step_bias,step_scatter",
                 end[0], end[0], end[1], end[1]);
    snprintf(header, sizeof header,
             "speed_m_s,beta,eps_%s,eps_%s,duration_s_%s,duration_s_%s,max_overlap_m,max_force_n,time_step_s"
             "%s%s%s%s%s%s%s",
             end[0], end[1], end[0], end[1], errors, request->step_corrected ? ",damping_correction,corrected_" : "",
             request->step_corrected ? quantity->name : "", contacts->count > 1 ? ",measured_end" : "",
             spheres ? ",contact_radius_m,max_pressure_pa" : "", approach ? ",eps_approach_only" : "",
             contacts->hertz.stiffness > 0 ? ",hertz_eps,hertz_duration_s,hertz_max_overlap_m" : "");
    table_init(table, header, kinds);
    for (size_t i = 0; i < rows && status == STATUS_OK; i++) {
        const struct cor_scene_contact *const contact = &contacts->contact[i / speeds];
        const struct cor_scene_impact *const impact = &row[i].impact;
        const double value[] = {impact->beta,
                                impact->eps[COR_END_ZERO_OVERLAP],
                                impact->eps[COR_END_ZERO_FORCE],
                                impact->duration_s[COR_END_ZERO_OVERLAP] * known,
                                impact->duration_s[COR_END_ZERO_FORCE] * known,
                                impact->max_overlap_m * known,
                                cor_scene_force_max_n(contact, row[i].speed_m_s),
                                time_step * known};
        char text[DECIMAL_TEXT];
        progress("impacts", (long)i, (long)rows);
        table_add_text(table, decimal_text(text, row[i].speed_m_s));
        for (size_t k = 0; k < sizeof value / sizeof *value; k++)
            table_add_number(table, value[k], digits);
        if (request->step_errors)
            status = add_step(table, &row[i], time_step, request, quantity);
        if (contacts->count > 1)
            table_add_text(
                table, is_jkr(contacts)
                           ? (i < speeds ? "tail" : "largest-pull")
                           : contact_end_options_pressed[contact_end_named((int)(i / speeds), contact->force_n > 0)]);
        if (spheres) {
            table_add_number(table, cor_scene_contact_radius(contact, impact->max_overlap_m), digits);
            table_add_number(table, cor_scene_pressure(contact, impact->max_overlap_m), digits);
        }
        double eps;
        if (approach && cor_scene_eps(&eps, contact, row[i].speed_m_s, COR_END_APPROACH_ONLY) == COR_FAULT_NONE)
            table_add_number(table, eps, digits);
        if (contacts->hertz.stiffness > 0)
            status = add_hertz(table, contacts, (int)(i / speeds), row[i].speed_m_s, digits);
    }
    free(row);
    progress_end();
    return status;
}
