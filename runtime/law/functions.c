/* SPDX-License-Identifier: MIT */
/* The table of law.h: every function by law, end of contact and quantity. */
#include <math.h>

#include "cor/law.h"
#include "cor/sphere.h"
#include "runtime/number/pair.h"

/* Hunt and Crossley's law by name has the elastic exponent 3/2. */
static double hunt_crossley_duration(double beta)
{
    return cor_inline_is_refused(beta) ? (double)NAN : cor_hunt_crossley_duration(beta, 1.5);
}

static double hunt_crossley_duration_approach_only(double beta)
{
    return cor_inline_is_refused(beta) ? (double)NAN : cor_hunt_crossley_duration_approach_only(beta, 1.5);
}

static double hunt_crossley_max_overlap(double beta)
{
    return cor_hunt_crossley_max_overlap(beta, 1.5);
}

static double hunt_crossley_time_of_max_overlap(double beta)
{
    return cor_inline_is_refused(beta) ? (double)NAN : cor_hunt_crossley_time_of_max_overlap(beta, 1.5);
}

static void one_by_one(double (*value)(double), const double *in, double *out, size_t n)
{
    for (size_t i = 0; i < n; i++)
        out[i] = value(in[i]);
}

static void hunt_crossley_duration_array(const double *in, double *out, size_t n)
{
    one_by_one(hunt_crossley_duration, in, out, n);
}

static void hunt_crossley_duration_approach_only_array(const double *in, double *out, size_t n)
{
    one_by_one(hunt_crossley_duration_approach_only, in, out, n);
}

static void hunt_crossley_max_overlap_array(const double *in, double *out, size_t n)
{
    one_by_one(hunt_crossley_max_overlap, in, out, n);
}

static void hunt_crossley_time_of_max_overlap_array(const double *in, double *out, size_t n)
{
    one_by_one(hunt_crossley_time_of_max_overlap, in, out, n);
}

/* The least double above -1 */
#define ABOVE_MINUS_1 (-0x1.fffffffffffffp-1)

enum { TABLE_LAWS = COR_LAW_HERTZ_DASHPOT + 1, TABLE_ENDS = COR_END_APPROACH_ONLY + 1 };

