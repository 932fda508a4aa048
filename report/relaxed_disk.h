/* SPDX-License-Identifier: MIT */
/* A disk held at rest against the wall, the dashed-dotted line of Fig. 10: the shape that minimises the energy (41) with all
 * momenta zero, for a given distance between centre of mass and wall. In the variables of (40) and (42) the minimum is where
 * each mode balances the pressure f(phi) = exp(alpha x(phi)) of the wall, Q = -(1/(pi omega^2)) int w f dphi with
 * w = C cos(n phi) cos(phi) - S sin(n phi) sin(phi), which leaves one equation on the rim,
 *
 *     ln(f)/alpha = x_0 + cos(phi) - int G(phi, psi) f(psi) dpsi,     -pi/2 <= phi <= pi/2,
 *     pi G = sum_n  A_n cos(n phi) cos(phi) cos(n psi) cos(psi) + D_n sin(n phi) sin(phi) sin(n psi) sin(psi)
 *                 - B_n (cos(n phi) cos(phi) sin(n psi) sin(psi) + sin(n phi) sin(phi) cos(n psi) cos(psi)),
 *
 * A_n, B_n, D_n being the sums of C^2, C S, S^2 over omega^2, all l. The load is P = int f dphi, x_0 = -1 + compression.
 * Units as in cor/disk.h. */
#ifndef COR_REPORT_RELAXED_DISK_H
#define COR_REPORT_RELAXED_DISK_H

#include <stddef.h>

#include "cor/disk.h"

struct relaxed_disk;

/* A disk that has not touched the wall, or NULL: nu outside (-1, 1), alpha not positive and finite, no such number of modes,
 * fewer than 8 points, a table with another n than can be, or no memory. points: on the quadrant 0 < phi < pi/2, equally
 * spaced. The sum over them is exact for the trigonometric part of f that they resolve, so the error falls faster than
 * any power once the edge of the contact, about alpha^(-2/3) wide, is a few points wide; compare with twice as many.
 *
 * The first has the lowest n_modes of a table; the second all modes there are, n below 2 points, by
 *     A_n = D_n = (2n - 1 + nu)/(n^2 - 1),  B_n = (n (1 - nu) - 2)/(n^2 - 1)                       n >= 2
 *     A_1 = B_1 = (1 - nu)/2,  D_1 = (3 + nu)/2,     A_0 = (1 - nu)/2,  B_0 = D_0 = 0
 * the static compliance of a disk under cos(n phi) and sin(n phi) tractions, its centre of mass held. */
struct relaxed_disk *relaxed_disk_of_modes(const struct cor_disk_modes *modes, size_t n_modes, double alpha,
                                           size_t points);
struct relaxed_disk *relaxed_disk_of_all_modes(double nu, double alpha, size_t points);
void relaxed_disk_free(struct relaxed_disk *disk);

struct relaxed_state {
    double load;            /* P */
    double energy;          /* (41) with P = 0: elastic energy and (1/alpha) int f dphi */
    double residual;        /* largest error of the equation above over all points, in units of R */
    const double *pressure; /* f at the points, until the next call */
    size_t points;
};

/* Moves the disk to a compression, from wherever it is: damped Newton steps in ln f, in as many stages as they need.
 * 1, or 0 where no equilibrium is found (then *out is what it was): a compression that is NaN, or beyond 1. */
int relaxed_disk_press(struct relaxed_disk *disk, double compression, struct relaxed_state *out);

/* G between two of the points. */
double relaxed_disk_kernel(const struct relaxed_disk *disk, size_t i, size_t j);

#endif
