/* SPDX-License-Identifier: MIT */
/* Damping laws of simulators, each in its own dimensionless parameter: restitution from damping, damping from
 * restitution, durations and overlaps. docs/simulators.md lists the law of each simulator, docs/laws.md the parameters
 * to set.
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
 *     approach_only   the force is damped during the approach, and elastic after the turning point
 *
 * The functions are entries of one table, by law, end and quantity:
 *
 *     const struct cor_law_function *tsuji = cor_law_function(COR_LAW_TSUJI, COR_END_ZERO_FORCE, COR_EPS);
 *     double eps = tsuji->value(0.3);
 *     tsuji->array(zeta, eps_of_zeta, n);
 *
 * Three groups of functions have names of their own: viscoelastic spheres (sphere.h), Hunt and Crossley's law with
 * another elastic exponent, and cor_tangential_no_slip for oblique impacts. For floats, call cor_law_arrayf, or call
 * the double function and round its result.
 *
 * cor.h has the rules for threads, memory, the floating-point environment and arrays. For beta >= 0, eps and loss are
 * in [0, 1]. No function uses more than COR_LAW_MAX_STACK bytes of stack; a function of a single number uses at most
 * 4 kB. Only COR_LAW_VISCOELASTIC and COR_LAW_HERTZ_DASHPOT call functions of the C library other than sqrt. */
#ifndef COR_LAW_H
#define COR_LAW_H

#include <stddef.h>

#include "export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bound on the stack of every function, in bytes. Measured in an optimised build, libm included: 17.9 kB. */
#define COR_LAW_MAX_STACK 24576

/* ---- The table of functions ---- */

enum cor_law {
    COR_LAW_VISCOELASTIC,    /* a = 3/2, b = 1/2 */
    COR_LAW_LINEAR,          /* 1, 0 */
    COR_LAW_TSUJI,           /* 3/2, 1/4 */
    COR_LAW_HUNT_CROSSLEY,   /* a = b; both are 3/2 in the table of functions */
    COR_LAW_HERTZ_DASHPOT,   /* 3/2, 0 */
    COR_LAW_PLATE,           /* a sphere on Zener's plate: a = 3/2, b = 1/2, only the end zero overlap */
    COR_LAW_ELASTIC_PLASTIC, /* spheres that yield: a = 3/2, without damping */
    /* used only by simulators */
    COR_LAW_LINEAR_ROOT, /* a linear spring, a dashpot x^(1/2): a = 1, b = 1/2 */
    COR_LAW_IMPULSE,     /* no force: the rebound speed is e times the impact speed, and the damping is 1 - e */
    COR_LAWS
};

/* The nonnegative exponents a = elastic/denominator and b = damping/denominator, in lowest terms. If the largest force
 * has no closed form, cor_law_force_max (scene.h) integrates series in powers that these integers determine. */
struct cor_exponents {
    int elastic, damping, denominator;
};

enum cor_end {
    COR_END_ZERO_OVERLAP,
    COR_END_ZERO_FORCE,
    /* used only by simulators */
    COR_END_LIMITED,       /* the damping force is limited to the spring force */
    COR_END_APPROACH_ONLY, /* damped only while the bodies approach */
    COR_END_INSTANT,       /* an impulse, which takes no time */
    COR_ENDS,
    COR_BOTH_ENDS = -1
};

enum cor_quantity {
    COR_EPS,
    COR_LOSS,                /* 1 - eps, with relative accuracy */
    COR_DAMPING_OF_EPS,      /* the inverse of eps */
    COR_DAMPING_OF_LOSS,     /* the inverse of 1 - eps */
    COR_DURATION,            /* duration of the contact, in units of T */
    COR_MAX_OVERLAP,         /* in units of g T */
    COR_TIME_OF_MAX_OVERLAP, /* in units of T */
    COR_QUANTITIES
};

/* One quantity of a law at an end of contact. x is eps, 1 - eps or the damping: zeta for laws with 2 b - a + 1 = 0
 * (COR_LAW_LINEAR, COR_LAW_TSUJI), beta for the others. */
