/* SPDX-License-Identifier: MIT */
#include "contact/contact_rows.h"

#include <math.h>
#include <stdlib.h>

#include "support/console.h"

char *contact_number_text(double x, int digits)
{
    char text[DECIMAL_TEXT];
    snprintf(text, sizeof text, isnan(x) ? "nan" : "%.*g", digits, x);
    return xstrdup(text);
}

/* ---- the contact ---- */

static double mass(const struct contact_model *model)
{
    return model->mass_kg;
}
static double stiffness(const struct contact_model *model)
{
    return model->stiffness;
}
static double radius(const struct contact_model *model)
{
    return model->radius_m;
}
static double beta_factor(const struct contact_model *model)
{
    return contact_model_is_constant(model) ? (double)NAN : model->damping;
}

/* In units, %s is an exponent. */
static const struct quantity {
    const char *name;
    double (*value)(const struct contact_model *model);
    const char *unit;
} quantities[] = {{"effective_mass", mass, "kg"},
                  {"effective_radius", radius, "m"},
                  {"stiffness", stiffness, "N/m^a"},
                  {"dissipation_time", contact_model_dissipation_time_s, "s"},
                  {"damping_coefficient", contact_model_coefficient, "N s/m^(b+1)"},
                  {"g_star", contact_model_g_star_m_s, "m/s"},
                  {"zeta", contact_model_zeta, "1"},
                  {"beta_factor", beta_factor, "(m/s)^(-q)"}};
enum { QUANTITIES = sizeof quantities / sizeof *quantities };

void contact_summary(struct table *table, const struct contact_models *models, int digits)
{
    static const char *const one[] = {"quantity", "value", "unit"};
    static const char *const two[] = {"quantity", "value_zero_overlap", "value_zero_force", "unit"};
    table_init(table, models->count == 1 ? one : two, 2 + models->count);
    table->kinds = models->count == 1 ? "tnt" : "tnnt";
    for (int i = 0; i < QUANTITIES; i++) {
        if (isnan(quantities[i].value(&models->model[0])))
            continue;
        table_add(table, xstrdup(quantities[i].name));
        for (int k = 0; k < models->count; k++)
            table_add(table, contact_number_text(quantities[i].value(&models->model[k]), digits));
        table_add(table, xstrdup(quantities[i].unit));
    }
    const double q = contact_model_speed_exponent(&models->model[0]);
    table_add(table, xstrdup("q"));
    for (int k = 0; k < models->count; k++)
        table_add(table, contact_number_text(q, digits));
    table_add(table, xstrdup("1"));
}

/* ---- the impacts ---- */

/* The shortest duration that one end allows; infinite if both are unknown */
static double shortest(const struct contact_impact *impact)
{
    return fmin(fmin(impact->duration_s[END_ZERO_OVERLAP], impact->duration_s[END_ZERO_FORCE]), INFINITY);
}

static int solve_all(struct contact_impact *impact, double *least, const struct contact_models *models,
                     const double *speed_m_s, size_t speeds)
{
    *least = INFINITY;
    for (int k = 0; k < models->count; k++) {
        for (size_t i = 0; i < speeds; i++) {
            progress("impacts", (long)((size_t)k * speeds + i), (long)((size_t)models->count * speeds));
            struct contact_impact *const solved = &impact[(size_t)k * speeds + i];
            const int status = contact_model_impact(solved, &models->model[k], speed_m_s[i]);
            if (status != STATUS_OK)
                return status;
            *least = fmin(*least, shortest(solved));
        }
    }
    return STATUS_OK;
}

static void add_row(struct table *table, double speed_m_s, const struct contact_impact *impact, double step, int digits)
{
    const double value[] = {impact->beta,
                            impact->eps[END_ZERO_OVERLAP],
                            impact->eps[END_ZERO_FORCE],
                            impact->duration_s[END_ZERO_OVERLAP],
                            impact->duration_s[END_ZERO_FORCE],
                            impact->max_overlap_m,
                            impact->max_force_n,
                            step};
    char text[DECIMAL_TEXT];
    table_add(table, xstrdup(decimal_text(text, speed_m_s)));
    for (size_t i = 0; i < sizeof value / sizeof *value; i++)
        table_add(table, contact_number_text(value[i], digits));
}

int contact_rows(struct table *table, const struct contact_models *models, const double *speed_m_s, size_t speeds,
                 double steps, int digits)
{
    static const char *const column[] = {"speed_m_s",
                                         "beta",
                                         "eps_zero_overlap",
                                         "eps_zero_force",
                                         "duration_s_zero_overlap",
                                         "duration_s_zero_force",
                                         "max_overlap_m",
                                         "max_force_n",
                                         "time_step_s",
                                         "measured_end"};
    struct contact_impact *const impact = xmalloc((size_t)models->count * speeds * sizeof *impact);
    double least;
    table_init(table, column, (int)(sizeof column / sizeof *column) - (models->count == 1));
    table->kinds = "nnnnnnnnnt";
    const int status = solve_all(impact, &least, models, speed_m_s, speeds);
    const double step = isinf(least) ? (double)NAN : least / steps;
    for (size_t i = 0; i < (size_t)models->count * speeds && status == STATUS_OK; i++) {
        add_row(table, speed_m_s[i % speeds], &impact[i], step, digits);
        if (models->count > 1)
            table_add(table,
                      xstrdup(models->measured_end[i / speeds] == END_ZERO_FORCE ? "zero-force" : "zero-overlap"));
    }
    free(impact);
    progress_end();
    return status;
}
