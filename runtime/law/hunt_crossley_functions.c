/* SPDX-License-Identifier: MIT */
/* The functions of Hunt and Crossley's law. closed_form.h computes eps, loss and their inverses. Durations and the time
 * of the largest overlap have tables for a = 1 and a = 3/2 (generated/hunt_crossley_tables.h). Every other exponent and
 * negative damping need a quadrature. */
#include "generated/hunt_crossley_tables.h"
#include "runtime/law/closed_form.h"
#include "runtime/number/fifth_root.h"
#include "runtime/table/hertz_approach_only.h"
#include "runtime/table/row.h"

/* ---- a = 1 and a = 3/2 by tables ---- */

struct crossley_tables {
    const double *(*max_rows)(int), *(*duration_rows)(int), *(*far_max)(int), *(*far_rebound)(int);
    struct cor_inline_pair exponent; /* k = a/(a + 1) */
    double elastic, elastic_tail;    /* half of the elastic duration, as a pair */
};

static struct crossley_tables crossley_tables_of(double a)
{
    struct crossley_tables t;
    if (a == 1) {
        t.max_rows = cor_rows_crossley_time_of_max_overlap_1;
        t.duration_rows = cor_rows_crossley_duration_1;
        t.far_max = cor_rows_crossley_far_time_of_max_overlap_1;
        t.far_rebound = cor_rows_crossley_far_rebound_1;
        t.exponent = cor_pair(0.5, 0);
        t.elastic = COR_PI / 2;
        t.elastic_tail = 6.12323399573676588613e-17;
    } else {
        t.max_rows = cor_rows_crossley_time_of_max_overlap_3_2;
        t.duration_rows = cor_rows_crossley_duration_3_2;
        t.far_max = cor_rows_crossley_far_time_of_max_overlap_3_2;
        t.far_rebound = cor_rows_crossley_far_rebound_3_2;
        t.exponent = cor_pair(0.6, 2.22044604925031308085e-17);
        t.elastic = COR_HERTZ_HALF_DURATION;
        t.elastic_tail = COR_HERTZ_HALF_DURATION_TAIL;
    }
    return t;
}

/* Returns beta^(k - 1) (1 - k)^k. For beta above 2^53 this is beta^(2k - 1) ((1 - k)/(1 + beta))^k up to a factor 1 +
 * k/beta. */
static struct cor_inline_pair crossley_far_unit(struct cor_inline_pair log_beta, struct cor_inline_pair k)
{
    const struct cor_inline_pair rest = cor_pair_plus(cor_pair(1, 0), cor_pair(-k.hi, -k.lo));
    const struct cor_inline_pair power = cor_inline_pair_times(rest, log_beta);
    const struct cor_inline_pair constant = cor_inline_pair_times(k, cor_kernel_minus_log(rest));
    return cor_kernel_exp_minus_pair(cor_pair_plus(power, constant));
}

/* Returns the time of the largest overlap, 0 <= beta < inf. */
static struct cor_inline_pair crossley_max(const struct crossley_tables *tables, double beta)
{
    const struct cor_inline_pair s = cor_kernel_log_plus_1(beta);
    if (s.hi < COR_ROWS_CROSSLEY_TIME_OF_MAX_OVERLAP_1_END)
        return cor_grid_value(COR_INLINE_GRID(COR_ROWS_CROSSLEY_TIME_OF_MAX_OVERLAP_1), tables->max_rows, s);
    const double *c = tables->far_max(0), inverse = 1 / beta, v = s.hi;
    /* (1 + beta)^-k is beta^-k (1 - k/beta), so that ln(beta) suffices */
    const struct cor_inline_pair minus = cor_kernel_minus_log(cor_pair(beta, 0)), u = cor_pair(-minus.hi, -minus.lo);
    struct cor_inline_pair sum = cor_pair_plus(s, cor_pair(c[0], c[1]));
    sum.lo += inverse * (c[2] + v * (c[3] + v * c[4]) - tables->exponent.hi * (v + c[0]));
    return cor_inline_pair_times(crossley_far_unit(u, tables->exponent), sum);
}

