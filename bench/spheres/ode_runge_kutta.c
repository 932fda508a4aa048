/* SPDX-License-Identifier: MIT */
#include "ode.h"

#include <math.h>

#include "dormand_prince.h"

enum { STAGES = DORMAND_PRINCE_STAGES };

struct state {
    double x, v;
};

static struct state slope(struct state s, double beta)
{
    const double root = sqrt(fmax(s.x, 0)); /* a trial step may leave the contact */
    return (struct state){s.v, -root * (beta * s.v + s.x)};
}

struct step {
    double h;
    struct state start, end;
    struct state k[STAGES]; /* k[0] the slope at the start, k[6] at the end */
};

static struct state weighted(struct state s, double h, const double *weight, const struct state *k, int n)
{
    double x = 0, v = 0;
    for (int i = 0; i < n; i++) {
        x += weight[i] * k[i].x;
        v += weight[i] * k[i].v;
    }
    return (struct state){s.x + h * x, s.v + h * v};
}

/* From start and k[0]; returns the error as a multiple of what is allowed. */
static double step_take(struct step *step, double beta, double tolerance)
{
    for (int stage = 1; stage < STAGES; stage++) {
        step->end = weighted(step->start, step->h, dormand_prince[stage], step->k, stage);
        step->k[stage] = slope(step->end, beta);
    }
    const struct state error = weighted((struct state){0, 0}, step->h, dormand_prince_difference, step->k, STAGES);
    const double x = error.x / (1 + fmax(fabs(step->start.x), fabs(step->end.x)));
    const double v = error.v / (1 + fmax(fabs(step->start.v), fabs(step->end.v)));
    return sqrt((x * x + v * v) / 2) / tolerance;
}

/* Positive before the end of contact. */
static double event_value(struct state s, double beta, enum end end)
{
    return end == ZERO_OVERLAP ? s.x : beta * s.v + s.x;
}

/* -v at the event, which the step passes: its length by the secant that keeps both signs (Illinois). */
static double speed_at_event(struct step *step, double beta, enum end end, double tolerance)
{
    double low = 0, high = step->h, value_low = event_value(step->start, beta, end),
           value_high = event_value(step->end, beta, end);
    int side = 0;
    for (int i = 0; i < 60 && high - low > 1e-15 * high; i++) {
        step->h = (low * value_high - high * value_low) / (value_high - value_low);
        step_take(step, beta, tolerance);
        const double value = event_value(step->end, beta, end);
        if (fabs(value) <= 1e-3 * tolerance)
            break;
        if (value > 0) {
            low = step->h;
            value_low = value;
            value_high /= side > 0 ? 2 : 1;
            side = 1;
        } else {
            high = step->h;
            value_high = value;
            value_low /= side < 0 ? 2 : 1;
            side = -1;
        }
    }
    return -step->end.v;
}

double ode_runge_kutta(double beta, enum end end, double tolerance)
{
    struct step step = {.h = 0.1 * pow(tolerance, 0.2), .start = {0, 1}};
    step.k[0] = slope(step.start, beta);
    for (int steps = 0; steps < 1000000; steps++) {
        const double error = step_take(&step, beta, tolerance);
        const double change = fmin(5, fmax(0.2, 0.9 * pow(error, -0.2)));
        if (error <= 1) {
            if (step.end.v < 0 && event_value(step.end, beta, end) <= 0)
                return speed_at_event(&step, beta, end, tolerance);
            step.start = step.end;
            step.k[0] = step.k[STAGES - 1];
        }
        step.h *= change;
    }
    return NAN;
}
