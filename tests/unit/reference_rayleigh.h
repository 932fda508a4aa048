/* SPDX-License-Identifier: MIT */
#ifndef COR_TESTS_REFERENCE_RAYLEIGH_H
#define COR_TESTS_REFERENCE_RAYLEIGH_H

#include <cor/disk.h>

/* The contact time, and C^2 (2 I)^2 of mode[0..n-1], n > 0, in long double, by another route than the library's, which
 * leaves the real axis */
long double reference_rayleigh(const struct cor_disk_mode *mode, size_t n, double nu, enum cor_disk_datum datum,
                               double speed, long double *fraction);

#endif
