/* SPDX-License-Identifier: MIT */
/* The collisions of the full dynamics that several figures share, docs/paper/collisions.csv, and single ones that are
 * watched. Units as in cor/disk.h. */
#ifndef COR_PAPER_COLLISIONS_H
#define COR_PAPER_COLLISIONS_H

#include <stddef.h>

#include "cor/disk.h"
#include "report.h"

/* Absolute error allowed in eps, of the table and of collisions that are watched */
#define COLLISION_TOLERANCE 1e-8
#define WATCHED_TOLERANCE 1e-9

struct collision {
    double nu;
    int modes; /* the lowest so many */
    double alpha, speed;
    int converged; /* 0: the steps do not agree to the tolerance, a chaotic collision */
    double one_minus_eps2, contact_time, max_compression;
};

/* Impact speeds of the paper, 0.005, 0.01, and 0.02 to 0.30 in steps of 0.02; those of the oscillation at small speed
 */
enum { PAPER_SPEEDS = 17, SLOW_SPEEDS = 28 };
double paper_speed(int i);
double slow_speed(int i);

/* Hardness of the wall in units of 1/speed: alpha v is the rate at which the wall's force grows on impact, beside which
 * omega of the modes stands. Those of every limit, and those of wall_limit beside them */
enum { WALLS = 3, OTHER_WALLS = 3 };
extern const double wall[WALLS], other_wall[OTHER_WALLS];

/* Numbers of modes of the limits; those of the slow speeds begin with the fourth. */
enum { SIZES = 6, LARGE_FROM = 3, WALL_SIZE = 3 };
extern const int size[SIZES];

/* All are computed, on every core, with progress on a terminal; or read from a file that collisions_figure wrote, and
 * `sample` of them drawn by the seed, all if negative, are computed again. 1, or 0 after saying on stderr what is
 * wrong. */
int collisions_compute(void);
int collisions_read(const char *path, int sample, unsigned long long seed);

/* alpha = rate/speed. NULL: not among them */
const struct collision *collision_find(double nu, int modes, double rate, double speed);

/* Told of each step; q and q_dot have the amplitudes Q and dQ/dt then. */
typedef void collision_visit(void *context, const struct cor_disk_moment *moment, const double *q, const double *q_dot);

/* One collision at nu = 0.33 with the lowest n_modes modes; visit and the arrays of n_modes elements may be NULL. 1, or
 * 0 after saying on stderr what is wrong. */
int collision_watch(size_t n_modes, double alpha, double speed, collision_visit *visit, void *context,
                    struct cor_disk_collision *out, double *energy_average, double *energy_after);

extern const struct figure collisions_figure;

#endif
