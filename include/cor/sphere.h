/* SPDX-License-Identifier: MIT */
/* Coefficient of restitution eps of viscoelastic spheres, dimensionless.
 *
 * The scaled collision
 *
 *     x'' + beta sqrt(x) x' + x^(3/2) = 0,     x(0) = 0,     x'(0) = 1
 *
 * depends on one number, beta = (3/2) A (rho/m)^(2/5) g^(1/5), with the dissipation time A, the elastic constant rho,
 * the effective mass m and the impact speed g. contact.h computes beta from materials in SI units. eps = -x' when the
 * contact ends. The library offers both common definitions of the end and has no default:
 *
 *     zero overlap     x = 0 again; the force is attractive just before
 *     zero force       x'' = 0, that is x = -beta x'; no attraction
 *
 * Each name below denotes two functions, NAME and NAME_array:
 *
 *     cor_sphere_eps_zero_overlap         cor_sphere_eps_zero_force          cor_sphere_eps_approach_only
 *     cor_sphere_loss_zero_overlap        cor_sphere_loss_zero_force         cor_sphere_loss_approach_only
 *     cor_sphere_beta_zero_overlap        cor_sphere_beta_zero_force         cor_sphere_beta_approach_only
 *     cor_sphere_duration_zero_overlap    cor_sphere_duration_zero_force     cor_sphere_duration_approach_only
 *     cor_sphere_max_overlap              cor_sphere_time_of_max_overlap     cor_sphere_beta_of_loss_approach_only
 *
 * eps and loss at zero overlap and zero force also have NAME_arrayf, in float arithmetic. Published approximations:
 * cor_sphere_eps_simple, cor_sphere_eps_simple_fraction, cor_sphere_eps_published_pade.
 *
 * cor.h describes threads, memory, the floating-point environment and arrays. No function uses more than
 * COR_SPHERE_MAX_STACK bytes of stack; a function of a single number uses at most 4 kB. For beta beyond 8, or beyond
 * 16 for eps and loss at zero force, the functions call cbrt and log of the C library. The bits of the results then
 * depend on that library.
 *
 * Equation numbers (n) refer to Ramirez, Poeschel, Brilliantov and Schwager, Phys. Rev. E 60, 4465 (1999);
 * docs/theory.md derives them again, and docs/errata.md lists where the print is wrong. */
#ifndef COR_SPHERE_H
#define COR_SPHERE_H

#include <stddef.h>

#include "export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bounds on the error of the functions below, in units of the last place of the exact value, over every double in
 * their domains, subnormal arguments and results included. Proved for rounding to nearest without fused operations, if
 * log of the C library is within 1 unit and cbrt within 64 (docs/theory.md, 8 and 18). tests/accuracy asserts them
 * too, against an independent reference; docs/accuracy.md records the proved bounds and the worst found. */
#define COR_SPHERE_EPS_MAX_ULP 1.0
#define COR_SPHERE_LOSS_MAX_ULP 1.0
#define COR_SPHERE_MAX_OVERLAP_MAX_ULP 1.0
#define COR_SPHERE_TIME_MAX_ULP 2.0
#define COR_SPHERE_BETA_MAX_ULP 2.0
/* Largest differences between a function of generated/cor_sphere.h and the same function of the library, in units of
 * the last place: with -ffast-math, and with fused multiplication and addition (-march=native). Special values do not
 * change. With all other flags, -ffinite-math-only included, both functions give the same bits. Sampled in
 * tests/header/run. */
#define COR_SPHERE_INLINE_FAST_MATH_ULP 4
#define COR_SPHERE_INLINE_NATIVE_ULP 4
/* Bound on the stack of every function, in bytes. Measured in an optimised build, libm included: 17.8 kB. */
#define COR_SPHERE_MAX_STACK 24576

/* C_1 of eps = 1 + C_1 beta + C_2 beta^2 + ..., with the sign of (65), which is opposite to the sign in (6):
 *
 *     C_1 = -sqrt(pi) Gamma(3/5) / (2^(1/5) 5^(2/5) Gamma(21/10)),     (g/g*)^(1/5) = |C_1| beta
 *
 * by (30). The constant is rounded to the nearest double. */
