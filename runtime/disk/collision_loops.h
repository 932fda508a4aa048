/* SPDX-License-Identifier: MIT */
/* Full dynamics of a disk at a wall: definitions that the integrator and its loops share.
 *
 * A mode is stored as the canonical pair q = sqrt(m omega) Q and p = sqrt(m omega) dQ/dt / omega. Free motion turns the
 * pair by the angle omega t. The same coefficients c = C/sqrt(m omega) and s = S/sqrt(m omega) lead from modes to the
 * rim and from the wall's force to modes. A block has LANES lanes, one for each n, and one row for each mode of that n,
 * so that sums over the modes of each n need no sum across lanes. Empty places have c = s = 0.
 *
 * On the rim, cos(n phi) cos(phi) and sin(n phi) sin(phi) are halves of sums of cos((n +- 1) phi), so that one cosine
 * series represents them all. */
#ifndef COR_RUNTIME_DISK_COLLISION_LOOPS_H
#define COR_RUNTIME_DISK_COLLISION_LOOPS_H

#include <stddef.h>

#include "runtime/number/sets.h"

/* Rows of one block of modes */
struct cor_mode_block {
    size_t first, rows; /* in LANES doubles */
};

/* Tables and loops process points and terms in panels of this size. */
enum { COR_PANEL = 4 * COR_LANES };

struct cor_rim {
    size_t blocks; /* of modes */
    const struct cor_mode_block *block;
    const double *c, *s;    /* as the modes */
    size_t used_terms;      /* the largest k with a cosine, plus 1 */
    size_t terms, points;   /* cos(k phi_j), k < terms, j < points: multiples of COR_PANEL */
    const double *by_point; /* [(j / COR_PANEL) terms + k][j % COR_PANEL] = cos(k phi_j) */
    const double *by_term;  /* [(k / COR_PANEL) points + j][k % COR_PANEL], the same */
};

/* Arrays over n have blocks times COR_LANES elements, arrays over terms at least two more, arrays over angles
 * `points`. */
struct cor_collision_loops {
    /* Kicks the modes by the forces on c and s of each n, turns them by the angles whose cosine and sine are given, and
     * then sums c q and s q. */
    void (*turn)(const struct cor_rim *rim, double *q, double *p, const double *cosine, const double *sine,
                 const double *force_c, const double *force_s, double *sum_c, double *sum_s);
    /* sum_n sum_c cos(n phi) cos(phi) - sum_s sin(n phi) sin(phi) = sum_k d_k cos(k phi) */
    void (*gather)(const struct cor_rim *rim, const double *sum_c, const double *sum_s, double *d);
    /* The transpose of gather: force_c and force_s of each n from e_k, times a factor */
    void (*split)(const struct cor_rim *rim, double factor, const double *e, double *force_c, double *force_s);
    /* reach[j] = offset + shape[j] + sum_k d_k cos(k phi_j), j < points */
    void (*reach)(const struct cor_rim *rim, size_t points, double offset, const double *shape, const double *d,
                  double *reach);
    /* pressure[j] = weight[j] exp(alpha reach[j]), 0 where alpha reach is below -700; returns their sum */
    double (*press)(size_t points, double alpha, const double *weight, const double *reach, double *pressure);
    /* e_k = sum_j pressure[j] cos(k phi_j) */
    void (*transform)(const struct cor_rim *rim, size_t points, const double *pressure, double *e);
    /* pressure[j] -= factor response[j] pressure[j]; returns their sum, and sets the greatest response */
    double (*soften)(size_t points, double factor, const double *response, double *pressure, double *greatest);
};

COR_TABLES(struct cor_collision_loops, cor_collision, cor_collision_set)

#endif
