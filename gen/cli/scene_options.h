/* SPDX-License-Identifier: MIT */
/* The options of a scene, as rows of a table of options: SCENE_OPTIONS of corgen embed and corgen plan,
 * CONTACT_OPTIONS of corgen contact and corgen sample. TYPE is their struct of arguments, with a member `scene`.
 * POISSON is the range of --poisson. APART lists the options that contradict all others except the range and
 * --poisson, or is NULL. */
#ifndef COR_GEN_CLI_SCENE_OPTIONS_H
#define COR_GEN_CLI_SCENE_OPTIONS_H

#include "cli/options.h"
#include "embed/request.h"

#define HELP_SCENE_LAW                                                                                                 \
    "\nThe law of the contact, x'' + beta x^B x' + x^A = 0:\n"                                                         \
    "  --law NAME       viscoelastic (default; 3/2, 1/2), hunt-crossley (3/2, 3/2), hertz-dashpot (3/2, 0);\n"         \
    "                   linear (1, 0) and tsuji (3/2, 1/4) have the same eps at every speed (cor/law.h)\n"             \
    "  --elastic A --damping B   any other exponents, such as 1 and 1/2\n"

#define HELP_CONTACT                                                                                                   \
    "\nBodies, SI units; the second like the first where not given:\n"                                                 \
    "  --young Y, --poisson NU   Young's modulus (Pa), Poisson's ratio\n"                                              \
    "  --radius R, --density D or --mass M    m, kg/m^3, kg\n"                                                         \
    "  --young-2, --poisson-2, --radius-2, --density-2, --mass-2\n"                                                    \
    "  --wall           the second is flat and held fast\n"                                                            \
    "  --plate-thickness H   the second is a large plate (--law plate), m\n"                                           \
    "or a spring K x^a: --stiffness K --effective-mass M, M = m_1 m_2/(m_1 + m_2)\n"                                   \
    "\nDissipation, one of:\n"                                                                                         \
    "  --dissipation-time A      s, and --dissipation-time-2, of viscoelastic spheres\n"                               \
    "  --viscosity ETA1,ETA2     Pa s, twice the shear and the bulk viscosity; --viscosity-2\n"                        \
    "  --g-star G       m/s, with eps = 1 - (speed/g*)^q + ..., q = 1/5 for spheres\n"                                 \
    "  --restitution E --at G    eps = E measured once, at the speed G; linear and tsuji without --at\n"               \
    "  --damping-coefficient C   of the force K x^a + C x^b x'\n"                                                      \
    "  --beta B --at G  or, linear and tsuji, --zeta Z\n"                                                              \
    "\nThe law:\n"                                                                                                     \
    "  --law NAME       viscoelastic (default), plate, linear, tsuji, hunt-crossley, hertz-dashpot\n"                  \
    "  --elastic A --damping B   instead, exponents as 3/2 and 1/2\n"

#define SCENE_NUMBER(TYPE, NAME, NUMBER, NUMBERS, REQUIRED, APART)                                                     \
    {                                                                                                                  \
        .name = (NAME), .kind = OPTION_REAL, .offset = offsetof(TYPE, scene.number[NUMBER]),                           \
        .range.number = (NUMBERS), .required = (REQUIRED), .excludes = (APART)                                         \
    }
