/* SPDX-License-Identifier: MIT */
/* The workspace of a collision, and its constant tables. */
#ifndef COR_RUNTIME_DISK_COLLISION_WORKSPACE_H
#define COR_RUNTIME_DISK_COLLISION_WORKSPACE_H

#include "cor/disk.h"
#include "runtime/disk/collision_loops.h"
#include "runtime/disk/collision_tuning.h"

#define COR_PI 3.14159265358979323846
#define COR_DISK_MASS COR_PI

struct cor_motion_sizes {
    size_t modes, n_max, blocks, cells; /* cells: places for modes */
    size_t terms, points;               /* points: largest number of places for angles */
    double omega_max;
};

/* A disk, its wall, and the arrays of one call */
struct cor_motion {
    struct cor_motion_sizes size;
    struct cor_rim rim;
    const struct cor_collision_loops *loops;
    const struct cor_disk_mode *mode;
    double alpha, tolerance, speed;
    double work_left, work_per_step; /* the budget; work_per_step 0: count the work of each step */
    size_t phi, phi_limit;           /* angles in use, and their largest number */
    size_t *place;                   /* cell of each mode */
    struct cor_mode_block *block;
    double *c, *s, *q, *p, *cosine, *sine;
    double *force_c, *force_s, *sum_c, *sum_s; /* of each n */
    double *cc, *cs, *ss;                      /* of each n: sums of C^2, C S and S^2 over the mass */
    double *d, *e, *shape, *flat, *weight, *reach, *pressure, *response, *by_point, *by_term, *table;
    double *after[COR_COLLISION_LEVELS], *average[COR_COLLISION_LEVELS]; /* of each mode, of each run */
};

/* Largest number of angles that a call with these options may use */
size_t cor_motion_phi_limit(const struct cor_disk_collision_options *options, size_t n_max);
/* Number of angles that the tolerance is expected to need */
size_t cor_motion_first_phi(const struct cor_motion *m, const struct cor_disk_collision_options *options);

struct cor_motion_sizes cor_motion_sizes(const struct cor_disk_mode *mode, size_t modes,
                                         const struct cor_disk_collision_options *options);
/* Sets the pointers of *m, whose size is set, to places in memory from an aligned base on. Returns the number of bytes
 * used. If base is NULL, the function only counts them. */
size_t cor_motion_arrange(struct cor_motion *m, char *base);
/* Fills the arrays of modes from m->mode. */
void cor_motion_set_modes(struct cor_motion *m);
/* Sets the angles phi_j = (j + shift/2) pi/(2 phi), j < phi, and the tables of cos(k phi_j). shift 0: the trapezoidal
 * rule, whose last angle, pi/2, adds nothing, because the wall does not reach it. shift 1: the midpoint rule, whose
 * error is to first order that of the trapezoidal rule with the other sign. */
void cor_motion_set_angles(struct cor_motion *m, size_t phi, size_t shift);
/* Multiplications of a step that computes the reach at `reached` angles and a pressure at `pressed` of them. Fitted to
 * times. */
double cor_motion_work(const struct cor_motion *m, size_t reached, size_t pressed);

#endif
