/* SPDX-License-Identifier: MIT */
#include "cor/sphere.h"
#include "sphere_eval.h"

double cor_sphere_eps_zero_overlap(double beta)
{
    return sphere_eps_zero_overlap(beta);
}

double cor_sphere_eps_zero_force(double beta)
{
    return sphere_eps_zero_force(beta);
}

double cor_sphere_loss_zero_overlap(double beta)
{
    return sphere_loss_zero_overlap(beta);
}

double cor_sphere_loss_zero_force(double beta)
{
    return sphere_loss_zero_force(beta);
}
