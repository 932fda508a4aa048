/* SPDX-License-Identifier: MIT */
/* What the benchmarks of collisions share. */
#ifndef COR_BENCH_DISKS_COLLISION_H
#define COR_BENCH_DISKS_COLLISION_H

#include "disk.h"

/* The scene of the targets, nu = 0.33 */
enum { COLLISION_MODES = 940 };
#define COLLISION_ALPHA 500.0
#define COLLISION_SPEED 0.1

/* A collision takes from 1 ms to 1 s: those above 30 ms have one turn in four. */
static inline struct timing collision_timing(const struct disk_bench *bench)
{
    return (struct timing){8e6, bench->quick ? 4 : 12, 4};
}

/* The library's collision; its status, COR_OK or COR_TOLERANCE_NOT_REACHED. */
int collision_with_cor(const struct cor_disk_modes *modes, size_t n_modes, double alpha, double speed, double tolerance,
                       struct cor_disk_collision *out);

#endif
