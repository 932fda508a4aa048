/* SPDX-License-Identifier: MIT */
/* How the time of a collision grows with the number of modes and the hardness of the wall, and the time of a speed in a
 * list: by a call for each, and by one call for all. */
#include <math.h>

#include <cor/status.h>

#include "collision.h"
#include "stages.h"

enum { MOST = 8, TOLERANCES = 2 };
static const double tolerances[TOLERANCES] = {1e-3, 1e-6};

struct scene {
    const struct cor_disk_modes *modes;
    size_t n;
    double alpha, tolerance;
    int status;
};

static void one_collision(void *closure)
{
    struct scene *const s = closure;
    struct cor_disk_collision out;
    s->status = collision_with_cor(s->modes, s->n, s->alpha, COLLISION_SPEED, s->tolerance, &out);
}

/* The scenes at each tolerance; those that miss it are left out of the table. */
static void measure(struct disk_bench *bench, const char *table, const struct scene *given, size_t n)
{
    static const char *const method[TOLERANCES] = {"cor 1e-03", "cor 1e-06"};
    struct scene scene[TOLERANCES * MOST];
    struct job job[TOLERANCES * MOST];
    for (size_t i = 0; i < TOLERANCES * n; i++) {
        scene[i] = given[i % n];
        scene[i].tolerance = tolerances[i / n];
        job[i] = (struct job){one_collision, &scene[i], 1, NAN};
    }
    timing_measure(job, TOLERANCES * n, collision_timing(bench));
    for (size_t i = 0; i < TOLERANCES * n; i++)
        if (scene[i].status == COR_OK)
            disk_csv(bench, &(struct disk_row){table, method[i / n], COLLISION_SPEED, scene[i].alpha, scene[i].n,
                                               job[i].best_ns / 1e9, NAN});
}

void collision_growth(struct disk_bench *bench)
{
    enum { SIZES = 6, WALLS = 6, QUICK_WALLS = 4 };
    struct scene size[MOST], wall[MOST];
    size_t n = 0;
    for (size_t modes = 225, i = 0; i < SIZES; i++, modes *= 2) {
        const struct cor_disk_modes *const table =
            modes <= cor_disk_modes_nu033.count ? &cor_disk_modes_nu033 : bench->all;
        if (table && modes <= table->count) {
            size[n] = (struct scene){.modes = table, .n = modes, .alpha = COLLISION_ALPHA};
            n++;
        }
    }
    measure(bench, "collision modes", size, n);
    const size_t walls = bench->quick ? QUICK_WALLS : WALLS;
    for (size_t i = 0; i < walls; i++)
        wall[i] = (struct scene){.modes = &cor_disk_modes_nu033, .n = COLLISION_MODES, .alpha = ldexp(250, (int)i)};
    measure(bench, "collision alpha", wall, walls);
}

/* ---- a list of speeds ---- */

enum { SPEEDS = 16 };

struct list {
    size_t n;
    int at_once;
};

static void list_of_collisions(void *closure)
{
    const struct list *const list = closure;
    const struct cor_disk_collision_options options = {COLLISION_ALPHA, tolerances[0], 0, 0};
    struct cor_disk_collision out[SPEEDS];
    double speed[SPEEDS];
    int status = COR_OK;
    for (int i = 0; i < SPEEDS; i++)
        speed[i] = COLLISION_SPEED * (1 + 0.01 * i);
    if (list->at_once)
        status = cor_disk_collision_array(&cor_disk_modes_nu033, list->n, &options, speed, SPEEDS, out, NULL);
    for (int i = 0; i < SPEEDS && !list->at_once && status == COR_OK; i++)
        status = cor_disk_collision(&cor_disk_modes_nu033, list->n, &options, speed[i], &out[i]);
    disk_must(status == COR_OK, cor_status_text(status));
}

void collision_lists(struct disk_bench *bench)
{
    static const size_t modes[] = {1, 30, 112, 940};
    enum { SIZES = sizeof modes / sizeof *modes, WAYS = 2 };
    struct list list[WAYS * SIZES];
    struct job job[WAYS * SIZES];
    for (size_t i = 0; i < WAYS * SIZES; i++) {
        list[i] = (struct list){modes[i / WAYS], i % WAYS};
        job[i] = (struct job){list_of_collisions, &list[i], SPEEDS, NAN};
    }
    timing_measure(job, WAYS * SIZES, collision_timing(bench));
    for (size_t i = 0; i < WAYS * SIZES; i++)
        disk_csv(bench, &(struct disk_row){"collision list", list[i].at_once ? "one call for all" : "a call for each",
                                           COLLISION_SPEED, COLLISION_ALPHA, list[i].n, job[i].best_ns / 1e9, NAN});
}
