/* SPDX-License-Identifier: MIT */
/* Every function of law.h that has a closed form against long double in another formulation, and against balls where
 * long double has too few digits: random points, doubles near every boundary of a kernel, the neighbours of the worst
 * point, special values. Prints one line for each function; these lines are what docs/accuracy.md quotes.
 *     test_laws [--points N] [--threads N] [--only TEXT] [--seed N]     (N random points of each function, 20000 if not
 *     said) */
#include "cor/law.h"

#include <stdio.h>

#include "ball_value.h"
#include "enclosure/collision.h"
#include "reference_law.h"
#include "search.h"
#include "support/formula.h"
#include "support/local.h"
#include "ulp.h"

/* ---- the exact values ---- */

enum { BALL_BITS = 256 };

/* exp(x), -exp(x) expm1 and so on of a long double keep what the double needs up to this L. */
static const long double far_exponent = 16;

/* exp(-share L), L by acos, acosh and logarithms, in balls; with limited damping for zeta > 1 */
static long double eps_far(enum law_end end, double zeta, struct ratio share)
{
    LOCAL(arb, l, om, phase);
    LET(om, BALL_BITS, "sqrt(abs(1 - zeta^2))", zeta);
    if (end == LAW_ZERO_OVERLAP)
        arb_const_pi(phase, BALL_BITS);
    else if (zeta > 1)
        LET(phase, BALL_BITS, "acosh(zeta)", zeta);
    else
        LET(phase, BALL_BITS, "acos(zeta)", zeta);
    if (end == LAW_ZERO_FORCE)
        LET(phase, BALL_BITS, "2*phase", phase);
    if (end == LAW_LIMITED)
        LET(phase, BALL_BITS, "2*phase - log(1 + 2*zeta^2 + 2*zeta*om) + log1p(8*zeta^2)/2", phase, zeta, om);
    LET(l, BALL_BITS, "exp(-share*zeta*phase/om)", share, zeta, phase, om);
    return ball_value(l);
}

/* eps or 1 - eps */
static long double ratio(enum law_end end, bool loss, long double zeta)
{
    if (zeta == 0)
        return !loss;
    if (isinf(zeta) || (end == LAW_ZERO_OVERLAP && zeta >= 1))
        return loss;
    const long double l = reference_ratio_exponent(end, zeta);
    return loss ? -expm1l(-l) : l < far_exponent ? expl(-l) : eps_far(end, (double)zeta, RATIO("1"));
}

/* ---- what is tested ---- */

enum family { RATIO, CROSSLEY, CROSSLEY_APPROACH, CROSSLEY_TIMES };
enum { SLOW_SHARE = 400 }; /* where the reference takes 0.1 ms */

#define ROW(name, shape, law, end, exact, max_ulp, share)                                                              \
    {                                                                                                                  \
#name, cor_##name, shape, max_ulp, law, end, exact, share                                                      \
    }
