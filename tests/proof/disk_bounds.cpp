/* SPDX-License-Identifier: MIT */
/* Proves the bounds of the disk's contact law. Adds the errors of the stages (errors.h), each amplified by the later
 * stages, in interval (ball) arithmetic over cells that cover the domain. docs/theory.md, 18, has the argument. Prints
 * one line for each function. The exit status is 1 if a bound does not hold. */
#include "errors.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "support/flint.h"
#include "support/local.h"

#include "runtime/disk/quasistatic.c"
#include "runtime/number/lambert_w.c"

#include "generated/disk_law_tables.h"
#include "runtime/table/row.h"

/* ---- intervals ---- */

static const slong bits = 192;

struct ball {
    arb_t x;
    ball(double value = 0)
    {
        arb_init(x);
        arb_set_d(x, value);
    }
    ball(const ball &other) : ball()
    {
        arb_set(x, other.x);
    }
    ball &operator=(const ball &other)
    {
        arb_set(x, other.x);
        return *this;
    }
    ~ball()
    {
        arb_clear(x);
    }
    double end(void (*get)(arf_t, const arb_t, slong), arf_rnd_t rounding) const
    {
        LOCAL(arf, y);
        get(y, x, 128);
        return arf_get_d(y, rounding);
    }
    double above() const
    {
        return end(arb_get_ubound_arf, ARF_RND_CEIL);
    }
    double below() const
    {
        return end(arb_get_lbound_arf, ARF_RND_FLOOR);
    }
};

#define BALL_OF(name, parameters, call)                                                                                \
    static ball name parameters                                                                                        \
    {                                                                                                                  \
        ball c;                                                                                                        \
        call;                                                                                                          \
        return c;                                                                                                      \
    }
#define BALL_OPERATOR(sign, f) BALL_OF(operator sign, (const ball &a, const ball &b), f(c.x, a.x, b.x, bits))
#define BALL_FUNCTION(name, f) BALL_OF(name, (const ball &a), f(c.x, a.x, bits))
BALL_OPERATOR(+, arb_add)
BALL_OPERATOR(-, arb_sub)
BALL_OPERATOR(*, arb_mul)
BALL_OPERATOR(/, arb_div)
BALL_FUNCTION(log, arb_log)
BALL_FUNCTION(log1p, arb_log1p)
BALL_FUNCTION(exp, arb_exp)
BALL_FUNCTION(expm1, arb_expm1)
BALL_FUNCTION(sqrt, arb_sqrt)
BALL_OF(size, (const ball &a), arb_abs(c.x, a.x))
BALL_OF(from_to, (const ball &a, const ball &b), arb_union(c.x, a.x, b.x, bits))
BALL_OF(pi_ball, (), arb_const_pi(c.x, bits))

/* Returns t(q) by W_-1 of a number that is not too close to its branch point. */
static ball lambert_t(const ball &q)
{
    ball w, z = ball(0) - exp(ball(-1) - q);
    arb_lambertw(w.x, z.x, 1, bits);
    return ball(-1) - w;
}

static ball around_0(double a)
{
    return from_to(ball(-a), ball(a));
}

/* Returns t - ln(1 + t), which increases with t > 0. */
static ball q_of(const ball &t)
{
    const ball low(t.below()), high(t.above());
    return from_to(low - log1p(low), high - log1p(high));
}

static double ulp(double x)
{
    int exponent;
    frexp(x, &exponent);
    return ldexp(1, exponent - 53);
}

static bool good = true;

static void require(bool yes, const char *what)
{
    if (!yes)
        printf("FAIL  %s\n", what);
    good = good && yes;
}

/* ---- t of q ---- */

static const double u = 0x1p-53;
static const double series_end = SERIES_END;

/* Largest errors of `log` and `log1p` in ulp */
struct library {
    double log, log1p;
};

