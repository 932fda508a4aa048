/* SPDX-License-Identifier: MIT */
/* The part of the contact law that other files of the library need beside cor/disk.h. */
#ifndef COR_RUNTIME_DISK_QUASISTATIC_H
#define COR_RUNTIME_DISK_QUASISTATIC_H

#include "cor/disk.h"

/* q0 = 2 ln(limit/v) >= 0 of an impact speed v > 0, with an error of 1 ulp arbitrarily close to the limit of the law;
 * NaN beyond it. */
double cor_disk_depth(double speed, double nu, enum cor_disk_datum datum);

#endif