/* Returns the time of the rebound for s = ln(1 + beta) >= 4.5. With k = a/(a + 1), U = 1 + beta - s and the constants
 * c_i of the table far_rebound, it is
 * beta^(2k - 1) (a + 1)^-k U^(1 - k) ((a + 1) + (c_1/U + ... + c_11/U^11)/U) */
static struct cor_inline_pair crossley_far_rebound(const struct crossley_tables *tables, double beta,
                                                   struct cor_inline_pair s)
{
    const double *c = tables->far_rebound(0);
    const struct cor_inline_pair k = tables->exponent, one = cor_pair(1, 0);
    const struct cor_inline_pair rest = cor_pair_plus(one, cor_pair(-k.hi, -k.lo)); /* 1/(a + 1) */
    const struct cor_inline_pair u = cor_pair_plus(cor_pair_two_sum(1, beta), cor_pair(-s.hi, -s.lo));
    const struct cor_inline_pair log_u = cor_kernel_minus_log(u), log_beta = cor_kernel_minus_log(cor_pair(beta, 0));
    double sum = 0;
    const double x = 1 / u.hi;
    for (int p = 10; p >= 0; p--)
        sum = c[p] + x * sum;
    /* -ln of beta^(2k - 1) U^(1 - k) (1 - k)^k */
    const struct cor_inline_pair slope = cor_pair_plus(k, cor_pair(-rest.hi, -rest.lo));
    struct cor_inline_pair exponent = cor_inline_pair_times(slope, log_beta);
    exponent = cor_pair_plus(exponent, cor_inline_pair_times(rest, log_u));
    const struct cor_inline_pair constant = cor_inline_pair_times(k, cor_kernel_minus_log(rest));
    exponent = cor_pair_plus(cor_pair(exponent.hi, exponent.lo), constant);
    struct cor_inline_pair factor = cor_pair_over(one, rest);
    factor = cor_inline_sum(factor.hi, factor.lo + x * x * sum);
    return cor_inline_pair_times(cor_kernel_exp_minus_pair(exponent), factor);
}

/* Returns the duration, 0 <= beta < inf. */
static double crossley_table_duration(const struct crossley_tables *tables, double beta)
{
    const struct cor_inline_pair s = cor_kernel_log_plus_1(beta);
    if (s.hi < COR_ROWS_CROSSLEY_DURATION_1_END)
        return cor_grid_value(COR_INLINE_GRID(COR_ROWS_CROSSLEY_DURATION_1), tables->duration_rows, s).hi;
    return cor_pair_plus(crossley_far_rebound(tables, beta, s), crossley_max(tables, beta)).hi;
}

/* Returns x^exponent; x.hi is a normal double. */
static struct cor_inline_pair crossley_power(struct cor_inline_pair x, struct cor_inline_pair exponent)
{
    return cor_kernel_exp_minus_pair(cor_inline_pair_times(exponent, cor_kernel_minus_log(x)));
}

/* ---- every exponent: quadrature ----
 *
 * Let tau = ln((1 + beta)/(1 + beta v)) during loading. During the rebound, let tau = ln((1 + beta v)/(1 - h)), which
 * runs backwards from the end. Loading and rebound each take the time
 *
 *     beta^(2k - 1) int_0^end (tau B(tau)/(1 - k))^-k d tau,   B = (1 + beta) E(-tau) - 1 or 1 - (1 - h) E(tau)
 *
 * with k = a/(a + 1), end = ln(1 + beta) or -ln(1 - h) and E(x) = (exp(x) - 1)/x. With tau = end w and b = B/(beta r),
 * r = 1 or eps, so that b(0) = 1, both times are
 *
 *     ((a + 1) end/beta)^(1/(a+1)) r^-k (1 - k) int_0^1 w^-k b(w)^-k dw
 *
 * b has no singularities, but b^-k has them at the zeros of b. For the loading these zeros are next to tau = 2 pi i m,
 * m != 0. For the rebound they are beyond the end: one at end + ln(1 + beta), where the collision began, and others
 * with imaginary parts of 7 or more. The interval is divided into panels. In each panel, b^-k is interpolated at
 * Chebyshev points by a polynomial of degree 20; its error is of order 3.7^-20 or less. In the first panel the
 * polynomial is integrated with the weight w^-k. */

