/* SPDX-License-Identifier: MIT */
/* Damping laws of simulators, each in its own dimensionless parameter: restitution from damping and damping from
 * restitution. docs/laws.md says which simulator has which law and what to give it.
 *
 * A force K x^a + C x^b x' acts between two bodies with overlap x and effective mass m that meet with speed g. In units of
 * time T = (m/K)^(1/(a+1)) g^((1-a)/(a+1)) and of length g T,
 *
 *     x'' + beta x^b x' + x^a = 0,     x(0) = 0,     x'(0) = 1,     beta = (C/m) g^b T^(b+1)
 *
 * eps = -x' when the contact ends. Simulators end it in four ways:
 *
 *     zero_overlap    x = 0 again; the force is attractive just before
 *     zero_force      x'' = 0; what "no attraction", "limit damping" and max(0, F) do
 *     limited         the damping force is cut off at the size of the elastic force: 0 <= F <= 2 K x^a
 *     approach_only   the force is damped while the bodies approach, and elastic from the turning point on
 *
 * Every function comes as double, as float (with an f at its end: the double function rounded once), and for arrays of
 * either: y[i] = function(x[i]) for i < n, the same to the last bit. n may be 0, the pointers then NULL. x and y may be the
 * same array, but must not overlap otherwise. The same input gives the same bits on every processor: instruction sets are
 * chosen at run time, and none of them changes a result; no function of the C library but sqrt takes part. */
#ifndef COR_LAW_H
#define COR_LAW_H

#include <stddef.h>

#include "export.h"
#include "hertz_dashpot.h" /* Hertz with a constant dashpot */

