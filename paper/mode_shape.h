/* SPDX-License-Identifier: MIT */
/* Displacements inside the disk of a free mode, (19): u_r(r) cos(n phi), u_phi(r) sin(n phi). */
#ifndef COR_PAPER_MODE_SHAPE_H
#define COR_PAPER_MODE_SHAPE_H

#include "cor/disk.h"

/* u_r and u_phi of (27), with kappa and kappa' where (19) has them */
struct mode_shape {
    int n, l;
    double omega, kappa, kappa_prime, a, b;
};

/* A : B from the boundary conditions (22), (23); the size is such that the rim has C or S of the table, whichever is
 * larger. */
struct mode_shape mode_shape_of(const struct cor_disk_mode *mode, double nu);

/* 0 < r <= 1 */
void mode_displacement(const struct mode_shape *shape, double r, double *u_r, double *u_phi);

#endif
