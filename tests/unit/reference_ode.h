/* SPDX-License-Identifier: MIT */
/* Reference for the sphere functions by another route than the library's: the equation of motion,
 * integrated. No table, no series in beta. */
#ifndef COR_TESTS_REFERENCE_ODE_H
#define COR_TESTS_REFERENCE_ODE_H

struct reference {
    long double eps_zero_overlap, loss_zero_overlap;
    long double eps_zero_force, loss_zero_force;
    long double duration_zero_overlap, duration_zero_force;
    long double max_overlap, time_of_max_overlap;
};

/* One collision at 0 <= beta <= 20: with x = beta^(-2/3) X, t = beta^(-2/3) s beyond beta = 1, X = w^2 and
 * ds = w dsigma,
 *
 *     dw/dsigma = v/2,     dv/dsigma = -w^2 (c1 v + c2 w^2),     ds/dsigma = w,     w = 0, v = 1 at the start
 *
 * by Taylor steps of order 40 in long double, c1 = beta and c2 = 1 up to beta = 1, c1 = 1 and c2 = beta^(-5/3) beyond.
 * Zero overlap: w = 0 again; zero force: c1 v + c2 w^2 = 0. Relative errors are about 1e-18 where long double has 64
 * bits, and 1e-15 where it is a double; loss is 1 - eps, with that absolute error. The time grows like beta^4: a
 * millisecond at 7. */
struct reference reference_collision(long double beta);

#endif
