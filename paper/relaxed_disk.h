/* SPDX-License-Identifier: MIT */
/* A disk held at rest against the wall, the dashed-dotted line of Fig. 10. Its shape minimises the energy (41) with
 * all momenta zero and the centre of mass at x_0. (In the printed (41), omega^2 Q^2 lacks a factor 1/2.) Then each mode
 * balances the pressure f(phi) = exp(alpha x(phi)) of the wall: Q = -(1/(pi omega^2)) int w f dphi, w = C cos(n phi)
 * cos(phi) - S sin(n phi) sin(phi). This turns (40) into one equation on the rim,
 *
 *     ln(f)/alpha = x_0 + cos(phi) - int G(phi, psi) f(psi) dpsi,     -pi/2 <= phi <= pi/2,
 *     pi G = sum_n A_n cos(n phi) cos(phi) cos(n psi) cos(psi) + D_n sin(n phi) sin(phi) sin(n psi) sin(psi)
 *                - B_n (cos(n phi) cos(phi) sin(n psi) sin(psi) + sin(n phi) sin(phi) cos(n psi) cos(psi)),
 *
 * where A_n, B_n, D_n are the sums over l of C^2, C S, S^2 divided by omega^2. The load is P = int f dphi, and x_0 = -1
 * + compression. Units as in cor/disk.h. */
#ifndef COR_PAPER_RELAXED_DISK_H
#define COR_PAPER_RELAXED_DISK_H

#include <stddef.h>

#include "cor/disk.h"

struct relaxed_disk {
    size_t points;
    double alpha, x_0, step; /* step: points are (i + 1/2) step */
    double load, energy;     /* P; energy (41) without momenta: elastic energy + (1/alpha) int f dphi */
    double largest_residual; /* largest residual of the equation above, in units of R */
    double *log_f, *f;       /* the pressure at the points */
    double *kernel, *matrix; /* G, and a matrix for the Newton step: points x points */
    double *residual, *scale, *u, *newton, *saved;
    double memory[];
};

/* Return a disk that has not touched the wall yet; NULL if memory is short (16 points^2 bytes). Free it with free().
 * The points are equally spaced on the quadrant 0 < phi < pi/2. The error of the sum over them falls faster than any
 * power once the edge of the contact, about alpha^(-2/3) wide, spans a few points. At delta <= 0.3 it
 * is below 1e-12 of the load for alpha = 500 and 192 points, and below 1e-7 for alpha = 20000 and 512 points. These
 * bounds come from runs with twice the number of points.
 *
 * relaxed_disk_of_modes: the disk has the lowest n_modes of a table. relaxed_disk_of_all_modes: it has all modes n <
 * 2*points, from the static compliance of a disk under tractions cos(n phi), sin(n phi) with its centre of mass held:
 *     A_n = D_n = (2n - 1 + nu)/(n^2 - 1),  B_n = (n (1 - nu) - 2)/(n^2 - 1)                       n >= 2
 *     A_1 = B_1 = (1 - nu)/2,  D_1 = (3 + nu)/2,     A_0 = (1 - nu)/2,  B_0 = D_0 = 0 */
struct relaxed_disk *relaxed_disk_of_modes(const struct cor_disk_modes *modes, size_t n_modes, double alpha,
                                           size_t points);
struct relaxed_disk *relaxed_disk_of_all_modes(double nu, double alpha, size_t points);

/* Moves the disk to a compression from any position: damped Newton steps in ln f, in stages. Returns the load, or NaN
 * if no equilibrium is found; a disk of few modes cannot bend far. */
double relaxed_disk_press(struct relaxed_disk *disk, double compression);

#endif
