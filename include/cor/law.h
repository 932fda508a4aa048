/* SPDX-License-Identifier: MIT */
/* Damping laws of simulators, each in its own dimensionless parameter: the functions compute restitution from damping
 * and damping from restitution. docs/simulators.md lists the law of each simulator, docs/laws.md the parameters to set.
 *
 * Two bodies of effective mass m meet with speed g. At the overlap x the force K x^a + C x^b x' acts between them. In
 * units of time T = (m/K)^(1/(a+1)) g^((1-a)/(a+1)) and of length g T,
 *
 *     x'' + beta x^b x' + x^a = 0,     x(0) = 0,     x'(0) = 1,     beta = (C/m) g^b T^(b+1)
 *
 * eps = -x' when the contact ends. Simulators end it in four ways:
 *
 *     zero_overlap    x = 0 again; the force is attractive just before
 *     zero_force      x'' = 0; the end in codes with "no attraction", "limit damping" or max(0, F)
 *     limited         the damping force is at most as large as the elastic force: 0 <= F <= 2 K x^a
 *     approach_only   the force is damped while the bodies approach, and elastic from the turning point on
 *
 * Each name below stands for four functions, NAME, NAMEf, NAME_array and NAME_arrayf. <end> is one of the four ends:
 * cor_linear_eps_zero_force and so on.
 *
 *     cor_linear_eps_<end>               cor_tsuji_eps_<end>                cor_hunt_crossley_eps
 *     cor_linear_loss_<end>              cor_tsuji_loss_<end>               cor_hunt_crossley_loss
 *     cor_linear_zeta_<end>              cor_tsuji_zeta_<end>               cor_hunt_crossley_beta
 *     cor_linear_zeta_of_loss_<end>      cor_tsuji_zeta_of_loss_<end>       cor_hunt_crossley_beta_of_loss
 *     cor_linear_duration_<end>          cor_tsuji_duration_<end>           cor_hunt_crossley_duration
 *     cor_linear_max_overlap             cor_tsuji_max_overlap              cor_hunt_crossley_max_overlap
 *     cor_linear_time_of_max_overlap     cor_tsuji_time_of_max_overlap      cor_hunt_crossley_time_of_max_overlap
 *
 * and, of oblique impacts, for cor_tangential_no_slip.
 *
 * Those of Hunt and Crossley but the last two also end in _approach_only. hertz_dashpot.h, which this header includes,
 * has Hertz's force with a constant dashpot, and sphere.h the viscoelastic sphere.
 *
 * cor.h says what holds of threads, memory, the floating-point environment and arrays; eps and loss stay in [0, 1]
 * where beta >= 0. No function uses more bytes of stack than COR_LAW_MAX_STACK (4 kB, if it is not of arrays), and sqrt
 * is the only function of the C library in use. */
#ifndef COR_LAW_H
#define COR_LAW_H

#include <stddef.h>

#include "export.h"
#include "hertz_dashpot.h" /* Hertz with a constant dashpot */

