/* SPDX-License-Identifier: MIT */
/* Rayleigh's energy: each of 1800 modes from slow to fast, and the energy of all modes, error against time. The library
 * stands beside the integral on the real axis as a careful user would write it. The truth of a mode is that integral in
 * long double; the truth of all modes is the sum over many more of them and its own tail. */
#include <math.h>
#include <stdlib.h>

#include <cor/status.h>

#include "disk.h"
#include "quadrature.h"

enum { MODES = 1800, SPEEDS = 8, NEIGHBOURS = 25 };

#define USUAL_SPEED 1e-3

static const enum cor_disk_datum datum = COR_DISK_DATUM_CENTRE_OF_MASS;

/* For single modes coarser grids miss the error that rounding leaves at any rate, and finer ones gain nothing; a sum
 * needs less. */
static const struct disk_grid modes_grid = {16, 26, 15}, sum_grid = {16, 12, 20};

struct task {
    const struct cor_disk_modes *modes;
    double speed, tolerance;
    size_t n;
    struct disk_grid grid;
    struct cor_disk_rayleigh out;
    int status;
    double *fraction;      /* n of them; NULL: not asked for */
    long double *integral; /* n of them */
};

static void to_tolerance(void *closure)
{
    struct task *const t = closure;
    t->status = cor_disk_rayleigh_tolerance(t->modes, datum, t->speed, t->tolerance, &t->out, &t->n);
}

static void plain_sum(void *closure)
{
    struct task *const t = closure;
    disk_must(cor_disk_rayleigh(t->modes, t->n, datum, t->speed, &t->out, t->fraction), COR_BEYOND_THEORY);
}

static void with_cosines(void *closure)
{
    struct task *const t = closure;
    const long double b = -2 * logl(2) - (1 + (long double)t->modes->nu) / 4;
    disk_must(disk_quadrature_double(t->grid, t->modes->mode, t->n, b, t->speed, t->integral) ? COR_OK
                                                                                              : COR_ERROR_RANGE,
              COR_OK);
    t->out.fraction = 0;
    for (size_t i = t->n; i-- > 0;) {
        t->fraction[i] = (double)t->integral[i];
        t->out.fraction += t->fraction[i];
    }
}

/* ---- each mode ---- */

static long double response(const struct cor_disk_mode *mode, long double fraction)
{
    const long double square = (long double)mode->omega * mode->omega;
    return fraction * square * square / ((long double)mode->c * mode->c);
}

/* Largest relative error of a fraction, over the modes whose cosine does not cancel: (2 I)^2 omega^4, which but for the
 * cosine varies slowly, is above 1/100 of the largest among 25 neighbours on each side. */
static double worst_error(const struct cor_disk_mode *mode, const double *fraction, const long double *reference)
{
    double worst = 0;
    for (size_t i = 0; i < MODES; i++) {
        const size_t low = i > NEIGHBOURS ? i - NEIGHBOURS : 0,
                     high = i + NEIGHBOURS < MODES ? i + NEIGHBOURS : MODES - 1;
        long double size = 0;
        for (size_t k = low; k <= high; k++)
            size = fmaxl(size, response(&mode[k], reference[k]));
        const double error = fabs((double)((fraction[i] - reference[i]) / reference[i]));
        if (response(&mode[i], reference[i]) > 0.01L * size && !(error <= worst)) /* a NaN too */
            worst = error;
        if (isnan(error))
            break;
    }
    return worst;
}

