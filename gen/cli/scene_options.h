/* SPDX-License-Identifier: MIT */
/* The options of one contact, for the option tables of contact, sample, embed and plan. ARGUMENTS must have a member
 * `scene`. APART: more options that contradict all of these, or NULL. POISSON: the range of --poisson, NULL for
 * spheres. POISSON_APART: options that contradict --poisson */
#ifndef COR_GEN_CLI_SCENE_OPTIONS_H
#define COR_GEN_CLI_SCENE_OPTIONS_H

#ifndef SCENE_ENDS
#define SCENE_ENDS contact_end_options_pressed
#endif

#include "cli/options.h"
#include "contact/contact.h"
#include "embed/request.h"

#define HELP_END_PRESSED                                                                                               \
    "  --end E          end of contact, zero-overlap or zero-force, or under a constant force zero-overlap or\n"       \
    "                   surface (default zero-overlap)\n"
#define HELP_CONTACT "\f" /* replaced by help_contact (options.h), because a literal has at most 4095 characters */
#define HELP_CONTACT_TEXT                                                                                              \
    "\n"                                                                                                               \
    "Bodies, in SI units:\n"                                                                                           \
    "  --young Y, --poisson NU   Young's modulus, Pa, and Poisson's ratio, above -1 and up to 0.5\n"                   \
    "  --radius R, --density D or --mass M   radius, m, and density, kg/m^3, or mass, kg\n"                            \
    "  --young-2, --poisson-2, --radius-2, --density-2, --mass-2\n"                                                    \
    "                   the same of the second body (default: as the first body)\n"                                    \
    "  --wall           use a flat and fixed second body\n"                                                            \
    "  --plate-thickness H   thickness of a large plate as second body, m, with --law plate\n"                         \
    "or a spring K x^a instead of bodies:\n"                                                                           \
    "  --stiffness K --effective-mass M   stiffness, N/m^a, and m_1 m_2/(m_1 + m_2), kg\n"                             \
    "  --duration T     duration of contact at the speed --at, s, instead of --stiffness; linear needs no --at\n\n"    \
    "Dissipation, one of:\n"                                                                                           \
    "  --dissipation-time A   dissipation time of viscoelastic spheres, s; also --dissipation-time-2\n"                \
    "  --viscosity ETA1,ETA2   twice the shear viscosity, and the bulk viscosity, Pa s; also --viscosity-2\n"          \
    "  --g-star G       characteristic speed, m/s, of eps = 1 - (speed/g*)^q + ..., for spheres q = 1/5\n"             \
    "  --restitution E --at G   measured eps, above 0 and up to 1, and its speed, m/s; linear and tsuji\n"             \
    "                   need no --at\n"                                                                                \
    "  --damping-coefficient C   damping of the force K x^a + C x^b x', N s/m^(b+1)\n"                                 \
    "  --beta B --at G  beta at the speed G, m/s\n"                                                                    \
    "  --zeta Z         damping ratio of the laws linear and tsuji\n\n"                                                \
    "Law:\n"                                                                                                           \
    "  --law NAME       law of contact (docs/laws.md; default viscoelastic):\n"                                        \
    "                   {law}\n"                                                                                       \
    "  --elastic A --damping B   exponents of another law, 0 to 24, such as 3/2 and 1/2, instead of --law\n"           \
    "Laws that give only eps of the speed, without bodies (docs/ice.md):\n"                                            \
    "  --coefficient A --exponent B   with --law power-law, min(1, A v^-B)\n"                                          \
    "  --eps-inf E --decay-speed V    with --law exponential, E + (1 - E) exp(-v/V)\n"                                 \
    "  --table FILE                   with --law table, a csv file with the columns speed_m_s,eps\n\n"                 \
    "Yield, or a liquid:\n"                                                                                            \
    "  --yield-stress Y   yield stress, Pa; prints the yield speed, and warns of speeds above it\n"                    \
    "  --viscosity-liquid ETA --gap-outer H --gap-inner h\n"                                                           \
    "                   viscosity, Pa s, and the outer and inner gap, m, between which the liquid acts\n\n"            \
    "A constant force that presses the bodies together:\n"                                                             \
    "  --gravity G      gravity on a ball above a --wall or a plate, m/s^2\n"                                          \
    "  --adhesion W --adhesion-model M   work of adhesion, J/m^2, and its model, dmt (the force 2 pi W R)\n"           \
    "                   or jkr (columns _tail and _largest_pull)\n"

/* Options that contradict an own law: all options of one contact except law and end */
#define SCENE_NUMBERS_APART                                                                                            \
    " young poisson radius density mass young-2 poisson-2 radius-2 density-2 mass-2 wall plate-thickness gravity "     \
    "adhesion yield-stress viscosity-liquid gap-outer gap-inner stiffness effective-mass duration dissipation-time "   \
    "dissipation-time-2 viscosity viscosity-2 g-star restitution damping-coefficient beta zeta at"
#define SCENE_OWN_APART                                                                                                \
    SCENE_NUMBERS_APART                                                                                                \
    " elastic damping end equivalent adhesion-model steps time-step step-tolerance step-corrected "                    \
    "integrator simulator-version friction tangential-restitution materials pairs durations "
#define SCENE_OWN(NAME, NUMBER, NUMBERS, APART)                                                                        \
    OPTION(NAME, REAL, scene.number[NUMBER], .range.number = (NUMBERS), .excludes = SCENE_OWN_APART APART)

