/* SPDX-License-Identifier: MIT */
#include "embed/request.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "support/console.h"

const char *const embed_purpose_names[] = {
    [PURPOSE_BALANCED] = "balanced", [PURPOSE_SCALAR] = "scalar", [PURPOSE_ARRAY] = "array", NULL};
const char *const embed_type_names[] = {[EMBED_DOUBLE] = "double", [EMBED_FLOAT] = "float", NULL};

bool embed_given(const struct embed_request *request, int number)
{
    return request->number[number].text != NULL;
}

double embed_number(const struct embed_request *request, int number)
{
    return decimal_value(&request->number[number]);
}

int embed_number_in_order(int i)
{
    return (i + EMBED_SPEED_MIN) % EMBED_NUMBERS;
}

const char *embed_number_name(int number)
{
    static const char *const range[] = {"speed-min", "speed-max", "tolerance"};
    return number < COR_SCENE_NUMBERS ? cor_scene_number_names[number] : range[number - COR_SCENE_NUMBERS];
}

const struct decimal *embed_number_of_body(const struct embed_request *request, int number, int body)
{
    const int second = number + COR_SCENE_BODY;
    return &request->number[body == 2 && embed_given(request, second) ? second : number];
}

bool embed_mass_is_given(const struct embed_request *request, int body)
{
    const bool own = body == 2 && (embed_given(request, COR_SCENE_MASS_2) || embed_given(request, COR_SCENE_DENSITY_2));
    return embed_given(request, own ? COR_SCENE_MASS_2 : COR_SCENE_MASS);
}

/* The range of the header's type, and the attainable accuracy of eps */
struct type_limits {
    const char *name;
    double speed_least, speed_most, tolerance_least;
};

static double rounded(const struct embed_request *request, int which)
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

int embed_request_law(struct law *law, const struct embed_request *request)
{
    const struct cor_exponents *const named = &cor_law_exponents[request->law];
    const struct ratio_text a = ratio_text(ratio_make(named->elastic, named->denominator)),
                            b = ratio_text(ratio_make(named->damping, named->denominator));
    const char *const elastic = request->elastic ? request->elastic : a.text;
    const char *const damping = request->damping ? request->damping : b.text;
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
    else if (request->law != COR_LAW_VISCOELASTIC)
        snprintf(text, EMBED_LAW_OPTIONS, " --law %s", cor_law_names[request->law]);
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

/* ---- the scene ---- */

/* "ETA1,ETA2", both not negative; -1 for what is something else */
static void parse_viscosity(double eta[2], const char *text)
{
    const char *const comma = strchr(text, ',');
    eta[0] = eta[1] = -1;
    for (int i = 0; comma && i < 2; i++) {
        char part[64];
        struct decimal x = {0};
        const char *const start = i == 0 ? text : comma + 1;
        const size_t length = i == 0 ? (size_t)(comma - text) : strlen(start);
        if (length < sizeof part) {
            snprintf(part, sizeof part, "%.*s", (int)length, start);
            if (decimal_parse(&x, part, DECIMAL_EXPONENT_DIGITS) && x.forms == DECIMAL_PLAIN)
                eta[i] = decimal_value(&x);
        }
        decimal_clear(&x);
    }
}

int embed_request_scene(struct cor_scene *scene, const struct embed_request *request)
{
    struct law law;
    const int status = embed_request_law(&law, request);
    if (status != STATUS_OK)
        return status;
    *scene = (struct cor_scene){.law = {(int)law.ad, (int)law.bd, (int)law.d},
                                .plate = request->law == COR_LAW_PLATE,
                                .wall = request->wall,
                                .end = request->end};
    for (int i = 0; i < COR_SCENE_NUMBERS; i++)
        scene->number[i] = embed_given(request, i) ? embed_number(request, i) : (double)NAN;
    for (int body = 0; body < 2; body++)
        if (request->viscosity[body])
            parse_viscosity(&scene->number[COR_SCENE_VISCOSITY + body * COR_SCENE_BODY], request->viscosity[body]);
    return STATUS_OK;
}

int embed_refuse_bodies(const struct cor_scene_fault *fault, const char *rule)
{
    char text[COR_SCENE_FAULT_TEXT];
    cor_scene_fault_text(text, sizeof text, fault, "", rule);
    return usage_error("%s", text);
}

/* ---- the contact of a header ---- */

static int given_among(const struct embed_request *request, int first, int last)
{
    int count = 0;
    for (int number = first; number <= last; number++)
        count += embed_given(request, number);
    return count;
}

static int check_materials(const struct embed_request *request, const char *rule)
{
    struct cor_scene scene;
    struct cor_scene_fault fault;
    if (embed_request_scene(&scene, request) != STATUS_OK)
        return STATUS_USAGE;
    if (cor_scene_check_bodies(&fault, &scene, COR_SCENE_DISSIPATES) != COR_FAULT_NONE)
        return embed_refuse_bodies(&fault, rule);
    if (fmpq_is_zero(embed_number_of_body(request, COR_SCENE_DISSIPATION_TIME, 1)->value) &&
        fmpq_is_zero(embed_number_of_body(request, COR_SCENE_DISSIPATION_TIME, 2)->value))
        return usage_error("--dissipation-time: no dissipation, so eps is 1 at every speed; no header is needed");
    return STATUS_OK;
}

static int check_contact(const struct embed_request *request, const struct law *law)
{
    /* the numbers of one way to say how strong the damping is */
    static const struct {
        const char *name;
        int first, last;
    } way[] = {{"--g-star", COR_SCENE_G_STAR, COR_SCENE_G_STAR},
               {"materials", COR_SCENE_YOUNG, COR_SCENE_DISSIPATION_TIME_2},
               {"--beta", COR_SCENE_BETA, COR_SCENE_AT},
               {"--stiffness with --damping-coefficient", COR_SCENE_STIFFNESS, COR_SCENE_EFFECTIVE_MASS}};
    enum { MATERIALS = 1, WAYS = sizeof way / sizeof *way };
    const char *const rule =
        law_is_sphere(law)
            ? "a scene has --g-star, or --young, --poisson, --radius, --dissipation-time and --density or --mass, or "
              "--beta and --at, or --stiffness, --damping-coefficient and --effective-mass"
            : "a scene of this law has --g-star, or --beta and --at, or --stiffness, --damping-coefficient and "
              "--effective-mass";
    int used = WAYS;
    for (int i = 0; i < WAYS; i++) {
        if (given_among(request, way[i].first, way[i].last) == 0 && !(i == MATERIALS && request->wall))
            continue;
        if (used < WAYS)
            return usage_error("%s and %s exclude each other: %s", way[used].name, way[i].name, rule);
        used = i;
    }
    if (used == WAYS)
        return usage_error("a scene needs a contact: %s", rule);
    if (used == MATERIALS)
        return law_is_sphere(law) ? check_materials(request, rule)
                                  : usage_error("materials make a contact of viscoelastic spheres only: %s", rule);
    for (int number = way[used].first; number <= way[used].last; number++)
        if (!embed_given(request, number))
            return usage_error("--%s is missing: %s", embed_number_name(number), rule);
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