#define COR_SPHERE_C1 (-1.15344885809528879913)

/* double cor_sphere_eps_zero_overlap(double beta), cor_sphere_eps_zero_force: restitution coefficient. The name gives
 * the end of contact.
 * Domain: 0 <= beta <= inf. Accuracy: COR_SPHERE_EPS_MAX_ULP. 0 <= eps <= 1. From one double beta to the next one, eps
 * never rises by more than one unit of its last place. This and the accuracy are proved (docs/theory.md, 18).
 * Large beta, zero overlap: h*^5 beta^-5 with h*^5 = 5.1583817...; for beta >= 7 the relative difference is below
 * 2^-75. Large beta, zero force: (3/2)^(2/3) beta^(-5/3) with corrections of relative size beta^(-5/3) ln(beta).
 * Special values: +-0 -> exactly 1, +inf -> 0; negative and NaN -> NaN.
 * Source: (10), from the equation of motion itself; docs/theory.md, 4 to 6 and 8. */
COR_API double cor_sphere_eps_zero_overlap(double beta);
COR_API void cor_sphere_eps_zero_overlap_array(const double *beta, double *y, size_t n);
COR_API double cor_sphere_eps_zero_force(double beta);
COR_API void cor_sphere_eps_zero_force_array(const double *beta, double *y, size_t n);

/* double cor_sphere_loss_zero_overlap(double beta), cor_sphere_loss_zero_force: 1 - eps, without the cancellation of a
 * subtraction. The loss tends to |C_1| beta as beta -> 0, and is accurate down to the smallest subnormal.
 * Domain: 0 <= beta <= inf. Accuracy: COR_SPHERE_LOSS_MAX_ULP.
 * Special values: +-0 -> 0, +inf -> 1; negative and NaN -> NaN. Source: as for eps. */
COR_API double cor_sphere_loss_zero_overlap(double beta);
COR_API void cor_sphere_loss_zero_overlap_array(const double *beta, double *y, size_t n);
COR_API double cor_sphere_loss_zero_force(double beta);
COR_API void cor_sphere_loss_zero_force_array(const double *beta, double *y, size_t n);

/* double cor_sphere_beta_zero_overlap(double eps), cor_sphere_beta_zero_force: the inverse functions, which return the
 * beta that has this eps. Domain: 0 <= eps <= 1. Accuracy: COR_SPHERE_BETA_MAX_ULP with the given double eps treated as
 * exact. (Near eps = 1, beta is (1 - eps)/|C_1|, so a change of eps by one unit of its last place changes beta much.
 * The condition number is eps/(1 - eps).) Special values: 1 -> 0, +-0 -> +inf; outside [0, 1] and NaN -> NaN. Source:
 * as for eps. */
COR_API double cor_sphere_beta_zero_overlap(double eps);
COR_API void cor_sphere_beta_zero_overlap_array(const double *eps, double *y, size_t n);
COR_API double cor_sphere_beta_zero_force(double eps);
COR_API void cor_sphere_beta_zero_force_array(const double *eps, double *y, size_t n);

/* double cor_sphere_duration_zero_overlap(double beta), cor_sphere_duration_zero_force: duration of the contact, in
 * units of (rho/m)^(-2/5) g^(-1/5), s.
 * Domain: 0 <= beta <= inf. Accuracy: COR_SPHERE_TIME_MAX_ULP.
 * Large beta: (10/3) beta ln(beta) (zero overlap); beta^(-2/3) (2.9119... ln(beta) + 0.5292...) (zero force).
 * Special values: +-0 -> 2 tau_0 of (51), 3.2180...; +inf -> +inf (zero overlap), 0 (zero force); negative and
 * NaN -> NaN. Source: docs/theory.md, 4 to 6 and 8. */
COR_API double cor_sphere_duration_zero_overlap(double beta);
COR_API void cor_sphere_duration_zero_overlap_array(const double *beta, double *y, size_t n);
COR_API double cor_sphere_duration_zero_force(double beta);
COR_API void cor_sphere_duration_zero_force_array(const double *beta, double *y, size_t n);