/* Bounds |A| and |2 A + p A'| for every p, where p^2 A(p) is the rest of the series. */
static void series_factors(double *factor, double *slope)
{
    const ball p = from_to(ball(0), ball(COR_PROOF_SERIES_MAX_P));
    ball a(0), b(0);
    for (int k = (int)(sizeof lambert_series / sizeof *lambert_series) - 1; k >= 0; k--) {
        a = a * p + ball(lambert_series[k]);
        b = b * p + ball(lambert_series[k]) * ball(k + 2);
    }
    *factor = size(a).above();
    *slope = size(b).above();
}

/* Bounds the error of t.hi + t.lo relative to t(q.hi + q.lo), for q.hi < 0.1 and t <= high. |q.lo| <= 1.01 2^-53 q.hi.
 * p is the rounded sqrt(2 q.hi), and delta bounds |2 q/p^2 - 1|. */
static double series_error(double high)
{
    static double factor, slope;
    if (factor == 0)
        series_factors(&factor, &slope);
    const ball q = q_of(ball(high)), p = sqrt(2 * q) * ball(1 + 1e-15);
    const double delta = 3.02 * u;
    require(p.below() <= COR_PROOF_SERIES_MAX_P, "the end of the series");
    const ball rest = factor * p * p, moved = p * ball(delta / 2 * (1 + 1e-9));
    require((rest + moved).above() * (1 + 1e-9) < COR_PROOF_SERIES_MAX_LOW, "t.lo of the series");
    const ball correction = COR_PROOF_ROOT * p + p * ball(delta * delta);
    const ball cut = COR_PROOF_SERIES_DEFECT * p * p * (ball(1) + p) * ball(1 + 1e-9);
    const ball error =
        correction + slope * p * moved + COR_PROOF_SERIES * rest + ball(u) * (rest + moved) * ball(1 + 1e-9) + cut;
    return error.above();
}

/* Bounds the relative error of y after the step of fourth order, for t in [low, high] and q.hi >= 0.1. The exact
 * correction e with 1 + t = y (1 + e) satisfies r = u e + w, w = e - ln(1 + e) = e^2 W. The step misses e by
 *
 *     e^4 (u^2 V + W^2 (1 + 4 u/3))/(u (b + 2 r)),     2 W + (4/3) e W - 1 = e^2 V */
static double step_error(double low, double high, const library &n)
{
    const ball t = from_to(ball(low), ball(high)), y = ball(1) + t, q = q_of(t) * (ball(1) + around_0(1.1 * u));
    double worst = 0;
    for (int by_log = 0; by_log < 2; by_log++) {
        if (by_log ? q.above() < 3 : q.below() >= 3)
            continue;
        ball start;
        if (by_log) {
            /* for q >= 3 every operation of start_of is monotone */
            start = from_to(ball(start_of(std::max(q.below(), 3.0), 0)), ball(start_of(q.above(), 0)));
        } else {
            const ball p = sqrt(2 * q) * (ball(1) + around_0(u));
            start = ball(1) + p * (ball(1) + p * (ball(1.0 / 3) + p * (ball(1.0 / 36) - p * ball(1.0 / 270))));
            start = start * (ball(1) + around_0(COR_PROOF_START));
        }
        const ball e = y / start - ball(1), e2 = e * e, v = start - ball(1);
        const double most = size(e).above();
        if (!(most < 0.01)) {
            require(false, "the start of the iteration");
            return 1;
        }
        const ball W = ball(0.5) - e / ball(3) + around_0(most * most / 3.9);
        const ball V = ball(1) / ball(18) + around_0(0.68 * most);
        const ball r = v * e + e2 * W, b = 2 * v * v + ball(4) / 3 * v * r;
        const ball divisor = v * (b + 2 * r);
        const ball missed = e2 * e2 * (v * v * V + W * W * (ball(1) + 4 * v / ball(3))) / divisor;
        /* The error of r comes from q.lo, log and two roundings. The step multiplies it by `derivative`. */
        const ball residual = ball(u) * (1.1 * q + (2 * n.log) * log(start) + q + v + ball(1));
        const ball N = r * (b + r),
                   dN = 4 * v * v + (ball(16) / 3 * v + ball(2)) * r - 2 * v * v - (ball(8) / 3 * v) * r;
        const ball dD = v * (ball(4) / 3 * v + ball(2));
        const ball derivative = (dN * divisor - N * dD) / (divisor * divisor);
        require(size(r).above() + residual.above() <= COR_PROOF_FIRST_RESIDUAL * start.below() * (1 - 1e-3),
                "the first residual");
        const ball total = size(missed) + size(derivative) * residual + ball(COR_PROOF_STEP + 0x1p-48);
        worst = std::max(worst, total.above() * 1.02); /* relative to y (1 + e) */
    }
    return worst;
}