#ifdef __cplusplus
extern "C" {
#endif

/* ---- The table of functions ---- */

enum cor_law {
    COR_LAW_VISCOELASTIC,    /* a = 3/2, b = 1/2 */
    COR_LAW_LINEAR,          /* 1, 0 */
    COR_LAW_TSUJI,           /* 3/2, 1/4 */
    COR_LAW_HUNT_CROSSLEY,   /* a, a; by name 3/2, 3/2 */
    COR_LAW_HERTZ_DASHPOT,   /* 3/2, 0 */
    COR_LAW_PLATE,           /* a sphere on Zener's plate: 3/2, 1/2, and only the end zero overlap */
    COR_LAW_ELASTIC_PLASTIC, /* spheres that yield: 3/2, without damping */
    /* of simulators alone */
    COR_LAW_LINEAR_ROOT, /* 1, 1/2 */
    COR_LAW_IMPULSE,     /* no force: the rebound speed is e times the impact speed, and the damping is 1 - e */
    COR_LAWS
};

enum cor_end {
    COR_END_ZERO_OVERLAP,
    COR_END_ZERO_FORCE,
    /* of simulators alone */
    COR_END_LIMITED,       /* the damping force is limited to the spring's */
    COR_END_APPROACH_ONLY, /* damped only while the bodies approach */
    COR_END_INSTANT,       /* of an impulse */
    COR_ENDS,
    COR_BOTH_ENDS = -1
};

enum cor_quantity {
    COR_EPS,
    COR_LOSS,                /* 1 - eps, with relative accuracy */
    COR_DAMPING_OF_EPS,      /* the inverse of eps */
    COR_DAMPING_OF_LOSS,     /* the inverse of 1 - eps */
    COR_DURATION,            /* of the contact, in units of T */
    COR_MAX_OVERLAP,         /* in units of g T */
    COR_TIME_OF_MAX_OVERLAP, /* in units of T */
    COR_QUANTITIES
};

/* One quantity of a law at an end of contact. x is the damping (zeta for COR_LAW_LINEAR and COR_LAW_TSUJI, beta for the
 * others), eps or 1 - eps. */
struct cor_law_function {
    const char *name; /* "linear_eps_zero_force" */
    double (*value)(double x);
    void (*array)(const double *in, double *out, size_t n);
    void (*arrayf)(const float *in, float *out, size_t n); /* in float arithmetic; NULL: absent */
    double least, largest;                                 /* the domain: NaN outside */
    double max_ulp; /* bound on the error of value and array, in units of the last place of the exact value */
};

/* Returns the function, or NULL for a combination that does not exist or an argument that is not in its enum. Look it
 * up once and call it often. */
COR_API const struct cor_law_function *cor_law_function(enum cor_law law, enum cor_end end, enum cor_quantity quantity);

/* Returns the function's value at x; NaN if the function does not exist. */
COR_API double cor_law_value(enum cor_law law, enum cor_end end, enum cor_quantity quantity, double x);

/* Sets out[i] to the bits of the value at in[i] for i < n; NaN if the function does not exist. */
COR_API void cor_law_array(enum cor_law law, enum cor_end end, enum cor_quantity quantity, const double *in,
                           double *out, size_t n);

/* The same for floats: by `arrayf` if the function has one, otherwise the value rounded once. */
COR_API void cor_law_arrayf(enum cor_law law, enum cor_end end, enum cor_quantity quantity, const float *in, float *out,
                            size_t n);

/* Names: "hunt-crossley", "zero-force", "damping-of-eps". NULL for an argument that is not in its enum. */
COR_API const char *cor_law_name(enum cor_law law);
COR_API const char *cor_end_name(enum cor_end end);
COR_API const char *cor_quantity_name(enum cor_quantity quantity);

/* Bounds on the error of the functions below, in units of the last place of the exact value, over every double in their
 * domains, subnormal arguments and results included. Sampled: tests/accuracy/test_laws.c asserts them against MPFR in
 * another formulation, at random arguments and around every boundary; docs/accuracy.md records the worst cases
 * found. */
#define COR_LAW_EPS_MAX_ULP 2.0
#define COR_LAW_LOSS_MAX_ULP 2.0
#define COR_LAW_INVERSE_MAX_ULP 2.0
#define COR_LAW_MAX_OVERLAP_MAX_ULP 2.0
#define COR_LAW_TIME_MAX_ULP 2.0
/* Bound on the error of the float variants, in units of the last place of a float. */
#define COR_LAW_FLOAT_MAX_ULP 1.0
/* Bytes of stack, of this header and of hertz_dashpot.h; 17.9 kB are measured in an optimised build, libm included. */
#define COR_LAW_MAX_STACK 24576

#define COR_LAW_DECLARE_(function)                                                                                     \
    COR_API double cor_##function(double x);                                                                           \
    COR_API float cor_##function##f(float x);                                                                          \
    COR_API void cor_##function##_array(const double *x, double *y, size_t n);                                         \
    COR_API void cor_##function##_arrayf(const float *x, float *y, size_t n);
#define COR_LAW_DECLARE_ENDS_(function)                                                                                \
    COR_LAW_DECLARE_(function##_zero_overlap)                                                                          \
    COR_LAW_DECLARE_(function##_zero_force)                                                                            \
    COR_LAW_DECLARE_(function##_limited)                                                                               \
    COR_LAW_DECLARE_(function##_approach_only)

/* ---- The linear dashpot (a = 1, b = 0) and Tsuji's damping (a = 3/2, b = 1/4) ----
 *
 * The parameter of both laws is the damping ratio zeta. For the linear dashpot beta = 2 zeta and zeta = C/(2 sqrt(m
 * K)); for Tsuji's damping beta = sqrt(5) zeta and zeta = C/sqrt(5 m K). eps is the same function of zeta for both
 * laws, and independent of the impact speed. With
 *
 *     A(zeta) = acos(zeta)/sqrt(1 - zeta^2),   1 for zeta = 1,   acosh(zeta)/sqrt(zeta^2 - 1) for zeta > 1
 *
 * -ln(eps) is pi zeta/sqrt(1 - zeta^2) at zero overlap (zeta < 1; from zeta = 1 on the bodies stay together and eps is
 * 0), 2 zeta A(zeta) at zero force, zeta A(zeta) with damping during the approach only, and zeta (2 A(zeta) - atan2(2
 * zeta sqrt(1 - zeta^2), 1 + 2 zeta^2)/sqrt(1 - zeta^2)) with the limited damper. The last expression is continued
 * analytically beyond zeta = 1. */

/* double cor_linear_eps_<end>(double zeta): restitution coefficient; <end> is one of the four ends above.
 * Domain: 0 <= zeta <= inf. Accuracy: COR_LAW_EPS_MAX_ULP. 0 <= eps <= 1, and from one double zeta to the next eps
 * never rises by more than two units of its last place.
 * Large zeta: 1/(4 zeta^2) (zero force), 1/(2 zeta) (approach only), 1/(2 sqrt(2) zeta) (limited).
 * Special values: +-0 -> 1, +inf -> 0; at zero overlap 0 for zeta >= 1; negative and NaN -> NaN.
 * Source: docs/laws.md; at zero force the three cases of Schwager and Poeschel, Granular Matter 9, 465 (2007), in
 * one. */
COR_LAW_DECLARE_ENDS_(linear_eps)

/* double cor_linear_loss_<end>(double zeta): 1 - eps with relative accuracy, also where a subtraction would cancel. As
 * zeta -> 0 the loss tends to pi zeta, or to pi zeta/2 with damping during the approach only, down to the smallest
 * subnormal.
 * Domain: 0 <= zeta <= inf. Accuracy: COR_LAW_LOSS_MAX_ULP.
 * Special values: +-0 -> 0, +inf -> 1; at zero overlap 1 for zeta >= 1; negative and NaN -> NaN. Source: as eps. */
COR_LAW_DECLARE_ENDS_(linear_loss)

/* double cor_linear_zeta_<end>(double eps): the inverse, the smallest zeta that has this eps.
 * Domain: 0 <= eps <= 1. Accuracy: COR_LAW_INVERSE_MAX_ULP with the given double eps taken as exact. (Near eps = 1, one
 * unit of its last place changes zeta much; the function below takes 1 - eps instead.)
 * Special values: 1 -> 0; 0 -> +inf, at zero overlap 1; +inf where zeta is beyond the largest double (approach only and
 * limited, eps below 2.8e-309 and 2.0e-309); outside [0, 1] and NaN -> NaN.
 * Source: at zero overlap L/sqrt(pi^2 + L^2), L = -ln(eps); the others solve the equations above. */
COR_LAW_DECLARE_ENDS_(linear_zeta)

/* double cor_linear_zeta_of_loss_<end>(double loss): the inverse as a function of 1 - eps.
 * Domain: 0 <= loss <= 1. Accuracy: COR_LAW_INVERSE_MAX_ULP. Special values: 0 -> 0; 1 -> +inf, at zero overlap 1;
 * outside [0, 1] and NaN -> NaN. */
COR_LAW_DECLARE_ENDS_(linear_zeta_of_loss)

/* double cor_linear_duration_<end>(double zeta): duration of the contact in units of sqrt(m/K):
 *
 *     zero overlap   pi/sqrt(1 - zeta^2)            zero force       2 A(zeta)
 *     approach only  A(zeta) + pi/2                 limited          atan(2 sqrt(2) zeta)/sqrt(2) - ln(eps)/zeta
 *
 * Domain: 0 <= zeta <= inf. Accuracy: COR_LAW_TIME_MAX_ULP.
 * Special values: +-0 -> pi; +inf -> 0 (zero force), pi/2 (approach only), pi/(2 sqrt(2)) (limited); at zero overlap
 * +inf for zeta >= 1; negative and NaN -> NaN. */
COR_LAW_DECLARE_ENDS_(linear_duration)

/* double cor_linear_max_overlap(double zeta): largest overlap of the full law, exp(-zeta A(zeta)), in units of g
 * sqrt(m/K).
 * double cor_linear_time_of_max_overlap(double zeta): the time of the largest overlap, A(zeta), in units of sqrt(m/K).
 * Domain: 0 <= zeta <= inf. Accuracy: COR_LAW_MAX_OVERLAP_MAX_ULP, COR_LAW_TIME_MAX_ULP.
 * Special values: +-0 -> 1 and pi/2, +inf -> 0 and 0; negative and NaN -> NaN. */
COR_LAW_DECLARE_(linear_max_overlap)
COR_LAW_DECLARE_(linear_time_of_max_overlap)

/* The same functions for Tsuji's damping. eps, loss and their inverses equal those of the linear dashpot. Durations and
 * times are in units of T = (m/K)^(2/5) g^(-1/5), as for the sphere (sphere.h). The largest overlap is ((5/4)
 * eps)^(2/5) in units of g T, with eps at zero force.
 * Special values of times: +-0 -> 3.2180... (durations, those of the sphere), 1.6090... (of the largest overlap); +inf
 * -> 0, but +inf with damping during the approach only and 0.9... with the limited damper; at zero overlap +inf for
 * zeta >= 1. */
COR_LAW_DECLARE_ENDS_(tsuji_eps)
COR_LAW_DECLARE_ENDS_(tsuji_loss)
COR_LAW_DECLARE_ENDS_(tsuji_zeta)
COR_LAW_DECLARE_ENDS_(tsuji_zeta_of_loss)
COR_LAW_DECLARE_ENDS_(tsuji_duration)
COR_LAW_DECLARE_(tsuji_max_overlap)
COR_LAW_DECLARE_(tsuji_time_of_max_overlap)

/* ---- Hunt and Crossley's law: F = F_el(x) (1 + d x') ----
 *
 * For every elastic force F_el(x), eps depends on beta = d g alone. The ends zero overlap and zero force coincide. With
 * f(z) = z - ln(1 + z), eps is the solution of f(-beta eps) = f(beta); with damping during the approach only, eps is
 * sqrt(2 f(beta))/beta. In the range -1 < beta < 0 the force adds energy, and eps is above 1. */

/* double cor_hunt_crossley_eps(double beta), cor_hunt_crossley_eps_approach_only: restitution coefficient.
 * Domain: -1 < beta <= inf. Accuracy: COR_LAW_EPS_MAX_ULP.
 * Large beta: 1/beta, to the last bit from beta = 45 on; sqrt(2/beta) with damping during the approach only.
 * Special values: +-0 -> 1, +inf -> 0; beta <= -1 and NaN -> NaN.
 * Source: docs/laws.md; Hunt and Crossley, J. Appl. Mech. 42, 440 (1975), for the law. */
COR_LAW_DECLARE_(hunt_crossley_eps)
COR_LAW_DECLARE_(hunt_crossley_eps_approach_only)

/* double cor_hunt_crossley_loss(double beta), cor_hunt_crossley_loss_approach_only: 1 - eps with relative accuracy. As
 * beta -> 0 the loss tends to (2/3) beta, or to beta/3 with damping during the approach only. It is negative where beta
 * is negative.
 * Domain: -1 < beta <= inf. Accuracy: COR_LAW_LOSS_MAX_ULP.
 * Special values: +-0 -> 0, +inf -> 1; beta <= -1 and NaN -> NaN. */
COR_LAW_DECLARE_(hunt_crossley_loss)
COR_LAW_DECLARE_(hunt_crossley_loss_approach_only)

/* double cor_hunt_crossley_beta(double eps), cor_hunt_crossley_beta_approach_only: the inverse, beta = 2 y/(1 + eps),
 * where y solves coth(y) - 1/y = (1 - eps)/(1 + eps) (y is the inverse Langevin function).
 * Domain: 0 <= eps <= 1. Accuracy: COR_LAW_INVERSE_MAX_ULP with the given double eps taken as exact.
 * Special values: 1 -> 0, 0 -> +inf; +inf where beta is beyond the largest double (eps below 5.6e-309, approach only
 * 1.1e-154); outside [0, 1] and NaN -> NaN. */
COR_LAW_DECLARE_(hunt_crossley_beta)
COR_LAW_DECLARE_(hunt_crossley_beta_approach_only)

/* double cor_hunt_crossley_beta_of_loss(double loss), cor_hunt_crossley_beta_of_loss_approach_only: the inverse as a
 * function of 1 - eps.
 * Domain: 0 <= loss <= 1. Accuracy: COR_LAW_INVERSE_MAX_ULP. Special values: 0 -> 0, 1 -> +inf; outside [0, 1] and
 * NaN -> NaN. */
COR_LAW_DECLARE_(hunt_crossley_beta_of_loss)
COR_LAW_DECLARE_(hunt_crossley_beta_of_loss_approach_only)

/* Functions of beta and of the elastic exponent a of F_el = K x^a. All elements of an array have the same exponent. */
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
 * _time_of_max_overlap: times in units of T = (m/K)^(1/(a+1)) g^((1-a)/(a+1)).
 * Domain: -1 < beta <= inf, 0 <= a < inf. Accuracy: for a = 1 or 3/2 and beta >= 0 tables give COR_LAW_TIME_MAX_ULP.
 * For beta < 0 and for every other a <= COR_HUNT_CROSSLEY_MAX_EXPONENT, a quadrature of a few microseconds gives
 * COR_HUNT_CROSSLEY_TIME_MAX_ERROR, relative, for every beta.
 * Special values: beta = +-0 -> the elastic collision's, for a = 1 pi and pi/2; +inf -> +inf (duration), 0 (time of the
 * largest overlap); a > COR_HUNT_CROSSLEY_MAX_EXPONENT, outside the domain and NaN -> NaN. */
#define COR_HUNT_CROSSLEY_TIME_MAX_ERROR 1e-14
#define COR_HUNT_CROSSLEY_MAX_EXPONENT 100.0
COR_LAW_DECLARE_WITH_EXPONENT_(hunt_crossley_duration)
COR_LAW_DECLARE_WITH_EXPONENT_(hunt_crossley_duration_approach_only)
COR_LAW_DECLARE_WITH_EXPONENT_(hunt_crossley_time_of_max_overlap)

/* ---- Oblique impact without slip ----
 *
 * A tangential spring with the stiffness k_t x^(a-1) at the overlap x acts beside an elastic force K x^a without
 * damping. The displacement s of the contact point obeys s'' + kappa x^(a-1) s = 0 beside x'' = -x^a. Here kappa is
 * k_t/K times the effective mass over the mass that the contact point feels: (7/2) k_t/K for homogeneous spheres
 * (cor_tangential_kappa of contact.h). */

/* double cor_tangential_no_slip(double kappa, double elastic_exponent): the tangential velocity of the contact point
 * after the collision over that before,
 *
 *     u'/u = cos(pi sqrt((a - 1)^2 + 8 (a + 1) kappa)/(2 (a + 1)))/cos(pi (a - 1)/(2 (a + 1)))
 *
 * -1 is a full reversal, 1 means that the spring gave back what it took. The same holds where the force, not the
 * displacement, is what the contact remembers: f' = kappa x^(a-1) s'. Friction is assumed to be strong enough;
 * cor_tangential_stick_angle says where it is not.
 * Domain: 0 <= kappa <= COR_NO_SLIP_MAX_KAPPA, COR_NO_SLIP_MIN_EXPONENT <= a <= COR_NO_SLIP_MAX_EXPONENT.
 * Accuracy: COR_NO_SLIP_MAX_ULP, next to the zeros of the cosine, too; proved in runtime/law/tangential.c, sampled in
 * tests/accuracy/test_laws.c. That of the float variants is COR_LAW_FLOAT_MAX_ULP.
 * Special values: kappa = 0 -> 1; kappa = 1 and kappa = a -> -1; a zero of the cosine -> 0; outside the domain and
 * NaN -> NaN. Source: docs/theory.md, 20. */
#define COR_NO_SLIP_MAX_ULP 0.51
#define COR_NO_SLIP_MAX_KAPPA 1e6
#define COR_NO_SLIP_MIN_EXPONENT 1e-6
#define COR_NO_SLIP_MAX_EXPONENT 100.0
COR_API double cor_tangential_no_slip(double kappa, double elastic_exponent);
COR_API float cor_tangential_no_slipf(float kappa, float elastic_exponent);
COR_API void cor_tangential_no_slip_array(const double *kappa, double elastic_exponent, double *y, size_t n);
COR_API void cor_tangential_no_slip_arrayf(const float *kappa, float elastic_exponent, float *y, size_t n);

#undef COR_LAW_DECLARE_
#undef COR_LAW_DECLARE_ENDS_
#undef COR_LAW_DECLARE_WITH_EXPONENT_

#ifdef __cplusplus
}
#endif

#endif