#define RATIO_ROWS(name, end)                                                                                          \
    ROW(linear_eps_##name, EPS, RATIO, end, NULL, COR_LAW_EPS_MAX_ULP, 0),                                             \
        ROW(linear_loss_##name, LOSS, RATIO, end, NULL, COR_LAW_LOSS_MAX_ULP, 0),                                      \
        ROW(linear_zeta_##name, INVERSE, RATIO, end, NULL, COR_LAW_INVERSE_MAX_ULP, 0),                                \
        ROW(linear_zeta_of_loss_##name, INVERSE_OF_LOSS, RATIO, end, NULL, COR_LAW_INVERSE_MAX_ULP, 0)
#define CROSSLEY_ROWS(law, suffix)                                                                                     \
    ROW(hunt_crossley_eps##suffix, EPS, law, 0, NULL, COR_LAW_EPS_MAX_ULP, 0),                                         \
        ROW(hunt_crossley_loss##suffix, LOSS, law, 0, NULL, COR_LAW_LOSS_MAX_ULP, 0),                                  \
        ROW(hunt_crossley_beta##suffix, INVERSE, law, 0, NULL, COR_LAW_INVERSE_MAX_ULP, 0),                            \
        ROW(hunt_crossley_beta_of_loss##suffix, INVERSE_OF_LOSS, law, 0, NULL, COR_LAW_INVERSE_MAX_ULP, 0)
#define TIME COR_LAW_TIME_MAX_ULP
#define OVERLAP COR_LAW_MAX_OVERLAP_MAX_ULP

/* The largest overlap and times as functions of zeta: name, bound, share of the points; value at 0, at infinity,
 * elsewhere. Tsuji's damping: the largest overlap is (5/4 eps)^(2/5). By Gamma functions half of the elastic duration,
 * and the duration of limited damping without bound: (5/8)^(2/5) times the integral of (1 - X^(5/2))^(-1/2) from 0 to
 * 1. */
#define PI acosl(-1)
#define PHASE reference_ratio_exponent(LAW_APPROACH_ONLY, zeta)
#define TSUJI_MOST expl(0.4L * logl(1.25L))
#define HALF (TSUJI_MOST * sqrtl(PI) * tgammal(1.4L) / tgammal(0.9L))
#define LAST (powl(0.625L, 0.4L) * sqrtl(PI) * tgammal(1.4L) / tgammal(0.9L))
#define OF_ZETA(X)                                                                                                     \
    X(linear_duration_zero_overlap, TIME, 0, PI, HUGE_VALL,                                                            \
      zeta < 1 ? PI / sqrtl((1 - (long double)zeta) * (1 + (long double)zeta)) : HUGE_VALL)                            \
    X(linear_duration_zero_force, TIME, 0, PI, 0, 2 * PHASE / zeta)                                                    \
    X(linear_duration_limited, TIME, 0, PI, PI / sqrtl(8),                                                             \
      atanl(sqrtl(8) * zeta) / sqrtl(2) + reference_ratio_exponent(LAW_LIMITED, zeta) / zeta)                          \
    X(linear_duration_approach_only, TIME, 0, PI, PI / 2, PI / 2 + PHASE / zeta)                                       \
    X(linear_max_overlap, OVERLAP, 0, 1, 0, ratio(LAW_APPROACH_ONLY, false, zeta))                                     \
    X(linear_time_of_max_overlap, TIME, 0, PI / 2, 0, PHASE / zeta)                                                    \
    X(tsuji_max_overlap, OVERLAP, 0, TSUJI_MOST, 0,                                                                    \
      TSUJI_MOST *(2 * PHASE < far_exponent ? expl(-0.8L * PHASE) : eps_far(LAW_ZERO_FORCE, zeta, RATIO("2/5"))))      \
    X(tsuji_duration_zero_overlap, TIME, SLOW_SHARE, 2 * HALF, HUGE_VALL,                                              \
      zeta < 1 ? reference_tsuji_time(LAW_ZERO_OVERLAP, zeta) : HUGE_VALL)                                             \
    X(tsuji_duration_zero_force, TIME, SLOW_SHARE, 2 * HALF, 0, reference_tsuji_time(LAW_ZERO_FORCE, zeta))            \
    X(tsuji_duration_limited, TIME, SLOW_SHARE, 2 * HALF, LAST,                                                        \
      zeta < 1e-30  ? 2 * HALF                                                                                         \
      : zeta < 1e18 ? reference_tsuji_time(LAW_LIMITED, zeta)                                                          \
                    : LAST)                                                                                            \
    X(tsuji_duration_approach_only, TIME, SLOW_SHARE, 2 * HALF, HUGE_VALL,                                             \
      reference_tsuji_time(LAW_APPROACH_ONLY, zeta) + HALF * expl(PHASE / 5))                                          \
    X(tsuji_time_of_max_overlap, TIME, SLOW_SHARE, HALF, 0, reference_tsuji_time(LAW_APPROACH_ONLY, zeta))
#define OF_ZETA_EXACT(name, bound, share, at_0, at_infinity, elsewhere)                                                \
    static long double name##_exact(double zeta)                                                                       \
    {                                                                                                                  \
        return zeta == 0 ? (at_0) : isinf(zeta) ? (at_infinity) : (elsewhere);                                         \
    }
#define OF_ZETA_ROW(name, bound, share, ...) ROW(name, OTHER, RATIO, 0, name##_exact, bound, share),
OF_ZETA(OF_ZETA_EXACT)

/* Hunt and Crossley's times for a = 1 and 3/2, and the functions of one argument that the table wants */
#define OF_BETA(name, at_0, at_infinity, elsewhere)                                                                    \
    static long double name(double a, double beta)                                                                     \
    {                                                                                                                  \
        return beta < 1e-25 ? (at_0) : isinf(beta) ? (at_infinity) : (elsewhere);                                      \
    }
#define ELASTIC_HALF reference_crossley_elastic_half(a)
OF_BETA(crossley_duration, 2 * ELASTIC_HALF, HUGE_VALL, reference_crossley_duration(a, beta))
OF_BETA(crossley_max, ELASTIC_HALF, 0, reference_crossley_time_of_max_overlap(a, beta))
OF_BETA(crossley_approach, 2 * ELASTIC_HALF, a > 1 ? HUGE_VALL : ELASTIC_HALF,
        reference_crossley_duration_approach_only(a, beta))

static long double crossley_overlap(double a, double beta)
{
    const long double eps = beta == 0 ? 1 : isinf(beta) ? 0 : reference_hunt_crossley_approach_eps(beta), n = a + 1.0L;
    return powl(n / 2 * eps * eps, 1 / n);
}

/* Name, reference, a, its name; law, bound and share of the points */
#define OF_BETA_AND_A(X)                                                                                               \
    X(hunt_crossley_duration, crossley_duration, 1, 1, CROSSLEY_TIMES, TIME, SLOW_SHARE)                               \
    X(hunt_crossley_duration, crossley_duration, 1.5, 3_2, CROSSLEY_TIMES, TIME, SLOW_SHARE)                           \
    X(hunt_crossley_time_of_max_overlap, crossley_max, 1, 1, CROSSLEY_TIMES, TIME, SLOW_SHARE)                         \
    X(hunt_crossley_time_of_max_overlap, crossley_max, 1.5, 3_2, CROSSLEY_TIMES, TIME, SLOW_SHARE)                     \
    X(hunt_crossley_duration_approach_only, crossley_approach, 1, 1, CROSSLEY_TIMES, TIME, SLOW_SHARE)                 \
    X(hunt_crossley_duration_approach_only, crossley_approach, 1.5, 3_2, CROSSLEY_TIMES, TIME, SLOW_SHARE)             \
    X(hunt_crossley_max_overlap, crossley_overlap, 1, 1, CROSSLEY_APPROACH, OVERLAP, 0)                                \
    X(hunt_crossley_max_overlap, crossley_overlap, 1.25, 5_4, CROSSLEY_APPROACH, OVERLAP, 0)                           \
    X(hunt_crossley_max_overlap, crossley_overlap, 1.5, 3_2, CROSSLEY_APPROACH, OVERLAP, 0)
#define OF_BETA_AND_A_EXACT(function, reference, a, suffix, law, bound, share)                                         \
    static double cor_##function##_##suffix(double beta)                                                               \
    {                                                                                                                  \
        return cor_##function(beta, a);                                                                                \
    }                                                                                                                  \
    static long double function##_##suffix##_exact(double beta)                                                        \
    {                                                                                                                  \
        return reference(a, beta);                                                                                     \
    }
#define OF_BETA_AND_A_ROW(function, reference, a, suffix, law, bound, share)                                           \
    ROW(function##_##suffix, OTHER, law, 0, function##_##suffix##_exact, bound, share),
OF_BETA_AND_A(OF_BETA_AND_A_EXACT)

static const struct search_function functions[] = {
    RATIO_ROWS(zero_overlap, LAW_ZERO_OVERLAP),
    RATIO_ROWS(zero_force, LAW_ZERO_FORCE),
    RATIO_ROWS(limited, LAW_LIMITED),
    RATIO_ROWS(approach_only, LAW_APPROACH_ONLY),
    OF_ZETA(OF_ZETA_ROW) OF_BETA_AND_A(OF_BETA_AND_A_ROW) CROSSLEY_ROWS(CROSSLEY, ),
    CROSSLEY_ROWS(CROSSLEY_APPROACH, _approach_only),
};

/* eps or 1 - eps of Hunt and Crossley's law */
static long double crossley(int law, bool loss, long double beta)
{
    if (beta == 0 || isinf(beta))
        return (beta == 0) == loss ? 0 : 1;
    if (law == CROSSLEY)
        return loss ? reference_hunt_crossley_loss(beta) : reference_hunt_crossley_eps(beta);
    return loss ? reference_hunt_crossley_approach_loss(beta) : reference_hunt_crossley_approach_eps(beta);
}

static long double exact(const struct search_function *f, enum search_shape shape, long double x)
{
    if (!(x >= 0) && (f->law == RATIO || !(x > -1)))
        return NAN;
    if (f->law == CROSSLEY_TIMES && x < 0) /* not judged: by quadrature, tests/unit/test_law.c */
        return (long double)f->value((double)x);
    if (f->exact != NULL)
        return f->exact((double)x);
    return f->law == RATIO ? ratio((enum law_end)f->end, shape == LOSS, x) : crossley(f->law, shape == LOSS, x);
}

/* ---- searches ---- */

/* zeta or beta: where kernels are, near 1, every size, every bit pattern; a part of beta is negative */
static double random_damping(struct random_state *r, const struct search_function *f)
{
    const double kind = random_uniform(r, 0, 1), u = random_uniform(r, 0, 1);
    if (f->law != RATIO && kind < 0.15)
        return kind < 0.08 ? -u : -exp(-30 * u);
    if (kind < 0.55)
        return 3 * u;
    if (kind < 0.7)
        return 15 * u;
    if (kind < 0.85)
        return exp(-46 + 92 * u);
    if (kind < 0.9)
        return 1 + (random_bits(r) & 1 ? -1 : 1) * exp2(-52 * u);
    return random_pattern(r, HUGE_VAL);
}

static double random_eps(struct random_state *r)
{
    const double kind = random_uniform(r, 0, 1), u = random_uniform(r, 0, 1);
    if (kind < 0.6)
        return u;
    if (kind < 0.75)
        return random_pattern(r, 1);
    if (kind < 0.9)
        return 1 - exp2(-54 * u);
    return exp(-30 * u);
}

static double random_argument(struct random_state *r, const struct search_function *f)
{
    return search_is_inverse(f) ? random_eps(r) : random_damping(r, f);
}

/* Where kernels and series meet (runtime/law/damping_ratio.h, hunt_crossley.h), and the ends of the number format */
static NUMBERS(damping_boundaries, 0.25, 0.5, 0.75, 1, 2, 3, 4, 11, 16, 64, 0.7, 2.0 / 3, 0x1p-20, 0x1p-60, 0x1p64,
               0x1p100, 0x1p500, 0x1p540, 0x1p511, 1e300, 0x1p-900, 0x1p-1022, 0x1p28, 800, 0x1p-537, 0x1p53,
               2.23606797749979, 0x1p1023, 0x1.8p1022, 0.84, 1000, 0x1p200, 0x1p900);
static NUMBERS(eps_boundaries, 0.5, 0.25, 0.125, 0x1p-5, 0x1p-6, 0.1353352832366127, 0.36787944117144233,
               0.26359713811572677, 0.4065696597405991, 0.1495686192226351, 0x1p-900, 0x1p-200, 1e-154,
               2.7813423231340017e-309, 1.9667060174891983e-309, 5.562684646268003e-309, 0x1p-60, 0x1p-30);

static void search_boundaries(struct worst *worst, const struct search_function *f, const struct search_options *o)
{
    const uint64_t radius = f->share > 0 ? 0 : 32;
    if (search_is_inverse(f)) {
        for (size_t i = 0; i < COUNT_OF(eps_boundaries); i++) {
            worst_walk(worst, f, o, eps_boundaries[i], radius);
            worst_walk(worst, f, o, 1 - eps_boundaries[i], radius);
        }
        for (int k = -1074; k <= 0; k++)
            worst_walk(worst, f, o, ldexp(1, k), 1);
        for (int k = -53; k < 0; k++)
            worst_walk(worst, f, o, 1 - ldexp(1, k), 3);
        return;
    }
    for (size_t i = 0; i < COUNT_OF(damping_boundaries); i++) {
        worst_walk(worst, f, o, damping_boundaries[i], radius);
        if (f->law != RATIO && damping_boundaries[i] <= 1)
            worst_walk(worst, f, o, -damping_boundaries[i], radius);
    }
    for (int k = -1074; k<1024; k += f->share> 0 ? 91 : 1)
        worst_walk(worst, f, o, ldexp(1, k), radius > 0);
}

/* ---- Hunt and Crossley's times by quadrature, against enclosed collisions ---- */

static double relative_error_of_ball(double computed, const arb_t exact)
{
    LOCAL(arb, off);
    LET(off, 200, "computed/exact - 1", computed, exact);
    return arb_is_finite(off) ? fabs(arf_get_d(arb_midref(off), ARF_RND_NEAR)) : HUGE_VAL;
}

/* Exponents and beta up to the largest that a collision is enclosed for within seconds: the fast and the slow motion,
 * and the quadrature's nearest singularities */
static bool crossley_times_are_enclosed(const struct search_options *o)
{
    const double most = COR_HUNT_CROSSLEY_TIME_MAX_ERROR;
    struct random_state r = random_seeded(o->seed);
    LOCAL(collision, c);
    LOCAL(arb, beta_ball);
    double worst = 0;
    bool good = true;
    const uint64_t points = o->points / 2500;
    for (uint64_t i = 0; i < points; i++) {
        const unsigned denominator = i % 2 == 0 ? 1 : 8;
        const unsigned numerator = (unsigned)(i % 2 == 0 ? 9 + random_below(&r, 16) : 1 + random_below(&r, 64));
        const double a = (double)numerator / denominator, beta = random_log(&r, 1e-3, 1e6);
        char text[32];
        struct law law;
        snprintf(text, sizeof text, "%u/%u", numerator, denominator);
        arb_set_d(beta_ball, beta);
        const bool solved = law_parse(&law, text, text) == NULL && collision_solve(c, beta_ball, &law, 72) == 0;
        const double max = relative_error_of_ball(cor_hunt_crossley_time_of_max_overlap(beta, a), c->t_max);
        const double duration = relative_error_of_ball(cor_hunt_crossley_duration(beta, a), c->t_zero_overlap);
        worst = fmax(worst, fmax(max, duration));
        if (solved && max <= most && duration <= most)
            continue;
        printf("FAIL  Hunt and Crossley's times at beta = %.17g, a = %s: off by %.1e, %.1e\n", beta, text, max,
               duration);
        good = false;
    }
    printf("Hunt and Crossley's times by quadrature: off by %.1e at most, %llu enclosed collisions\n", worst,
           (unsigned long long)points);
    return good;
}

/* ---- oblique impacts ---- */

enum { NO_SLIP_BITS = 600 };

/* cos(pi sqrt((a - 1)^2 + 8 (a + 1) kappa)/(2 (a + 1)))/cos(pi (a - 1)/(2 (a + 1))), where 300 bits may cancel */
static long double no_slip_exact(double kappa, double a)
{
    LOCAL(arb, d, e);
    LET(d, NO_SLIP_BITS, "sqrt((a - 1)^2 + 8*(a + 1)*kappa)/(2*(a + 1))", a, kappa);
    LET(e, NO_SLIP_BITS, "(a - 1)/(2*(a + 1))", a);
    arb_cos_pi(d, d, NO_SLIP_BITS);
    arb_cos_pi(e, e, NO_SLIP_BITS);
    LET(d, NO_SLIP_BITS, "d/e", d, e);
    return ball_value(d);
}

/* kappa of every size, and the doubles next to the zeros of the cosine: what is computed exactly 0 must be a zero. */
static bool no_slip_is_good(const struct search_options *o)
{
    struct random_state r = random_seeded(o->seed);
    double worst = 0, least = 1;
    bool good = true;
    for (uint64_t i = 0; i < o->points; i++) {
        static const double exponents[] = {1, 1.5, 0.5, 3, 1.25, COR_NO_SLIP_MIN_EXPONENT, COR_NO_SLIP_MAX_EXPONENT};
        const double a = i % 2 == 0 ? random_log(&r, COR_NO_SLIP_MIN_EXPONENT, COR_NO_SLIP_MAX_EXPONENT)
                                    : exponents[random_below(&r, COUNT_OF(exponents))];
        const double n = (double)random_below(&r, i % 3 == 0 ? 1400 : 4);
        const double zero = a / (2 * (a + 1)) + n * (n + 1) / 2 * (a + 1);
        double kappa = i % 5 == 0 ? random_uniform(&r, 0, 10) : random_log(&r, 1e-320, COR_NO_SLIP_MAX_KAPPA);
        if (i % 4 != 0 && zero <= COR_NO_SLIP_MAX_KAPPA)
            kappa = zero * (1 + ((double)random_below(&r, 7) - 3) * DBL_EPSILON / 2);
        const double y = cor_tangential_no_slip(kappa, a);
        const long double exact = no_slip_exact(kappa, a);
        const bool is_zero = fabsl(exact) < 1e-60L;
        const double error = is_zero ? (y == 0 ? 0 : HUGE_VAL) : ulp_error((double)fabsl(y), fabsl(exact));
        const double of_floats = cor_tangential_no_slip((double)(float)kappa, (double)(float)a);
        const double narrow = fabs((double)cor_tangential_no_slipf((float)kappa, (float)a) - of_floats);
        if (!is_zero)
            least = fmin(least, fabs(y));
        worst = fmax(worst, error);
        if (error <= COR_NO_SLIP_MAX_ULP && (y > 0) == (exact > 0 && !is_zero) &&
            !(narrow > 0x1p-24 * fabs(of_floats) + 1e-45))
            continue;
        printf("FAIL  no slip at kappa = %.17g, a = %.17g: %.17g, exact %.20Lg\n", kappa, a, y, exact);
        good = false;
    }
    printf("tangential_no_slip: %.4f ulp at most, bound %.2f, down to %.1e\n", worst, COR_NO_SLIP_MAX_ULP, least);
    return good;
}

/* ---- the run ---- */

static const char help[] = "test_laws [--points N] [--threads N] [--only TEXT] [--seed N]\n";

int main(int argc, char **argv)
{
    struct search_options o = {.points = 20000,
                               .seed = 19990101,
                               .threads = 1,
                               .exact = exact,
                               .random_argument = random_argument,
                               .boundaries = search_boundaries,
                               .judges_specials = true,
                               .largest_rise = 2,
                               .radius = 200};
    const int status = search_options_read(&o, argc, argv, help);
    if (status != 0)
        return status;
    bool good = true;
    worst_heading(o.seed);
    for (size_t i = 0; i < COUNT_OF(functions); i++)
        good = search_worst(&functions[i], &o) < HUGE_VAL && good;
    if (search_wants(&o, "hunt_crossley_times_by_quadrature"))
        good = crossley_times_are_enclosed(&o) && good;
    if (search_wants(&o, "tangential_no_slip"))
        good = no_slip_is_good(&o) && good;
    flint_cleanup();
    return good ? 0 : 1;
}
