/* SPDX-License-Identifier: MIT */
/* The exponents of the laws; the numbers of a scene, with their names, units and ranges; the checks of bodies; the
 * messages of faults, with the names of corgen's options. This file calls no function of libcor except
 * cor_status_text. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cor/scene.h"
#include "cor/status.h"
#include "runtime/core/laws.h"
#include "runtime/number/si_range.h"

const struct cor_exponents cor_law_exponents[COR_LAW_IMPULSE] = {COR_CONTACT_LAWS(COR_LAW_EXPONENTS)
                                                                     COR_SIMULATOR_LAWS(COR_LAW_EXPONENTS)};

const char *const cor_end_names[COR_ENDS] = {"zero overlap", "zero force", "limited", "approach only", "an instant"};

#define POSITIVE 0, INFINITY, 0, "a finite number above 0"
#define NOT_NEGATIVE 0, INFINITY, 1, "a finite number, 0 or more"
#define BODY(SUFFIX, suffix)                                                                                           \
    [COR_SCENE_YOUNG##SUFFIX] = {"young" suffix, "Pa", POSITIVE},                                                      \
    [COR_SCENE_POISSON##SUFFIX] = {"poisson" suffix, "", -1, 0.5, 0, "a number above -1 and up to 0.5"},               \
    [COR_SCENE_RADIUS##SUFFIX] = {"radius" suffix, "m", POSITIVE},                                                     \
    [COR_SCENE_DENSITY##SUFFIX] = {"density" suffix, "kg/m^3", POSITIVE},                                              \
    [COR_SCENE_MASS##SUFFIX] = {"mass" suffix, "kg", POSITIVE},                                                        \
    [COR_SCENE_DISSIPATION_TIME##SUFFIX] = {"dissipation-time" suffix, "s", NOT_NEGATIVE},                             \
    [COR_SCENE_VISCOSITY##SUFFIX] = {"viscosity" suffix, "Pa s", NOT_NEGATIVE},                                        \
    [COR_SCENE_BULK_VISCOSITY##SUFFIX] = {"bulk-viscosity" suffix, "Pa s", NOT_NEGATIVE}
const struct cor_scene_option cor_scene_options[COR_SCENE_NUMBERS] = {
    [COR_SCENE_G_STAR] = {"g-star", "m/s", POSITIVE},
    BODY(, ""),
    BODY(_2, "-2"),
    [COR_SCENE_BETA] = {"beta", "", POSITIVE},
    [COR_SCENE_AT] = {"at", "m/s", POSITIVE},
    [COR_SCENE_STIFFNESS] = {"stiffness", "N/m^a", POSITIVE},
    [COR_SCENE_DAMPING_COEFFICIENT] = {"damping-coefficient", "N s/m^(b+1)", POSITIVE},
    [COR_SCENE_EFFECTIVE_MASS] = {"effective-mass", "kg", POSITIVE},
    [COR_SCENE_RESTITUTION] = {"restitution", "", 0, 1, 0, "a number above 0 and up to 1"},
    [COR_SCENE_ZETA] = {"zeta", "", NOT_NEGATIVE},
    [COR_SCENE_PLATE_THICKNESS] = {"plate-thickness", "m", POSITIVE},
    [COR_SCENE_GRAVITY] = {"gravity", "m/s^2", POSITIVE},
    [COR_SCENE_ADHESION] = {"adhesion", "J/m^2", POSITIVE},
    [COR_SCENE_YIELD_STRESS] = {"yield-stress", "Pa", POSITIVE},
    [COR_SCENE_LIQUID_VISCOSITY] = {"viscosity-liquid", "Pa s", POSITIVE},
    [COR_SCENE_GAP_OUTER] = {"gap-outer", "m", POSITIVE},
    [COR_SCENE_GAP_INNER] = {"gap-inner", "m", POSITIVE},
    [COR_SCENE_DURATION] = {"duration", "s", POSITIVE}};

int cor_option_allows(const struct cor_scene_option *option, double value)
{
    return cor_inline_is_finite(value) && value <= option->largest &&
           (option->least_allowed ? value >= option->least : value > option->least);
}

int cor_scene_given(const struct cor_scene *scene, int number)
{
    return !isnan(scene->number[number]);
}

double cor_scene_of_body(const struct cor_scene *scene, int number, int body)
{
    const int second = number + COR_SCENE_BODY;
    return scene->number[body == 2 && cor_scene_given(scene, second) ? second : number];
}

int cor_scene_mass_is_given(const struct cor_scene *scene, int body)
{
    const int own =
        body == 2 && (cor_scene_given(scene, COR_SCENE_MASS_2) || cor_scene_given(scene, COR_SCENE_DENSITY_2));
    return cor_scene_given(scene, own ? COR_SCENE_MASS_2 : COR_SCENE_MASS);
}

int cor_scene_check_bodies(struct cor_scene_fault *fault, const struct cor_scene *scene, int options)
{
    static const int needed[] = {COR_SCENE_YOUNG, COR_SCENE_POISSON, COR_SCENE_RADIUS, COR_SCENE_DISSIPATION_TIME};
    const int count = (int)(sizeof needed / sizeof *needed) - !(options & COR_SCENE_DISSIPATES);
    const int dense = cor_scene_given(scene, COR_SCENE_DENSITY_2), massive = cor_scene_given(scene, COR_SCENE_MASS_2),
              may_be_dense = options & COR_SCENE_DENSE_WALL;
    struct cor_scene_fault f = {COR_FAULT_NONE, COR_SCENE_DENSITY, COR_SCENE_MASS, 0};
    if (cor_scene_given(scene, COR_SCENE_DENSITY) == cor_scene_given(scene, COR_SCENE_MASS))
        f.fault = COR_FAULT_ONE_OF;
    else if (dense && massive)
        f = (struct cor_scene_fault){COR_FAULT_EXCLUDED, COR_SCENE_DENSITY_2, COR_SCENE_MASS_2, 0};
    else if (scene->wall && (cor_scene_given(scene, COR_SCENE_RADIUS_2) || massive || (dense && !may_be_dense)))
        f = (struct cor_scene_fault){COR_FAULT_WALL, may_be_dense ? COR_SCENE_RADIUS_2 : COR_SCENE_DENSITY_2, 0, 0};
    for (int i = count - 1; i >= 0; i--) /* the first missing number takes precedence over all other faults */
        if (!cor_scene_given(scene, needed[i]))
            f = (struct cor_scene_fault){COR_FAULT_MISSING, needed[i], needed[i], 0};
    *fault = f;
    return f.fault;
}

