/* SPDX-License-Identifier: MIT */
/* Ways to sum a cosine series over the angles phi_j = (j + 1/2) pi/(2 points) other than by a table: a recurrence, and
 * a fast Fourier transform. Built for this machine, with fused operations and -ffast-math, which the library's loops
 * are not. */
#ifndef COR_BENCH_DISKS_PHI_SUMS_H
#define COR_BENCH_DISKS_PHI_SUMS_H

#include <stddef.h>

/* terms: a multiple of 8, at most `points`; points: a power of two, 32 at least. */
struct phi_sums {
    size_t terms, points;
    double *two_cos;  /* 2 cos(phi_j) */
    double *first;    /* [j][16]: cos(k phi_j), k = -8 ... 7 */
    double *two_cos8; /* 2 cos(8 phi_j) */
    double *twiddle;  /* of the transform of `points` complex numbers, stage by stage, cosines and sines */
    double *quarter;  /* cos and sin of pi k/(4 points), k < points + 1 */
    double *half;     /* cos and sin of pi k/points */
    double *work;     /* 6 points */
};

void phi_sums_init(struct phi_sums *sums, size_t terms, size_t points);
void phi_sums_free(struct phi_sums *sums);

/* reach[j] = sum_k d_k cos(k phi_j) for the first `window` angles, a multiple of 32; all angles by FFT. */
void phi_sums_reach_recurrence(const struct phi_sums *sums, size_t window, const double *d, double *reach);
void phi_sums_reach_fft(const struct phi_sums *sums, const double *d, double *reach);

/* e_k = sum_j pressure_j cos(k phi_j), k < terms */
void phi_sums_transform_recurrence(const struct phi_sums *sums, size_t window, const double *pressure, double *e);
void phi_sums_transform_fft(const struct phi_sums *sums, const double *pressure, double *e);

#endif
