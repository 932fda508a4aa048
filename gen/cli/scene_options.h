/* SPDX-License-Identifier: MIT */
/* The options that describe one contact, as rows of a table of options: SCENE_OPTIONS of contact, sample, embed and
 * plan, of which fit has SCENE_BODY alone. ARGUMENTS has a member `scene`. APART lists options that contradict all of
 * them, or is NULL. POISSON and POISSON_APART are range and contradiction of --poisson. */
#ifndef COR_GEN_CLI_SCENE_OPTIONS_H
#define COR_GEN_CLI_SCENE_OPTIONS_H

#include "cli/options.h"
#include "contact/contact.h"
#include "embed/request.h"

#define HELP_END_PRESSED                                                                                               \
    "  --end E          the contact ends at zero-overlap (default) or zero-force; under a constant force, at\n"        \
    "                   zero-overlap or, limited to pushing, at the surface\n"
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

#define SCENE_NUMBER(NAME, NUMBER, NUMBERS, UNIT, APART)                                                               \
    OPTION(NAME, REAL, scene.number[NUMBER], .range.number = (NUMBERS), .unit = (UNIT), .excludes = (APART))
#define SCENE_POSITIVE(NAME, NUMBER, UNIT, APART) SCENE_NUMBER(NAME, NUMBER, &option_positive, UNIT, APART)
#define SCENE_RANGE_NUMBER(NAME, NUMBER, UNIT)                                                                         \
    OPTION(NAME, REAL, scene.number[NUMBER], .range.number = &option_positive, .unit = (UNIT), .required = true)
#define SCENE_RANGE                                                                                                    \
    SCENE_RANGE_NUMBER("speed-min", EMBED_SPEED_MIN, "m/s"), SCENE_RANGE_NUMBER("speed-max", EMBED_SPEED_MAX, "m/s"),  \
        SCENE_RANGE_NUMBER("tolerance", EMBED_TOLERANCE, NULL)
#define SCENE_TEXT(NAME, FIELD, APART) OPTION(NAME, TEXT, scene.FIELD, .excludes = (APART))
#define SCENE_WORD(NAME, FIELD, WORDS, WHY, APART)                                                                     \
    OPTION(NAME, WORD, scene.FIELD, .range.words = (WORDS), .why = (WHY), .excludes = (APART))
#define SCENE_BODY(SUFFIX, NUMBER_SUFFIX, YOUNG, POISSON, POISSON_APART, APART)                                        \
    SCENE_NUMBER("young" SUFFIX, COR_SCENE_YOUNG##NUMBER_SUFFIX, YOUNG, "Pa", APART),                                  \
        SCENE_NUMBER("poisson" SUFFIX, COR_SCENE_POISSON##NUMBER_SUFFIX, POISSON, NULL, POISSON_APART),                \
        SCENE_POSITIVE("radius" SUFFIX, COR_SCENE_RADIUS##NUMBER_SUFFIX, "m", APART),                                  \
        SCENE_POSITIVE("density" SUFFIX, COR_SCENE_DENSITY##NUMBER_SUFFIX, "kg/m^3", APART),                           \
        SCENE_POSITIVE("mass" SUFFIX, COR_SCENE_MASS##NUMBER_SUFFIX, "kg", APART)
#define SCENE_OPTIONS(POISSON, POISSON_APART, APART)                                                                   \
    SCENE_BODY("", , &option_positive, POISSON, POISSON_APART, APART),                                                 \
        SCENE_BODY("-2", _2, &option_positive, &option_sphere_poisson, APART, APART),                                  \
        OPTION("wall", FLAG, scene.wall, .excludes = (APART)),                                                         \
        SCENE_POSITIVE("plate-thickness", COR_SCENE_PLATE_THICKNESS, "m", APART),                                      \
        SCENE_POSITIVE("gravity", COR_SCENE_GRAVITY, "m/s^2", APART),                                                  \
        SCENE_POSITIVE("adhesion", COR_SCENE_ADHESION, "J/m^2", APART),                                                \
        OPTION("adhesion-model", WORD, scene.adhesion_model, .range.words = embed_adhesion_names,                      \
               .why = "a model of adhesion", .excludes = (APART), .needs = "adhesion"),                                \
        SCENE_POSITIVE("yield-stress", COR_SCENE_YIELD_STRESS, "Pa", APART),                                           \
        SCENE_POSITIVE("viscosity-liquid", COR_SCENE_LIQUID_VISCOSITY, "Pa s", APART),                                 \
        SCENE_POSITIVE("gap-outer", COR_SCENE_GAP_OUTER, "m", APART),                                                  \
        SCENE_POSITIVE("gap-inner", COR_SCENE_GAP_INNER, "m", APART),                                                  \
        SCENE_POSITIVE("stiffness", COR_SCENE_STIFFNESS, "N/m^a", APART),                                              \
        SCENE_POSITIVE("effective-mass", COR_SCENE_EFFECTIVE_MASS, "kg", APART),                                       \
        SCENE_POSITIVE("duration", COR_SCENE_DURATION, "s", APART),                                                    \
        SCENE_NUMBER("dissipation-time", COR_SCENE_DISSIPATION_TIME, &option_not_negative, "s", APART),                \
        SCENE_NUMBER("dissipation-time-2", COR_SCENE_DISSIPATION_TIME_2, &option_not_negative, "s", APART),            \
        SCENE_TEXT("viscosity", viscosity[0], APART), SCENE_TEXT("viscosity-2", viscosity[1], APART),                  \
        SCENE_POSITIVE("g-star", COR_SCENE_G_STAR, "m/s", APART),                                                      \
        SCENE_NUMBER("restitution", COR_SCENE_RESTITUTION, &option_restitution, NULL, APART),                          \
        SCENE_POSITIVE("damping-coefficient", COR_SCENE_DAMPING_COEFFICIENT, NULL, APART),                             \
        SCENE_POSITIVE("beta", COR_SCENE_BETA, NULL, APART),                                                           \
        SCENE_NUMBER("zeta", COR_SCENE_ZETA, &option_not_negative, NULL, APART),                                       \
        SCENE_POSITIVE("at", COR_SCENE_AT, "m/s", APART), SCENE_WORD("law", law, contact_law_names, "a law", APART),   \
        SCENE_TEXT("elastic", elastic, "law " APART), SCENE_TEXT("damping", damping, "law " APART),                    \
        SCENE_WORD("end", end, contact_end_options_pressed, "an end of contact", APART)
#define SCENE_PURPOSE(APART) SCENE_WORD("for", purpose, embed_purpose_names, "a use", APART)

#endif