static const struct cor_law_function table[TABLE_LAWS][TABLE_ENDS][COR_QUANTITIES] =
    {
        [COR_LAW_VISCOELASTIC][COR_END_ZERO_OVERLAP] =
            {
                [COR_EPS] = {"viscoelastic_eps_zero_overlap", cor_sphere_eps_zero_overlap,
                             cor_sphere_eps_zero_overlap_array, cor_sphere_eps_zero_overlap_fast_arrayf, 0, INFINITY,
                             COR_SPHERE_EPS_MAX_ULP},
                [COR_LOSS] = {"viscoelastic_loss_zero_overlap", cor_sphere_loss_zero_overlap,
                              cor_sphere_loss_zero_overlap_array, cor_sphere_loss_zero_overlap_fast_arrayf, 0, INFINITY,
                              COR_SPHERE_LOSS_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"viscoelastic_damping_of_eps_zero_overlap", cor_sphere_beta_zero_overlap,
                                        cor_sphere_beta_zero_overlap_array, NULL, 0, 1, COR_SPHERE_BETA_MAX_ULP},
                [COR_DURATION] = {"viscoelastic_duration_zero_overlap", cor_sphere_duration_zero_overlap,
                                  cor_sphere_duration_zero_overlap_array, NULL, 0, INFINITY, COR_SPHERE_TIME_MAX_ULP},
                [COR_MAX_OVERLAP] = {"viscoelastic_max_overlap", cor_sphere_max_overlap, cor_sphere_max_overlap_array,
                                     NULL, 0, INFINITY, COR_SPHERE_MAX_OVERLAP_MAX_ULP},
                [COR_TIME_OF_MAX_OVERLAP] = {"viscoelastic_time_of_max_overlap",
                                             cor_sphere_time_of_max_overlap, cor_sphere_time_of_max_overlap_array, NULL,
                                             0, INFINITY, COR_SPHERE_TIME_MAX_ULP},
            },
        [COR_LAW_VISCOELASTIC][COR_END_ZERO_FORCE] =
            {
                [COR_EPS] = {"viscoelastic_eps_zero_force", cor_sphere_eps_zero_force, cor_sphere_eps_zero_force_array,
                             cor_sphere_eps_zero_force_fast_arrayf, 0, INFINITY, COR_SPHERE_EPS_MAX_ULP},
                [COR_LOSS] = {"viscoelastic_loss_zero_force", cor_sphere_loss_zero_force,
                              cor_sphere_loss_zero_force_array, cor_sphere_loss_zero_force_fast_arrayf, 0, INFINITY,
                              COR_SPHERE_LOSS_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"viscoelastic_damping_of_eps_zero_force", cor_sphere_beta_zero_force,
                                        cor_sphere_beta_zero_force_array, NULL, 0, 1, COR_SPHERE_BETA_MAX_ULP},
                [COR_DURATION] = {"viscoelastic_duration_zero_force", cor_sphere_duration_zero_force,
                                  cor_sphere_duration_zero_force_array, NULL, 0, INFINITY, COR_SPHERE_TIME_MAX_ULP},
                [COR_MAX_OVERLAP] = {"viscoelastic_max_overlap", cor_sphere_max_overlap, cor_sphere_max_overlap_array,
                                     NULL, 0, INFINITY, COR_SPHERE_MAX_OVERLAP_MAX_ULP},
                [COR_TIME_OF_MAX_OVERLAP] = {"viscoelastic_time_of_max_overlap", cor_sphere_time_of_max_overlap,
                                             cor_sphere_time_of_max_overlap_array, NULL, 0, INFINITY,
                                             COR_SPHERE_TIME_MAX_ULP},
            },
        [COR_LAW_VISCOELASTIC][COR_END_APPROACH_ONLY] =
            {
                [COR_EPS] = {"viscoelastic_eps_approach_only", cor_sphere_eps_approach_only,
                             cor_sphere_eps_approach_only_array, NULL, 0, INFINITY, COR_SPHERE_APPROACH_MAX_ULP},
                [COR_LOSS] = {"viscoelastic_loss_approach_only", cor_sphere_loss_approach_only,
                              cor_sphere_loss_approach_only_array, NULL, 0, INFINITY, COR_SPHERE_APPROACH_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"viscoelastic_damping_of_eps_approach_only", cor_sphere_beta_approach_only,
                                        cor_sphere_beta_approach_only_array, NULL, 0, 1, COR_SPHERE_APPROACH_MAX_ULP},
                [COR_DAMPING_OF_LOSS] = {"viscoelastic_damping_of_loss_approach_only",
                                         cor_sphere_beta_of_loss_approach_only,
                                         cor_sphere_beta_of_loss_approach_only_array, NULL, 0, 1,
                                         COR_SPHERE_APPROACH_MAX_ULP},
                [COR_DURATION] = {"viscoelastic_duration_approach_only", cor_sphere_duration_approach_only,
                                  cor_sphere_duration_approach_only_array, NULL, 0, INFINITY,
                                  COR_SPHERE_APPROACH_MAX_ULP},
                [COR_MAX_OVERLAP] = {"viscoelastic_max_overlap", cor_sphere_max_overlap, cor_sphere_max_overlap_array,
                                     NULL, 0, INFINITY, COR_SPHERE_MAX_OVERLAP_MAX_ULP},
                [COR_TIME_OF_MAX_OVERLAP] = {"viscoelastic_time_of_max_overlap", cor_sphere_time_of_max_overlap,
                                             cor_sphere_time_of_max_overlap_array, NULL, 0, INFINITY,
                                             COR_SPHERE_TIME_MAX_ULP},
            },
        [COR_LAW_LINEAR][COR_END_ZERO_OVERLAP] =
            {
                [COR_EPS] = {"linear_eps_zero_overlap", cor_linear_eps_zero_overlap, cor_linear_eps_zero_overlap_array,
                             NULL, 0, INFINITY, COR_LAW_EPS_MAX_ULP},
                [COR_LOSS] = {"linear_loss_zero_overlap", cor_linear_loss_zero_overlap,
                              cor_linear_loss_zero_overlap_array, NULL, 0, INFINITY, COR_LAW_LOSS_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"linear_damping_of_eps_zero_overlap", cor_linear_zeta_zero_overlap,
                                        cor_linear_zeta_zero_overlap_array, NULL, 0, 1, COR_LAW_INVERSE_MAX_ULP},
                [COR_DAMPING_OF_LOSS] = {"linear_damping_of_loss_zero_overlap", cor_linear_zeta_of_loss_zero_overlap,
                                         cor_linear_zeta_of_loss_zero_overlap_array, NULL, 0, 1,
                                         COR_LAW_INVERSE_MAX_ULP},
                [COR_DURATION] = {"linear_duration_zero_overlap", cor_linear_duration_zero_overlap,
                                  cor_linear_duration_zero_overlap_array, NULL, 0, INFINITY, COR_LAW_TIME_MAX_ULP},
                [COR_MAX_OVERLAP] = {"linear_max_overlap", cor_linear_max_overlap, cor_linear_max_overlap_array, NULL,
                                     0, INFINITY, COR_LAW_MAX_OVERLAP_MAX_ULP},
                [COR_TIME_OF_MAX_OVERLAP] = {"linear_time_of_max_overlap", cor_linear_time_of_max_overlap,
                                             cor_linear_time_of_max_overlap_array, NULL, 0, INFINITY,
                                             COR_LAW_TIME_MAX_ULP},
            },
        [COR_LAW_LINEAR][COR_END_ZERO_FORCE] =
            {
                [COR_EPS] = {"linear_eps_zero_force", cor_linear_eps_zero_force, cor_linear_eps_zero_force_array, NULL,
                             0, INFINITY, COR_LAW_EPS_MAX_ULP},
                [COR_LOSS] = {"linear_loss_zero_force", cor_linear_loss_zero_force, cor_linear_loss_zero_force_array,
                              NULL, 0, INFINITY, COR_LAW_LOSS_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"linear_damping_of_eps_zero_force", cor_linear_zeta_zero_force,
                                        cor_linear_zeta_zero_force_array, NULL, 0, 1, COR_LAW_INVERSE_MAX_ULP},
                [COR_DAMPING_OF_LOSS] = {"linear_damping_of_loss_zero_force", cor_linear_zeta_of_loss_zero_force,
                                         cor_linear_zeta_of_loss_zero_force_array, NULL, 0, 1, COR_LAW_INVERSE_MAX_ULP},
                [COR_DURATION] = {"linear_duration_zero_force", cor_linear_duration_zero_force,
                                  cor_linear_duration_zero_force_array, NULL, 0, INFINITY, COR_LAW_TIME_MAX_ULP},
                [COR_MAX_OVERLAP] = {"linear_max_overlap", cor_linear_max_overlap, cor_linear_max_overlap_array, NULL,
                                     0, INFINITY, COR_LAW_MAX_OVERLAP_MAX_ULP},
                [COR_TIME_OF_MAX_OVERLAP] = {"linear_time_of_max_overlap", cor_linear_time_of_max_overlap,
                                             cor_linear_time_of_max_overlap_array, NULL, 0, INFINITY,
                                             COR_LAW_TIME_MAX_ULP},
            },
        [COR_LAW_LINEAR][COR_END_LIMITED] =
            {
                [COR_EPS] = {"linear_eps_limited", cor_linear_eps_limited, cor_linear_eps_limited_array, NULL, 0,
                             INFINITY, COR_LAW_EPS_MAX_ULP},
                [COR_LOSS] = {"linear_loss_limited", cor_linear_loss_limited, cor_linear_loss_limited_array, NULL, 0,
                              INFINITY, COR_LAW_LOSS_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"linear_damping_of_eps_limited", cor_linear_zeta_limited,
                                        cor_linear_zeta_limited_array, NULL, 0, 1, COR_LAW_INVERSE_MAX_ULP},
                [COR_DAMPING_OF_LOSS] = {"linear_damping_of_loss_limited", cor_linear_zeta_of_loss_limited,
                                         cor_linear_zeta_of_loss_limited_array, NULL, 0, 1, COR_LAW_INVERSE_MAX_ULP},
                [COR_DURATION] = {"linear_duration_limited", cor_linear_duration_limited,
                                  cor_linear_duration_limited_array, NULL, 0, INFINITY, COR_LAW_TIME_MAX_ULP},
            },
        [COR_LAW_LINEAR][COR_END_APPROACH_ONLY] =
            {
                [COR_EPS] = {"linear_eps_approach_only", cor_linear_eps_approach_only,
                             cor_linear_eps_approach_only_array, NULL, 0, INFINITY, COR_LAW_EPS_MAX_ULP},
                [COR_LOSS] = {"linear_loss_approach_only", cor_linear_loss_approach_only,
                              cor_linear_loss_approach_only_array, NULL, 0, INFINITY, COR_LAW_LOSS_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"linear_damping_of_eps_approach_only", cor_linear_zeta_approach_only,
                                        cor_linear_zeta_approach_only_array, NULL, 0, 1, COR_LAW_INVERSE_MAX_ULP},
                [COR_DAMPING_OF_LOSS] = {"linear_damping_of_loss_approach_only", cor_linear_zeta_of_loss_approach_only,
                                         cor_linear_zeta_of_loss_approach_only_array, NULL, 0, 1,
                                         COR_LAW_INVERSE_MAX_ULP},
                [COR_DURATION] = {"linear_duration_approach_only", cor_linear_duration_approach_only,
                                  cor_linear_duration_approach_only_array, NULL, 0, INFINITY, COR_LAW_TIME_MAX_ULP},
                [COR_MAX_OVERLAP] = {"linear_max_overlap", cor_linear_max_overlap, cor_linear_max_overlap_array, NULL,
                                     0, INFINITY, COR_LAW_MAX_OVERLAP_MAX_ULP},
                [COR_TIME_OF_MAX_OVERLAP] = {"linear_time_of_max_overlap", cor_linear_time_of_max_overlap,
                                             cor_linear_time_of_max_overlap_array, NULL, 0, INFINITY,
                                             COR_LAW_TIME_MAX_ULP},
            },
        [COR_LAW_TSUJI][COR_END_ZERO_OVERLAP] =
            {
                [COR_EPS] = {"tsuji_eps_zero_overlap", cor_tsuji_eps_zero_overlap, cor_tsuji_eps_zero_overlap_array,
                             NULL, 0, INFINITY, COR_LAW_EPS_MAX_ULP},
                [COR_LOSS] = {"tsuji_loss_zero_overlap", cor_tsuji_loss_zero_overlap, cor_tsuji_loss_zero_overlap_array,
                              NULL, 0, INFINITY, COR_LAW_LOSS_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"tsuji_damping_of_eps_zero_overlap", cor_tsuji_zeta_zero_overlap,
                                        cor_tsuji_zeta_zero_overlap_array, NULL, 0, 1, COR_LAW_INVERSE_MAX_ULP},
                [COR_DAMPING_OF_LOSS] = {"tsuji_damping_of_loss_zero_overlap", cor_tsuji_zeta_of_loss_zero_overlap,
                                         cor_tsuji_zeta_of_loss_zero_overlap_array, NULL, 0, 1,
                                         COR_LAW_INVERSE_MAX_ULP},
                [COR_DURATION] = {"tsuji_duration_zero_overlap", cor_tsuji_duration_zero_overlap,
                                  cor_tsuji_duration_zero_overlap_array, NULL, 0, INFINITY, COR_LAW_TIME_MAX_ULP},
                [COR_MAX_OVERLAP] = {"tsuji_max_overlap", cor_tsuji_max_overlap, cor_tsuji_max_overlap_array, NULL, 0,
                                     INFINITY, COR_LAW_MAX_OVERLAP_MAX_ULP},
                [COR_TIME_OF_MAX_OVERLAP] = {"tsuji_time_of_max_overlap", cor_tsuji_time_of_max_overlap,
                                             cor_tsuji_time_of_max_overlap_array, NULL, 0, INFINITY,
                                             COR_LAW_TIME_MAX_ULP},
            },
        [COR_LAW_TSUJI][COR_END_ZERO_FORCE] =
            {
                [COR_EPS] = {"tsuji_eps_zero_force", cor_tsuji_eps_zero_force, cor_tsuji_eps_zero_force_array, NULL, 0,
                             INFINITY, COR_LAW_EPS_MAX_ULP},
                [COR_LOSS] = {"tsuji_loss_zero_force", cor_tsuji_loss_zero_force, cor_tsuji_loss_zero_force_array, NULL,
                              0, INFINITY, COR_LAW_LOSS_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"tsuji_damping_of_eps_zero_force", cor_tsuji_zeta_zero_force,
                                        cor_tsuji_zeta_zero_force_array, NULL, 0, 1, COR_LAW_INVERSE_MAX_ULP},
                [COR_DAMPING_OF_LOSS] = {"tsuji_damping_of_loss_zero_force", cor_tsuji_zeta_of_loss_zero_force,
                                         cor_tsuji_zeta_of_loss_zero_force_array, NULL, 0, 1, COR_LAW_INVERSE_MAX_ULP},
                [COR_DURATION] = {"tsuji_duration_zero_force", cor_tsuji_duration_zero_force,
                                  cor_tsuji_duration_zero_force_array, NULL, 0, INFINITY, COR_LAW_TIME_MAX_ULP},
                [COR_MAX_OVERLAP] = {"tsuji_max_overlap", cor_tsuji_max_overlap, cor_tsuji_max_overlap_array, NULL, 0,
                                     INFINITY, COR_LAW_MAX_OVERLAP_MAX_ULP},
                [COR_TIME_OF_MAX_OVERLAP] = {"tsuji_time_of_max_overlap", cor_tsuji_time_of_max_overlap,
                                             cor_tsuji_time_of_max_overlap_array, NULL, 0, INFINITY,
                                             COR_LAW_TIME_MAX_ULP},
            },
        [COR_LAW_TSUJI][COR_END_LIMITED] =
            {
                [COR_EPS] = {"tsuji_eps_limited", cor_tsuji_eps_limited, cor_tsuji_eps_limited_array, NULL, 0,
                             INFINITY, COR_LAW_EPS_MAX_ULP},
                [COR_LOSS] = {"tsuji_loss_limited", cor_tsuji_loss_limited, cor_tsuji_loss_limited_array, NULL, 0,
                              INFINITY, COR_LAW_LOSS_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"tsuji_damping_of_eps_limited",
                                        cor_tsuji_zeta_limited, cor_tsuji_zeta_limited_array, NULL, 0, 1,
                                        COR_LAW_INVERSE_MAX_ULP},
                [COR_DAMPING_OF_LOSS] = {"tsuji_damping_of_loss_limited", cor_tsuji_zeta_of_loss_limited,
                                         cor_tsuji_zeta_of_loss_limited_array, NULL, 0, 1, COR_LAW_INVERSE_MAX_ULP},
                [COR_DURATION] = {"tsuji_duration_limited", cor_tsuji_duration_limited,
                                  cor_tsuji_duration_limited_array, NULL, 0, INFINITY, COR_LAW_TIME_MAX_ULP},
            },
        [COR_LAW_TSUJI][COR_END_APPROACH_ONLY] =
            {
                [COR_EPS] = {"tsuji_eps_approach_only", cor_tsuji_eps_approach_only, cor_tsuji_eps_approach_only_array,
                             NULL, 0, INFINITY, COR_LAW_EPS_MAX_ULP},
                [COR_LOSS] = {"tsuji_loss_approach_only", cor_tsuji_loss_approach_only,
                              cor_tsuji_loss_approach_only_array, NULL, 0, INFINITY, COR_LAW_LOSS_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"tsuji_damping_of_eps_approach_only", cor_tsuji_zeta_approach_only,
                                        cor_tsuji_zeta_approach_only_array, NULL, 0, 1, COR_LAW_INVERSE_MAX_ULP},
                [COR_DAMPING_OF_LOSS] = {"tsuji_damping_of_loss_approach_only", cor_tsuji_zeta_of_loss_approach_only,
                                         cor_tsuji_zeta_of_loss_approach_only_array, NULL, 0, 1,
                                         COR_LAW_INVERSE_MAX_ULP},
                [COR_DURATION] = {"tsuji_duration_approach_only", cor_tsuji_duration_approach_only,
                                  cor_tsuji_duration_approach_only_array, NULL, 0, INFINITY, COR_LAW_TIME_MAX_ULP},
                [COR_MAX_OVERLAP] = {"tsuji_max_overlap", cor_tsuji_max_overlap, cor_tsuji_max_overlap_array, NULL, 0,
                                     INFINITY, COR_LAW_MAX_OVERLAP_MAX_ULP},
                [COR_TIME_OF_MAX_OVERLAP] = {"tsuji_time_of_max_overlap", cor_tsuji_time_of_max_overlap,
                                             cor_tsuji_time_of_max_overlap_array, NULL, 0, INFINITY,
                                             COR_LAW_TIME_MAX_ULP},
            },
        [COR_LAW_HUNT_CROSSLEY][COR_END_ZERO_OVERLAP] =
            {
                [COR_EPS] = {"hunt_crossley_eps_zero_overlap", cor_hunt_crossley_eps, cor_hunt_crossley_eps_array, NULL,
                             ABOVE_MINUS_1, INFINITY, COR_LAW_EPS_MAX_ULP},
                [COR_LOSS] = {"hunt_crossley_loss_zero_overlap", cor_hunt_crossley_loss, cor_hunt_crossley_loss_array,
                              NULL, ABOVE_MINUS_1, INFINITY, COR_LAW_LOSS_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"hunt_crossley_damping_of_eps_zero_overlap",
                                        cor_hunt_crossley_beta, cor_hunt_crossley_beta_array, NULL, 0, 1,
                                        COR_LAW_INVERSE_MAX_ULP},
                [COR_DAMPING_OF_LOSS] = {"hunt_crossley_damping_of_loss_zero_overlap", cor_hunt_crossley_beta_of_loss,
                                         cor_hunt_crossley_beta_of_loss_array, NULL, 0, 1, COR_LAW_INVERSE_MAX_ULP},
                [COR_DURATION] = {"hunt_crossley_duration_zero_overlap", hunt_crossley_duration,
                                  hunt_crossley_duration_array, NULL, 0, INFINITY, COR_LAW_TIME_MAX_ULP},
                [COR_MAX_OVERLAP] = {"hunt_crossley_max_overlap", hunt_crossley_max_overlap,
                                     hunt_crossley_max_overlap_array, NULL, ABOVE_MINUS_1, INFINITY,
                                     COR_LAW_MAX_OVERLAP_MAX_ULP},
                [COR_TIME_OF_MAX_OVERLAP] = {"hunt_crossley_time_of_max_overlap", hunt_crossley_time_of_max_overlap,
                                             hunt_crossley_time_of_max_overlap_array, NULL, 0, INFINITY,
                                             COR_LAW_TIME_MAX_ULP},
            },
        [COR_LAW_HUNT_CROSSLEY][COR_END_ZERO_FORCE] =
            {
                [COR_EPS] = {"hunt_crossley_eps_zero_force", cor_hunt_crossley_eps, cor_hunt_crossley_eps_array, NULL,
                             ABOVE_MINUS_1, INFINITY, COR_LAW_EPS_MAX_ULP},
                [COR_LOSS] = {"hunt_crossley_loss_zero_force", cor_hunt_crossley_loss, cor_hunt_crossley_loss_array,
                              NULL, ABOVE_MINUS_1, INFINITY, COR_LAW_LOSS_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"hunt_crossley_damping_of_eps_zero_force",
                                        cor_hunt_crossley_beta, cor_hunt_crossley_beta_array, NULL, 0, 1,
                                        COR_LAW_INVERSE_MAX_ULP},
                [COR_DAMPING_OF_LOSS] = {"hunt_crossley_damping_of_loss_zero_force", cor_hunt_crossley_beta_of_loss,
                                         cor_hunt_crossley_beta_of_loss_array, NULL, 0, 1, COR_LAW_INVERSE_MAX_ULP},
                [COR_DURATION] = {"hunt_crossley_duration_zero_force", hunt_crossley_duration,
                                  hunt_crossley_duration_array, NULL, 0, INFINITY, COR_LAW_TIME_MAX_ULP},
                [COR_MAX_OVERLAP] = {"hunt_crossley_max_overlap", hunt_crossley_max_overlap,
                                     hunt_crossley_max_overlap_array, NULL, ABOVE_MINUS_1, INFINITY,
                                     COR_LAW_MAX_OVERLAP_MAX_ULP},
                [COR_TIME_OF_MAX_OVERLAP] = {"hunt_crossley_time_of_max_overlap", hunt_crossley_time_of_max_overlap,
                                             hunt_crossley_time_of_max_overlap_array, NULL, 0, INFINITY,
                                             COR_LAW_TIME_MAX_ULP},
            },
        [COR_LAW_HUNT_CROSSLEY][COR_END_APPROACH_ONLY] =
            {
                [COR_EPS] = {"hunt_crossley_eps_approach_only", cor_hunt_crossley_eps_approach_only,
                             cor_hunt_crossley_eps_approach_only_array, NULL, ABOVE_MINUS_1, INFINITY,
                             COR_LAW_EPS_MAX_ULP},
                [COR_LOSS] = {"hunt_crossley_loss_approach_only", cor_hunt_crossley_loss_approach_only,
                              cor_hunt_crossley_loss_approach_only_array, NULL, ABOVE_MINUS_1, INFINITY,
                              COR_LAW_LOSS_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"hunt_crossley_damping_of_eps_approach_only",
                                        cor_hunt_crossley_beta_approach_only,
                                        cor_hunt_crossley_beta_approach_only_array, NULL, 0, 1,
                                        COR_LAW_INVERSE_MAX_ULP},
                [COR_DAMPING_OF_LOSS] = {"hunt_crossley_damping_of_loss_approach_only",
                                         cor_hunt_crossley_beta_of_loss_approach_only,
                                         cor_hunt_crossley_beta_of_loss_approach_only_array, NULL, 0, 1,
                                         COR_LAW_INVERSE_MAX_ULP},
                [COR_DURATION] = {"hunt_crossley_duration_approach_only", hunt_crossley_duration_approach_only,
                                  hunt_crossley_duration_approach_only_array, NULL, 0, INFINITY, COR_LAW_TIME_MAX_ULP},
                [COR_MAX_OVERLAP] = {"hunt_crossley_max_overlap", hunt_crossley_max_overlap,
                                     hunt_crossley_max_overlap_array, NULL, ABOVE_MINUS_1, INFINITY,
                                     COR_LAW_MAX_OVERLAP_MAX_ULP},
                [COR_TIME_OF_MAX_OVERLAP] = {"hunt_crossley_time_of_max_overlap", hunt_crossley_time_of_max_overlap,
                                             hunt_crossley_time_of_max_overlap_array, NULL, 0, INFINITY,
                                             COR_LAW_TIME_MAX_ULP},
            },
        [COR_LAW_HERTZ_DASHPOT][COR_END_ZERO_OVERLAP] =
            {
                [COR_EPS] = {"hertz_dashpot_eps_zero_overlap", cor_hertz_dashpot_eps_zero_overlap,
                             cor_hertz_dashpot_eps_zero_overlap_array, NULL, 0,
                             INFINITY, COR_HERTZ_DASHPOT_EPS_MAX_ULP},
                [COR_LOSS] = {"hertz_dashpot_loss_zero_overlap", cor_hertz_dashpot_loss_zero_overlap,
                              cor_hertz_dashpot_loss_zero_overlap_array, NULL, 0,
                              INFINITY, COR_HERTZ_DASHPOT_LOSS_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"hertz_dashpot_damping_of_eps_zero_overlap",
                                        cor_hertz_dashpot_beta_zero_overlap, cor_hertz_dashpot_beta_zero_overlap_array,
                                        NULL, 0, 1, COR_HERTZ_DASHPOT_BETA_MAX_ULP},
                [COR_DAMPING_OF_LOSS] = {"hertz_dashpot_damping_of_loss_zero_overlap",
                                         cor_hertz_dashpot_beta_of_loss_zero_overlap,
                                         cor_hertz_dashpot_beta_of_loss_zero_overlap_array, NULL, 0, 1,
                                         COR_HERTZ_DASHPOT_BETA_MAX_ULP},
                [COR_DURATION] = {"hertz_dashpot_duration_zero_overlap", cor_hertz_dashpot_duration_zero_overlap,
                                  cor_hertz_dashpot_duration_zero_overlap_array, NULL, 0, INFINITY,
                                  COR_HERTZ_DASHPOT_TIME_MAX_ULP},
                [COR_MAX_OVERLAP] = {"hertz_dashpot_max_overlap", cor_hertz_dashpot_max_overlap,
                                     cor_hertz_dashpot_max_overlap_array, NULL, 0, INFINITY,
                                     COR_HERTZ_DASHPOT_MAX_OVERLAP_MAX_ULP},
                [COR_TIME_OF_MAX_OVERLAP] = {"hertz_dashpot_time_of_max_overlap", cor_hertz_dashpot_time_of_max_overlap,
                                             cor_hertz_dashpot_time_of_max_overlap_array, NULL, 0, INFINITY,
                                             COR_HERTZ_DASHPOT_TIME_MAX_ULP},
            },
        [COR_LAW_HERTZ_DASHPOT][COR_END_ZERO_FORCE] =
            {
                [COR_EPS] = {"hertz_dashpot_eps_zero_force", cor_hertz_dashpot_eps_zero_force,
                             cor_hertz_dashpot_eps_zero_force_array, NULL, 0, INFINITY, COR_HERTZ_DASHPOT_EPS_MAX_ULP},
                [COR_LOSS] = {"hertz_dashpot_loss_zero_force", cor_hertz_dashpot_loss_zero_force,
                              cor_hertz_dashpot_loss_zero_force_array, NULL, 0, INFINITY,
                              COR_HERTZ_DASHPOT_LOSS_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"hertz_dashpot_damping_of_eps_zero_force", cor_hertz_dashpot_beta_zero_force,
                                        cor_hertz_dashpot_beta_zero_force_array, NULL, 0, 1,
                                        COR_HERTZ_DASHPOT_BETA_MAX_ULP},
                [COR_DAMPING_OF_LOSS] = {"hertz_dashpot_damping_of_loss_zero_force",
                                         cor_hertz_dashpot_beta_of_loss_zero_force,
                                         cor_hertz_dashpot_beta_of_loss_zero_force_array, NULL, 0, 1,
                                         COR_HERTZ_DASHPOT_BETA_MAX_ULP},
                [COR_DURATION] = {"hertz_dashpot_duration_zero_force", cor_hertz_dashpot_duration_zero_force,
                                  cor_hertz_dashpot_duration_zero_force_array, NULL, 0, INFINITY,
                                  COR_HERTZ_DASHPOT_TIME_MAX_ULP},
                [COR_MAX_OVERLAP] = {"hertz_dashpot_max_overlap", cor_hertz_dashpot_max_overlap,
                                     cor_hertz_dashpot_max_overlap_array, NULL, 0, INFINITY,
                                     COR_HERTZ_DASHPOT_MAX_OVERLAP_MAX_ULP},
                [COR_TIME_OF_MAX_OVERLAP] = {"hertz_dashpot_time_of_max_overlap", cor_hertz_dashpot_time_of_max_overlap,
                                             cor_hertz_dashpot_time_of_max_overlap_array, NULL, 0, INFINITY,
                                             COR_HERTZ_DASHPOT_TIME_MAX_ULP},
            },
        [COR_LAW_HERTZ_DASHPOT][COR_END_APPROACH_ONLY] =
            {
                [COR_EPS] = {"hertz_dashpot_eps_approach_only", cor_hertz_dashpot_eps_approach_only,
                             cor_hertz_dashpot_eps_approach_only_array, NULL, 0,
                             INFINITY, COR_HERTZ_DASHPOT_APPROACH_MAX_ULP},
                [COR_LOSS] = {"hertz_dashpot_loss_approach_only", cor_hertz_dashpot_loss_approach_only,
                              cor_hertz_dashpot_loss_approach_only_array, NULL, 0, INFINITY,
                              COR_HERTZ_DASHPOT_APPROACH_MAX_ULP},
                [COR_DAMPING_OF_EPS] = {"hertz_dashpot_damping_of_eps_approach_only",
                                        cor_hertz_dashpot_beta_approach_only,
                                        cor_hertz_dashpot_beta_approach_only_array, NULL, 0, 1,
                                        COR_HERTZ_DASHPOT_APPROACH_MAX_ULP},
                [COR_DAMPING_OF_LOSS] = {"hertz_dashpot_damping_of_loss_approach_only",
                                         cor_hertz_dashpot_beta_of_loss_approach_only,
                                         cor_hertz_dashpot_beta_of_loss_approach_only_array, NULL, 0, 1,
                                         COR_HERTZ_DASHPOT_APPROACH_MAX_ULP},
                [COR_DURATION] = {"hertz_dashpot_duration_approach_only", cor_hertz_dashpot_duration_approach_only,
                                  cor_hertz_dashpot_duration_approach_only_array, NULL, 0, INFINITY,
                                  COR_HERTZ_DASHPOT_APPROACH_MAX_ULP},
                [COR_MAX_OVERLAP] = {"hertz_dashpot_max_overlap", cor_hertz_dashpot_max_overlap,
                                     cor_hertz_dashpot_max_overlap_array, NULL, 0, INFINITY,
                                     COR_HERTZ_DASHPOT_MAX_OVERLAP_MAX_ULP},
                [COR_TIME_OF_MAX_OVERLAP] = {"hertz_dashpot_time_of_max_overlap", cor_hertz_dashpot_time_of_max_overlap,
                                             cor_hertz_dashpot_time_of_max_overlap_array, NULL, 0, INFINITY,
                                             COR_HERTZ_DASHPOT_TIME_MAX_ULP},
            },
};

