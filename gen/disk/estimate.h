/* SPDX-License-Identifier: MIT */
/* Estimates of the free modes of a disk in double arithmetic, without proof. modes.c proves the modes. */
#ifndef COR_GEN_DISK_ESTIMATE_H
#define COR_GEN_DISK_ESTIMATE_H

#include "disk/equation.h"

/* Number of roots below omega, of one n and of all n. The number is wrong by one if omega is within rounding errors of
 * a root. */
slong disk_estimate_count(const struct disk *disk, slong n, double omega);
double disk_estimate_total(const struct disk *disk, double omega);

/* The roots of one n below omega, in increasing order, malloc'ed. Roots that doubles cannot separate are equal. */
double *disk_estimate_roots(slong *count, const struct disk *disk, slong n, double omega);

#endif
