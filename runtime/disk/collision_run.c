/* SPDX-License-Identifier: MIT */
#include "runtime/disk/collision_run.h"

#include <math.h>
#include <string.h>

#include "runtime/disk/collision_step.h"

/* ---- between steps: a polynomial through five moments at intervals of h ---- */

enum { MOMENTS = 5 };

/* stands for the logarithm of a zero load */
#define LOG_NO_LOAD (-1e3)

struct course {
    double depth[MOMENTS], log_load[MOMENTS]; /* in order of time */
};

/* The polynomial through five values at -2 ... 2 */
static void course_interpolate(const double f[MOMENTS], double c[MOMENTS])
{
    c[0] = f[2];
    c[1] = (8 * (f[3] - f[1]) - (f[4] - f[0])) / 12;
    c[2] = (16 * (f[1] + f[3]) - (f[0] + f[4]) - 30 * f[2]) / 24;
    c[3] = ((f[4] - f[0]) - 2 * (f[3] - f[1])) / 12;
    c[4] = ((f[0] + f[4]) - 4 * (f[1] + f[3]) + 6 * f[2]) / 24;
}

static int course_has_maximum(const double f[MOMENTS])
{
    return f[2] >= f[1] && f[2] > f[3];
}

/* The maximum of the polynomial, which is near the middle value */
static double course_maximum(const double f[MOMENTS])
{
    double c[MOMENTS], low = -1, high = 1;
    course_interpolate(f, c);
    for (int i = 0; i < 50; i++) {
        const double t = 0.5 * (low + high);
        if (c[1] + t * (2 * c[2] + t * (3 * c[3] + t * 4 * c[4])) > 0)
            low = t;
        else
            high = t;
    }
    return c[0] + low * (c[1] + low * (c[2] + low * (c[3] + low * c[4])));
}

/* The point between the middle value, 0, and the next one, 1, at which the polynomial passes `level` */
static double course_crossing(const double f[MOMENTS], double level)
{
    double c[MOMENTS], low = 0, high = 1;
    const int rises = f[3] > f[2];
    course_interpolate(f, c);
    for (int i = 0; i < 50; i++) {
        const double t = 0.5 * (low + high);
        if ((c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4]))) < level) == rises)
            low = t;
        else
            high = t;
    }
    return 0.5 * (low + high);
}

/* Adds a moment to the course, and updates the run: maxima of depth and load, start and end of the contact.
 *
 * With the wall's force F, the integrator's x is y - (h^2/12) F(y)/m, where y is the true position to order 4
 * (Numerov's method). The force of the modified potential at x is that of the true potential at y. */
static void course_follow(struct course *course, struct cor_collision_run *run, const struct cor_collision_state *now,
                          double log_threshold)
{
    const double h = run->h, *const load = course->log_load;
    memmove(course->depth, course->depth + 1, (MOMENTS - 1) * sizeof *course->depth);
    memmove(course->log_load, course->log_load + 1, (MOMENTS - 1) * sizeof *course->log_load);
    course->depth[MOMENTS - 1] = now->depth - h * h / 12 * now->force / COR_DISK_MASS;
    course->log_load[MOMENTS - 1] = now->force > 0 ? log(now->force) : LOG_NO_LOAD;
    if (run->steps < MOMENTS)
        return;
    if (course_has_maximum(course->depth))
        run->max_compression = fmax(run->max_compression, course_maximum(course->depth));
    if (course_has_maximum(load) && load[0] > LOG_NO_LOAD && load[MOMENTS - 1] > LOG_NO_LOAD)
        run->max_load = fmax(run->max_load, exp(course_maximum(load)));
    const int above = load[3] >= log_threshold;
    if (above != (load[2] >= log_threshold)) {
        const double t = now->time + h * (course_crossing(load, log_threshold) - 2);
        if (!above)
            run->end = t;
        else if (isnan(run->start))
            run->start = t;
    }
}

/* ---- averages and observers ---- */

/* Weight of a value at `time` in the integral of a piecewise linear function from start to end: the integral, over the
 * part of the interval from `time` to `time` + h between start and end, of a weight that falls from 1 at `time` to 0. h
 * may be negative. */
static double piece_weight(double time, double h, double start, double end)
{
    const double a = fmin(fmax((start - time) / h, 0), 1), b = fmin(fmax((end - time) / h, 0), 1);
    const double from = fmin(a, b), to = fmax(a, b);
    return fabs(h) * ((to - from) - 0.5 * (to * to - from * from));
}

