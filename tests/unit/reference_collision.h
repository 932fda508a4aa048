/* SPDX-License-Identifier: MIT */
/* Computes the collision of a disk with the wall exp(alpha x)/alpha, (40), (44), (45) of Gerl and Zippelius, by Taylor
 * series in time. This reference for cor_disk_collision shares neither code nor method with that function. */
#ifndef COR_TESTS_REFERENCE_COLLISION_H
#define COR_TESTS_REFERENCE_COLLISION_H

#include <stddef.h>

#include "cor/disk.h"

struct reference_collision {
    double eps, one_minus_eps2, contact_time, max_compression; /* members as in struct cor_disk_collision */
    double energy_drift;
    double error; /* four times the difference in eps of the last two runs, mainly the error of the earlier run */
};

/* Solves the equations of motion, with the signs that conserve energy, in the variables x_0 and Q,
 *     x_0'' = -load/m,     Q'' = -omega^2 Q - (1/m) int (C cos(n phi) cos(phi) - S sin(n phi) sin(phi)) exp(alpha x)
 *     dphi,
 * by Taylor series of order 20 to 34 in time. The integrals use Gauss's rule of 16 points on equal panels of the
 * quadrant. From run to run, steps, order and panels reduce the error 100 times. The first runs are in long double,
 * the later ones in quad precision. The runs end when two of them agree to `needed` in eps.
 * energy_after and energy_average are NULL or receive n numbers. Returns 0, or 1 if even the last runs do not agree
 * (*out has their numbers), or 2 after 10^6 steps. */
int reference_disk_collision(const struct cor_disk_mode *mode, size_t n, double alpha, double speed, double needed,
                             struct reference_collision *out, double *energy_after, double *energy_average);

#endif
