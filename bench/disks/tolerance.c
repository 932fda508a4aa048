/* SPDX-License-Identifier: MIT */
/* What a tolerance of Rayleigh's energy costs, and how error falls with time by other ways. The truth is the sum over
 * many more modes (20 000) and its own tail, where their file is given. */
#include <math.h>
#include <stdlib.h>

#include <cor/status.h>

#include "errors.h"
#include "quadrature.h"
#include "reference_disk.h"
#include "stages.h"

static const enum cor_disk_datum datum = COR_DISK_DATUM_CENTRE_OF_MASS;

/* All energy, and how well it is known, relative; the sums of the lowest modes. */
struct truth {
    double energy, error;
    double *partial; /* of 1, 2, ... modes */
    size_t n;
};

static void truth_init(struct truth *truth, const struct disk_bench *bench, double speed)
{
    *truth = (struct truth){NAN, NAN, NULL, 0};
    if (!bench->all)
        return;
    struct cor_disk_rayleigh out;
    truth->n = bench->all->count;
    truth->partial = disk_memory(truth->n, sizeof *truth->partial);
    const int status = cor_disk_rayleigh(bench->all, truth->n, datum, speed, &out, truth->partial);
    disk_must(status == COR_OK, cor_status_text(status));
    for (size_t i = 1; i < truth->n; i++)
        truth->partial[i] += truth->partial[i - 1];
    truth->energy = out.fraction + out.tail;
    truth->error = out.error_estimate / truth->energy;
}

/* Modes whose sum alone is within tolerance; beyond what is there, as the rest of a sum falls, like 1/n. */
static double truncation(const struct truth *truth, double tolerance)
{
    size_t n = truth->n;
    const double most = tolerance * truth->energy;
    if (n == 0)
        return NAN;
    const double left = truth->energy - truth->partial[n - 1];
    if (left > most)
        return (double)n * left / most;
    while (n > 1 && truth->energy - truth->partial[n - 2] <= most)
        n--;
    return (double)n;
}

struct task {
    const struct cor_disk_modes *modes;
    double speed, tolerance;
    size_t n;
    struct cor_disk_rayleigh out;
    int status;
};

static void to_tolerance(void *closure)
{
    struct task *const t = closure;
    t->status = cor_disk_rayleigh_tolerance(t->modes, datum, t->speed, t->tolerance, &t->out, &t->n);
}

static void all_modes(void *closure)
{
    struct task *const t = closure;
    t->status = cor_disk_rayleigh(t->modes, t->n, datum, t->speed, &t->out, NULL);
}

static double true_error(const struct task *t, const struct truth *truth)
{
    return fabs((t->out.fraction + t->out.tail) / truth->energy - 1);
}

/* The modes that a tolerance takes, of the library's 1800 ("1800") and of many more ("all"), and those whose sum alone
 * would be as good. A table with too few modes has no row. */
void disk_tolerance(struct disk_bench *bench)
{
    enum { SPEEDS = 3, TOLERANCES = 9, TABLES = 2 };
    static const double speeds[SPEEDS] = {1e-8, 1e-3, 1e-2};
    static struct task task[SPEEDS][TOLERANCES][TABLES];
    struct job job[SPEEDS * TOLERANCES * TABLES];
    const int tables = bench->all ? TABLES : 1;
    size_t jobs = 0;
    for (int i = 0; i < SPEEDS; i++)
        for (int k = 0; k < TOLERANCES; k++)
            for (int table = 0; table < tables; table++) {
                struct task *const t = &task[i][k][table];
                *t = (struct task){.modes = table ? bench->all : &cor_disk_modes_nu033,
                                   .speed = speeds[i],
                                   .tolerance = pow(10, -2 - k)};
                job[jobs++] = (struct job){to_tolerance, t, 1, NAN};
            }
    timing_measure(job, jobs, bench->timing);
    jobs = 0;
    for (int i = 0; i < SPEEDS; i++) {
        struct truth truth;
        truth_init(&truth, bench, speeds[i]);
        for (int k = 0; k < TOLERANCES; k++) {
            for (int table = 0; table < tables; table++, jobs++) {
                const struct task *const t = &task[i][k][table];
                const int known = 2 * t->n <= truth.n; /* else the truth has the same modes */
                if (t->status == COR_OK)
                    disk_csv(bench, &(struct disk_row){"tolerance", table ? "all" : "1800", t->speed, t->tolerance,
                                                       t->n, job[jobs].best_ns / 1e9,
                                                       known ? fmax(true_error(t, &truth), truth.error) : NAN});
            }
            if (bench->all)
                disk_csv(bench, &(struct disk_row){"tolerance", "sum alone", speeds[i], task[i][k][0].tolerance,
                                                   (size_t)truncation(&truth, task[i][k][0].tolerance), NAN, NAN});
        }
        free(truth.partial);
    }
}

