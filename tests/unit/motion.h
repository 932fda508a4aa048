/* SPDX-License-Identifier: MIT */
/* Motions by another route than the library's, in long double: the classical method of Runge and Kutta, and the course
 * of a contact by it. */
#ifndef COR_TESTS_MOTION_H
#define COR_TESTS_MOTION_H

#include <math.h>
#include <string.h>

enum { MOTION_MOST = 11 };

typedef void motion_slopes(long double *slope, const long double *y, const void *of);
typedef long double motion_value(const long double *y, const void *of);

static inline void runge_kutta(motion_slopes *slopes, const void *of, long double *y, int n, long double h)
{
    long double k[4][MOTION_MOST], at[MOTION_MOST];
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < n; j++)
            at[j] = i == 0 ? y[j] : y[j] + (i == 3 ? h : h / 2) * k[i - 1][j];
        slopes(k[i], at, of);
    }
    for (int j = 0; j < n; j++)
        y[j] += h / 6 * (k[0][j] + 2 * k[1][j] + 2 * k[2][j] + k[3][j]);
}

/* A step of h, or of the part of it after which a value is 0 or just below; whether it is */
static inline int runge_kutta_until(motion_value *value, motion_slopes *slopes, const void *of, long double *y, int n,
                                    long double h)
{
    long double next[MOTION_MOST], low = 0, high = h;
    const size_t size = (size_t)n * sizeof *y;
    memcpy(next, y, size);
    runge_kutta(slopes, of, next, n, h);
    const int ends = !(value(next, of) > 0);
    for (int i = 0; i < 60 && ends; i++) {
        const long double middle = (low + high) / 2;
        memcpy(next, y, size);
        runge_kutta(slopes, of, next, n, middle);
        *(value(next, of) > 0 ? &low : &high) = middle;
    }
    runge_kutta(slopes, of, y, n, high);
    return ends;
}

/* A contact in units of its mass and impact speed: x'' = press - force, x = w^d, y = {w, x', t} by dt = d w^(d-1) ds,
 * in which powers of x by 1/d are smooth */
struct motion {
    int d;
    long double press;
    long double (*force)(long double w, long double v, const void *of);
    const void *of;
    int at_zero_force;  /* it ends there, and may creep without an end otherwise */
    motion_value *kink; /* NULL, or a value that falls to 0 where the force has a kink: a step ends there */
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

struct motion_course {
    /* At zero overlap, and at zero force or, with a constant force, back at the surface; 0 and infinity: the bodies
     * stay together */
    long double eps[2], duration[2];
    long double max_overlap, time_of_max_overlap, force_max; /* the force at the steps */
};

/* Bodies that have turned twice stay together. */
static inline struct motion_course motion_course(const struct motion *m, long double h)
{
    struct motion_course r = {{0, 0}, {HUGE_VALL, HUGE_VALL}, 0, 0, 0};
    long double y[3] = {0, 1, 0}, next[3], at[3];
    int released = 0;
    for (long k = 0; k < 1000000; k++, memcpy(y, next, sizeof y)) {
        const long double force = motion_force(y, m);
        memcpy(next, y, sizeof y);
        memcpy(at, y, sizeof y);
        runge_kutta(motion_contact, m, next, 3, h);
        r.force_max = fmaxl(r.force_max, force);
        if (m->kink && m->kink(y, m) > 0 && m->kink(next, m) <= 0) {
            memcpy(next, y, sizeof y);
            runge_kutta_until(m->kink, motion_contact, m, next, 3, h);
        }
        if (y[1] > 0 && next[1] <= 0) {
            if (r.max_overlap > 0)
                return r;
            runge_kutta_until(motion_speed, motion_contact, m, at, 3, h);
            r.max_overlap = motion_power(at[0], m->d);
            r.time_of_max_overlap = at[2];
            memcpy(next, at, sizeof y); /* where a force may change with the direction */
        }
        if (k > 0 && !released && force > 0 && motion_force(next, m) <= 0) {
            memcpy(at, y, sizeof y);
            runge_kutta_until(motion_force, motion_contact, m, at, 3, h);
            const long double left = at[1] * at[1] - 2 * m->press * motion_power(at[0], m->d);
            released = 1;
            if (left > 0) {
                r.eps[1] = sqrtl(left);
                r.duration[1] = at[2] - (m->press > 0 ? (at[1] + r.eps[1]) / m->press : 0);
            }
            if (m->at_zero_force)
                return r;
        }
        if (k > 0 && next[0] <= 0) {
            memcpy(at, y, sizeof y);
            runge_kutta_until(motion_overlap, motion_contact, m, at, 3, h);
            r.eps[0] = -at[1];
            r.duration[0] = at[2];
            if (!released) { /* a force that is 0 at zero overlap alone */
                r.eps[1] = r.eps[0];
                r.duration[1] = at[2];
            }
            return r;
        }
    }
    return r;
}

#endif
