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

/* In the order of enum cor_scene_number */
const char *const cor_scene_number_names[COR_SCENE_NUMBERS] = {"g-star",
                                                               "young",
                                                               "poisson",
                                                               "radius",
                                                               "density",
                                                               "mass",
                                                               "dissipation-time",
                                                               "viscosity",
                                                               "bulk-viscosity",
                                                               "young-2",
                                                               "poisson-2",
                                                               "radius-2",
                                                               "density-2",
                                                               "mass-2",
                                                               "dissipation-time-2",
                                                               "viscosity-2",
                                                               "bulk-viscosity-2",
                                                               "beta",
                                                               "at",
                                                               "stiffness",
                                                               "damping-coefficient",
                                                               "effective-mass",
                                                               "restitution",
                                                               "zeta",
                                                               "plate-thickness",
                                                               "gravity",
                                                               "adhesion",
                                                               "yield-stress",
                                                               "viscosity-liquid",
                                                               "gap-outer",
                                                               "gap-inner",
                                                               "duration"};

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
