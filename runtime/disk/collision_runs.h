/* SPDX-License-Identifier: MIT */
/* The runs of a call. The estimated error determines the steps, the angles and the number of runs. */
#ifndef COR_RUNTIME_DISK_COLLISION_RUNS_H
#define COR_RUNTIME_DISK_COLLISION_RUNS_H

#include "runtime/disk/collision_workspace.h"

/* COR_OK, COR_TOLERANCE_NOT_REACHED or COR_CONTACT_NOT_ENDED, as cor/disk.h says. m has its modes and first angles. */
int cor_collision_runs(struct cor_motion *m, struct cor_disk_collision *out,
                       const struct cor_disk_collision_detail *detail);

#endif
