/* SPDX-License-Identifier: MIT */
/* The Hamiltonian is that of free motion plus the wall. Free motion is solved exactly: every mode turns and the centre
 * drifts. A step is a kick of the wall between two halves of free motion. In the kick,
 *
 *     V - (h^2/24) |grad V|^2/m                                                       (Takahashi and Imada, 1984)
 *
 * replaces the potential V of the wall. This costs one more passage from the rim to the modes and back, but no second
 * exponential. Two successive halves of free motion are one drift. */
#include "runtime/disk/collision_step.h"

#include <math.h>
#include <string.h>

double cor_collision_negligible_load(const struct cor_motion *m)
{
    return cor_tuning.wall_left * fmin(m->tolerance, cor_tuning.wall_tolerance) * 0.5 * COR_DISK_MASS * m->speed *
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

/* Number of angles, in whole panels, up to the last one whose pressure exceeds window_edge times the peak */
static size_t window_of(const struct cor_motion *m)
{
    double peak = 0;
    size_t last = 0;
    for (size_t j = 0; j < m->phi; j++)
        peak = fmax(peak, m->pressure[j]);
    for (size_t j = 0; j < m->phi; j++)
        if (m->pressure[j] > cor_tuning.window_edge * peak)
            last = j;
    return (last / COR_PANEL + 1) * COR_PANEL;
}

/* Change of the load with half the angles */
static double ripple_of(const struct cor_motion *m)
{
    double even = 0, odd = 0;
    for (size_t j = 0; j < m->rim.points; j += 2) {
        even += m->pressure[j];
        odd += m->pressure[j + 1];
    }
    return fabs(even - odd);
}

/* Whether, after a scan, a window that ended at `window` has omitted a significant pressure */
static int window_missed(const struct cor_motion *m, size_t window, double load)
{
    for (size_t j = window; j < m->rim.points; j++)
        if (m->pressure[j] > cor_tuning.window_missed * load)
            return 1;
    return 0;
}

/* Replaces the pressure in the window by that of the modified potential, pressure (1 - (h^2/12) alpha a) with the rim's
 * acceleration a, (15.1), and sets its moments e; returns its force. */
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

enum cor_collision_kick cor_collision_kick(struct cor_motion *m, double h, enum cor_collision_angles angles,
                                           struct cor_collision_state *now)
{
    const double negligible = cor_collision_negligible_load(m);
    const size_t reached = angles == COR_WINDOW ? now->window : m->rim.points;
    now->force = now->stiffness = 0;
    now->load = rim_load(m, now->depth, reached);
    /* the rim accelerates at least as much as the centre */
    if (!(h * h * m->alpha / COR_DISK_MASS * now->load < cor_tuning.max_stiffness))
        return COR_KICK_TOO_STIFF;
    memset(m->force_c, 0, m->size.blocks * COR_LANES * sizeof *m->force_c);
    memset(m->force_s, 0, m->size.blocks * COR_LANES * sizeof *m->force_s);
    if (angles != COR_WINDOW) {
        const size_t window = now->window;
        now->ripple = ripple_of(m);
        now->window = window_of(m);
        if (angles == COR_SCAN && window_missed(m, window, fmax(now->load, negligible)))
            return COR_KICK_TOO_NARROW;
    }
    if (now->load > cor_tuning.no_load * negligible) {
        now->force = rim_soften(m, h, now->load, now->window, &now->stiffness);
        if (!(now->stiffness < cor_tuning.max_stiffness))
            return COR_KICK_TOO_STIFF;
        m->loops->split(&m->rim, -h, m->e, m->force_c, m->force_s);
    }
    now->v -= h * now->force / COR_DISK_MASS;
    m->work_left -= m->work_per_step > 0 ? m->work_per_step : cor_motion_work(m, reached, now->window);
    return COR_KICKED;
}

/* ---- the first moment ---- */

/* alpha (x_0 + 1) at the first moment, at which the load sqrt(2 pi/alpha) exp(alpha (x_0 + 1)) of a disk that keeps its
 * shape is negligible */
static double first_exponent(const struct cor_motion *m)
{
    return log(cor_collision_negligible_load(m) * sqrt(m->alpha / (2 * COR_PI)));
}

int cor_collision_in_sight(const struct cor_motion *m, double h)
{
    /* the way to the wall and back takes at least twice as long */
    return cor_collision_negligible_load(m) > LEAST_LOAD &&
           -2 * first_exponent(m) <= h * COR_DISK_COLLISION_MAX_STEPS * (m->alpha * m->speed);
}

static void modes_at_rest(struct cor_motion *m, double h)
{
    const size_t cells = m->size.cells, lanes = m->size.blocks * COR_LANES;
    memset(m->q, 0, cells * sizeof *m->q);
    memset(m->p, 0, cells * sizeof *m->p);
    memset(m->cosine, 0, cells * sizeof *m->cosine);
    memset(m->sine, 0, cells * sizeof *m->sine);
    for (size_t i = 0; i < m->size.modes; i++) {
        m->cosine[m->place[i]] = cos(m->mode[i].omega * h);
        m->sine[m->place[i]] = sin(m->mode[i].omega * h);
    }
    memset(m->force_c, 0, lanes * sizeof *m->force_c);
    memset(m->force_s, 0, lanes * sizeof *m->force_s);
    memset(m->e, 0, (m->size.terms + lanes) * sizeof *m->e);
    memset(m->sum_c, 0, lanes * sizeof *m->sum_c);
    memset(m->sum_s, 0, lanes * sizeof *m->sum_s);
}

/* The wall's force grows like exp(sigma t), sigma = alpha v: Q'' + omega^2 Q = F/m gives Q = F/(m (omega^2 + sigma^2)),
 * and the centre has lost the wall's energy. The first half of the kick at this moment precedes it. */
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

double cor_collision_greatest_swing(const struct cor_motion *m)
{
    double swing = 0;
    for (size_t i = 0; i < m->size.cells; i++)
        swing += fmax(fabs(m->c[i]), fabs(m->s[i])) * sqrt(m->q[i] * m->q[i] + m->p[i] * m->p[i]);
    return swing;
}