/* Returns the error of t.hi + t.lo for q.hi >= 0.1. */
static double newton_error(double low, double high, const library &n)
{
    enum { PARTS = 64 };
    double e = 0;
    for (int i = 0; i < PARTS; i++) {
        const double a = low + (high - low) / PARTS * i,
                     b = i == PARTS - 1 ? high : low + (high - low) / PARTS * (i + 1);
        e = std::max(e, step_error(a, b, n));
    }
    const ball y = ball(1) + from_to(ball(low), ball(high)), t = y - ball(1);
    const double log_error = n.log * ulp(log(y).above() * (1 + 1e-8));
    /* a cell of the goals ends at 1.5 times its lower end at most */
    require(e * 1.5 + log_error + 0x1p-48 < COR_PROOF_SECOND_RESIDUAL, "the second residual");
    require((log(y) - e * y).below() > 0.3, "1 + t - y and q in one order");
    const ball cut = (e * e) * y / t * ball(0.51);
    const ball total = COR_PROOF_NEWTON * y + y / t * ball(log_error * (1 + 1e-8)) + cut;
    return total.above();
}

/* Returns the error of t.hi + t.lo for t in a cell. */
static double pair_error(double low, double high, const library &n)
{
    const ball q = q_of(from_to(ball(low), ball(high)));
    double error = 0;
    if (q.below() < series_end * (1 + 4 * u)) {
        const double last = std::min(high, 0.5163); /* q(0.5163) = 0.1 + 5e-6 */
        error = series_error(last);
    }
    if (q.above() > series_end * (1 - 4 * u))
        error = std::max(error, newton_error(std::max(low, 0.5161), high, n));
    return error;
}

/* ---- logarithms ---- */

/* Returns the error of q = ln(limit/x) for q in [low, high]. `limit` is the relative error of the limit as a pair. */
static double depth_error(double low, double high, const library &n, double limit)
{
    const double border = COR_LOG_RATIO_NEAR;
    double error = 0;
    if (high > border * (1 - 1e-12)) /* for |ln(m)| < 0.3466 a unit is at most 2^-54 */
        error = n.log * 0x1p-54 + COR_PROOF_FAR + 0x1p-99;
    if (low < border * (1 + 1e-12)) {
        const ball q = std::min(high, 0.51), d = ball(1) - exp(ball(0) - q);
        const double last = n.log1p * ulp(q.above());
        const double near = last + (d * ball(u * (1 + 1e-9)) + q * ball(4 * COR_PROOF_NEAR + 0x1p-90)).above() + limit;
        error = std::max(error, near);
    }
    return error;
}

/* ---- the limits ---- */

/* Returns |pair/exact - 1|. */
static double off(const pair &x, const ball &exact)
{
    return size((ball(x.hi) + ball(x.lo)) / exact - ball(1)).above();
}

/* Returns the error of cor_pair_plus(x, y): two roundings, of sums of low parts below u |x|, u |y| and u |x + y|. */
static ball plus_error(const ball &x, const ball &y, const ball &sum)
{
    return ball(1.001 * u * u) * (2 * size(x) + 2 * size(y) + size(sum));
}

/* Returns the relative error of pair_exp(x) for x between low and high, |x| < 2. The errors are from s = exp(x/512) - 1
 * by Horner's rule in pairs, from s -> 2 s + s^2, nine times, and from 1 + s. */
