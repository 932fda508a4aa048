/* SPDX-License-Identifier: MIT */
/* One step of a collision: a drift over h and a kick of the wall, docs/derivation.md, 15. */
#ifndef COR_RUNTIME_DISK_COLLISION_STEP_H
#define COR_RUNTIME_DISK_COLLISION_STEP_H

#include "runtime/disk/collision_workspace.h"

/* The centre of mass and the wall; the modes are in struct cor_motion, where force_c and force_s hold that part of the
 * last kick that the modes have not received yet. */
struct cor_collision_state {
    double time;
    double depth;     /* x_0 + 1, which keeps digits that x_0 near -1 would lose times alpha */
    double v;         /* towards the wall, after the last kick */
    double load;      /* of the wall */
    double force;     /* of the modified potential (15.1), which replaces the wall in the kick */
    double stiffness; /* h^2 alpha (largest acceleration of the rim) at the last kick */
    double ripple;    /* by how much half the angles change the load, at the last scan */
    size_t window;    /* angles near the contact that are evaluated between two scans */
};

enum cor_collision_kick { COR_KICKED, COR_KICK_TOO_STIFF, COR_KICK_TOO_NARROW };

/* Which angles a kick evaluates: those of the window; all of them, to find the next window and whether the last one was
 * too narrow; or all of them because a window has been too narrow before. */
enum cor_collision_angles { COR_WINDOW, COR_SCAN, COR_ALL_ANGLES };

/* Load of the wall that counts for nothing, before and after the contact */
double cor_collision_negligible_load(const struct cor_motion *m);
/* Whether a collision with steps h can end within COR_DISK_COLLISION_MAX_STEPS, as far as its way to the wall shows */
int cor_collision_in_sight(const struct cor_motion *m, double h);
/* Sets the state at the first moment, the modes' included, to first order in the wall's force. */
void cor_collision_approach(struct cor_motion *m, double h, struct cor_collision_state *now);
/* Free motion over h: the modes turn, after their part of the last kick, and the centre drifts. */
void cor_collision_drift(struct cor_motion *m, double h, struct cor_collision_state *now);
/* The wall's kick over h at the positions of now */
enum cor_collision_kick cor_collision_kick(struct cor_motion *m, double h, enum cor_collision_angles angles,
                                           struct cor_collision_state *now);

/* Energy of a mode halfway through the kick */
double cor_collision_mode_energy(const struct cor_motion *m, size_t i);
/* How far any part of the rim can swing out of its round shape while nothing pushes */
double cor_collision_greatest_swing(const struct cor_motion *m);

#endif
