/* SPDX-License-Identifier: MIT */
/* The options that describe one contact, as rows of a table of options: SCENE_OPTIONS of contact, sample, embed and
 * plan, of which fit has SCENE_BODY alone. TYPE is their struct of arguments, with a member `scene`. APART lists
 * options that contradict all of them, or is NULL. POISSON and POISSON_APART are range and contradiction of
 * --poisson. */
#ifndef COR_GEN_CLI_SCENE_OPTIONS_H
#define COR_GEN_CLI_SCENE_OPTIONS_H

#include "cli/options.h"
#include "contact/contact.h"
#include "embed/request.h"

#define HELP_CONTACT                                                                                                   \
    "\nBodies, SI units; the second like the first where not given:\n"                                                 \
    "  --young Y, --poisson NU   Young's modulus (Pa), Poisson's ratio\n"                                              \
    "  --radius R, --density D or --mass M    m, kg/m^3, kg\n"                                                         \
    "  --young-2, --poisson-2, --radius-2, --density-2, --mass-2\n"                                                    \
    "  --wall           the second is flat and held fast\n"                                                            \
    "  --plate-thickness H   the second is a large plate (--law plate), m\n"                                           \
    "or a spring K x^a: --stiffness K --effective-mass M, M = m_1 m_2/(m_1 + m_2)\n"                                   \
    "  --duration T     s, of a contact at the speed --at, instead of --stiffness; linear without --at\n"              \
    "\nDissipation, one of:\n"                                                                                         \
    "  --dissipation-time A      s, and --dissipation-time-2, of viscoelastic spheres\n"                               \
    "  --viscosity ETA1,ETA2     Pa s, twice the shear and the bulk viscosity; --viscosity-2\n"                        \
    "  --g-star G       m/s, with eps = 1 - (speed/g*)^q + ..., q = 1/5 for spheres\n"                                 \
    "  --restitution E --at G    eps = E measured once, at the speed G; linear and tsuji without --at\n"               \
    "  --damping-coefficient C   of the force K x^a + C x^b x'\n"                                                      \
    "  --beta B --at G  or, linear and tsuji, --zeta Z\n"                                                              \
    "\nThe law:\n"                                                                                                     \
    "  --law NAME       viscoelastic (default), plate, linear, tsuji, hunt-crossley, hertz-dashpot (docs/laws.md)\n"   \
    "                   elastic-plastic\n"                                                                             \
    "  --elastic A --damping B   instead, any exponents as 3/2 and 1/2\n"                                              \
    "\nYield, or a liquid:\n"                                                                                          \
    "  --yield-stress Y   Pa: the yield speed, and a warning above it\n"                                               \
    "  --viscosity-liquid ETA --gap-outer H --gap-inner h   Pa s, m: lubrication between both\n"                       \
    "\nA constant force that presses the bodies together:\n"                                                           \
    "  --gravity G      m/s^2, on a ball above a --wall or a plate\n"                                                  \
    "  --adhesion W --adhesion-model M   J/m^2; dmt: the force 2 pi W R; jkr: columns _tail, _largest_pull\n"

#define SCENE_NUMBER(TYPE, NAME, NUMBER, NUMBERS, UNIT, APART)                                                         \
    {                                                                                                                  \
        .name = (NAME), .kind = OPTION_REAL, .offset = offsetof(TYPE, scene.number[NUMBER]),                           \
        .range.number = (NUMBERS), .unit = (UNIT), .excludes = (APART)                                                 \
    }
#define SCENE_RANGE_NUMBER(TYPE, NAME, NUMBER, UNIT)                                                                   \
    {                                                                                                                  \
        .name = (NAME), .kind = OPTION_REAL, .offset = offsetof(TYPE, scene.number[NUMBER]),                           \
        .range.number = &option_positive, .unit = (UNIT), .required = true                                             \
    }
#define SCENE_RANGE(TYPE)                                                                                              \
    SCENE_RANGE_NUMBER(TYPE, "speed-min", EMBED_SPEED_MIN, "m/s"),                                                     \
        SCENE_RANGE_NUMBER(TYPE, "speed-max", EMBED_SPEED_MAX, "m/s"),                                                 \
        SCENE_RANGE_NUMBER(TYPE, "tolerance", EMBED_TOLERANCE, NULL)
#define SCENE_TEXT(TYPE, NAME, FIELD, APART)                                                                           \
    {                                                                                                                  \
        .name = (NAME), .kind = OPTION_TEXT, .offset = offsetof(TYPE, scene.FIELD), .excludes = (APART)                \
    }