/* ---- messages of faults ---- */

#define BODY_RULE                                                                                                      \
    "a contact of bodies needs --young, --poisson, --radius and --density or --mass, for example --young 7e10 "        \
    "--poisson 0.17 --radius 1e-3 --density 1600; describe a different second body by the same options with -2, or "   \
    "by "                                                                                                              \
    "--wall"
#define PAIR_RULE                                                                                                      \
    "With --effective-mass, two of these four determine a contact: --stiffness, --damping-coefficient, --duration, "   \
    "and one of --restitution, --beta and --zeta"
#define WAY_RULE                                                                                                       \
    "Give one dissipation: --dissipation-time A (s), --viscosity ETA1,ETA2 (Pa s), --g-star G (m/s), --restitution E " \
    "--at SPEED (such as --restitution 0.9 --at 1), --damping-coefficient C, --beta B --at SPEED or --zeta Z"

/* Words in braces are replaced. {number}, {other}: names of options. {law}: the law. {bodies}: a rule for bodies.
 * {status}: the status of libcor. {more}: the text of more_of. */
static const char *const sentences[] = {
    [COR_FAULT_SOLVER] = "the law {law} has no functions in cor; corgen contact solves it",
    [COR_FAULT_NO_DAMPING] =
        "found no damping that gives the eps of --restitution; give another --restitution or --end",
    [COR_FAULT_MISSING] = "--{number} is missing: {bodies}",
    [COR_FAULT_ONE_OF] = "give exactly one of --{number} and --{other}; {bodies}",
    [COR_FAULT_EXCLUDED] = "--{number} and --{other} exclude each other",
    [COR_FAULT_WALL] = "--wall is flat and fixed: leave out --radius-2{more} and --mass-2",
    [COR_FAULT_MATERIAL] = "the numbers of these bodies give no contact: {status}",
    [COR_FAULT_VISCOSITY] =
        "--{number} is not two numbers, 0 or more, with a comma between them: ETA1,ETA2 in Pa s, for example 1e3,2e3",
    [COR_FAULT_PLATE_LAW] = "--plate-thickness needs --law plate",
    [COR_FAULT_PLATE_END] = "--end zero-force does not apply to --law plate, whose contact force is never attractive; "
                            "write --end zero-overlap",
    [COR_FAULT_PLATE_BODIES] =
        "--law plate needs a sphere and a plate, for example --young 7e10 --poisson 0.24 --radius 5e-3 --density 2500 "
        "--plate-thickness 3e-3; a plate of another material has --young-2, --poisson-2 and --density-2",
    [COR_FAULT_PLATE_NUMBERS] =
        "--law plate needs --plate-thickness H in m, for example 3e-3; a plate of another material has --young-2, "
        "--poisson-2 and --density-2, but no --radius-2, --mass-2 or --wall",
    [COR_FAULT_PLATE_DENSITY] =
        "--density-2 is missing: the density of the plate in kg/m^3, for example --density-2 2500",
    [COR_FAULT_PLATE_DAMPING] = "--law plate has no --{number}, because the plate dissipates by its own motion; "
                                "allowed: --dissipation-time or --viscosity of the sphere",
    [COR_FAULT_TWO_CONTACTS] = "give bodies, or --stiffness with --effective-mass, but not both; {bodies}",
    [COR_FAULT_SPRING] =
        "--{number} is missing: a spring needs --stiffness K in N/m^a, or the --duration T of its contacts in s, and "
        "--effective-mass m_1 m_2/(m_1 + m_2) in kg, for example --stiffness 1e5 --effective-mass 1e-3{more}",
    [COR_FAULT_NOT_HERTZ] =
        "two bodies have Hertz's force, x^(3/2), but the law {law} has another; instead of bodies give --stiffness K "
        "in N/m^a and --effective-mass M in kg, for example --stiffness 1e5 --effective-mass 1e-3",
    [COR_FAULT_NO_WAY] =
        "no dissipation is given. For a ball that drops from the height H and rebounds to H', write "
        "--restitution E --at G, with E = sqrt(H'/H) and G = sqrt(2 g H). For an elastic contact write "
        "--dissipation-time 0. " WAY_RULE,
    [COR_FAULT_TWO_WAYS] = "--{number} and --{other} exclude each other{more}. " WAY_RULE ". " PAIR_RULE,
    [COR_FAULT_NOT_SPHERE] = "--{number} belongs to viscoelastic spheres, not to the law {law}; give --restitution "
                             "E{more} or --damping-coefficient C",
    [COR_FAULT_CONSTANT] = "--g-star: eps of the law {law} is the same at every speed; give --restitution E or --zeta "
                           "Z, for example --zeta 0.1",
    [COR_FAULT_NOT_CONSTANT] = "--zeta is the damping ratio of the laws linear and tsuji; for the law {law} give "
                               "--restitution E --at SPEED or --damping-coefficient C",
    [COR_FAULT_NO_BODIES] = "--{number} needs bodies{more}: {bodies}",
    [COR_FAULT_NO_SCALES] = "--{number} needs bodies, or --stiffness and --effective-mass: {bodies}",
    [COR_FAULT_NO_SPEED] = "--{number} needs --at SPEED in m/s, for example --at 1: {more}",
    [COR_FAULT_SPEED_ALONE] =
        "--at is the speed of --restitution, --beta or --duration; give one of them, or leave out --at",
    [COR_FAULT_FIRST_MISSING] = "--{number} needs --{other} of the first body",
    [COR_FAULT_NO_SECOND_BODY] = "--{number} needs a second body that is viscoelastic",
    [COR_FAULT_RANGE] = "a number of this contact, or its speed, is out of range; allowed: 1e-250 to 1e250 in SI "
                        "units, if the numbers of bodies and dissipation are not too far apart",
    [COR_FAULT_NO_STIFFNESS] =
        "no stiffness matches both given numbers. The bodies never part with this damping, or the "
        "damping is 0, or the stiffness is too large for a double",
    [COR_FAULT_PRESSED] =
        "the damping is too strong to integrate the law {law} under gravity or adhesion; use less damping",
    [COR_FAULT_GRAVITY] = "--gravity needs a ball on a --wall or a plate, because gravity does not press two free "
                          "bodies together; give --wall or leave out --gravity",
    [COR_FAULT_ADHESION] =
        "give --adhesion W in J/m^2 and --adhesion-model together, for example --adhesion 0.05 --adhesion-model dmt",
    [COR_FAULT_ADHESION_MODEL] =
        "--adhesion-model jkr needs spheres without gravity and yield, and the law viscoelastic, tsuji, hunt-crossley "
        "or hertz-dashpot; otherwise write --adhesion-model dmt, the constant force 2 pi W R",
    [COR_FAULT_PRESSED_LAW] = "--gravity and --adhesion are not possible with {more}; leave them out",
    [COR_FAULT_NO_YIELD] = "--law elastic-plastic needs --yield-stress Y in Pa, for example --yield-stress 1e9, or "
                           "--restitution E --at SPEED, measured at a speed at which the bodies yield",
    [COR_FAULT_YIELD_DAMPING] =
        "--{number}: the law elastic-plastic has no damping; give --yield-stress Y, or --restitution E --at SPEED",
    [COR_FAULT_LIQUID] = "--{number} is missing: a liquid needs --viscosity-liquid ETA in Pa s, --gap-outer and "
                         "--gap-inner in m, for example --viscosity-liquid 1e-3 --gap-outer 1e-4 --gap-inner 1e-6",
    [COR_FAULT_GAPS] = "--{number} must be larger than --{other}",
    [COR_FAULT_NO_DURATION] =
        "no damping makes this contact last for the --duration. Damping prolongs a contact that ends at zero overlap "
        "and shortens a contact that ends at zero force; give the other --end or another --duration",
    [COR_FAULT_EQUIVALENT] =
        "--equivalent makes a linear spring of two bodies at one speed. It needs --law linear, --at V, --young, "
        "--poisson, --radius, --density, and --restitution E or --dissipation-time with --end. Leave out "
        "--plate-thickness, --adhesion, --yield-stress, --viscosity-liquid and --duration",
    [COR_FAULT_TWO_DURATIONS] =
        "--dissipation-time and --duration do not determine a contact that ends at zero overlap: two stiffnesses can "
        "match them, or none. Give --end zero-force, or replace one of them by --stiffness or --restitution",
};

