/* SPDX-License-Identifier: MIT */
/* Modes for collisions with the hard wall, as many as each collision needs, shared by the threads of a sweep. */
#ifndef COR_GEN_SWEEP_HARD_WALL_H
#define COR_GEN_SWEEP_HARD_WALL_H

#include <pthread.h>
#include <stddef.h>

#include "cor/disk.h"

/* Tables of one material, each for more levels of the ladder than the one before. A collision tries them in this order,
 * so that its numbers do not depend on the others. */
enum { HARD_WALL_TABLES = 4 };
struct hard_wall_tables {
    pthread_mutex_t lock;
    double nu;
    struct cor_disk_modes table[HARD_WALL_TABLES]; /* mode NULL: not made yet */
};

void hard_wall_tables_init(struct hard_wall_tables *tables);
void hard_wall_tables_clear(struct hard_wall_tables *tables);
/* Another material; no thread may be at work. */
void hard_wall_tables_set(struct hard_wall_tables *tables, double nu);

/* A workspace that grows when a collision needs more; NULL and 0 to begin with; the caller frees bytes. */
struct sweep_room {
    void *bytes;
    size_t size;
};

/* cor_disk_hard_wall_in with the first table that suffices; NaN in *out where nothing is known. */
int hard_wall_collide(struct cor_disk_hard_wall *out, struct hard_wall_tables *tables, double tolerance, double speed,
                      struct sweep_room *room);

#endif
