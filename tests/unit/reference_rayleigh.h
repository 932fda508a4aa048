/* SPDX-License-Identifier: MIT */
#ifndef COR_TESTS_REFERENCE_RAYLEIGH_H
#define COR_TESTS_REFERENCE_RAYLEIGH_H

#include <cor/disk.h>

/* Returns the contact time and computes C^2 (2 I)^2 of mode[0..n-1], n > 0, in long double. The library's path of
 * integration leaves the real axis. */
long double reference_rayleigh(const struct cor_disk_mode *mode, size_t n, double nu, enum cor_disk_datum datum,
                               double speed, long double *fraction);

#endif
