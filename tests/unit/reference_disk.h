/* SPDX-License-Identifier: MIT */
/* The excitation of a disk's modes by its quasistatic contact force, (65) to (67) of Gerl and Zippelius, integrated in
 * time: what tests and benchmarks hold cor_disk_rayleigh against. */
#ifndef COR_TESTS_REFERENCE_DISK_H
#define COR_TESTS_REFERENCE_DISK_H

#include <stddef.h>

#include "cor/disk.h"

/* (2 I)^2 C^2 of mode[0..n-1] for the contact law's constant b and the impact speed v, by Dormand and Prince's pair of
 * orders 5 and 4 with error `tolerance` a step, relative to v in all velocities. The signs are those that conserve
 * energy: delta' = v, v' = -P/m, q' = -(i C/(m omega)) exp(i omega t) P, fraction = (omega |q|/v)^2.
 * Returns the number of steps, 0 without memory or where the step vanishes; *contact_time, if not NULL, is the time
 * when delta is 0 again. */
size_t reference_disk_rayleigh(const struct cor_disk_mode *mode, size_t n, double b, double speed, double tolerance,
                               double *fraction, double *contact_time);

#endif
