/* SPDX-License-Identifier: MIT */
/* The integrators. Compiled once for each set of flags; BUILD is the name of what comes out. */
#include "collision_rivals.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "disk.h"

#define PI 3.14159265358979323846
#define MASS PI

/* Steps between two looks at whether the disk is gone */
enum { STEPS_A_LOOK = 16 };
/* Times that the disk needs to cross its radius at first, after which it is given up */
static const double patience = 4;

struct wall {
    double *sum_c, *sum_s;     /* of each n: sum of C Q, of S Q */
    double *pressure;          /* of each angle, with the weight */
    double *force_c, *force_s; /* of each n, on C and on S */
    double load;
};

static void wall_init(struct wall *wall, const struct rival_disk *disk)
{
    wall->sum_c = disk_memory(disk->width, sizeof(double));
    wall->sum_s = disk_memory(disk->width, sizeof(double));
    wall->force_c = disk_memory(disk->width, sizeof(double));
    wall->force_s = disk_memory(disk->width, sizeof(double));
    wall->pressure = disk_memory(disk->angles, sizeof(double));
    wall->load = 0;
}

static void wall_free(struct wall *wall)
{
    free(wall->sum_c);
    free(wall->sum_s);
    free(wall->force_c);
    free(wall->force_s);
    free(wall->pressure);
}

/* Reach becomes pressure; their sum */
static double wall_press(const struct rival_disk *disk, double *restrict x)
{
    double load = 0;
    for (size_t j = 0; j < disk->angles; j++)
        x[j] = disk->weight * exp(disk->alpha * x[j]);
    for (size_t j = 0; j < disk->angles; j++)
        load += x[j];
    return load;
}

/* Forces from sums: to the rim and back, four rows of a table at a time. */
static void wall_touch(const struct rival_disk *disk, struct wall *wall, double x0)
{
    const size_t angles = disk->angles, width = disk->width;
    double *restrict const x = wall->pressure;
    for (size_t j = 0; j < angles; j++)
        x[j] = x0 + disk->cos_phi[j];
    for (size_t n = 0; n < width; n += 4) {
        const double *restrict const c = disk->cos_by_n + n * angles, *restrict const s = disk->sin_by_n + n * angles;
        const double *const a = wall->sum_c + n, *const b = wall->sum_s + n;
        const double a0 = a[0], a1 = a[1], a2 = a[2], a3 = a[3], b0 = b[0], b1 = b[1], b2 = b[2], b3 = b[3];
        for (size_t j = 0; j < angles; j++)
            x[j] +=
                ((a0 * c[j] - b0 * s[j]) + (a1 * c[angles + j] - b1 * s[angles + j])) +
                ((a2 * c[2 * angles + j] - b2 * s[2 * angles + j]) + (a3 * c[3 * angles + j] - b3 * s[3 * angles + j]));
    }
    wall->load = wall_press(disk, x);
    double *restrict const force_c = wall->force_c, *restrict const force_s = wall->force_s;
    memset(force_c, 0, width * sizeof *force_c);
    memset(force_s, 0, width * sizeof *force_s);
    for (size_t j = 0; j < angles; j += 4) {
        const double *restrict const c = disk->cos_by_angle + j * width, *restrict const s =
                                                                             disk->sin_by_angle + j * width;
        const double f0 = x[j], f1 = x[j + 1], f2 = x[j + 2], f3 = x[j + 3];
        for (size_t n = 0; n < width; n++) {
            force_c[n] += (f0 * c[n] + f1 * c[width + n]) + (f2 * c[2 * width + n] + f3 * c[3 * width + n]);
            force_s[n] -= (f0 * s[n] + f1 * s[width + n]) + (f2 * s[2 * width + n] + f3 * s[3 * width + n]);
        }
    }
}