static double exp_error(double low, double high)
{
    const ball x = from_to(ball(low), ball(high)), r = size(x) / ball(512);
    double factorial = 5040;
    ball s = r / ball(factorial) * ball(1.01), e(8 * u);
    for (int i = 5; i >= 0; i--) {
        factorial /= i + 2;
        const ball c = ball(1) / ball(factorial), sum = c - s;
        e = (c * ball(0x1p-104) + s * e + plus_error(c, s, c + s)) / sum + ball(1.001 * COR_PROOF_PAIR_TIMES);
        s = (c + s) * r;
    }
    e = e + ball(0x1p-105); /* the terms from r^11/11! onward, r < 2^-8 */
    for (int i = 0; i < 9; i++) {
        const ball value = expm1(x / ball(ldexp(512, -i)));
        const ball whole = size(ball(2) + value);
        e = (e * size(ball(2) + ball(2) * value) * ball(1 + 1e-9) + size(value) * ball(COR_PROOF_PAIR_TIMES) +
             plus_error(ball(2), value, whole)) /
            whole;
    }
    const ball value = expm1(x), whole = ball(1) + value;
    return ((size(value) * e + plus_error(ball(1), value, whole)) / whole).above();
}

/* Tests the pairs stored in the code, and the limits 4 exp(b - 1), 4 pi exp(b - 1), sqrt(8) exp(b - 1) and 4 pi exp(2 b
 * - 2). Here b - 1 = -2 + slope nu, or -1 - 2 ln 2 - 1/4 + slope nu. Returns the relative error of a limit. */
static double limit_error(void)
{
    const ball circle = pi_ball(), root = sqrt(ball(2));
    const double constants =
        std::max({off(pi, circle), off(half_pi, circle / ball(2)), off(four_pi, 4 * circle),
                  off(one_over_pi, 1 / circle), off(one_over_two_pi, ball(1) / (2 * circle)), off(root_2, root),
                  off(root_2_pi, root * circle), off(four.number, ball(4)), off(four.log, log(ball(4))),
                  off(log_four_pi.number, 4 * circle), off(log_four_pi.log, log(4 * circle))});
    require(constants < 0x1p-104, "the constants of the law");
    double numbers = 0;
    for (int quantity = 0; quantity < 4; quantity++)
        for (int datum = 0; datum < 3; datum++) {
            struct limit limit;
            find_limit((enum quantity)quantity, 0, (enum cor_disk_datum)datum, &limit);
            const ball exponent = datum == COR_DISK_DATUM_CENTRE_OF_MASS ? ball(-1.25) - 2 * log(ball(2)) : ball(-2);
            const ball factor = quantity == COMPRESSION ? ball(4) : quantity == SPEED ? 2 * root : 4 * circle;
            const ball number = factor * exp(ball(quantity == ENERGY ? 2 : 1) * exponent);
            numbers = std::max({numbers, off(limit.at_zero.number, number)});
            require(off(limit.at_zero.log, log(number)) < 0x1p-102, "the logarithm of a limit");
        }
    require(numbers < 0x1p-104, "a limit at nu = 0");
    require(four.number.hi == 4 && four.number.lo == 0, "4");
    double worst = 0;
    enum { CELLS = 512 };
    for (int i = 0; i < CELLS; i++)
        worst = std::max(worst, exp_error(-2 + 4.0 * i / CELLS, -2 + 4.0 * (i + 1) / CELLS));
    return (worst + numbers + COR_PROOF_PAIR_TIMES) * (1 + 1e-9);
}

/* ---- sums over the domain ---- */

/* Two assumptions about libm. struct bound has the largest bound in ulp for each of them, and its place. */
static const library libraries[2] = {{COR_PROOF_LOG_ULP, COR_PROOF_LOG1P_ULP},
                                     {COR_PROOF_LOG_NEAR_ULP, COR_PROOF_LOG1P_ULP}};

struct bound {
    double ulp[2], at;
};

static void bound_take(bound *worst, int assumption, double error, double at)
{
    if (!(error <= worst->ulp[assumption])) {
        worst->ulp[assumption] = error;
        worst->at = at;
    }
}

