/* SPDX-License-Identifier: MIT */
/* A collision of 940 modes, error against time: the paper's Runge-Kutta method, splittings, the library. The truth
 * comes by two routes, the library at its least tolerance and a splitting of order 6 with small steps. */
#include <math.h>

#include <cor/status.h>

#include "collision_rivals.h"
#ifndef COR_BENCH_SHARED
#include "collision_stage.h"
#endif
#include "collision.h"
#include "stages.h"

/* The least at which the library meets its own estimate of the error in both scenes below */
#define REFERENCE_TOLERANCE 1e-12

static const double most_unsure = 1e-11; /* of eps, between the two routes to the truth */

enum { RK4_ANGLES = 256, SPLITTING_ANGLES = 128, POINTS = 24 };

/* Left in the wall at the ends of a rival's run; shifts eps by half as much. */
#define WALL_LEFT 1e-12

/* A method at one step or tolerance */
struct run {
    const struct rival_build *build; /* NULL: cor */
    const struct rival_disk *disk;
    const struct rival_splitting *splitting; /* NULL: Runge-Kutta */
    enum rival_rk4 form;
    double setting;
    long steps;
    double eps;
};

static void one_collision(void *closure)
{
    struct run *const run = closure;
    struct cor_disk_collision out;
    if (!run->build) {
        disk_must(collision_with_cor(&cor_disk_modes_nu033, COLLISION_MODES, COLLISION_ALPHA, COLLISION_SPEED,
                                     run->setting, &out) == COR_OK,
                  "cor misses a tolerance");
        run->eps = out.eps;
        run->steps = (long)out.steps;
    } else if (run->splitting)
        run->eps = run->build->splitting(run->disk, run->splitting, run->setting, &run->steps);
    else
        run->eps = run->build->rk4(run->disk, run->form, run->setting, &run->steps);
}

/* ---- the truth ---- */

struct truth {
    double eps, unsure;
};

static struct truth find_truth(void)
{
    struct run cor = {.setting = REFERENCE_TOLERANCE};
    struct rival_disk disk;
    rival_disk_init(&disk, &cor_disk_modes_nu033, COLLISION_MODES, COLLISION_ALPHA, COLLISION_SPEED,
                    2 * SPLITTING_ANGLES, 1e-15);
    struct run rival = {
        .build = &rival_build_plain, .disk = &disk, .splitting = &rival_splittings[RIVAL_SRKN11_6], .setting = 0.0035};
    one_collision(&cor);
    one_collision(&rival);
    rival_disk_free(&disk);
    const struct truth truth = {cor.eps, fmax(fabs(cor.eps - rival.eps), 1e-15)};
    disk_must(truth.unsure <= most_unsure, "the two references of a collision differ");
    return truth;
}

/* Orders of the methods, from two steps of a small scene: a wrong coefficient would leave a low order. */
static void check_orders(void)
{
    enum { MODES = 10, ANGLES = 128 };
    const double alpha = 50, coarse[RIVAL_SPLITTINGS + 1] = {0.0025, 0.0037, 0.015, 0.11, 0.12, 0.0025};
    struct rival_disk disk;
    struct cor_disk_collision out;
    disk_must(collision_with_cor(&cor_disk_modes_nu033, MODES, alpha, COLLISION_SPEED, REFERENCE_TOLERANCE, &out) ==
                  COR_OK,
              "no reference");
    rival_disk_init(&disk, &cor_disk_modes_nu033, MODES, alpha, COLLISION_SPEED, ANGLES, 1e-15);
    for (int i = 0; i <= RIVAL_SPLITTINGS; i++) {
        const struct rival_splitting *const splitting = i < RIVAL_SPLITTINGS ? &rival_splittings[i] : NULL;
        const int due = splitting ? splitting->order : 4;
        double error[2];
        for (int k = 0; k < 2; k++) {
            struct run run = {.build = &rival_build_plain,
                              .disk = &disk,
                              .splitting = splitting,
                              .form = RIVAL_RK4,
                              .setting = ldexp(coarse[i], -k)};
            one_collision(&run);
            error[k] = fabs(run.eps - out.eps);
        }
        const double order = log2(error[0] / error[1]);
        disk_must(order > due - 0.3, "a method has not its order");
    }
    rival_disk_free(&disk);
}

/* ---- curves ---- */

struct curve {
    const char *table, *method;
    size_t points;
    struct run run[POINTS];
};

struct plan {
    const struct rival_splitting *splitting;
    double coarsest, ratio;
    int points;
};

static const struct plan plans[] = {
    {NULL, 0.02, 1.4142135623730951, 11},
    {&rival_splittings[RIVAL_STRANG], 0.02, 2, 8},
    {&rival_splittings[RIVAL_YOSHIDA4], 0.064, 1.4142135623730951, 12},
    {&rival_splittings[RIVAL_SRKN6_4], 0.085, 1.4142135623730951, 10},
    {&rival_splittings[RIVAL_SRKN11_6], 0.11, 1.4142135623730951, 9},
    {&rival_splittings[RIVAL_SRKN14_6], 0.11, 1.4142135623730951, 8},
};

enum { PLANS = sizeof plans / sizeof *plans, BUILDS = 3, CURVES = BUILDS * PLANS + 1 };

