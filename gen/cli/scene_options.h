/* SPDX-License-Identifier: MIT */
/* The options of a scene of spheres for corgen embed and corgen plan, as rows of a table of options. POISSON is the
 * range of --poisson. APART lists the options that contradict all others except the range and --poisson, or is NULL. */
#ifndef COR_GEN_CLI_SCENE_OPTIONS_H
#define COR_GEN_CLI_SCENE_OPTIONS_H

#include "cli/options.h"
#include "embed/request.h"

#define HELP_SCENE_LAW                                                                                                 \
    "\nThe law of the contact, x'' + beta x^B x' + x^A = 0:\n"                                                         \
    "  --law NAME       viscoelastic (default; 3/2, 1/2), hunt-crossley (3/2, 3/2), hertz-dashpot (3/2, 0);\n"         \
    "                   linear (1, 0) and tsuji (3/2, 1/4) have the same eps at every speed (cor/law.h)\n"             \
    "  --elastic A --damping B   any other exponents, such as 1 and 1/2\n"

#define SCENE_NUMBER(TYPE, NAME, NUMBER, NUMBERS, REQUIRED, APART)                                                     \
    {                                                                                                                  \
        .name = (NAME), .kind = OPTION_REAL, .offset = offsetof(TYPE, scene.number[NUMBER]),                           \
        .range.number = (NUMBERS), .required = (REQUIRED), .excludes = (APART)                                         \
    }
#define SCENE_BODY(TYPE, SUFFIX, NUMBER_SUFFIX, APART)                                                                 \
    SCENE_NUMBER(TYPE, "young" SUFFIX, EMBED_YOUNG##NUMBER_SUFFIX, &option_positive, false, APART),                    \
        SCENE_NUMBER(TYPE, "radius" SUFFIX, EMBED_RADIUS##NUMBER_SUFFIX, &option_positive, false, APART),              \
        SCENE_NUMBER(TYPE, "density" SUFFIX, EMBED_DENSITY##NUMBER_SUFFIX, &option_positive, false, APART),            \
        SCENE_NUMBER(TYPE, "mass" SUFFIX, EMBED_MASS##NUMBER_SUFFIX, &option_positive, false, APART),                  \
        SCENE_NUMBER(TYPE, "dissipation-time" SUFFIX, EMBED_DISSIPATION_TIME##NUMBER_SUFFIX, &option_not_negative,     \
                     false, APART)
/* beta at a speed, and the coefficients of the force */
#define SCENE_FORCE(TYPE, APART)                                                                                       \
    SCENE_NUMBER(TYPE, "beta", EMBED_BETA, &option_positive, false, APART),                                            \
        SCENE_NUMBER(TYPE, "at", EMBED_AT, &option_positive, false, APART),                                            \
        SCENE_NUMBER(TYPE, "stiffness", EMBED_STIFFNESS, &option_positive, false, APART),                              \
        SCENE_NUMBER(TYPE, "damping-coefficient", EMBED_DAMPING_COEFFICIENT, &option_positive, false, APART),          \
        SCENE_NUMBER(TYPE, "effective-mass", EMBED_EFFECTIVE_MASS, &option_positive, false, APART)
#define SCENE_EXPONENTS(TYPE, APART)                                                                                   \
    {.name = "elastic", .kind = OPTION_TEXT, .offset = offsetof(TYPE, scene.elastic), .excludes = "law " APART},       \
    {                                                                                                                  \
        .name = "damping", .kind = OPTION_TEXT, .offset = offsetof(TYPE, scene.damping), .excludes = "law " APART      \
    }
#define SCENE_LAW(TYPE, APART)                                                                                         \
    SCENE_FORCE(TYPE, APART),                                                                                          \
        {.name = "law",                                                                                                \
         .kind = OPTION_WORD,                                                                                          \
         .offset = offsetof(TYPE, scene.law),                                                                          \
         .range.words = embed_law_names,                                                                               \
         .why = "a law",                                                                                               \
         .excludes = (APART)},                                                                                         \
        SCENE_EXPONENTS(TYPE, APART)
#define SCENE_OPTIONS(TYPE, POISSON, APART)                                                                            \
    SCENE_NUMBER(TYPE, "speed-min", EMBED_SPEED_MIN, &option_positive, true, NULL),                                    \
        SCENE_NUMBER(TYPE, "speed-max", EMBED_SPEED_MAX, &option_positive, true, NULL),                                \
        SCENE_NUMBER(TYPE, "tolerance", EMBED_TOLERANCE, &option_positive, true, NULL),                                \
        SCENE_NUMBER(TYPE, "g-star", EMBED_G_STAR, &option_positive, false, APART),                                    \
        {.name = "end",                                                                                                \
         .kind = OPTION_WORD,                                                                                          \
         .offset = offsetof(TYPE, scene.end),                                                                          \
         .range.words = option_ends,                                                                                   \
         .why = "an end of contact",                                                                                   \
         .excludes = (APART)},                                                                                         \
        {.name = "for",                                                                                                \
         .kind = OPTION_WORD,                                                                                          \
         .offset = offsetof(TYPE, scene.purpose),                                                                      \
         .range.words = embed_purpose_names,                                                                           \
         .why = "a use",                                                                                               \
         .excludes = (APART)},                                                                                         \
        SCENE_NUMBER(TYPE, "poisson", EMBED_POISSON, POISSON, false, NULL), SCENE_BODY(TYPE, "", , APART),             \
        SCENE_NUMBER(TYPE, "poisson-2", EMBED_POISSON_2, &option_sphere_poisson, false, APART),                        \
        SCENE_BODY(TYPE, "-2", _2, APART), SCENE_LAW(TYPE, APART),                                                     \
    {                                                                                                                  \
        .name = "wall", .kind = OPTION_FLAG, .offset = offsetof(TYPE, scene.wall), .excludes = (APART)                 \
    }

#endif
