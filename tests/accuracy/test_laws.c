/* SPDX-License-Identifier: MIT */
/* Tests the functions of law.h for a damping ratio, and Hunt and Crossley's law, against another formulation in long
 * double, or in balls where long double has too few digits. Points are random, near boundaries of kernels, next to the
 * worst point, and special. Prints one line for each function; docs/accuracy.md quotes these lines.
 *     test_laws [--points N] [--threads N] [--only TEXT] [--seed N]     (N random points each, 20000 by default) */
#include "cor/law.h"

#include <stdio.h>

#include "../reference/laws.h"
#include "ball_value.h"
#include "search.h"
#include "support/formula.h"
#include "support/local.h"
#include "ulp.h"

/* ---- the exact values ---- */

enum { BALL_BITS = 256 };

/* For L = -ln(eps) up to this number, exp and expm1 in long double are accurate enough. */
static const long double far_exponent = 16;

/* Returns exp(-share L) in balls, where L comes from acos, acosh and logarithms. Limited damping requires zeta > 1. */
static long double eps_far(enum cor_end end, double zeta, struct ratio share)
{
    LOCAL(arb, l, om, phase);
    LET(om, BALL_BITS, "sqrt(abs(1 - zeta^2))", zeta);
    if (end == COR_END_ZERO_OVERLAP)
        arb_const_pi(phase, BALL_BITS);
    else if (zeta > 1)
        LET(phase, BALL_BITS, "acosh(zeta)", zeta);
    else
        LET(phase, BALL_BITS, "acos(zeta)", zeta);
    if (end == COR_END_ZERO_FORCE)
        LET(phase, BALL_BITS, "2*phase", phase);
    if (end == COR_END_LIMITED)
        LET(phase, BALL_BITS, "2*phase - log(1 + 2*zeta^2 + 2*zeta*om) + log1p(8*zeta^2)/2", phase, zeta, om);
    LET(l, BALL_BITS, "exp(-share*zeta*phase/om)", share, zeta, phase, om);
    return ball_value(l);
}

/* Returns eps or 1 - eps. */
static long double ratio(enum cor_end end, bool loss, long double zeta)
{
    if (zeta == 0)
        return !loss;
    if (isinf(zeta) || (end == COR_END_ZERO_OVERLAP && zeta >= 1))
        return loss;
    const long double l = reference_ratio_exponent(end, zeta);
    return loss ? -expm1l(-l) : l < far_exponent ? expl(-l) : eps_far(end, (double)zeta, RATIO("1"));
}

/* Constants: half of the elastic duration, and Tsuji's largest overlap at zeta = 0. The limit of Tsuji's duration with
 * limited damping is (5/8)^(2/5) times the integral of (1 - X^(5/2))^(-1/2) from 0 to 1, in Gamma functions. */
#define PI acosl(-1)
#define TSUJI_MOST expl(0.4L * logl(1.25L))
#define HALF (TSUJI_MOST * sqrtl(PI) * tgammal(1.4L) / tgammal(0.9L))
#define LAST (powl(0.625L, 0.4L) * sqrtl(PI) * tgammal(1.4L) / tgammal(0.9L))

/* Returns the largest overlap or a time of the linear dashpot, 0 < zeta < inf. */
static long double linear_exact(enum cor_end end, enum cor_quantity quantity, double zeta)
{
    const long double phase = reference_ratio_exponent(COR_END_APPROACH_ONLY, zeta) / zeta;
    if (quantity != COR_DURATION)
        return quantity == COR_MAX_OVERLAP ? ratio(COR_END_APPROACH_ONLY, false, zeta) : phase;
    if (end == COR_END_ZERO_OVERLAP)
        return zeta < 1 ? PI / sqrtl((1 - (long double)zeta) * (1 + (long double)zeta)) : HUGE_VALL;
    if (end == COR_END_LIMITED)
        return atanl(sqrtl(8) * zeta) / sqrtl(2) + reference_ratio_exponent(end, zeta) / zeta;
    return end == COR_END_ZERO_FORCE ? 2 * phase : PI / 2 + phase;
}

