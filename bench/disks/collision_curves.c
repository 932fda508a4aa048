/* SPDX-License-Identifier: MIT */
/* A collision of 940 modes, error against time, from the tolerance 1e-2 to 1e-12. The truth comes by Taylor series of
 * the motion in time, tests/unit/reference_collision.c. */
#include <math.h>

#include <cor/status.h>

#include "collision.h"
#include "reference_collision.h"
#include "stages.h"

struct run {
    double tolerance, eps;
};

static void one_collision(void *closure)
{
    struct run *const run = closure;
    struct cor_disk_collision out;
    disk_must(collision_with_cor(&cor_disk_modes_nu033, COLLISION_MODES, COLLISION_ALPHA, COLLISION_SPEED,
                                 run->tolerance, &out) == COR_OK,
              "cor misses a tolerance");
    run->eps = out.eps;
}

void collision_curves(struct disk_bench *bench)
{
    enum { RUNS = 11 };
    struct run run[RUNS];
    struct job job[RUNS];
    struct reference_collision truth;
    disk_must(reference_disk_collision(cor_disk_modes_nu033.mode, COLLISION_MODES, COLLISION_ALPHA, COLLISION_SPEED,
                                       1e-13, &truth, NULL, NULL) == 0,
              "no reference of a collision");
    for (int i = 0; i < RUNS; i++) {
        run[i] = (struct run){.tolerance = pow(10, -2 - i)};
        job[i] = (struct job){one_collision, &run[i], 1, NAN};
    }
    timing_measure(job, RUNS, collision_timing(bench));
    for (int i = 0; i < RUNS; i++)
        disk_csv(bench, &(struct disk_row){"collision", "cor", COLLISION_SPEED, run[i].tolerance, COLLISION_MODES,
                                           job[i].best_ns / 1e9, fmax(fabs(run[i].eps - truth.eps), truth.error)});
}
