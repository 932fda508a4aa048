/* SPDX-License-Identifier: MIT */
/* The part of the contact law that other files of the library need in addition to cor/disk.h. */
#ifndef COR_RUNTIME_DISK_QUASISTATIC_H
#define COR_RUNTIME_DISK_QUASISTATIC_H

#include "cor/disk.h"
#include "runtime/number/pair.h"

/* Returns q0 = 2 ln(limit/v) >= 0 of an impact speed v > 0, with an error of 1 ulp, even next to the limit of the law;
 * NaN beyond it. */
double cor_disk_depth(double speed, double nu, enum cor_disk_datum datum);

/* Return ln(limit/x) of a positive compression or speed x as the parts of cor_log_ratio_parts, with an absolute error
 * of 2^-54 (1 + 2^-20); NaN for nu or datum outside its domain. */
struct cor_inline_pair cor_disk_compression_depth(double compression, double nu, enum cor_disk_datum datum);
struct cor_inline_pair cor_disk_speed_depth(double speed, double nu, enum cor_disk_datum datum);

/* Return cor_disk_load and cor_disk_contact_time for every argument, without tables, in the default environment. */
double cor_disk_load_by_pairs(double compression, double nu, enum cor_disk_datum datum);
double cor_disk_contact_time_by_quadrature(double speed, double nu, enum cor_disk_datum datum);

#endif
