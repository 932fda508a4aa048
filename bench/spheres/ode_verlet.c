/* SPDX-License-Identifier: MIT */
#include "ode.h"

#include <math.h>

static const double longest = 1e4; /* elastic contacts */

double ode_verlet(double beta, enum end end, long steps)
{
    const double h = ODE_ELASTIC_CONTACT / (double)steps;
    double x = 0, v = 1, force = 0;
    for (double t = 0; t < longest * ODE_ELASTIC_CONTACT; t += h) {
        v += 0.5 * h * force;
        x += h * v;
        if (x <= 0 && v < 0)
            return -v;
        const double root = sqrt(x);
        force = -root * (beta * v + x);
        if (end == ZERO_FORCE && v < 0 && force >= 0)
            return -v;
        v += 0.5 * h * force;
    }
    return NAN;
}
