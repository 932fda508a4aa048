/* SPDX-License-Identifier: MIT */
/* eps of one collision by integrating it, in double: what the tables of the library replace. */
#ifndef COR_BENCH_SPHERES_ODE_H
#define COR_BENCH_SPHERES_ODE_H

#include "methods.h"

enum { ODE_TAYLOR_ORDER_MAX = 32 };

/* Taylor steps on the polynomial form: x = w^2 and dt = w ds make
 *
 *     dw/ds = v/2,     dv/ds = -w^2 (beta v + w^2),     w = 0, v = 1 at the start
 *
 * without root or singular point. Steps as long as the last two terms stay below the tolerance. */
double ode_taylor(double beta, enum end end, int order, double tolerance);

/* The order that makes the tolerance cheapest. */
int ode_taylor_order(double tolerance);

/* Dormand and Prince's embedded 5(4) pair on x'' + beta sqrt(x) x' + x^(3/2) = 0 as it stands, in x and t: the error of
 * a step relative and absolute by the tolerance, the last step cut to the end of contact by the secant method. */
double ode_runge_kutta(double beta, enum end end, double tolerance);

/* Velocity Verlet as simulators of many grains take it: steps of a fixed length, so many in a contact without
 * dissipation, the damping at the half-step's velocity; the contact ends with the step that finds it ended. */
#define ODE_ELASTIC_CONTACT 3.2180654597190431
double ode_verlet(double beta, enum end end, long steps);

#endif
