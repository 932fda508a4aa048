/* SPDX-License-Identifier: MIT */
/* A collision of 940 modes, error against time: the paper's Runge-Kutta method, splittings, the library. The truth
 * comes by two routes, the library at its least tolerance and a splitting of order 6 with small steps. */
#include <math.h>
#include <string.h>

#include <cor/status.h>

#include "collision_rivals.h"
#ifndef COR_BENCH_SHARED
#include "collision_stage.h"
#endif
#include "collision.h"

static const double least_ratio = 20, most_ms = 15, target_error = 1e-8, most_unsure = 1e-11;

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
        disk_must(collision_with_cor(&cor_disk_modes_nu033, COLLISION_MODES, COLLISION_ALPHA, run->setting, &out) ==
                      COR_OK,
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
    struct run cor = {.setting = COR_DISK_COLLISION_MIN_TOLERANCE};
    struct rival_disk disk;
    rival_disk_init(&disk, &cor_disk_modes_nu033, COLLISION_MODES, COLLISION_ALPHA, COLLISION_SPEED,
                    2 * SPLITTING_ANGLES, 1e-15);
    struct run rival = {
        .build = &rival_build_plain, .disk = &disk, .splitting = &rival_splittings[RIVAL_SRKN11_6], .setting = 0.0035};
    one_collision(&cor);
    one_collision(&rival);
    rival_disk_free(&disk);
    const struct truth truth = {cor.eps, fmax(fabs(cor.eps - rival.eps), 1e-15)};
    printf("eps = %.15f by cor, %.15f by a splitting of order 6 with %ld steps and %d angles: they differ by %.1e\n",
           cor.eps, rival.eps, rival.steps, 2 * SPLITTING_ANGLES, truth.unsure);
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
    disk_must(collision_with_cor(&cor_disk_modes_nu033, MODES, alpha, COR_DISK_COLLISION_MIN_TOLERANCE, &out) == COR_OK,
              "no reference");
    rival_disk_init(&disk, &cor_disk_modes_nu033, MODES, alpha, COLLISION_SPEED, ANGLES, 1e-15);
    printf("orders, measured with %d modes at alpha = %g:", MODES, alpha);
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
        printf("%s %s %.2f", i ? "," : "", splitting ? splitting->csv : "RK4", order);
        disk_must(order > due - 0.3, "a method has not its order");
    }
    printf("\n");
    rival_disk_free(&disk);
}

/* ---- curves ---- */

struct curve {
    const char *name, *csv, *flags;
    size_t points;
    struct run run[POINTS];
    double seconds[POINTS], error[POINTS];
};

/* Time from which on the error stays below, by interpolation of logarithms; NaN where the curve does not reach it. */
static double time_at(const struct curve *curve, double error)
{
    double worst = 0, previous = 0;
    for (size_t i = curve->points; i-- > 0;) { /* from the smallest steps */
        worst = fmax(worst, isnan(curve->error[i]) ? INFINITY : curve->error[i]);
        if (worst > error) {
            if (i + 1 == curve->points)
                return NAN;
            if (isinf(worst) || previous <= 0)
                return curve->seconds[i + 1];
            const double part = log(previous / error) / log(previous / worst);
            return curve->seconds[i + 1] * pow(curve->seconds[i] / curve->seconds[i + 1], part);
        }
        previous = worst;
    }
    return curve->seconds[0];
}

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
        for (size_t i = 0; i < curve[c].points; i++) {
            const struct run *const run = &curve[c].run[i];
            curve[c].seconds[i] = job[jobs++].best_ns / 1e9;
            curve[c].error[i] = run->eps == RIVAL_NO_RESULT ? NAN : fmax(fabs(run->eps - truth->eps), truth->unsure);
            char table[64];
            snprintf(table, sizeof table, "collision%s%s", *curve[c].flags ? " " : "", curve[c].flags);
            disk_csv(bench, &(struct disk_row){table, curve[c].csv, COLLISION_SPEED, run->setting, COLLISION_MODES,
                                               curve[c].seconds[i], curve[c].error[i]});
            least = fmin(least, curve[c].error[i]);
        }
        disk_must(least < 1e-6, "a method does not converge");
    }
}

