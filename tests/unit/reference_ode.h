/* SPDX-License-Identifier: MIT */
/* Reference for the sphere functions by another route than the library's: the equation of motion,
 * integrated. No table, no series in beta. */
#ifndef COR_TESTS_REFERENCE_ODE_H
#define COR_TESTS_REFERENCE_ODE_H

struct reference {
    long double eps_zero_overlap, loss_zero_overlap;
    long double eps_zero_force, loss_zero_force;
};

/* One collision at 0 <= beta <= 5: with x = w^2 and dt = w dsigma,
 *
 *     dw/dsigma = v/2,     dv/dsigma = -w^2 (beta v + w^2),     w = 0, v = 1 at the start
 *
 * by Taylor steps of order 40 in long double. Zero overlap: w = 0 again; zero force: beta v + w^2 =
 * 0. eps is good to about 1e-18 where long double has 64 bits, and 1e-15 where it is a double; loss
 * is 1 - eps, with that absolute error. */
struct reference reference_collision(long double beta);

#endif
