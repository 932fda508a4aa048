/* SPDX-License-Identifier: MIT */
/* The closed forms of Hunt and Crossley's law; hunt_crossley_times.c computes its times. */
#include "cor/law.h"
#include "runtime/law/define.h"
#include "runtime/number/fifth_root.h"

/* eps beyond this beta is computed in units of 2^-380, so that its fourth power is a normal number. */
#define CROSSLEY_HUGE COR_INLINE_2_500

/* X^(1/(a + 1)), X = (a + 1)/2 eps^2 with eps of damping during the approach only, 0 <= a < inf: the fifth root of X^2
 * for a = 3/2, the square root for a = 1 */
static double cor_crossley_max_overlap(double beta, double elastic_exponent)
{
    const double a = elastic_exponent;
    if (!(beta > -1 && a >= 0) || isinf(a))
        return (double)NAN;
    if (isinf(beta))
        return 0;
    if (a > COR_INLINE_2_100)
        return 1;
    const int huge = beta > CROSSLEY_HUGE;
    const struct cor_inline_pair eps = cor_pair_scaled(cor_crossley_eps_approach_pair(beta), huge ? 0x1p380 : 1);
    if (a == 1.5) { /* of 25/16 eps^4, and what its rounding leaves out */
        const struct cor_inline_pair square = cor_inline_product(eps.hi, eps.hi);
        const struct cor_inline_pair root = cor_inline_fifth_root_parts(square.hi * square.hi * 1.5625);
        const double rest = (0.4 * square.lo + 0.8 * eps.hi * eps.lo) / square.hi;
        return (root.hi + (root.lo + root.hi * rest)) * (huge ? 0x1p-304 : 1);
    }
    const struct cor_inline_pair plus = cor_pair_two_sum(1, a);
    const struct cor_inline_pair x = cor_inline_pair_times(cor_pair_scaled(plus, 0.5), cor_inline_pair_times(eps, eps));
    if (a == 1) {
        const struct cor_inline_pair root = cor_pair_root(x);
        return (root.hi + root.lo) * (huge ? 0x1p-380 : 1);
    }
    struct cor_inline_pair minus_log = cor_kernel_minus_log(x);
    if (huge)
        minus_log = cor_pair_plus(minus_log, cor_pair(760 * COR_KERNEL_LN2_HEAD, 760 * COR_KERNEL_LN2_TAIL));
    return cor_kernel_exp_minus_pair(cor_pair_over(minus_log, plus)).hi;
}

LAW_DEFINE(hunt_crossley_eps, crossley_eps)
LAW_DEFINE(hunt_crossley_loss, crossley_loss)
LAW_DEFINE(hunt_crossley_beta, crossley_beta)
LAW_DEFINE(hunt_crossley_beta_of_loss, crossley_beta_of_loss)
LAW_DEFINE(hunt_crossley_eps_approach_only, crossley_eps_approach_only)
LAW_DEFINE(hunt_crossley_loss_approach_only, crossley_loss_approach_only)
LAW_DEFINE(hunt_crossley_beta_approach_only, crossley_beta_approach_only)
LAW_DEFINE(hunt_crossley_beta_of_loss_approach_only, crossley_beta_of_loss_approach_only)
LAW_DEFINE_WITH_EXPONENT(hunt_crossley_max_overlap, crossley_max_overlap)