static const char *rounded(double x, int digits, char text[16])
{
    if (isnan(x))
        strcpy(text, "-");
    else
        snprintf(text, 16, "%.*f", digits, x);
    return text;
}

static void print_curve(const struct curve *curve, const struct curve *rk4)
{
    static const double errors[] = {1e-4, 1e-6, 1e-8, 1e-10};
    char text[16];
    printf("%-32s %-8s", curve->name, curve->flags);
    for (size_t i = 0; i < sizeof errors / sizeof *errors; i++)
        printf(" %9s", rounded(1e3 * time_at(curve, errors[i]), 2, text));
    const double ratio = time_at(rk4, target_error) / time_at(curve, target_error);
    printf(" %9s", rounded(ratio, 1, text));
    for (size_t i = 0; i < curve->points && isnan(curve->error[i]); i++)
        if (i + 1 < curve->points && !isnan(curve->error[i + 1]))
            printf("   nothing above h = %.3g", curve->run[i + 1].setting);
    printf("\n");
}

/* Times of one step of the paper's method in other forms, over that of the form of the curve */
static void print_forms(struct disk_bench *bench, const struct rival_disk *disk, const struct rival_build *build,
                        const char *flags, double *ungrouped)
{
    static const struct {
        const char *name;
        enum rival_rk4 form;
    } forms[] = {{"RK4", RIVAL_RK4},
                 {"RK4 cos and sin anew", RIVAL_RK4_RECOMPUTED},
                 {"RK4 every mode at every angle", RIVAL_RK4_UNGROUPED}};
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
        char table[64];
        snprintf(table, sizeof table, "collision forms%s%s", *flags ? " " : "", flags);
        disk_csv(bench, &(struct disk_row){table, forms[i].name, COLLISION_SPEED, run[i].setting, COLLISION_MODES,
                                           job[i].best_ns / 1e9, NAN});
    }
    *ungrouped = job[2].best_ns / job[0].best_ns;
    printf("RK4, %s: a step takes %.1f times as long with cos and sin of omega t in place of a recurrence, %.1f times\n"
           "with every mode at every angle, as (40) and (44) are printed, in place of sums over the modes of each n\n",
           *flags ? flags : "library's flags", job[1].best_ns / job[0].best_ns, *ungrouped);
}

static void plan_curve(struct curve *curve, const struct plan *plan, const struct rival_build *build, const char *flags,
                       const struct rival_disk *disk, int quick)
{
    *curve = (struct curve){.name = plan->splitting ? plan->splitting->name : "Runge-Kutta 4, 256 angles",
                            .csv = plan->splitting ? plan->splitting->csv : "RK4",
                            .flags = flags};
    double h = plan->coarsest;
    for (int i = 0; i < plan->points; i++, h /= plan->ratio)
        if (!quick || i % 2 == 0)
            curve->run[curve->points++] =
                (struct run){.build = build, .disk = disk, .splitting = plan->splitting, .setting = h};
}