static void add_to_average(const struct cor_motion *m, double time, double h, const struct cor_collision_run *before,
                           double *average)
{
    const double energy = 0.5 * COR_DISK_MASS * m->speed * m->speed, contact = before->end - before->start;
    const double weight =
        piece_weight(time, h, before->start, before->end) + piece_weight(time, -h, before->start, before->end);
    if (weight > 0)
        for (size_t i = 0; i < m->size.modes; i++)
            average[i] += weight / (contact * energy) * cor_collision_mode_energy(m, i);
}

/* Reports positions to order 4 (see course_follow) and velocities to order 2, halfway through the kick. */
static void report_moment(const struct cor_motion *m, const struct cor_disk_collision_detail *detail,
                          const struct cor_collision_state *now, double h)
{
    for (size_t i = 0; i < m->size.modes; i++) {
        const size_t cell = m->place[i], n = (size_t)m->mode[i].n;
        const double omega = m->mode[i].omega, unit = 1 / sqrt(COR_DISK_MASS * omega);
        const double kick = m->c[cell] * m->force_c[n] + m->s[cell] * m->force_s[n];
        if (detail->q != NULL)
            detail->q[i] = unit * (m->q[cell] + h * omega / 12 * kick);
        if (detail->q_dot != NULL)
            detail->q_dot[i] = omega * unit * (m->p[cell] + 0.5 * kick);
    }
    const double acceleration = -now->force / COR_DISK_MASS;
    const struct cor_disk_moment moment = {now->time, now->depth + h * h / 12 * acceleration - 1,
                                           now->v - 0.5 * h * acceleration, now->force, now->force / m->alpha};
    detail->observe(detail->context, &moment);
}

/* ---- the run ---- */

static void run_begin(struct cor_collision_run *run)
{
    run->steps = 0;
    run->max_load = run->ripple = run->stiffness = 0;
    run->max_compression = -INFINITY;
    run->start = run->end = NAN;
}

static int run_may_step(const struct cor_motion *m, const struct cor_collision_run *run)
{
    return run->steps < COR_DISK_COLLISION_MAX_STEPS && m->work_left > 0;
}

enum cor_collision_outcome cor_collision_run(struct cor_motion *m, struct cor_collision_run *run,
                                             const struct cor_collision_run *before, double *average,
                                             const struct cor_disk_collision_detail *detail)
{
    const double h = run->h, work_left = m->work_left;
    const int known = before != NULL && before->max_load > 0;
    const double log_threshold = known ? log(cor_tuning.contact_load * before->max_load) : INFINITY;
    struct course course;
    struct cor_collision_state now;
    memset(&course, 0, sizeof course);
    run_begin(run);
    if (average != NULL)
        memset(average, 0, m->size.modes * sizeof *average);
    if (!cor_collision_in_sight(m, h))
        return COR_RUN_TOO_LONG;
    cor_collision_approach(m, h, &now);
    /* the largest reach of a rim with a negligible load */
    const double negligible = cor_collision_negligible_load(m), clear = log(negligible / COR_PI) / m->alpha;
    for (;;) {
        if (!run_may_step(m, run))
            return COR_RUN_TOO_LONG;
        run->steps++;
        const int scan = run->steps % (size_t)cor_tuning.scan_interval == 1;
        const enum cor_collision_angles angles = run->all_angles ? COR_ALL_ANGLES : scan ? COR_SCAN : COR_WINDOW;
        cor_collision_drift(m, h, &now);
        const enum cor_collision_kick kick = cor_collision_kick(m, h, angles, &now);
        if (kick != COR_KICKED)
            return kick == COR_KICK_TOO_STIFF ? COR_RUN_TOO_STIFF : COR_RUN_TOO_NARROW;
        run->ripple = fmax(run->ripple, now.ripple);
        run->stiffness = fmax(run->stiffness, now.stiffness);
        course_follow(&course, run, &now, log_threshold);
        if (average != NULL && before != NULL)
            add_to_average(m, now.time, h, before, average);
        if (detail != NULL && detail->observe != NULL)
            report_moment(m, detail, &now, h);
        if (angles != COR_WINDOW && now.v < 0 && now.load < negligible &&
            now.depth + cor_collision_greatest_swing(m) < clear)
            break;
    }
    run->eps = -now.v / m->speed;
    run->contact_time = run->end - run->start;
    run->work = work_left - m->work_left;
    return COR_RUN_ENDED;
}