/* Every mode at every angle, as (40) and (44) are printed; then the force of each mode is in force_of. */
static void touch_ungrouped(const struct rival_disk *disk, struct wall *wall, double x0, const double *q,
                            double *force_of)
{
    const size_t angles = disk->angles;
    double *restrict const x = wall->pressure;
    for (size_t j = 0; j < angles; j++)
        x[j] = x0 + disk->cos_phi[j];
    for (size_t n = 0; n < disk->ns; n++) {
        const double *restrict const c = disk->cos_by_n + n * angles, *restrict const s = disk->sin_by_n + n * angles;
        for (size_t i = disk->first[n]; i < disk->first[n + 1]; i++) {
            const double a = disk->c[i] * q[i], b = disk->s[i] * q[i];
            for (size_t j = 0; j < angles; j++)
                x[j] += a * c[j] - b * s[j];
        }
    }
    wall->load = wall_press(disk, x);
    for (size_t n = 0; n < disk->ns; n++) {
        const double *restrict const c = disk->cos_by_n + n * angles, *restrict const s = disk->sin_by_n + n * angles;
        for (size_t i = disk->first[n]; i < disk->first[n + 1]; i++) {
            double sum[8] = {0};
            for (size_t j = 0; j + 8 <= angles; j += 8)
                for (size_t k = 0; k < 8; k++)
                    sum[k] += x[j + k] * (disk->c[i] * c[j + k] - disk->s[i] * s[j + k]);
            for (size_t j = angles / 8 * 8; j < angles; j++)
                sum[0] += x[j] * (disk->c[i] * c[j] - disk->s[i] * s[j]);
            force_of[i] = ((sum[0] + sum[4]) + (sum[1] + sum[5])) + ((sum[2] + sum[6]) + (sum[3] + sum[7]));
        }
    }
}

/* Whether the wall pushes no more, and no part of the rim can come back to it; amplitudes are hypot(u, v). */
static int disk_is_gone(const struct rival_disk *disk, double x0, double velocity, double load, const double *u,
                        const double *v)
{
    if (!(velocity < 0 && load < rival_negligible_load(disk)))
        return 0;
    double swing = 0;
    for (size_t i = 0; i < disk->modes; i++)
        swing += fmax(fabs(disk->c[i]), fabs(disk->s[i])) * sqrt(u[i] * u[i] + v[i] * v[i]);
    return x0 + 1 + swing < log(rival_negligible_load(disk) / PI) / disk->alpha;
}

/* ---- splittings ---- */

/* Kick by h_kick, turn by the angles of cosine and sine, new sums */
static void kick_and_turn(const struct rival_disk *disk, struct wall *wall, double h_kick, const double *per_speed_c,
                          const double *per_speed_s, const double *restrict cosine, const double *restrict sine,
                          double *restrict q, double *restrict p)
{
    for (size_t n = 0; n < disk->ns; n++) {
        const double fc = -h_kick * wall->force_c[n], fs = -h_kick * wall->force_s[n];
        double a = 0, b = 0;
        for (size_t i = disk->first[n]; i < disk->first[n + 1]; i++) {
            const double p_i = p[i] + (per_speed_c[i] * fc + per_speed_s[i] * fs);
            const double q_new = cosine[i] * q[i] + sine[i] * p_i;
            p[i] = cosine[i] * p_i - sine[i] * q[i];
            q[i] = q_new;
            a += disk->c[i] * q_new;
            b += disk->s[i] * q_new;
        }
        wall->sum_c[n] = a;
        wall->sum_s[n] = b;
    }
}

static double splitting(const struct rival_disk *disk, const struct rival_splitting *of, double h, long *steps)
{
    const size_t modes = disk->modes;
    enum { ARRAYS = 4, MOST = 16 };
    double *const memory = disk_memory((ARRAYS + 2 * MOST) * modes, sizeof *memory);
    double *const q = memory, *const p = q + modes, *const per_c = p + modes, *const per_s = per_c + modes;
    const double *cosine[MOST], *sine[MOST];
    for (size_t i = 0; i < modes; i++) { /* p = P/(m omega) */
        per_c[i] = disk->c[i] / (MASS * disk->omega[i]);
        per_s[i] = disk->s[i] / (MASS * disk->omega[i]);
    }
    for (int k = 0; k < of->stages; k++) {
        double *const c = memory + (size_t)(ARRAYS + 2 * k) * modes, *const s = c + modes;
        const int twin = of->stages - 1 - k;
        if (twin < k) {
            cosine[k] = cosine[twin];
            sine[k] = sine[twin];
            continue;
        }
        for (size_t i = 0; i < modes; i++) {
            c[i] = cos(disk->omega[i] * of->a[k] * h);
            s[i] = sin(disk->omega[i] * of->a[k] * h);
        }
        cosine[k] = c;
        sine[k] = s;
    }
    struct wall wall;
    wall_init(&wall, disk);
    double x0 = rival_first_position(disk), v = disk->speed, pending = 0, eps = RIVAL_NO_RESULT;
    wall_touch(disk, &wall, x0);
    const long most = (long)(patience / (disk->speed * h));
    for (*steps = 0; *steps < most && fabs(v) < 10 * disk->speed;) {
        for (int k = 0; k < of->stages; k++) {
            const double h_kick = pending + of->b[k] * h;
            pending = 0;
            v -= h_kick * wall.load / MASS;
            kick_and_turn(disk, &wall, h_kick, per_c, per_s, cosine[k], sine[k], q, p);
            x0 += of->a[k] * h * v;
            if (k + 1 == of->stages && of->b[k + 1] == 0)
                break; /* the next step begins with free motion too */
            wall_touch(disk, &wall, x0);
        }
        pending = of->b[of->stages] * h;
        ++*steps;
        if (*steps % STEPS_A_LOOK == 0 && disk_is_gone(disk, x0, v, wall.load, q, p)) {
            eps = -(v - pending * wall.load / MASS) / disk->speed;
            break;
        }
    }
    wall_free(&wall);
    free(memory);
    return eps;
}

