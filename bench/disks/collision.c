/* SPDX-License-Identifier: MIT */
/* A collision of 940 modes, error against time, from the tolerance 1e-2 to 1e-12. The truth comes by Taylor series of
 * the motion in time, tests/unit/reference_collision.c.
 *
 * Then what few modes and a soft wall leave out, and what they save: eps against the limit of all modes at a rigid
 * wall, which comes from the library's table of limits, and no closer than that is known. */
#include <math.h>

#include <cor/status.h>

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

void disk_collision(struct disk_bench *bench)
{
    /* a collision takes from 1 ms to 1 s: those above 30 ms have one turn in four */
    const struct timing timing = {8e6, bench->quick ? 4 : 12, 4};
    curve(bench, timing);
    models(bench, 0.1, 125, timing);
    models(bench, 0.01, 500, timing);
}