/* ---- error against time, for the plot ---- */

struct slow {
    struct disk_grid grid;
    double tolerance, speed;
    long double b;
    size_t n;
    long double *integrals;
    double *fraction;
};

static void with_cosines(void *closure)
{
    struct slow *const s = closure;
    disk_must(disk_quadrature_double(s->grid, cor_disk_modes_nu033.mode, s->n, s->b, s->speed, s->integrals, NULL) > 0,
              "too many nodes");
    for (size_t i = 0; i < s->n; i++)
        s->fraction[i] = (double)s->integrals[i];
}

static void with_runge_kutta(void *closure)
{
    const struct slow *const s = closure;
    disk_must(reference_disk_rayleigh(cor_disk_modes_nu033.mode, s->n, (double)s->b, s->speed, s->tolerance,
                                      s->fraction, NULL) > 0,
              "Runge-Kutta failed");
}

static double sum_of(const double *fraction, size_t n)
{
    double sum = 0;
    while (n-- > 0)
        sum += fraction[n];
    return sum;
}

/* Energy of all modes: with the tail, to a tolerance, and without it */
static void energy_curves(struct disk_bench *bench, double speed, const struct truth *truth)
{
    static const double tolerances[] = {0.3, 0.1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6};
    static const size_t counts[] = {3, 10, 30, 100, 300, 1000, 1800, 5000, 20000};
    enum { TOLERANCES = sizeof tolerances / sizeof *tolerances, COUNTS = sizeof counts / sizeof *counts };
    struct task task[TOLERANCES + COUNTS];
    struct job job[TOLERANCES + COUNTS];
    for (int i = 0; i < TOLERANCES + COUNTS; i++) {
        const int count = i - TOLERANCES;
        task[i] = (struct task){.modes = bench->all, .speed = speed, .tolerance = count < 0 ? tolerances[i] : NAN};
        if (count >= 0)
            task[i].n = counts[count] < truth->n ? counts[count] : truth->n;
        job[i] = (struct job){count < 0 ? to_tolerance : all_modes, &task[i], 1, NAN};
    }
    timing_measure(job, TOLERANCES + COUNTS, bench->timing);
    for (int i = 0; i < TOLERANCES + COUNTS; i++) {
        const struct task *const t = &task[i];
        if (i < TOLERANCES && t->status == COR_OK && t->n < truth->n / 2)
            disk_csv(bench, &(struct disk_row){"energy", "cor", speed, t->tolerance, t->n, job[i].best_ns / 1e9,
                                               fmax(true_error(t, truth), truth->error)});
        else if (i >= TOLERANCES)
            disk_csv(bench, &(struct disk_row){"energy", "truncation", speed, NAN, t->n, job[i].best_ns / 1e9,
                                               fabs(t->out.fraction / truth->energy - 1)});
    }
}