#ifdef __cplusplus
extern "C" {
#endif

/* Bounds on the error of the functions below, in units of the last place of the exact value, over every double in their
 * domains, subnormal arguments and results included. Sampled: tests/accuracy/test_laws.c asserts them against MPFR in
 * another formulation, at random arguments and around every boundary; docs/accuracy.md records the worst found. */
#define COR_LAW_EPS_MAX_ULP 2.0
#define COR_LAW_LOSS_MAX_ULP 2.0
#define COR_LAW_INVERSE_MAX_ULP 2.0
#define COR_LAW_MAX_OVERLAP_MAX_ULP 2.0
#define COR_LAW_TIME_MAX_ULP 2.0
/* The float variants, in units of the last place of a float. */
#define COR_LAW_FLOAT_MAX_ULP 1.0

#define COR_LAW_DECLARE_(function)                                                                                     \
    COR_API double cor_##function(double x);                                                                           \
    COR_API float cor_##function##f(float x);                                                                          \
    COR_API void cor_##function##_array(const double *x, double *y, size_t n);                                         \
    COR_API void cor_##function##_arrayf(const float *x, float *y, size_t n);

/* ---- The linear dashpot (a = 1, b = 0) and Tsuji's damping (a = 3/2, b = 1/4) ----
 *
 * Both have the damping ratio zeta as their parameter, beta = 2 zeta and beta = sqrt(5) zeta: with stiffness K and damping C,
 * zeta = C/(2 sqrt(m K)) and zeta = C/sqrt(5 m K). eps is the same function of zeta for both, and independent of the impact
 * speed. With
 *
 *     A(zeta) = acos(zeta)/sqrt(1 - zeta^2),   1 for zeta = 1,   acosh(zeta)/sqrt(zeta^2 - 1) for zeta > 1
 *
 * -ln(eps) is pi zeta/sqrt(1 - zeta^2) at zero overlap (zeta < 1; from zeta = 1 on the bodies stay together and eps is 0),
 * 2 zeta A(zeta) at zero force, zeta A(zeta) with damping while approaching only, and
 * zeta (2 A(zeta) - atan2(2 zeta sqrt(1 - zeta^2), 1 + 2 zeta^2)/sqrt(1 - zeta^2)) with the limited damper, continued
 * analytically beyond zeta = 1. */

/* double cor_linear_eps_<end>(double zeta): restitution coefficient; <end> one of the four.
 * Domain: 0 <= zeta <= inf. Accuracy: COR_LAW_EPS_MAX_ULP. 0 <= eps <= 1, and from one double zeta to the next eps never
 * rises by more than two units of its last place.
 * Large zeta: 1/(4 zeta^2) (zero force), 1/(2 zeta) (approach only), 1/(2 sqrt(2) zeta) (limited).
 * Special values: +-0 -> 1, +inf -> 0; at zero overlap 0 for zeta >= 1; negative and NaN -> NaN.
 * Source: docs/laws.md; at zero force the three cases of Schwager and Poeschel, Granular Matter 9, 465 (2007), in one. */
COR_LAW_DECLARE_(linear_eps_zero_overlap)
COR_LAW_DECLARE_(linear_eps_zero_force)
COR_LAW_DECLARE_(linear_eps_limited)
COR_LAW_DECLARE_(linear_eps_approach_only)

/* double cor_linear_loss_<end>(double zeta): 1 - eps with relative accuracy, where the subtraction would have none. It tends
 * to pi zeta as zeta -> 0, to pi zeta/2 with damping while approaching only, down to the smallest subnormal.
 * Domain: 0 <= zeta <= inf. Accuracy: COR_LAW_LOSS_MAX_ULP.
 * Special values: +-0 -> 0, +inf -> 1; at zero overlap 1 for zeta >= 1; negative and NaN -> NaN. Source: as eps. */
COR_LAW_DECLARE_(linear_loss_zero_overlap)
COR_LAW_DECLARE_(linear_loss_zero_force)
COR_LAW_DECLARE_(linear_loss_limited)
COR_LAW_DECLARE_(linear_loss_approach_only)

/* double cor_linear_zeta_<end>(double eps): the inverse, the least zeta that has this eps.
 * Domain: 0 <= eps <= 1. Accuracy: COR_LAW_INVERSE_MAX_ULP for the double eps as it is given. (Near eps = 1 a change of its
 * last place is a large change of zeta; from 1 - eps: the function below.)
 * Special values: 1 -> 0; 0 -> +inf, at zero overlap 1; +inf where zeta is beyond the largest double (approach only and
 * limited, eps below 2.8e-309 and 2.0e-309); outside [0, 1] and NaN -> NaN.
 * Source: at zero overlap L/sqrt(pi^2 + L^2), L = -ln(eps); the others solve the equations above. */
COR_LAW_DECLARE_(linear_zeta_zero_overlap)
COR_LAW_DECLARE_(linear_zeta_zero_force)
COR_LAW_DECLARE_(linear_zeta_limited)
COR_LAW_DECLARE_(linear_zeta_approach_only)

/* double cor_linear_zeta_of_loss_<end>(double loss): the same from 1 - eps.
 * Domain: 0 <= loss <= 1. Accuracy: COR_LAW_INVERSE_MAX_ULP. Special values: 0 -> 0; 1 -> +inf, at zero overlap 1; outside
 * [0, 1] and NaN -> NaN. */
COR_LAW_DECLARE_(linear_zeta_of_loss_zero_overlap)
COR_LAW_DECLARE_(linear_zeta_of_loss_zero_force)
COR_LAW_DECLARE_(linear_zeta_of_loss_limited)
COR_LAW_DECLARE_(linear_zeta_of_loss_approach_only)

/* double cor_linear_duration_<end>(double zeta): duration of the contact in units of sqrt(m/K):
 *
 *     zero overlap   pi/sqrt(1 - zeta^2)            zero force       2 A(zeta)
 *     approach only  A(zeta) + pi/2                 limited          atan(2 sqrt(2) zeta)/sqrt(2) - ln(eps)/zeta
 *
 * Domain: 0 <= zeta <= inf. Accuracy: COR_LAW_TIME_MAX_ULP.
 * Special values: +-0 -> pi; +inf -> 0 (zero force), pi/2 (approach only), pi/(2 sqrt(2)) (limited); at zero overlap +inf for
 * zeta >= 1; negative and NaN -> NaN. */
COR_LAW_DECLARE_(linear_duration_zero_overlap)
COR_LAW_DECLARE_(linear_duration_zero_force)
COR_LAW_DECLARE_(linear_duration_limited)
COR_LAW_DECLARE_(linear_duration_approach_only)

/* double cor_linear_max_overlap(double zeta): largest overlap of the full law, exp(-zeta A(zeta)), in units of g sqrt(m/K).
 * double cor_linear_time_of_max_overlap(double zeta): when it is reached, A(zeta), in units of sqrt(m/K).
 * Domain: 0 <= zeta <= inf. Accuracy: COR_LAW_MAX_OVERLAP_MAX_ULP, COR_LAW_TIME_MAX_ULP.
 * Special values: +-0 -> 1 and pi/2, +inf -> 0 and 0; negative and NaN -> NaN. */
COR_LAW_DECLARE_(linear_max_overlap)
COR_LAW_DECLARE_(linear_time_of_max_overlap)

/* The same for Tsuji's damping. eps, loss and their inverses are the linear dashpot's, under the name of the law.
 * Durations and times are in units of T = (m/K)^(2/5) g^(-1/5), the largest overlap is ((5/4) eps)^(2/5) with eps at zero
 * force, in units of g T: as for the sphere (sphere.h).
 * Special values of times: +-0 -> 3.2180... (durations, those of the sphere), 1.6090... (of the largest overlap); +inf -> 0,
 * but +inf with damping while approaching only and 0.9... with the limited damper; at zero overlap +inf for zeta >= 1. */
COR_LAW_DECLARE_(tsuji_eps_zero_overlap)
COR_LAW_DECLARE_(tsuji_eps_zero_force)
COR_LAW_DECLARE_(tsuji_eps_limited)
COR_LAW_DECLARE_(tsuji_eps_approach_only)
COR_LAW_DECLARE_(tsuji_loss_zero_overlap)
COR_LAW_DECLARE_(tsuji_loss_zero_force)
COR_LAW_DECLARE_(tsuji_loss_limited)
COR_LAW_DECLARE_(tsuji_loss_approach_only)
COR_LAW_DECLARE_(tsuji_zeta_zero_overlap)
COR_LAW_DECLARE_(tsuji_zeta_zero_force)
COR_LAW_DECLARE_(tsuji_zeta_limited)
COR_LAW_DECLARE_(tsuji_zeta_approach_only)
COR_LAW_DECLARE_(tsuji_zeta_of_loss_zero_overlap)
COR_LAW_DECLARE_(tsuji_zeta_of_loss_zero_force)
COR_LAW_DECLARE_(tsuji_zeta_of_loss_limited)
COR_LAW_DECLARE_(tsuji_zeta_of_loss_approach_only)
COR_LAW_DECLARE_(tsuji_duration_zero_overlap)
COR_LAW_DECLARE_(tsuji_duration_zero_force)
COR_LAW_DECLARE_(tsuji_duration_limited)
COR_LAW_DECLARE_(tsuji_duration_approach_only)
COR_LAW_DECLARE_(tsuji_max_overlap)
COR_LAW_DECLARE_(tsuji_time_of_max_overlap)

/* ---- Hunt and Crossley's law: F = F_el(x) (1 + d x') ----
 *
 * eps depends on beta = d g alone, whatever the elastic force F_el(x) is. Zero overlap and zero force coincide. With
 * f(z) = z - ln(1 + z), eps is the solution of f(-beta eps) = f(beta); with damping while approaching only it is
 * sqrt(2 f(beta))/beta. -1 < beta < 0 is a pumped collision, whose eps is above 1. */

/* double cor_hunt_crossley_eps(double beta), cor_hunt_crossley_eps_approach_only: restitution coefficient.
 * Domain: -1 < beta <= inf. Accuracy: COR_LAW_EPS_MAX_ULP.
 * Large beta: 1/beta, to the last bit from beta = 45 on; sqrt(2/beta) with damping while approaching only.
 * Special values: +-0 -> 1, +inf -> 0; beta <= -1 and NaN -> NaN.
 * Source: docs/laws.md; Hunt and Crossley, J. Appl. Mech. 42, 440 (1975), for the law. */
COR_LAW_DECLARE_(hunt_crossley_eps)
COR_LAW_DECLARE_(hunt_crossley_eps_approach_only)

/* double cor_hunt_crossley_loss(double beta), cor_hunt_crossley_loss_approach_only: 1 - eps with relative accuracy. It tends
 * to (2/3) beta as beta -> 0, to beta/3 with damping while approaching only; it is negative where beta is.
 * Domain: -1 < beta <= inf. Accuracy: COR_LAW_LOSS_MAX_ULP.
 * Special values: +-0 -> 0, +inf -> 1; beta <= -1 and NaN -> NaN. */
COR_LAW_DECLARE_(hunt_crossley_loss)
COR_LAW_DECLARE_(hunt_crossley_loss_approach_only)

/* double cor_hunt_crossley_beta(double eps), cor_hunt_crossley_beta_approach_only: the inverse. beta = 2 y/(1 + eps) with
 * coth(y) - 1/y = (1 - eps)/(1 + eps), Langevin's function inverted.
 * Domain: 0 <= eps <= 1. Accuracy: COR_LAW_INVERSE_MAX_ULP for the double eps as it is given.
 * Special values: 1 -> 0, 0 -> +inf; +inf where beta is beyond the largest double (eps below 5.6e-309, approach only
 * 1.1e-154); outside [0, 1] and NaN -> NaN. */
COR_LAW_DECLARE_(hunt_crossley_beta)
COR_LAW_DECLARE_(hunt_crossley_beta_approach_only)

/* double cor_hunt_crossley_beta_of_loss(double loss), cor_hunt_crossley_beta_of_loss_approach_only: the same from 1 - eps.
 * Domain: 0 <= loss <= 1. Accuracy: COR_LAW_INVERSE_MAX_ULP. Special values: 0 -> 0, 1 -> +inf; outside [0, 1] and
 * NaN -> NaN. */
COR_LAW_DECLARE_(hunt_crossley_beta_of_loss)
COR_LAW_DECLARE_(hunt_crossley_beta_of_loss_approach_only)

/* Functions of beta and of the elastic exponent a of F_el = K x^a, of which arrays share one. */
#define COR_LAW_DECLARE_WITH_EXPONENT_(function)                                                                       \
    COR_API double cor_##function(double beta, double elastic_exponent);                                               \
    COR_API float cor_##function##f(float beta, float elastic_exponent);                                               \
    COR_API void cor_##function##_array(const double *beta, double elastic_exponent, double *y, size_t n);             \
    COR_API void cor_##function##_arrayf(const float *beta, float elastic_exponent, float *y, size_t n);

/* double cor_hunt_crossley_max_overlap(double beta, double elastic_exponent): largest overlap,
 * ((a + 1) f(beta)/beta^2)^(1/(a + 1)), in units of g T = g (m/K)^(1/(a+1)) g^((1-a)/(a+1)).
 * Domain: -1 < beta <= inf, 0 <= a < inf. Accuracy: COR_LAW_MAX_OVERLAP_MAX_ULP.
 * Special values: beta = +-0 -> ((a + 1)/2)^(1/(a + 1)), +inf -> 0; outside the domain and NaN -> NaN. */
COR_LAW_DECLARE_WITH_EXPONENT_(hunt_crossley_max_overlap)

/* double cor_hunt_crossley_duration(double beta, double elastic_exponent), _duration_approach_only,
 * _time_of_max_overlap: in units of T = (m/K)^(1/(a+1)) g^((1-a)/(a+1)).
 * Domain: -1 < beta <= inf, 0 <= a < inf. Accuracy: COR_LAW_TIME_MAX_ULP for a = 1 and a = 3/2 and beta >= 0, by tables;
 * COR_HUNT_CROSSLEY_TIME_MAX_ERROR, relative, for every other a <= COR_HUNT_CROSSLEY_MAX_EXPONENT and for beta < 0, by quadrature,
 * which takes some microseconds.
 * Special values: beta = +-0 -> the elastic collision's, for a = 1 pi and pi/2; +inf -> +inf (duration), 0 (time of the
 * largest overlap); a > COR_HUNT_CROSSLEY_MAX_EXPONENT, outside the domain and NaN -> NaN. */
#define COR_HUNT_CROSSLEY_TIME_MAX_ERROR 1e-13
#define COR_HUNT_CROSSLEY_MAX_EXPONENT 100.0
COR_LAW_DECLARE_WITH_EXPONENT_(hunt_crossley_duration)
COR_LAW_DECLARE_WITH_EXPONENT_(hunt_crossley_duration_approach_only)
COR_LAW_DECLARE_WITH_EXPONENT_(hunt_crossley_time_of_max_overlap)

#undef COR_LAW_DECLARE_
#undef COR_LAW_DECLARE_WITH_EXPONENT_

#ifdef __cplusplus
}
#endif

#endif
