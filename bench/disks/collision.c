/* SPDX-License-Identifier: MIT */
/* Collisions in full: error against time, what more modes and harder walls cost, and where the time goes. */
#include "collision.h"

#include <math.h>

#include <cor/status.h>

int collision_with_cor(const struct cor_disk_modes *modes, size_t n_modes, double alpha, double tolerance,
                       struct cor_disk_collision *out)
{
    const struct cor_disk_collision_options options = {alpha, tolerance, 0, 0};
    const int status = cor_disk_collision(modes, n_modes, &options, COLLISION_SPEED, out);
    disk_must(status == COR_OK || status == COR_TOLERANCE_NOT_REACHED, cor_status_text(status));
    return status;
}

struct scene {
    const struct cor_disk_modes *modes;
    size_t n;
    double alpha, tolerance;
    int status;
    struct cor_disk_collision out;
};

static void one_collision(void *closure)
{
    struct scene *const s = closure;
    s->status = collision_with_cor(s->modes, s->n, s->alpha, s->tolerance, &s->out);
}

/* Slope of ln(time) against ln(x) by least squares, over the scenes whose tolerance was met */
static double exponent(const struct scene *scene, const struct job *job, size_t n, int over_alpha)
{
    double count = 0, x_sum = 0, y_sum = 0, xx = 0, xy = 0;
    for (size_t i = 0; i < n; i++) {
        if (scene[i].status != COR_OK)
            continue;
        const double x = log(over_alpha ? scene[i].alpha : (double)scene[i].n), y = log(job[i].best_ns);
        count++;
        x_sum += x;
        y_sum += y;
        xx += x * x;
        xy += x * y;
    }
    return (count * xy - x_sum * y_sum) / (count * xx - x_sum * x_sum);
}

enum { MOST_SCENES = 8, TOLERANCES = 2 };
static const double tolerances[TOLERANCES] = {1e-3, 1e-6};

/* The scenes, whose tolerance is still to be set, at each tolerance */
static void scale(struct disk_bench *bench, const struct scene *given, size_t n, int over_alpha)
{
    static struct scene scene[TOLERANCES][MOST_SCENES];
    struct job job[TOLERANCES * MOST_SCENES];
    for (size_t t = 0; t < TOLERANCES; t++)
        for (size_t i = 0; i < n; i++) {
            scene[t][i] = given[i];
            scene[t][i].tolerance = tolerances[t];
            job[t * n + i] = (struct job){one_collision, &scene[t][i], 1, NAN};
        }
    timing_measure(job, TOLERANCES * n, collision_timing(bench));
    printf("%7s", over_alpha ? "alpha" : "N");
    for (size_t t = 0; t < TOLERANCES; t++)
        printf(" | at %.0e: ms %8s %15s %9s ", tolerances[t], "steps", "eps", "drift");
    printf("\n");
    for (size_t i = 0; i < n; i++) {
        printf("%7.0f", over_alpha ? given[i].alpha : (double)given[i].n);
        for (size_t t = 0; t < TOLERANCES; t++) {
            const struct scene *const s = &scene[t][i];
            const double ns = job[t * n + i].best_ns;
            printf(" | %12.2f %8zu %15.12f %9.1e%c", ns / 1e6, s->out.steps, s->out.eps, s->out.energy_drift,
                   s->status == COR_OK ? ' ' : '*');
            char method[32];
            snprintf(method, sizeof method, "cor %.0e", s->tolerance);
            disk_csv(bench, &(struct disk_row){over_alpha ? "collision alpha" : "collision modes", method,
                                               COLLISION_SPEED, s->alpha, s->n, ns / 1e9, NAN});
        }
        printf("\n");
    }
    for (size_t t = 0; t < TOLERANCES; t++)
        printf("%stime ~ %s^%.2f at %.0e", t ? ", " : "", over_alpha ? "alpha" : "N",
               exponent(scene[t], job + t * n, n, over_alpha), tolerances[t]);
    printf("\n");
}

static void scaling(struct disk_bench *bench)
{
    enum { SIZES = 6, WALLS = 6, QUICK_WALLS = 4 };
    struct scene scene[MOST_SCENES];
    size_t n = 0;
    printf("more modes, alpha = %g, v = %g; *: the tolerance is not met, and the exponents leave it out\n",
           COLLISION_ALPHA, COLLISION_SPEED);
    for (size_t i = 0; i < SIZES; i++) {
        const size_t modes = (size_t)225 << i;
        const struct cor_disk_modes *const table =
            modes <= cor_disk_modes_nu033.count ? &cor_disk_modes_nu033 : bench->all;
        if (table && modes <= table->count) {
            scene[n] = (struct scene){.modes = table, .n = modes, .alpha = COLLISION_ALPHA};
            n++;
        }
    }
    scale(bench, scene, n, 0);
    printf("harder walls, %d modes\n", COLLISION_MODES);
    n = 0;
    for (int i = 0; i < (bench->quick ? QUICK_WALLS : WALLS); i++) {
        scene[n] = (struct scene){.modes = &cor_disk_modes_nu033, .n = COLLISION_MODES, .alpha = ldexp(250, i)};
        n++;
    }
    scale(bench, scene, n, 1);
    printf("\n");
}

void disk_collision(struct disk_bench *bench)
{
    collision_curves(bench);
    scaling(bench);
    collision_parts(bench);
    fflush(stdout);
}
