/* SPDX-License-Identifier: MIT */
/* What is wrong with a scene, in words. Numbers have the names of corgen's options. */
#include <stdio.h>

#include "cor/scene.h"
#include "cor/status.h"

#define BODY_RULE                                                                                                      \
    "a contact of bodies has --young, --poisson, --radius and --density or --mass, as --young 7e10 --poisson 0.17 "    \
    "--radius 1e-3 --density 1600; -2 for the second body, or --wall"
#define WAY_RULE                                                                                                       \
    "The dissipation is one of --dissipation-time A (s), --viscosity ETA1,ETA2 (Pa s), --g-star G (m/s), "             \
    "--restitution E --at SPEED (as --restitution 0.9 --at 1), --damping-coefficient C, --beta B --at SPEED, --zeta Z"

long cor_scene_fault_text(char *text, size_t size, const struct cor_scene_fault *fault, const char *law,
                          const char *rule)
{
    const char *const number = cor_scene_number_names[fault->number], *const other =
                                                                          cor_scene_number_names[fault->other];
    const char *const bodies = rule ? rule : BODY_RULE;
    switch (fault->fault) {
    case COR_FAULT_SOLVER:
        return snprintf(text, size, "the law %s has no functions in cor; corgen contact solves it", law);
    case COR_FAULT_NO_DAMPING:
        return snprintf(text, size, "no damping found for which eps is the --restitution");
    case COR_FAULT_MISSING:
        return snprintf(text, size, "--%s is missing: %s", number, bodies);
    case COR_FAULT_ONE_OF:
        return snprintf(text, size, "--%s and --%s: give one of them; %s", number, other, bodies);
    case COR_FAULT_EXCLUDED:
        return snprintf(text, size, "--%s and --%s exclude each other", number, other);
    case COR_FAULT_WALL:
        return snprintf(text, size, "--wall is flat and held fast: no --radius-2%s or --mass-2",
                        fault->number == COR_SCENE_DENSITY_2 ? ", --density-2" : "");
    case COR_FAULT_MATERIAL:
        return snprintf(text, size, "these bodies make no contact: %s", cor_status_text(fault->status));
    case COR_FAULT_VISCOSITY:
        return snprintf(text, size, "--%s is not two numbers, 0 or more: ETA1,ETA2 in Pa s, as 1e3,2e3", number);
    case COR_FAULT_PLATE_LAW:
        return snprintf(text, size, "--plate-thickness needs --law plate");
    case COR_FAULT_PLATE_END:
        return snprintf(
            text, size,
            "--end zero-force: a plate has the end zero-overlap alone; its contact force is never attractive");
    case COR_FAULT_PLATE_BODIES:
        return snprintf(text, size,
                        "--law plate needs a sphere and a plate: --young, --poisson, --radius, --density or --mass, "
                        "--plate-thickness, and -2 of the plate, as --young 7e10 --poisson 0.24 --radius 5e-3 "
                        "--density 2500 --plate-thickness 3e-3");
    case COR_FAULT_PLATE_NUMBERS:
        return snprintf(text, size,
                        "--law plate is a sphere on a plate of --plate-thickness H, as 3e-3, and, where they differ "
                        "from the sphere's, --young-2, --poisson-2 and --density-2; no --radius-2, --mass-2 or --wall");
    case COR_FAULT_PLATE_DENSITY:
        return snprintf(text, size, "--density-2 is missing: the density of the plate in kg/m^3, as 2500");
    case COR_FAULT_PLATE_DAMPING:
        return snprintf(text, size,
                        "the plate dissipates by its own motion: --law plate takes no --%s, only the "
                        "--dissipation-time or --viscosity of the sphere",
                        number);
    case COR_FAULT_TWO_CONTACTS:
        return snprintf(text, size, "--stiffness with --effective-mass and bodies exclude each other; %s", bodies);
    case COR_FAULT_SPRING:
        return snprintf(text, size,
                        "--%s is missing: a spring has --stiffness K in N/m^a, or the --duration T of its contacts in "
                        "s, and --effective-mass m_1 m_2/(m_1 + m_2) in kg, as --stiffness 1e5 --effective-mass 1e-3",
                        number);
    case COR_FAULT_NOT_HERTZ:
        return snprintf(text, size,
                        "two bodies have Hertz's force, x^(3/2); the law %s needs --stiffness K in N/m^a and "
                        "--effective-mass M in kg, as --stiffness 1e5 --effective-mass 1e-3",
                        law);
    case COR_FAULT_NO_WAY:
        return snprintf(text, size,
                        "no dissipation is given. A drop measures it: from the height H to H' on the rebound is "
                        "--restitution E --at G with E = sqrt(H'/H) and G = sqrt(2 g H), as --restitution 0.9 --at 1; "
                        "--dissipation-time 0 is elastic. " WAY_RULE);
    case COR_FAULT_TWO_WAYS:
        return snprintf(text, size, "--%s and --%s exclude each other. " WAY_RULE, number, other);
    case COR_FAULT_NOT_SPHERE:
        return snprintf(text, size,
                        "--%s is that of viscoelastic spheres, not of the law %s: give --restitution E%s or "
                        "--damping-coefficient C",
                        number, law, fault->other == COR_SCENE_AT ? " --at SPEED" : "");
    case COR_FAULT_CONSTANT:
        return snprintf(text, size,
                        "--g-star: eps of the law %s is the same at every speed; give --restitution E or --zeta Z, as "
                        "--zeta 0.1",
                        law);
    case COR_FAULT_NOT_CONSTANT:
        return snprintf(text, size,
                        "--zeta is the damping ratio of the laws linear and tsuji; the law %s takes --restitution E "
                        "--at SPEED or --damping-coefficient C",
                        law);
    case COR_FAULT_NO_BODIES:
        return snprintf(text, size, "--%s needs bodies%s: %s", number,
                        fault->number == COR_SCENE_ADHESION    ? ", whose radii multiply it"
                        : fault->number == COR_SCENE_VISCOSITY ? ", whose elasticity divides it"
                                                               : "",
                        bodies);
    case COR_FAULT_NO_SCALES:
        return snprintf(text, size, "--%s needs bodies, or --stiffness and --effective-mass: %s", number, bodies);
    case COR_FAULT_NO_SPEED:
        if (fault->number == COR_SCENE_DURATION)
            return snprintf(text, size,
                            "--duration needs --at SPEED in m/s, as --at 1: durations of the law %s depend on the "
                            "speed (those of linear do not)",
                            law);
        return snprintf(text, size,
                        "--%s needs --at SPEED in m/s, as --at 1: eps of the law %s depends on the speed (that of "
                        "linear and tsuji does not)",
                        number, law);
    case COR_FAULT_SPEED_ALONE:
        return snprintf(text, size, "--at is the speed of --restitution, --beta or --duration, and none is given");
    case COR_FAULT_FIRST_MISSING:
        return snprintf(text, size, "--%s needs --%s, that of the first body", number, other);
    case COR_FAULT_NO_SECOND_BODY:
        return snprintf(text, size, "--%s needs a second body that is viscoelastic", number);
    case COR_FAULT_RANGE:
        return snprintf(text, size,
                        "the damping of this contact is beyond a double: the numbers of its bodies or of its "
                        "dissipation are too far apart");
    case COR_FAULT_NO_STIFFNESS:
        return snprintf(text, size,
                        "no stiffness makes the contact last for the --duration: with this damping its bodies never "
                        "part, or the stiffness is beyond a double");
    case COR_FAULT_PRESSED:
        return snprintf(text, size,
                        "the damping of the law %s is too strong to be integrated under gravity or adhesion", law);
    case COR_FAULT_GRAVITY:
        return snprintf(text, size,
                        "--gravity presses a ball to a --wall or a plate; two free bodies fall together, and their "
                        "contact knows nothing of it");
    case COR_FAULT_ADHESION:
        return snprintf(text, size,
                        "--adhesion W, in J/m^2, and --adhesion-model go together, as --adhesion 0.05 "
                        "--adhesion-model dmt");
    case COR_FAULT_ADHESION_MODEL:
        return snprintf(text, size,
                        "--adhesion-model jkr is for spheres alone, without gravity and yield, and for the laws "
                        "viscoelastic, tsuji, hunt-crossley and hertz-dashpot; dmt is the constant force 2 pi W R");
    case COR_FAULT_PRESSED_LAW:
        return snprintf(text, size, "--gravity and --adhesion have no answer for %s",
                        fault->number == COR_SCENE_YIELD_STRESS ? "--law elastic-plastic" : "a contact in a liquid");
    case COR_FAULT_NO_YIELD:
        return snprintf(text, size,
                        "--law elastic-plastic needs --yield-stress Y in Pa, as --yield-stress 1e9, or --restitution E "
                        "--at SPEED, measured where the bodies yield");
    case COR_FAULT_YIELD_DAMPING:
        return snprintf(text, size,
                        "--%s: the law elastic-plastic has no damping; it takes --yield-stress Y, or --restitution E "
                        "--at SPEED",
                        number);
    case COR_FAULT_LIQUID:
        return snprintf(text, size,
                        "--%s is missing: a liquid has --viscosity-liquid ETA in Pa s and --gap-outer and --gap-inner "
                        "in m, as --viscosity-liquid 1e-3 --gap-outer 1e-4 --gap-inner 1e-6",
                        number);
    case COR_FAULT_GAPS:
        return snprintf(text, size, "--%s is not larger than --%s", number, other);
    default:
        return snprintf(text, size, "%s", "");
    }
}
