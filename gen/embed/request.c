/* SPDX-License-Identifier: MIT */
#include "embed/request.h"

#include <stddef.h>

#include "support/console.h"

const char *const embed_number_names[EMBED_NUMBERS] = {
    [EMBED_SPEED_MIN] = "speed-min", [EMBED_SPEED_MAX] = "speed-max",
    [EMBED_TOLERANCE] = "tolerance", [EMBED_G_STAR] = "g-star",
    [EMBED_YOUNG] = "young",         [EMBED_POISSON] = "poisson",
    [EMBED_RADIUS] = "radius",       [EMBED_DENSITY] = "density",
    [EMBED_MASS] = "mass",           [EMBED_DISSIPATION_TIME] = "dissipation-time",
    [EMBED_YOUNG_2] = "young-2",     [EMBED_POISSON_2] = "poisson-2",
    [EMBED_RADIUS_2] = "radius-2",   [EMBED_DENSITY_2] = "density-2",
    [EMBED_MASS_2] = "mass-2",       [EMBED_DISSIPATION_TIME_2] = "dissipation-time-2"};
const char *const embed_purpose_names[] = {
    [PURPOSE_BALANCED] = "balanced", [PURPOSE_SCALAR] = "scalar", [PURPOSE_ARRAY] = "array", NULL};
const char *const embed_type_names[] = {[EMBED_DOUBLE] = "double", [EMBED_FLOAT] = "float", NULL};

bool embed_given(const struct embed_request *request, enum embed_number which)
{
    return request->number[which].text != NULL;
}

double embed_number(const struct embed_request *request, enum embed_number which)
{
    return decimal_value(&request->number[which]);
}

const struct decimal *embed_number_of_body(const struct embed_request *request, enum embed_number which, int body)
{
    const enum embed_number second = which + EMBED_BODY;
    return &request->number[body == 2 && embed_given(request, second) ? second : which];
}

bool embed_mass_is_given(const struct embed_request *request, int body)
{
    const bool own = body == 2 && (embed_given(request, EMBED_MASS_2) || embed_given(request, EMBED_DENSITY_2));
    return embed_given(request, own ? EMBED_MASS_2 : EMBED_MASS);
}

int embed_request_check(const struct embed_request *request)
{
    static const enum embed_number body[] = {EMBED_YOUNG, EMBED_POISSON, EMBED_RADIUS, EMBED_DISSIPATION_TIME};
    static const char rule[] =
        "a scene has --g-star, or --young, --poisson, --radius, --dissipation-time and --density or --mass";
    bool any = request->wall;
    for (enum embed_number number = EMBED_YOUNG; number < EMBED_NUMBERS; number++)
        any = any || embed_given(request, number);
    if (embed_given(request, EMBED_G_STAR))
        return any ? usage_error("--g-star and materials exclude each other: %s", rule) : STATUS_OK;
    if (!any)
        return usage_error("a scene needs a contact: %s", rule);
    for (size_t i = 0; i < sizeof body / sizeof *body; i++)
        if (!embed_given(request, body[i]))
            return usage_error("--%s is missing: %s", embed_number_names[body[i]], rule);
    if (embed_given(request, EMBED_DENSITY) == embed_given(request, EMBED_MASS))
        return usage_error("--density and --mass: give one of them; %s", rule);
    if (embed_given(request, EMBED_DENSITY_2) && embed_given(request, EMBED_MASS_2))
        return usage_error("--density-2 and --mass-2 exclude each other");
    if (request->wall && (embed_given(request, EMBED_RADIUS_2) || embed_given(request, EMBED_DENSITY_2) ||
                          embed_given(request, EMBED_MASS_2)))
        return usage_error("--wall is flat and held fast: no --radius-2, --density-2 or --mass-2");
    return STATUS_OK;
}
