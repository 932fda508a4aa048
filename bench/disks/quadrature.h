/* SPDX-License-Identifier: MIT */
/* The cosine integral of cor/disk.h along the real axis, mode after mode,
 *
 *     I(omega) = int_0^(pi/2) sin(theta) cos(omega s(theta)) dtheta,     s(theta) = int_theta^(pi/2) sqrt(y/2) dtheta',
 *     y = 1 + t,     t - ln(1 + t) = 2 ln(v_limit/(v sin(theta))),
 *
 * by Gauss and Legendre's rule in long double, in panels that shrink towards both ends, where the integrand has
 * singularities: the truth, by another route than the library's, which leaves the real axis. */
#ifndef COR_BENCH_DISKS_QUADRATURE_H
#define COR_BENCH_DISKS_QUADRATURE_H

#include <stddef.h>

#include <cor/disk.h>

enum { DISK_GRID_POINTS = 32, DISK_GRID_NODES = 16384 };

struct disk_grid {
    int points;   /* of a panel, 2 to DISK_GRID_POINTS */
    int halvings; /* of the panels towards each end */
    double phase; /* a panel spans at most so much of omega s, at the highest frequency */
};

/* For references: rounding in long double is what is left. */
#define DISK_GRID_REFERENCE ((struct disk_grid){28, 40, 30})

/* C^2 (2 I)^2 of mode[0..n-1] for the contact law's constant b. Returns the number of nodes; 0: more than
 * DISK_GRID_NODES, or a panel's points out of range. */
size_t disk_quadrature(struct disk_grid grid, const struct cor_disk_mode *mode, size_t n, long double b, double speed,
                       long double *fraction);

#endif