struct crossley_side {
    double end, rest;   /* rest: 1 - h of the rebound, 0 for the loading */
    double speed, beta; /* speed: beta r */
    int rebound;
};

/* Returns (exp(x) - 1)/x - 1, |x| < 0.34, with relative accuracy. */
static double crossley_mean_exponential(double x)
{
    static const double c[] = COR_KERNEL_EXP_POLYNOMIAL;
    const double x2 = x * x, x4 = x2 * x2;
    return x * (COR_POLYNOMIAL_8(c, x, x2, x4) + ((c[8] + c[9] * x) + c[10] * x2) * (x4 * x4));
}

/* Returns b at w = 1 - below. Near w = 1 the rebound needs end - tau, which `below` gives without cancellation. */
static double crossley_b(const struct crossley_side *side, double w, double below)
{
    const double tau = side->end * w;
    if (tau < 0.34) {
        const double e = crossley_mean_exponential(side->rebound ? tau : -tau);
        return side->rebound ? 1 - side->rest / side->speed * e : 1 + e + e / side->beta;
    }
    if (!side->rebound) {
        const double gone = cor_kernel_one_minus_exp_minus(cor_pair(tau, 0));
        return (gone - (tau - gone) / side->beta) / tau;
    }
    const double left = side->end * below, near = left < 1400 ? cor_kernel_exp_minus(cor_pair(left, 0)) : 0;
    return (tau - near + side->rest) / (tau * side->speed);
}

static double crossley_exp(double x)
{
    return cor_kernel_exp_minus_pair(cor_pair(-x, 0)).hi;
}

static double crossley_minus_log(double x)
{
    return cor_kernel_minus_log(cor_pair(x, 0)).hi;
}

enum { DEGREE = 20 };

/* (1 + cos(pi j/20))/2, and weights of Clenshaw and Curtis's rule on [0, 1], which are symmetric */
static const double crossley_place[DEGREE + 1] = {0x1.0000000000000p+0, 0x1.fcd924a17f22ep-1, 0x1.f378709a22a80p-1,
                                                  0x1.e41900e9e9636p-1, 0x1.cf1bbcdcbfa54p-1, 0x1.b504f333f9de6p-1,
                                                  0x1.96791823aad2fp-1, 0x1.7438b8ad13780p-1, 0x1.4f1bbcdcbfa54p-1,
                                                  0x1.280c16cf50a6fp-1, 0x1.0000000000000p-1, 0x1.afe7d2615eb23p-2,
                                                  0x1.61c8864680b58p-2, 0x1.178e8ea5d9100p-2, 0x1.a61b9f7154b44p-3,
                                                  0x1.2bec333018867p-3, 0x1.8722191a02d61p-4, 0x1.be6ff16169c9bp-5,
                                                  0x1.90f1ecbbab00ap-6, 0x1.936daf406e919p-8, 0};
static const double clenshaw_curtis[DEGREE / 2 + 1] = {
    0x1.4880522014880p-10, 0x1.88ddbc6c94bdfp-7, 0x1.8f64d1c1e488ap-6, 0x1.23a57ba9f2560p-5,
    0x1.7a75f00c6ed6ep-5,  0x1.c6c0ba9c5f3a8p-5, 0x1.0456353477520p-4, 0x1.1e928048c5ae2p-4,
    0x1.32029b0efece3p-4,  0x1.3dafadaabf1b0p-4, 0x1.41c002b231adfp-4};

