/* SPDX-License-Identifier: MIT */
#include "fit/compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"

/* ---- which models ---- */

static int refuse_model(const char *name, size_t length)
{
    const char *allowed[FIT_MAX_MODELS + 3] = {"all"};
    char word[64];
    size_t n = 1;
    for (size_t i = 0; i < fit_model_count; i++)
        if (i == 0 || strcmp(fit_models[i].name, fit_models[i - 1].name) != 0)
            allowed[n++] = fit_models[i].name;
    allowed[n] = "or several, as viscoelastic,power-law";
    snprintf(word, sizeof word, "%.*s", (int)length, name);
    return refuse_word(word, allowed, "", "--law: '%.*s' is not a model", (int)length, name);
}

static bool is_word(const char *text, size_t length, const char *word)
{
    return strlen(word) == length && strncmp(text, word, length) == 0;
}

int fit_request_models(struct fit_request *request, const char *names, const char *end)
{
    bool marked = false;
    memset(request->wanted, 0, sizeof request->wanted);
    for (const char *name = names, *next; name; name = next) {
        const size_t length = strcspn(name, ",");
        const bool all = is_word(name, length, "all");
        bool known = all;
        next = name[length] ? name + length + 1 : NULL;
        for (size_t i = 0; i < fit_model_count; i++) {
            const struct fit_model *const m = &fit_models[i];
            const bool named = all || is_word(name, length, m->name);
            const bool ends = !end || strcmp(m->end, end) == 0 || strcmp(m->end, "both") == 0;
            known = known || named;
            request->wanted[i] = request->wanted[i] || (named && ends);
            marked = marked || request->wanted[i];
        }
        if (!known)
            return refuse_model(name, length);
    }
    return marked ? STATUS_OK
                  : usage_error("--end %s: no model of --law %s ends there; allowed: another end or model", end, names);
}

/* ---- fits ---- */

void fit_compare(struct fit_comparison *c, const struct fit_data *data, const struct fit_request *request)
{
    const struct fit_estimate *best = NULL; /* of the least scale */
    *c = (struct fit_comparison){.models = 0};
    for (size_t i = 0; i < fit_model_count; i++) {
        const enum fit_curve curve = fit_models[i].curve;
        if (!request->wanted[i] || c->used[curve])
            continue;
        progress("fitting", (long)i, (long)fit_model_count);
        fit_estimate_curve(&c->estimate[curve], curve, data, request->robust);
        c->used[curve] = c->estimate[curve].fitted;
    }
    progress_end();
    for (int curve = 0; curve < FIT_CURVES; curve++)
        if (c->used[curve] && (!best || c->estimate[curve].scale < best->scale))
            best = &c->estimate[curve];
    for (int curve = 0; curve < FIT_CURVES; curve++)
        if (c->used[curve])
            c->estimate[curve].aic = fit_aic(&c->estimate[curve], data, request->robust, best);
    for (int i = 0; i < (int)fit_model_count; i++) {
        const enum fit_curve curve = fit_models[i].curve;
        if (!request->wanted[i])
            continue;
        if (!c->used[curve]) {
            c->too_many_parameters++;
            continue;
        }
        int place = c->models++;
        for (; place > 0 && c->estimate[fit_models[c->ranked[place - 1]].curve].aic > c->estimate[curve].aic; place--)
            c->ranked[place] = c->ranked[place - 1];
        c->ranked[place] = i;
    }
}

bool fit_is_accepted(const struct fit_estimate *estimate)
{
    return !(estimate->p_value < FIT_SIGNIFICANCE);
}

/* ---- outliers ---- */

/* The largest distance in size, or that of the line if it is not 0 */
static struct fit_distance farthest(const struct fit_data *data, const struct fit_estimate *e, long line)
{
    struct fit_distance *const at = xmalloc(fit_lines(data) * sizeof *at), found;
    size_t most = 0;
    fit_distances(at, e, data);
    for (size_t i = 1; i < fit_lines(data); i++)
        if (line ? at[i].line == line : fabs(at[i].distance) > fabs(at[most].distance))
            most = i;
    found = at[most];
    free(at);
    return found;
}

/* The data without the points of the lines, or the bounces with their times, but for line `except` if it is not
 * negative; `rest` is cleared before. */
static void set_rest(struct fit_data *rest, const struct fit_data *data, const struct fit_outliers *o, int except)
{
    bool *const left_out = xmalloc(data->points * sizeof *left_out);
    memset(left_out, 0, data->points * sizeof *left_out);
    fit_data_clear(rest);
    for (int k = 0; k < o->count; k++) {
        const long line = k == except ? -1 : o->outlier[k].line;
        for (size_t i = 0; i < data->points; i++) {
            const struct fit_bounce *const b = data->bounce ? &data->bounce[i] : NULL;
            if (b ? b->line[0] == line || b->line[1] == line || b->line[2] == line : data->point[i].line == line)
                left_out[b ? b->point : i] = true;
        }
    }
    fit_data_copy(rest, data, left_out);
    free(left_out);
}

