/* SPDX-License-Identifier: MIT */
/* The Hamiltonian is the sum of free motion and the wall. Free motion is solved exactly: every mode turns and the
 * centre drifts. A step is a kick of the wall between two halves of free motion. In the kick,
 *
 *     V - (h^2/24) |grad V|^2/m                                                       (Takahashi and Imada, 1984)
 *
 * replaces the potential V of the wall. This costs one more passage from the rim to the modes and back, but no second
 * exponential. Two successive halves of free motion are one drift. */
#include "runtime/disk/collision_parts.h"

#include <math.h>

/* Returns the load of the wall that is negligible before and after the contact. */
static double negligible_load(const struct cor_motion *m)
{
    return COR_TUNING_WALL_LEFT * fmin(m->tolerance, COR_TUNING_WALL_TOLERANCE) * 0.5 * COR_DISK_MASS * m->speed *
           m->speed * m->alpha;
}

/* Loads below this value lose digits to underflow. */
#define LEAST_LOAD 1e-290

/* ---- the wall's force ---- */

/* Computes reach and pressure at the first `points` angles from sum_c and sum_s; returns the load. */
static double rim_load(struct cor_motion *m, double depth, size_t points)
{
    m->loops->gather(&m->rim, m->sum_c, m->sum_s, m->d);
    m->loops->reach(&m->rim, points, depth, m->shape, m->d, m->reach);
    return m->loops->press(points, m->alpha, m->weight, m->reach, m->pressure);
}

/* Returns the number of angles, in whole panels, up to the last pressure above COR_TUNING_WINDOW_EDGE times the
 * peak. */
static size_t window_of(const struct cor_motion *m)
{
    double peak = 0;
    size_t last = 0;
    for (size_t j = 0; j < m->phi; j++)
        peak = fmax(peak, m->pressure[j]);
    for (size_t j = 0; j < m->phi; j++)
        if (m->pressure[j] > COR_TUNING_WINDOW_EDGE * peak)
            last = j;
    return (last / COR_PANEL + 1) * COR_PANEL;
}

/* Returns the change of the load if only every second angle is used. */
static double ripple_of(const struct cor_motion *m)
{
    double even = 0, odd = 0;
    for (size_t j = 0; j < m->rim.points; j += 2) {
        even += m->pressure[j];
        odd += m->pressure[j + 1];
    }
    return fabs(even - odd);
}

/* True if, after a scan, a window that ended at `window` has omitted a significant pressure. */
static int window_missed(const struct cor_motion *m, size_t window, double load)
{
    for (size_t j = window; j < m->rim.points; j++)
        if (m->pressure[j] > COR_TUNING_WINDOW_MISSED * load)
            return 1;
    return 0;
}

/* Replaces the pressure in the window by the pressure of the modified potential, pressure (1 - (h^2/12) alpha a) with
 * the rim's acceleration a, (15.1). Sets e to the moments of the new pressure. Returns the new force. */
static double rim_soften(struct cor_motion *m, double h, double load, size_t window, double *stiffness)
{
    double fastest, *const sum_c = m->force_c, *const sum_s = m->force_s;
    m->loops->transform(&m->rim, window, m->pressure, m->e);
    m->loops->split(&m->rim, 1, m->e, m->force_c, m->force_s);
    for (size_t n = 0; n < m->rim.blocks * COR_LANES; n++) {
        const double force_c = m->force_c[n], force_s = m->force_s[n];
        sum_c[n] = m->cc[n] * force_c + m->cs[n] * force_s;
        sum_s[n] = m->cs[n] * force_c + m->ss[n] * force_s;
    }
    m->loops->gather(&m->rim, sum_c, sum_s, m->d);
    m->loops->reach(&m->rim, window, load / COR_DISK_MASS, m->flat, m->d, m->response);
    const double force = m->loops->soften(window, h * h * m->alpha / 12, m->response, m->pressure, &fastest);
    *stiffness = h * h * m->alpha * fastest;
    m->loops->transform(&m->rim, window, m->pressure, m->e);
    return force;
}

/* ---- a step ---- */

void cor_collision_drift(struct cor_motion *m, double h, struct cor_collision_state *now)
{
    m->loops->turn(&m->rim, m->q, m->p, m->cosine, m->sine, m->force_c, m->force_s, m->sum_c, m->sum_s);
    now->depth += h * now->v;
    now->time += h;
}