static void measure(struct disk_bench *bench, struct curve *curve, size_t n, const struct truth *truth)
{
    static struct job job[CURVES * POINTS];
    size_t jobs = 0;
    for (size_t c = 0; c < n; c++)
        for (size_t i = 0; i < curve[c].points; i++)
            job[jobs++] = (struct job){one_collision, &curve[c].run[i], 1, NAN};
    timing_measure(job, jobs, collision_timing(bench));
    jobs = 0;
    for (size_t c = 0; c < n; c++) {
        double least = INFINITY;
        for (size_t i = 0; i < curve[c].points; i++, jobs++) {
            const struct run *const run = &curve[c].run[i];
            if (run->eps == RIVAL_NO_RESULT) /* steps so large explode */
                continue;
            const double error = fmax(fabs(run->eps - truth->eps), truth->unsure);
            disk_csv(bench, &(struct disk_row){curve[c].table, curve[c].method, COLLISION_SPEED, run->setting,
                                               COLLISION_MODES, job[jobs].best_ns / 1e9, error});
            least = fmin(least, error);
        }
        disk_must(least < 1e-6, "a method does not converge");
    }
}

/* The paper's method in its forms, at one step */
static void measure_forms(struct disk_bench *bench, const struct rival_disk *disk, const struct rival_build *build,
                          const char *table)
{
    static const struct {
        const char *name;
        enum rival_rk4 form;
    } forms[] = {{"RK4", RIVAL_RK4}, {"RK4; every mode at every angle", RIVAL_RK4_UNGROUPED}};
    enum { FORMS = sizeof forms / sizeof *forms };
    struct run run[FORMS];
    struct job job[FORMS];
    for (int i = 0; i < FORMS; i++) {
        run[i] = (struct run){.build = build, .disk = disk, .form = forms[i].form, .setting = 0.02};
        job[i] = (struct job){one_collision, &run[i], 1, NAN};
    }
    timing_measure(job, FORMS, collision_timing(bench));
    for (int i = 0; i < FORMS; i++) {
        disk_must(fabs(run[i].eps - run[0].eps) < 1e-10, "forms of RK4 differ");
        disk_csv(bench, &(struct disk_row){table, forms[i].name, COLLISION_SPEED, run[i].setting, COLLISION_MODES,
                                           job[i].best_ns / 1e9, NAN});
    }
}

static void plan_curve(struct curve *curve, const char *table, const struct plan *plan, const struct rival_build *build,
                       const struct rival_disk *disk, int quick)
{
    *curve = (struct curve){.table = table, .method = plan->splitting ? plan->splitting->name : "RK4"};
    double h = plan->coarsest;
    for (int i = 0; i < plan->points; i++, h /= plan->ratio)
        if (!quick || i % 2 == 0)
            curve->run[curve->points++] =
                (struct run){.build = build, .disk = disk, .splitting = plan->splitting, .setting = h};
}

/* How the rivals are built: by the flags of the library's own loops, and for this machine (CMakeLists.txt) */
static const struct built {
    const char *table, *forms;
    const struct rival_build *build;
} builds[] = {
    {"collision", "collision forms", &rival_build_plain},
#ifdef COR_BENCH_HAS_NATIVE
    {"collision native", "collision forms native", &rival_build_native},
#endif
};
enum { BUILT = sizeof builds / sizeof *builds };

void collision_curves(struct disk_bench *bench)
{
    static struct curve curve[CURVES];
    struct rival_disk wide, narrow;
    rival_disk_init(&wide, &cor_disk_modes_nu033, COLLISION_MODES, COLLISION_ALPHA, COLLISION_SPEED, RK4_ANGLES,
                    WALL_LEFT);
    rival_disk_init(&narrow, &cor_disk_modes_nu033, COLLISION_MODES, COLLISION_ALPHA, COLLISION_SPEED, SPLITTING_ANGLES,
                    WALL_LEFT);
    const struct truth truth = find_truth();
    check_orders();

    size_t n = 0;
    for (size_t b = 0; b < BUILT; b++)
        for (size_t p = 0; p < PLANS; p++)
            plan_curve(&curve[n++], builds[b].table, &plans[p], builds[b].build, plans[p].splitting ? &narrow : &wide,
                       bench->quick);
#ifndef COR_BENCH_SHARED
    struct stage stage;
    stage_init(&stage, &cor_disk_modes_nu033, COLLISION_MODES, SPLITTING_ANGLES);
    narrow.stage = &stage;
    for (size_t p = 0; p < PLANS; p++)
        if (plans[p].splitting)
            plan_curve(&curve[n++], "collision cor's", &plans[p], &rival_build_loops, &narrow, bench->quick);
#endif
    struct curve *const cor = &curve[n++];
    *cor = (struct curve){.table = "collision", .method = "cor"};
    for (int k = 2; k <= 12; k++)
        cor->run[cor->points++] = (struct run){.setting = pow(10, -k)};
    measure(bench, curve, n, &truth);
    for (size_t b = 0; b < BUILT; b++)
        measure_forms(bench, &wide, builds[b].build, builds[b].forms);
#ifndef COR_BENCH_SHARED
    stage_free(&stage);
#endif
    rival_disk_free(&wide);
    rival_disk_free(&narrow);
}