/* plus = a + 1, k = a/(a + 1), share = 1 - k, and the weights of (1 - k) int_0^1 w^-k f(w) dw */
struct crossley_rule {
    struct cor_inline_pair plus, share, k;
    double weight[DEGREE + 1];
};

/* Computes the rule. The integrals of Chebyshev's polynomials obey the recurrence of Piessens and Branders, J. Comput.
 * Appl. Math. 1, 55 (1975). */
static void crossley_rule_make(struct crossley_rule *rule, double a)
{
    double moment[DEGREE + 1], cosine[2 * DEGREE];
    rule->plus = cor_pair_two_sum(1, a);
    rule->share = cor_pair_over(cor_pair(1, 0), rule->plus);
    rule->k = cor_pair_over(cor_pair(a, 0), rule->plus);
    const double share = rule->share.hi;
    moment[0] = 1;
    moment[1] = -rule->k.hi / (1 + share);
    for (int n = 2; n <= DEGREE; n++)
        moment[n] = -(share + n * (n - 1 - share) * moment[n - 1]) / ((n - 1) * (n + share));
    moment[0] *= 0.5;
    moment[DEGREE] *= 0.5;
    for (int j = 0; j < 2 * DEGREE; j++)
        cosine[j] = 2 * crossley_place[j <= DEGREE ? j : 2 * DEGREE - j] - 1;
    for (int j = 0; j <= DEGREE / 2; j++) {
        double even = moment[0], odd = 0;
        for (int n = 1, at = j; n < DEGREE; n += 2) {
            const int next = at + j < 2 * DEGREE ? at + j : at + j - 2 * DEGREE;
            odd += moment[n] * cosine[at];
            even += moment[n + 1] * cosine[next];
            at = next + j < 2 * DEGREE ? next + j : next + j - 2 * DEGREE;
        }
        const double scale = j ? 2.0 / DEGREE : 1.0 / DEGREE;
        rule->weight[j] = scale * (even + odd);
        rule->weight[DEGREE - j] = scale * (even - odd);
    }
}

/* Returns the beginning of the panel that ends at w: 0, or a place whose distance from the singularity of w^-k is about
 * the length of the panel or more. */
static double crossley_panel(const struct crossley_side *side, double w)
{
    const double tau = side->end * w, least = 0x1p-52 * side->end; /* shorter panels are negligible */
    const double gap = side->end - tau + cor_kernel_log_plus_1(side->beta).hi;
    const double longest = side->rebound ? cor_kernel_max(2.0 * gap, least) : 5;
    if (tau <= longest)
        return 0;
    return cor_kernel_max(side->rebound ? w - longest / side->end : 0, w / 2.2);
}

/* Returns (1 - k) int_0^1 w^-k b^-k dw. The integral over the first panel is the integral of w^-k plus the integral of
 * w^-k (b^-k - 1), which is small where k is near 1. */
static double crossley_quadrature(const struct crossley_side *side, const struct crossley_rule *rule)
{
    const double k = rule->k.hi, share = rule->share.hi;
    double sum = 0;
    for (double to = 1, from; to > 0; to = from) {
        from = crossley_panel(side, to);
        const double length = to - from;
        double part = 0;
        for (int j = 0; j < DEGREE + (from > 0); j++) { /* at w = 0 the value is 1 */
            const double w = from + length * crossley_place[j];
            const double b = crossley_b(side, w, (1 - to) + length * crossley_place[DEGREE - j]);
            const double value = crossley_exp(k * crossley_minus_log(from > 0 ? w * b : b));
            part +=
                from > 0 ? value * clenshaw_curtis[j <= DEGREE / 2 ? j : DEGREE - j] : (value - 1) * rule->weight[j];
        }
        sum += from > 0 ? share * length * part : (1 + part) * crossley_exp(share * -crossley_minus_log(to));
    }
    return sum;
}

