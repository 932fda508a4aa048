/* SPDX-License-Identifier: MIT */
/* Coefficient of restitution eps of viscoelastic spheres, dimensionless.
 *
 * The scaled collision
 *
 *     x'' + beta sqrt(x) x' + x^(3/2) = 0,     x(0) = 0,     x'(0) = 1
 *
 * depends on one number, beta = (3/2) A (rho/m)^(2/5) g^(1/5), with the dissipation time A, the
 * elastic constant rho, the effective mass m and the impact speed g; contact.h computes it from
 * materials in SI units. eps = -x' when the contact ends. Two conditions can end it; both are
 * offered and neither is the default:
 *
 *     zero overlap     x = 0 again; the force is attractive just before
 *     zero force       x'' = 0, that is x = -beta x'; no attraction
 *
 * Equation numbers (n) are those of Ramirez, Poeschel, Brilliantov and Schwager, Phys. Rev. E 60,
 * 4465 (1999); docs/derivation.md derives them again and lists where the print is wrong. */
#ifndef COR_SPHERE_H
#define COR_SPHERE_H

#include <stddef.h>

#include "export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Largest beta that the eps and loss functions below accept at this stage. */
#define COR_SPHERE_BETA_MAX 2.0

/* Bounds on |computed/exact - 1| of eps and of loss = 1 - eps, 0 <= beta <= COR_SPHERE_BETA_MAX,
 * both ends of contact, approximation and evaluation together. Sampled: tests/unit/test_sphere.c
 * asserts them against an integration of the equation of motion; generated/sphere_pade.h states
 * the error of the approximation alone. Where the loss is subnormal, half a unit of the last
 * subnormal place comes on top. */
#define COR_SPHERE_EPS_MAX_REL 1e-10
#define COR_SPHERE_LOSS_MAX_REL 1e-10

/* C_1 of eps = 1 + C_1 beta + C_2 beta^2 + ..., (65) with its sign (minus that of (6)):
 *
 *     C_1 = -sqrt(pi) Gamma(3/5) / (2^(1/5) 5^(2/5) Gamma(21/10)),     (g/g*)^(1/5) = |C_1| beta
 *
 * by (30). Rounded to the nearest double. */
#define COR_SPHERE_C1 (-1.15344885809528879913)

/* eps at zero overlap and at zero force.
 * Domain: 0 <= beta <= COR_SPHERE_BETA_MAX. Accuracy: COR_SPHERE_EPS_MAX_REL.
 * Special values: beta = +-0 -> exactly 1; negative, NaN and beyond the domain (+inf too) -> NaN.
 * Source: (10) with Pade approximants of the series (65) in beta (zero overlap), and of its
 * counterpart in sqrt(beta) (zero force). */
COR_API double cor_sphere_eps_zero_overlap(double beta);
COR_API double cor_sphere_eps_zero_force(double beta);

/* loss = 1 - eps, with relative accuracy where the subtraction would have none: loss tends to
 * |C_1| beta as beta -> 0, down to the smallest subnormal.
 * Domain: 0 <= beta <= COR_SPHERE_BETA_MAX. Accuracy: COR_SPHERE_LOSS_MAX_REL.
 * Special values: beta = +-0 -> exactly 0; negative, NaN and beyond the domain -> NaN.
 * Source: as eps, 1 - P/Q = (Q - P)/Q with the difference taken before rounding. */
COR_API double cor_sphere_loss_zero_overlap(double beta);
COR_API double cor_sphere_loss_zero_force(double beta);

/* eps[i] = cor_sphere_eps_...(beta[i]) for i < n, the same to the last bit. n may be 0, the
 * pointers then NULL. beta and eps may be the same array, but must not overlap otherwise. */
COR_API void cor_sphere_eps_zero_overlap_array(const double *beta, double *eps, size_t n);
COR_API void cor_sphere_eps_zero_force_array(const double *beta, double *eps, size_t n);

/* ---- Approximations of 1999, kept as what they are. None of them is the answer. ---- */

/* The constant d of (22), rounded to the nearest double:
 *
 *     d = sqrt(pi) Gamma(3/5) / (5 Gamma(21/10)), the integral of sqrt(x) sqrt(1 - x^(5/2)), 0 to 1
 *
 * 2 delta d = |C_1| beta, where delta = (5/4)^(3/5) beta is (14). */
#define COR_SPHERE_SIMPLE_D 0.504454894269828315974

/* Bound on the rounding error of the three functions below, each as the formula it is, in units of
 * the last place of its value. */
#define COR_SPHERE_EPS_SIMPLE_MAX_ULP 12.0

/* The simple theory: the root in [0, 1] of eps + 2 delta d eps^(3/5) = 1, (27).
 * It shares C_1 and C_2 with eps at zero overlap and no more: it is 1.6 % too large at beta = 0.5,
 * 11 % at 1, 88 % at 2, and falls like beta^(-5/3) instead of beta^(-5). Against eps at zero force
 * it is 2 %, 7 % and 16 % too small there.
 * Domain: 0 <= beta <= inf.
 * Accuracy as the solution of (27): COR_SPHERE_EPS_SIMPLE_MAX_ULP, sampled.
 * Special values: +-0 -> 1, +inf -> 0, negative or NaN -> NaN. */
COR_API double cor_sphere_eps_simple(double beta);

/* The continued fraction of the simple theory, (28), cut after `depth` levels: eps = 1/t_depth,
 *
 *     t_0 = 1,     t_(k+1) = 1 + 2 delta d t_k^(2/5)
 *
 * Each level lowers the value, towards cor_sphere_eps_simple.
 * Domain: 0 <= beta <= inf, depth >= 0; a beta above 1.5e308 counts as infinite.
 * Accuracy as (28): COR_SPHERE_EPS_SIMPLE_MAX_ULP, sampled.
 * Special values: +-0 or depth 0 -> 1, +inf -> 0 for depth >= 1; negative or NaN beta, or negative
 * depth -> NaN. */
COR_API double cor_sphere_eps_simple_fraction(double beta, int depth);

/* The published [1/4] Pade approximant (35) with the printed coefficients of Table I,
 *
 *     (1 + d_1 s)/(1 + d_2 s + d_3 s^2 + d_4 s^3 + d_5 s^4),     s = (g/g*)^(1/5) = |C_1| beta,
 *     d_1 ... d_5 = 2.5839, 3.5839, 2.9839, 1.1487, 0.3265
 *
 * Wrong: its a_3 and a_4 are (docs/derivation.md), and it follows from the series cut after a_4.
 * Against eps at zero overlap it is 0.6 % too large at beta = 0.5, 5 % at 1, 51 % at 2, a factor
 * 3.3 at 3, and falls like beta^(-3) instead of beta^(-5). Here to reproduce old simulations and
 * figures; for the answer call cor_sphere_eps_zero_overlap.
 * Domain: 0 <= beta <= inf. Accuracy as (35): COR_SPHERE_EPS_SIMPLE_MAX_ULP, sampled.
 * Special values: +-0 -> 1, +inf -> 0, negative or NaN -> NaN. */
COR_API double cor_sphere_eps_published_pade(double beta);

#ifdef __cplusplus
}
#endif

#endif
