/* SPDX-License-Identifier: MIT */
#ifndef COR_TESTS_REFERENCE_RAYLEIGH_H
#define COR_TESTS_REFERENCE_RAYLEIGH_H

#include <cor/disk.h>

/* C^2 (2 I)^2 of mode[0..n-1], n > 0, in long double, for the contact law's constant b, by another route than the
 * library's, which leaves the real axis */
void reference_rayleigh(const struct cor_disk_mode *mode, size_t n, long double b, double speed, long double *fraction);

#endif
