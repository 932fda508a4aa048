/* SPDX-License-Identifier: MIT */
/* Measures the time and error of Rayleigh's energy: of each of 1800 modes at low to high speeds, then of all modes.
 * The reference for a mode is its integral on the real axis in long double. The reference for all modes is a sum over
 * many more modes, with its tail. */
#include <math.h>
#include <stdbool.h>

#include "disk.h"
#include "reference_rayleigh.h"

enum { MODES = 1800, SPEEDS = 8, NEIGHBOURS = 25 };

#define USUAL_SPEED 1e-3

static const enum cor_disk_datum datum = COR_DISK_DATUM_CENTRE_OF_MASS;

struct task {
    const struct cor_disk_modes *modes;
    double speed, tolerance;
    size_t n;
    struct cor_disk_rayleigh out;
    int status;
    double *fraction; /* n elements; NULL: not requested */
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

/* ---- each mode ---- */

static long double response(const struct cor_disk_mode *mode, long double fraction)
{
    const long double square = (long double)mode->omega * mode->omega;
    return fraction * square * square / ((long double)mode->c * mode->c);
}

/* Returns the largest relative error of the modes' fractions. Omits a mode if the cosine in its integral is
 * near a zero. Its response() is then below 1/100 of the largest response of 25 neighbours on each side. */
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
        if (response(&mode[i], reference[i]) > 0.01L * size && !(error <= worst)) /* also true for NaN */
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
    static double fraction[SPEEDS][MODES];
    static long double integral[MODES];
    struct task task[SPEEDS];
    struct job job[SPEEDS];
    for (int i = 0; i < SPEEDS; i++) {
        task[i] = (struct task){.modes = modes, .n = MODES, .fraction = fraction[i]};
        task[i].speed = speeds[i] > 0 ? speeds[i] : cor_disk_speed_limit(modes->nu, datum);
        job[i] = (struct job){plain_sum, &task[i], 1, NAN};
    }
    timing_measure(job, SPEEDS, bench->timing);
    for (int i = 0; i < SPEEDS; i++) {
        const double speed = task[i].speed;
        reference_rayleigh(modes->mode, MODES, modes->nu, datum, speed, integral);
        disk_csv(bench, &(struct disk_row){"rayleigh", "cor", speed, NAN, MODES, job[i].best_ns / 1e9,
                                           worst_error(modes->mode, fraction[i], integral)});
    }
}

/* ---- all modes: sums to a tolerance with the tail, and plain sums without the tail ---- */

static void all_modes(struct disk_bench *bench)
{
    static const double tolerances[] = {0.3, 0.1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6};
    static const size_t counts[] = {3, 10, 30, 100, 300, 1000, 1800, 5000, 20000};
    enum { TOLERANCES = sizeof tolerances / sizeof *tolerances, COUNTS = sizeof counts / sizeof *counts };
    enum { TASKS = TOLERANCES + COUNTS };
    struct task task[TASKS], truth = {.modes = bench->all, .speed = USUAL_SPEED, .n = bench->all->count};
    struct job job[TASKS];
    for (int i = 0; i < TASKS; i++) {
        const bool sum = i >= TOLERANCES;
        task[i] = (struct task){.modes = bench->all,
                                .speed = USUAL_SPEED,
                                .tolerance = sum ? (double)NAN : tolerances[i],
                                .n = sum ? counts[i - TOLERANCES] : 0};
        job[i] = (struct job){sum ? plain_sum : to_tolerance, &task[i], 1, NAN};
    }
    timing_measure(job, TASKS, bench->timing);
    plain_sum(&truth);
    const double energy = truth.out.fraction + truth.out.tail, unsure = truth.out.error_estimate / energy;
    for (int i = 0; i < TASKS; i++) {
        const struct task *const t = &task[i];
        const bool sum = i >= TOLERANCES;
        if (!sum && (t->status != COR_OK || t->n >= truth.n / 2))
            continue; /* the sum failed, or has too many modes for this reference */
        const double found = t->out.fraction + (sum ? 0 : t->out.tail);
        disk_csv(bench, &(struct disk_row){"energy", sum ? "truncation" : "cor", USUAL_SPEED, t->tolerance, t->n,
                                           job[i].best_ns / 1e9, fmax(fabs(found / energy - 1), unsure)});
    }
}

void disk_rayleigh(struct disk_bench *bench)
{
    each_mode(bench);
    all_modes(bench);
}