/* Collects suspicious lines; `rest` holds the others. */
static void collect_suspicious(struct fit_outliers *o, const struct fit_data *data)
{
    set_rest(&o->rest, data, o, -1);
    while (o->count < FIT_MAX_OUTLIERS) {
        struct fit_estimate e;
        fit_estimate_curve(&e, o->curve, &o->rest, true);
        if (!e.fitted)
            break;
        const struct fit_distance far = farthest(&o->rest, &e, 0);
        if ((double)o->rest.points * erfc(fabs(far.distance) / sqrt(2)) > 0.05)
            break;
        o->outlier[o->count++] = far;
        set_rest(&o->rest, data, o, -1);
        if (o->rest.points < 3 * data->points / 4) { /* too many: the last one stays */
            o->count--;
            set_rest(&o->rest, data, o, -1);
            break;
        }
    }
}

/* The least Q of least squares of points */
static double squares(const struct fit_estimate *e, size_t points)
{
    return isnan(e->scale) ? e->chi2 : e->scale * e->scale * (double)(points - (size_t)e->parameters);
}

/* How far line i lies from the least squares e of the rest, and whether that is significant among so many lines */
static bool is_significant(struct fit_outliers *o, int i, const struct fit_estimate *e, const struct fit_data *data)
{
    const size_t freedom = o->rest.points - (size_t)e->parameters;
    const double spread = data->has_sigma ? fmax(sqrt(e->chi2 / (double)freedom), 1) : 1;
    struct fit_distance *const line = &o->outlier[i];
    struct fit_data with = {0};
    struct fit_estimate f;
    set_rest(&with, data, o, i);
    fit_estimate_curve(&f, o->curve, &with, false);
    *line = farthest(&with, e, line->line);
    if (data->bounce) { /* without the bounces of this time another lambda may look right by chance */
        const double f_freedom = (double)(with.points - (size_t)f.parameters);
        double other = farthest(&with, &f, line->line).distance;
        other *= sqrt((f_freedom - 1) / fmax(f_freedom - other * other, 1e-9));
        line->distance = fabs(other) < fabs(line->distance) ? other : line->distance;
    } else {
        const double change = squares(&f, with.points) - squares(e, o->rest.points);
        line->distance = copysign(sqrt(fmax(change, 0)), line->distance) / (data->has_sigma ? 1 : e->scale);
    }
    fit_data_clear(&with);
    const double t = line->distance / spread;
    const double tail = data->has_sigma && !(spread > 1) ? erfc(fabs(t) / sqrt(2)) : fisher_tail(t * t, 1, freedom);
    return (double)fit_lines(data) * tail < FIT_SIGNIFICANCE;
}

/* Puts lines back, the nearest first, until each that is left out is too far from the rest. */
static void keep_significant(struct fit_outliers *o, const struct fit_data *data)
{
    for (int nearest = 0; nearest >= 0 && o->count > 0;) {
        struct fit_estimate e;
        fit_estimate_curve(&e, o->curve, &o->rest, false);
        nearest = -1;
        for (int i = 0; i < o->count; i++)
            if (!is_significant(o, i, &e, data) &&
                (nearest < 0 || fabs(o->outlier[i].distance) < fabs(o->outlier[nearest].distance)))
                nearest = i;
        if (nearest < 0)
            break;
        o->outlier[nearest] = o->outlier[--o->count];
        set_rest(&o->rest, data, o, -1);
    }
}

static int compare_lines(const void *a, const void *b)
{
    const long x = ((const struct fit_distance *)a)->line, y = ((const struct fit_distance *)b)->line;
    return x < y ? -1 : x > y;
}

void fit_find_outliers(struct fit_outliers *outliers, const struct fit_data *data, const struct fit_request *request)
{
    struct fit_request robust = *request;
    struct fit_comparison comparison;
    *outliers = (struct fit_outliers){.count = 0};
    robust.robust = true;
    fit_compare(&comparison, data, &robust);
    if (data->point[0].line == 0 || comparison.models == 0)
        return;
    outliers->curve = fit_models[comparison.ranked[0]].curve;
    collect_suspicious(outliers, data);
    if (outliers->count > 0)
        keep_significant(outliers, data);
    qsort(outliers->outlier, (size_t)outliers->count, sizeof *outliers->outlier, compare_lines);
    if (outliers->count == 0)
        fit_data_clear(&outliers->rest);
}
