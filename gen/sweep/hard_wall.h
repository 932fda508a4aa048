/* SPDX-License-Identifier: MIT */
/* Tables of modes for collisions with the hard wall, shared by the threads of a sweep. Each collision uses the number
 * of modes that it needs. */
#ifndef COR_GEN_SWEEP_HARD_WALL_H
#define COR_GEN_SWEEP_HARD_WALL_H

#include <stddef.h>

#include "cor/disk.h"

/* Number of tables of one material. Each table has the modes of more levels than the previous one. Every collision
 * tries the tables in this order, so that its result does not depend on other collisions. */
enum { HARD_WALL_TABLES = 4 };
struct hard_wall_tables { /* begins as {0} */
    double nu;
    struct cor_disk_modes table[HARD_WALL_TABLES]; /* mode NULL: not computed yet */
};

/* Changes the material. No thread may use the tables meanwhile. */
void hard_wall_tables_set(struct hard_wall_tables *tables, double nu);
void hard_wall_tables_clear(struct hard_wall_tables *tables);

/* Calls cor_disk_hard_wall with the first table that suffices. Each call has the budget max_steps. Unknown numbers in
 * *out are NaN. */
int hard_wall_collide(struct cor_disk_hard_wall *out, struct hard_wall_tables *tables, double tolerance,
                      size_t max_steps, double speed);

#endif
