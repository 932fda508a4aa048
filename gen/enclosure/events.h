/* SPDX-License-Identifier: MIT */
/* The events of one collision, which the equation of motion determines */
#ifndef COR_GEN_ENCLOSURE_EVENTS_H
#define COR_GEN_ENCLOSURE_EVENTS_H

#include "series/law.h"

struct collision {
    arb_t x_max, t_max;
    arb_t eps_zero_overlap, t_zero_overlap;
    arb_t eps_zero_force, t_zero_force;
};

void collision_init(struct collision *c);
void collision_clear(struct collision *c);
LOCAL_STRUCT(collision)

#endif
