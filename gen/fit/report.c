/* SPDX-License-Identifier: MIT */
#include "fit/compare.h"

#include <math.h>
#include <string.h>

#include "support/console.h"

/* ---- the table ---- */

enum { DIGITS = 6 };

static void add_row(struct table *table, const struct fit_model *model, const struct fit_estimate *e, int parameter,
                    const struct fit_bodies *bodies)
{
    table_add_text(table, model->name);
    table_add_text(table, model->end);
    table_add_text(table, fit_parameter_name(model, parameter, bodies));
    table_add_known(table, fit_parameter_value(model, parameter, e->theta[parameter], bodies), DIGITS);
    for (int level = 0; level < LEVELS; level++) {
        const struct fit_interval *const interval = &e->interval[parameter][level];
        const double a = fit_parameter_value(model, parameter, interval->low, bodies);
        const double b = fit_parameter_value(model, parameter, interval->high, bodies);
        table_add_known(table, fmin(a, b), DIGITS);
        table_add_known(table, fmax(a, b), DIGITS);
    }
    table_add_known(table, e->rms, DIGITS);
    table_add_known(table, e->chi2, DIGITS);
    table_add_known(table, e->aic, DIGITS);
}

void fit_report_print(const struct fit_report *report, enum output_format format, FILE *file)
{
    const struct fit_comparison *const comparison = &report->comparison;
    struct table table;
    table_init(&table, "model,end,parameter,value,low_68,high_68,low_95,high_95,rms,chi2,aic", "tttnnnnnnnn");
    for (int i = 0; i < comparison->models; i++) {
        const struct fit_model *const model = &fit_models[comparison->ranked[i]];
        const struct fit_estimate *const e = &comparison->estimate[model->curve];
        for (int parameter = 0; parameter < e->parameters; parameter++)
            add_row(&table, model, e, parameter, report->request->bodies);
    }
    table_print(&table, format, file);
    table_clear(&table);
    if (format == FORMAT_TEXT) {
        fputs("\n", file);
        fit_report_remarks(report, file);
    }
}

/* ---- remarks ---- */

static void remark_data(const struct fit_data *data, FILE *file)
{
    double least = data->point[0].eps, most = data->point[0].eps;
    for (size_t i = 1; i < data->points; i++) {
        least = fmin(least, data->point[i].eps);
        most = fmax(most, data->point[i].eps);
    }
    fprintf(file, "%zu points%s: %.4g to %.4g m/s, eps %.4g to %.4g; ", data->points,
            data->bounce ? " from times of bounces" : "", data->point[0].speed_m_s,
            data->point[data->points - 1].speed_m_s, least, most);
    fputs(data->has_sigma ? "weights 1/eps_sigma^2.\n"
          : data->bounce  ? "the scatter gives the errors of the times.\n"
                          : "no eps_sigma: equal weights, and the scatter gives sigma.\n",
          file);
    if (data->unused)
        fprintf(file, "Columns that are not read: %s.\n", data->unused);
}

enum { P_VALUE = 32 };
static const char *p_value_text(char text[P_VALUE], const struct fit_estimate *e)
{
    if (isnan(e->p_value))
        return "p unknown";
    if (!(e->p_value >= 1e-300)) /* the tail functions underflow */
        return "p < 1e-300";
    snprintf(text, P_VALUE, "p = %.2g", e->p_value);
    return text;
}

static const char *verdict_on(const struct fit_estimate *e)
{
    return isnan(e->p_value) ? "too few" : fit_is_accepted(e) ? "fits" : "does not fit";
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
        char p_value[P_VALUE];
        fprintf(file, "  %-12s %-13s ", verdict_on(e), p_value_text(p_value, e));
        const char *separator = "";
        for (int k = i; k < c->models; k++)
            if (fit_models[c->ranked[k]].curve == curve) {
                fprintf(file, "%s%s", separator, fit_models[c->ranked[k]].title);
                separator = ", ";
            }
        fputs("\n", file);
    }
}