struct cor_law_function {
    const char *name; /* "linear_eps_zero_force" */
    double (*value)(double x);
    void (*array)(const double *in, double *out, size_t n);
    void (*arrayf)(const float *in, float *out, size_t n); /* in float arithmetic; NULL: absent */
    double least, largest;                                 /* the domain: NaN outside */
    double max_ulp; /* bound on the error of value and array, in units of the last place of the exact value */
};

/* Returns the function, or NULL for a combination that does not exist or an argument that is not in its enum. */
#if defined(__cplusplus) && defined(__GNUC__) /* g++ -Wshadow warns that the function has the name of a struct */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#endif
COR_API const struct cor_law_function *cor_law_function(enum cor_law law, enum cor_end end, enum cor_quantity quantity);
#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

/* Returns the value of the function at x; NaN if the function does not exist. */
COR_API double cor_law_value(enum cor_law law, enum cor_end end, enum cor_quantity quantity, double x);

/* Sets out[i] to the bits of the value at in[i] for i < n; NaN if the function does not exist. */
COR_API void cor_law_array(enum cor_law law, enum cor_end end, enum cor_quantity quantity, const double *in,
                           double *out, size_t n);

/* Does the same for floats: calls `arrayf` if the function has one, and otherwise rounds each value once. */
COR_API void cor_law_arrayf(enum cor_law law, enum cor_end end, enum cor_quantity quantity, const float *in, float *out,
                            size_t n);

/* Return names: "hunt-crossley", "zero-force", "damping-of-eps"; NULL for an argument that is not in its enum. */
COR_API const char *cor_law_name(enum cor_law law);
COR_API const char *cor_end_name(enum cor_end end);
COR_API const char *cor_quantity_name(enum cor_quantity quantity);