#define SCENE_BODY(TYPE, SUFFIX, NUMBER_SUFFIX, APART)                                                                 \
    SCENE_NUMBER(TYPE, "young" SUFFIX, COR_SCENE_YOUNG##NUMBER_SUFFIX, &option_positive, false, APART),                \
        SCENE_NUMBER(TYPE, "radius" SUFFIX, COR_SCENE_RADIUS##NUMBER_SUFFIX, &option_positive, false, APART),          \
        SCENE_NUMBER(TYPE, "density" SUFFIX, COR_SCENE_DENSITY##NUMBER_SUFFIX, &option_positive, false, APART),        \
        SCENE_NUMBER(TYPE, "mass" SUFFIX, COR_SCENE_MASS##NUMBER_SUFFIX, &option_positive, false, APART),              \
        SCENE_NUMBER(TYPE, "dissipation-time" SUFFIX, COR_SCENE_DISSIPATION_TIME##NUMBER_SUFFIX, &option_not_negative, \
                     false, APART)
/* beta at a speed, and the coefficients of the force */
#define SCENE_FORCE(TYPE, APART)                                                                                       \
    SCENE_NUMBER(TYPE, "beta", COR_SCENE_BETA, &option_positive, false, APART),                                        \
        SCENE_NUMBER(TYPE, "at", COR_SCENE_AT, &option_positive, false, APART),                                        \
        SCENE_NUMBER(TYPE, "stiffness", COR_SCENE_STIFFNESS, &option_positive, false, APART),                          \
        SCENE_NUMBER(TYPE, "damping-coefficient", COR_SCENE_DAMPING_COEFFICIENT, &option_positive, false, APART),      \
        SCENE_NUMBER(TYPE, "effective-mass", COR_SCENE_EFFECTIVE_MASS, &option_positive, false, APART)
#define SCENE_LAW(TYPE, WORDS, APART)                                                                                  \
    {.name = "law",                                                                                                    \
     .kind = OPTION_WORD,                                                                                              \
     .offset = offsetof(TYPE, scene.law),                                                                              \
     .range.words = (WORDS),                                                                                           \
     .why = "a law",                                                                                                   \
     .excludes = (APART)},                                                                                             \
        SCENE_TEXT(TYPE, "elastic", elastic, "law " APART), SCENE_TEXT(TYPE, "damping", damping, "law " APART)
#define SCENE_TEXT(TYPE, NAME, FIELD, APART)                                                                           \
    {                                                                                                                  \
        .name = (NAME), .kind = OPTION_TEXT, .offset = offsetof(TYPE, scene.FIELD), .excludes = (APART)                \
    }
#define SCENE_OPTIONS(TYPE, POISSON, APART)                                                                            \
    SCENE_NUMBER(TYPE, "speed-min", EMBED_SPEED_MIN, &option_positive, true, NULL),                                    \
        SCENE_NUMBER(TYPE, "speed-max", EMBED_SPEED_MAX, &option_positive, true, NULL),                                \
        SCENE_NUMBER(TYPE, "tolerance", EMBED_TOLERANCE, &option_positive, true, NULL),                                \
        SCENE_NUMBER(TYPE, "g-star", COR_SCENE_G_STAR, &option_positive, false, APART),                                \
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
        SCENE_NUMBER(TYPE, "poisson", COR_SCENE_POISSON, POISSON, false, NULL), SCENE_BODY(TYPE, "", , APART),         \
        SCENE_NUMBER(TYPE, "poisson-2", COR_SCENE_POISSON_2, &option_sphere_poisson, false, APART),                    \
        SCENE_BODY(TYPE, "-2", _2, APART), SCENE_FORCE(TYPE, APART), SCENE_LAW(TYPE, scene_law_names, APART),          \
    {                                                                                                                  \
        .name = "wall", .kind = OPTION_FLAG, .offset = offsetof(TYPE, scene.wall), .excludes = (APART)                 \
    }
#define CONTACT_OPTIONS(TYPE)                                                                                          \
    SCENE_BODY(TYPE, "", , NULL),                                                                                      \
        SCENE_NUMBER(TYPE, "poisson", COR_SCENE_POISSON, &option_sphere_poisson, false, NULL),                         \
        SCENE_BODY(TYPE, "-2", _2, NULL),                                                                              \
        SCENE_NUMBER(TYPE, "poisson-2", COR_SCENE_POISSON_2, &option_sphere_poisson, false, NULL),                     \
        {.name = "wall", .kind = OPTION_FLAG, .offset = offsetof(TYPE, scene.wall)},                                   \
        SCENE_NUMBER(TYPE, "plate-thickness", COR_SCENE_PLATE_THICKNESS, &option_positive, false, NULL),               \
        SCENE_FORCE(TYPE, NULL), SCENE_TEXT(TYPE, "viscosity", viscosity[0], NULL),                                    \
        SCENE_TEXT(TYPE, "viscosity-2", viscosity[1], NULL),                                                           \
        SCENE_NUMBER(TYPE, "g-star", COR_SCENE_G_STAR, &option_positive, false, NULL),                                 \
        SCENE_NUMBER(TYPE, "restitution", COR_SCENE_RESTITUTION, &option_restitution, false, NULL),                    \
        SCENE_NUMBER(TYPE, "zeta", COR_SCENE_ZETA, &option_not_negative, false, NULL),                                 \
        SCENE_LAW(TYPE, contact_law_names, ""), OPTION_END(TYPE, scene.end)

static const char *const scene_law_names[] = {COR_LAW_NAMES, NULL};

#endif
