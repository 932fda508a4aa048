/* SPDX-License-Identifier: MIT */
/* Hertz's contact with a constant dashpot. Two bodies of effective mass m meet with speed g. At the overlap x the force
 * K x^(3/2) + C x' acts between them. In units of time T = (m/K)^(2/5) g^(-1/5) and of length g T,
 *
 *     x'' + beta x' + x^(3/2) = 0,     x(0) = 0,     x'(0) = 1,     beta = C m^(-3/5) K^(-2/5) g^(-1/5)
 *
 * Slow impacts are the strongly damped ones. eps = -x' when the contact ends, by one of two definitions:
 *
 *     zero_overlap    x = 0 again; the force is attractive just before. From beta = COR_HERTZ_DASHPOT_BETA_C on
 *                     the bodies never part: eps is exactly 0 and the duration infinite. These are the impacts with
 *                     g <= C^5/(COR_HERTZ_DASHPOT_BETA_C^5 m^3 K^2)
 *     zero_force      x'' = 0; no attraction
 *
 * Each name below stands for four functions, NAME, NAMEf, NAME_array and NAME_arrayf; <end> is zero_overlap, zero_force
 * or approach_only:
 *
 *     cor_hertz_dashpot_eps_<end>     cor_hertz_dashpot_beta_<end>             cor_hertz_dashpot_max_overlap
 *     cor_hertz_dashpot_loss_<end>    cor_hertz_dashpot_beta_of_loss_<end>     cor_hertz_dashpot_time_of_max_overlap
 *     cor_hertz_dashpot_duration_<end>
 *
 * cor.h says what holds of threads, memory, the floating-point environment and arrays, law.h of the stack.
 * Source: docs/theory.md, 9. */
#ifndef COR_HERTZ_DASHPOT_H
#define COR_HERTZ_DASHPOT_H

#include <stddef.h>

#include "export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bounds on the error of the functions below, in units of the last place of the exact value, over every double in their
 * domains. Sampled: tests/table/test_hertz_dashpot.c asserts them against enclosed collisions at random arguments and
 * around every boundary; docs/accuracy.md records the worst cases found. */
#define COR_HERTZ_DASHPOT_EPS_MAX_ULP 1.0
#define COR_HERTZ_DASHPOT_LOSS_MAX_ULP 1.0
#define COR_HERTZ_DASHPOT_MAX_OVERLAP_MAX_ULP 1.0
#define COR_HERTZ_DASHPOT_TIME_MAX_ULP 2.0
#define COR_HERTZ_DASHPOT_BETA_MAX_ULP 2.0
/* Bound on the error of the float variants, in units of the last place of a float. */
#define COR_HERTZ_DASHPOT_FLOAT_MAX_ULP 1.0

/* beta_c = 1.127988135520169216213..., rounded to the nearest double, which is below it */
#define COR_HERTZ_DASHPOT_BETA_C 1.12798813552016922

#define COR_HERTZ_DASHPOT_DECLARE_(quantity)                                                                           \
    COR_API double cor_hertz_dashpot_##quantity(double x);                                                             \
    COR_API float cor_hertz_dashpot_##quantity##f(float x);                                                            \
    COR_API void cor_hertz_dashpot_##quantity##_array(const double *x, double *y, size_t n);                           \
    COR_API void cor_hertz_dashpot_##quantity##_arrayf(const float *x, float *y, size_t n);

/* double cor_hertz_dashpot_eps_<end>(double beta): restitution coefficient.
 * Domain: 0 <= beta <= inf. Accuracy: COR_HERTZ_DASHPOT_EPS_MAX_ULP. 0 <= eps <= 1.
 * Large beta: beta^(-5/2) at zero force. Just below beta_c, d = beta_c - beta: s d (1 + pi sqrt(s d/beta_c^5)),
 * s = 0.206987698804...
 * Special values: +-0 -> 1, +inf -> 0; at zero overlap 0 above beta_c; negative and NaN -> NaN. */
COR_HERTZ_DASHPOT_DECLARE_(eps_zero_overlap)
COR_HERTZ_DASHPOT_DECLARE_(eps_zero_force)

/* double cor_hertz_dashpot_loss_<end>(double beta): 1 - eps with relative accuracy, also where a subtraction would
 * cancel. As beta -> 0 the loss tends to 1.78781... beta.
 * Domain: 0 <= beta <= inf. Accuracy: COR_HERTZ_DASHPOT_LOSS_MAX_ULP.
 * Special values: +-0 -> 0, +inf -> 1; at zero overlap 1 above beta_c; negative and NaN -> NaN. */