enum cor_collision_outcome cor_collision_kick(struct cor_motion *m, double h, enum cor_collision_angles angles,
                                              struct cor_collision_state *now)
{
    const double negligible = negligible_load(m);
    const size_t reached = angles == COR_WINDOW ? now->window : m->rim.points;
    now->force = now->stiffness = 0;
    now->load = rim_load(m, now->depth, reached);
    /* the rim accelerates at least as much as the centre */
    if (!(h * h * m->alpha / COR_DISK_MASS * now->load < COR_TUNING_MAX_STIFFNESS))
        return COR_RUN_TOO_STIFF;
    COR_CLEAR_DOUBLES(m->size.blocks * COR_LANES, m->force_c, m->force_s);
    if (angles != COR_WINDOW) {
        const size_t window = now->window;
        now->ripple = ripple_of(m);
        now->window = window_of(m);
        if (angles == COR_SCAN && window_missed(m, window, fmax(now->load, negligible)))
            return COR_RUN_TOO_NARROW;
    }
    if (now->load > COR_TUNING_NO_LOAD * negligible) {
        now->force = rim_soften(m, h, now->load, now->window, &now->stiffness);
        if (!(now->stiffness < COR_TUNING_MAX_STIFFNESS))
            return COR_RUN_TOO_STIFF;
        m->loops->split(&m->rim, -h, m->e, m->force_c, m->force_s);
    }
    now->v -= h * now->force / COR_DISK_MASS;
    m->work_left -= m->work_per_step > 0 ? m->work_per_step : cor_motion_work(m, reached, now->window);
    return COR_RUN_ENDED;
}

/* ---- the first moment ---- */

/* Returns alpha (x_0 + 1) at the first moment. The load of a disk that keeps its shape, sqrt(2 pi/alpha)
 * exp(alpha (x_0 + 1)), is then negligible. */
static double first_exponent(const struct cor_motion *m)
{
    return log(negligible_load(m) * sqrt(m->alpha / (2 * COR_PI)));
}

/* False if the negligible load underflows, or if COR_DISK_COLLISION_MAX_STEPS steps of h are certainly too few. */
static int in_sight(const struct cor_motion *m, double h)
{
    /* a collision lasts at least twice the time from the first moment to the touch */
    return negligible_load(m) > LEAST_LOAD &&
           -2 * first_exponent(m) <= h * COR_DISK_COLLISION_MAX_STEPS * (m->alpha * m->speed);
}

static void modes_at_rest(struct cor_motion *m, double h)
{
    const size_t lanes = m->size.blocks * COR_LANES;
    COR_CLEAR_DOUBLES(m->size.cells, m->q, m->p, m->cosine, m->sine);
    COR_CLEAR_DOUBLES(lanes, m->force_c, m->force_s, m->sum_c, m->sum_s);
    COR_CLEAR_DOUBLES(m->size.terms + lanes, m->e);
    for (size_t i = 0; i < m->size.modes; i++) {
        m->cosine[m->place[i]] = cos(m->mode[i].omega * h);
        m->sine[m->place[i]] = sin(m->mode[i].omega * h);
    }
}

/* Sets the first moment. The wall's force grows like exp(sigma t), sigma = alpha v, so Q'' + omega^2 Q = F/m gives Q =
 * F/(m (omega^2 + sigma^2)). The kinetic energy of the centre is smaller by the energy of the wall. Only the second
 * half of the first kick is applied: the first half is before this moment. */
void cor_collision_approach(struct cor_motion *m, double h, struct cor_collision_state *now)
{
    const double sigma = m->alpha * m->speed, energy = 0.5 * COR_DISK_MASS * m->speed * m->speed;
    const struct cor_collision_state first = {first_exponent(m) / sigma, m->speed, 0, 0, 0, 0, 0, m->rim.points};
    *now = first;
    modes_at_rest(m, h);
    now->depth = m->speed * now->time;
    now->load = rim_load(m, now->depth, m->rim.points);
    m->loops->transform(&m->rim, m->rim.points, m->pressure, m->e);
    m->loops->split(&m->rim, -1, m->e, m->force_c, m->force_s);
    for (size_t i = 0; i < m->size.modes; i++) {
        const size_t cell = m->place[i], n = (size_t)m->mode[i].n;
        const double omega = m->mode[i].omega;
        const double force = m->c[cell] * m->force_c[n] + m->s[cell] * m->force_s[n];
        m->q[cell] = omega * force / (omega * omega + sigma * sigma);
        m->p[cell] = sigma / omega * m->q[cell];
    }
    m->loops->split(&m->rim, -0.5 * h, m->e, m->force_c, m->force_s);
    now->v = m->speed * sqrt(1 - now->load / (m->alpha * energy)) - 0.5 * h * now->load / COR_DISK_MASS;
}

/* ---- modes ---- */

double cor_collision_mode_energy(const struct cor_motion *m, size_t i)
{
    const size_t cell = m->place[i], n = (size_t)m->mode[i].n;
    const double q = m->q[cell];
    const double p = m->p[cell] + 0.5 * (m->c[cell] * m->force_c[n] + m->s[cell] * m->force_s[n]);
    return 0.5 * m->mode[i].omega * (q * q + p * p);
}

