/* SPDX-License-Identifier: MIT */
#include "plan/plan.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"
#include "support/decimal.h"
#include "support/emit_c.h"

const char *const plan_quantity_names[] = {
    [PLAN_EPS] = "eps", [PLAN_CONTACT_TIME] = "contact-time", [PLAN_COMPRESSION] = "compression", NULL};

static const char *const verdicts[] = {"chosen", "meets", "misses", "outside", "shown"};

static double *plan_numbers(slong n)
{
    double *x = xmalloc((size_t)n * sizeof *x);
    for (slong i = 0; i < n; i++)
        x[i] = (double)NAN;
    return x;
}

void plan_init(struct plan *plan, slong points, double speed_min, double speed_max)
{
    *plan = (struct plan){.points = points, .chosen = -1};
    plan->speed = plan_numbers(4 * points);
    plan->at = plan->speed + points;
    plan->truth = plan->at + points;
    plan->uncertainty = plan->truth + points;
    for (slong i = 0; i < points; i++) {
        const double speed = speed_min * pow(speed_max / speed_min, (double)i / (double)(points - 1));
        plan->speed[i] = i == 0 ? speed_min : i + 1 == points ? speed_max : fmin(fmax(speed, speed_min), speed_max);
        plan->uncertainty[i] = 0;
    }
}

void plan_clear(struct plan *plan)
{
    for (int i = 0; i < plan->models; i++) {
        free(plan->model[i].value);
        free(plan->model[i].error);
        free(plan->model[i].use);
    }
    free(plan->model);
    free(plan->speed);
    free(plan->title);
    free(plan->remark);
    *plan = (struct plan){.chosen = -1};
}

struct plan_model *plan_add(struct plan *plan, const char *format, ...)
{
    plan->model = xgrow(plan->model, (size_t)plan->models, sizeof *plan->model);
    struct plan_model *model = &plan->model[plan->models++];
    *model = (struct plan_model){.value = plan_numbers(plan->points), .error = plan_numbers(plan->points)};
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(model->name, sizeof model->name, format, arguments);
    va_end(arguments);
    return model;
}

void plan_model_is(const struct plan *plan, struct plan_model *model, double cost, const char *leaves_out, char *use)
{
    model->cost = cost;
    model->leaves_out = leaves_out;
    model->use = use;
    for (slong i = 0; i < plan->points && !model->promised; i++) {
        const double off = fabs(model->value[i] - plan->truth[i]);
        model->error[i] = plan->relative && off > 0 ? off / plan->truth[i] : off;
    }
}

static void model_judge(const struct plan *plan, struct plan_model *model)
{
    double worst = 0, with = 0;
    model->worst_at = 0;
    for (slong i = 0; i < plan->points; i++) {
        const double error = isnan(model->error[i]) ? (double)INFINITY : model->error[i];
        with = fmax(with, error + (model->promised ? 0 : plan->uncertainty[i]));
        if (error > worst) {
            worst = error;
            model->worst_at = i;
        }
    }
    model->worst = fmax(worst, model->elsewhere);
    with = fmax(with, model->elsewhere);
    model->verdict = model->shown                            ? PLAN_SHOWN
                     : model->outside || isinf(worst)        ? PLAN_OUTSIDE
                     : with <= PLAN_MARGIN * plan->tolerance ? PLAN_MEETS
                                                             : PLAN_MISSES;
}

void plan_choose(struct plan *plan)
{
    plan->chosen = -1;
    for (int i = 0; plan->model && i < plan->models; i++) {
        struct plan_model *model = &plan->model[i];
        model_judge(plan, model);
        const struct plan_model *best = plan->chosen < 0 ? NULL : &plan->model[plan->chosen];
        if (model->verdict == PLAN_MEETS &&
            (!best || model->cost < best->cost || (!(model->cost > best->cost) && model->worst < best->worst)))
            plan->chosen = i;
    }
    if (plan->model && plan->chosen >= 0)
        plan->model[plan->chosen].verdict = PLAN_CHOSEN;
}

