/* SPDX-License-Identifier: MIT */
/* The table behind cor_disk_eps, disk_limits.h: collisions of disks of all modes with a rigid wall, over cells of speed
 * and Poisson's ratio that are refined until their polynomials are good enough. The collisions take an hour, and are
 * kept: the header holds all that is known of them. */
#ifndef COR_GEN_TABLES_LIMITS_H
#define COR_GEN_TABLES_LIMITS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "tables/disk.h"

#define DISK_LIMITS_FILE "disk_limits.h"

/* Each returns STATUS_OK, or STATUS_FAILED after saying why. The table stays known until disk_limits_clear. */
int disk_limits_collide(const char *path);                             /* all; unfinished, they are in path.part */
int disk_limits_read(const char *text, size_t size, const char *path); /* a whole file; path: for messages */
bool disk_limits_known(void);
void disk_limits_clear(void);

/* Of the table that is known; the table of modes is not looked at. */
int disk_limits_write(FILE *file, const struct disk_table *modes);

/* Collides again, at places of a cell that the seed chooses, or at all places of all cells, and says on standard output
 * by how much 1 - eps^2 differs. STATUS_FAILED too if by more than DISK_LIMITS_AGREE, or if the cell's polynomial is
 * farther off between its places than it says. */
#define DISK_LIMITS_AGREE 2.5e-7
int disk_limits_check_sample(uint64_t seed);
int disk_limits_check_all(void);

#endif
