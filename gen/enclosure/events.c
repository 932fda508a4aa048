/* SPDX-License-Identifier: MIT */
#include "enclosure/events.h"

void collision_init(struct collision *c)
{
    arb_init(c->x_max);
    arb_init(c->t_max);
    arb_init(c->eps_zero_overlap);
    arb_init(c->t_zero_overlap);
    arb_init(c->eps_zero_force);
    arb_init(c->t_zero_force);
}

void collision_clear(struct collision *c)
{
    arb_clear(c->x_max);
    arb_clear(c->t_max);
    arb_clear(c->eps_zero_overlap);
    arb_clear(c->t_zero_overlap);
    arb_clear(c->eps_zero_force);
    arb_clear(c->t_zero_force);
}