static double crossley_side_time(const struct crossley_side *side, const struct crossley_rule *rule)
{
    const struct cor_inline_pair log_speed = cor_kernel_minus_log(cor_pair(side->speed, 0)),
                                 log_beta = cor_kernel_minus_log(cor_pair(side->beta, 0)),
                                 log_end = cor_kernel_minus_log(cor_pair(side->end / side->beta * rule->plus.hi, 0));
    /* computes -ln of all factors together: a separate power of beta would lose digits where k ln(beta) is large */
    const struct cor_inline_pair slow = cor_pair_plus(log_beta, cor_pair(-log_speed.hi, -log_speed.lo));
    const struct cor_inline_pair factor = cor_kernel_exp_minus_pair(
        cor_pair_plus(cor_inline_pair_times(rule->share, log_end), cor_inline_pair_times(rule->k, slow)));
    return factor.hi * crossley_quadrature(side, rule);
}

static double crossley_loading(double beta, const struct crossley_rule *rule)
{
    const struct crossley_side side = {cor_kernel_log_plus_1(beta).hi, 0, beta, beta, 0};
    return crossley_side_time(&side, rule);
}

/* Returns the time of the rebound. For beta >= 2, end = -ln(1 - h) is computed as
 * beta + 1 - ln(1 + beta) - (1 - h). */
static double crossley_rebound(double beta, const struct crossley_rule *rule)
{
    const int weak = beta < 2;
    const double h = cor_kernel_min(beta * closed_eps(&crossley_ends, beta), 1), rest = 1 - h;
    const double end = weak ? cor_kernel_minus_log_one_minus(h).hi : beta + 1 - cor_kernel_log_plus_1(beta).hi - rest;
    const struct crossley_side side = {end, rest, h, beta, 1};
    return crossley_side_time(&side, rule);
}

/* Returns the time of the loading or of the rebound. In backward time, a collision with negative damping is a damped
 * collision that starts with the speed eps, with h = -beta. The loading of one is the rebound of the other. */
static double crossley_half(double beta, const struct crossley_rule *rule, int rebound)
{
    if (fabs(beta) < 1e-15)
        return crossley_loading(1e-15, rule);
    if (beta > 0)
        return rebound ? crossley_rebound(beta, rule) : crossley_loading(beta, rule);
    const double eps = closed_eps(&crossley_ends, beta), damped = -beta * eps;
    const struct cor_inline_pair power = cor_pair_plus(rule->share, cor_pair(-rule->k.hi, -rule->k.lo));
    const double unit = crossley_power(cor_pair(eps, 0), power).hi;
    const struct crossley_side backward = {-cor_kernel_log_plus_1(beta).hi, 1 + beta, -beta, damped, 1};
    return unit * (rebound ? crossley_loading(damped, rule) : crossley_side_time(&backward, rule));
}

/* ---- the functions ---- */

static int crossley_valid(double beta, double a)
{
    return beta > -1 && a >= 0 && a <= COR_HUNT_CROSSLEY_MAX_EXPONENT;
}

static int crossley_has_table(double beta, double a)
{
    return beta >= 0 && (a == 1 || a == 1.5);
}

static double crossley_duration(double beta, double elastic_exponent)
{
    const double a = elastic_exponent;
    if (!crossley_valid(beta, a))
        return NAN;
    if (isinf(beta))
        return a > 0 ? INFINITY
                     : 1; /* a = 0, a constant force: the approach takes no time, and the rebound takes the time 1 */
    if (crossley_has_table(beta, a)) {
        const struct crossley_tables tables = crossley_tables_of(a);
        return crossley_table_duration(&tables, beta);
    }
    struct crossley_rule rule;
    crossley_rule_make(&rule, a);
    return crossley_half(beta, &rule, 0) + crossley_half(beta, &rule, 1);
}

