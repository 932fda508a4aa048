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
int collision_with_cor(const struct cor_disk_modes *modes, size_t n_modes, double alpha, double tolerance,
                       struct cor_disk_collision *out);

/* Error against time of all methods, and the targets */
void collision_curves(struct disk_bench *bench);

/* Error and time of fewer modes and softer walls */
void collision_models(struct disk_bench *bench);

/* Parts of one evaluation of the wall's force by instruction set, and other ways to sum over the angles. Nothing where
 * the library's inner loops cannot be reached, that is, in a shared library. */
void collision_parts(struct disk_bench *bench);

#endif
