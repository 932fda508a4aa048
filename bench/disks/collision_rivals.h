/* SPDX-License-Identifier: MIT */
/* A disk at a wall, (40) to (45), by the methods that a user would take. No part of the library is in it. */
#ifndef COR_BENCH_DISKS_COLLISION_RIVALS_H
#define COR_BENCH_DISKS_COLLISION_RIVALS_H

#include <stddef.h>

#include <cor/disk.h>

/* A splitting: kick b[0], free motion a[0], kick b[1], ... kick b[stages]; b[0] may be 0. Times of the step. */
struct rival_splitting {
    const char *name;
    int order, stages;
    double a[16], b[17];
};

enum { RIVAL_STRANG, RIVAL_YOSHIDA4, RIVAL_SRKN6_4, RIVAL_SRKN11_6, RIVAL_SRKN14_6, RIVAL_SPLITTINGS };

extern const struct rival_splitting rival_splittings[RIVAL_SPLITTINGS];

/* How the paper's Runge-Kutta method evaluates its right side: the sums over modes grouped by n, or every mode at every
 * angle. exp(i omega t) comes by a recurrence. */
enum rival_rk4 { RIVAL_RK4, RIVAL_RK4_UNGROUPED };

struct rival_disk {
    size_t modes, ns, width, angles; /* ns: n = 0 ... ns - 1; width: ns, filled up to a multiple of 4 */
    double alpha, speed, weight;
    double wall_left;    /* energy of the wall at the first and the last moment, relative to the disk's */
    struct stage *stage; /* for rival_build_loops alone */
    size_t *first;       /* modes of n: first[n] to first[n + 1] - 1 */
    double *omega, *c, *s;
    /* cos(n phi_j) cos(phi_j) and sin(n phi_j) sin(phi_j), phi_j = (j + 1/2) pi/(2 angles): [n][j] and [j][n] */
    double *cos_by_n, *sin_by_n, *cos_by_angle, *sin_by_angle, *cos_phi;
};

/* angles: a multiple of 4. Exits where there is no memory. */
void rival_disk_init(struct rival_disk *disk, const struct cor_disk_modes *modes, size_t n_modes, double alpha,
                     double speed, size_t angles, double wall_left);
void rival_disk_free(struct rival_disk *disk);

/* Load of the wall at the first and the last moment, and x_0 of the first */
double rival_negligible_load(const struct rival_disk *disk);
double rival_first_position(const struct rival_disk *disk);

/* What the two functions leave where the solution explodes or the disk does not come back */
#define RIVAL_NO_RESULT (-1.0)

/* Speed after over speed before, steps of h; *steps gets their number. Built twice: with the flags of the library's own
 * loops, and for this machine with -ffast-math. */
struct rival_build {
    double (*splitting)(const struct rival_disk *disk, const struct rival_splitting *splitting, double h, long *steps);
    double (*rk4)(const struct rival_disk *disk, enum rival_rk4 form, double h, long *steps);
};
extern const struct rival_build rival_build_plain;
#ifdef COR_BENCH_HAS_NATIVE
extern const struct rival_build rival_build_native;
#endif
/* The splittings with the library's own inner loops, and like it without the angles far from the contact: what is left
 * of a difference is the method's. disk->stage must be set; no Runge-Kutta method. */
extern const struct rival_build rival_build_loops;

#endif
