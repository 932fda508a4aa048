/* SPDX-License-Identifier: MIT */
/* The equation of motion from first contact to an event, step by step (docs/derivation.md, 6). */
#ifndef COR_GEN_ENCLOSURE_MOTION_H
#define COR_GEN_ENCLOSURE_MOTION_H

#include "enclosure/events.h"

/* How far the motion is followed. Events on the way are recorded too. */
enum motion_goal { MOTION_TURNING_POINT, MOTION_ZERO_FORCE, MOTION_ZERO_OVERLAP };

enum motion_outcome {
    MOTION_DONE,
    MOTION_IMPRECISE, /* more bits are needed */
    MOTION_ENDLESS    /* no event within TAYLOR_MAX_STEPS */
};

/* Follows the motion with prec bits and sets what the goal and the events before it determine. An overdamped law that
 * creeps to zero overlap for ever has eps_zero_overlap exactly 0 and t_zero_overlap = +inf: proved. */
enum motion_outcome motion_solve(struct collision *c, const arb_t beta, const struct law *law, enum motion_goal goal,
                                 slong prec);

/* To zero overlap at strong damping, n > 0, where the motion reaches the slow manifold to 2^-bits: loading, turning
 * point and zero force are followed, then the manifold takes over (slow_manifold.h). */
enum motion_outcome motion_solve_slow(struct collision *c, const arb_t beta, const struct law *law, slong bits,
                                      slong prec);

#endif
