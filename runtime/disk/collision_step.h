/* SPDX-License-Identifier: MIT */
/* One step of a collision: a drift over h and a kick of the wall, docs/theory-disks.md, 15. */
#ifndef COR_RUNTIME_DISK_COLLISION_STEP_H
#define COR_RUNTIME_DISK_COLLISION_STEP_H

#include "runtime/disk/collision_workspace.h"

/* State of the centre of mass and of the wall. struct cor_motion holds the modes; its force_c and force_s hold the part
 * of the last kick that the modes have not received yet. */
struct cor_collision_state {
    double time;
    double depth;     /* x_0 + 1; alpha x_0 would lose digits near x_0 = -1 */
    double v;         /* towards the wall, after the last kick */
    double load;      /* of the wall */
    double force;     /* of the modified potential (15.1), which replaces the wall in the kick */
    double stiffness; /* h^2 alpha (largest acceleration of the rim) at the last kick */
    double ripple;    /* change of the load with half the angles, at the last scan */
    size_t window;    /* angles near the contact that are evaluated between two scans */
};

enum cor_collision_kick { COR_KICKED, COR_KICK_TOO_STIFF, COR_KICK_TOO_NARROW };

/* The angles that a kick evaluates. COR_WINDOW: those of the window. COR_SCAN: all angles, to find the next window and
 * to check the last one. COR_ALL_ANGLES: all angles, because a window was too narrow in an earlier run. */
enum cor_collision_angles { COR_WINDOW, COR_SCAN, COR_ALL_ANGLES };

/* The load of the wall that is negligible before and after the contact */
double cor_collision_negligible_load(const struct cor_motion *m);
/* Whether a collision with steps h can end within COR_DISK_COLLISION_MAX_STEPS, judged by the time to reach the wall */
int cor_collision_in_sight(const struct cor_motion *m, double h);
/* Sets the state of the disk and of its modes at the first moment, to first order in the wall's force. */
void cor_collision_approach(struct cor_motion *m, double h, struct cor_collision_state *now);
/* Free motion over h: the modes receive their part of the last kick and turn, and the centre drifts. */
void cor_collision_drift(struct cor_motion *m, double h, struct cor_collision_state *now);
/* The wall's kick over h at the positions of now */
enum cor_collision_kick cor_collision_kick(struct cor_motion *m, double h, enum cor_collision_angles angles,
                                           struct cor_collision_state *now);

/* Energy of a mode halfway through the kick */
double cor_collision_mode_energy(const struct cor_motion *m, size_t i);
/* Largest displacement of any part of the rim out of its round shape in free motion */
double cor_collision_greatest_swing(const struct cor_motion *m);

#endif