/* ---- the paper's method ---- */

struct rk4 {
    const struct rival_disk *disk;
    struct wall wall;
    enum rival_rk4 form;
    double h;
    double *memory;
    double *re, *im, *stage_re, *stage_im, *slope_re, *slope_im; /* q, q of the stage, sum of slopes */
    double *cosine[3], *sine[3];                                 /* of omega t at the step's begin, middle and end */
    double *half_cos, *half_sin;                                 /* of omega h/2 */
    double *per_c, *per_s, *amplitude, *force_of;
};

enum { RK4_ARRAYS = 18 };

static void rk4_init(struct rk4 *rk4, const struct rival_disk *disk, enum rival_rk4 form, double h)
{
    const size_t modes = disk->modes;
    *rk4 = (struct rk4){.disk = disk, .form = form, .h = h};
    wall_init(&rk4->wall, disk);
    double *at = rk4->memory = disk_memory(RK4_ARRAYS * modes, sizeof *at);
    double **const array[RK4_ARRAYS] = {
        &rk4->re,        &rk4->im,        &rk4->stage_re,  &rk4->stage_im, &rk4->slope_re,  &rk4->slope_im,
        &rk4->cosine[0], &rk4->cosine[1], &rk4->cosine[2], &rk4->sine[0],  &rk4->sine[1],   &rk4->sine[2],
        &rk4->half_cos,  &rk4->half_sin,  &rk4->per_c,     &rk4->per_s,    &rk4->amplitude, &rk4->force_of};
    for (size_t i = 0; i < RK4_ARRAYS; i++, at += modes)
        *array[i] = at;
    for (size_t i = 0; i < modes; i++) {
        rk4->cosine[2][i] = 1;
        rk4->half_cos[i] = cos(0.5 * disk->omega[i] * h);
        rk4->half_sin[i] = sin(0.5 * disk->omega[i] * h);
        rk4->per_c[i] = disk->c[i] / (MASS * disk->omega[i]);
        rk4->per_s[i] = disk->s[i] / (MASS * disk->omega[i]);
    }
}

static void rk4_free(struct rk4 *rk4)
{
    wall_free(&rk4->wall);
    free(rk4->memory);
}

/* exp(i omega t) half a step on */
static void advance_phases(const struct rk4 *rk4, int from, int to)
{
    const double *restrict const c = rk4->cosine[from], *restrict const s = rk4->sine[from];
    double *restrict const c_to = rk4->cosine[to], *restrict const s_to = rk4->sine[to];
    for (size_t i = 0; i < rk4->disk->modes; i++) {
        c_to[i] = c[i] * rk4->half_cos[i] - s[i] * rk4->half_sin[i];
        s_to[i] = s[i] * rk4->half_cos[i] + c[i] * rk4->half_sin[i];
    }
}

