/* SPDX-License-Identifier: MIT */
/* Published formulas of simulators, to compare with exact functions; the input numbers of models */
#ifndef COR_RUNTIME_SCENE_SIMULATORS_H
#define COR_RUNTIME_SCENE_SIMULATORS_H

#include <math.h>

#include "cor/scene.h"
#include "runtime/scene/exponents.h"

/* Returns gamma of the damping 2 gamma sqrt(m k_tangent), which gives about e at zero force: a fit by Thornton, Cummins
 * and Cleary, Powder Technol. 233, 30 (2013). */
double cor_thornton_gamma(double e);
/* Returns the polynomial of Tsuji, Tanaka and Ishida, Powder Technol. 71, 239 (1992), in the form of LAMMPS. */
double cor_tsuji_alpha(double e);
/* Returns beta as a function of e: Flores et al. (2011). */
double cor_flores_beta(double e);

/* Returns the contact with the law of a model (NULL: its own law) and with the damping of the model at a speed. */
COR_INLINE struct cor_scene_contact cor_model_contact(struct cor_scene_contact c, const struct cor_exponents *law,
                                                      double damping, double speed_m_s)
{
    if (law) {
        c.law = *law;
        c.plate = 0;
    }
    const double q = cor_scene_speed_exponent(&c);
    c.damping = cor_law_is_constant(&c.law) ? damping : cor_quiet_product(damping, cor_quiet_power(speed_m_s, -q));
    return c;
}

/* Returns the density of a sphere; NaN for a wall, which has none. */
COR_INLINE double cor_scene_body_density(const struct cor_scene *scene, int body)
{
    const struct cor_body b = cor_scene_body(scene, body);
    const double square = cor_quiet_product(4 * COR_PI / 3 * b.radius_m, b.radius_m);
    return isinf(b.radius_m) ? (double)NAN : cor_quiet_quotient(b.mass_kg, cor_quiet_product(square, b.radius_m));
}

/* True if Young's modulus, Poisson's ratio or the density of the bodies differ */
COR_INLINE int cor_scene_materials_differ(const struct cor_scene *scene)
{
    const struct cor_body one = cor_scene_body(scene, 1), two = cor_scene_body(scene, 2);
    return one.young_modulus_pa != two.young_modulus_pa || one.poisson_ratio != two.poisson_ratio ||
           isgreater(fabs(cor_quiet_quotient(cor_scene_body_density(scene, 1), cor_scene_body_density(scene, 2)) - 1),
                     1e-14);
}

/* True if no simulator's formula overflows with these numbers: each is 0, unknown, or from 2^-160 to 2^160, about
 * 1e48 */
COR_INLINE int cor_is_moderate(const struct cor_scene_contact *contact, double speed_m_s)
{
    const double numbers[] = {contact->mass_kg, contact->stiffness, contact->radius_m, speed_m_s};
    int moderate = cor_contact_is_sound(contact);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        moderate =
            moderate && (isnan(numbers[i]) || numbers[i] == 0 || cor_inline_between(numbers[i], 0x1p-160, 0x1p160));
    return moderate;
}

/* True if a version has the model. version: a number from cor_simulator_version, or 0 for any version */
COR_INLINE int cor_model_has_version(const struct cor_simulator_model *model, long version)
{
    return version == 0 || (version >= model->since && (model->until == 0 || version <= model->until));
}

/* _has_law: 1 if the model has the law of the contact. _has_one_eps: 1 if it can realise eps at one speed. */
int cor_simulator_has_law(const struct cor_simulator_model *model, const struct cor_scene_contact *contact);
int cor_simulator_has_one_eps(const struct cor_simulator_model *model, const struct cor_scene_contact *contact);

/* A request to a model. contacts: made from the scene by cor_scene_contacts. speed_m_s: NaN for all speeds. eps: at the
 * speed, or at all speeds; NaN if it depends on the speed or the end. steps > 0: number of time steps in an elastic
 * duration; the damping is then corrected by cor_scene_step_corrected at the speed. */
struct cor_simulator_target {
    const struct cor_scene *scene;
    const struct cor_scene_contact *contacts;
    int count;
    double speed_m_s, eps, steps;
};
/* Return the damping of the model for the target, and the number that a user sets. same_law: use the law of the
 * contact; otherwise only its eps. They return NaN, and set the reason, if the number does not exist. */
double cor_simulator_damping(const struct cor_simulator_model *model, const struct cor_simulator_target *target,
                             int same_law);
double cor_simulator_number(const struct cor_simulator_model *model, const struct cor_simulator_target *target,
                            int same_law, enum cor_simulator_status *status);
/* Returns the damping corrected for target->steps; NaN without a known integrator. An impulse needs no correction. */
double cor_simulator_step_damping(const struct cor_simulator_model *model, const struct cor_simulator_target *target,
                                  int same_law, double damping);

#endif
