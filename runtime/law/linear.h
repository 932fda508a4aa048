/* SPDX-License-Identifier: MIT */
/* Times and overlaps of the linear dashpot x'' + 2 zeta x' + x = 0, in addition to the functions of damping_ratio.h. */
#ifndef COR_RUNTIME_LAW_LINEAR_H
#define COR_RUNTIME_LAW_LINEAR_H

#include "runtime/law/damping_ratio.h"

COR_KERNEL double cor_linear_inline_time_of_max_overlap_near(double zeta)
{
    return cor_ratio_phase_near(cor_pair(zeta, 0), cor_pair(2, 0)).hi;
}

COR_INLINE double cor_linear_inline_time_of_max_overlap(double zeta)
{
    return zeta >= 0 ? cor_ratio_phase_time(zeta).hi : (double)NAN;
}

COR_KERNEL double cor_linear_inline_duration_zero_force_near(double zeta)
{
    return 2 * cor_linear_inline_time_of_max_overlap_near(zeta);
}

COR_INLINE double cor_linear_inline_duration_zero_force(double zeta)
{
    return 2 * cor_linear_inline_time_of_max_overlap(zeta);
}

/* Returns the duration. The rebound of an undamped spring takes pi/2 at every speed. */
COR_INLINE double cor_linear_inline_duration_approach_only(double zeta)
{
    if (!(zeta >= 0))
        return (double)NAN;
    const struct cor_inline_pair rebound = cor_pair(COR_PI / 2, COR_PI_TAIL / 2);
    return cor_pair_plus(rebound, cor_ratio_phase_time(zeta)).hi;
}

COR_KERNEL double cor_linear_inline_duration_zero_overlap_near(double zeta)
{
    return cor_ratio_over_omega(zeta, cor_pair(COR_PI, COR_PI_TAIL)).hi;
}

COR_INLINE double cor_linear_inline_duration_zero_overlap(double zeta)
{
    if (!(zeta >= 0))
        return (double)NAN;
    return zeta < 1 ? cor_linear_inline_duration_zero_overlap_near(zeta) : (double)INFINITY;
}

/* Returns the duration. The force is twice the elastic force for the time atan(2 sqrt(2) zeta)/sqrt(2) = (2 zeta/R)
 * A(1/R), R = sqrt(1 + 8 zeta^2). Then the law holds for the time L/zeta. For zeta above 2^64 the sum is
 * pi/(2 sqrt(2)). */
COR_INLINE double cor_linear_inline_duration_limited(double zeta)
{
    if (!(zeta >= 0))
        return (double)NAN;
    if (zeta > COR_INLINE_2_40 * 16777216.0)
        return 1.11072073453959156175;
    const struct cor_inline_pair over = cor_pair_over(cor_pair(1, 0), cor_ratio_limited_parts(zeta).root);
    const struct cor_inline_pair numerator = cor_inline_pair_times(over, cor_pair(4 * zeta, 0));
    return cor_pair_plus(cor_ratio_phase_near(over, numerator), cor_ratio_limited_time(zeta)).hi;
}

#endif
