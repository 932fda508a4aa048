/* SPDX-License-Identifier: MIT */
/* Complex balls of doubles: all numbers within `radius` of re + i im. The result of an operation contains the results
 * for all numbers in its arguments.
 *
 * Every radius is increased by far more than the rounding errors. An operation on centres has a relative error of a few
 * 2^-53; COMPLEX_BALL_ROUNDING = 2^-48 of the moduli covers it. A radius is computed from a few products and sums of
 * positive numbers, and is multiplied by 1 + 2^-45. These balls are a hundred times as fast as Arb's, which have any
 * precision. They are used where an accuracy of one per cent suffices. */
#ifndef COR_GEN_ENCLOSURE_COMPLEX_BALL_H
#define COR_GEN_ENCLOSURE_COMPLEX_BALL_H

#include <math.h>
#include <stdbool.h>

struct complex_ball {
    double re, im, radius;
};

#define COMPLEX_BALL_ROUNDING 0x1p-48

/* Returns an upper bound of a positive number that was computed with a few roundings. */
static inline double raise_bound(double x)
{
    return x * (1 + 0x1p-45) + 0x1p-900;
}

static inline struct complex_ball ball_of(double re, double im)
{
    return (struct complex_ball){re, im, 0};
}

/* Returns |centre| to a few 2^-53. */
static inline double ball_size(struct complex_ball x)
{
    return sqrt(x.re * x.re + x.im * x.im);
}

/* ball_above and ball_below return an upper and a lower bound of the modulus. */
static inline double ball_above(struct complex_ball x)
{
    return raise_bound(ball_size(x) + x.radius);
}

static inline double ball_below(struct complex_ball x)
{
    return ball_size(x) * (1 - 0x1p-45) - raise_bound(x.radius);
}

static inline bool ball_is_finite(struct complex_ball x)
{
    return isfinite(x.re) && isfinite(x.im) && isfinite(x.radius);
}

static inline struct complex_ball ball_widened(struct complex_ball x, double radius)
{
    x.radius = raise_bound(x.radius + radius);
    return x;
}

static inline struct complex_ball ball_centre(struct complex_ball x)
{
    x.radius = 0;
    return x;
}

static inline struct complex_ball ball_add(struct complex_ball x, struct complex_ball y)
{
    struct complex_ball z = {x.re + y.re, x.im + y.im, 0};
    z.radius = raise_bound(x.radius + y.radius + COMPLEX_BALL_ROUNDING * ball_size(z));
    return z;
}

static inline struct complex_ball ball_neg(struct complex_ball x)
{
    return (struct complex_ball){-x.re, -x.im, x.radius};
}

static inline struct complex_ball ball_sub(struct complex_ball x, struct complex_ball y)
{
    return ball_add(x, ball_neg(y));
}

static inline struct complex_ball ball_mul(struct complex_ball x, struct complex_ball y)
{
    const double a = ball_size(x), b = ball_size(y);
    return (struct complex_ball){
        x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re,
        raise_bound(a * y.radius + b * x.radius + x.radius * y.radius + COMPLEX_BALL_ROUNDING * a * b)};
}

static inline struct complex_ball ball_times(struct complex_ball x, double factor)
{
    const double a = fabs(factor);
    return (struct complex_ball){x.re * factor, x.im * factor,
                                 raise_bound(a * x.radius + COMPLEX_BALL_ROUNDING * ball_size(x) * a)};
}

/* Returns 1/x; not finite if the ball may contain 0. The radius follows from |1/(c + d) - 1/c| = |d|/|c (c + d)|. */
static inline struct complex_ball ball_inv(struct complex_ball x)
{
    const double size = ball_size(x), least = ball_below(x), square = x.re * x.re + x.im * x.im;
    if (!(least > 0) || !(square > 0x1p-900) || !isfinite(square))
        return (struct complex_ball){0, 0, HUGE_VAL};
    return (struct complex_ball){x.re / square, -x.im / square,
                                 raise_bound(x.radius / (size * least) + COMPLEX_BALL_ROUNDING / size)};
}

static inline struct complex_ball ball_sqr(struct complex_ball x)
{
    return ball_mul(x, x);
}

/* Returns exp(x). Assumes that exp, cos and sin are accurate to 2^-48. */
static inline struct complex_ball ball_exp(struct complex_ball x)
{
    const double size = exp(x.re);
    return (struct complex_ball){size * cos(x.im), size * sin(x.im),
                                 raise_bound(size * (raise_bound(expm1(x.radius)) + 4 * COMPLEX_BALL_ROUNDING))};
}

#endif
