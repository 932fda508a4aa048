/* SPDX-License-Identifier: MIT */
/* The list of functions whose array forms are loops: LOOP(name, public, least, largest, stages). The stages, those of
 * array_kernel.c in this order, and cor_<public> give the same bits on least <= x <= largest; cor_<public> takes every
 * double. PARTED(name, public, least, largest, split, first, second) has stages for the numbers that a `split` finds,
 * and others for the rest. */
#ifndef COR_RUNTIME_LAW_FUNCTIONS_H
#define COR_RUNTIME_LAW_FUNCTIONS_H

#include "runtime/law/hunt_crossley.h"
#include "runtime/law/linear.h"

/* The name has the end behind the law's: ratio_eps_zero_overlap for linear_eps_zero_overlap */
#define COR_LAW_RATIO_(LOOP, quantity, least, largest, stages)                                                         \
    LOOP(ratio_##quantity, linear_##quantity, least, largest, stages)
#define COR_LAW_LOOPS(LOOP, PARTED)                                                                                    \
    COR_LAW_RATIO_(LOOP, eps_zero_overlap, 0.0, COR_RATIO_BELOW_ONE, (OVERLAP, EXP))                                   \
    COR_LAW_RATIO_(LOOP, eps_zero_force, 0.0, COR_RATIO_FORCE_NEAR, (FORCE, PHASE, EXP))                               \
    COR_LAW_RATIO_(LOOP, eps_limited, COR_RATIO_TINY, COR_RATIO_LIMITED_NEAR, (LIMITED, PHASE, SHARE, EXP))            \
    COR_LAW_RATIO_(LOOP, eps_approach_only, 0.0, COR_RATIO_FORCE_NEAR, (APPROACH, PHASE, EXP))                         \
    COR_LAW_RATIO_(LOOP, loss_zero_overlap, COR_RATIO_TINY, COR_RATIO_BELOW_ONE, (OVERLAP, LOSS))                      \
    COR_LAW_RATIO_(LOOP, loss_zero_force, COR_RATIO_TINY, COR_RATIO_FORCE_NEAR, (FORCE, PHASE, LOSS))                  \
    COR_LAW_RATIO_(LOOP, loss_limited, COR_RATIO_TINY, COR_RATIO_LIMITED_NEAR, (LIMITED, PHASE, SHARE, LOSS))          \
    COR_LAW_RATIO_(LOOP, loss_approach_only, COR_RATIO_TINY, COR_RATIO_FORCE_NEAR, (APPROACH, PHASE, LOSS))            \
    COR_LAW_RATIO_(LOOP, zeta_zero_overlap, COR_RATIO_TINY, 1.0, (LOG, OF_OVERLAP))                                    \
    COR_LAW_RATIO_(LOOP, zeta_zero_force, COR_RATIO_EPS_FORCE_NEAR, 1.0, (LOG, HALF, START, PHASE, OF_PHASE))          \
    COR_LAW_RATIO_(LOOP, zeta_limited, COR_RATIO_EPS_LIMITED_NEAR, COR_RATIO_BELOW_ONE,                                \
                   (LOG, START_LIMITED, LIMITED, PHASE, SHARE, OF_LIMITED))                                            \
    COR_LAW_RATIO_(LOOP, zeta_approach_only, COR_RATIO_EPS_APPROACH_NEAR, 1.0, (LOG, START, PHASE, OF_PHASE))          \
    COR_LAW_RATIO_(LOOP, zeta_of_loss_zero_overlap, COR_RATIO_TINY, COR_RATIO_BELOW_ONE, (LOG_OF_LOSS, OF_OVERLAP))    \
    COR_LAW_RATIO_(LOOP, zeta_of_loss_zero_force, COR_RATIO_TINY, 1 - COR_RATIO_EPS_FORCE_NEAR,                        \
                   (LOG_OF_LOSS, HALF, START, PHASE, OF_PHASE))                                                        \
    COR_LAW_RATIO_(LOOP, zeta_of_loss_limited, COR_RATIO_TINY, 1 - COR_RATIO_EPS_LIMITED_NEAR,                         \
                   (LOG_OF_LOSS, START_LIMITED, LIMITED, PHASE, SHARE, OF_LIMITED))                                    \
    COR_LAW_RATIO_(LOOP, zeta_of_loss_approach_only, COR_RATIO_TINY, 1 - COR_RATIO_EPS_APPROACH_NEAR,                  \
                   (LOG_OF_LOSS, START, PHASE, OF_PHASE))                                                              \
    LOOP(linear_inline_duration_zero_overlap, linear_duration_zero_overlap, 0.0, COR_RATIO_BELOW_ONE, (TIME_OVERLAP))  \
    LOOP(linear_inline_duration_zero_force, linear_duration_zero_force, 0.0, COR_RATIO_FORCE_NEAR, (TIME, TWICE))      \
    LOOP(linear_inline_time_of_max_overlap, linear_time_of_max_overlap, 0.0, COR_RATIO_FORCE_NEAR, (TIME))             \
    PARTED(hc_eps, hunt_crossley_eps, COR_HC_TINY, COR_HC_LARGEST, WEAK, (ROOT, EPS_WEAK), (REST, EPS_STRONG))         \
    PARTED(hc_loss, hunt_crossley_loss, COR_HC_TINY, COR_HC_LARGEST, WEAK, (ROOT, LOSS_WEAK), (REST, LOSS_STRONG))     \
    PARTED(hc_beta, hunt_crossley_beta, COR_INLINE_2_M900, COR_RATIO_BELOW_ONE, LANGEVIN, (EPS, OF_LANGEVIN),          \
           (EPS, LIMIT, REST, LIMIT_STEP, REST, LIMIT_STEP))                                                           \
    PARTED(hc_beta_of_loss, hunt_crossley_beta_of_loss, COR_INLINE_2_M200, COR_RATIO_BELOW_ONE, LANGEVIN_OF_LOSS,      \
           (EPS_OF_LOSS, OF_LANGEVIN), (EPS_OF_LOSS, LIMIT, REST, LIMIT_STEP, REST, LIMIT_STEP))                       \
    LOOP(hc_eps_approach_only, hunt_crossley_eps_approach_only, COR_HC_APPROACH_LEAST, COR_HC_APPROACH_NEAR,           \
         (EPS_HC_APPROACH))                                                                                            \
    LOOP(hc_loss_approach_only, hunt_crossley_loss_approach_only, COR_HC_APPROACH_LEAST, COR_HC_APPROACH_NEAR,         \
         (LOSS_HC_APPROACH))

#endif