/* double cor_sphere_max_overlap(double beta): largest overlap x_max, in units of (rho/m)^(-2/5) g^(4/5).
 * Domain: 0 <= beta <= inf. Accuracy: COR_SPHERE_MAX_OVERLAP_MAX_ULP.
 * Large beta: (3/2)^(2/3) beta^(-2/3).
 * Special values: +-0 -> y_0 of (51), 1.0933...; +inf -> 0; negative and NaN -> NaN. Source: (57) to (62). */
COR_API double cor_sphere_max_overlap(double beta);
COR_API void cor_sphere_max_overlap_array(const double *beta, double *y, size_t n);

/* double cor_sphere_time_of_max_overlap(double beta): the time at which the overlap is largest, in units of
 * (rho/m)^(-2/5) g^(-1/5).
 * Domain: 0 <= beta <= inf. Accuracy: COR_SPHERE_TIME_MAX_ULP.
 * Large beta: beta^(-2/3) (1.4559... ln(beta) + 0.4112...).
 * Special values: +-0 -> tau_0 of (51), 1.6090...; +inf -> 0; negative and NaN -> NaN. Source: (51) to (56). */
COR_API double cor_sphere_time_of_max_overlap(double beta);
COR_API void cor_sphere_time_of_max_overlap_array(const double *beta, double *y, size_t n);

/* ---- Arrays of floats ----
 *
 * eps and 1 - eps in float arithmetic, in less than half the time of the double arrays. For every other function of
 * floats, call the double function and round its result.
 * Domain: 0 <= beta <= inf. Accuracy: COR_SPHERE_FLOAT_MAX_ULP, in units of the last place of a float, measured at
 * every float (tests/accuracy/test_floats.c). Beta >= 8 (zero overlap) or 16 (zero force), -0 and, for the loss,
 * 0 < beta < 2^-100 give the double result rounded to a float, which takes longer.
 * Special values: as for the double functions. */
#define COR_SPHERE_FLOAT_MAX_ULP 0.75
COR_API void cor_sphere_eps_zero_overlap_arrayf(const float *beta, float *y, size_t n);
COR_API void cor_sphere_eps_zero_force_arrayf(const float *beta, float *y, size_t n);
COR_API void cor_sphere_loss_zero_overlap_arrayf(const float *beta, float *y, size_t n);
COR_API void cor_sphere_loss_zero_force_arrayf(const float *beta, float *y, size_t n);

/* ---- Damping during the approach only ----
 *
 * Some simulators damp the force while the bodies approach, and use only the elastic force after the turning point
 * (law.h, approach_only). The approach and its largest overlap x_max are the same as in the full law, so that
 *
 *     eps = sqrt((4/5) x_max^(5/2)),     duration = time of the largest overlap + tau_0 eps^(-1/5)
 *
 * double cor_sphere_eps_approach_only(double beta), cor_sphere_loss_approach_only: eps, and 1 - eps with relative
 * accuracy.
 * Domain: 0 <= beta <= inf. Accuracy: COR_SPHERE_APPROACH_MAX_ULP, sampled in tests/accuracy.
 * Small beta: 1 - eps tends to |C_1| beta/2. Large beta: sqrt(4/5) (3/2)^(5/6) beta^(-5/6).
 * Special values: +-0 -> 1 (loss 0), +inf -> 0 (loss 1); negative and NaN -> NaN.
 *
 * double cor_sphere_beta_approach_only(double eps), cor_sphere_beta_of_loss_approach_only(double loss): the inverse
 * functions, from eps or from 1 - eps.
 * Domain: 0 to 1. Accuracy: COR_SPHERE_APPROACH_MAX_ULP with the given double treated as exact.
 * Special values: eps 1, loss 0 -> 0; eps 0, loss 1 -> +inf, and +inf where beta is beyond the largest double; outside
 * [0, 1] and NaN -> NaN.
 *
 * double cor_sphere_duration_approach_only(double beta): in the unit of the other durations.
 * Domain: 0 <= beta <= inf. Accuracy: COR_SPHERE_TIME_MAX_ULP. Special values: +-0 -> 2 tau_0, +inf -> +inf; negative
 * and NaN -> NaN. */
