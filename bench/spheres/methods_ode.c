/* SPDX-License-Identifier: MIT */
/* The equation of motion integrated for every collision, from speed. */
#include <math.h>
#include <stdio.h>

#include "ode.h"

SCALAR_METHOD(taylor, const double unit = scene->contact.beta_per_root,
              ode_taylor(pow(g, 0.2) * unit, method->end, method->order, method->tolerance))
SCALAR_METHOD(runge_kutta, const double unit = scene->contact.beta_per_root,
              ode_runge_kutta(pow(g, 0.2) * unit, method->end, method->tolerance))
SCALAR_METHOD(verlet, const double unit = scene->contact.beta_per_root,
              ode_verlet(pow(g, 0.2) * unit, method->end, method->order))
SCALAR_METHOD(taylor_beta, , ode_taylor(g, method->end, method->order, method->tolerance))
SCALAR_METHOD(runge_kutta_beta, , ode_runge_kutta(g, method->end, method->tolerance))
SCALAR_METHOD(verlet_beta, , ode_verlet(g, method->end, method->order))

#define ROW(CURVE, INPUT, NAME)                                                                                        \
    {                                                                                                                  \
        .curve = CURVE, .input = INPUT, .flags = INTEGRATES, .each = NAME##_each, .chain = NAME##_chain                \
    }
static const struct method taylors[] = {ROW("Taylor", FROM_SPEED, taylor), ROW("Taylor", FROM_BETA, taylor_beta)};
static const struct method runge_kuttas[] = {ROW("Runge-Kutta", FROM_SPEED, runge_kutta),
                                             ROW("Runge-Kutta", FROM_BETA, runge_kutta_beta)};
static const struct method verlets[] = {ROW("Verlet", FROM_SPEED, verlet), ROW("Verlet", FROM_BETA, verlet_beta)};

static void add_to_tolerance(struct methods *methods, struct method method, double tolerance)
{
    method.tolerance = tolerance;
    method.order = ode_taylor_order(tolerance);
    snprintf(method.setting, sizeof method.setting, "%.0e", tolerance);
    methods_add(methods, &method);
}

void add_integrators(struct methods *methods)
{
    static const double taylor_tolerances[] = {1e-3, 1e-6, 1e-9, 1e-12, 1e-15};
    static const double runge_kutta_tolerances[] = {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13};
    static const int steps[] = {10, 30, 100, 300, 1000, 3000, 10000};
    for (enum input input = FROM_SPEED; input <= FROM_BETA; input++)
        for (enum end end = ZERO_OVERLAP; end <= ZERO_FORCE; end++) {
            struct method taylor = taylors[input], runge_kutta = runge_kuttas[input], verlet = verlets[input];
            taylor.end = runge_kutta.end = verlet.end = end;
            for (size_t i = 0; i < sizeof taylor_tolerances / sizeof *taylor_tolerances; i++)
                add_to_tolerance(methods, taylor, taylor_tolerances[i]);
            for (size_t i = 0; i < sizeof runge_kutta_tolerances / sizeof *runge_kutta_tolerances; i++)
                add_to_tolerance(methods, runge_kutta, runge_kutta_tolerances[i]);
            for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
                verlet.order = steps[i];
                snprintf(verlet.setting, sizeof verlet.setting, "%d steps", steps[i]);
                methods_add(methods, &verlet);
            }
        }
}
