/* SPDX-License-Identifier: MIT */
#include "embed/request.h"

#include <float.h>
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

/* The range of the header's type, and the attainable accuracy of eps */
struct type_limits {
    const char *name;
    double speed_least, speed_most, tolerance_least;
};

static double rounded(const struct embed_request *request, enum embed_number which)
{
    const double x = embed_number(request, which);
    return request->type == EMBED_FLOAT ? (double)(float)x : x;
}

static int check_range(const struct embed_request *request)
{
    static const struct type_limits limits[] = {[EMBED_DOUBLE] = {"double", 1e-270, 1e270, 1e-15},
                                                [EMBED_FLOAT] = {"float", (double)FLT_MIN, (double)FLT_MAX, 4e-7}};
    const struct type_limits *const type = &limits[request->type];
    const double min = rounded(request, EMBED_SPEED_MIN), max = rounded(request, EMBED_SPEED_MAX);
    const double tolerance = embed_number(request, EMBED_TOLERANCE);
    const struct decimal *const number = request->number;
    if (!(min >= type->speed_least))
        return usage_error("--speed-min %s m/s is too small for a %s; at least %.2g", number[EMBED_SPEED_MIN].text,
                           type->name, type->speed_least);
    if (!(max <= type->speed_most))
        return usage_error("--speed-max %s m/s is too large for a %s; at most %.2g", number[EMBED_SPEED_MAX].text,
                           type->name, type->speed_most);
    if (!(max > min))
        return usage_error("--speed-min %s is not below --speed-max %s", number[EMBED_SPEED_MIN].text,
                           number[EMBED_SPEED_MAX].text);
    if (!(tolerance >= type->tolerance_least && tolerance <= EMBED_COARSEST))
        return usage_error("--tolerance %s is not from %g to %g, what a %s can hold", number[EMBED_TOLERANCE].text,
                           type->tolerance_least, EMBED_COARSEST, type->name);
    return STATUS_OK;
}

static int check_contact(const struct embed_request *request)
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
    if (fmpq_is_zero(embed_number_of_body(request, EMBED_DISSIPATION_TIME, 1)->value) &&
        fmpq_is_zero(embed_number_of_body(request, EMBED_DISSIPATION_TIME, 2)->value))
        return usage_error("--dissipation-time: no dissipation, so eps is 1 at every speed; no header is needed");
    return STATUS_OK;
}

int embed_request_check(const struct embed_request *request)
{
    const int status = check_range(request);
    return status == STATUS_OK ? check_contact(request) : status;
}
