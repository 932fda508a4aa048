/* SPDX-License-Identifier: MIT */
/* Rayleigh's energy of 1800 modes from slow to fast: the library, the integral on the real axis as a careful user would
 * write it, and (65) to (67) integrated in time. */
#include <math.h>
#include <stdlib.h>

#include <cor/status.h>

#include "disk.h"
#include "errors.h"
#include "quadrature.h"
#include "reference_disk.h"

enum { MODES = 1800, SPEEDS = 8, PROBED = 60, SLOW_TURNS = 2, FLOORS = 3, JOBS = 2 * SPEEDS + FLOORS };

/* Coarser misses the error that rounding leaves at any rate, finer gains nothing. */
static const struct disk_grid users_grid = {16, 26, 15};

#define USUAL_SPEED 1e-3

static const double most_us = 2000, least_ratio = 1000, most_error = COR_DISK_RAYLEIGH_MAX_ERROR;

struct task {
    const struct cor_disk_modes *modes;
    double speed, tolerance;
    size_t n; /* modes that cor takes */
    long double b;
    struct cor_disk_rayleigh out;
    double fraction[MODES];
    long double rounded[MODES];
    double sum;
};

static void with_cor(void *closure)
{
    struct task *const t = closure;
    const int status = cor_disk_rayleigh(t->modes, t->n, COR_DISK_DATUM_CENTRE_OF_MASS, t->speed, &t->out, t->fraction);
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

static void one_sine_and_cosine(void *closure)
{
    struct task *const t = closure;
    const double half_time = 0.5 * cor_disk_contact_time(t->speed, t->modes->nu, COR_DISK_DATUM_CENTRE_OF_MASS);
    for (size_t i = 0; i < MODES; i++) {
        const double phase = half_time * t->modes->mode[i].omega, c = cos(phase), s = sin(phase);
        t->fraction[i] = c + s;
    }
}

static void one_pass(void *closure)
{
    struct task *const t = closure;
    double sum = 0;
    for (size_t i = 0; i < MODES; i++)
        sum += t->modes->mode[i].c * t->modes->mode[i].c;
    t->sum = sum;
}

/* The tolerance at which the highest modes, the worst, are as good as is asked of cor; else the largest at which they
 * are within a factor of 2 of the best: then rounding in double is what is left. */
static double runge_kutta_tolerance(const struct task *t, const long double *reference)
{
    const size_t first = MODES - PROBED;
    double least = INFINITY, best = NAN, fraction[PROBED];
    for (double tolerance = 1e-10; tolerance > 0.5e-15 && least > most_error; tolerance /= 10) {
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

static double relative_sum_error(double sum, const long double *reference)
{
    long double exact = 0;
    for (size_t i = MODES; i-- > 0;)
        exact += reference[i];
    return fabs((double)((sum - exact) / exact));
}

static void heading(void)
{
    printf(
        "Rayleigh's energy, 1800 modes, nu = 0.33, centre of mass. Error: largest relative one of a mode's fraction\n"
        "where (2 I)^2 omega^4 is above 1/100 of its largest among 25 neighbours on each side, that is, where the\n"
        "cosine does not cancel; against the real-axis integral in long double, of which two grids differ by the\n"
        "second column. Ratios: time over cor's. R-K: Runge-Kutta 5(4) over (65) to (67) at the tolerance at which\n"
        "its error is 1e-10, or else nearly least.\n");
    printf("%-10s %8s | %6s %8s %8s | %10s %8s %6s | %8s %7s %8s %7s\n", "v", "unsure", "cor us", "error", "of sum",
           "cosines ms", "error", "ratio", "R-K s", "tol.", "error", "ratio");
}

/* One speed; *users, what a user would write, is then overwritten by Runge and Kutta's method. */
static void print_speed(struct disk_bench *bench, const struct task *cor, double cor_ns, struct task *users,
                        double users_ns, int with_slow)
{
    static long double reference[MODES], second[MODES];
    static double rounded[MODES];
    const struct cor_disk_mode *const mode = cor->modes->mode;
    disk_must(disk_quadrature_long(DISK_GRID_REFERENCE, mode, MODES, cor->b, cor->speed, reference, NULL) > 0 &&
                  disk_quadrature_long(DISK_GRID_SECOND, mode, MODES, cor->b, cor->speed, second, NULL) > 0,
              "too many nodes");
    for (size_t i = 0; i < MODES; i++)
        rounded[i] = (double)second[i];
    const double unsure = disk_worst_error(mode, MODES, rounded, reference);
    const double error = disk_worst_error(mode, MODES, cor->fraction, reference);
    const double users_error = disk_worst_error(mode, MODES, users->fraction, reference);
    printf("%-10.4g %8.1e | %6.0f %8.1e %8.1e | %10.1f %8.1e %6.0f |", cor->speed, unsure, cor_ns / 1e3, error,
           relative_sum_error(cor->out.fraction, reference), users_ns / 1e6, users_error, users_ns / cor_ns);
    disk_csv(bench, &(struct disk_row){"rayleigh", "cor", cor->speed, NAN, MODES, cor_ns / 1e9, error});
    disk_csv(bench, &(struct disk_row){"rayleigh", "cosines", cor->speed, users_grid.points, MODES, users_ns / 1e9,
                                       users_error});
    if (with_slow) {
        users->tolerance = runge_kutta_tolerance(users, reference);
        struct job once = {with_runge_kutta, users, 1, NAN};
        double slow_ns = INFINITY;
        for (int turn = 0; turn < (bench->quick ? 1 : SLOW_TURNS); turn++) {
            timing_once(&once);
            slow_ns = fmin(slow_ns, once.best_ns);
        }
        const double slow_error = disk_worst_error(mode, MODES, users->fraction, reference);
        printf(" %8.2f %7.0e %8.1e %7.0f", slow_ns / 1e9, users->tolerance, slow_error, slow_ns / cor_ns);
        disk_judge(bench, "1000 times", slow_ns >= least_ratio * cor_ns);
        disk_csv(bench, &(struct disk_row){"rayleigh", "Runge-Kutta", cor->speed, users->tolerance, MODES,
                                           slow_ns / 1e9, slow_error});
    }
    disk_judge(bench, "2 ms", cor_ns < most_us * 1e3);
    disk_judge(bench, "1e-10", error <= most_error);
    printf("\n");
    fflush(stdout);
}

void disk_rayleigh(struct disk_bench *bench)
{
    const struct cor_disk_modes *const modes = &cor_disk_modes_nu033;
    static struct task task[JOBS];
    static const double speeds[SPEEDS] = {1e-12, 1e-8, 1e-4, USUAL_SPEED, 1e-2, 0.03, 0.1, 0};
    static const struct {
        const char *name;
        void (*run)(void *);
    } floors[FLOORS] = {{"cor with one mode", with_cor},
                        {"a sine and a cosine a mode", one_sine_and_cosine},
                        {"a pass over the modes", one_pass}};
    struct job job[JOBS];
    for (int i = 0; i < JOBS; i++) {
        const int k = i % SPEEDS, floor = i - 2 * SPEEDS;
        task[i] = (struct task){.modes = modes, .b = disk_constant_b(modes->nu)};
        task[i].n = floor < 0 ? MODES : 1;
        if (floor >= 0)
            task[i].speed = USUAL_SPEED;
        else
            task[i].speed = speeds[k] > 0 ? speeds[k] : cor_disk_speed_limit(modes->nu, COR_DISK_DATUM_CENTRE_OF_MASS);
        job[i] = (struct job){floor >= 0   ? floors[floor].run
                              : i < SPEEDS ? with_cor
                                           : with_quadrature,
                              &task[i], 1, NAN};
    }
    timing_measure(job, JOBS, bench->timing);

    heading();
    for (int i = 0; i < SPEEDS; i++)
        print_speed(bench, &task[i], job[i].best_ns, &task[SPEEDS + i], job[SPEEDS + i].best_ns,
                    !bench->quick || task[i].speed == USUAL_SPEED);
    printf("at v = %g:", USUAL_SPEED);
    for (int i = 0; i < FLOORS; i++) {
        const double ns = job[2 * SPEEDS + i].best_ns;
        printf("%s %s %.1f us", i ? "," : "", floors[i].name, ns / 1e3);
        disk_csv(bench, &(struct disk_row){"rayleigh", floors[i].name, USUAL_SPEED, NAN, MODES, ns / 1e9, NAN});
    }
    printf("\n\n");
}
