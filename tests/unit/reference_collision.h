/* SPDX-License-Identifier: MIT */
/* The collision of a disk with the wall exp(alpha x)/alpha, (40), (44), (45) of Gerl and Zippelius, by extrapolation:
 * what tests hold cor_disk_collision against, and no code of it. */
#ifndef COR_TESTS_REFERENCE_COLLISION_H
#define COR_TESTS_REFERENCE_COLLISION_H

#include <stddef.h>

#include "cor/disk.h"

struct reference_collision {
    double eps, one_minus_eps2, contact_time, max_compression; /* as in struct cor_disk_collision */
    double energy_drift;
    double max_load;
    size_t steps, evaluations;
};

/* The equations of motion with the signs that conserve energy, in the variables x_0 and Q themselves,
 *     x_0'' = -load/m,     Q'' = -omega^2 Q - (1/m) int (C cos(n phi) cos(phi) - S sin(n phi) sin(phi)) exp(alpha x) dphi,
 * by Stoermer's method with 1, 2, ... 8 sub-steps extrapolated to none (order 16), its step chosen for an error of
 * `tolerance` a step in every velocity, relative to v; the integrals by Gauss's rule of 16 points on `panels` equal
 * panels of the part of 0 <= phi <= pi/2 that can be pressed, and on one panel of the rest. Moments between steps (largest load, ends of contact, largest compression) are reached by
 * a shorter step from the one before, so are as good as the rest. The motion ends where no sum of the amplitudes, all
 * of one sign, reaches the wall again.
 * energy_after and energy_average are NULL or get n numbers. Returns 0, or 1 without memory or where the step vanishes
 * or after 10^6 of them. */
int reference_disk_collision(const struct cor_disk_mode *mode, size_t n, double alpha, double speed, double tolerance,
                             size_t panels, struct reference_collision *out, double *energy_after,
                             double *energy_average);

#endif