static void each_mode(struct disk_bench *bench)
{
    static const double speeds[SPEEDS] = {1e-12, 1e-8, 1e-4, USUAL_SPEED, 1e-2, 0.03, 0.1, 0};
    const struct cor_disk_modes *const modes = &cor_disk_modes_nu033;
    const long double b = -2 * logl(2) - (1 + (long double)modes->nu) / 4;
    static double fraction[2 * SPEEDS][MODES];
    static long double integral[MODES];
    struct task task[2 * SPEEDS];
    struct job job[2 * SPEEDS];
    for (int i = 0; i < 2 * SPEEDS; i++) {
        const double speed = speeds[i % SPEEDS];
        task[i] = (struct task){.modes = modes, .n = MODES, .grid = modes_grid, .fraction = fraction[i]};
        task[i].integral = integral;
        task[i].speed = speed > 0 ? speed : cor_disk_speed_limit(modes->nu, datum);
        job[i] = (struct job){i < SPEEDS ? plain_sum : with_cosines, &task[i], 1, NAN};
    }
    timing_measure(job, (size_t)2 * SPEEDS, bench->timing);
    for (int i = 0; i < SPEEDS; i++) {
        const double speed = task[i].speed;
        disk_must(disk_quadrature_long(DISK_GRID_REFERENCE, modes->mode, MODES, b, speed, integral) ? COR_OK
                                                                                                    : COR_ERROR_RANGE,
                  COR_OK);
        disk_csv(bench, &(struct disk_row){"rayleigh", "cor", speed, NAN, MODES, job[i].best_ns / 1e9,
                                           worst_error(modes->mode, fraction[i], integral)});
        disk_csv(bench, &(struct disk_row){"rayleigh", "cosines", speed, modes_grid.points, MODES,
                                           job[SPEEDS + i].best_ns / 1e9,
                                           worst_error(modes->mode, fraction[SPEEDS + i], integral)});
    }
}

/* ---- all modes: with the tail, to a tolerance; without it; by cosine integrals ---- */

static void all_modes(struct disk_bench *bench)
{
    static const double tolerances[] = {0.3, 0.1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6};
    static const size_t counts[] = {3, 10, 30, 100, 300, 1000, 1800, 5000, 20000};
    static const char *const method[] = {"cor", "truncation", "cosines"};
    static void (*const run[])(void *) = {to_tolerance, plain_sum, with_cosines};
    enum { TOLERANCES = sizeof tolerances / sizeof *tolerances, COUNTS = sizeof counts / sizeof *counts };
    enum { SUMS = TOLERANCES + COUNTS, TASKS = SUMS + COUNTS - 2 };
    struct task task[TASKS], truth = {.modes = bench->all, .speed = USUAL_SPEED, .n = bench->all->count};
    struct job job[TASKS];
    double *const fraction = disk_memory(MODES, sizeof *fraction);
    long double *const integral = disk_memory(MODES, sizeof *integral);
    for (int i = 0; i < TASKS; i++) {
        task[i] = (struct task){.modes = bench->all, .speed = USUAL_SPEED, .tolerance = NAN};
        if (i < TOLERANCES)
            task[i].tolerance = tolerances[i];
        else
            task[i].n = counts[i < SUMS ? i - TOLERANCES : i - SUMS];
        if (i >= SUMS) {
            task[i].grid = sum_grid;
            task[i].fraction = fraction;
            task[i].integral = integral;
        }
        job[i] = (struct job){run[(i >= TOLERANCES) + (i >= SUMS)], &task[i], 1, NAN};
    }
    timing_measure(job, TASKS, bench->timing);
    plain_sum(&truth);
    const double energy = truth.out.fraction + truth.out.tail, unsure = truth.out.error_estimate / energy;
    for (int i = 0; i < TASKS; i++) {
        const struct task *const t = &task[i];
        if (i < TOLERANCES && (t->status != COR_OK || t->n >= truth.n / 2))
            continue; /* the truth has the same modes */
        const double sum = t->out.fraction + (i < TOLERANCES ? t->out.tail : 0);
        const double setting = i < SUMS ? t->tolerance : sum_grid.points;
        disk_csv(bench, &(struct disk_row){"energy", method[(i >= TOLERANCES) + (i >= SUMS)], USUAL_SPEED, setting,
                                           t->n, job[i].best_ns / 1e9, fmax(fabs(sum / energy - 1), unsure)});
    }
    free(fraction);
    free(integral);
}

void disk_rayleigh(struct disk_bench *bench)
{
    each_mode(bench);
    all_modes(bench);
}
