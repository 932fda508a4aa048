/* SPDX-License-Identifier: MIT */
#include "fit/report.h"

#include <math.h>
#include <string.h>

#include "support/console.h"

/* ---- the table ---- */

static const char *const columns[] = {"model",  "end",     "parameter", "value", "low_68", "high_68",
                                      "low_95", "high_95", "rms",       "chi2",  "aic"};

/* Six digits; an unknown number is an empty cell. */
static void add_number(struct table *table, double x)
{
    char text[32] = "";
    if (!isnan(x))
        snprintf(text, sizeof text, "%.6g", x);
    table_add(table, xstrdup(text));
}

static void add_interval(struct table *table, const struct fit_model *model, int parameter,
                         const struct fit_interval *interval, const struct fit_bodies *bodies)
{
    const double a = fit_parameter_value(model, parameter, interval->low, bodies);
    const double b = fit_parameter_value(model, parameter, interval->high, bodies);
    add_number(table, fmin(a, b));
    add_number(table, fmax(a, b));
}

static void add_row(struct table *table, const struct fit_model *model, const struct fit_estimate *e, int parameter,
                    const struct fit_bodies *bodies)
{
    table_add(table, xstrdup(model->name));
    table_add(table, xstrdup(model->end));
    table_add(table, xstrdup(fit_parameter_name(model, parameter, bodies)));
    add_number(table, fit_parameter_value(model, parameter, e->theta[parameter], bodies));
    for (int level = 0; level < LEVELS; level++)
        add_interval(table, model, parameter, &e->interval[parameter][level], bodies);
    add_number(table, e->rms);
    add_number(table, e->chi2);
    add_number(table, e->aic);
}

void fit_report_print(const struct fit_comparison *comparison, const struct fit_data *data,
                      const struct fit_request *request, enum output_format format, FILE *file)
{
    struct table table;
    table_init(&table, columns, sizeof columns / sizeof *columns);
    table.kinds = "tttnnnnnnnn";
    for (int i = 0; i < comparison->models; i++) {
        const struct fit_model *const model = &fit_models[comparison->ranked[i]];
        const struct fit_estimate *const e = &comparison->estimate[model->curve];
        for (int parameter = 0; parameter < e->parameters; parameter++)
            add_row(&table, model, e, parameter, request->bodies);
    }
    table_print(&table, format, file);
    table_clear(&table);
    if (format == FORMAT_TEXT) {
        fputs("\n", file);
        fit_report_remarks(comparison, data, request, file);
    }
}

/* ---- remarks ---- */

static void remark_data(const struct fit_data *data, FILE *file)
{
    double least = data->eps[0], most = data->eps[0];
    for (size_t i = 1; i < data->points; i++) {
        least = fmin(least, data->eps[i]);
        most = fmax(most, data->eps[i]);
    }
    fprintf(file, "%zu points%s: %.4g to %.4g m/s, eps %.4g to %.4g; ", data->points,
            data->from_bounces ? " from times of bounces" : "", data->speed_m_s[0], data->speed_m_s[data->points - 1],
            least, most);
    fputs(data->sigma ? "weights 1/eps_sigma^2.\n" : "no eps_sigma: equal weights, and the scatter gives sigma.\n",
          file);
}

static void remark_robust(FILE *file)
{
    fprintf(file, "Robust: Huber's function, linear beyond %g sigma.\n", FIT_HUBER);
}

/* "viscoelastic zero-overlap, plate zero-overlap": the models of one curve */
static void print_models_of(const struct fit_comparison *c, enum fit_curve curve, FILE *file)
{
    const char *separator = "";
    for (int i = 0; i < c->models; i++) {
        const struct fit_model *const model = &fit_models[c->ranked[i]];
        if (model->curve != curve)
            continue;
        fprintf(file, "%s%s%s%s", separator, model->name, strcmp(model->end, "both") == 0 ? "" : " ",
                strcmp(model->end, "both") == 0 ? "" : model->end);
        separator = ", ";
    }
}

/* Every curve once, in the order of the ranks */
static void remark_curves(const struct fit_comparison *c, FILE *file)
{
    bool named[FIT_CURVES] = {false};
    for (int i = 0; i < c->models; i++) {
        const enum fit_curve curve = fit_models[c->ranked[i]].curve;
        const struct fit_estimate *const e = &c->estimate[curve];
        if (named[curve])
            continue;
        named[curve] = true;
        char p_value[32] = "p < 1e-300"; /* the tail functions underflow */
        if (isnan(e->p_value))
            snprintf(p_value, sizeof p_value, "p unknown");
        else if (e->p_value >= 1e-300)
            snprintf(p_value, sizeof p_value, "p = %.2g", e->p_value);
        fprintf(file, "  %-12s %-13s ",
                isnan(e->p_value)    ? "too few"
                : fit_is_accepted(e) ? "fits"
                                     : "does not fit",
                p_value);
        print_models_of(c, curve, file);
        fputs("\n", file);
    }
}

static void remark_verdict(const struct fit_comparison *c, FILE *file)
{
    int contacts = 0, accepted_contacts = 0, accepted = 0;
    const char *best = NULL;
    for (int i = 0; i < c->models; i++) {
        const struct fit_model *const model = &fit_models[c->ranked[i]];
        const bool fits = fit_is_accepted(&c->estimate[model->curve]);
        contacts += model->is_contact;
        accepted_contacts += fits && model->is_contact;
        accepted += fits;
        best = fits && !best ? model->name : best;
    }
    if (accepted == 0)
        fputs("None of these models fits the data.\n", file);
    else if (contacts > 0 && accepted_contacts == 0)
        fputs("None of these laws of contact fits the data. The power law does; it is a formula without a contact.\n",
              file);
    else
        fprintf(file, "Of the models that fit, %s has the least AIC.\n", best);
}

void fit_report_remarks(const struct fit_comparison *comparison, const struct fit_data *data,
                        const struct fit_request *request, FILE *file)
{
    remark_data(data, file);
    if (request->robust)
        remark_robust(file);
    if (comparison->too_many_parameters > 0)
        fprintf(file, "%d model%s left out: more points than parameters are needed.\n", comparison->too_many_parameters,
                comparison->too_many_parameters == 1 ? " is" : "s are");
    if (comparison->models == 0)
        return;
    fprintf(file, "p: probability of so large %s, if the model is right; below %g it does not fit.\n",
            comparison->estimate[fit_models[comparison->ranked[0]].curve].p_of_chi2 ? "a chi2"
                                                                                    : "means of neighbouring residuals",
            FIT_SIGNIFICANCE);
    remark_curves(comparison, file);
    remark_verdict(comparison, file);
}