static double crossley_time_of_max_overlap(double beta, double elastic_exponent)
{
    const double a = elastic_exponent;
    if (!crossley_valid(beta, a))
        return NAN;
    if (isinf(beta))
        return 0;
    if (crossley_has_table(beta, a)) {
        const struct crossley_tables tables = crossley_tables_of(a);
        return crossley_max(&tables, beta).hi;
    }
    struct crossley_rule rule;
    crossley_rule_make(&rule, a);
    return crossley_half(beta, &rule, 0);
}

/* Returns eps^((1 - a)/(1 + a)), the time of the elastic rebound to the speed eps divided by half of the elastic
 * duration. */
static struct cor_inline_pair crossley_elastic_rebound(double beta, double a)
{
    const struct cor_inline_pair plus = cor_pair_two_sum(1, a), minus = cor_pair_two_sum(1, -a);
    return crossley_power(cor_crossley_eps_approach_pair(beta), cor_pair_over(minus, plus));
}

static double crossley_duration_approach_only(double beta, double elastic_exponent)
{
    const double a = elastic_exponent;
    if (!crossley_valid(beta, a))
        return NAN;
    if (isinf(beta) && a != 1)
        return a > 1 ? INFINITY : 0;
    if (crossley_has_table(beta, a)) {
        const struct crossley_tables tables = crossley_tables_of(a);
        const struct cor_inline_pair half = cor_pair(tables.elastic, tables.elastic_tail);
        if (isinf(beta))
            return half.hi;
        const struct cor_inline_pair rebound = cor_inline_pair_times(half, crossley_elastic_rebound(beta, a));
        return cor_pair_plus(rebound, crossley_max(&tables, beta)).hi;
    }
    struct crossley_rule rule;
    crossley_rule_make(&rule, a);
    return crossley_half(beta, &rule, 0) + crossley_half(0, &rule, 0) * crossley_elastic_rebound(beta, a).hi;
}

/* ---- the largest overlap ---- */

/* For larger beta, eps is computed in units of 2^-380, so that its fourth power is a normal number. */
#define CROSSLEY_HUGE COR_INLINE_2_500

/* Returns X^(1/(a + 1)), X = (a + 1)/2 eps^2, 0 <= a < inf, where eps is for damping during the approach only. The
 * result is the fifth root of X^2 for a = 3/2, and the square root of X for a = 1. */
static double crossley_max_overlap(double beta, double elastic_exponent)
{
    const double a = elastic_exponent;
    if (!(beta > -1 && a >= 0) || isinf(a))
        return (double)NAN;
    if (isinf(beta))
        return 0;
    if (a > COR_INLINE_2_100)
        return 1;
    const int huge = beta > CROSSLEY_HUGE;
    const struct cor_inline_pair eps = cor_pair_scaled(cor_crossley_eps_approach_pair(beta), huge ? 0x1p380 : 1);
    if (a == 1.5) { /* the fifth root of 25/16 eps^4, corrected for its rounding */
        const struct cor_inline_pair square = cor_inline_product(eps.hi, eps.hi);
        const struct cor_inline_pair root = cor_inline_fifth_root_parts(square.hi * square.hi * 1.5625);
        const double rest = (0.4 * square.lo + 0.8 * eps.hi * eps.lo) / square.hi;
        return (root.hi + (root.lo + root.hi * rest)) * (huge ? 0x1p-304 : 1);
    }
    const struct cor_inline_pair plus = cor_pair_two_sum(1, a);
    const struct cor_inline_pair x = cor_inline_pair_times(cor_pair_scaled(plus, 0.5), cor_inline_pair_times(eps, eps));
    if (a == 1) {
        const struct cor_inline_pair root = cor_pair_root(x);
        return (root.hi + root.lo) * (huge ? 0x1p-380 : 1);
    }
    struct cor_inline_pair minus_log = cor_kernel_minus_log(x);
    if (huge)
        minus_log = cor_pair_plus(minus_log, cor_pair(760 * COR_KERNEL_LN2_HEAD, 760 * COR_KERNEL_LN2_TAIL));
    return cor_kernel_exp_minus_pair(cor_pair_over(minus_log, plus)).hi;
}

