/* SPDX-License-Identifier: MIT */
#include "contact/contact.h"

#include "cor/status.h"
#include "enclosure/collision.h"
#include "support/console.h"
#include "support/local.h"

const char *const contact_law_names[] = {COR_LAW_NAMES, "plate", NULL};

/* ---- enclosed collisions ---- */

enum { CONTACT_BITS = 64 };
#define ENCLOSED_BETA_MAX 1e12 /* beyond, the bits and the seconds of an enclosure grow without use */

static double nearest(const arb_t x)
{
    return arf_get_d(arb_midref(x), ARF_RND_NEAR);
}

struct law contact_law(const struct cor_exponents *exponents)
{
    const slong a = exponents->elastic, b = exponents->damping, d = exponents->denominator;
    return (struct law){ratio_make(a, d), ratio_make(b, d), d, a, b};
}

int contact_enclosed(struct cor_scaled_impact *impact, const struct cor_exponents *exponents, double beta, int end)
{
    const struct law law = contact_law(exponents);
    if (!(beta <= ENCLOSED_BETA_MAX))
        return -usage_error(
            "beta is %g at an impact; allowed for x'' + beta x^(%ld/%ld) x' + x^(%ld/%ld) = 0: up to %g", beta,
            (long)law.b.num, (long)law.b.den, (long)law.a.num, (long)law.a.den, ENCLOSED_BETA_MAX);
    struct collision c;
    LOCAL(arb, x);
    collision_init(&c);
    arb_set_d(x, beta);
    const int status = (end == COR_BOTH_ENDS        ? collision_solve
                        : end == COR_END_ZERO_FORCE ? collision_solve_force
                                                    : collision_solve_overlap)(&c, x, &law, CONTACT_BITS);
    *impact = (struct cor_scaled_impact){{nearest(c.eps_zero_overlap), nearest(c.eps_zero_force)},
                                         {nearest(c.t_zero_overlap), nearest(c.t_zero_force)},
                                         nearest(c.x_max)};
    collision_clear(&c);
    return status == 0 ? STATUS_OK : -STATUS_FAILED;
}

int contact_status(int status)
{
    return status < 0 ? -status : status == COR_FAULT_NONE ? STATUS_OK : STATUS_FAILED;
}

/* ---- what is wrong with a request ---- */

#define BODY_RULE                                                                                                      \
    "a contact of bodies has --young, --poisson, --radius and --density or --mass, as --young 7e10 --poisson 0.17 "    \
    "--radius 1e-3 --density 1600; -2 for the second body, or --wall"
#define WAY_RULE                                                                                                       \
    "the dissipation is one of --dissipation-time A (s), --viscosity ETA1,ETA2 (Pa s), --g-star G (m/s), "             \
    "--restitution E --at SPEED (as --restitution 0.9 --at 1), --damping-coefficient C, --beta B --at SPEED, --zeta Z"

