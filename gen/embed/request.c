/* SPDX-License-Identifier: MIT */
#include "embed/request.h"

#include <float.h>
#include <stddef.h>
#include <stdio.h>

#include "support/console.h"

const char *const embed_number_names[EMBED_NUMBERS] = {[EMBED_SPEED_MIN] = "speed-min",
                                                       [EMBED_SPEED_MAX] = "speed-max",
                                                       [EMBED_TOLERANCE] = "tolerance",
                                                       [EMBED_G_STAR] = "g-star",
                                                       [EMBED_YOUNG] = "young",
                                                       [EMBED_POISSON] = "poisson",
                                                       [EMBED_RADIUS] = "radius",
                                                       [EMBED_DENSITY] = "density",
                                                       [EMBED_MASS] = "mass",
                                                       [EMBED_DISSIPATION_TIME] = "dissipation-time",
                                                       [EMBED_YOUNG_2] = "young-2",
                                                       [EMBED_POISSON_2] = "poisson-2",
                                                       [EMBED_RADIUS_2] = "radius-2",
                                                       [EMBED_DENSITY_2] = "density-2",
                                                       [EMBED_MASS_2] = "mass-2",
                                                       [EMBED_DISSIPATION_TIME_2] = "dissipation-time-2",
                                                       [EMBED_BETA] = "beta",
                                                       [EMBED_AT] = "at",
                                                       [EMBED_STIFFNESS] = "stiffness",
                                                       [EMBED_DAMPING_COEFFICIENT] = "damping-coefficient",
                                                       [EMBED_EFFECTIVE_MASS] = "effective-mass"};
const char *const embed_purpose_names[] = {
    [PURPOSE_BALANCED] = "balanced", [PURPOSE_SCALAR] = "scalar", [PURPOSE_ARRAY] = "array", NULL};
const char *const embed_type_names[] = {[EMBED_DOUBLE] = "double", [EMBED_FLOAT] = "float", NULL};

const char *const embed_law_names[] = {[EMBED_VISCOELASTIC] = "viscoelastic",
                                       [EMBED_LINEAR] = "linear",
                                       [EMBED_TSUJI] = "tsuji",
                                       [EMBED_HUNT_CROSSLEY] = "hunt-crossley",
                                       [EMBED_HERTZ_DASHPOT] = "hertz-dashpot",
                                       [EMBED_LAWS] = NULL};

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

/* ---- the law ---- */

/* eps of Hunt and Crossley's law is that of beta for every elastic exponent; it has 3/2 here. */
static const struct {
    const char *elastic, *damping;
} exponents[EMBED_LAWS] = {[EMBED_VISCOELASTIC] = {"3/2", "1/2"},
                           [EMBED_LINEAR] = {"1", "0"},
                           [EMBED_TSUJI] = {"3/2", "1/4"},
                           [EMBED_HUNT_CROSSLEY] = {"3/2", "3/2"},
                           [EMBED_HERTZ_DASHPOT] = {"3/2", "0"}};

int embed_request_law(struct law *law, const struct embed_request *request)
{
    const char *const elastic = request->elastic ? request->elastic : exponents[request->law].elastic;
    const char *const damping = request->damping ? request->damping : exponents[request->law].damping;
    const char *const wrong = law_parse(law, elastic, damping);
    return wrong ? usage_error("--elastic %s --damping %s: %s", elastic, damping, wrong) : STATUS_OK;
}

const char *embed_law_options(char text[EMBED_LAW_OPTIONS], const struct embed_request *request)
{
    text[0] = '\0';
    if (request->elastic || request->damping)
        snprintf(text, EMBED_LAW_OPTIONS, "%s%s%s%s", request->elastic ? " --elastic " : "",
                 request->elastic ? request->elastic : "", request->damping ? " --damping " : "",
                 request->damping ? request->damping : "");
    else if (request->law != EMBED_VISCOELASTIC)
        snprintf(text, EMBED_LAW_OPTIONS, " --law %s", embed_law_names[request->law]);
    return text;
}

/* Where q = 0 eps is that of the damping ratio alone. */
static int check_law(const struct law *law)
{
    if (!law_is_linear(law))
        return STATUS_OK;
    const char *const name = law->b.num == 0 ? "linear" : "tsuji";
    return usage_error("in the law %s eps is the same at every speed, that of the damping ratio zeta alone: "
                       "cor_%s_eps_zero_overlap(zeta) and cor_%s_eps_zero_force(zeta) of cor/law.h",
                       law_equation(law).text, name, name);
}

/* ---- the contact ---- */

/* The numbers of one way to say how strong the damping is */
struct contact_way {
    enum embed_number first, last;
};

static int given_among(const struct embed_request *request, struct contact_way way)
{
    int count = 0;
    for (enum embed_number number = way.first; number <= way.last; number++)
        count += embed_given(request, number);
    return count;
}

static int check_materials(const struct embed_request *request, const char *rule)
{
    static const enum embed_number body[] = {EMBED_YOUNG, EMBED_POISSON, EMBED_RADIUS, EMBED_DISSIPATION_TIME};
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

static int check_contact(const struct embed_request *request, const struct law *law)
{
    enum { G_STAR, MATERIALS, BETA, FORCE, WAYS };
    static const struct contact_way way[WAYS] = {[G_STAR] = {EMBED_G_STAR, EMBED_G_STAR},
                                                 [MATERIALS] = {EMBED_YOUNG, EMBED_DISSIPATION_TIME_2},
                                                 [BETA] = {EMBED_BETA, EMBED_AT},
                                                 [FORCE] = {EMBED_STIFFNESS, EMBED_EFFECTIVE_MASS}};
    static const char *const name[WAYS] = {"--g-star", "materials", "--beta", "--stiffness with --damping-coefficient"};
    const char *const rule =
        law_is_sphere(law)
            ? "a scene has --g-star, or --young, --poisson, --radius, --dissipation-time and --density or --mass, or "
              "--beta and --at, or --stiffness, --damping-coefficient and --effective-mass"
            : "a scene of this law has --g-star, or --beta and --at, or --stiffness, --damping-coefficient and "
              "--effective-mass";
    int used = WAYS;
    for (int i = 0; i < WAYS; i++) {
        if (given_among(request, way[i]) == 0 && !(i == MATERIALS && request->wall))
            continue;
        if (used < WAYS)
            return usage_error("%s and %s exclude each other: %s", name[used], name[i], rule);
        used = i;
    }
    if (used == WAYS)
        return usage_error("a scene needs a contact: %s", rule);
    if (used == MATERIALS)
        return law_is_sphere(law) ? check_materials(request, rule)
                                  : usage_error("materials make a contact of viscoelastic spheres only: %s", rule);
    for (enum embed_number number = way[used].first; number <= way[used].last; number++)
        if (!embed_given(request, number))
            return usage_error("--%s is missing: %s", embed_number_names[number], rule);
    return STATUS_OK;
}

int embed_request_check(const struct embed_request *request)
{
    struct law law;
    int status = embed_request_law(&law, request);
    if (status == STATUS_OK)
        status = check_law(&law);
    if (status == STATUS_OK)
        status = check_range(request);
    return status == STATUS_OK ? check_contact(request, &law) : status;
}
