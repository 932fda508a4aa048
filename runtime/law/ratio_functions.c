/* SPDX-License-Identifier: MIT */
/* The closed forms of the linear dashpot and of Tsuji's damping; tsuji.c computes Tsuji's times. */
#include "cor/law.h"
#include "runtime/law/define.h"
#include "runtime/number/fifth_root.h"

/* Tsuji's damping: (5/4 eps)^(2/5), eps at zero force */
static double cor_tsuji_inline_max_overlap(double zeta)
{
    if (!(zeta >= 0))
        return (double)NAN;
    if (zeta < COR_ROWS_RATIO_EPS_ZERO_FORCE_END) { /* the fifth root of (25/16) eps^2 */
        const double eps = cor_ratio_eps_zero_force(zeta);
        return cor_inline_fifth_root_normal(eps * eps * 1.5625);
    }
    if (isinf(zeta))
        return 0;
    const struct cor_inline_pair two_fifths = cor_pair(0.4, -2.22044604925031308085e-17);
    const struct cor_inline_pair log_5_4 = cor_pair(-8.92574205256839031675e-02, 8.60950677367028016675e-19);
    const struct cor_inline_pair part = cor_inline_pair_times(two_fifths, cor_ratio_force_exponent(zeta));
    const struct cor_inline_pair sum = cor_pair_two_sum(part.hi, log_5_4.hi);
    return cor_kernel_exp_minus_pair(cor_pair(sum.hi, sum.lo + (part.lo + log_5_4.lo))).hi;
}

#define LAW_OF_END_(law, end)                                                                                          \
    LAW_DEFINE(law##_eps_##end, ratio_eps_##end)                                                                       \
    LAW_DEFINE(law##_loss_##end, ratio_loss_##end)                                                                     \
    LAW_DEFINE(law##_zeta_##end, ratio_zeta_##end)                                                                     \
    LAW_DEFINE(law##_zeta_of_loss_##end, ratio_zeta_of_loss_##end)
#define LAW_OF_RATIO(law)                                                                                              \
    LAW_OF_END_(law, zero_overlap)                                                                                     \
    LAW_OF_END_(law, zero_force)                                                                                       \
    LAW_OF_END_(law, limited)                                                                                          \
    LAW_OF_END_(law, approach_only)

LAW_OF_RATIO(linear)
LAW_DEFINE(linear_duration_zero_overlap, linear_inline_duration_zero_overlap)
LAW_DEFINE(linear_duration_zero_force, linear_inline_duration_zero_force)
LAW_DEFINE_ONE_BY_ONE(linear_duration_limited, linear_inline_duration_limited)
LAW_DEFINE_ONE_BY_ONE(linear_duration_approach_only, linear_inline_duration_approach_only)
LAW_DEFINE(linear_max_overlap, ratio_eps_approach_only)
LAW_DEFINE(linear_time_of_max_overlap, linear_inline_time_of_max_overlap)

LAW_OF_RATIO(tsuji)
LAW_DEFINE_ONE_BY_ONE(tsuji_max_overlap, tsuji_inline_max_overlap)
