/* SPDX-License-Identifier: MIT */
/* From which speed on gravity and adhesion may be left out */
#ifndef COR_GEN_PLAN_PRESSING_H
#define COR_GEN_PLAN_PRESSING_H

#include "cor/scene.h"

/* For a contact with force_n > 0: lines that end with \n, malloc'ed. Sampled at 201 speeds of the range, from above. */
char *plan_pressing_remark(const struct cor_scene_contact *contact, int end, double speed_min, double speed_max,
                           double tolerance);

#endif