#define SCENE_BODY(TYPE, SUFFIX, NUMBER_SUFFIX, YOUNG, POISSON, POISSON_APART, APART)                                  \
    SCENE_NUMBER(TYPE, "young" SUFFIX, COR_SCENE_YOUNG##NUMBER_SUFFIX, YOUNG, "Pa", APART),                            \
        SCENE_NUMBER(TYPE, "poisson" SUFFIX, COR_SCENE_POISSON##NUMBER_SUFFIX, POISSON, NULL, POISSON_APART),          \
        SCENE_NUMBER(TYPE, "radius" SUFFIX, COR_SCENE_RADIUS##NUMBER_SUFFIX, &option_positive, "m", APART),            \
        SCENE_NUMBER(TYPE, "density" SUFFIX, COR_SCENE_DENSITY##NUMBER_SUFFIX, &option_positive, "kg/m^3", APART),     \
        SCENE_NUMBER(TYPE, "mass" SUFFIX, COR_SCENE_MASS##NUMBER_SUFFIX, &option_positive, "kg", APART)
#define SCENE_OPTIONS(TYPE, POISSON, POISSON_APART, APART)                                                             \
    SCENE_BODY(TYPE, "", , &option_positive, POISSON, POISSON_APART, APART),                                           \
        SCENE_BODY(TYPE, "-2", _2, &option_positive, &option_sphere_poisson, APART, APART),                            \
        {.name = "wall", .kind = OPTION_FLAG, .offset = offsetof(TYPE, scene.wall), .excludes = (APART)},              \
        SCENE_NUMBER(TYPE, "plate-thickness", COR_SCENE_PLATE_THICKNESS, &option_positive, "m", APART),                \
        SCENE_NUMBER(TYPE, "gravity", COR_SCENE_GRAVITY, &option_positive, "m/s^2", APART),                            \
        SCENE_NUMBER(TYPE, "adhesion", COR_SCENE_ADHESION, &option_positive, "J/m^2", APART),                          \
        {.name = "adhesion-model",                                                                                     \
         .kind = OPTION_WORD,                                                                                          \
         .offset = offsetof(TYPE, scene.adhesion_model),                                                               \
         .range.words = embed_adhesion_names,                                                                          \
         .why = "a model of adhesion",                                                                                 \
         .excludes = (APART),                                                                                          \
         .needs = "adhesion"},                                                                                         \
        SCENE_NUMBER(TYPE, "yield-stress", COR_SCENE_YIELD_STRESS, &option_positive, "Pa", APART),                     \
        SCENE_NUMBER(TYPE, "viscosity-liquid", COR_SCENE_LIQUID_VISCOSITY, &option_positive, "Pa s", APART),           \
        SCENE_NUMBER(TYPE, "gap-outer", COR_SCENE_GAP_OUTER, &option_positive, "m", APART),                            \
        SCENE_NUMBER(TYPE, "gap-inner", COR_SCENE_GAP_INNER, &option_positive, "m", APART),                            \
        SCENE_NUMBER(TYPE, "stiffness", COR_SCENE_STIFFNESS, &option_positive, "N/m^a", APART),                        \
        SCENE_NUMBER(TYPE, "effective-mass", COR_SCENE_EFFECTIVE_MASS, &option_positive, "kg", APART),                 \
        SCENE_NUMBER(TYPE, "duration", COR_SCENE_DURATION, &option_positive, "s", APART),                              \
        SCENE_NUMBER(TYPE, "dissipation-time", COR_SCENE_DISSIPATION_TIME, &option_not_negative, "s", APART),          \
        SCENE_NUMBER(TYPE, "dissipation-time-2", COR_SCENE_DISSIPATION_TIME_2, &option_not_negative, "s", APART),      \
        SCENE_TEXT(TYPE, "viscosity", viscosity[0], APART), SCENE_TEXT(TYPE, "viscosity-2", viscosity[1], APART),      \
        SCENE_NUMBER(TYPE, "g-star", COR_SCENE_G_STAR, &option_positive, "m/s", APART),                                \
        SCENE_NUMBER(TYPE, "restitution", COR_SCENE_RESTITUTION, &option_restitution, NULL, APART),                    \
        SCENE_NUMBER(TYPE, "damping-coefficient", COR_SCENE_DAMPING_COEFFICIENT, &option_positive, NULL, APART),       \
        SCENE_NUMBER(TYPE, "beta", COR_SCENE_BETA, &option_positive, NULL, APART),                                     \
        SCENE_NUMBER(TYPE, "zeta", COR_SCENE_ZETA, &option_not_negative, NULL, APART),                                 \
        SCENE_NUMBER(TYPE, "at", COR_SCENE_AT, &option_positive, "m/s", APART),                                        \
        {.name = "law",                                                                                                \
         .kind = OPTION_WORD,                                                                                          \
         .offset = offsetof(TYPE, scene.law),                                                                          \
         .range.words = contact_law_names,                                                                             \
         .why = "a law",                                                                                               \
         .excludes = (APART)},                                                                                         \
        SCENE_TEXT(TYPE, "elastic", elastic, "law " APART), SCENE_TEXT(TYPE, "damping", damping, "law " APART),        \
    {                                                                                                                  \
        .name = "end", .kind = OPTION_WORD, .offset = offsetof(TYPE, scene.end), .range.words = option_ends,           \
        .why = "an end of contact", .excludes = (APART)                                                                \
    }
#define SCENE_PURPOSE(TYPE, APART)                                                                                     \
    {                                                                                                                  \
        .name = "for", .kind = OPTION_WORD, .offset = offsetof(TYPE, scene.purpose),                                   \
        .range.words = embed_purpose_names, .why = "a use", .excludes = (APART)                                        \
    }

#endif
