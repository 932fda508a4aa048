/* SPDX-License-Identifier: MIT */
/* The options of a contact for corgen contact and corgen sample, as rows of a table of options. TYPE is their struct of
 * arguments; its scene and its request share their storage. */
#ifndef COR_GEN_CLI_CONTACT_OPTIONS_H
#define COR_GEN_CLI_CONTACT_OPTIONS_H

#include "cli/options.h"
#include "cli/scene_options.h"
#include "contact/contact_request.h"

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

#define CONTACT_NUMBER(TYPE, NAME, NUMBER, NUMBERS)                                                                    \
    {                                                                                                                  \
        .name = (NAME), .kind = OPTION_REAL, .offset = offsetof(TYPE, request.number[NUMBER]),                         \
        .range.number = (NUMBERS)                                                                                      \
    }
#define CONTACT_TEXT(TYPE, NAME, FIELD)                                                                                \
    {                                                                                                                  \
        .name = (NAME), .kind = OPTION_TEXT, .offset = offsetof(TYPE, request.FIELD)                                   \
    }
#define CONTACT_OPTIONS(TYPE)                                                                                          \
    SCENE_BODY(TYPE, "", , NULL), SCENE_NUMBER(TYPE, "poisson", EMBED_POISSON, &option_sphere_poisson, false, NULL),   \
        SCENE_BODY(TYPE, "-2", _2, NULL),                                                                              \
        SCENE_NUMBER(TYPE, "poisson-2", EMBED_POISSON_2, &option_sphere_poisson, false, NULL),                         \
        {.name = "wall", .kind = OPTION_FLAG, .offset = offsetof(TYPE, scene.wall)},                                   \
        CONTACT_NUMBER(TYPE, "plate-thickness", CONTACT_PLATE_THICKNESS, &option_positive), SCENE_FORCE(TYPE, NULL),   \
        CONTACT_TEXT(TYPE, "viscosity", viscosity), CONTACT_TEXT(TYPE, "viscosity-2", viscosity_2),                    \
        SCENE_NUMBER(TYPE, "g-star", EMBED_G_STAR, &option_positive, false, NULL),                                     \
        CONTACT_NUMBER(TYPE, "restitution", CONTACT_RESTITUTION, &option_restitution),                                 \
        CONTACT_NUMBER(TYPE, "zeta", CONTACT_ZETA, &option_not_negative),                                              \
        {.name = "law",                                                                                                \
         .kind = OPTION_WORD,                                                                                          \
         .offset = offsetof(TYPE, request.law),                                                                        \
         .range.words = contact_law_names,                                                                             \
         .why = "a law"},                                                                                              \
        SCENE_EXPONENTS(TYPE, ""), OPTION_END(TYPE, request.end)

#endif
