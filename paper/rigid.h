/* SPDX-License-Identifier: MIT */
/* The limit that the paper extrapolates to, computed: a disk of all its modes at a rigid wall. */
#ifndef COR_PAPER_RIGID_H
#define COR_PAPER_RIGID_H

#include "cor/disk.h"
#include "report.h"

/* Of 1 - eps^2: where a limit is given as a number, and where as a line in a picture */
#define RIGID_TOLERANCE 2e-5
#define RIGID_LINE_TOLERANCE 1e-4

/* A collision at nu = 0.33 or 0.9, computed at the first call with these arguments; all NaN after saying on stderr what
 * is wrong. */
struct cor_disk_hard_wall rigid_wall(double nu, double speed, double tolerance);

void rigid_wall_clear(void);

extern const struct figure rigid_wall_figure, approach_figure;

#endif