/* Returns the largest displacement of any part of the rim from its round shape in free motion. */
static double greatest_swing(const struct cor_motion *m)
{
    double swing = 0;
    for (size_t i = 0; i < m->size.cells; i++)
        swing += fmax(fabs(m->c[i]), fabs(m->s[i])) * sqrt(m->q[i] * m->q[i] + m->p[i] * m->p[i]);
    return swing;
}

/* ---- between steps: a polynomial through five moments at intervals of h ---- */

enum { MOMENTS = 5 };

/* used as the logarithm of a zero load */
#define LOG_NO_LOAD (-1e3)

struct course {
    double depth[MOMENTS], log_load[MOMENTS]; /* in order of time */
};

/* Computes the polynomial through five values at -2 ... 2. */
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

/* Bisects the interval in which a polynomial passes `level`. */
static void course_bisect(const double c[MOMENTS], double level, int rises, double *low, double *high)
{
    for (int i = 0; i < 50; i++) {
        const double t = 0.5 * (*low + *high);
        const int below = c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4]))) < level;
        *(below == rises ? low : high) = t;
    }
}

/* Returns the maximum of the polynomial, which is near the middle value. */
static double course_maximum(const double f[MOMENTS])
{
    double c[MOMENTS], t = -1, high = 1;
    course_interpolate(f, c);
    const double falls[MOMENTS] = {-c[1], -2 * c[2], -3 * c[3], -4 * c[4], 0};
    course_bisect(falls, 0, 1, &t, &high);
    return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4])));
}

/* Returns the place between 0 (middle value) and 1 (next value) at which the polynomial passes `level`. */
static double course_crossing(const double f[MOMENTS], double level)
{
    double c[MOMENTS], low = 0, high = 1;
    course_interpolate(f, c);
    course_bisect(c, level, f[3] > f[2], &low, &high);
    return 0.5 * (low + high);
}

/* Adds a moment to *course, and updates the run: maxima of depth and load, start and end of the contact.
 *
 * With the wall's force F, the integrator's x is y - (h^2/12) F(y)/m, where y is the true position to order 4
 * (Numerov's method). The force of the modified potential at x equals the force of the true potential at y. */
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

/* Returns the weight of the value at `time` in the integral of a piecewise linear function from start to end. It is the
 * integral of a ramp from 1 at `time` to 0 at `time` + h, restricted to start ... end. h may be negative. */
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

enum cor_collision_outcome cor_collision_run(struct cor_motion *m, struct cor_collision_run *run,
                                             const struct cor_collision_run *before, double *average,
                                             const struct cor_disk_collision_detail *detail)
{
    const double h = run->h, work_left = m->work_left;
    const int known = before != NULL && before->max_load > 0;
    const double log_threshold = known ? log(COR_TUNING_CONTACT_LOAD * before->max_load) : INFINITY;
    struct course course = {{0}, {0}};
    struct cor_collision_state now;
    run->steps = 0;
    run->max_load = run->ripple = run->stiffness = 0;
    run->max_compression = -INFINITY;
    run->start = run->end = NAN;
    if (average != NULL)
        memset(average, 0, m->size.modes * sizeof *average);
    if (!in_sight(m, h))
        return COR_RUN_TOO_LONG;
    cor_collision_approach(m, h, &now);
    /* the largest reach of a rim with a negligible load */
    const double negligible = negligible_load(m),
                 clear = negligible > 0 ? log(negligible / COR_PI) / m->alpha : -INFINITY;
    for (;;) {
        if (!(run->steps < COR_DISK_COLLISION_MAX_STEPS && m->work_left > 0))
            return COR_RUN_TOO_LONG;
        run->steps++;
        const int scan = run->steps % (size_t)COR_TUNING_SCAN_INTERVAL == 1;
        const enum cor_collision_angles angles = run->all_angles ? COR_ALL_ANGLES : scan ? COR_SCAN : COR_WINDOW;
        cor_collision_drift(m, h, &now);
        const enum cor_collision_outcome kick = cor_collision_kick(m, h, angles, &now);
        if (kick != COR_RUN_ENDED)
            return kick;
        run->ripple = fmax(run->ripple, now.ripple);
        run->stiffness = fmax(run->stiffness, now.stiffness);
        course_follow(&course, run, &now, log_threshold);
        if (average != NULL && before != NULL)
            add_to_average(m, now.time, h, before, average);
        if (detail != NULL && detail->observe != NULL)
            report_moment(m, detail, &now, h);
        if (angles != COR_WINDOW && now.v < 0 && now.load < negligible && now.depth + greatest_swing(m) < clear)
            break;
    }
    run->eps = -now.v / m->speed;
    run->contact_time = run->end - run->start;
    run->work = work_left < INFINITY ? work_left - m->work_left : 0;
    return COR_RUN_ENDED;
}
