/* SPDX-License-Identifier: MIT */
/* Remarks on effects beside the models: lines that end with \n, malloc'ed */
#ifndef COR_GEN_PLAN_REMARKS_H
#define COR_GEN_PLAN_REMARKS_H

#include "embed/request.h"

/* For a contact with force_n > 0: from which speed on gravity and adhesion may be left out. Sampled at 201 speeds of
 * the range, from above. */
char *plan_pressing_remark(const struct cor_scene_contact *contact, int end, double speed_min, double speed_max,
                           double tolerance);

/* 1 - eps^2 to first order at a speed in m/s, the energy that elastic waves alone take, as cor_contact_wave_loss
 * computes it, from a sphere that hits a massive wall, a half-space with the density of the sphere. NaN for a scene
 * without a wall or without materials. */
double plan_wave_loss(const struct embed_request *request, double speed);

/* A sentence about this loss at the scene's largest speed, where eps is the restitution from the scene's dissipation
 * time. NULL if the loss is NaN. */
char *plan_wave_remark(const struct embed_request *request, double speed, double eps);

#endif
