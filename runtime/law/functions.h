/* SPDX-License-Identifier: MIT */
/* The list of functions whose array forms are loops of kernels: LOOP(name, public, least, largest). cor_<name>_near and
 * cor_<public> give the same bits on least <= x <= largest; cor_<public> takes every double. PARTED(name, public,
 * least, largest) has two kernels, cor_<name>_first where cor_<name>_is_first holds, and cor_<name>_second
 * elsewhere. */
#ifndef COR_RUNTIME_LAW_FUNCTIONS_H
#define COR_RUNTIME_LAW_FUNCTIONS_H

#include "runtime/law/hunt_crossley.h"
#include "runtime/law/linear.h"

#define COR_LAW_LOOPS(LOOP, PARTED)                                                                                    \
    LOOP(ratio_eps_zero_overlap, linear_eps_zero_overlap, 0.0, COR_RATIO_BELOW_ONE)                                    \
    LOOP(ratio_eps_zero_force, linear_eps_zero_force, 0.0, COR_RATIO_FORCE_NEAR)                                       \
    LOOP(ratio_eps_limited, linear_eps_limited, COR_RATIO_TINY, COR_RATIO_LIMITED_NEAR)                                \
    LOOP(ratio_eps_approach_only, linear_eps_approach_only, 0.0, COR_RATIO_FORCE_NEAR)                                 \
    LOOP(ratio_loss_zero_overlap, linear_loss_zero_overlap, COR_RATIO_TINY, COR_RATIO_BELOW_ONE)                       \
    LOOP(ratio_loss_zero_force, linear_loss_zero_force, COR_RATIO_TINY, COR_RATIO_FORCE_NEAR)                          \
    LOOP(ratio_loss_limited, linear_loss_limited, COR_RATIO_TINY, COR_RATIO_LIMITED_NEAR)                              \
    LOOP(ratio_loss_approach_only, linear_loss_approach_only, COR_RATIO_TINY, COR_RATIO_FORCE_NEAR)                    \
    LOOP(ratio_zeta_zero_overlap, linear_zeta_zero_overlap, COR_RATIO_TINY, 1.0)                                       \
    LOOP(ratio_zeta_zero_force, linear_zeta_zero_force, COR_RATIO_EPS_FORCE_NEAR, 1.0)                                 \
    LOOP(ratio_zeta_limited, linear_zeta_limited, COR_RATIO_EPS_LIMITED_NEAR, COR_RATIO_BELOW_ONE)                     \
    LOOP(ratio_zeta_approach_only, linear_zeta_approach_only, COR_RATIO_EPS_APPROACH_NEAR, 1.0)                        \
    LOOP(ratio_zeta_of_loss_zero_overlap, linear_zeta_of_loss_zero_overlap, COR_RATIO_TINY, COR_RATIO_BELOW_ONE)       \
    LOOP(ratio_zeta_of_loss_zero_force, linear_zeta_of_loss_zero_force, COR_RATIO_TINY, 1 - COR_RATIO_EPS_FORCE_NEAR)  \
    LOOP(ratio_zeta_of_loss_limited, linear_zeta_of_loss_limited, COR_RATIO_TINY, 1 - COR_RATIO_EPS_LIMITED_NEAR)      \
    LOOP(ratio_zeta_of_loss_approach_only, linear_zeta_of_loss_approach_only, COR_RATIO_TINY,                          \
         1 - COR_RATIO_EPS_APPROACH_NEAR)                                                                              \
    LOOP(linear_inline_duration_zero_overlap, linear_duration_zero_overlap, 0.0, COR_RATIO_BELOW_ONE)                  \
    LOOP(linear_inline_duration_zero_force, linear_duration_zero_force, 0.0, COR_RATIO_FORCE_NEAR)                     \
    LOOP(linear_inline_time_of_max_overlap, linear_time_of_max_overlap, 0.0, COR_RATIO_FORCE_NEAR)                     \
    PARTED(hc_eps, hunt_crossley_eps, COR_HC_TINY, COR_HC_LARGEST)                                                     \
    PARTED(hc_loss, hunt_crossley_loss, COR_HC_TINY, COR_HC_LARGEST)                                                   \
    PARTED(hc_beta, hunt_crossley_beta, COR_INLINE_2_M900, COR_RATIO_BELOW_ONE)                                        \
    PARTED(hc_beta_of_loss, hunt_crossley_beta_of_loss, COR_INLINE_2_M200, COR_RATIO_BELOW_ONE)                        \
    LOOP(hc_eps_approach_only, hunt_crossley_eps_approach_only, COR_HC_APPROACH_LEAST, COR_HC_APPROACH_NEAR)           \
    LOOP(hc_loss_approach_only, hunt_crossley_loss_approach_only, COR_HC_APPROACH_LEAST, COR_HC_APPROACH_NEAR)

#endif
