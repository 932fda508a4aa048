/* SPDX-License-Identifier: MIT */
/* Published formulas that simulators use, for comparisons with exact functions; versions of models */
#ifndef COR_RUNTIME_SCENE_SIMULATORS_H
#define COR_RUNTIME_SCENE_SIMULATORS_H

#include <math.h>

#include "cor/scene.h"
#include "runtime/scene/exponents.h"

/* Thornton, Cummins and Cleary, Powder Technol. 233, 30 (2013): damping 2 gamma sqrt(m k_tangent), fitted to zero
 * force */
double cor_thornton_gamma(double e);
/* The polynomial of Tsuji, Tanaka and Ishida, Powder Technol. 71, 239 (1992), in the form of LAMMPS */
double cor_tsuji_alpha(double e);
/* beta as a function of e: Flores et al. (2011) */
double cor_flores_beta(double e);

/* The contact with the law of a model (NULL: its own) and with the damping of the model at a speed */
static inline struct cor_scene_contact cor_model_contact(struct cor_scene_contact c, const struct cor_exponents *law,
                                                         double damping, double speed_m_s)
{
    if (law) {
        c.law = *law;
        c.plate = 0;
    }
    c.damping = cor_law_is_constant(&c.law) ? damping : damping * pow(speed_m_s, -cor_scene_speed_exponent(&c));
    return c;
}

/* Density of a sphere; NaN: it has none, as a wall */
static inline double cor_scene_body_density(const struct cor_scene *scene, int body)
{
    const struct cor_body b = cor_scene_body(scene, body);
    return b.mass_kg / (4 * COR_PI / 3 * b.radius_m * b.radius_m * b.radius_m);
}

/* True if Young's modulus, Poisson's ratio or the density of the bodies differ */
static inline int cor_scene_materials_differ(const struct cor_scene *scene)
{
    const struct cor_body one = cor_scene_body(scene, 1), two = cor_scene_body(scene, 2);
    return one.young_modulus_pa != two.young_modulus_pa || one.poisson_ratio != two.poisson_ratio ||
           fabs(cor_scene_body_density(scene, 1) / cor_scene_body_density(scene, 2) - 1) > 1e-14;
}

/* Whether a version, by cor_simulator_version, has the model; 0: any version will do */
static inline int cor_model_has_version(const struct cor_simulator_model *model, long version)
{
    return version == 0 || (version >= model->since && (model->until == 0 || version <= model->until));
}

#endif
