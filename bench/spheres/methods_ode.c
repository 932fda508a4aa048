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

static void add_curve(struct methods *methods, const struct method *shape, const double *tolerances, size_t n)
{
    for (enum end end = ZERO_OVERLAP; end <= ZERO_FORCE; end++)
        for (size_t i = 0; i < n; i++) {
            struct method method = *shape;
            method.precision = "tolerance";
            method.flags = INTEGRATES;
            method.end = end;
            method.tolerance = tolerances[i];
            const int taylors = method.each == taylor_each || method.each == taylor_beta_each;
            method.order = taylors ? ode_taylor_order(method.tolerance) : 0;
            if (method.order > 0)
                snprintf(method.name, sizeof method.name, "ODE, Taylor order %d, tolerance %.0e", method.order,
                         method.tolerance);
            else
                snprintf(method.name, sizeof method.name, "ODE, Runge-Kutta 5(4), tolerance %.0e", method.tolerance);
            methods_add(methods, &method);
        }
}

static const struct method taylor[] = {
    {.curve = "Taylor", .input = FROM_SPEED, .each = taylor_each, .chain = taylor_chain},
    {.curve = "Taylor", .input = FROM_BETA, .each = taylor_beta_each, .chain = taylor_beta_chain},
};
static const struct method runge_kutta[] = {
    {.curve = "Runge-Kutta", .input = FROM_SPEED, .each = runge_kutta_each, .chain = runge_kutta_chain},
    {.curve = "Runge-Kutta", .input = FROM_BETA, .each = runge_kutta_beta_each, .chain = runge_kutta_beta_chain},
};
static const struct method verlet[] = {
    {.curve = "Verlet", .input = FROM_SPEED, .each = verlet_each, .chain = verlet_chain},
    {.curve = "Verlet", .input = FROM_BETA, .each = verlet_beta_each, .chain = verlet_beta_chain},
};

static void add_from(struct methods *methods, enum input input)
{
    static const double taylor_tolerances[] = {1e-3, 1e-6, 1e-9, 1e-12, 1e-15};
    static const double runge_kutta_tolerances[] = {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13};
    add_curve(methods, &taylor[input], taylor_tolerances, sizeof taylor_tolerances / sizeof *taylor_tolerances);
    add_curve(methods, &runge_kutta[input], runge_kutta_tolerances,
              sizeof runge_kutta_tolerances / sizeof *runge_kutta_tolerances);
}

void add_integrators(struct methods *methods)
{
    add_from(methods, FROM_SPEED);
}

void add_report_integrators(struct methods *methods)
{
    static const int steps[] = {10, 30, 100, 300, 1000, 3000, 10000};
    add_from(methods, FROM_BETA);
    for (enum input input = FROM_SPEED; input <= FROM_BETA; input++)
        for (enum end end = ZERO_OVERLAP; end <= ZERO_FORCE; end++)
            for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
                struct method method = verlet[input];
                method.precision = "step";
                method.flags = INTEGRATES;
                method.end = end;
                method.order = steps[i];
                snprintf(method.name, sizeof method.name, "ODE, velocity Verlet, %d steps", steps[i]);
                snprintf(method.setting, sizeof method.setting, "%d steps", steps[i]);
                methods_add(methods, &method);
            }
}