/* ---- The functions of the table ----
 *
 * The bounds max_ulp hold for every double of the domain, subnormal arguments and results included. They are sampled at
 * random arguments and around every boundary. tests/accuracy/test_laws.c asserts them against MPFR in another
 * formulation. For Hertz's dashpot, tests/table/test_hertz_dashpot.c asserts them against enclosed collisions;
 * docs/accuracy.md records the worst cases found. In all laws:
 *
 *     COR_EPS              from one double to the next, eps never rises by more than two units of its last place
 *     COR_LOSS             1 - eps with relative accuracy, without the cancellation of a subtraction
 *     COR_DAMPING_OF_EPS   the smallest damping that has this eps, with the given double treated as exact. Near eps = 1
 *                          one unit of its last place changes the damping much; use COR_DAMPING_OF_LOSS there
 *     COR_MAX_OVERLAP,     equal at the ends zero overlap, zero force and approach only; absent for the limited end
 *     COR_TIME_OF_MAX_OVERLAP
 *
 * Damping 0 gives eps 1 and loss 0; damping +inf gives eps 0 and loss 1. The inverses return +inf if the damping
 * exceeds the largest double.
 *
 * Linear dashpot (a = 1, b = 0) and Tsuji's damping (a = 3/2, b = 1/4): x is the damping ratio zeta. For the linear
 * dashpot beta = 2 zeta and zeta = C/(2 sqrt(m K)); for Tsuji's damping beta = sqrt(5) zeta and zeta = C/sqrt(5 m K).
 * eps is the same function of zeta for both laws, and independent of the impact speed. With
 *
 *     A(zeta) = acos(zeta)/sqrt(1 - zeta^2),   1 for zeta = 1,   acosh(zeta)/sqrt(zeta^2 - 1) for zeta > 1
 *
 * -ln(eps) depends on the end:
 *     zero overlap   pi zeta/sqrt(1 - zeta^2) for zeta < 1; for zeta >= 1 the bodies stay together and eps is 0
 *     zero force     2 zeta A(zeta)                                       approach only  zeta A(zeta)
 *     limited        zeta (2 A(zeta) - atan2(2 zeta sqrt(1 - zeta^2), 1 + 2 zeta^2)/sqrt(1 - zeta^2)), continued
 *                    analytically beyond zeta = 1
 * The linear dashpot has the durations, largest overlap and time of the largest overlap
 *
 *     zero overlap   pi/sqrt(1 - zeta^2), +inf for zeta >= 1     zero force     2 A(zeta)
 *     approach only  A(zeta) + pi/2
 *     limited        atan(2 sqrt(2) zeta)/sqrt(2) - ln(eps)/zeta
 *     largest overlap  exp(-zeta A(zeta))                        its time       A(zeta)
 *
 * Tsuji's largest overlap is ((5/4) eps)^(2/5) with eps at zero force; his durations tend to 3.2180... as zeta -> 0,
 * and to 0 (zero force), +inf (approach only) and 0.9... (limited) as zeta -> inf.
 * Source: docs/laws.md; the formula at zero force combines the three cases of Schwager and Poeschel, Granular Matter 9,
 * 465 (2007).
 *
 * Hunt and Crossley's law, F = F_el(x) (1 + d x'): for every elastic force F_el(x), eps depends only on beta = d g. The
 * ends zero overlap and zero force coincide. With f(z) = z - ln(1 + z), eps is the solution of f(-beta eps) = f(beta);
 * with damping during the approach only, eps is sqrt(2 f(beta))/beta. In the range -1 < beta < 0 the force adds energy,
 * eps is above 1 and the loss negative. The largest overlap and the times are those for F_el = K x^(3/2); the times
 * need beta >= 0. Large beta: eps tends to 1/beta, or to sqrt(2/beta) with damping during the approach only.
 * Source: docs/laws.md; Hunt and Crossley, J. Appl. Mech. 42, 440 (1975), for the law.
 *
 * Hertz's contact with a constant dashpot (a = 3/2, b = 0): beta = C m^(-3/5) K^(-2/5) g^(-1/5), so slow impacts are
 * damped most strongly. At zero overlap the bodies never part if beta >= COR_HERTZ_DASHPOT_BETA_C, which means g <=
 * C^5/(COR_HERTZ_DASHPOT_BETA_C^5 m^3 K^2): eps is exactly 0 and the duration infinite. The inverse of eps = 0 is
 * COR_HERTZ_DASHPOT_BETA_C. With damping during the approach only, eps = sqrt((4/5) Y^(5/2)) and the duration is the
 * time of the largest overlap + tau_0 eps^(-1/5). Here Y is the largest overlap of the full law, and tau_0 = 1.6090...
 * Small beta: the loss tends to 1.78781... beta, or to 0.89390... beta for approach only. Large beta: eps tends to
 * beta^(-5/2) at zero force, or to sqrt(4/5) beta^(-5/4) for approach only. At zero overlap just below beta_c, with
 * d = beta_c - beta, eps is near s d (1 + pi sqrt(s d/beta_c^5)), s = 0.206987698804...
 * Source: docs/theory.md, 9.
 *
 * beta_c = 1.127988135520169216213..., rounded to the nearest double, which is below it: */
#define COR_HERTZ_DASHPOT_BETA_C 1.12798813552016922

/* ---- Hunt and Crossley's law with the elastic exponent a of F_el = K x^a ----
 *
 * All elements of an array have the same exponent. */

/* double cor_hunt_crossley_max_overlap(double beta, double elastic_exponent): largest overlap,
 * ((a + 1) f(beta)/beta^2)^(1/(a + 1)), in units of g T.
 * Domain: -1 < beta <= inf, 0 <= a < inf. Accuracy: COR_HUNT_CROSSLEY_MAX_ULP.
 * Special values: beta = +-0 -> ((a + 1)/2)^(1/(a + 1)), +inf -> 0; outside the domain and NaN -> NaN. */
#define COR_HUNT_CROSSLEY_MAX_ULP 2.0
COR_API double cor_hunt_crossley_max_overlap(double beta, double elastic_exponent);
COR_API void cor_hunt_crossley_max_overlap_array(const double *beta, double elastic_exponent, double *y, size_t n);

