/* SPDX-License-Identifier: MIT */
/* The closed forms of the linear dashpot and of Tsuji's damping; tsuji.c computes Tsuji's times. */
#include "cor/law.h"
#include "runtime/law/define.h"

#define LAW_OF_RATIO(law, end)                                                                                         \
    LAW_DEFINE(law##_eps_##end, ratio_eps_##end)                                                                       \
    LAW_DEFINE(law##_loss_##end, ratio_loss_##end)                                                                     \
    LAW_DEFINE(law##_zeta_##end, ratio_zeta_##end)                                                                     \
    LAW_DEFINE(law##_zeta_of_loss_##end, ratio_zeta_of_loss_##end)

LAW_OF_RATIO(linear, zero_overlap)
LAW_OF_RATIO(linear, zero_force)
LAW_OF_RATIO(linear, limited)
LAW_OF_RATIO(linear, approach_only)
LAW_DEFINE(linear_duration_zero_overlap, linear_inline_duration_zero_overlap)
LAW_DEFINE(linear_duration_zero_force, linear_inline_duration_zero_force)
LAW_DEFINE_ONE_BY_ONE(linear_duration_limited, linear_inline_duration_limited)
LAW_DEFINE_ONE_BY_ONE(linear_duration_approach_only, linear_inline_duration_approach_only)
LAW_DEFINE(linear_max_overlap, ratio_eps_approach_only)
LAW_DEFINE(linear_time_of_max_overlap, linear_inline_time_of_max_overlap)

LAW_OF_RATIO(tsuji, zero_overlap)
LAW_OF_RATIO(tsuji, zero_force)
LAW_OF_RATIO(tsuji, limited)
LAW_OF_RATIO(tsuji, approach_only)
LAW_DEFINE_ONE_BY_ONE(tsuji_max_overlap, tsuji_inline_max_overlap)
