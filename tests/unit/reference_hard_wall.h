/* SPDX-License-Identifier: MIT */
/* Computes the collision of a disk with a rigid wall by the formulas of docs/theory-disks.md, 17, directly: every sum
 * is written out, and every contact is found anew. The forces act as plain kicks, with an error of order h^2. The
 * method is slow; it is the reference for runtime/disk/hard_wall_*.c. */
#ifndef COR_TESTS_REFERENCE_HARD_WALL_H
#define COR_TESTS_REFERENCE_HARD_WALL_H

#include <cor/disk.h>

struct reference_wall {
    double omega;  /* only modes below omega move */
    int fade_next; /* w = (1 - r^2)^2 (1 + fade_next r^2) */
    double h;
    int nyquist; /* angles are pi/nyquist apart; n goes up to nyquist */
    int angles;  /* number of angles, from 0 onward */
};

/* Returns 1 - eps^2, or NaN if a contact is not found or reaches the last angle. */
double reference_hard_wall(const struct cor_disk_modes *modes, double speed, const struct reference_wall *wall);

#endif
