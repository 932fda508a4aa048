/* SPDX-License-Identifier: MIT */
/* What cor_bench_disk measures, one function a table of disks.csv. */
#ifndef COR_BENCH_DISKS_STAGES_H
#define COR_BENCH_DISKS_STAGES_H

#include "disk.h"

/* Rayleigh's energy of 1800 modes from slow to fast, what a tolerance of it costs, and error against time */
void disk_rayleigh(struct disk_bench *bench);
void disk_tolerance(struct disk_bench *bench);
void disk_curves(struct disk_bench *bench);

/* Loading 1800 modes */
void disk_loading(struct disk_bench *bench);

/* A collision: error against time; what fewer modes and softer walls leave out */
void collision_curves(struct disk_bench *bench);
void collision_models(struct disk_bench *bench);

/* The rigid wall: error against time, beside soft walls extrapolated; random scenes to 1e-6 */
void disk_hard_wall(struct disk_bench *bench);

#endif
