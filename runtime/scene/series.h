/* SPDX-License-Identifier: MIT */
/* Numerical parts that files of this folder share: motions by Taylor series, powers, roots */
#ifndef COR_RUNTIME_SCENE_SERIES_H
#define COR_RUNTIME_SCENE_SERIES_H

#include <float.h>
#include <math.h>

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

enum { SERIES_ORDER = 24, SERIES_MOST_STEPS = 100000 };

static inline double series_at(const double *c, double s)
{
    double y = c[SERIES_ORDER];
    for (int n = SERIES_ORDER - 1; n >= 0; n--)
        y = y * s + c[n];
    return y;
}

static inline double series_slope(const double *c, double s)
{
    double y = SERIES_ORDER * c[SERIES_ORDER];
    for (int n = SERIES_ORDER - 1; n > 0; n--)
        y = y * s + n * c[n];
    return y;
}

/* A step at which the last terms of two series do not matter */
static inline double series_step(const double *w, const double *v)
{
    const double size = DBL_EPSILON / 8 * fmax(fabs(w[0]), fabs(v[0]));
    double least = INFINITY;
    for (int n = SERIES_ORDER - 2; n <= SERIES_ORDER; n++) {
        const double last = fmax(fabs(w[n]), fabs(v[n]));
        if (last > 0)
            least = fmin(least, pow(size / last, 1.0 / n));
    }
    return isfinite(least) ? 0.9 * least : 1;
}

/* Where a series falls below a level, or its slope below 0, between two places */
static inline double series_root(double (*value)(const double *c, double s), const double *c, double level, double low,
                                 double high)
{
    for (int k = 0; k < 80; k++) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high)
            break;
        if (value(c, middle) > level)
            low = middle;
        else
            high = middle;
    }
    return high;
}

#endif
