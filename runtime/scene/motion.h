/* SPDX-License-Identifier: MIT */
/* Computes collisions by Taylor series, as motions with polynomial coefficients:
 *
 *     du/ds = v,     dv/ds = -T(u) (F - press),     F = E(u) + damper u^b v,     dt/ds = T(u)
 *
 * u is a function of the overlap, and v the velocity. T and E are sums of two terms. The header also has parts that
 * files of this directory share: integer powers, and collisions in which more forces than the law act. */
#ifndef COR_RUNTIME_SCENE_MOTION_H
#define COR_RUNTIME_SCENE_MOTION_H

#include "cor/scene.h"
#include "runtime/number/inline.h"
#include "runtime/number/root.h"

/* A collision, in the units of its function. If the bodies stay together, eps is 0 and the duration infinite. */
struct cor_full_impact {
    double eps[COR_SCENE_ENDS], duration[COR_SCENE_ENDS], max_overlap, force_max;
};
static const struct cor_full_impact cor_together = {{0, 0}, {INFINITY, INFINITY}, 0, 0};

COR_INLINE double product_coefficient(const double *x, const double *y, int n)
{
    double sum = 0;
    for (int k = 0; k <= n; k++)
        sum += x[k] * y[n - k];
    return sum;
}

COR_INLINE double whole_power(double x, int n)
{
    double y = 1;
    for (; n > 0; n /= 2) {
        y *= n % 2 ? x : 1;
        x *= n > 1 ? x : 1;
    }
    return y;
}

/* ---- motions ---- */

enum { MOTION_ORDER = 24, MOTION_MOST_STEPS = 100000, MOTION_POWERS = 64 };

/* A power of u, computed as the product of two other powers. The powers 0 and 1 come first. */
struct motion_power {
    int exponent, left, right;
    double c[MOTION_ORDER + 1];
};

struct motion_term {
    double factor;
    int exponent, power; /* power: set by cor_motion_init */
};

/* One step of a motion: coefficients of power series in s, 0 <= s <= `step` */
struct motion {
    struct motion_term time[2], spring[2], damper;
    double press;
    int powers;
    struct motion_power power[MOTION_POWERS];
    double v[MOTION_ORDER + 1], t[MOTION_ORDER + 1], force[MOTION_ORDER + 1];
    double step, unit; /* the unit of s: 1, or smaller where coefficients would overflow */
    /* True if `press` dominates the inertia at the start. v is then computed from v^2/2 + spring - press x = energy -
     * loss, because the series gives a small speed at x = 0 as an inaccurate difference. */
    int follows_energy;
    double energy, loss[MOTION_ORDER + 1]; /* loss: the work of the damper */
};

/* Sets the powers of the terms, and the start u, v at t = 0. Returns 0 if the exponents need too many powers. */
int cor_motion_init(struct motion *m, double u, double v);

/* Adds a power of u to the series, and returns its place in `power`. */
int cor_motion_power(struct motion *m, int exponent);

/* Fills the coefficients from u, v and t at s = 0, and sets the longest step at which the last coefficients are
 * negligible. Returns 0 if the product of two coefficients would overflow. */
int cor_motion_expand(struct motion *m);
/* Makes the end of the step the start of the next one. */
void cor_motion_advance(struct motion *m);

/* Follows the motion to the turning point, where the next step begins, or until `rests` is true at the end of a step
 * where F falls. *force_max: the largest F on the way. Returns 0 if this needs too many steps. */
int cor_motion_compress(struct motion *m, double *force_max, int (*rests)(const struct motion *m));

/* Functions of the place s in a step. cor_motion_root returns the place at which a function falls to `level`. */
typedef double motion_function(const struct motion *m, double s, double level);
motion_function cor_motion_u, cor_motion_v; /* return u and v minus `level` */
double cor_motion_t(const struct motion *m, double s);
double cor_motion_loss(const struct motion *m, double s);
double cor_motion_root(const struct motion *m, motion_function *f, double low, double high, double level);

COR_INLINE double cor_motion_start(const struct motion *m)
{
    return m->power[1].c[0];
}

/* ---- pressed.c ---- */

/* Collisions under a constant force that presses the bodies together, in units in which it is 1 (docs/theory.md, 24):
 *
 *     x'' + damping x^b x' + x^a = 1,     x(0) = 0,     x'(0) = speed
 *
 * The ends are zero overlap and the surface, which has the array index of zero force. A body leaves the contact where
 * its force vanishes and flies back to x = 0 against the constant force. */

/* Returns the largest force of x'' + damper x^b x' + elastic x^a = 0; NaN if the motion needs too many steps. */
double cor_pressed_force_max(const struct cor_exponents *law, double elastic, double damper);

/* Solves a collision. force_max: the largest value of x^a + damping x^b x'. Returns COR_OK, or COR_FAULT_PRESSED if the
 * motion takes too many steps. */
int cor_pressed_solve(struct cor_full_impact *impact, const struct cor_exponents *law, double damping, double speed);

/* Returns the impact speed up to which the bodies stay together; infinite if it exceeds 1e9. */
double cor_pressed_sticking_speed(const struct cor_exponents *law, double damping, int end);

/* ---- jkr.c ---- */

/* Collisions of spheres that adhere by the theory of Johnson, Kendall and Roberts (docs/theory.md, 22), in the units
 *
 *     contact radius  c = c_0 u^2, c_0^3 = 2 pi w R^2/E*     overlap  (c_0^2/R) (u^4 - u)     force  pi w R
 *     time  T = (m c_0^2/(pi w R^2))^(1/2)                   speed  V = c_0^2/(R T)
 *
 * With x = u^4 - u the force is f = (8/3) u^6 - 4 u^3, and x'' + kappa u^power x' + f = 0. The bodies touch at x = 0
 * with the impact speed divided by V, where the contact jumps to u = 1. */

/* Computes the collision of a contact with adhesion_j_m2 > 0 and the damping coefficient C, in SI units, at a speed >
 * 0. Returns COR_OK, or COR_FAULT_PRESSED if the motion needs too many steps. */
int cor_jkr_impact(struct cor_full_impact *impact, const struct cor_scene_contact *contact, double coefficient,
                   double speed_m_s);

/* Returns the speed up to which the bodies stay together, m/s; NaN if a motion needs too many steps. */
double cor_jkr_sticking_speed(const struct cor_scene_contact *contact, double coefficient, int end);

/* True if the damper of a law is a power of the contact radius: Hertz's laws with b = 0, 1/4, 1/2 and 3/2. */
int cor_jkr_has_law(const struct cor_exponents *law);

/* ---- plastic.c ---- */

/* Computes the collision above the yield speed, in SI units. */
void cor_plastic_impact(struct cor_full_impact *impact, const struct cor_scene_contact *contact, double speed_m_s);

/* Returns the speed below which a liquid holds the bodies. */
double cor_wet_sticking_speed(const struct cor_scene_contact *contact, int end);

#endif