static void bound_report(const char *name, const bound &worst, double promised, int assumption)
{
    const bool holds = worst.ulp[assumption] <= promised;
    printf("%s  %-28s %.2f ulp if log is within %g ulp, %.2f if within %g; worst at %.3g\n", holds ? "ok  " : "FAIL",
           name, worst.ulp[0], libraries[0].log, worst.ulp[1], libraries[1].log, worst.at);
    good = good && holds;
}

/* Returns the error after the last rounding, in ulp of the exact value, if the error before this rounding is `units`. A
 * power of two may be between the exact value and the sum. Then the sum may have the larger ulp. */
static double rounded(double units)
{
    return (units + (units > 1 ? 1 : 0.5)) * (1 + 1e-9);
}

/* Returns the second rounding error of a subnormal result. Results are normal up to q = `end`. */
static double subnormal(double q, double end)
{
    return q > end ? 0.5 : 0;
}

/* Relative errors of the functions of 1 + t, before the last rounding, from the errors of t and of the sum 1 + t */
static double of_load(double low, double, double t_error, double sum_error)
{
    return (t_error + sum_error) / (1 + low) + 4 * COR_PROOF_PAIRS;
}

static double of_root(double low, double high, double t_error, double sum_error)
{
    return of_load(low, high, t_error, sum_error) / 2 + 4 * COR_PROOF_PAIRS;
}

/* d ln((1 + t/2)/sqrt(1 + t))/dt = t/(2 (1 + t) (2 + t)) */
static double of_compression(double low, double high, double t_error, double sum_error)
{
    const double slope = (high + t_error) / (2 * (1 + low) * (2 + low));
    return t_error * slope + 2 * sum_error + 4 * COR_PROOF_PAIRS;
}

static const struct {
    const char *name;
    int multiple; /* for functions of a speed, q is twice the logarithm */
    double (*relative)(double low, double high, double t_error, double sum_error);
} t_laws[] = {{"load of a compression", 1, of_load},
              {"load of an energy", 1, of_root},
              {"largest load", 2, of_root},
              {"largest compression", 2, of_compression}};
enum { T_LAWS = sizeof t_laws / sizeof *t_laws };

/* Returns the error of t from an error of q: dt/dq = (1 + t)/t falls with t, and t(q (1 - rho)) >= (1 - rho) t(q). */
static double t_of_error(double low, double q_error, double q)
{
    const double rho = q_error / q;
    require(rho < 0.4, "q is known");
    return q_error * (1 + low) / low / (1 - rho) * (1 + 1e-9);
}

/* The limit exceeds the argument by at least one part in 2^92. */
static const double least_depth = 0x1p-92;

static bool has_power_of_two(double low, double high)
{
    return ulp(low * (1 - 1e-9)) < ulp(high * (1 + 1e-9));
}

/* Adds the errors of t(q) and of the functions of t, for t from 2^-47 to 2000. */
static void sum_over_t(double limit)
{
    bound t_of_q = {}, law[T_LAWS] = {};
    for (int k = 0;; k++) {
        const double low = 0x1p-47 * exp2(k / 32.0), high = 0x1p-47 * exp2((k + 1) / 32.0) * (1 + 1e-12);
        if (low > 2000)
            break;
        const ball q = q_of(from_to(ball(low), ball(high)));
        const double sum = (q.below() < 0.1001 ? COR_PROOF_SUM_SERIES : 0) + COR_PROOF_SUM_NEWTON;
        for (int i = 0; i < 2; i++) {
            const double own = pair_error(low, high, libraries[i]);
            if (i == 1)
                require(own <= 1.5 * 0x1p-52 * low && own <= u * (1 + low), "the pair t");
            /* check_borders tests arguments next to a power of two, where the error may exceed 1 ulp */
            const double own_ulp = own / ulp(low);
            require(i == 0 || own_ulp <= 1 || !has_power_of_two(low, high) || (low < 1.1 && high > 0.9) ||
                        (low < 0.51 && high > 0.49),
                    "t near 2^k");
            bound_take(&t_of_q, i, i == 0 ? rounded(own_ulp) : own_ulp + 0.5, low);
            for (int f = 0; f < T_LAWS; f++) {
                const int m = t_laws[f].multiple;
                if (q.above() < m * least_depth)
                    continue;
                const double error =
                    own +
                    t_of_error(low, m * depth_error(q.below() / m, q.above() / m, libraries[i], limit), q.below());
                const double relative = t_laws[f].relative(low, high, error, sum);
                bound_take(&law[f], i, rounded(relative / u) + subnormal(q.above(), 600), low);
            }
        }
    }
    /* below 2^-47 every part of the error of the series, relative to t, is smaller than at 2^-47 */
    bound_take(&t_of_q, 1, series_error(0x1p-47) / 0x1p-47 / u + 0.51, 0);
    for (int f = 0; f < T_LAWS; f++)
        bound_report(t_laws[f].name, law[f], COR_DISK_LAW_MAX_ULP, 0);
    bound_report("t of q", t_of_q, 2, 1);
}