#define COR_SPHERE_APPROACH_MAX_ULP 2.0
COR_API double cor_sphere_eps_approach_only(double beta);
COR_API void cor_sphere_eps_approach_only_array(const double *beta, double *y, size_t n);
COR_API double cor_sphere_loss_approach_only(double beta);
COR_API void cor_sphere_loss_approach_only_array(const double *beta, double *y, size_t n);
COR_API double cor_sphere_beta_approach_only(double eps);
COR_API void cor_sphere_beta_approach_only_array(const double *eps, double *y, size_t n);
COR_API double cor_sphere_beta_of_loss_approach_only(double loss);
COR_API void cor_sphere_beta_of_loss_approach_only_array(const double *loss, double *y, size_t n);
COR_API double cor_sphere_duration_approach_only(double beta);
COR_API void cor_sphere_duration_approach_only_array(const double *beta, double *y, size_t n);

/* ---- Approximations published in 1999, as they were published. Call them only to reproduce old results. ---- */

/* The constant d of (22), rounded to the nearest double:
 *
 *     d = sqrt(pi) Gamma(3/5) / (5 Gamma(21/10)), the integral of sqrt(x) sqrt(1 - x^(5/2)), 0 to 1
 *
 * 2 delta d = |C_1| beta, where delta = (5/4)^(3/5) beta is (14). */
#define COR_SPHERE_SIMPLE_D 0.504454894269828315974

/* Bound on the rounding error of the three functions below, against the exact value of each formula, in units of the
 * last place. */
#define COR_SPHERE_EPS_SIMPLE_MAX_ULP 12.0

/* Returns the root in [0, 1] of eps + 2 delta d eps^(3/5) = 1, (27), of the simple theory. Of its series in beta, only
 * C_1 and C_2 agree with eps at zero overlap. Relative to that eps the root is 1.6 % too large at beta = 0.5, 11 % at 1
 * and 88 % at 2. It decreases like beta^(-5/3) instead of beta^(-5). Relative to eps at zero force it is 2 %, 7 % and
 * 16 % too small at the same beta.
 * Domain: 0 <= beta <= inf.
 * Accuracy as the solution of (27): COR_SPHERE_EPS_SIMPLE_MAX_ULP, sampled.
 * Special values: +-0 -> 1, +inf -> 0, negative or NaN -> NaN. */
COR_API double cor_sphere_eps_simple(double beta);

/* Returns the continued fraction of the simple theory, (28), cut off after `depth` levels: eps = 1/t_depth,
 *
 *     t_0 = 1,     t_(k+1) = 1 + 2 delta d t_k^(2/5)
 *
 * Each level lowers the value, towards cor_sphere_eps_simple.
 * Domain: 0 <= beta <= inf, depth >= 0.
 * Accuracy as (28): COR_SPHERE_EPS_SIMPLE_MAX_ULP, sampled.
 * Special values: +-0 or depth 0 -> 1, +inf -> 0 for depth >= 1; negative or NaN beta, or negative
 * depth -> NaN. */
COR_API double cor_sphere_eps_simple_fraction(double beta, int depth);

/* Returns the published [1/4] Pade approximant (35) with the printed coefficients of Table I,
 *
 *     (1 + d_1 s)/(1 + d_2 s + d_3 s^2 + d_4 s^3 + d_5 s^4),     s = (g/g*)^(1/5) = |C_1| beta,
 *     d_1 ... d_5 = 2.5839, 3.5839, 2.9839, 1.1487, 0.3265
 *
 * It is inaccurate for two reasons: the published a_3 and a_4 are wrong (docs/errata.md), and the series behind it ends
 * after a_4. Relative to eps at zero overlap it is 0.6 % too large at beta = 0.5, 5 % at 1, 51 % at 2, and a factor of
 * 3.3 at 3. It decreases like beta^(-3) instead of beta^(-5). Call it only to reproduce old simulations and figures.
 * For the restitution itself, call cor_sphere_eps_zero_overlap.
 * Domain: 0 <= beta <= inf. Accuracy as (35): COR_SPHERE_EPS_SIMPLE_MAX_ULP, sampled.
 * Special values: +-0 -> 1, +inf -> 0, negative or NaN -> NaN. */
COR_API double cor_sphere_eps_published_pade(double beta);

#ifdef __cplusplus
}
#endif

#endif
