/* SPDX-License-Identifier: MIT */
/* How far fractions of modes are off. */
#ifndef COR_BENCH_DISKS_ERRORS_H
#define COR_BENCH_DISKS_ERRORS_H

#include <stddef.h>

#include <cor/disk.h>

/* Largest relative error of a fraction, over the modes whose cosine does not cancel: (2 I)^2 omega^4, which but for the
 * cosine varies slowly, is above 1/100 of the largest among 25 neighbours on each side. */
double disk_worst_error(const struct cor_disk_mode *mode, size_t n, const double *fraction,
                        const long double *reference);

#endif