/* ---- output ---- */

/* Prints a cost with two digits, such as "0", "3.4 ns" or "160 us". */
static void print_cost(char *text, size_t size, double ns)
{
    static const char *const unit[] = {"ns", "us", "ms", "s"};
    int k = 0;
    snprintf(text, size, "%.1e", ns);
    for (ns = strtod(text, NULL); ns >= 1000 && k < 3; k++)
        ns /= 1000;
    if (ns > 0)
        snprintf(text, size, "%g %s", ns, unit[k]);
    else
        snprintf(text, size, "0");
}

/* Prints an error bound with two digits, rounded up. */
static void print_error(char *text, size_t size, double error)
{
    if (!(error > 0) || isinf(error)) {
        snprintf(text, size, "%s", isinf(error) ? "none" : "0");
        return;
    }
    snprintf(text, size, "%.2g", strtod(emit_bound(error * (1 - 1e-12)).text, NULL));
}

static void print_text(const struct plan *plan, FILE *file)
{
    char error[32], cost[32], tolerance[DECIMAL_TEXT];
    fprintf(file, "%s", plan->title);
    fprintf(file, "Required: %s, %s at most %s.\n\n", plan->quantity, plan->relative ? "relative error" : "error",
            decimal_text(tolerance, plan->tolerance));
    fprintf(file, "  %-39s  %-8s  %-8s  %-8s  %-8s  %s\n", "model", "error",
            strcmp(plan->argument, "beta") == 0 ? "at beta" : "at speed", "cost", "", "leaves out");
    for (int i = 0; i < plan->models; i++) {
        const struct plan_model *m = &plan->model[i];
        print_error(error, sizeof error, m->worst);
        print_cost(cost, sizeof cost, m->cost);
        fprintf(file, "%c %-39s  %-8s  %-8.4g  %-8s  %-8s  %s\n", i == plan->chosen ? '>' : ' ', m->name, error,
                plan->at[m->worst_at], cost, i == plan->chosen ? "" : verdicts[m->verdict], m->leaves_out);
    }
    fprintf(file, "\n");
    if (plan->chosen < 0) {
        fprintf(file, "No model meets the tolerance.\n\n");
    } else {
        const struct plan_model *m = &plan->model[plan->chosen];
        print_error(error, sizeof error, m->worst);
        print_cost(cost, sizeof cost, m->cost);
        fprintf(file, "Choice: %s. Error %s, cost %s; leaves out %s.\n\n", m->name, error, cost, m->leaves_out);
        for (const char *line = m->use; line && *line; line = strchr(line, '\n') + 1)
            fprintf(file, "    %.*s\n", (int)strcspn(line, "\n"), line);
        fprintf(file, "\n");
    }
    if (plan->remark)
        fprintf(file, "%s\n", plan->remark);
    fprintf(file, "%s", plan->note);
}

void plan_print(const struct plan *plan, enum output_format format, FILE *file)
{
    if (format == FORMAT_TEXT) {
        print_text(plan, file);
        return;
    }
    char header[2 * PLAN_NAME], text[DECIMAL_TEXT];
    struct table table;
    snprintf(header, sizeof header, "model,%s,value,error,cost,uncertainty,verdict", plan->argument);
    table_init(&table, header, "tnnnnnt");
    for (int i = 0; i < plan->models; i++)
        for (slong k = 0; k < plan->points; k++) {
            const struct plan_model *const m = &plan->model[i];
            const double number[] = {plan->at[k], m->value[k], m->error[k], m->cost, plan->uncertainty[k]};
            table_add_text(&table, m->name);
            for (size_t j = 0; j < sizeof number / sizeof *number; j++)
                table_add_text(&table, isfinite(number[j]) ? decimal_text(text, number[j]) : "nan");
            table_add_text(&table, verdicts[m->verdict]);
        }
    table_print(&table, format, file);
    table_clear(&table);
}