/* ---- the functions with the exponent as an argument ---- */

double cor_hunt_crossley_max_overlap(double beta, double elastic_exponent)
{
    return law_value_of_exponent(crossley_max_overlap, beta, elastic_exponent);
}

void cor_hunt_crossley_max_overlap_array(const double *beta, double elastic_exponent, double *y, size_t n)
{
    law_array_of_exponent(crossley_max_overlap, beta, elastic_exponent, y, n);
}

double cor_hunt_crossley_duration(double beta, double elastic_exponent)
{
    return law_value_of_exponent(crossley_duration, beta, elastic_exponent);
}

void cor_hunt_crossley_duration_array(const double *beta, double elastic_exponent, double *y, size_t n)
{
    law_array_of_exponent(crossley_duration, beta, elastic_exponent, y, n);
}

double cor_hunt_crossley_duration_approach_only(double beta, double elastic_exponent)
{
    return law_value_of_exponent(crossley_duration_approach_only, beta, elastic_exponent);
}

void cor_hunt_crossley_duration_approach_only_array(const double *beta, double elastic_exponent, double *y, size_t n)
{
    law_array_of_exponent(crossley_duration_approach_only, beta, elastic_exponent, y, n);
}

double cor_hunt_crossley_time_of_max_overlap(double beta, double elastic_exponent)
{
    return law_value_of_exponent(crossley_time_of_max_overlap, beta, elastic_exponent);
}

void cor_hunt_crossley_time_of_max_overlap_array(const double *beta, double elastic_exponent, double *y, size_t n)
{
    law_array_of_exponent(crossley_time_of_max_overlap, beta, elastic_exponent, y, n);
}

/* ---- the functions of the table: x is beta, eps or 1 - eps ---- */

/* In the table of law.h the elastic exponent is 3/2, and times need beta >= 0. */
#define ELASTIC 1.5

static double duration_at(double beta)
{
    return cor_inline_is_refused(beta) ? NAN : crossley_duration(beta, ELASTIC);
}

static double duration_approach_only_at(double beta)
{
    return cor_inline_is_refused(beta) ? NAN : crossley_duration_approach_only(beta, ELASTIC);
}

static double time_of_max_overlap_at(double beta)
{
    return cor_inline_is_refused(beta) ? NAN : crossley_time_of_max_overlap(beta, ELASTIC);
}

static double max_overlap_at(double beta)
{
    return crossley_max_overlap(beta, ELASTIC);
}

/* clang-format off */
static double eps_ends(double x) { return closed_value(&crossley_ends, COR_EPS, x); }
static double loss_ends(double x) { return closed_value(&crossley_ends, COR_LOSS, x); }
static double beta_ends(double x) { return closed_value(&crossley_ends, COR_DAMPING_OF_EPS, x); }
static double beta_of_loss_ends(double x) { return closed_value_of_loss(&crossley_ends, beta_ends, x); }
static double eps_approach_only(double x) { return closed_value(&crossley_approach_only, COR_EPS, x); }
static double loss_approach_only(double x) { return closed_value(&crossley_approach_only, COR_LOSS, x); }
static double beta_approach_only(double x) { return closed_value(&crossley_approach_only, COR_DAMPING_OF_EPS, x); }
static double beta_of_loss_approach_only(double x)
{ return closed_value_of_loss(&crossley_approach_only, beta_approach_only, x); }
static double duration(double x) { return law_value(duration_at, x); }
static double duration_approach_only(double x) { return law_value(duration_approach_only_at, x); }
static double time_of_max_overlap(double x) { return law_value(time_of_max_overlap_at, x); }
static double max_overlap(double x) { return law_value(max_overlap_at, x); }

