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

/* number: of enum cor_scene_number; COR_SCENE_NUMBERS stands for q */
static const struct quantity {
    const char *name;
    int number;
    const char *unit;
} quantities[] = {{"effective_mass", COR_SCENE_EFFECTIVE_MASS, "kg"},
                  {"effective_radius", COR_SCENE_RADIUS, "m"},
                  {"stiffness", COR_SCENE_STIFFNESS, "N/m^a"},
                  {"dissipation_time", COR_SCENE_DISSIPATION_TIME, "s"},
                  {"damping_coefficient", COR_SCENE_DAMPING_COEFFICIENT, "N s/m^(b+1)"},
                  {"g_star", COR_SCENE_G_STAR, "m/s"},
                  {"zeta", COR_SCENE_ZETA, "1"},
                  {"beta_factor", COR_SCENE_BETA, "(m/s)^(-q)"},
                  {"q", COR_SCENE_NUMBERS, "1"}};
enum { QUANTITIES = sizeof quantities / sizeof *quantities };

static double value_of(const struct cor_scene_contact *contact, int number)
{
    switch (number) {
    case COR_SCENE_EFFECTIVE_MASS:
        return contact->mass_kg;
    case COR_SCENE_RADIUS:
        return contact->radius_m;
    case COR_SCENE_STIFFNESS:
        return contact->stiffness;
    case COR_SCENE_NUMBERS:
        return cor_scene_speed_exponent(contact);
    default:
        return cor_scene_damping(contact, number);
    }
}

void contact_summary(struct table *table, const struct contacts *contacts, int digits)
{
    static const char *const one[] = {"quantity", "value", "unit"};
    static const char *const two[] = {"quantity", "value_zero_overlap", "value_zero_force", "unit"};
    table_init(table, contacts->count == 1 ? one : two, 2 + contacts->count);
    table->kinds = contacts->count == 1 ? "tnt" : "tnnt";
    for (int i = 0; i < QUANTITIES; i++) {
        if (isnan(value_of(&contacts->contact[0], quantities[i].number)))
            continue;
        table_add(table, xstrdup(quantities[i].name));
        for (int k = 0; k < contacts->count; k++)
            table_add(table, contact_number_text(value_of(&contacts->contact[k], quantities[i].number), digits));
        table_add(table, xstrdup(quantities[i].unit));
    }
}

/* ---- the impacts ---- */

int contact_rows(struct table *table, const struct contacts *contacts, const double *speed_m_s, size_t speeds,
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
    const size_t rows = (size_t)contacts->count * speeds;
    struct cor_scene_impact *const impact = xmalloc(rows * sizeof *impact);
    double least = INFINITY; /* the shortest duration, of the ends that are known */
    int status = STATUS_OK;
    table_init(table, column, (int)(sizeof column / sizeof *column) - (contacts->count == 1));
    table->kinds = "nnnnnnnnnt";
    for (size_t i = 0; i < rows && status == STATUS_OK; i++) {
        progress("impacts", (long)i, (long)rows);
        status = contact_status(cor_scene_impact(&impact[i], &contacts->contact[i / speeds], speed_m_s[i % speeds]));
        for (int end = 0; end < COR_SCENE_ENDS; end++)
            least = fmin(least, impact[i].duration_s[end]);
    }
    for (size_t i = 0; i < rows && status == STATUS_OK; i++) {
        const double value[] = {impact[i].beta,
                                impact[i].eps[END_ZERO_OVERLAP],
                                impact[i].eps[END_ZERO_FORCE],
                                impact[i].duration_s[END_ZERO_OVERLAP],
                                impact[i].duration_s[END_ZERO_FORCE],
                                impact[i].max_overlap_m,
                                cor_scene_force_max_n(&contacts->contact[i / speeds], speed_m_s[i % speeds]),
                                isinf(least) ? (double)NAN : least / steps};
        char text[DECIMAL_TEXT];
        table_add(table, xstrdup(decimal_text(text, speed_m_s[i % speeds])));
        for (size_t k = 0; k < sizeof value / sizeof *value; k++)
            table_add(table, contact_number_text(value[k], digits));
        if (contacts->count > 1)
            table_add(table, xstrdup(i < speeds ? "zero-overlap" : "zero-force"));
    }
    free(impact);
    progress_end();
    return status;
}
