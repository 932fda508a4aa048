/* SPDX-License-Identifier: MIT */
/* The closed forms of Hunt and Crossley's law; hunt_crossley_times.c computes its times. */
#include "cor/law.h"
#include "runtime/law/define.h"

/* ((a + 1)/2 eps^2)^(1/(a + 1)) with eps of damping during the approach only, 0 <= a < inf */
static double cor_crossley_max_overlap(double beta, double elastic_exponent)
{
    const double a = elastic_exponent;
    if (!(beta > -1 && a >= 0) || isinf(a))
        return (double)NAN;
    if (isinf(beta))
        return 0;
    const struct cor_inline_pair plus = cor_pair_two_sum(1, a);
    const struct cor_inline_pair half = cor_kernel_minus_log(cor_pair_scaled(plus, 0.5));
    const struct cor_inline_pair eps = cor_kernel_minus_log(cor_crossley_eps_approach_pair(beta));
    const struct cor_inline_pair x = cor_pair_over(cor_pair_plus(half, cor_pair_scaled(eps, 2)), plus);
    return cor_kernel_exp_minus_pair(x).hi;
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
