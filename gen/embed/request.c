/* SPDX-License-Identifier: MIT */
#include "embed/request.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "runtime/core/laws.h"
#include "support/console.h"

const char *const embed_purpose_names[] = {[PURPOSE_BALANCED] = "balanced",
                                           [PURPOSE_SCALAR] = "scalar",
                                           [PURPOSE_ARRAY] = "array",
                                           [PURPOSE_REBOUND] = "rebound",
                                           NULL};
const char *const embed_law_names[] = {COR_CONTACT_LAWS(COR_LAW_NAME)[EMBED_LAW_POWER] = "power-law",
                                       [EMBED_LAW_EXPONENTIAL] = "exponential", [EMBED_LAW_TABLE] = "table", NULL};
const char *const embed_type_names[] = {[EMBED_DOUBLE] = "double", [EMBED_FLOAT] = "float", NULL};
const char *const embed_adhesion_names[] = {
    [COR_ADHESION_NONE] = "none", [COR_ADHESION_DMT] = "dmt", [COR_ADHESION_JKR] = "jkr", NULL};

bool embed_given(const struct embed_request *request, int number)
{
    return request->number[number].text != NULL;
}

double embed_number(const struct embed_request *request, int number)
{
    return decimal_value(&request->number[number]);
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

int embed_check_numbers(const struct decimal *number, double min, double max, double least, double most)
{
    const double tolerance = decimal_value(&number[EMBED_TOLERANCE]);
    if (!(max > min))
        return usage_error(
            "--speed-min %s is not below --speed-max %s; write for example --speed-min 0.01 --speed-max 10",
            number[EMBED_SPEED_MIN].text, number[EMBED_SPEED_MAX].text);
    if (!(tolerance >= least && tolerance <= most && tolerance < 1))
        return usage_error("--tolerance: '%s' is not a number from %g to %s%g", number[EMBED_TOLERANCE].text, least,
                           most < 1 ? "" : "below ", most);
    return STATUS_OK;
}

int embed_request_check(const struct embed_request *request)
{
    /* allowed speeds, and least tolerance, of a header of each type */
    static const struct limits {
        const char *name;
        double speed_least, speed_most, tolerance_least;
    } limits[] = {[EMBED_DOUBLE] = {"double", 1e-270, 1e270, 1e-15},
                  [EMBED_FLOAT] = {"float", (double)FLT_MIN, (double)FLT_MAX, 4e-7}};
    const struct limits *const type = &limits[request->type];
    const struct decimal *const number = request->number;
    double min = embed_number(request, EMBED_SPEED_MIN), max = embed_number(request, EMBED_SPEED_MAX);
    if (request->type == EMBED_FLOAT) {
        min = (double)(float)min;
        max = (double)(float)max;
    }
    if (!(min >= type->speed_least))
        return usage_error("--speed-min: %s m/s is too small for a %s; allowed: %.2g m/s or more",
                           number[EMBED_SPEED_MIN].text, type->name, type->speed_least);
    if (!(max <= type->speed_most))
        return usage_error("--speed-max: %s m/s is too large for a %s; allowed: up to %.2g m/s",
                           number[EMBED_SPEED_MAX].text, type->name, type->speed_most);
    return embed_check_numbers(number, min, max, type->tolerance_least, EMBED_COARSEST);
}

char *embed_options(const struct embed_request *request, int width)
{
    static const char *const own[] = {"speed-min", "speed-max", "tolerance",  "coefficient",
                                      "exponent",  "eps-inf",   "decay-speed"};
    char *text = NULL;
    size_t size;
    int column = 15;
    FILE *const t = open_memstream(&text, &size);
    for (int i = 0; i < EMBED_NUMBERS; i++) {
        const int k = (i + EMBED_SPEED_MIN) % EMBED_NUMBERS, second = k == COR_SCENE_VISCOSITY_2;
        const char *const name = k < COR_SCENE_NUMBERS ? cor_scene_options[k].name : own[k - COR_SCENE_NUMBERS];
        const char *const value =
            second || k == COR_SCENE_VISCOSITY ? request->viscosity[second] : request->number[k].text;
        if (!value)
            continue;
        const int length = (int)(strlen(name) + strlen(value)) + 4;
        if ((column += length) > width) {
            fputs(" \\\n                ", t);
            column = length;
        }
        fprintf(t, " --%s %s", name, value);
    }
    if (request->wall)
        fputs(" --wall", t);
    if (request->adhesion_model)
        fprintf(t, " --adhesion-model %s", embed_adhesion_names[request->adhesion_model]);
    if (request->elastic)
        fprintf(t, " --elastic %s", request->elastic);
    if (request->damping)
        fprintf(t, " --damping %s", request->damping);
    if (!request->elastic && !request->damping && request->law != COR_LAW_VISCOELASTIC)
        fprintf(t, " --law %s", embed_law_names[request->law]);
    if (request->table)
        fprintf(t, " --table %s", request->table);
    fclose(t);
    return text;
}

const char *embed_end_option(const struct embed_request *request)
{
    static const char *const text[] = {" --end zero-overlap", " --end zero-force", " --end surface"};
    return request->law < EMBED_LAW_POWER ? text[request->end] : "";
}

bool embed_viscosity(struct decimal eta[2], const char *text)
{
    const char *const comma = strchr(text, ',');
    char first[64];
    snprintf(first, sizeof first, "%.*s", comma ? (int)(comma - text) : 0, text);
    return comma && comma - text < (ptrdiff_t)sizeof first && decimal_parse(&eta[0], first, DECIMAL_EXPONENT_DIGITS) &&
           eta[0].forms == DECIMAL_PLAIN && decimal_parse(&eta[1], comma + 1, DECIMAL_EXPONENT_DIGITS) &&
           eta[1].forms == DECIMAL_PLAIN;
}

bool embed_is_pressed(const struct embed_request *request)
{
    return embed_given(request, COR_SCENE_GRAVITY) ||
           (embed_given(request, COR_SCENE_ADHESION) && request->adhesion_model != COR_ADHESION_JKR);
}

int embed_request_scene(struct cor_scene *scene, const struct embed_request *request)
{
    int end = request->end;
    if (contact_end_given(&end, embed_is_pressed(request)) != STATUS_OK)
        return STATUS_USAGE;
    struct cor_exponents law = cor_law_exponents[request->law];
    const struct ratio_text a = ratio_text(law_elastic(&law)), b = ratio_text(law_damping(&law));
    const char *const elastic = request->elastic ? request->elastic : a.text;
    const char *const damping = request->damping ? request->damping : b.text;
    const char *const wrong = law_parse(&law, elastic, damping);
    if (wrong)
        return usage_error("--elastic %s --damping %s: %s", elastic, damping, wrong);
    *scene = (struct cor_scene){.law = law,
                                .plate = request->law == COR_LAW_PLATE,
                                .plastic = request->law == COR_LAW_ELASTIC_PLASTIC,
                                .wall = request->wall,
                                .end = end,
                                .adhesion_model = request->adhesion_model};
    for (int i = 0; i < COR_SCENE_NUMBERS; i++)
        scene->number[i] = embed_given(request, i) ? embed_number(request, i) : (double)NAN;
    for (int i = 0; i < 4; i++) {
        struct decimal eta[2] = {{0}};
        const char *const text = request->viscosity[i / 2];
        if (text)
            scene->number[COR_SCENE_VISCOSITY + i % 2 + i / 2 * COR_SCENE_BODY] =
                embed_viscosity(eta, text) ? decimal_value(&eta[i % 2]) : -1;
        decimal_clear(&eta[0]);
        decimal_clear(&eta[1]);
    }
    return STATUS_OK;
}