static void remark_verdict(const struct fit_comparison *c, FILE *file)
{
    int contacts = 0, accepted_contacts = 0, judged = 0; /* the power law is no law of contact */
    const struct fit_model *best = NULL;
    for (int i = 0; i < c->models; i++) {
        const struct fit_model *const model = &fit_models[c->ranked[i]];
        const bool contact = model->curve != FIT_POWER_LAW, known = !isnan(c->estimate[model->curve].p_value),
                   fits = known && fit_is_accepted(&c->estimate[model->curve]);
        judged += known;
        contacts += contact && known;
        accepted_contacts += contact && fits;
        best = fits && !best ? model : best;
    }
    if (judged == 0)
        fprintf(file, "The points are too few to judge any of these models. Of them, %s has the least AIC.\n",
                fit_models[c->ranked[0]].title);
    else if (!best)
        fprintf(file, "None of these models fits the data%s.\n",
                judged < c->models ? ", of those that the points are enough to judge" : "");
    else if (contacts > 0 && accepted_contacts == 0)
        fputs("None of these laws of contact fits the data. The power law does; it is a formula without a contact.\n",
              file);
    else
        fprintf(file, "Of the models that fit, %s has the least AIC.\n", best->title);
}

static void remark_outliers(const struct fit_report *report, FILE *file)
{
    const struct fit_outliers *const o = &report->outliers;
    for (int i = 0; i < o->count; i++) {
        const double distance = o->outlier[i].distance;
        fprintf(file, "Line %ld is an outlier: its %s is %.1f sigma too %s.\n", o->outlier[i].line,
                report->data->bounce ? "time" : "eps", fabs(distance),
                report->data->bounce ? (distance > 0 ? "late" : "early") : (distance > 0 ? "high" : "low"));
    }
    const struct fit_comparison *const c = &report->without_outliers;
    if (o->count == 0 || c->models == 0)
        return;
    const struct fit_model *const model = &fit_models[c->ranked[0]];
    const struct fit_estimate *const e = &c->estimate[model->curve];
    const struct fit_bodies *const bodies = report->request->bodies;
    char p_value[P_VALUE];
    fprintf(file, "Without %s %s has the least AIC (%s, %s):", o->count == 1 ? "it" : "these lines", model->title,
            verdict_on(e), p_value_text(p_value, e));
    for (int j = 0; j < e->parameters; j++) {
        const double a = fit_parameter_value(model, j, e->interval[j][LEVEL_95].low, bodies);
        const double b = fit_parameter_value(model, j, e->interval[j][LEVEL_95].high, bodies);
        fprintf(file, "%s %s = %.6g (95 %%: %.6g to %.6g)", j ? "," : "", fit_parameter_name(model, j, bodies),
                fit_parameter_value(model, j, e->theta[j], bodies), fmin(a, b), fmax(a, b));
    }
    fprintf(file, ".%s\n", report->request->robust ? "" : " --robust gives outliers little weight.");
}

void fit_report_remarks(const struct fit_report *report, FILE *file)
{
    const struct fit_comparison *const comparison = &report->comparison;
    remark_data(report->data, file);
    if (report->request->robust)
        fprintf(file, "Robust: Huber's function, linear beyond %g sigma.\n", FIT_HUBER);
    if (comparison->too_many_parameters > 0)
        fprintf(file, "%d model%s left out: more points than parameters are needed.\n", comparison->too_many_parameters,
                comparison->too_many_parameters == 1 ? " is" : "s are");
    if (comparison->models == 0)
        return;
    const struct fit_model *const first = &fit_models[comparison->ranked[0]];
    const struct fit_estimate *const e = &comparison->estimate[first->curve];
    if (report->data->bounce)
        fprintf(file, "sigma of a time %.2g s, of eps at a bounce %.2g, from the residuals of %s.\n", e->time_sigma_s,
                e->time_sigma_s * sqrt(e->ratio), first->title);
    remark_outliers(report, file);
    fprintf(file, "p: probability of so large %s, if the model is right; below %g it does not fit.\n",
            e->p_of_chi2 ? "a chi2" : "means of neighbouring residuals", FIT_SIGNIFICANCE);
    remark_curves(comparison, file);
    remark_verdict(comparison, file);
}
