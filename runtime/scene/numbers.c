/* SPDX-License-Identifier: MIT */
/* The laws and numbers of a scene, and whether those of its bodies are complete. No function of libcor. */
#include <math.h>

#include "cor/scene.h"

const char *const cor_law_names[COR_LAWS] = {COR_LAW_NAMES, "plate", "elastic-plastic",
                                             "linear spring, dashpot x^(1/2)", "impulse"};

const struct cor_exponents cor_law_exponents[COR_LAW_IMPULSE] = {
    [COR_LAW_VISCOELASTIC] = {3, 1, 2},    [COR_LAW_LINEAR] = {1, 0, 1},        [COR_LAW_TSUJI] = {6, 1, 4},
    [COR_LAW_HUNT_CROSSLEY] = {3, 3, 2},   [COR_LAW_HERTZ_DASHPOT] = {3, 0, 2}, [COR_LAW_PLATE] = {3, 1, 2},
    [COR_LAW_ELASTIC_PLASTIC] = {3, 1, 2}, [COR_LAW_LINEAR_ROOT] = {2, 1, 2}};

const char *const cor_end_names[COR_ENDS] = {"zero overlap", "zero force", "limited", "approach only", "an instant"};

const char *const cor_scene_number_names[COR_SCENE_NUMBERS] = {[COR_SCENE_G_STAR] = "g-star",
                                                               [COR_SCENE_YOUNG] = "young",
                                                               [COR_SCENE_POISSON] = "poisson",
                                                               [COR_SCENE_RADIUS] = "radius",
                                                               [COR_SCENE_DENSITY] = "density",
                                                               [COR_SCENE_MASS] = "mass",
                                                               [COR_SCENE_DISSIPATION_TIME] = "dissipation-time",
                                                               [COR_SCENE_VISCOSITY] = "viscosity",
                                                               [COR_SCENE_BULK_VISCOSITY] = "bulk-viscosity",
                                                               [COR_SCENE_YOUNG_2] = "young-2",
                                                               [COR_SCENE_POISSON_2] = "poisson-2",
                                                               [COR_SCENE_RADIUS_2] = "radius-2",
                                                               [COR_SCENE_DENSITY_2] = "density-2",
                                                               [COR_SCENE_MASS_2] = "mass-2",
                                                               [COR_SCENE_DISSIPATION_TIME_2] = "dissipation-time-2",
                                                               [COR_SCENE_VISCOSITY_2] = "viscosity-2",
                                                               [COR_SCENE_BULK_VISCOSITY_2] = "bulk-viscosity-2",
                                                               [COR_SCENE_BETA] = "beta",
                                                               [COR_SCENE_AT] = "at",
                                                               [COR_SCENE_STIFFNESS] = "stiffness",
                                                               [COR_SCENE_DAMPING_COEFFICIENT] = "damping-coefficient",
                                                               [COR_SCENE_EFFECTIVE_MASS] = "effective-mass",
                                                               [COR_SCENE_RESTITUTION] = "restitution",
                                                               [COR_SCENE_ZETA] = "zeta",
                                                               [COR_SCENE_PLATE_THICKNESS] = "plate-thickness",
                                                               [COR_SCENE_GRAVITY] = "gravity",
                                                               [COR_SCENE_ADHESION] = "adhesion",
                                                               [COR_SCENE_YIELD_STRESS] = "yield-stress",
                                                               [COR_SCENE_LIQUID_VISCOSITY] = "viscosity-liquid",
                                                               [COR_SCENE_GAP_OUTER] = "gap-outer",
                                                               [COR_SCENE_GAP_INNER] = "gap-inner",
                                                               [COR_SCENE_DURATION] = "duration"};

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
    const int dense = cor_scene_given(scene, COR_SCENE_DENSITY_2), massive = cor_scene_given(scene, COR_SCENE_MASS_2);
    *fault = (struct cor_scene_fault){COR_FAULT_NONE, COR_SCENE_DENSITY, COR_SCENE_MASS, 0};
    for (int i = 0; i < count && !fault->fault; i++)
        if (!cor_scene_given(scene, needed[i]))
            *fault = (struct cor_scene_fault){COR_FAULT_MISSING, needed[i], needed[i], 0};
    if (fault->fault)
        return fault->fault;
    if (cor_scene_given(scene, COR_SCENE_DENSITY) == cor_scene_given(scene, COR_SCENE_MASS))
        fault->fault = COR_FAULT_ONE_OF;
    else if (dense && massive)
        *fault = (struct cor_scene_fault){COR_FAULT_EXCLUDED, COR_SCENE_DENSITY_2, COR_SCENE_MASS_2, 0};
    else if (scene->wall &&
             (cor_scene_given(scene, COR_SCENE_RADIUS_2) || massive || (dense && !(options & COR_SCENE_DENSE_WALL))))
        *fault = (struct cor_scene_fault){
            COR_FAULT_WALL, options & COR_SCENE_DENSE_WALL ? COR_SCENE_RADIUS_2 : COR_SCENE_DENSITY_2, 0, 0};
    return fault->fault;
}