static const char *more_of(const struct cor_scene_fault *fault)
{
    const int number = fault->number;
    switch (fault->fault) {
    case COR_FAULT_WALL:
        return number == COR_SCENE_DENSITY_2 ? ", --density-2" : "";
    case COR_FAULT_NOT_SPHERE:
        return fault->other == COR_SCENE_AT ? " --at SPEED" : "";
    case COR_FAULT_SPRING:
        return number == COR_SCENE_STIFFNESS ? ". " PAIR_RULE : "";
    case COR_FAULT_TWO_WAYS:
        return fault->other == COR_SCENE_DURATION ? ", because the stiffness is given, too" : "";
    case COR_FAULT_NO_BODIES:
        return number == COR_SCENE_ADHESION    ? " for their radii"
               : number == COR_SCENE_VISCOSITY ? " for their elasticity"
                                               : "";
    case COR_FAULT_NO_SPEED:
        return number == COR_SCENE_DURATION
                   ? "durations of the law {law} depend on the speed (only the law linear needs no --at)"
                   : "eps of the law {law} depends on the speed (only linear and tsuji need no --at)";
    default:
        return number == COR_SCENE_YIELD_STRESS ? "--law elastic-plastic" : "a contact in a liquid";
    }
}

long cor_scene_fault_text(char *text, size_t size, const struct cor_scene_fault *fault, const char *law,
                          const char *rule)
{
    const struct {
        const char *word, *text;
    } words[] = {{"{number}", cor_scene_options[fault->number].name},
                 {"{other}", cor_scene_options[fault->other].name},
                 {"{law}", law},
                 {"{bodies}", rule ? rule : BODY_RULE},
                 {"{status}", cor_status_text(fault->status)}};
    const int known = fault->fault >= 0 && fault->fault < (int)(sizeof sentences / sizeof *sentences);
    const char *const sentence = known && sentences[fault->fault] ? sentences[fault->fault] : "";
    const char *const more = strstr(sentence, "{more}");
    char whole[COR_SCENE_FAULT_TEXT];
    size_t length = 0;
    snprintf(whole, sizeof whole, "%.*s%s%s", (int)(more ? more - sentence : COR_SCENE_FAULT_TEXT), sentence,
             more ? more_of(fault) : "", more ? more + 6 : "");
    for (const char *at = whole; *at;) {
        const char one[] = {*at, '\0'}, *part = one;
        size_t used = 1;
        for (size_t i = 0; i < sizeof words / sizeof *words && *at == '{'; i++)
            if (strncmp(at, words[i].word, strlen(words[i].word)) == 0) {
                part = words[i].text;
                used = strlen(words[i].word);
            }
        for (at += used; *part; part++, length++)
            if (length + 1 < size)
                text[length] = *part;
    }
    if (size > 0)
        text[length < size ? length : size - 1] = '\0';
    return (long)length;
}