/* ---- the rows of the load ---- */

/* Expands R = y - 1 - ln(y) - q in powers of t - at. y = pi/(c_0 + c_0' + c_1 t + ...), q = 2^octave (node + t). */
static void residual_series(arb_poly_t r, const double *c, double node, int octave, const ball &at, slong terms)
{
    LOCAL(arb_poly, y, log);
    for (slong k = 1; k < COR_INLINE_COLUMNS; k++)
        arb_poly_set_coeff_arb(r, k - 1, ball(c[k]).x);
    arb_poly_set_coeff_arb(r, 0, (ball(c[0]) + ball(c[1])).x);
    arb_poly_taylor_shift(r, r, at.x, bits);
    arb_poly_inv_series(y, r, terms, bits);
    const ball q = (ball(node) + at) * ball(ldexp(1, octave)) + ball(1);
    arb_poly_scalar_mul(y, y, pi_ball().x, bits);
    arb_poly_log_series(log, y, terms, bits);
    arb_poly_sub(r, y, log, bits);
    arb_poly_zero(y);
    arb_poly_set_coeff_arb(y, 0, q.x);
    arb_poly_set_coeff_arb(y, 1, ball(ldexp(1, octave)).x);
    arb_poly_sub(r, r, y, bits);
}

/* Returns the relative error of a row of the load in its cell |t| <= half: |R|/t_least, by Taylor's theorem. */
static double row_defect(const double *c, double node, int octave, double half, double t_least)
{
    enum { TERMS = 16 };
    LOCAL(arb_poly, at_node, in_cell);
    residual_series(at_node, c, node, octave, ball(0), TERMS);
    residual_series(in_cell, c, node, octave, around_0(half), TERMS + 1);
    ball sum(0), power(1), term;
    for (slong k = 0; k <= TERMS; k++, power = power * ball(half)) {
        arb_poly_get_coeff_arb(term.x, k < TERMS ? at_node : in_cell, k);
        sum = sum + size(term) * power;
    }
    return sum.above() / t_least * (1 + 1e-9);
}

/* Adds the errors of a load from cor_inline_row_product. The products of c_0 with both parts of the compression are
 * exact. The other terms are at most `share` of c_0. Each has 12 roundings, and the rounding of t counts as at most 10
 * more. */
static void sum_over_rows(void)
{
    bound load = {};
    for (int i = 0; i < COR_ROWS_DISK_LOAD_FACTOR_ROWS; i++) {
        const int cells = 1 << COR_ROWS_DISK_LOAD_FACTOR_OCTAVE_BITS;
        const int octave = COR_ROWS_DISK_LOAD_FACTOR_FIRST_OCTAVE + i / cells;
        const double *const c = cor_rows_disk_load_factor(i);
        const double half = 0.5 / cells, node = 1 + (i % cells + 0.5) / cells;
        const double t_least = lambert_t(ldexp(node - half, octave)).below();
        double share = 0, power = 1;
        for (int k = 1; k < COR_INLINE_COLUMNS; k++, power *= half)
            share += fabs(c[k]) * power / c[0] * (1 + 1e-9);
        const double digits = c[0] / ulp(c[0]) * 0x1p-27;
        require(share < 0.07 && digits == floor(digits), "a row of the load");
        const double defect = row_defect(c, node, octave, half, t_least);
        for (int k = 0; k < 2; k++) {
            const double q_error = libraries[k].log * 0x1p-54 + COR_PROOF_FAR + 0x1p-99;
            const double relative =
                defect + q_error / t_least * (1 + 1e-9) + u * (share * (12 + 10 + 3) + 0x1p-20) / (1 - share);
            bound_take(&load, k, rounded(relative / u), ldexp(node, octave));
        }
    }
    bound_report("load of a compression, rows", load, COR_DISK_LAW_MAX_ULP, 0);
}

