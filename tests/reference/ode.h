/* SPDX-License-Identifier: MIT */
/* Integrates motions in long double, independently of library and generator, and gives the results of a contact. Uses
 * Gragg's method with extrapolation (Bulirsch and Stoer), and steps that end where a value falls to zero. */
#ifndef COR_TESTS_REFERENCE_ODE_H
#define COR_TESTS_REFERENCE_ODE_H

#include <float.h>
#include <math.h>
#include <string.h>

enum { ODE_MOST = 11, ODE_ROWS = 6 };

typedef void ode_slopes(long double *slope, const long double *y, const void *of);
typedef long double ode_value(const long double *y, const void *of);

/* y' = slopes(y), n components. longest: the longest step. error: per step, relative to |y| + |h y'| for each
 * component; 0 means 1e-18. h: the length of the next step; 0 means the longest. */
struct ode {
    ode_slopes *slopes;
    const void *of;
    int n;
    long double longest, error, h;
};

/* Computes y after a step of h, and returns its error divided by the allowed error. The table contains changes of y,
 * which have smaller rounding errors than y. Row k: 2 (k + 1) substeps. */
static inline long double ode_try(const struct ode *o, const long double *y, long double h, long double *next)
{
    long double table[ODE_ROWS][ODE_MOST], slope[ODE_MOST], first[ODE_MOST], before[ODE_MOST], change[ODE_MOST];
    long double worst = 0;
    o->slopes(first, y, o->of);
    for (int k = 0; k < ODE_ROWS; k++) {
        const int parts = 2 * (k + 1);
        const long double part = h / parts;
        for (int j = 0; j < o->n; j++) {
            before[j] = 0;
            change[j] = part * first[j];
        }
        for (int i = 1; i <= parts; i++) {
            for (int j = 0; j < o->n; j++)
                next[j] = y[j] + change[j];
            o->slopes(slope, next, o->of);
            for (int j = 0; j < o->n; j++) {
                const long double here = change[j];
                change[j] = i < parts ? before[j] + 2 * part * slope[j] : (before[j] + here + part * slope[j]) / 2;
                before[j] = here;
            }
        }
        for (int j = 0; j < o->n; j++) { /* Neville's scheme in part^2 */
            table[k][j] = change[j];
            for (int m = k - 1; m >= 0; m--) {
                const long double ratio = (long double)(k + 1) / (m + 1);
                table[m][j] = table[m + 1][j] + (table[m + 1][j] - table[m][j]) / (ratio * ratio - 1);
            }
        }
    }
    for (int j = 0; j < o->n; j++) {
        const long double size = fabsl(y[j]) + fabsl(h * first[j]) + LDBL_MIN, off = fabsl(table[0][j] - table[1][j]);
        worst = fmaxl(worst, off / size);
        next[j] = y[j] + table[0][j];
    }
    return worst / (o->error > 0 ? o->error : 1e-18L);
}

/* Makes the longest step from y to `next` within the error. most: its maximal length. Returns its length. */
static inline long double ode_step(struct ode *o, const long double *y, long double most, long double *next)
{
    const long double power = -1.0L / (2 * ODE_ROWS - 1);
    for (;;) {
        const long double h = fminl(o->h > 0 ? o->h : o->longest, most), error = ode_try(o, y, h, next);
        const long double change = 0.9L * powl(fmaxl(error, 1e-12L), power);
        if (error <= 1 || h < 1e-15L * o->longest) {
            o->h = h < most ? fminl(fminl(change, 4) * h, o->longest) : o->h;
            return h;
        }
        o->h = fmaxl(change, 0.1L) * h;
    }
}

static inline void ode_advance(struct ode *o, long double *y, long double length)
{
    long double next[ODE_MOST];
    for (long double left = length; left > 0; memcpy(y, next, sizeof *y * (size_t)o->n))
        left -= ode_step(o, y, left, next);
}

/* Makes a step, which ends early where the first of some positive values falls to 0 or just below. Returns the index of
 * this value (the least index if several fall together), or -1 after a whole step. */
