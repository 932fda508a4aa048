/* SPDX-License-Identifier: MIT */
#include "cor/sphere.h"
#include "runtime/sphere/eval.h"

double cor_sphere_eps_zero_overlap(double beta)
{
    return cor_inline_eps_zero_overlap(beta);
}

double cor_sphere_eps_zero_force(double beta)
{
    return cor_inline_eps_zero_force(beta);
}

double cor_sphere_loss_zero_overlap(double beta)
{
    return cor_inline_loss_zero_overlap(beta);
}

double cor_sphere_loss_zero_force(double beta)
{
    return cor_inline_loss_zero_force(beta);
}

double cor_sphere_beta_zero_overlap(double eps)
{
    return cor_inline_beta_zero_overlap(eps);
}

double cor_sphere_beta_zero_force(double eps)
{
    return cor_inline_beta_zero_force(eps);
}

double cor_sphere_duration_zero_overlap(double beta)
{
    return cor_inline_duration_zero_overlap(beta);
}

double cor_sphere_duration_zero_force(double beta)
{
    return cor_inline_duration_zero_force(beta);
}

double cor_sphere_max_overlap(double beta)
{
    return cor_inline_max_overlap(beta);
}

double cor_sphere_time_of_max_overlap(double beta)
{
    return cor_inline_time_of_max_overlap(beta);
}
