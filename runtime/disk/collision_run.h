/* SPDX-License-Identifier: MIT */
/* One collision with steps of one size, from before the contact until after it. */
#ifndef COR_RUNTIME_DISK_COLLISION_RUN_H
#define COR_RUNTIME_DISK_COLLISION_RUN_H

#include "runtime/disk/collision_workspace.h"

struct cor_collision_run {
    double h;
    int number;     /* 0 for the first one with the same angles */
    int all_angles; /* evaluate all angles at every step */
    size_t steps;
    double work; /* what it took of the call's budget */
    double eps, max_compression, contact_time;
    double max_load;
    double ripple;     /* largest of what half the angles change of the load */
    double stiffness;  /* largest h^2 alpha (acceleration of the rim) */
    double start, end; /* of the contact, NaN if that is not known */
};

enum cor_collision_outcome {
    COR_RUN_ENDED,
    COR_RUN_TOO_STIFF,  /* the step is too large */
    COR_RUN_TOO_NARROW, /* the window left out a pressure that counts */
    COR_RUN_TOO_LONG    /* COR_DISK_COLLISION_MAX_STEPS or the call's budget */
};

/* Runs with steps run->h. `before` is a run with larger steps, or NULL: its largest load says what a contact is, and
 * `average`, if not NULL, gets the mean energy of each mode over its contact. detail->observe, if there is one, is called
 * at every step. The modes are left as they are at the end. */
enum cor_collision_outcome cor_collision_run(struct cor_motion *m, struct cor_collision_run *run,
                                             const struct cor_collision_run *before, double *average,
                                             const struct cor_disk_collision_detail *detail);

#endif