/* double cor_hunt_crossley_duration(double beta, double elastic_exponent), _duration_approach_only,
 * _time_of_max_overlap: times in units of T.
 * Domain: -1 < beta <= inf, 0 <= a < inf. Accuracy: for a = 1 or 3/2 and beta >= 0 tables give
 * COR_HUNT_CROSSLEY_MAX_ULP. Otherwise, for a <= COR_HUNT_CROSSLEY_MAX_EXPONENT, a quadrature of a few microseconds has
 * a relative error of at most COR_HUNT_CROSSLEY_TIME_MAX_ERROR.
 * Special values: beta = +-0 -> the times of the elastic collision, which are pi and pi/2 for a = 1; +inf -> +inf
 * (duration), 0 (time of the largest overlap); a > COR_HUNT_CROSSLEY_MAX_EXPONENT, outside the domain and
 * NaN -> NaN. */
#define COR_HUNT_CROSSLEY_TIME_MAX_ERROR 1e-14
#define COR_HUNT_CROSSLEY_MAX_EXPONENT 100.0
COR_API double cor_hunt_crossley_duration(double beta, double elastic_exponent);
COR_API void cor_hunt_crossley_duration_array(const double *beta, double elastic_exponent, double *y, size_t n);
COR_API double cor_hunt_crossley_duration_approach_only(double beta, double elastic_exponent);
COR_API void cor_hunt_crossley_duration_approach_only_array(const double *beta, double elastic_exponent, double *y,
                                                            size_t n);
COR_API double cor_hunt_crossley_time_of_max_overlap(double beta, double elastic_exponent);
COR_API void cor_hunt_crossley_time_of_max_overlap_array(const double *beta, double elastic_exponent, double *y,
                                                         size_t n);

/* ---- Oblique impact without slip ----
 *
 * A tangential spring with the stiffness k_t x^(a-1) at the overlap x acts together with an elastic force K x^a without
 * damping. The displacement s of the contact point obeys s'' + kappa x^(a-1) s = 0, where x'' = -x^a. Here kappa is
 * (k_t/K) (effective mass)/(effective mass of the contact point in the tangential direction), which is (7/2) k_t/K
 * for homogeneous spheres (cor_tangential_kappa of contact.h). */

/* double cor_tangential_no_slip(double kappa, double elastic_exponent): the tangential velocity of the contact point
 * after the collision, divided by its velocity before,
 *
 *     u'/u = cos(pi sqrt((a - 1)^2 + 8 (a + 1) kappa)/(2 (a + 1)))/cos(pi (a - 1)/(2 (a + 1)))
 *
 * -1 is a full reversal, 1 means no change. This formula also holds if the tangential force f is accumulated in
 * increments, f' = kappa x^(a-1) s', instead of computed from s. Friction is assumed to be strong enough;
 * cor_tangential_stick_angle gives the limit.
 * Domain: 0 <= kappa <= COR_NO_SLIP_MAX_KAPPA, COR_NO_SLIP_MIN_EXPONENT <= a <= COR_NO_SLIP_MAX_EXPONENT.
 * Accuracy: COR_NO_SLIP_MAX_ULP, also next to the zeros of the cosine; proved in runtime/law/tangential.c, sampled in
 * tests/accuracy/test_laws.c.
 * Special values: kappa = 0 -> 1; kappa = 1 and kappa = a -> -1; a zero of the cosine -> 0; outside the domain and
 * NaN -> NaN. Source: docs/theory.md, 20. */
#define COR_NO_SLIP_MAX_ULP 0.51
#define COR_NO_SLIP_MAX_KAPPA 1e6
#define COR_NO_SLIP_MIN_EXPONENT 1e-6
#define COR_NO_SLIP_MAX_EXPONENT 100.0
COR_API double cor_tangential_no_slip(double kappa, double elastic_exponent);
COR_API void cor_tangential_no_slip_array(const double *kappa, double elastic_exponent, double *y, size_t n);

#ifdef __cplusplus
}
#endif

#endif