static int refuse(const struct cor_scene_fault *fault, const struct embed_request *request, const struct law *law)
{
    const char *const number = cor_scene_number_names[fault->number], *const other =
                                                                          cor_scene_number_names[fault->other];
    const struct law_text equation = law_equation(law);
    switch (fault->fault) {
    case COR_FAULT_NO_DAMPING:
        return fail("no damping found for which eps is %g", embed_number(request, COR_SCENE_RESTITUTION));
    case COR_FAULT_MATERIAL:
        return usage_error("these bodies make no contact: %s", cor_status_text(fault->status));
    case COR_FAULT_VISCOSITY:
        return usage_error("--%s: '%s' is not two numbers, 0 or more, with a comma between them: ETA1,ETA2 in Pa s, as "
                           "1e3,2e3",
                           number, request->viscosity[fault->number == COR_SCENE_VISCOSITY_2]);
    case COR_FAULT_PLATE_LAW:
        return usage_error("--plate-thickness needs --law plate");
    case COR_FAULT_PLATE_END:
        return usage_error(
            "--end zero-force: a plate has the end zero-overlap alone; its contact force is never attractive");
    case COR_FAULT_PLATE_BODIES:
        return usage_error("--law plate needs a sphere and a plate: --young, --poisson, --radius, --density or --mass, "
                           "--plate-thickness, and -2 of the plate, as --young 7e10 --poisson 0.24 --radius 5e-3 "
                           "--density 2500 --plate-thickness 3e-3");
    case COR_FAULT_PLATE_NUMBERS:
        return usage_error(
            "--law plate is a sphere on a plate of --plate-thickness H, as 3e-3, and, where they differ from "
            "the sphere's, --young-2, --poisson-2 and --density-2; no --radius-2, --mass-2 or --wall");
    case COR_FAULT_PLATE_DENSITY:
        return usage_error("--density-2 is missing: the density of the plate in kg/m^3, as 2500");
    case COR_FAULT_PLATE_DAMPING:
        return usage_error("the plate dissipates by its own motion: --law plate takes no --%s, only the "
                           "--dissipation-time or --viscosity of the sphere",
                           number);
    case COR_FAULT_TWO_CONTACTS:
        return usage_error("--stiffness with --effective-mass and bodies exclude each other; " BODY_RULE);
    case COR_FAULT_SPRING:
        return usage_error("--%s is missing: a spring has --stiffness K in N/m^a and --effective-mass m_1 m_2/(m_1 + "
                           "m_2) in kg, as --stiffness 1e5 --effective-mass 1e-3",
                           number);
    case COR_FAULT_NOT_HERTZ:
        return usage_error("two bodies have Hertz's force, x^(3/2); the law %s needs --stiffness K in N/m^a and "
                           "--effective-mass M in kg, as --stiffness 1e5 --effective-mass 1e-3",
                           equation.text);
    case COR_FAULT_NO_WAY:
        return usage_error("no dissipation: " WAY_RULE);
    case COR_FAULT_TWO_WAYS:
        return usage_error("--%s and --%s exclude each other: " WAY_RULE, number, other);
    case COR_FAULT_NOT_SPHERE:
        return usage_error("--%s is that of viscoelastic spheres, not of the law %s: give --restitution E%s or "
                           "--damping-coefficient C",
                           number, equation.text, law_is_linear(law) ? "" : " --at SPEED");
    case COR_FAULT_CONSTANT:
        return usage_error(
            "--g-star: eps of the law %s is the same at every speed; give --restitution E or --zeta Z, as --zeta 0.1",
            equation.text);
    case COR_FAULT_NOT_CONSTANT:
        return usage_error("--zeta is the damping ratio of the laws linear and tsuji; the law %s takes --restitution E "
                           "--at SPEED or --damping-coefficient C",
                           equation.text);
    case COR_FAULT_NO_BODIES:
        return usage_error("--viscosity needs bodies, whose elasticity divides it: " BODY_RULE);
    case COR_FAULT_NO_SCALES:
        return usage_error("--%s needs bodies, or --stiffness and --effective-mass: " BODY_RULE, number);
    case COR_FAULT_NO_SPEED:
        return usage_error("--%s needs --at SPEED in m/s, as --at 1: eps of the law %s depends on the speed (that of "
                           "linear and tsuji does not)",
                           number, equation.text);
    case COR_FAULT_SPEED_ALONE:
        return usage_error("--at is the speed of --restitution or --beta, and neither is given");
    case COR_FAULT_FIRST_MISSING:
        return usage_error("--%s needs --%s, that of the first body", number, other);
    case COR_FAULT_NO_SECOND_BODY:
        return usage_error("--%s needs a second body that is viscoelastic", number);
    case COR_FAULT_RANGE:
        return usage_error("the damping of this contact is beyond a double: the numbers of its bodies or of its "
                           "dissipation are too far apart");
    default:
        return embed_refuse_bodies(fault, BODY_RULE);
    }
}

int contacts_of_request(struct contacts *contacts, const struct embed_request *request)
{
    struct cor_scene_fault fault;
    int status = embed_request_scene(&contacts->scene, request);
    if (status != STATUS_OK)
        return status;
    contacts->law = contact_law(&contacts->scene.law);
    contacts->scene.solver = contact_enclosed;
    status = cor_scene_contacts(contacts->contact, &contacts->count, &fault, &contacts->scene);
    return status < 0 ? STATUS_FAILED : status == COR_FAULT_NONE ? STATUS_OK : refuse(&fault, request, &contacts->law);
}
