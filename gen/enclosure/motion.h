/* SPDX-License-Identifier: MIT */
/* Integrates the equation of motion from first contact to an event, step by step (docs/theory.md, 6). */
#ifndef COR_GEN_ENCLOSURE_MOTION_H
#define COR_GEN_ENCLOSURE_MOTION_H

#include "series/law.h"

/* The events of one collision, in the order of enum quantity */
enum { COLLISION_FIELDS = 6 };
struct collision {
    union {
        struct {
            arb_t eps_zero_overlap, eps_zero_force, t_zero_overlap, t_zero_force, x_max, t_max;
        };
        arb_t field[COLLISION_FIELDS];
    };
};

void collision_init(struct collision *c);
void collision_clear(struct collision *c);
LOCAL_STRUCT(collision)

/* The event at which the motion ends. Earlier events are recorded as well. */
enum motion_goal { MOTION_TURNING_POINT, MOTION_ZERO_FORCE, MOTION_ZERO_OVERLAP };

enum motion_outcome {
    MOTION_DONE,
    MOTION_IMPRECISE, /* more bits are needed */
    MOTION_MISSED,    /* no number of bits brings the motion close enough to the slow manifold */
    MOTION_ENDLESS    /* no event within TAYLOR_MAX_STEPS */
};

/* Integrates the motion with prec bits, and sets the fields that the goal and earlier events determine. If an
 * overdamped collision creeps to zero overlap and never ends, eps_zero_overlap is exactly 0 and t_zero_overlap = +inf,
 * both proved. */
enum motion_outcome motion_solve(struct collision *c, const arb_t beta, const struct cor_exponents *law,
                                 enum motion_goal goal, slong prec);

/* Integrates the motion under a constant force > 0. MOTION_ZERO_FORCE: to the surface, for a > b and beta > 0.
 * MOTION_ZERO_OVERLAP: to both ends. For bodies that stay together eps is exactly 0 and t = +inf. If the overlap never
 * exceeds the overlap at rest, x_max is the overlap at rest, and t_max = +inf. All are proved (docs/theory.md, 24). */
enum motion_outcome motion_solve_pressed(struct collision *c, const arb_t beta, const arb_t force,
                                         const struct cor_exponents *law, enum motion_goal goal, slong prec);

/* Solves to zero overlap at strong damping, n > 0, if the motion reaches the slow manifold to 2^-bits. It integrates
 * loading, turning point and zero force. The manifold gives the rest (slow_manifold.h). */
enum motion_outcome motion_solve_slow(struct collision *c, const arb_t beta, const struct cor_exponents *law,
                                      slong bits, slong prec);

/* Encloses the largest value of x^a + beta x^b x' during the collision, for a law with law_force_has_one_peak(). */
enum motion_outcome motion_force_max(arb_t force, const arb_t beta, const struct cor_exponents *law, slong prec);

#endif
