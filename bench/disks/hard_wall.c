/* SPDX-License-Identifier: MIT */
/* The rigid wall, error against time: cor_disk_hard_wall at tolerances, beside what was to be had before it, soft walls
 * of few modes extrapolated to alpha -> infinity and N -> infinity. The truth is the rigid wall at its least tolerance,
 * with modes up to Omega = 960 (480 in a quick run). */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cor/status.h>

#include "gen/support/clock.h"
#include "stages.h"

enum { SCENES = 5, TOLERANCES = 5, GRIDS = 4 };
static const struct scene {
    double nu, speed;
} scenes[SCENES] = {{0.33, 0.01}, {0.33, 0.06}, {0.33, 0.1}, {0.33, 0.3}, {0.9, 0.1}};
static const double tolerances[TOLERANCES] = {1e-3, 1e-4, 1e-5, 3e-6, 1e-6};

/* The first modes of a material, as many as so many levels of the rigid wall need */
static struct cor_disk_modes modes_of(double nu, int levels)
{
    struct cor_disk_modes modes;
    const double omega = COR_DISK_HARD_WALL_FIRST_OMEGA * pow(2, 0.5 * (levels - 1));
    const size_t count = cor_disk_modes_below(nu, omega * (1 + 1e-9)) + 1;
    struct cor_disk_mode *const mode = disk_memory(count, sizeof *mode);
    disk_must(cor_disk_modes_compute(nu, count, mode, &modes) == COR_OK, "no modes");
    return modes;
}

/* ---- the rigid wall ---- */

struct rigid {
    const struct cor_disk_modes *modes;
    double speed, tolerance;
    struct cor_disk_hard_wall out;
    int status;
};

static void to_tolerance(void *closure)
{
    struct rigid *const r = closure;
    const struct cor_disk_hard_wall_options options = {r->tolerance, SIZE_MAX};
    r->status = cor_disk_hard_wall(r->modes, r->modes->count, &options, r->speed, &r->out);
    disk_must(r->status == COR_OK || r->status == COR_TOLERANCE_NOT_REACHED, cor_status_text(r->status));
}

/* ---- soft walls, extrapolated ---- */

/* 1 - eps^2 = L + a u + c u^(5/3) + b w + d u w, u = 1/(alpha v), w = 1/sqrt(N), by least squares: the best of the
 * forms that were tried, docs/derivation.md, 15 */
enum { WALLS = 4, COUNTS = 5, ROWS = WALLS * COUNTS, TERMS = 5 };
static const double hardness[WALLS] = {22, 30, 41, 56};
static const size_t counts[COUNTS] = {3000, 3800, 4800, 6000, 7500};
static const double shares[GRIDS] = {0.15, 0.4, 1, 2.5}; /* of these counts */

static void set_terms(long double term[TERMS], double u, double w)
{
    term[0] = 1;
    term[1] = u;
    term[2] = powl(u, 5.0L / 3);
    term[3] = w;
    term[4] = (long double)u * w;
}

static double fitted_limit(const double u[ROWS], const double w[ROWS], const double loss[ROWS])
{
    long double a[TERMS][TERMS + 1] = {{0}};
    for (int r = 0; r < ROWS; r++) {
        long double term[TERMS];
        set_terms(term, u[r], w[r]);
        for (int i = 0; i < TERMS; i++) {
            for (int j = 0; j < TERMS; j++)
                a[i][j] += term[i] * term[j];
            a[i][TERMS] += term[i] * loss[r];
        }
    }
    for (int k = 0; k < TERMS; k++) /* positive definite: no exchange of rows is needed */
        for (int i = 0; i < TERMS; i++)
            if (i != k) {
                const long double factor = a[i][k] / a[k][k];
                for (int j = k; j <= TERMS; j++)
                    a[i][j] -= factor * a[k][j];
            }
    return (double)(a[0][TERMS] / a[0][0]);
}

struct soft {
    const struct cor_disk_modes *modes;
    double speed, share, limit;
};

static void extrapolate(void *closure)
{
    struct soft *const s = closure;
    double u[ROWS], w[ROWS], loss[ROWS];
    for (int r = 0; r < ROWS; r++) {
        const size_t n = (size_t)(s->share * (double)counts[r % COUNTS]);
        const struct cor_disk_collision_options options = {.alpha = hardness[r / COUNTS] / s->speed, .tolerance = 1e-7};
        struct cor_disk_collision out;
        const int status = cor_disk_collision(s->modes, n, &options, s->speed, &out);
        disk_must(status == COR_OK || status == COR_TOLERANCE_NOT_REACHED, cor_status_text(status));
        u[r] = 1 / hardness[r / COUNTS];
        w[r] = 1 / sqrt((double)n);
        loss[r] = out.one_minus_eps2;
    }
    s->limit = fitted_limit(u, w, loss);
}

/* ---- tables ---- */

