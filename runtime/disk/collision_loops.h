/* SPDX-License-Identifier: MIT */
/* Full dynamics of a disk at a wall: what the integrator and its loops share.
 *
 * Modes are held as the canonical pairs q = sqrt(m omega) Q and p = sqrt(m omega) dQ/dt / omega, which free motion turns
 * by the angle omega t; c = C/sqrt(m omega) and s = S/sqrt(m omega) then stand in both directions, from modes to the rim
 * and from the wall's force to modes. Modes of one n stand in one lane of a block of LANES different n, one mode a row:
 * sums over the modes of each n need no sum across lanes. Empty places have c = s = 0.
 *
 * On the rim, cos(n phi) cos(phi) and sin(n phi) sin(phi) are halves of sums of cos((n +- 1) phi): one cosine series. */
#ifndef COR_RUNTIME_DISK_COLLISION_LOOPS_H
#define COR_RUNTIME_DISK_COLLISION_LOOPS_H

#include <stddef.h>

#include "runtime/core/instruction_set.h"

/* Whatever the width of a vector is, so that every set gives the same bits. */
enum { COR_LANES = 8 };

/* Rows of one block of modes */
struct cor_mode_block {
    size_t first, rows; /* in LANES doubles */
};

/* Points and terms are tabled in panels of so many, which is also how many the loops do at once. */
enum { COR_PANEL = 4 * COR_LANES };

struct cor_rim {
    size_t blocks; /* of modes */
    const struct cor_mode_block *block;
    const double *c, *s;    /* as the modes */
    size_t used_terms;      /* the last k with a cosine, and 1 more */
    size_t terms, points;   /* cos(k phi_j), k < terms, j < points: multiples of COR_PANEL */
    const double *by_point; /* [(j / COR_PANEL) terms + k][j % COR_PANEL] = cos(k phi_j) */
    const double *by_term;  /* [(k / COR_PANEL) points + j][k % COR_PANEL], the same */
};

/* Arrays of each n have blocks COR_LANES elements, of terms two more than that at least, of angles `points`. */
struct cor_collision_loops {
    /* Kicks the modes by the forces on c and s of each n, turns them by the angles whose cosine and sine are given, and
     * sums what c q and s q are afterwards. */
    void (*turn)(const struct cor_rim *rim, double *q, double *p, const double *cosine, const double *sine,
                 const double *force_c, const double *force_s, double *sum_c, double *sum_s);
    /* sum_n sum_c cos(n phi) cos(phi) - sum_s sin(n phi) sin(phi) = sum_k d_k cos(k phi) */
    void (*gather)(const struct cor_rim *rim, const double *sum_c, const double *sum_s, double *d);
    /* The other way: force_c and force_s of each n, from e_k, times a factor */
    void (*split)(const struct cor_rim *rim, double factor, const double *e, double *force_c, double *force_s);
    /* reach[j] = offset + shape[j] + sum_k d_k cos(k phi_j), j < points */
    void (*reach)(const struct cor_rim *rim, size_t points, double offset, const double *shape, const double *d,
                  double *reach);
    /* pressure[j] = weight[j] exp(alpha reach[j]), 0 where alpha reach is below -700; their sum */
    double (*press)(size_t points, double alpha, const double *weight, const double *reach, double *pressure);
    /* e_k = sum_j pressure[j] cos(k phi_j) */
    void (*transform)(const struct cor_rim *rim, size_t points, const double *pressure, double *e);
    /* pressure[j] -= factor response[j] pressure[j]; their sum, and the greatest response */
    double (*soften)(size_t points, double factor, const double *response, double *pressure, double *greatest);
};

extern const struct cor_collision_loops cor_collision_portable;
#ifdef COR_X86_SETS
extern const struct cor_collision_loops cor_collision_avx2, cor_collision_avx512;
#endif

#endif