static inline int ode_until(struct ode *o, long double *y, ode_value *const *value, int values)
{
    const size_t size = sizeof *y * (size_t)o->n;
    long double next[ODE_MOST], at[ODE_MOST], last[ODE_MOST], length = ode_step(o, y, o->longest, next);
    int found = -1;
    for (int i = 0; i < values; i++) {
        long double low = 0, high = length, above = value[i](y, o->of), below = value[i](next, o->of);
        if (i == found || !(above > 0) || below > 0)
            continue;
        memcpy(last, next, size);
        for (int k = 0, side = 0; k < 80 && high - low > 2 * LDBL_EPSILON * high && below < 0; k++) { /* Illinois */
            long double middle = k % 8 == 7 ? (low + high) / 2 : low + (high - low) * (above / (above - below));
            middle = fminl(fmaxl(middle, low + 0.01L * (high - low) * (k % 3 == 2)), high);
            ode_try(o, y, middle, at);
            const long double f = value[i](at, o->of);
            if (f > 0) {
                low = middle;
                above = f;
                below *= side == 1 ? 0.5L : 1;
            } else {
                high = middle;
                below = f;
                memcpy(last, at, size);
                above *= side == -1 ? 0.5L : 1;
            }
            side = f > 0 ? 1 : -1;
        }
        if (found < 0 || high < length * (1 - 1e-15L)) {
            found = i;
            length = high;
            memcpy(next, last, size);
            i = -1; /* repeat the search: another value may reach zero earlier */
        }
    }
    memcpy(y, next, size);
    return found;
}

/* ---- a contact ---- */

/* A contact in units of its mass and impact speed: x'' = press - force, x = w^d. With dt = d w^(d-1) ds, y = {w, x', t}
 * is smooth although exponents of x are fractions with the denominator d. A force may have kinks. */
struct motion {
    int d;
    long double press;
    long double (*force)(long double w, long double v, const void *of);
    const void *of;
    int at_zero_force; /* the motion ends at zero force; otherwise it may have no end */
    long double error; /* error per step; 0 means 1e-18, which is too small for a force in doubles */
};

static inline long double motion_power(long double x, int n)
{
    long double y = 1;
    for (int i = 0; i < n; i++)
        y *= x;
    return y;
}

static inline void motion_contact(long double *slope, const long double *y, const void *of)
{
    const struct motion *const m = of;
    slope[0] = y[1];
    slope[2] = m->d * motion_power(y[0], m->d - 1);
    slope[1] = slope[2] * (m->press - m->force(y[0], y[1], m->of));
}

static inline long double motion_overlap(const long double *y, const void *of)
{
    (void)of;
    return y[0];
}

static inline long double motion_speed(const long double *y, const void *of)
{
    (void)of;
    return y[1];
}

static inline long double motion_force(const long double *y, const void *of)
{
    const struct motion *const m = of;
    return m->force(y[0], y[1], m->of);
}

/* Returns the change of the force over a tiny step along the motion, which is 0 at a peak. */
static inline long double motion_rise(const long double *y, const void *of)
{
    long double slope[3];
    motion_contact(slope, y, of);
    const long double step = 1e-7L / (fabsl(slope[0]) + fabsl(slope[1]) + 1),
                      later[] = {y[0] + step * slope[0], y[1] + step * slope[1]};
    return motion_force(later, of) - motion_force(y, of);
}

struct motion_course {
    /* Index 0: at zero overlap. Index 1: at zero force or, under a constant force, at the surface. eps is 0 and the
     * duration infinite if the bodies stay together. */
    long double eps[2], duration[2];
    long double max_overlap, time_of_max_overlap, force_max;
};

/* Computes the results of a contact. Bodies that have turned twice stay together. */
static inline struct motion_course motion_course(const struct motion *m)
{
    enum { OVERLAP, FORCE, SPEED, RISE, VALUES, STEPS = 4000 };
    static ode_value *const value[VALUES] = {motion_overlap, motion_force, motion_speed, motion_rise};
    struct motion_course r = {{0, 0}, {HUGE_VALL, HUGE_VALL}, 0, 0, 0};
    struct ode o = {.slopes = motion_contact, .of = m, .n = 3, .longest = 0.2L, .error = m->error};
    long double y[3] = {0, 1, 0};
    int released = 0;
    for (int k = 0; k < STEPS; k++) {
        r.force_max = fmaxl(r.force_max, motion_force(y, m));
        const int ends = ode_until(&o, y, value, VALUES);
        if (ends == SPEED && r.max_overlap > 0)
            return r;
        if (ends == SPEED) {
            r.max_overlap = motion_power(y[0], m->d);
            r.time_of_max_overlap = y[2];
        }
        if (ends == FORCE && !released) {
            const long double left = y[1] * y[1] - 2 * m->press * motion_power(y[0], m->d);
            released = 1;
            if (left > 0) {
                r.eps[1] = sqrtl(left);
                r.duration[1] = y[2] - (m->press > 0 ? (y[1] + r.eps[1]) / m->press : 0);
            }
            if (m->at_zero_force)
                return r;
        }
        if (ends == OVERLAP) {
            r.eps[0] = -y[1];
            r.duration[0] = y[2];
            if (!released) { /* the force is 0 only at zero overlap */
                r.eps[1] = r.eps[0];
                r.duration[1] = y[2];
            }
            return r;
        }
    }
    return r;
}

#endif
