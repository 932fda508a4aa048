/* SPDX-License-Identifier: MIT */
/* The long table of disks: collisions over speeds, Poisson's numbers, hardnesses and numbers of modes, in disk_limits.csv,
 * and what they tend to, in disk_limits.h. The collisions take minutes, and are kept; the header is made of them. */
#ifndef COR_GEN_TABLES_LIMITS_H
#define COR_GEN_TABLES_LIMITS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "tables/disk.h"

#define DISK_LIMITS_ROWS_FILE "disk_limits.csv"
#define DISK_LIMITS_HEADER_FILE "disk_limits.h"
/* Tolerance of the collisions, on eps, and how much two results for 1 - eps^2 may differ: each is off by twice the
 * tolerance at most, and rounded to eight places. */
#define DISK_LIMITS_TOLERANCE 1e-7
#define DISK_LIMITS_AGREE (4 * DISK_LIMITS_TOLERANCE + 1e-8)

/* Each returns STATUS_OK, or STATUS_FAILED after saying why. The collisions stay known until disk_limits_clear. */
int disk_limits_collide(void);                                         /* all of them, on every processor */
int disk_limits_read(const char *text, size_t size, const char *path); /* a whole file; path: for messages */
bool disk_limits_known(void);
void disk_limits_clear(void);

/* Of the collisions that are known; the table is not looked at. */
int disk_limits_rows_write(FILE *file, const struct disk_table *table);
int disk_limits_header_write(FILE *file, const struct disk_table *table);

/* Computes collisions again, those that the seed chooses of one material, or all, and says on standard output by how
 * much they differ. STATUS_FAILED too if by more than DISK_LIMITS_AGREE. */
int disk_limits_check_sample(uint64_t seed);
int disk_limits_check_all(void);

#endif
