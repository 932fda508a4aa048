/* SPDX-License-Identifier: MIT */
/* The sums over modes of Rayleigh's energy, and its tail: the sum over all other modes, and its error estimate. */
#ifndef COR_RUNTIME_DISK_RAYLEIGH_TAIL_H
#define COR_RUNTIME_DISK_RAYLEIGH_TAIL_H

#include "cor/disk.h"
#include "runtime/disk/rayleigh_spectrum.h"

/* A lower bound on the frequencies of any disk; the lowest is 1.1769, for nu -> 1 */
#define COR_RAYLEIGH_LEAST_OMEGA 1.17
/* Surface modes up to this times the highest frequency of the table are summed one by one. */
#define COR_RAYLEIGH_FAR 8.0

/* Modes that the loops process together, with their weights in the sums */
struct cor_mode_chunk {
    int count;
    double omega[COR_LINES];
    struct cor_mode_weights weights;
};

/* The modes l = 0 beyond the table, which are continued in chunks */
struct cor_surface_modes {
    int known; /* the largest n of the table; 0 if the modes cannot be continued */
    double highest;
    struct cor_surface_fit fit;
    int n;              /* up to which they have been continued */
    double omega, echo; /* of that mode: its frequency and its weight */
};

/* Data for the tail of a table at every speed; the highest mode is number n_modes. */
struct cor_rayleigh_table {
    const struct cor_rayleigh_set *set;
    const struct cor_disk_modes *modes;
    size_t n_modes;
    struct cor_fading fading;
    struct cor_surface_modes surface;
    double low_strength, high_strength; /* sums of C^2 times the windows, complete after every mode has been weighted
                                         * once */
};

void cor_rayleigh_table_init(struct cor_rayleigh_table *table, const struct cor_rayleigh_set *set,
                             const struct cor_disk_modes *modes, size_t n_modes);

/* Computes the weights of a chunk of modes, from number i to at most number `to`, and adds to the table's sums of
 * C^2. */
void cor_rayleigh_weigh_modes(struct cor_rayleigh_table *table, size_t i, size_t to, struct cor_mode_chunk *chunk);

/* Adds a chunk to the sums at a speed; mode_fraction is NULL or gets the fractions of the chunk's modes. */
void cor_rayleigh_add(const struct cor_spectrum *spectrum, const struct cor_mode_chunk *chunk,
                      struct cor_mode_sums *sums, double *mode_fraction);

/* Computes the chunk after the modes up to surface->n. Returns 0 if no further chunk exists. */
int cor_surface_modes_next(struct cor_surface_modes *surface, const struct cor_rayleigh_set *set,
                           struct cor_mode_chunk *chunk);

/* Sets the tail beyond out->fraction, and the error estimate. `sums` are those of all modes of the table. surface_sum
 * is the sum `faded` of the chunks of all surface modes. */
void cor_rayleigh_finish(struct cor_disk_rayleigh *out, const struct cor_rayleigh_table *table,
                         const struct cor_spectrum *spectrum, const struct cor_mode_sums *sums, double surface_sum);

#endif
