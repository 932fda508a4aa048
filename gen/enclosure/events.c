/* SPDX-License-Identifier: MIT */
#include "enclosure/events.h"

#define COLLISION(action, c)                                                                                           \
    FOR_ALL(arb, action, (c)->x_max, (c)->t_max, (c)->eps_zero_overlap, (c)->t_zero_overlap, (c)->eps_zero_force,      \
            (c)->t_zero_force)

void collision_init(struct collision *c)
{
    COLLISION(init, c);
}

void collision_clear(struct collision *c)
{
    COLLISION(clear, c);
}
