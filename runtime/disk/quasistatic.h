/* SPDX-License-Identifier: MIT */
/* What other files of the library need of the contact law beside cor/disk.h. */
#ifndef COR_RUNTIME_DISK_QUASISTATIC_H
#define COR_RUNTIME_DISK_QUASISTATIC_H

#include "cor/disk.h"

/* q0 = 2 ln(limit/v) >= 0 of an impact speed v > 0, to an ulp however near the limit of the law is; NaN beyond it. */
double cor_disk_depth(double speed, double nu, enum cor_disk_datum datum);

#endif