void collision_curves(struct disk_bench *bench)
{
    static struct curve curve[CURVES];
    static const struct {
        const struct rival_build *build;
        const char *flags;
    } builds[] = {
        {&rival_build_plain, ""},
#ifdef COR_BENCH_HAS_NATIVE
        {&rival_build_native, "native"},
#endif
    };
    enum { BUILT = sizeof builds / sizeof *builds };
    struct rival_disk wide, narrow;
    rival_disk_init(&wide, &cor_disk_modes_nu033, COLLISION_MODES, COLLISION_ALPHA, COLLISION_SPEED, RK4_ANGLES,
                    WALL_LEFT);
    rival_disk_init(&narrow, &cor_disk_modes_nu033, COLLISION_MODES, COLLISION_ALPHA, COLLISION_SPEED, SPLITTING_ANGLES,
                    WALL_LEFT);
    printf("a collision of %d modes, nu = 0.33, alpha = %g, v = %g\n", COLLISION_MODES, COLLISION_ALPHA,
           COLLISION_SPEED);
    const struct truth truth = find_truth();
    check_orders();

    size_t n = 0;
    for (size_t b = 0; b < BUILT; b++)
        for (size_t p = 0; p < PLANS; p++)
            plan_curve(&curve[n++], &plans[p], builds[b].build, builds[b].flags, plans[p].splitting ? &narrow : &wide,
                       bench->quick);
#ifndef COR_BENCH_SHARED
    struct stage stage;
    stage_init(&stage, &cor_disk_modes_nu033, COLLISION_MODES, SPLITTING_ANGLES);
    narrow.stage = &stage;
    for (size_t p = 0; p < PLANS; p++)
        if (plans[p].splitting)
            plan_curve(&curve[n++], &plans[p], &rival_build_loops, "cor's", &narrow, bench->quick);
#endif
    struct curve *const cor = &curve[n++];
    *cor = (struct curve){.name = "cor, to a tolerance", .csv = "cor", .flags = ""};
    size_t at_target = 0;
    for (int k = 2; k <= 12; k++) {
        if (k == 8)
            at_target = cor->points;
        cor->run[cor->points++] = (struct run){.setting = pow(10, -k)};
    }
    measure(bench, curve, n, &truth);

    printf(
        "ms at an error of eps, interpolated; RK4's time over the method's at %g. Splittings with %d angles. Rivals:\n"
        "with the flags of the library's loops; native: -O3 -march=native -ffast-math; cor's: with its inner loops, "
        "which\n"
        "pass over angles far from the contact\n",
        target_error, SPLITTING_ANGLES);
    printf("%-32s %-8s %9s %9s %9s %9s %9s\n", "method", "built", "1e-4", "1e-6", "1e-8", "1e-10", "RK4/this");
    for (size_t i = 0; i < n; i++)
        print_curve(&curve[i], &curve[i / PLANS < BUILT ? i / PLANS * PLANS : 0]);
    printf("cor's tolerances: time, steps of the last run, error\n");
    for (size_t i = 0; i < cor->points; i++)
        printf("%9.0e %8.2f ms %7ld %9.1e\n", cor->run[i].setting, cor->seconds[i] * 1e3, cor->run[i].steps,
               cor->error[i]);
    double ungrouped[BUILT];
    for (size_t b = 0; b < BUILT; b++)
        print_forms(bench, &wide, builds[b].build, builds[b].flags, &ungrouped[b]);

    const double cor_s = time_at(cor, target_error), safe_s = cor->seconds[at_target];
    for (size_t b = 0; b < BUILT; b++) {
        const double rk4_s = time_at(&curve[b * PLANS], target_error);
        printf("at error %g, RK4 (%s) over cor: %.1f, with every mode at every angle %.1f; over cor at tolerance %g: "
               "%.1f, %.1f\n",
               target_error, *builds[b].flags ? builds[b].flags : "library's flags", rk4_s / cor_s,
               ungrouped[b] * rk4_s / cor_s, target_error, rk4_s / safe_s, ungrouped[b] * rk4_s / safe_s);
    }
    printf("targets, RK4 with the library's flags and sums grouped; cor at tolerance %g: %.2f ms", target_error,
           safe_s * 1e3);
    disk_judge(bench, "20 times", time_at(&curve[0], target_error) >= least_ratio * cor_s);
    disk_judge(bench, "15 ms", safe_s * 1e3 <= most_ms);
    disk_judge(bench, "1e-8", cor->error[at_target] <= target_error);
    printf("\n\n");
#ifndef COR_BENCH_SHARED
    stage_free(&stage);
#endif
    rival_disk_free(&wide);
    rival_disk_free(&narrow);
}
