/* SPDX-License-Identifier: MIT */
/* The table behind cor_disk_eps, disk_limits.h: collisions of disks of all modes with a rigid wall, over cells of speed
 * and Poisson's ratio that are refined until their polynomials are accurate enough. The collisions take a quarter of
 * an hour of CPU time and are kept: corgen is built with them. */
#ifndef COR_GEN_TABLES_LIMITS_H
#define COR_GEN_TABLES_LIMITS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#define DISK_LIMITS_FILE "disk_limits.h"

struct cor_disk_limit_piece;

/* Each returns STATUS_OK, or STATUS_FAILED after reporting the reason. The table stays in memory until
 * disk_limits_clear. */
int disk_limits_collide(void); /* computes all collisions */
/* Whether a table is in memory: that of disk_limits_collide, or that with which corgen was built, with other pieces
 * unless `piece` is NULL. A corgen of COR_BOOTSTRAP is built with none. */
bool disk_limits_known(const struct cor_disk_limit_piece *piece);
void disk_limits_clear(void);

/* Writes the table in memory. */
int disk_limits_write(FILE *file);

/* Recomputes collisions at points of a cell that the seed chooses, or at all points of all cells, and prints the
 * difference of 1 - eps^2 on standard output. Returns STATUS_FAILED also if the difference exceeds DISK_LIMITS_AGREE,
 * or if the error of a cell's polynomial between its points exceeds its uncertainty. */
#define DISK_LIMITS_AGREE 2.5e-7
int disk_limits_check_sample(uint64_t seed);
int disk_limits_check_all(void);

#endif
