/* SPDX-License-Identifier: MIT */
#include "fit/compare.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "support/console.h"

/* ---- which models ---- */

static int refuse_model(const char *name, size_t length)
{
    char allowed[256] = "all";
    for (size_t i = 0; i < fit_model_count; i++) {
        const size_t used = strlen(allowed);
        if (i == 0 || strcmp(fit_models[i].name, fit_models[i - 1].name) != 0)
            snprintf(allowed + used, sizeof allowed - used, ", %s", fit_models[i].name);
    }
    return usage_error("--law: '%.*s' is not a model; allowed: %s, or several, as viscoelastic,power-law", (int)length,
                       name, allowed);
}

static bool end_matches(const struct fit_model *model, const char *end)
{
    return !end || strcmp(model->end, end) == 0 || strcmp(model->end, "both") == 0;
}

int fit_request_models(struct fit_request *request, const char *names, const char *end)
{
    int marked = 0;
    memset(request->wanted, 0, sizeof request->wanted);
    for (const char *name = names;; name++) {
        const size_t length = strcspn(name, ",");
        const bool all = length == 3 && strncmp(name, "all", length) == 0;
        bool known = all;
        for (size_t i = 0; i < fit_model_count; i++) {
            if (!all && (strlen(fit_models[i].name) != length || strncmp(fit_models[i].name, name, length) != 0))
                continue;
            known = true;
            if (!request->wanted[i] && end_matches(&fit_models[i], end)) {
                request->wanted[i] = true;
                marked++;
            }
        }
        if (!known)
            return refuse_model(name, length);
        name += length;
        if (*name == '\0')
            break;
    }
    return marked > 0
               ? STATUS_OK
               : usage_error("--end %s: no model of --law %s ends there; allowed: another end or model", end, names);
}

/* ---- fits ---- */

static void fit_curves(struct fit_comparison *c, const struct fit_data *data, const struct fit_request *request)
{
    for (size_t i = 0; i < fit_model_count; i++) {
        const enum fit_curve curve = fit_models[i].curve;
        if (!request->wanted[i] || c->used[curve])
            continue;
        progress("fitting", (long)i, (long)fit_model_count);
        fit_estimate_curve(&c->estimate[curve], curve, data, request->robust);
        c->used[curve] = c->estimate[curve].fitted;
    }
    progress_end();
}

static void set_aic(struct fit_comparison *c, const struct fit_data *data, bool robust)
{
    double scale = INFINITY;
    for (int curve = 0; curve < FIT_CURVES; curve++)
        if (c->used[curve] && c->estimate[curve].scale < scale)
            scale = c->estimate[curve].scale;
    for (int curve = 0; curve < FIT_CURVES; curve++)
        if (c->used[curve])
            c->estimate[curve].aic = fit_aic(&c->estimate[curve], data, robust, scale);
}

static void rank_models(struct fit_comparison *c, const struct fit_request *request)
{
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

void fit_compare(struct fit_comparison *comparison, const struct fit_data *data, const struct fit_request *request)
{
    *comparison = (struct fit_comparison){.models = 0};
    fit_curves(comparison, data, request);
    set_aic(comparison, data, request->robust);
    rank_models(comparison, request);
}

bool fit_is_accepted(const struct fit_estimate *estimate)
{
    return !(estimate->p_value < FIT_SIGNIFICANCE);
}
