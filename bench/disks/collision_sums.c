/* SPDX-License-Identifier: MIT */
/* Ways to sum over the angles: the library's table, a recurrence, a fast Fourier transform. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "collision.h"
#include "phi_sums.h"
#include "stages.h"

#if defined COR_BENCH_SHARED || !defined COR_BENCH_HAS_NATIVE
void collision_sums(struct disk_bench *bench)
{
    (void)bench;
}
#else
#include "collision_stage.h"

struct part {
    struct stage *stage;
    const struct cor_collision_loops *loops;
    const struct phi_sums *sums;
    size_t window;
};

static void part_turn(void *closure)
{
    const struct part *const p = closure;
    struct stage *const st = p->stage;
    p->loops->turn(&st->rim, st->q, st->p, st->cosine, st->sine, st->force_c, st->force_s, st->sum_c, st->sum_s);
}

static void part_reach(void *closure)
{
    const struct part *const p = closure;
    struct stage *const st = p->stage;
    p->loops->gather(&st->rim, st->sum_c, st->sum_s, st->d);
    p->loops->reach(&st->rim, p->window, 0, st->shape, st->d, st->reach);
}

static void sum_table_reach(void *closure)
{
    const struct part *const p = closure;
    p->loops->reach(&p->stage->rim, p->window, 0, p->stage->flat, p->stage->d, p->stage->response);
}

static void sum_table_transform(void *closure)
{
    const struct part *const p = closure;
    p->loops->transform(&p->stage->rim, p->window, p->stage->pressure, p->stage->e);
}

static void sum_recurrence_reach(void *closure)
{
    const struct part *const p = closure;
    phi_sums_reach_recurrence(p->sums, p->window, p->stage->d, p->stage->response);
}

static void sum_recurrence_transform(void *closure)
{
    const struct part *const p = closure;
    phi_sums_transform_recurrence(p->sums, p->window, p->stage->pressure, p->stage->e);
}

static void sum_fft_reach(void *closure)
{
    const struct part *const p = closure;
    phi_sums_reach_fft(p->sums, p->stage->d, p->stage->response);
}

static void sum_fft_transform(void *closure)
{
    const struct part *const p = closure;
    phi_sums_transform_fft(p->sums, p->stage->pressure, p->stage->e);
}

static double farthest(const double *x, const double *y, size_t n)
{
    double most = 0, size = 0;
    for (size_t i = 0; i < n; i++) {
        most = fmax(most, fabs(x[i] - y[i]));
        size = fmax(size, fabs(y[i]));
    }
    return most / size;
}

/* The table, a recurrence and a transform, there and back, at all angles and at the first half and quarter of them:
 * only angles near the contact feel the wall, and the library takes no others in seven steps of eight. */
static void sums_over_angles(struct disk_bench *bench, struct stage *st, size_t n_modes)
{
    enum { WINDOWS = 3 };
    static const struct {
        const char *name;
        void (*reach)(void *), (*transform)(void *);
        size_t windows;
    } ways[] = {{"table", sum_table_reach, sum_table_transform, WINDOWS},
                {"recurrence", sum_recurrence_reach, sum_recurrence_transform, WINDOWS},
                {"fast Fourier transform", sum_fft_reach, sum_fft_transform, 1}};
    enum { WAYS = sizeof ways / sizeof *ways };
    static const char *const tables[WINDOWS] = {"collision sums", "collision sums half", "collision sums quarter"};
    const size_t points = st->rim.points, terms = st->rim.terms;
    const struct stage_set *const best = &stage_sets[stage_sets_here() - 1];
    struct phi_sums sums;
    phi_sums_init(&sums, terms, points);
    struct part part[WINDOWS];
    struct job job[WAYS * WINDOWS * 2];
    for (size_t w = 0; w < WINDOWS; w++)
        part[w] = (struct part){st, best->loops, &sums, points >> w};

    /* A shape that matters: that of the modes; a pressure like that of a contact */
    part_turn(&part[0]);
    part_reach(&part[0]);
    for (size_t j = 0; j < points; j++)
        st->pressure[j] = exp(-40 * pow((double)j / (double)points, 2));
    double *const reach = disk_memory(points, sizeof *reach), *const e = disk_memory(terms, sizeof *e);
    double error[WAYS];
    for (size_t i = 0; i < WAYS; i++) {
        ways[i].reach(&part[0]);
        ways[i].transform(&part[0]);
        if (i == 0) {
            memcpy(reach, st->response, points * sizeof *reach);
            memcpy(e, st->e, terms * sizeof *e);
        }
        error[i] = fmax(farthest(st->response, reach, points), farthest(st->e, e, st->rim.used_terms));
        disk_must(error[i] < 1e-10, "ways to sum over the angles differ");
    }
    for (size_t i = 0; i < WAYS; i++)
        for (size_t w = 0; w < WINDOWS; w++) {
            const size_t at = (i * WINDOWS + w) * 2;
            job[at] = (struct job){ways[i].reach, &part[w], 1, NAN};
            job[at + 1] = (struct job){ways[i].transform, &part[w], 1, NAN};
        }
    timing_measure(job, WAYS * WINDOWS * 2, bench->timing);

    for (size_t i = 0; i < WAYS; i++)
        for (size_t w = 0; w < ways[i].windows; w++) {
            const size_t at = (i * WINDOWS + w) * 2;
            disk_csv(bench, &(struct disk_row){tables[w], ways[i].name, NAN, (double)points, n_modes,
                                               (job[at].best_ns + job[at + 1].best_ns) / 1e9, error[i]});
        }
    phi_sums_free(&sums);
    free(reach);
    free(e);
}

void collision_sums(struct disk_bench *bench)
{
    const struct {
        const struct cor_disk_modes *modes;
        size_t n, points;
    } scenes[] = {{&cor_disk_modes_nu033, COLLISION_MODES, 128}, {bench->all, 7200, 1024}};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        if (!scenes[i].modes || scenes[i].modes->count < scenes[i].n)
            continue;
        struct stage st;
        stage_init(&st, scenes[i].modes, scenes[i].n, scenes[i].points);
        sums_over_angles(bench, &st, scenes[i].n);
        stage_free(&st);
    }
}
#endif