/* Returns the largest overlap or a time of Tsuji's damping, where the largest overlap is (5/4 eps)^(2/5). */
static long double tsuji_exact(enum cor_end end, enum cor_quantity quantity, double zeta)
{
    const long double l = reference_ratio_exponent(COR_END_APPROACH_ONLY, zeta);
    if (quantity == COR_MAX_OVERLAP)
        return TSUJI_MOST * (2 * l < far_exponent ? expl(-0.8L * l) : eps_far(COR_END_ZERO_FORCE, zeta, RATIO("2/5")));
    if (quantity == COR_TIME_OF_MAX_OVERLAP)
        return reference_tsuji_time(COR_END_APPROACH_ONLY, zeta);
    if (end == COR_END_LIMITED && !(zeta >= 1e-30 && zeta < 1e18))
        return zeta < 1 ? 2 * HALF : LAST;
    if (end == COR_END_ZERO_OVERLAP && zeta >= 1)
        return HUGE_VALL;
    return reference_tsuji_time(end, zeta) + (end == COR_END_APPROACH_ONLY ? HALF * expl(l / 5) : 0);
}

/* Returns f->quantity, the largest overlap or a time, of f->law, linear or Tsuji, for any zeta >= 0. */
static long double ratio_exact(const struct search_function *f, double zeta)
{
    const enum cor_quantity quantity = (enum cor_quantity)f->quantity;
    const enum cor_end end = (enum cor_end)f->end;
    const bool is_linear = f->law == COR_LAW_LINEAR;
    const long double half = is_linear ? PI / 2 : HALF;
    if (zeta == 0)
        return quantity == COR_MAX_OVERLAP ? (is_linear ? 1 : TSUJI_MOST) : quantity == COR_DURATION ? 2 * half : half;
    if (isinf(zeta)) {
        if (quantity != COR_DURATION || end == COR_END_ZERO_FORCE)
            return 0;
        return end == COR_END_LIMITED                      ? (is_linear ? PI / sqrtl(8) : LAST)
               : is_linear && end == COR_END_APPROACH_ONLY ? half
                                                           : HUGE_VALL;
    }
    return is_linear ? linear_exact(end, quantity, zeta) : tsuji_exact(end, quantity, zeta);
}

/* Returns the value for Hunt and Crossley's law with the elastic exponent a. Times for negative beta are tested in
 * tests/unit/test_law.c. */
static long double crossley_exact(const struct search_function *f, double beta)
{
    const double a = f->exponent;
    const bool approach = f->end == COR_END_APPROACH_ONLY;
    const long double half = reference_crossley_elastic_half(a), n = a + 1.0L;
    if (f->quantity == COR_MAX_OVERLAP) {
        const long double eps = beta == 0 ? 1 : isinf(beta) ? 0 : reference_hunt_crossley_approach_eps(beta);
        return powl(n / 2 * eps * eps, 1 / n);
    }
    if (beta < 0)
        return a == 1.5 ? NAN : (long double)f->value(beta);
    if (f->quantity == COR_TIME_OF_MAX_OVERLAP)
        return beta < 1e-25 ? half : isinf(beta) ? 0 : reference_crossley_time_of_max_overlap(a, beta);
    if (beta < 1e-25)
        return 2 * half;
    if (isinf(beta))
        return approach && a <= 1 ? half : HUGE_VALL;
    return (approach ? reference_crossley_duration_approach_only : reference_crossley_duration)(a, beta);
}

/* Returns eps or 1 - eps of Hunt and Crossley's law. */
static long double crossley(bool approach, bool loss, long double beta)
{
    if (beta == 0 || isinf(beta))
        return (beta == 0) == loss ? 0 : 1;
    if (!approach)
        return loss ? reference_hunt_crossley_loss(beta) : reference_hunt_crossley_eps(beta);
    return loss ? reference_hunt_crossley_approach_loss(beta) : reference_hunt_crossley_approach_eps(beta);
}

static long double exact(const struct search_function *f, enum search_shape shape, long double x)
{
    const bool is_crossley = f->law == COR_LAW_HUNT_CROSSLEY;
    if (!(x >= 0) && !(is_crossley && x > -1))
        return NAN;
    if (shape == OTHER)
        return is_crossley ? crossley_exact(f, (double)x) : ratio_exact(f, (double)x);
    return is_crossley ? crossley(f->end == COR_END_APPROACH_ONLY, shape == LOSS, x)
                       : ratio((enum cor_end)f->end, shape == LOSS, x);
}

