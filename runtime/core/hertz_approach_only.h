/* SPDX-License-Identifier: MIT */
/* Damping during the approach only, for any law with Hertz's elastic force. The approach is that of the full law and
 * the rebound is elastic, so that eps^2/2 = (2/5) Y^(5/2) with the largest overlap Y of the full law. */
#ifndef COR_RUNTIME_HERTZ_APPROACH_ONLY_H
#define COR_RUNTIME_HERTZ_APPROACH_ONLY_H

#include "runtime/number/elementary.h"

/* sqrt(4/5) = (4/5)^(1/2) and (4/5)^(-1/10) as pairs */
#define COR_HERTZ_SPEED 8.94427190999915855407e-01
#define COR_HERTZ_SPEED_TAIL 2.31564598480493453558e-17
#define COR_HERTZ_TIME 1.02256518256357287200
#define COR_HERTZ_TIME_TAIL 5.54898733737113814765e-17
/* Half of the elastic duration, X_0 sqrt(pi) Gamma(7/5)/Gamma(9/10) */
#define COR_HERTZ_HALF_DURATION 1.60903272985952150442
#define COR_HERTZ_HALF_DURATION_TAIL 3.78449505742605387477e-17

/* eps = sqrt(4/5) Y^(5/4) */
COR_INLINE struct cor_inline_pair cor_hertz_eps_approach_only(struct cor_inline_pair overlap)
{
    const struct cor_inline_pair fourth_root = cor_pair_root(cor_pair_root(overlap));
    const struct cor_inline_pair power = cor_inline_pair_times(overlap, fourth_root);
    return cor_inline_pair_times(power, cor_pair(COR_HERTZ_SPEED, COR_HERTZ_SPEED_TAIL));
}

/* The overlap Y that belongs to eps: (5/4)^(2/5) eps^(4/5), with a few rounding errors */
COR_INLINE double cor_hertz_overlap_of_eps(double eps)
{
    const struct cor_inline_pair l = cor_kernel_minus_log(cor_pair(eps, 0));
    return 1.09336207394327805637 * cor_kernel_exp_minus_pair(cor_pair(0.8 * l.hi, 0)).hi;
}

/* Duration: the time of the largest overlap plus that of the elastic rebound. The rebound to the speed eps takes half
 * of the elastic duration times eps^(-1/5) = (4/5)^(-1/10) Y^(-1/4). */
COR_INLINE double cor_hertz_duration_approach_only(struct cor_inline_pair overlap, double time_of_max_overlap)
{
    const struct cor_inline_pair fourth_root = cor_pair_root(cor_pair_root(overlap));
    const struct cor_inline_pair half = cor_inline_pair_times(
        cor_pair(COR_HERTZ_HALF_DURATION, COR_HERTZ_HALF_DURATION_TAIL), cor_pair(COR_HERTZ_TIME, COR_HERTZ_TIME_TAIL));
    return cor_pair_plus(cor_pair_over(half, fourth_root), cor_pair(time_of_max_overlap, 0)).hi;
}

#endif
