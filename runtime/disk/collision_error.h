/* SPDX-License-Identifier: MIT */
/* The parts of the error of eps, and their estimates; docs/theory-disks.md, 15. */
#ifndef COR_RUNTIME_DISK_COLLISION_ERROR_H
#define COR_RUNTIME_DISK_COLLISION_ERROR_H

#include "runtime/disk/collision_run.h"

struct cor_collision_error {
    double step;      /* of the extrapolation to h = 0 */
    double angles;    /* of the quadrature over the rim */
    double round_off; /* of all operations */
    double wall;      /* of the wall's force before the first and after the last moment */
};

/* Evidence of errors from the runs of a call */
struct cor_collision_evidence {
    int runs;                            /* with the same angles */
    double movement[COR_COLLISION_RUNS]; /* of the extrapolated result by each of them but the first */
    double amplification;                /* of errors: measured, or a bound on it */
    int measured;
    double by_angles; /* movement by shifted angles, if it is measured */
    int angles_measured;
};

/* Error due to the step, after the last run, whose round-off is known */
double cor_collision_step_error(const struct cor_motion *m, const struct cor_collision_evidence *evidence,
                                double round_off);
/* Error of the quadrature relative to the peak load; 1 where nothing is known of it */
double cor_collision_quadrature_error(const struct cor_motion *m, const struct cor_collision_run *run);
/* Sets all parts except the step for the last run, which leaves the fraction `left` of the energy in the modes. */
void cor_collision_other_errors(const struct cor_motion *m, const struct cor_collision_run *run, double left,
                                const struct cor_collision_evidence *evidence, struct cor_collision_error *error);
/* The parts that smaller steps do not reduce */
double cor_collision_lasting_error(const struct cor_collision_error *error);
/* The sum of all parts, at most 1 */
double cor_collision_total_error(const struct cor_collision_error *error);

#endif