/* The wall at a stage: Q = Re(q exp(-i omega t)) */
static void rk4_touch(struct rk4 *rk4, double x0, const double *re, const double *im, int phase)
{
    const struct rival_disk *const disk = rk4->disk;
    const double *const c = rk4->cosine[phase], *const s = rk4->sine[phase];
    if (rk4->form == RIVAL_RK4_UNGROUPED) {
        for (size_t i = 0; i < disk->modes; i++)
            rk4->amplitude[i] = re[i] * c[i] + im[i] * s[i];
        touch_ungrouped(disk, &rk4->wall, x0, rk4->amplitude, rk4->force_of);
        return;
    }
    for (size_t n = 0; n < disk->ns; n++) {
        double a = 0, b = 0;
        for (size_t i = disk->first[n]; i < disk->first[n + 1]; i++) {
            const double q = re[i] * c[i] + im[i] * s[i];
            a += disk->c[i] * q;
            b += disk->s[i] * q;
        }
        rk4->wall.sum_c[n] = a;
        rk4->wall.sum_s[n] = b;
    }
    wall_touch(disk, &rk4->wall, x0);
}

/* dq/dt = -(i/(m omega)) exp(i omega t) F: adds it to the sum of slopes with its weight, and goes along it from the
 * step's begin to the next stage. */
static void rk4_slope(struct rk4 *rk4, int phase, double weight, double next)
{
    const struct rival_disk *const disk = rk4->disk;
    const double *restrict const c = rk4->cosine[phase], *restrict const s = rk4->sine[phase];
    double *restrict const slope_re = rk4->slope_re, *restrict const slope_im = rk4->slope_im;
    double *restrict const stage_re = rk4->stage_re, *restrict const stage_im = rk4->stage_im;
    for (size_t n = 0; n < disk->ns; n++) {
        const double fc = rk4->wall.force_c[n], fs = rk4->wall.force_s[n];
        for (size_t i = disk->first[n]; i < disk->first[n + 1]; i++) {
            const double f = rk4->form == RIVAL_RK4_UNGROUPED ? rk4->force_of[i] / (MASS * disk->omega[i])
                                                              : rk4->per_c[i] * fc + rk4->per_s[i] * fs;
            const double re = s[i] * f, im = -c[i] * f;
            slope_re[i] += weight * re;
            slope_im[i] += weight * im;
            stage_re[i] = rk4->re[i] + next * re;
            stage_im[i] = rk4->im[i] + next * im;
        }
    }
}

static double runge_kutta(const struct rival_disk *disk, enum rival_rk4 form, double h, long *steps)
{
    struct rk4 rk4;
    rk4_init(&rk4, disk, form, h);
    const size_t bytes = disk->modes * sizeof(double);
    double x0 = rival_first_position(disk), v = disk->speed, eps = RIVAL_NO_RESULT;
    const long most = (long)(patience / (disk->speed * h));
    for (*steps = 0; *steps < most && fabs(v) < 10 * disk->speed;) {
        memcpy(rk4.cosine[0], rk4.cosine[2], bytes);
        memcpy(rk4.sine[0], rk4.sine[2], bytes);
        advance_phases(&rk4, 0, 1);
        advance_phases(&rk4, 1, 2);
        memset(rk4.slope_re, 0, bytes);
        memset(rk4.slope_im, 0, bytes);
        static const int phase[4] = {0, 1, 1, 2};
        static const double weight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}, next[4] = {0.5, 0.5, 1, 0};
        double x_stage = x0, v_stage = v, x_sum = 0, v_sum = 0;
        for (int k = 0; k < 4; k++) {
            rk4_touch(&rk4, x_stage, k ? rk4.stage_re : rk4.re, k ? rk4.stage_im : rk4.im, phase[k]);
            rk4_slope(&rk4, phase[k], weight[k], next[k] * h);
            const double acceleration = -rk4.wall.load / MASS;
            x_sum += weight[k] * v_stage;
            v_sum += weight[k] * acceleration;
            x_stage = x0 + next[k] * h * v_stage;
            v_stage = v + next[k] * h * acceleration;
        }
        x0 += h * x_sum;
        v += h * v_sum;
        for (size_t i = 0; i < disk->modes; i++) {
            rk4.re[i] += h * rk4.slope_re[i];
            rk4.im[i] += h * rk4.slope_im[i];
        }
        ++*steps;
        if (*steps % STEPS_A_LOOK == 0 && disk_is_gone(disk, x0, v, rk4.wall.load, rk4.re, rk4.im)) {
            eps = -v / disk->speed;
            break;
        }
    }
    rk4_free(&rk4);
    return eps;
}

const struct rival_build BUILD = {splitting, runge_kutta};
