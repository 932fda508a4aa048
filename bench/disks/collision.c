/* SPDX-License-Identifier: MIT */
/* Measures error against time of a collision of 940 modes, for tolerances from 1e-2 to 1e-12. The reference is a Taylor
 * series of the motion in time, tests/unit/reference_collision.c.
 *
 * Then measures error and time for few modes and soft walls. The reference is eps of all modes at a rigid wall, from
 * the library's table of limits. No reported error is below the uncertainty of this table.
 *
 * Then runs each scene once with all modes at a rigid wall, including the computation of the modes. The scenes are
 * spread over the domain of that table for v = 0.01 and above. */
#include <math.h>
#include <stdlib.h>
#include <time.h>

#include "disk.h"
#include "reference_collision.h"

struct run {
    double speed, alpha, tolerance;
    size_t n;
    double eps;
};

static void collide(void *closure)
{
    struct run *const r = closure;
    const struct cor_disk_collision_options options = {.alpha = r->alpha, .tolerance = r->tolerance};
    struct cor_disk_collision out;
    disk_must(cor_disk_collision(&cor_disk_modes_nu033, r->n, &options, r->speed, &out), COR_TOLERANCE_NOT_REACHED);
    r->eps = out.eps;
}

static void limit(void *closure)
{
    struct run *const r = closure;
    r->eps = cor_disk_eps(r->speed, cor_disk_modes_nu033.nu);
}

static void perturbation(void *closure)
{
    struct run *const r = closure;
    struct cor_disk_rayleigh out;
    disk_must(
        cor_disk_rayleigh_tolerance(&cor_disk_modes_nu033, COR_DISK_DATUM_CENTRE_OF_MASS, r->speed, 1e-3, &out, &r->n),
        COR_BEYOND_THEORY);
    r->eps = sqrt(1 - out.fraction - out.tail);
}

static void curve(struct disk_bench *bench, struct timing timing)
{
    enum { RUNS = 11, MODES = 940 };
    static const double alpha = 500, speed = 0.1;
    struct run run[RUNS];
    struct job job[RUNS];
    struct reference_collision truth;
    const int failed =
        reference_disk_collision(cor_disk_modes_nu033.mode, MODES, alpha, speed, 1e-13, &truth, NULL, NULL);
    disk_must(failed ? COR_TOLERANCE_NOT_REACHED : COR_OK, COR_OK);
    for (int i = 0; i < RUNS; i++) {
        run[i] = (struct run){speed, alpha, pow(10, -2 - i), MODES, NAN};
        job[i] = (struct job){collide, &run[i], 1, NAN};
    }
    timing_measure(job, RUNS, timing);
    for (int i = 0; i < RUNS; i++)
        disk_csv(bench, &(struct disk_row){"collision", "cor", speed, run[i].tolerance, MODES, job[i].best_ns / 1e9,
                                           fmax(fabs(run[i].eps - truth.eps), truth.error)});
}

static void models(struct disk_bench *bench, double speed, double softest, struct timing timing)
{
    enum { SIZES = 6, WALLS = 5, MODELS = 2 + SIZES * WALLS };
    struct run run[MODELS] = {{.speed = speed}, {.speed = speed}};
    struct job job[MODELS] = {{limit, &run[0], 1, NAN}, {perturbation, &run[1], 1, NAN}};
    for (int i = 2; i < MODELS; i++) {
        const int size = (i - 2) / WALLS, wall = (i - 2) % WALLS;
        run[i] = (struct run){speed, ldexp(softest, wall), 1e-4, (size_t)1800 >> size, NAN};
        job[i] = (struct job){collide, &run[i], 1, NAN};
    }
    timing_measure(job, MODELS, timing);
    const double unsure = cor_disk_eps_uncertainty(speed, cor_disk_modes_nu033.nu);
    for (int i = 0; i < MODELS; i++) {
        static const char *const methods[] = {"cor_disk_eps", "Rayleigh", "cor"};
        disk_csv(bench,
                 &(struct disk_row){"collision models", methods[i < 2 ? i : 2], speed, i < 2 ? NAN : run[i].alpha,
                                    run[i].n, job[i].best_ns / 1e9, fmax(fabs(run[i].eps - run[0].eps), unsure)});
    }
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Writes the rows "median" and "slowest", and how many scenes reach the tolerance: in any time, and in 2 s. */
static void rigid_wall(struct disk_bench *bench, double tolerance)
{
    enum { SCENES = 60, FEW = 6 };
    const struct cor_disk_hard_wall_options options = {.tolerance = tolerance};
    const size_t scenes = bench->quick ? FEW : SCENES;
    double seconds[SCENES], most = 0;
    size_t reached = 0, soon = 0;
    for (size_t i = 0; i < scenes; i++) {
        const double x = fmod(0.6180339887498949 * (double)i, 1), y = fmod(0.7548776662466927 * (double)i, 1);
        struct cor_disk_hard_wall out;
        const clock_t start = clock();
        const int status = cor_disk_hard_wall_nu(COR_DISK_EPS_MIN_NU + x * (COR_DISK_EPS_MAX_NU - COR_DISK_EPS_MIN_NU),
                                                 &options, 0.01 * pow(30, y), &out);
        seconds[i] = (double)(clock() - start) / CLOCKS_PER_SEC;
        disk_must(status, COR_TOLERANCE_NOT_REACHED);
        reached += status == COR_OK;
        soon += status == COR_OK && seconds[i] <= 2;
        most = fmax(most, out.error_estimate);
    }
    qsort(seconds, scenes, sizeof *seconds, ascending);
    const struct disk_row row[] = {{"rigid wall", "median", NAN, tolerance, scenes, seconds[scenes / 2], NAN},
                                   {"rigid wall", "slowest", NAN, tolerance, scenes, seconds[scenes - 1], most},
                                   {"rigid wall", "reached", NAN, tolerance, reached, NAN, NAN},
                                   {"rigid wall", "within 2 s", NAN, tolerance, soon, NAN, NAN}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        disk_csv(bench, &row[i]);
}

void disk_collision(struct disk_bench *bench)
{
    /* a collision takes 1 ms to 1 s; collisions above 30 ms run in every fourth round */
    const struct timing timing = {8e6, bench->quick ? 4 : 12, 4};
    curve(bench, timing);
    models(bench, 0.1, 125, timing);
    models(bench, 0.01, 500, timing);
    for (int k = 3; k <= 6; k++)
        rigid_wall(bench, pow(10, -k));
}