/* ---- the functions ---- */

enum { SLOW_SHARE = 400, MOST_FUNCTIONS = 100 }; /* SLOW_SHARE: `share` of functions whose reference takes 0.1 ms */

#define AT_EXPONENT(name, function, exponent)                                                                          \
    static double crossley_##name(double beta)                                                                         \
    {                                                                                                                  \
        return cor_hunt_crossley_##function(beta, exponent);                                                           \
    }
AT_EXPONENT(duration_1, duration, 1)
AT_EXPONENT(duration_approach_only_1, duration_approach_only, 1)
AT_EXPONENT(time_of_max_overlap_1, time_of_max_overlap, 1)
AT_EXPONENT(max_overlap_1, max_overlap, 1)
AT_EXPONENT(max_overlap_5_4, max_overlap, 1.25)

/* Functions with the elastic exponent as an argument; the table contains only 3/2. */
#define CROSSLEY(name, end, quantity, exponent, share)                                                                 \
    {                                                                                                                  \
        "hunt_" #name, name, OTHER, COR_HUNT_CROSSLEY_MAX_ULP, COR_LAW_HUNT_CROSSLEY, end, quantity, exponent, share   \
    }
static struct search_function functions[MOST_FUNCTIONS] = {
    CROSSLEY(crossley_duration_1, COR_END_ZERO_FORCE, COR_DURATION, 1, SLOW_SHARE),
    CROSSLEY(crossley_duration_approach_only_1, COR_END_APPROACH_ONLY, COR_DURATION, 1, SLOW_SHARE),
    CROSSLEY(crossley_time_of_max_overlap_1, COR_END_ZERO_FORCE, COR_TIME_OF_MAX_OVERLAP, 1, SLOW_SHARE),
    CROSSLEY(crossley_max_overlap_1, COR_END_ZERO_FORCE, COR_MAX_OVERLAP, 1, 0),
    CROSSLEY(crossley_max_overlap_5_4, COR_END_ZERO_FORCE, COR_MAX_OVERLAP, 1.25, 0),
};
static size_t function_count = 5;

/* Adds a function of the table, unless it is in the list already: some laws and some ends share functions. */
static void add_function(enum cor_law law, enum cor_end end, enum cor_quantity quantity)
{
    static const enum search_shape shape[] = {EPS, LOSS, INVERSE, INVERSE_OF_LOSS, OTHER, OTHER, OTHER};
    const struct cor_law_function *const f = cor_law_function(law, end, quantity);
    const bool slow = (quantity == COR_DURATION || quantity == COR_TIME_OF_MAX_OVERLAP) && law != COR_LAW_LINEAR;
    for (size_t i = 0; f && i < function_count; i++)
        if (functions[i].value == f->value)
            return;
    if (f)
        functions[function_count++] = (struct search_function){
            f->name, f->value, shape[quantity], f->max_ulp, (int)law, end, (int)quantity, 1.5, slow ? SLOW_SHARE : 0};
}

/* ---- searches ---- */

