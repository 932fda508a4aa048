/* SPDX-License-Identifier: MIT */
/* Rayleigh's energy of 1800 modes from slow to fast: the library, the integral on the real axis as a careful user would
 * write it, and (65) to (67) integrated in time. */
#include <math.h>
#include <stdlib.h>

#include <cor/status.h>

#include "errors.h"
#include "quadrature.h"
#include "reference_disk.h"
#include "stages.h"

enum { MODES = 1800, SPEEDS = 8, PROBED = 60, SLOW_TURNS = 2, JOBS = 2 * SPEEDS };

/* Coarser misses the error that rounding leaves at any rate, finer gains nothing. */
static const struct disk_grid users_grid = {16, 26, 15};

#define USUAL_SPEED 1e-3

struct task {
    const struct cor_disk_modes *modes;
    double speed, tolerance;
    long double b;
    struct cor_disk_rayleigh out;
    double fraction[MODES];
    long double rounded[MODES];
};

static void with_cor(void *closure)
{
    struct task *const t = closure;
    const int status =
        cor_disk_rayleigh(t->modes, MODES, COR_DISK_DATUM_CENTRE_OF_MASS, t->speed, &t->out, t->fraction);
    disk_must(status == COR_OK || status == COR_BEYOND_THEORY, cor_status_text(status));
}

static void with_quadrature(void *closure)
{
    struct task *const t = closure;
    disk_must(disk_quadrature_double(users_grid, t->modes->mode, MODES, t->b, t->speed, t->rounded, NULL) > 0,
              "too many nodes");
    for (size_t i = 0; i < MODES; i++)
        t->fraction[i] = (double)t->rounded[i];
}

static void with_runge_kutta(void *closure)
{
    struct task *const t = closure;
    disk_must(reference_disk_rayleigh(t->modes->mode, MODES, (double)t->b, t->speed, t->tolerance, t->fraction, NULL) >
                  0,
              "Runge-Kutta failed");
}

/* The tolerance at which the highest modes, the worst, are as good as is asked of cor; else the largest at which they
 * are within a factor of 2 of the best: then rounding in double is what is left. */
static double runge_kutta_tolerance(const struct task *t, const long double *reference)
{
    const size_t first = MODES - PROBED;
    double least = INFINITY, best = NAN, fraction[PROBED];
    for (double tolerance = 1e-10; tolerance > 0.5e-15 && least > COR_DISK_RAYLEIGH_MAX_ERROR; tolerance /= 10) {
        disk_must(reference_disk_rayleigh(t->modes->mode + first, PROBED, (double)t->b, t->speed, tolerance, fraction,
                                          NULL) > 0,
                  "Runge-Kutta failed");
        const double error = disk_worst_error(t->modes->mode + first, PROBED, fraction, reference + first);
        if (error < 0.5 * least) {
            least = error;
            best = tolerance;
        }
    }
    return best;
}

static double turns_of_runge_kutta(struct task *task, int turns)
{
    struct job once = {with_runge_kutta, task, 1, NAN};
    double ns = INFINITY;
    for (int turn = 0; turn < turns; turn++) {
        timing_once(&once);
        ns = fmin(ns, once.best_ns);
    }
    return ns;
}

/* One speed: the library; what a user would write; the same task by Runge and Kutta's method, if with_slow. */
static void report_speed(struct disk_bench *bench, const struct task *cor, double cor_ns, struct task *users,
                         double users_ns, int with_slow)
{
    static long double reference[MODES];
    const struct cor_disk_mode *const mode = cor->modes->mode;
    disk_must(disk_quadrature_long(DISK_GRID_REFERENCE, mode, MODES, cor->b, cor->speed, reference, NULL) > 0,
              "too many nodes");
    disk_csv(bench, &(struct disk_row){"rayleigh", "cor", cor->speed, NAN, MODES, cor_ns / 1e9,
                                       disk_worst_error(mode, MODES, cor->fraction, reference)});
    disk_csv(bench, &(struct disk_row){"rayleigh", "cosines", cor->speed, users_grid.points, MODES, users_ns / 1e9,
                                       disk_worst_error(mode, MODES, users->fraction, reference)});
    if (!with_slow)
        return;
    users->tolerance = runge_kutta_tolerance(users, reference);
    const double ns = turns_of_runge_kutta(users, bench->quick ? 1 : SLOW_TURNS);
    disk_csv(bench, &(struct disk_row){"rayleigh", "Runge-Kutta", cor->speed, users->tolerance, MODES, ns / 1e9,
                                       disk_worst_error(mode, MODES, users->fraction, reference)});
}

void disk_rayleigh(struct disk_bench *bench)
{
    const struct cor_disk_modes *const modes = &cor_disk_modes_nu033;
    static struct task task[JOBS];
    static const double speeds[SPEEDS] = {1e-12, 1e-8, 1e-4, USUAL_SPEED, 1e-2, 0.03, 0.1, 0};
    struct job job[JOBS];
    for (int i = 0; i < JOBS; i++) {
        const double speed = speeds[i % SPEEDS];
        task[i] = (struct task){.modes = modes, .b = disk_constant_b(modes->nu)};
        task[i].speed = speed > 0 ? speed : cor_disk_speed_limit(modes->nu, COR_DISK_DATUM_CENTRE_OF_MASS);
        job[i] = (struct job){i < SPEEDS ? with_cor : with_quadrature, &task[i], 1, NAN};
    }
    timing_measure(job, JOBS, bench->timing);
    for (int i = 0; i < SPEEDS; i++)
        report_speed(bench, &task[i], job[i].best_ns, &task[SPEEDS + i], job[SPEEDS + i].best_ns,
                     !bench->quick || task[i].speed == USUAL_SPEED);
}