/* An option for a number of cor/scene.h, with its unit and range. NUMBERS: another range, or NULL */
#define SCENE_NUMBER_OF(NAME, NUMBER, NUMBERS, APART)                                                                  \
    OPTION(NAME, REAL, scene.number[NUMBER], .scene = &cor_scene_options[NUMBER], .range.number = (NUMBERS),           \
           .excludes = (APART))
#define SCENE_NUMBER(NAME, NUMBER, APART) SCENE_NUMBER_OF(NAME, NUMBER, NULL, APART)
#define SCENE_RANGE_NUMBER(NAME, NUMBER, UNIT)                                                                         \
    OPTION(NAME, REAL, scene.number[NUMBER], .range.number = &option_positive, .unit = (UNIT), .required = true)
#define SCENE_RANGE                                                                                                    \
    SCENE_RANGE_NUMBER("speed-min", EMBED_SPEED_MIN, "m/s"), SCENE_RANGE_NUMBER("speed-max", EMBED_SPEED_MAX, "m/s"),  \
        SCENE_RANGE_NUMBER("tolerance", EMBED_TOLERANCE, NULL)
#define SCENE_TEXT(NAME, FIELD, APART) OPTION(NAME, TEXT, scene.FIELD, .excludes = (APART))
#define SCENE_WORD(NAME, FIELD, WORDS, WHY, APART)                                                                     \
    OPTION(NAME, WORD, scene.FIELD, .range.words = (WORDS), .why = (WHY), .excludes = (APART))
#define SCENE_BODY(SUFFIX, NUMBER_SUFFIX, POISSON, POISSON_APART, APART)                                               \
    SCENE_NUMBER("young" SUFFIX, COR_SCENE_YOUNG##NUMBER_SUFFIX, APART),                                               \
        SCENE_NUMBER_OF("poisson" SUFFIX, COR_SCENE_POISSON##NUMBER_SUFFIX, POISSON, POISSON_APART),                   \
        SCENE_NUMBER("radius" SUFFIX, COR_SCENE_RADIUS##NUMBER_SUFFIX, APART),                                         \
        SCENE_NUMBER("density" SUFFIX, COR_SCENE_DENSITY##NUMBER_SUFFIX, APART),                                       \
        SCENE_NUMBER("mass" SUFFIX, COR_SCENE_MASS##NUMBER_SUFFIX, APART)
#define SCENE_OPTIONS(POISSON, POISSON_APART, APART)                                                                   \
    SCENE_BODY("", , POISSON, POISSON_APART, APART), SCENE_BODY("-2", _2, NULL, APART, APART),                         \
        OPTION("wall", FLAG, scene.wall, .excludes = (APART)),                                                         \
        SCENE_NUMBER("plate-thickness", COR_SCENE_PLATE_THICKNESS, APART),                                             \
        SCENE_NUMBER("gravity", COR_SCENE_GRAVITY, APART), SCENE_NUMBER("adhesion", COR_SCENE_ADHESION, APART),        \
        OPTION("adhesion-model", WORD, scene.adhesion_model, .range.words = embed_adhesion_names,                      \
               .why = "a model of adhesion", .excludes = (APART), .needs = "adhesion"),                                \
        SCENE_NUMBER("yield-stress", COR_SCENE_YIELD_STRESS, APART),                                                   \
        SCENE_NUMBER("viscosity-liquid", COR_SCENE_LIQUID_VISCOSITY, APART),                                           \
        SCENE_NUMBER("gap-outer", COR_SCENE_GAP_OUTER, APART), SCENE_NUMBER("gap-inner", COR_SCENE_GAP_INNER, APART),  \
        SCENE_NUMBER("stiffness", COR_SCENE_STIFFNESS, APART),                                                         \
        SCENE_NUMBER("effective-mass", COR_SCENE_EFFECTIVE_MASS, APART),                                               \
        SCENE_NUMBER("duration", COR_SCENE_DURATION, APART),                                                           \
        SCENE_NUMBER("dissipation-time", COR_SCENE_DISSIPATION_TIME, APART),                                           \
        SCENE_NUMBER("dissipation-time-2", COR_SCENE_DISSIPATION_TIME_2, APART),                                       \
        SCENE_TEXT("viscosity", viscosity[0], APART), SCENE_TEXT("viscosity-2", viscosity[1], APART),                  \
        SCENE_NUMBER("g-star", COR_SCENE_G_STAR, APART), SCENE_NUMBER("restitution", COR_SCENE_RESTITUTION, APART),    \
        SCENE_NUMBER("damping-coefficient", COR_SCENE_DAMPING_COEFFICIENT, APART),                                     \
        SCENE_NUMBER("beta", COR_SCENE_BETA, APART), SCENE_NUMBER("zeta", COR_SCENE_ZETA, APART),                      \
        SCENE_NUMBER("at", COR_SCENE_AT, APART), SCENE_WORD("law", law, embed_law_names, "a law", APART),              \
        SCENE_OWN("coefficient", EMBED_COEFFICIENT, &option_positive, APART),                                          \
        SCENE_OWN("exponent", EMBED_EXPONENT, &option_own_exponent, APART),                                            \
        SCENE_OWN("eps-inf", EMBED_EPS_INF, &option_own_eps, APART),                                                   \
        SCENE_OWN("decay-speed", EMBED_DECAY_SPEED, &option_positive, APART),                                          \
        SCENE_TEXT("table", table, SCENE_OWN_APART APART), SCENE_TEXT("elastic", elastic, "law " APART),               \
        SCENE_TEXT("damping", damping, "law " APART), SCENE_WORD("end", end, SCENE_ENDS, "an end of contact", APART)
#define SCENE_PURPOSE(APART) SCENE_WORD("for", purpose, embed_purpose_names, "a use", APART)

#endif
