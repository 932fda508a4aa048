/* SPDX-License-Identifier: MIT */
#include "ode.h"

#include <float.h>
#include <math.h>

struct jet {
    int order;
    double w[ODE_TAYLOR_ORDER_MAX + 1], v[ODE_TAYLOR_ORDER_MAX + 1];
};

/* The coefficients of w and v from their values w[0] and v[0]. */
static void jet_expand(struct jet *jet, double beta)
{
    double square[ODE_TAYLOR_ORDER_MAX], force[ODE_TAYLOR_ORDER_MAX]; /* w^2 and beta v + w^2 */
    for (int k = 0; k < jet->order; k++) {
        double sum = 0; /* w^2 is symmetric: half of the products, twice */
        for (int i = 0; 2 * i < k; i++)
            sum += jet->w[i] * jet->w[k - i];
        square[k] = 2 * sum + (k % 2 == 0 ? jet->w[k / 2] * jet->w[k / 2] : 0);
        force[k] = beta * jet->v[k] + square[k];
        double product = 0;
        for (int i = 0; i <= k; i++)
            product += square[i] * force[k - i];
        jet->w[k + 1] = jet->v[k] / (2 * (k + 1));
        jet->v[k + 1] = -product / (k + 1);
    }
}

struct state {
    double w, v;
};

static struct state jet_at(const struct jet *jet, double h)
{
    struct state s = {jet->w[jet->order], jet->v[jet->order]};
    for (int i = jet->order - 1; i >= 0; i--) {
        s.w = s.w * h + jet->w[i];
        s.v = s.v * h + jet->v[i];
    }
    return s;
}

static double step_length(const struct jet *jet, double tolerance)
{
    double h = 1;
    for (int k = jet->order - 1; k <= jet->order; k++) {
        const double size = fmax(fabs(jet->w[k]), fabs(jet->v[k]));
        if (size > 0)
            h = fmin(h, exp2(log2(tolerance / size) / k));
    }
    return h;
}

/* Positive before the end of contact. */
static double event_value(struct state s, double beta, enum end end)
{
    return end == ZERO_OVERLAP ? s.w : beta * s.v + s.w * s.w;
}

/* d event/ds by the equation of motion; at zero force v' = 0 */
static double event_slope(struct state s, double beta, enum end end)
{
    return end == ZERO_OVERLAP ? s.v / 2 : s.w * (s.v - beta * s.w * (beta * s.v + s.w * s.w));
}

/* -v where the event passes through zero in [0, high], by Newton's method kept between two signs. */
static double speed_at_event(const struct jet *jet, double beta, enum end end, double high)
{
    double low = 0, h = high;
    struct state s = jet_at(jet, h);
    for (int i = 0; i < 60; i++) {
        const double value = event_value(s, beta, end);
        if (value > 0)
            low = h;
        else
            high = h;
        double next = h - value / event_slope(s, beta, end);
        if (!(next >= low && next <= high))
            next = low + (high - low) / 2;
        const int done = fabs(next - h) <= 2 * DBL_EPSILON * fabs(next);
        h = next;
        s = jet_at(jet, h);
        if (done)
            break;
    }
    return -s.v;
}

double ode_taylor(double beta, enum end end, int order, double tolerance)
{
    struct jet jet = {.order = order, .w = {0}, .v = {1}};
    for (int steps = 0; steps < 100000; steps++) {
        jet_expand(&jet, beta);
        const double h = step_length(&jet, tolerance);
        const struct state s = jet_at(&jet, h);
        if (s.v < 0 && (s.w <= 0 || event_value(s, beta, end) <= 0))
            return speed_at_event(&jet, beta, end, h);
        jet.w[0] = s.w;
        jet.v[0] = s.v;
    }
    return NAN;
}

int ode_taylor_order(double tolerance)
{
    const int order = (int)ceil(-0.5 * log(tolerance)) + 2;
    return order < 4 ? 4 : order > ODE_TAYLOR_ORDER_MAX ? ODE_TAYLOR_ORDER_MAX : order;
}