/* Returns zeta or beta: near kernels, near 1, every magnitude, every bit pattern. Some beta are negative. */
static double random_damping(struct random_state *r, const struct search_function *f)
{
    const double kind = random_uniform(r, 0, 1), u = random_uniform(r, 0, 1);
    if (f->law == COR_LAW_HUNT_CROSSLEY && kind < 0.15)
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

/* Places where kernels and series meet (runtime/law/damping_ratio.h, hunt_crossley.h), and ends of the number format */
static NUMBERS(damping_boundaries, 0.25, 0.5, 0.75, 1, 2, 3, 4, 11, 16, 64, 0.7, 2.0 / 3, 0x1p-20, 0x1p-60, 0x1p64,
               0x1p100, 0x1p500, 0x1p540, 0x1p511, 1e300, 0x1p-900, 0x1p-1022, 0x1p28, 800, 0x1p-537, 0x1p53,
               2.23606797749979, 0x1p1023, 0x1.8p1022, 0.84, 1000, 0x1p200, 0x1p900);
static NUMBERS(eps_boundaries, 0.5, 0.25, 0.125, 0x1p-5, 0x1p-6, 0.1353352832366127, 0.36787944117144233,
               0.26359713811572677, 0.4065696597405991, 0.1495686192226351, 0x1p-900, 0x1p-200, 1e-154,
               2.7813423231340017e-309, 1.9667060174891983e-309, 5.562684646268003e-309, 0x1p-60, 0x1p-30);

/* Tests points next to an end of each row of the tables of times, and points where the series beyond the rows begin.
 * Tsuji's rows are in zeta^(1/5), ln(1 + zeta) and, at zero overlap, y = zeta/(10 sqrt(1 - zeta^2)). The series of zero
 * overlap begin near y = 6 and at y = 10. The rows of Hunt and Crossley are in ln(1 + beta). */
static void search_rows(struct worst *worst, const struct search_function *f, const struct search_options *o)
{
    enum { WEAK = 42, STRONG = 43, SHORT = 36, LONG = 70 };
    static NUMBERS(tsuji, 0.4, 2.5, 40, 2.0899e5, 1e6, 1e17);
    static NUMBERS(late, 0.01, 0.3, 1, 3, 5.9, 6.4, 6.6, 7, 8, 9, 9.9, 9.99, 10.0001, 10.1, 10.5, 11, 12, 14, 17, 112);
    static NUMBERS(crossley, 89.02, 90, 95, 110, 150, 300, 2.516e11, 1e12, 1e14, 1e16);
    const bool is_tsuji = f->law == COR_LAW_TSUJI,
               is_late = is_tsuji && f->quantity == COR_DURATION && f->end == COR_END_ZERO_OVERLAP;
    for (size_t i = 0; i < COUNT_OF(late) && is_late; i++)
        worst_walk(worst, f, o, 10 * late[i] / sqrt(1 + 100 * late[i] * late[i]), 0);
    for (size_t i = 0; i < (is_tsuji ? COUNT_OF(tsuji) : COUNT_OF(crossley)) && !is_late; i++)
        worst_walk(worst, f, o, is_tsuji ? tsuji[i] : crossley[i], 0);
    for (int i = 0; i < (is_tsuji ? WEAK + STRONG : SHORT + LONG) && !is_late; i++) {
        const double part = i % 2 ? 0.04 : 0.96;
        worst_walk(worst, f, o,
                   is_tsuji ? (i < WEAK ? pow((i + part) / 32, 5) : expm1(1.5 + (i - WEAK + part) / 4))
                            : expm1(i < SHORT ? (i + part) / 8 : (i - SHORT + part) * 3 / 8),
                   0);
    }
}

static void search_boundaries(struct worst *worst, const struct search_function *f, const struct search_options *o)
{
    const uint64_t radius = f->share > 0 ? 0 : 32;
    if (f->share > 0)
        search_rows(worst, f, o);
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
        if (f->law == COR_LAW_HUNT_CROSSLEY && damping_boundaries[i] <= 1)
            worst_walk(worst, f, o, -damping_boundaries[i], radius);
    }
    for (int k = -1074; k<1024; k += f->share> 0 ? 91 : 1)
        worst_walk(worst, f, o, ldexp(1, k), radius > 0);
}

/* ---- oblique impacts ---- */

enum { NO_SLIP_BITS = 600 };

/* Returns cos(pi sqrt((a - 1)^2 + 8 (a + 1) kappa)/(2 (a + 1)))/cos(pi (a - 1)/(2 (a + 1))); 300 bits may cancel. */
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

/* Tests kappa of every magnitude, and doubles next to zeros of the cosine: a computed 0 must be exact. */
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
        if (!is_zero)
            least = fmin(least, fabs(y));
        worst = fmax(worst, error);
        if (error <= COR_NO_SLIP_MAX_ULP && (y > 0) == (exact > 0 && !is_zero))
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
    for (int law = COR_LAW_LINEAR; law <= COR_LAW_HUNT_CROSSLEY; law++)
        for (int k = 0; k < (COR_END_APPROACH_ONLY + 1) * COR_QUANTITIES; k++)
            add_function((enum cor_law)law, (enum cor_end)(k / COR_QUANTITIES),
                         (enum cor_quantity)(k % COR_QUANTITIES));
    for (size_t i = 0; i < function_count; i++)
        good = search_worst(&functions[i], &o) < HUGE_VAL && good;
    if (search_wants(&o, "tangential_no_slip"))
        good = no_slip_is_good(&o) && good;
    flint_cleanup();
    return good ? 0 : 1;
}
