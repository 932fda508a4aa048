/* SPDX-License-Identifier: MIT */
/* One collision with steps of one size, from before the contact until after it. */
#ifndef COR_RUNTIME_DISK_COLLISION_RUN_H
#define COR_RUNTIME_DISK_COLLISION_RUN_H

#include "runtime/disk/collision_workspace.h"

struct cor_collision_run {
    double h;
    int number;     /* 0 for the first run with the same angles */
    int all_angles; /* evaluate all angles at every step */
    size_t steps;
    double work; /* its share of the call's budget */
    double eps, max_compression, contact_time;
    double max_load;
    double ripple;     /* largest change of the load with half the angles */
    double stiffness;  /* largest h^2 alpha (acceleration of the rim) */
    double start, end; /* of the contact; NaN if unknown */
};

enum cor_collision_outcome {
    COR_RUN_ENDED,
    COR_RUN_TOO_STIFF,  /* the step is too large */
    COR_RUN_TOO_NARROW, /* the window omitted a significant pressure */
    COR_RUN_TOO_LONG    /* more than COR_DISK_COLLISION_MAX_STEPS or the call's budget */
};

/* Computes a collision with steps run->h. `before` is a run with larger steps, or NULL. Its largest load defines the
 * contact, over which `average`, if not NULL, receives the mean energy of each mode. The function calls
 * detail->observe, if not NULL, at every step. On return the modes are in their final state. */
enum cor_collision_outcome cor_collision_run(struct cor_motion *m, struct cor_collision_run *run,
                                             const struct cor_collision_run *before, double *average,
                                             const struct cor_disk_collision_detail *detail);

/* The runs of a call (collision_runs.c). The estimated error determines the steps, the angles and the number of runs.
 * COR_OK, COR_TOLERANCE_NOT_REACHED or COR_CONTACT_NOT_ENDED, as cor/disk.h says. m has its modes and first angles,
 * *out nothing known. */
int cor_collision_runs(struct cor_motion *m, struct cor_disk_collision *out,
                       const struct cor_disk_collision_detail *detail);

#endif