static void eps_ends_array(const double *x, double *y, size_t n)
{ cor_row_array(&crossley_ends.eps, eps_ends, x, y, n); }
static void loss_ends_array(const double *x, double *y, size_t n)
{ cor_row_array(&crossley_ends.loss, loss_ends, x, y, n); }
static void beta_ends_array(const double *x, double *y, size_t n)
{ cor_row_array(&crossley_ends.damping_of_eps, beta_ends, x, y, n); }
static void beta_of_loss_ends_array(const double *x, double *y, size_t n)
{ cor_row_array(&crossley_ends.damping_of_loss, beta_of_loss_ends, x, y, n); }
static void eps_approach_only_array(const double *x, double *y, size_t n)
{ cor_row_array(&crossley_approach_only.eps, eps_approach_only, x, y, n); }
static void loss_approach_only_array(const double *x, double *y, size_t n)
{ cor_row_array(&crossley_approach_only.loss, loss_approach_only, x, y, n); }
static void beta_approach_only_array(const double *x, double *y, size_t n)
{ cor_row_array(&crossley_approach_only.damping_of_eps, beta_approach_only, x, y, n); }
static void beta_of_loss_approach_only_array(const double *x, double *y, size_t n)
{ cor_row_array(&crossley_approach_only.damping_of_loss, beta_of_loss_approach_only, x, y, n); }
static void duration_array(const double *x, double *y, size_t n)
{ cor_array_in_environment(duration_at, x, y, n); }
static void duration_approach_only_array(const double *x, double *y, size_t n)
{ cor_array_in_environment(duration_approach_only_at, x, y, n); }
static void time_of_max_overlap_array(const double *x, double *y, size_t n)
{ cor_array_in_environment(time_of_max_overlap_at, x, y, n); }
static void max_overlap_array(const double *x, double *y, size_t n)
{ cor_array_in_environment(max_overlap_at, x, y, n); }
/* clang-format on */

/* The smallest double above -1 */
#define LEAST (-0x1.fffffffffffffp-1)

#define OVERLAP_ROWS                                                                                                   \
    COR_LAW_ROW("hunt_crossley_max_overlap", max_overlap, LEAST, INFINITY, 2),                                         \
        COR_LAW_ROW("hunt_crossley_time_of_max_overlap", time_of_max_overlap, 0, INFINITY, 2)
#define ROWS(end, eps, loss, damping_of_eps, damping_of_loss, duration)                                                \
    {                                                                                                                  \
        COR_LAW_ROW("hunt_crossley_eps_" end, eps, LEAST, INFINITY, 2),                                                \
            COR_LAW_ROW("hunt_crossley_loss_" end, loss, LEAST, INFINITY, 2),                                          \
            COR_LAW_ROW("hunt_crossley_damping_of_eps_" end, damping_of_eps, 0, 1, 2),                                 \
            COR_LAW_ROW("hunt_crossley_damping_of_loss_" end, damping_of_loss, 0, 1, 2),                               \
            COR_LAW_ROW("hunt_crossley_duration_" end, duration, 0, INFINITY, 2), OVERLAP_ROWS                         \
    }

/* In the order of enum cor_quantity */
const cor_law_functions cor_hunt_crossley_functions = {
    [COR_END_ZERO_OVERLAP] = ROWS("zero_overlap", eps_ends, loss_ends, beta_ends, beta_of_loss_ends, duration),
    [COR_END_ZERO_FORCE] = ROWS("zero_force", eps_ends, loss_ends, beta_ends, beta_of_loss_ends, duration),
    [COR_END_APPROACH_ONLY] = ROWS("approach_only", eps_approach_only, loss_approach_only, beta_approach_only,
                                   beta_of_loss_approach_only, duration_approach_only),
};