const struct cor_law_function *cor_law_function(enum cor_law law, enum cor_end end, enum cor_quantity quantity)
{
    if ((unsigned)law >= TABLE_LAWS || (unsigned)end >= TABLE_ENDS || (unsigned)quantity >= COR_QUANTITIES)
        return NULL;
    const struct cor_law_function *const function = &table[law][end][quantity];
    return function->value ? function : NULL;
}

double cor_law_value(enum cor_law law, enum cor_end end, enum cor_quantity quantity, double x)
{
    const struct cor_law_function *const function = cor_law_function(law, end, quantity);
    return function ? function->value(x) : (double)NAN;
}

void cor_law_array(enum cor_law law, enum cor_end end, enum cor_quantity quantity, const double *in, double *out,
                   size_t n)
{
    const struct cor_law_function *const function = cor_law_function(law, end, quantity);
    if (function)
        function->array(in, out, n);
    else
        for (size_t i = 0; i < n; i++)
            out[i] = NAN;
}

void cor_law_arrayf(enum cor_law law, enum cor_end end, enum cor_quantity quantity, const float *in, float *out,
                    size_t n)
{
    enum { BLOCK = 256 };
    const struct cor_law_function *const function = cor_law_function(law, end, quantity);
    double wide[BLOCK];
    if (function && function->arrayf) {
        function->arrayf(in, out, n);
        return;
    }
    for (size_t i = 0, m; i < n; i += m) {
        m = n - i < BLOCK ? n - i : BLOCK;
        for (size_t j = 0; j < m; j++)
            wide[j] = (double)in[i + j];
        cor_law_array(law, end, quantity, wide, wide, m);
        for (size_t j = 0; j < m; j++)
            out[i + j] = cor_inline_narrow(wide[j]);
    }
}
