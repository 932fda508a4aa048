/* SPDX-License-Identifier: MIT */
/* Splittings with the library's own inner loops */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "collision_rivals.h"
#include "collision_stage.h"
#include "disk.h"

/* Pressure that the library does without, relative to the greatest; looked for at the first kick of a step */
static const double negligible_pressure = 1e-26;
static const double patience = 4;

struct state {
    struct stage *stage;
    const struct cor_collision_loops *loops;
    double alpha, load;
    size_t window;
};

static void wall_touch(struct state *state, double x0, int look)
{
    struct stage *const st = state->stage;
    const size_t angles = st->rim.points;
    if (look)
        state->window = angles;
    state->loops->gather(&st->rim, st->sum_c, st->sum_s, st->d);
    state->loops->reach(&st->rim, state->window, x0 + 1, st->shape, st->d, st->reach);
    state->load = state->loops->press(state->window, state->alpha, st->weight, st->reach, st->pressure);
    if (look) {
        double greatest = 0;
        size_t last = 0;
        for (size_t j = 0; j < angles; j++)
            greatest = fmax(greatest, st->pressure[j]);
        for (size_t j = 0; j < angles; j++)
            if (st->pressure[j] > negligible_pressure * greatest)
                last = j;
        state->window = stage_panels(last + 1);
    }
    state->loops->transform(&st->rim, state->window, st->pressure, st->e);
}

static int disk_is_gone(const struct state *state, const struct rival_disk *disk, double x0, double velocity)
{
    const struct stage *const st = state->stage;
    if (!(velocity < 0 && state->load < rival_negligible_load(disk)))
        return 0;
    double swing = 0;
    for (size_t i = 0; i < st->cells; i++)
        swing += fmax(fabs(st->c[i]), fabs(st->s[i])) * sqrt(st->q[i] * st->q[i] + st->p[i] * st->p[i]);
    return x0 + 1 + swing < log(rival_negligible_load(disk) / STAGE_MASS) / disk->alpha;
}

static double splitting(const struct rival_disk *disk, const struct rival_splitting *of, double h, long *steps)
{
    struct stage *const st = disk->stage;
    struct state state = {st, stage_sets[stage_sets_here() - 1].loops, disk->alpha, 0, 0};
    double *const angles = disk_memory(2 * (size_t)of->stages * st->cells, sizeof *angles);
    for (int k = 0; k < of->stages; k++)
        for (size_t i = 0; i < st->cells; i++) {
            const int twin = of->stages - 1 - k;
            double *const c = angles + 2 * (size_t)k * st->cells, *const s = c + st->cells;
            c[i] = twin < k ? angles[2 * (size_t)twin * st->cells + i] : cos(st->omega[i] * of->a[k] * h);
            s[i] = twin < k ? angles[(2 * (size_t)twin + 1) * st->cells + i] : sin(st->omega[i] * of->a[k] * h);
        }
    memset(st->q, 0, st->cells * sizeof *st->q);
    memset(st->p, 0, st->cells * sizeof *st->p);
    memset(st->sum_c, 0, st->lanes * sizeof *st->sum_c);
    memset(st->sum_s, 0, st->lanes * sizeof *st->sum_s);
    double x0 = rival_first_position(disk), v = disk->speed, pending = 0, eps = RIVAL_NO_RESULT;
    wall_touch(&state, x0, 1);
    const long most = (long)(patience / (disk->speed * h));
    for (*steps = 0; *steps < most && fabs(v) < 10 * disk->speed;) {
        for (int k = 0; k < of->stages; k++) {
            const double h_kick = pending + of->b[k] * h;
            pending = 0;
            v -= h_kick * state.load / STAGE_MASS;
            state.loops->split(&st->rim, -h_kick, st->e, st->force_c, st->force_s);
            const double *const c = angles + 2 * (size_t)k * st->cells;
            state.loops->turn(&st->rim, st->q, st->p, c, c + st->cells, st->force_c, st->force_s, st->sum_c, st->sum_s);
            x0 += of->a[k] * h * v;
            if (k + 1 == of->stages && of->b[k + 1] == 0)
                break;
            wall_touch(&state, x0, k == 0 && (of->stages > 1 || *steps % 8 == 0));
        }
        pending = of->b[of->stages] * h;
        ++*steps;
        if (*steps % 8 == 0 && disk_is_gone(&state, disk, x0, v)) {
            eps = -(v - pending * state.load / STAGE_MASS) / disk->speed;
            break;
        }
    }
    free(angles);
    return eps;
}

const struct rival_build rival_build_loops = {splitting, NULL};
