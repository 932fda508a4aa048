/* SPDX-License-Identifier: MIT */
/* Collisions as motions with polynomial coefficients, by Taylor series:
 *
 *     du/ds = v,     dv/ds = -T(u) (F - press),     F = E(u) + damper u^b v,     dt/ds = T(u)
 *
 * u is a function of the overlap, and v the velocity; T and E are sums of two terms. Beside it parts that files of this
 * folder share: whole powers, and roots of falling functions */
#ifndef COR_RUNTIME_SCENE_MOTION_H
#define COR_RUNTIME_SCENE_MOTION_H

#include <math.h>

#include "cor/scene.h"

/* A collision in the units of its function. eps = 0 and an infinite duration: the bodies stay together. */
struct cor_full_impact {
    double eps[COR_SCENE_ENDS], duration[COR_SCENE_ENDS], max_overlap, force_max;
};

static inline double whole_power(double x, int n)
{
    double y = 1;
    for (; n > 0; n /= 2, x *= x)
        y *= n % 2 ? x : 1;
    return y;
}

/* Where a falling function vanishes, by the Illinois method; all 0 at first */
struct bracket {
    double low, high, above, below, last;
};

static inline int is_bracketed(const struct bracket *b)
{
    return b->above > 0 && b->below < 0;
}

/* Takes the value at x. Returns the next place, which is `otherwise` while all values have one sign. */
static inline double next_place(struct bracket *b, double x, double value, double otherwise)
{
    if (value > 0) {
        b->below *= b->last > 0 ? 0.5 : 1;
        b->low = x;
        b->above = value;
    } else {
        b->above *= b->last < 0 ? 0.5 : 1;
        b->high = x;
        b->below = value;
    }
    b->last = value;
    return is_bracketed(b) ? (b->low * b->below - b->high * b->above) / (b->below - b->above) : otherwise;
}

/* ---- motions ---- */

enum { MOTION_ORDER = 24, MOTION_MOST_STEPS = 100000, MOTION_POWERS = 64 };

/* A power of u, the product of two others; powers 0 and 1 come first */
struct motion_power {
    int exponent, left, right;
    double c[MOTION_ORDER + 1];
};

struct motion_term {
    double factor;
    int exponent, power; /* power: set by cor_motion_init */
};

/* One step: coefficients in s, which is at most `step` */
struct motion {
    struct motion_term time[2], spring[2], damper;
    double press;
    int powers;
    struct motion_power power[MOTION_POWERS];
    double v[MOTION_ORDER + 1], t[MOTION_ORDER + 1], force[MOTION_ORDER + 1];
    double step;
};

/* Sets the powers of the terms, and the start u, v at t = 0. Returns 0 where the exponents need too many powers. */
int cor_motion_init(struct motion *m, double u, double v);

/* Fills the coefficients from u, v and t at s = 0, and the longest step at which the last ones do not matter. */
void cor_motion_expand(struct motion *m);
/* The end of the step becomes the start of the next one. */
void cor_motion_advance(struct motion *m);

/* Follows the motion to the turning point, where the next step begins, or to a step from which on F falls and `rests`
 * is true. *force_max: the largest F on the way. Returns 0 where it takes too many steps. */
int cor_motion_compress(struct motion *m, double *force_max, int (*rests)(const struct motion *m));

/* Functions of the place in a step, and where one falls to zero between two places */
typedef double motion_function(const struct motion *m, double s, double level);
motion_function cor_motion_u, cor_motion_v; /* less the level */
double cor_motion_t(const struct motion *m, double s);
double cor_motion_root(const struct motion *m, motion_function *f, double low, double high, double level);

static inline double cor_motion_start(const struct motion *m)
{
    return m->power[1].c[0];
}

#endif
