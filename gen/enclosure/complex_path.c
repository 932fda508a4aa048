/* SPDX-License-Identifier: MIT */
#include "enclosure/complex_path.h"

#define MAX_STEPS 20000.0 /* at resolution 1 */

/* A step is shortened unless its residual is at most (1 + MORE_OF_RESIDUAL) r + resolution (MORE_OF_SLOPE |slope| +
 * MORE_OF_VALUE |value|). r is the radius of the slope at the middle of the step. */
#define MORE_OF_RESIDUAL 0.25
#define MORE_OF_SLOPE 0.004
#define MORE_OF_VALUE 0.002
/* Largest product of a step and the derivative of the slope by the dependent variable */
#define LARGEST_RATE_STEP 0.4
/* Largest radius relative to the value */
#define LARGEST_RADIUS 0.5
#define FIRST_STEP 0.01
#define LARGEST_STEP 0.02
#define SMALLEST_STEP 1e-7

/* Returns the slopes with respect to s, for every s and every value of the dependent variable in balls. */
static struct slopes path_slopes(struct path *p, struct complex_ball s, struct complex_ball y)
{
    const struct complex_ball at = ball_widened(ball_add(ball_centre(p->begin), ball_mul(ball_centre(p->length), s)),
                                                COMPLEX_BALL_ROUNDING * ball_size(p->length) +
                                                    raise_bound(p->begin.radius * raise_bound(1 - s.re + s.radius) +
                                                                p->end.radius * raise_bound(s.re + s.radius)));
    p->s = s;
    struct slopes f = p->equation(p, at, y);
    f.slope = ball_mul(f.slope, p->length);
    f.derivative = ball_mul(f.derivative, p->length);
    f.time = ball_mul(f.time, p->length);
    return f;
}

/* Returns the size of the dependent variable, with which its radius is compared. */
static double value_size(const struct path *p, struct complex_ball value)
{
    return p->logarithm ? 1 : ball_size(value);
}

static double distance_between(struct complex_ball x, struct complex_ball centre)
{
    return ball_above(ball_sub(x, centre));
}

enum step_outcome { STEP_DONE, STEP_TOO_LONG, STEP_IMPOSSIBLE };

/* Makes one step from s to end. The line has the slope `mean`, the slope at the ball's centre in the middle of the
 * step. The distance e of a solution from the line obeys |e|' <= rate |e| + residual, where `rate` bounds the real part
 * of the slope's derivative between the line and the solution. */
static enum step_outcome try_step(struct path *p, struct path_state *y, double s, double end)
{
    const double h = end - s, longest = raise_bound(h), radius = y->value.radius; /* h is exact, or correct to 2^-53 */
    const struct complex_ball centre = ball_centre(y->value), middle = ball_of((s + end) / 2, 0);
    const struct complex_ball at_middle =
        path_slopes(p, middle, ball_centre(ball_add(centre, ball_times(p->slope, h / 2)))).slope;
    const struct complex_ball mean = ball_centre(at_middle);
    if (!ball_is_finite(at_middle))
        return STEP_IMPOSSIBLE;

    const struct complex_ball places = ball_widened(middle, longest / 2 + 0x1p-50);
    const struct complex_ball line =
        ball_add(centre, ball_mul(mean, ball_widened(ball_of(h / 2, 0), longest / 2 + 0x1p-50)));
    const struct slopes along = path_slopes(p, places, line);
    const double residual = distance_between(along.slope, mean);
    const double more = p->resolution * (MORE_OF_SLOPE * ball_size(mean) + MORE_OF_VALUE * value_size(p, centre));
    if (!(residual <= at_middle.radius * (1 + MORE_OF_RESIDUAL) + more) ||
        !(ball_above(along.derivative) * h <= LARGEST_RATE_STEP))
        return STEP_TOO_LONG;

    const double start = raise_bound(radius + longest * residual), tube = 2 * start;
    const struct slopes within = path_slopes(p, places, ball_widened(line, tube));
    const double rate =
        within.derivative.re + 0x1p-40 * fabs(within.derivative.re) + raise_bound(within.derivative.radius);
    /* |e| is at most `start` if rate <= 0, and otherwise at most exp(rate h) times `start` */
    const double growth = raise_bound(exp(rate * h) * (1 + 0x1p-40));
    if (!ball_is_finite(within.derivative) || !ball_is_finite(within.time) || (rate > 0 && !(growth * start <= tube)))
        return STEP_TOO_LONG;
    struct complex_ball next = ball_add(centre, ball_times(mean, h));
    next.radius += 0x1p-45 * longest * ball_size(mean); /* error of h */
    next.radius += rate > 0 ? raise_bound(growth * start)
                            : raise_bound(growth * radius + fmin(longest, raise_bound(1 / -rate)) * residual);
    next.radius = raise_bound(next.radius);
    p->slope = mean;
    y->value = next;
    y->time = ball_add(y->time, ball_mul(within.time, ball_widened(ball_of(h, 0), 0x1p-50)));
    return next.radius <= LARGEST_RADIUS * value_size(p, next) ? STEP_DONE : STEP_IMPOSSIBLE;
}

bool path_follow(struct path *p, path_equation *equation, struct complex_ball begin, struct complex_ball end,
                 struct path_state *y)
{
    p->equation = equation;
    p->begin = begin;
    p->end = end;
    p->length = ball_sub(end, begin);
    p->slope = ball_centre(path_slopes(p, ball_of(0, 0), ball_centre(y->value)).slope);
    double s = 0, h = FIRST_STEP;
    for (int k = 0; k < MAX_STEPS / p->resolution && s < 1; k++) {
        const double next = s + h < 1 ? s + h : 1;
        const enum step_outcome outcome = try_step(p, y, s, next);
        if (outcome == STEP_IMPOSSIBLE)
            return false;
        if (outcome == STEP_DONE) {
            s = next;
            h = fmin(1.5 * h, LARGEST_STEP);
        } else {
            h = (next - s) / 2;
            if (!(h > SMALLEST_STEP))
                return false;
        }
    }
    return s == 1;
}