/* Plain sums of n modes by other ways, each integrated as well as what the modes leave out deserves */
static void slow_energy_curves(struct disk_bench *bench, struct slow *s, const struct truth *truth)
{
    static const size_t counts[] = {3, 10, 30, 100, 300, 1000, 1800};
    enum { COUNTS = sizeof counts / sizeof *counts };
    for (int i = 0; i < COUNTS; i++) {
        struct job cosines = {with_cosines, s, 1, NAN};
        s->n = counts[i];
        s->grid = (struct disk_grid){16, 12, 20};
        timing_measure(&cosines, 1, bench->timing);
        disk_csv(bench, &(struct disk_row){"energy", "cosines", s->speed, s->grid.points, s->n, cosines.best_ns / 1e9,
                                           fabs(sum_of(s->fraction, s->n) / truth->energy - 1)});
    }
    for (int i = 0; i < COUNTS; i++) {
        struct job steps = {with_runge_kutta, s, 1, NAN};
        s->n = counts[i];
        s->tolerance = 1e-2;
        const double left = 1 - truth->partial[s->n - 1] / truth->energy;
        double own;
        do {
            s->tolerance /= 10;
            timing_once(&steps);
            own = fabs(sum_of(s->fraction, s->n) - truth->partial[s->n - 1]) / truth->energy;
        } while (!(own <= 0.1 * left) && s->tolerance > 1e-13);
        disk_csv(bench, &(struct disk_row){"energy", "Runge-Kutta", s->speed, s->tolerance, s->n, steps.best_ns / 1e9,
                                           fabs(sum_of(s->fraction, s->n) / truth->energy - 1)});
    }
}

/* The fraction of every mode, 1800 modes */
static void mode_curves(struct disk_bench *bench, struct slow *s)
{
    const struct cor_disk_modes *const modes = &cor_disk_modes_nu033;
    static const struct disk_grid grids[] = {{8, 10, 15},  {9, 13, 15},  {10, 16, 15}, {12, 20, 15},
                                             {14, 26, 15}, {16, 26, 15}, {20, 26, 15}};
    long double *const reference = disk_memory(modes->count, sizeof *reference);
    s->n = modes->count;
    disk_must(disk_quadrature_long(DISK_GRID_REFERENCE, modes->mode, s->n, s->b, s->speed, reference, NULL) > 0,
              "too many nodes");
    for (size_t i = 0; i < sizeof grids / sizeof *grids; i++) {
        struct job cosines = {with_cosines, s, 1, NAN};
        s->grid = grids[i];
        timing_measure(&cosines, 1, bench->timing);
        disk_csv(bench, &(struct disk_row){"modes", "cosines", s->speed, grids[i].points, s->n, cosines.best_ns / 1e9,
                                           disk_worst_error(modes->mode, s->n, s->fraction, reference)});
    }
    for (int k = 6; k <= (bench->quick ? 10 : 14); k++) {
        struct job steps = {with_runge_kutta, s, 1, NAN};
        s->tolerance = pow(10, -k);
        timing_once(&steps);
        disk_csv(bench, &(struct disk_row){"modes", "Runge-Kutta", s->speed, s->tolerance, s->n, steps.best_ns / 1e9,
                                           disk_worst_error(modes->mode, s->n, s->fraction, reference)});
    }
    struct cor_disk_rayleigh out;
    struct task task = {.modes = modes, .speed = s->speed, .n = s->n};
    struct job job = {all_modes, &task, 1, NAN};
    timing_measure(&job, 1, bench->timing);
    disk_must(cor_disk_rayleigh(modes, s->n, datum, s->speed, &out, s->fraction) == COR_OK, "no energy");
    disk_csv(bench, &(struct disk_row){"modes", "cor", s->speed, NAN, s->n, job.best_ns / 1e9,
                                       disk_worst_error(modes->mode, s->n, s->fraction, reference)});
    free(reference);
}

void disk_curves(struct disk_bench *bench)
{
    if (!bench->all)
        return;
    const size_t n = cor_disk_modes_nu033.count;
    struct slow s = {.speed = 1e-3, .b = disk_constant_b(cor_disk_modes_nu033.nu)};
    struct truth truth;
    s.integrals = disk_memory(n, sizeof *s.integrals);
    s.fraction = disk_memory(n, sizeof *s.fraction);
    truth_init(&truth, bench, s.speed);
    energy_curves(bench, s.speed, &truth);
    slow_energy_curves(bench, &s, &truth);
    mode_curves(bench, &s);
    free(truth.partial);
    free(s.integrals);
    free(s.fraction);
}