COR_HERTZ_DASHPOT_DECLARE_(loss_zero_overlap)
COR_HERTZ_DASHPOT_DECLARE_(loss_zero_force)

/* double cor_hertz_dashpot_beta_<end>(double eps): the inverse, the smallest beta that has this eps.
 * Domain: 0 <= eps <= 1. Accuracy: COR_HERTZ_DASHPOT_BETA_MAX_ULP with the given double eps taken as exact.
 * Special values: 1 -> 0; 0 -> +inf, at zero overlap COR_HERTZ_DASHPOT_BETA_C; outside [0, 1] and NaN -> NaN. */
COR_HERTZ_DASHPOT_DECLARE_(beta_zero_overlap)
COR_HERTZ_DASHPOT_DECLARE_(beta_zero_force)

/* double cor_hertz_dashpot_beta_of_loss_<end>(double loss): the inverse as a function of 1 - eps.
 * Domain: 0 <= loss <= 1. Accuracy: COR_HERTZ_DASHPOT_BETA_MAX_ULP. Special values: 0 -> 0; 1 -> as beta of eps = 0;
 * outside [0, 1] and NaN -> NaN. */
COR_HERTZ_DASHPOT_DECLARE_(beta_of_loss_zero_overlap)
COR_HERTZ_DASHPOT_DECLARE_(beta_of_loss_zero_force)

/* double cor_hertz_dashpot_duration_<end>(double beta): duration of the contact in units of T.
 * Domain: 0 <= beta <= inf. Accuracy: COR_HERTZ_DASHPOT_TIME_MAX_ULP.
 * Special values: +-0 -> 3.2180...; +inf -> 0 at zero force; at zero overlap +inf above beta_c; negative and
 * NaN -> NaN. */
COR_HERTZ_DASHPOT_DECLARE_(duration_zero_overlap)
COR_HERTZ_DASHPOT_DECLARE_(duration_zero_force)

/* double cor_hertz_dashpot_max_overlap(double beta): largest overlap in units of g T.
 * double cor_hertz_dashpot_time_of_max_overlap(double beta): the time of the largest overlap, in units of T.
 * Domain: 0 <= beta <= inf. Accuracy: COR_HERTZ_DASHPOT_MAX_OVERLAP_MAX_ULP, COR_HERTZ_DASHPOT_TIME_MAX_ULP.
 * Special values: +-0 -> (5/4)^(2/5) and 1.6090..., +inf -> 0; negative and NaN -> NaN. */
COR_HERTZ_DASHPOT_DECLARE_(max_overlap)
COR_HERTZ_DASHPOT_DECLARE_(time_of_max_overlap)

/* ---- Damping while approaching only ----
 *
 * The approach is that of the full law and the rebound is elastic, so that with the largest overlap Y
 *
 *     eps = sqrt((4/5) Y^(5/2)),     duration = time of the largest overlap + tau_0 eps^(-1/5),     tau_0 = 1.6090...
 *
 * The bodies part at every beta. double cor_hertz_dashpot_eps_approach_only(double beta), _loss_, _beta_ (the inverse),
 * _beta_of_loss_ and _duration_, with the domains of the functions above.
 * Accuracy: COR_HERTZ_DASHPOT_APPROACH_MAX_ULP. Sampled: tests/table/test_hertz_dashpot.c, against enclosed collisions.
 * Small beta: 1 - eps tends to 0.89390... beta. Large beta: sqrt(4/5) beta^(-5/4).
 * Special values: +-0 -> eps 1, loss 0, duration 2 tau_0; +inf -> 0, 1, +inf. eps 1, loss 0 -> beta 0; eps 0,
 * loss 1 -> +inf; outside the domain and NaN -> NaN. */
#define COR_HERTZ_DASHPOT_APPROACH_MAX_ULP 2.0
COR_HERTZ_DASHPOT_DECLARE_(eps_approach_only)
COR_HERTZ_DASHPOT_DECLARE_(loss_approach_only)
COR_HERTZ_DASHPOT_DECLARE_(beta_approach_only)
COR_HERTZ_DASHPOT_DECLARE_(beta_of_loss_approach_only)
COR_HERTZ_DASHPOT_DECLARE_(duration_approach_only)

#undef COR_HERTZ_DASHPOT_DECLARE_

#ifdef __cplusplus
}
#endif

#endif
