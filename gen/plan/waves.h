/* SPDX-License-Identifier: MIT */
/* The energy that elastic waves alone take from a sphere that hits a massive wall */
#ifndef COR_GEN_PLAN_WAVES_H
#define COR_GEN_PLAN_WAVES_H

#include "embed/request.h"

/* 1 - eps^2 to first order at a speed in m/s, as cor_contact_wave_loss computes it, for a half-space with the density
 * of the sphere. NaN for a scene without a wall or without materials. */
double plan_wave_loss(const struct embed_request *request, double speed);

/* A malloc'ed sentence about this loss at the scene's largest speed, where eps is the restitution from the scene's
 * dissipation time. NULL if the loss is NaN. */
char *plan_wave_remark(const struct embed_request *request, double speed, double eps);

#endif
