/* SPDX-License-Identifier: MIT */
/* The options of a scene of spheres for corgen embed and corgen plan, as rows of a table of options. POISSON is the
 * range of --poisson. APART lists the options that contradict all others except the range and --poisson, or is NULL. */
#ifndef COR_GEN_CLI_SCENE_OPTIONS_H
#define COR_GEN_CLI_SCENE_OPTIONS_H

#include "cli/options.h"
#include "embed/request.h"

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
        SCENE_BODY(TYPE, "-2", _2, APART),                                                                             \
    {                                                                                                                  \
        .name = "wall", .kind = OPTION_FLAG, .offset = offsetof(TYPE, scene.wall), .excludes = (APART)                 \
    }

#endif