/* Functions of q itself: argument^(1 + square) (constant + q)^power */
static const struct {
    const char *name;
    double constant, power;
    int square;
    double factor; /* if not 0: a leading logarithm, whose value is factor exp(-(1 + square) q) q^power */
    double least;  /* least q */
} q_laws[] = {{"compression of a load", 1, 1, 0, 0, least_depth},
              {"energy of a load", 0.5, 1, 1, 0, least_depth},
              {"leading log: compression", 0, 1, 0, 4, 0.999},
              {"leading log: load", 0, -1, 0, 12.566370614359172, 0x1p-54},
              {"leading log: energy", 0, -1, 1, 25.132741228718345, 0x1p-54},
              {"leading log: largest compr.", 0, 0.5, 0, 4, 0x1p-54},
              {"leading log: contact time", 0, 0.5, -1, 3.1415926535897931, 0x1p-54}};

static void sum_over_q(double limit)
{
    for (const auto &f : q_laws) {
        bound worst = {};
        for (int k = 0;; k++) {
            const double low = f.least * exp2(k / 64.0), high = f.least * exp2((k + 1) / 64.0) * (1 + 1e-12);
            if (low > 800)
                break;
            for (int i = 0; i < 2; i++) {
                const double q = depth_error(low, high, libraries[i], f.constant == 0 ? 0 : limit); /* 4 is exact */
                const double relative = fabs(f.power) * q / (f.constant + low) * (1 + 2 * q / (f.constant + low)) +
                                        4 * COR_PROOF_PAIRS + 0x1p-72;
                double units = relative / u;
                if (f.factor != 0 && high < 1) { /* finds the ulp from the range of values */
                    const double power_low = std::pow(low, f.power), power_high = std::pow(high, f.power);
                    const double least = f.factor * exp(-(1 + f.square) * high) * std::min(power_low, power_high);
                    const double most = f.factor * exp(-(1 + f.square) * low) * std::max(power_low, power_high);
                    units = std::min(units, relative * most * (1 + 1e-9) / ulp(least * (1 - 1e-9)));
                }
                bound_take(&worst, i, rounded(units) + subnormal(high, f.square == 1 ? 340 : 600), low);
            }
        }
        bound_report(f.name, worst, COR_DISK_LAW_MAX_ULP, 0);
    }
}

/* Tests doubles next to t = 1/2 and 1 with the linked library. Next to these powers of two, the errors that
 * sum_over_t adds exceed 1 ulp before the last rounding. */
static void check_borders(void)
{
    enum { STEPS = 24 };
    static const double of_t[] = {0.5, 1};
    double worst = 0;
    for (const double t : of_t) {
        double x = q_of(ball(t)).above();
        for (int i = 0; i < STEPS; i++)
            x = nextafter(x, 0);
        for (int i = 0; i < 2 * STEPS; i++, x = nextafter(x, 1)) {
            const ball value = lambert_t(x);
            worst = std::max(worst, size((ball(cor_lambert_t(x)) - value) / ball(ulp(value.below()))).above());
        }
    }
    printf("%s  %-28s %.2f ulp at %d doubles\n", worst <= 2 ? "ok  " : "FAIL", "beside t = 1/2, 1", worst, 4 * STEPS);
    good = good && worst <= 2;
}

int main(void)
{
    const double limit = limit_error();
    printf("limits: relative error of the pairs below 2^%.2f\n", log2(limit));
    sum_over_t(limit);
    sum_over_rows();
    sum_over_q(limit);
    check_borders();
    flint_cleanup();
    return good ? 0 : 1;
}
