/* SPDX-License-Identifier: MIT */
/* Where the free modes of a disk are, in double arithmetic, proved by nothing: disk_modes.c proves them. */
#ifndef COR_GEN_DISK_ESTIMATE_H
#define COR_GEN_DISK_ESTIMATE_H

#include "disk/equation.h"

/* Roots of one n below omega, and of all n; wrong by one where rounding errors reach a root. */
slong disk_estimate_count(const struct disk *disk, slong n, double omega);
double disk_estimate_total(const struct disk *disk, double omega);

/* The roots of one n below omega, upwards, malloc'ed. Those closer together than doubles can part are given equal. */
double *disk_estimate_roots(slong *count, const struct disk *disk, slong n, double omega);

#endif
