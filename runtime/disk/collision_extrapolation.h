/* SPDX-License-Identifier: MIT */
/* Results of runs with steps h, h/sqrt(2), h/2, ..., extrapolated to h = 0. */
#ifndef COR_RUNTIME_DISK_COLLISION_EXTRAPOLATION_H
#define COR_RUNTIME_DISK_COLLISION_EXTRAPOLATION_H

#include "runtime/disk/collision_run.h"

/* Ratio of the step of a run to that of the next one */
#define COR_COLLISION_RATIO 1.4142135623730951

/* Sets all fields of *out except error_estimate, and energy_after unless it is NULL, from runs whose mode energies are
 * in m->after. Returns the sum of negative extrapolated mode energies, which are set to 0. */
double cor_collision_results(const struct cor_motion *m, const struct cor_collision_run *run, int levels,
                             struct cor_disk_collision *out, double *energy_after);
/* Sets the mean energies from m->average, or NaN if no run has them. */
void cor_collision_averages(const struct cor_motion *m, const struct cor_collision_run *run, int levels,
                            double *energy_average);
/* The movement of the extrapolated result by the last run, and the difference between the last two runs. Each is the
 * larger of the change of eps and half the norm of the changes of the modes' energies, as a fraction of (pi/2) v^2. */
double cor_collision_movement(const struct cor_motion *m, const struct cor_collision_run *run, int levels);
double cor_collision_difference(const struct cor_motion *m, const struct cor_collision_run *run, int levels);

#endif
