/* SPDX-License-Identifier: MIT */
/* The equation of motion integrated for every collision, from speed. */
#include <math.h>
#include <stdio.h>

#include "ode.h"

SCALAR_METHOD(taylor, const double unit = scene->contact.beta_per_root,
              ode_taylor(pow(g, 0.2) * unit, method->end, method->order, method->tolerance))
SCALAR_METHOD(runge_kutta, const double unit = scene->contact.beta_per_root,
              ode_runge_kutta(pow(g, 0.2) * unit, method->end, method->tolerance))

static void add_curve(struct methods *methods, const struct method *shape, const double *tolerances, size_t n)
{
    for (enum end end = ZERO_OVERLAP; end <= ZERO_FORCE; end++)
        for (size_t i = 0; i < n; i++) {
            struct method method = *shape;
            method.end = end;
            method.tolerance = tolerances[i];
            method.order = method.each == taylor_each ? ode_taylor_order(method.tolerance) : 0;
            if (method.order > 0)
                snprintf(method.name, sizeof method.name, "ODE, Taylor order %d, tolerance %.0e", method.order,
                         method.tolerance);
            else
                snprintf(method.name, sizeof method.name, "ODE, Runge-Kutta 5(4), tolerance %.0e", method.tolerance);
            methods_add(methods, &method);
        }
}

void add_integrators(struct methods *methods)
{
    static const double taylor_tolerances[] = {1e-3, 1e-6, 1e-9, 1e-12, 1e-15};
    static const double runge_kutta_tolerances[] = {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13};
    static const struct method taylor = {
        .curve = "Taylor", .precision = "tolerance", .flags = INTEGRATES, .each = taylor_each, .chain = taylor_chain};
    static const struct method runge_kutta = {.curve = "Runge-Kutta",
                                              .precision = "tolerance",
                                              .flags = INTEGRATES,
                                              .each = runge_kutta_each,
                                              .chain = runge_kutta_chain};
    add_curve(methods, &taylor, taylor_tolerances, sizeof taylor_tolerances / sizeof *taylor_tolerances);
    add_curve(methods, &runge_kutta, runge_kutta_tolerances,
              sizeof runge_kutta_tolerances / sizeof *runge_kutta_tolerances);
}