static void bench_scene(struct disk_bench *bench, const struct scene *scene, const struct cor_disk_modes *modes)
{
    struct rigid truth = {
        .modes = modes, .speed = scene->speed, .tolerance = bench->quick ? 1e-6 : COR_DISK_HARD_WALL_MIN_TOLERANCE};
    to_tolerance(&truth);
    for (int i = 0; i < TOLERANCES; i++) {
        struct rigid r = {.modes = modes, .speed = scene->speed, .tolerance = tolerances[i]};
        struct job job = {to_tolerance, &r, 1, NAN};
        timing_measure(&job, 1, bench->timing);
        const double seconds = job.best_ns / 1e9, error = fabs(r.out.one_minus_eps2 - truth.out.one_minus_eps2);
        disk_csv(bench, &(struct disk_row){"hard_wall", "rigid", scene->speed, tolerances[i], r.out.omega_levels,
                                           seconds, error / truth.out.one_minus_eps2});
    }
    for (int i = 0; i < (bench->quick ? GRIDS - 1 : GRIDS); i++) {
        struct soft s = {modes, scene->speed, shares[i], NAN};
        struct job job = {extrapolate, &s, 1, NAN};
        timing_once(&job);
        const double error = fabs(s.limit - truth.out.one_minus_eps2);
        disk_csv(bench, &(struct disk_row){"hard_wall", "extrapolated", scene->speed, shares[i],
                                           (size_t)(shares[i] * (double)counts[COUNTS - 1]), job.best_ns / 1e9,
                                           error / truth.out.one_minus_eps2});
    }
}

/* ---- random scenes, to 1e-6 ---- */

#define HARD_SECONDS 10.0 /* within which 95 of 100 should reach 1e-6 */

static double uniform(unsigned long long *state)
{
    *state ^= *state >> 12; /* xorshift64* */
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return (double)(*state * 2685821657736338717ULL >> 11) * 0x1p-53;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* v from 1e-4 to 0.5, nu from -0.5 to 0.95; the modes are made anew each time, which counts */
static void bench_random(struct disk_bench *bench)
{
    enum { MOST = 100 };
    static double seconds[MOST];
    const int scenes_of_run = bench->quick ? 20 : MOST;
    const struct cor_disk_hard_wall_options options = {1e-6, SIZE_MAX};
    unsigned long long state = 19990101;
    int within = 0, reached = 0;
    for (int i = 0; i < scenes_of_run; i++) {
        const double speed = 1e-4 * pow(5000, uniform(&state)), nu = -0.5 + 1.45 * uniform(&state);
        struct cor_disk_hard_wall out;
        const double start = clock_processor_seconds();
        const int status = cor_disk_hard_wall_nu(nu, &options, speed, &out);
        seconds[i] = clock_processor_seconds() - start;
        disk_must(status == COR_OK || status == COR_TOLERANCE_NOT_REACHED, cor_status_text(status));
        reached += status == COR_OK;
        within += status == COR_OK && seconds[i] <= HARD_SECONDS;
        if (status != COR_OK || seconds[i] > HARD_SECONDS)
            printf("  nu = %7.4f, v = %.6f: %5.1f s, %zu levels, 1 - eps^2 = %.7f +- %.1e\n", nu, speed, seconds[i],
                   out.omega_levels, out.one_minus_eps2, out.error_estimate);
        disk_csv(bench, &(struct disk_row){"hard_wall", "random", speed, nu, out.omega_levels, seconds[i],
                                           out.error_estimate / out.one_minus_eps2});
    }
    qsort(seconds, (size_t)scenes_of_run, sizeof *seconds, by_size);
    printf(
        "%d random scenes to 1e-6: %d reach it, %d within %g s; processor seconds: median %.2f, 95 of 100 within %.1f",
        scenes_of_run, reached, within, HARD_SECONDS, seconds[scenes_of_run / 2], seconds[scenes_of_run * 95 / 100]);
    printf("\n");
}

/* ---- modes ---- */

struct making {
    double nu;
    size_t count;
    struct cor_disk_mode *mode;
};

static void make_modes(void *closure)
{
    const struct making *const m = closure;
    struct cor_disk_modes modes;
    disk_must(cor_disk_modes_compute(m->nu, m->count, m->mode, &modes) == COR_OK, "no modes");
}

void disk_hard_wall(struct disk_bench *bench)
{
    static const size_t made[] = {1800, 13000, 52000, 103000};
    for (size_t i = 0; i < (bench->quick ? 3 : 4); i++) {
        struct making m = {0.33, made[i], disk_memory(made[i], sizeof *m.mode)};
        struct job job = {make_modes, &m, 1, NAN};
        timing_measure(&job, 1, bench->timing);
        disk_csv(bench, &(struct disk_row){"hard_wall", "modes", NAN, NAN, made[i], job.best_ns / 1e9, NAN});
        free(m.mode);
    }
    struct cor_disk_modes modes = {NAN, 0, NULL};
    for (int i = 0; i < SCENES; i++) {
        if (!(modes.nu == scenes[i].nu)) {
            free((void *)(size_t)modes.mode);
            modes = modes_of(scenes[i].nu, bench->quick ? 11 : 13);
        }
        bench_scene(bench, &scenes[i], &modes);
    }
    free((void *)(size_t)modes.mode);
    bench_random(bench);
}
