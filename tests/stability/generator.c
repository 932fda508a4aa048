/* SPDX-License-Identifier: MIT */
/* The generator at high order: exact series, cancellation at the turning point, Padé systems and their poles. */
#include "stability.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "approximation/pade.h"
#include "enclosure/collision.h"
#include "motion.h"
#include "pumped.h"
#include "series/series.h"
#include "series/trajectory.h"
#include "series/turning_point.h"

static double bits_to_relative(slong bits)
{
    return ldexp(1, -(int)bits);
}

static void take_ball(struct outcome *out, double error, const char *input, const arb_t exact, const arb_t value)
{
    char *const x = arb_get_str(exact, 30, ARB_STR_NO_RADIUS), *const y = arb_get_str(value, 30, ARB_STR_NO_RADIUS);
    outcome_take(out, error, input, x, y);
    flint_free(x);
    flint_free(y);
}

/* ---- exact rationals ---- */

/* x(t) by exact coefficients, summed in interval arithmetic, against the motion itself */
static void exact_series(struct outcome *out, bool full)
{
    const slong order = full ? 40 : 14, terms = order, prec = 700;
    fmpq_poly_struct *const row = flint_malloc((size_t)(order + 1) * sizeof *row);
    arb_poly_t f;
    arb_t s, u, x, sum, beta, t;
    slong largest = 0;
    arb_poly_init(f);
    arb_init(s);
    arb_init(u);
    arb_init(x);
    arb_init(sum);
    arb_init(beta);
    arb_init(t);
    for (slong k = 0; k <= order; k++)
        fmpq_poly_init(row + k);
    trajectory_exact(row, order, terms, &law_sphere);
    static const double where[][2] = {{0.125, 0.25}, {0.0625, 0.5}, {-0.125, 0.25}};
    for (size_t i = 0; i < sizeof where / sizeof *where; i++) {
        arb_set_d(beta, where[i][0]);
        arb_set_d(t, where[i][1]);
        arb_sqrt(s, t, prec);
        arb_mul(s, s, t, prec); /* t^(3/2) */
        arb_mul(u, s, beta, prec);
        arb_mul(s, s, t, prec);
        arb_zero(sum);
        for (slong k = order; k >= 0; k--) {
            arb_poly_set_fmpq_poly(f, row + k, prec);
            arb_poly_evaluate(x, f, s, prec);
            arb_mul(sum, sum, u, prec);
            arb_add(sum, sum, x, prec);
            for (slong j = 0; j < fmpq_poly_length(row + k); j++) {
                const slong bits = (slong)fmpz_bits(fmpq_poly_numref(row + k) + j);
                largest = bits > largest ? bits : largest;
            }
        }
        arb_mul(sum, sum, t, prec);
        pumped_position(x, beta, t, full ? 260 : 160);
        char input[160];
        snprintf(input, sizeof input, "order %ld, beta = %g, t = %g; numbers of %ld bits", order, where[i][0],
                 where[i][1], largest);
        take_ball(out, ball_relative(sum, x), input, x, sum);
    }
    for (slong k = 0; k <= order; k++)
        fmpq_poly_clear(row + k);
    flint_free(row);
    arb_poly_clear(f);
    arb_clear(s);
    arb_clear(u);
    arb_clear(x);
    arb_clear(sum);
    arb_clear(beta);
    arb_clear(t);
}

/* ---- alternating sums ---- */

/* y, tau and C by the second route, the motion carried in power series of beta: once for all cases, to the order of the
 * form */
static arb_poly_t other_y, other_tau, other_c;

static slong need_other_route(bool full)
{
    static slong have;
    const slong order = full ? 25 : 10;
    if (have == 0) {
        arb_poly_init(other_y);
        arb_poly_init(other_tau);
        arb_poly_init(other_c);
    }
    if (have < order && collision_series(other_y, other_tau, other_c, order, &law_sphere, full ? 450 : 250) != 0)
        abort();
    have = have < order ? order : have;
    return order;
}

/* y_k and tau_k by the t-series in interval arithmetic, to `bits` bits, against the motion as a series in beta; and the
 * condition: the precision that the sums lose. */
static void turning_sums(struct outcome *out, bool full)
{
    enum { PROMISED = 100 };
    const slong order = need_other_route(full);
    struct series s;
    const arb_poly_struct *const reference[] = {other_y, other_tau, other_c}, *given[3];
    arb_t x, y;
    arb_init(x);
    arb_init(y);
    series_init(&s);
    if (series_compute(&s, order, &law_sphere, PROMISED) != 0)
        abort();
    given[0] = s.y;
    given[1] = s.tau;
    given[2] = s.c;
    for (int i = 0; i < 3; i++)
        for (slong k = 0; k <= order; k++) {
            static const char *const name[] = {"y", "tau", "C"};
            char input[160];
            arb_poly_get_coeff_arb(x, given[i], k);
            arb_poly_get_coeff_arb(y, reference[i], k);
            snprintf(input, sizeof input, "%s_%ld", name[i], k);
            /* balls that do not meet are a false proof, whatever their size */
            const double error = arb_overlaps(x, y) ? ball_relative(x, y) / bits_to_relative(PROMISED - 1) : HUGE_VAL;
            take_ball(out, error, input, y, x);
        }
    series_clear(&s);
    arb_clear(x);
    arb_clear(y);
}

/* Too few bits or too few terms must be said, never be a ball without the truth in it. */
static void turning_verdicts(struct outcome *out, bool full)
{
    const slong order = need_other_route(full) < 12 ? need_other_route(full) : 12;
    arb_poly_t y, tau;
    arb_t x, z;
    arb_poly_init(y);
    arb_poly_init(tau);
    arb_init(x);
    arb_init(z);
    static const slong tried[][3] = {{30, 100, 64}, {60, 100, 90}, {60, 100, 128}, {90, 100, 200}, {10, 60, 400}};
    slong lost = 0;
    for (size_t i = 0; i < sizeof tried / sizeof *tried; i++) {
        const enum turning_point_verdict verdict =
            turning_point_series(y, tau, order, tried[i][0], &law_sphere, tried[i][1], tried[i][2]);
        double error = 0;
        for (slong k = 0; k <= order; k++) {
            arb_poly_get_coeff_arb(x, y, k);
            arb_poly_get_coeff_arb(z, other_y, k);
            error += !arb_overlaps(x, z);
            const slong good = arb_rel_accuracy_bits(x);
            error += verdict == TURNING_POINT_OK && good < tried[i][1];
            if (verdict == TURNING_POINT_OK && tried[i][2] - good > lost)
                lost = tried[i][2] - good;
            arb_poly_get_coeff_arb(x, tau, k);
            arb_poly_get_coeff_arb(z, other_tau, k);
            error += !arb_overlaps(x, z);
        }
        char input[160];
        snprintf(input, sizeof input, "%ld terms, %ld bits for %ld", tried[i][0], tried[i][2], tried[i][1]);
        outcome_take(out, error, input, "-", verdict == TURNING_POINT_OK ? "good" : "refused");
    }
    out->condition = ldexp(1, (int)lost);
    arb_poly_clear(y);
    arb_poly_clear(tau);
    arb_clear(x);
    arb_clear(z);
}

/* h*^5: the end of the fall, by the generator and by the reference of tests/accuracy */
static void limit_of_fall(struct outcome *out, bool full)
{
    struct fall fall;
    arb_t h;
    arb_init(h);
    collision_h_star(h, full ? 300 : 140);
    arb_pow_ui(h, h, 5, 300);
    fall_init(&fall);
    take_ball(out, ball_relative(h, fall.h_star_5), "h*^5", fall.h_star_5, h);
    fall_clear(&fall);
    arb_clear(h);
}

/* ---- Padé ---- */

/* [m/m] of exp: p_j = m! (2 m - j)!/((2 m)! j! (m - j)!), q_j = (-1)^j p_j, against the linear system in interval
 * arithmetic. The condition is the growth of the intervals. */
static void exponential_pade(struct outcome *out, bool full)
{
    static const slong degree[] = {4, 10, 20, 30};
    for (size_t i = 0; i < (full ? sizeof degree / sizeof *degree : 3); i++) {
        const slong m = degree[i], prec = 20 * m + 64;
        struct pade f;
        arb_poly_t c;
        arb_t x, y;
        fmpz_t number;
        pade_init(&f);
        arb_poly_init(c);
        arb_init(x);
        arb_init(y);
        fmpz_init(number);
        f.root = 1;
        f.variable = "z";
        for (slong k = 0; k <= 2 * m; k++) {
            arb_fac_ui(x, (ulong)k, prec);
            arb_inv(x, x, prec);
            arb_poly_set_coeff_arb(c, k, x);
        }
        if (!pade_of_series(&f, c, m, m, prec))
            outcome_take(out, HUGE_VAL, "exp", "regular", "refused");
        for (slong j = 0; j <= m; j++)
            for (int side = 0; side < 2; side++) {
                char input[160];
                arb_bin_uiui(y, (ulong)m, (ulong)j, prec);
                arb_fac_ui(x, (ulong)(2 * m - j), prec);
                arb_mul(y, y, x, prec);
                arb_fac_ui(x, (ulong)(2 * m), prec);
                arb_div(y, y, x, prec);
                if (side && j % 2)
                    arb_neg(y, y);
                arb_poly_get_coeff_arb(x, side ? f.q : f.p, j);
                const double grown = (double)(prec - arb_rel_accuracy_bits(x));
                out->condition = fmax(out->condition, ldexp(1, (int)fmin(1000, grown)));
                snprintf(input, sizeof input, "exp [%ld/%ld], %c_%ld in %ld bits", m, m, side ? 'q' : 'p', j, prec);
                /* in bits that are lost beyond 100, or without the truth */
                take_ball(out, arb_overlaps(x, y) ? ball_relative(x, y) / 0x1p-60 : HUGE_VAL, input, y, x);
            }
        pade_clear(&f);
        arb_poly_clear(c);
        arb_clear(x);
        arb_clear(y);
        fmpz_clear(number);
    }
}

/* Padés of eps to 100 bits: Q eps - P must begin after z^(m+n), with a series from the other route. */
static void sphere_pade(struct outcome *out, bool full)
{
    enum { PROMISED = 100 };
    static const slong degree[][2] = {{3, 7}, {10, 15}};
    need_other_route(full);
    for (size_t i = 0; i < (full ? 2 : 1); i++) {
        const slong m = degree[i][0], n = degree[i][1], order = m + n, prec = 1000;
        const struct pade_request request = {PADE_ORDINARY, m, n, END_ZERO_OVERLAP, law_sphere};
        struct pade f;
        arb_poly_t c, product, magnitude;
        arb_t x, z;
        pade_init(&f);
        arb_poly_init(c);
        arb_poly_init(product);
        arb_poly_init(magnitude);
        arb_init(x);
        arb_init(z);
        if (pade_compute(&f, NULL, &request, PROMISED) != 0)
            abort();
        arb_poly_set_trunc(c, other_c, order + 1);
        arb_poly_mullow(product, f.q, c, order + 1, prec);
        arb_poly_sub(product, product, f.p, prec);
        for (slong k = 0; k < c->length; k++)
            arb_abs(c->coeffs + k, c->coeffs + k);
        for (slong k = 0; k < f.q->length; k++)
            arb_abs(f.q->coeffs + k, f.q->coeffs + k);
        arb_poly_mullow(magnitude, f.q, c, order + 1, prec);
        for (slong k = 0; k <= order; k++) {
            char input[160];
            arb_poly_get_coeff_arb(x, product, k);
            arb_poly_get_coeff_arb(z, magnitude, k);
            arb_div(x, x, z, 64);
            snprintf(input, sizeof input, "[%ld/%ld], residual at beta^%ld", m, n, k);
            arb_zero(z);
            take_ball(out, arb_contains_zero(x) ? upper(x) / bits_to_relative(PROMISED - 2) : HUGE_VAL, input, z, x);
        }
        /* what a relative change of 2^-53 of one C_k does to q, in units of 2^-53 */
        struct pade changed;
        arb_poly_t exact;
        pade_init(&changed);
        changed.root = 1;
        changed.variable = "beta";
        arb_poly_init(exact);
        arb_poly_set_trunc(exact, other_c, order + 1);
        for (slong k = 0; k < exact->length; k++)
            mag_zero(arb_radref(exact->coeffs + k));
        struct pade middle;
        pade_init(&middle);
        middle.root = 1;
        middle.variable = "beta";
        bool regular = pade_of_series(&middle, exact, m, n, prec);
        arb_set_d(x, 1 + 0x1p-53 * 2);
        arb_mul(exact->coeffs + order / 2, exact->coeffs + order / 2, x, prec);
        regular = regular && pade_of_series(&changed, exact, m, n, prec);
        for (slong k = 1; regular && k <= n; k++) {
            arb_poly_get_coeff_arb(x, changed.q, k);
            arb_poly_get_coeff_arb(z, middle.q, k);
            out->condition = fmax(out->condition, ball_relative(x, z) / 0x1p-52);
        }
        if (!regular)
            outcome_take(out, HUGE_VAL, "regular system", "regular", "refused");
        pade_clear(&middle);
        pade_clear(&changed);
        arb_poly_clear(exact);
        pade_clear(&f);
        arb_poly_clear(c);
        arb_poly_clear(product);
        arb_poly_clear(magnitude);
        arb_clear(x);
        arb_clear(z);
    }
}

/* 1/(1 + z) + d/(1 - z/2): the [1/2] is this function, with a pole at 2 and a zero at 2 (1 + d)/(1 - 2 d). With d = 0
 * the table's entry does not exist, and [0/1] has an infinite block. */
static void near_defect(struct outcome *out, bool full)
{
    (void)full;
    static const int power[] = {10, 20, 53, 100, 200, 300};
    const slong prec = 1200;
    for (size_t i = 0; i <= sizeof power / sizeof *power; i++) {
        const bool degenerate = i == sizeof power / sizeof *power;
        struct pade f;
        struct pade_analysis a;
        arb_poly_t c;
        arb_t d, x, distance;
        char input[160];
        pade_init(&f);
        pade_analysis_init(&a);
        arb_poly_init(c);
        arb_init(d);
        arb_init(x);
        arb_init(distance);
        f.root = 1;
        f.variable = "z";
        if (!degenerate) {
            arb_one(d);
            arb_mul_2exp_si(d, d, -power[i]);
        }
        for (slong k = 0; k <= 8; k++) {
            arb_mul_2exp_si(x, d, -k);
            arb_add_si(x, x, k % 2 ? -1 : 1, prec);
            arb_poly_set_coeff_arb(c, k, x);
        }
        const bool regular = pade_of_series(&f, c, 1, 2, prec);
        if (degenerate) {
            struct pade_block block = {0};
            const bool found = pade_block_of(&block, c, 1, 2, prec);
            outcome_take(out, !regular && found && block.m == 0 && block.n == 1 && block.open ? 0 : HUGE_VAL, "d = 0",
                         "degenerate", regular ? "regular" : "degenerate");
        } else if (!regular || !pade_analyse(&a, &f, prec)) {
            outcome_take(out, HUGE_VAL, "d > 0", "regular", "refused");
        } else {
            snprintf(input, sizeof input, "d = 2^-%d", power[i]);
            arb_mul_ui(distance, d, 3, prec);
            arb_mul_2exp_si(d, d, 1);
            arb_sub_ui(d, d, 1, prec);
            arb_neg(d, d);
            arb_div(distance, distance, d, prec);
            char *const defects = pade_defects(&a);
            const bool told = a.pairs == 1 && a.spurious == 1 && a.positive_poles == 1 && defects != NULL;
            free(defects);
            if (told) {
                take_ball(out,
                          arb_overlaps(a.pair->distance, distance) ? ball_absolute(a.pair->distance, distance)
                                                                   : HUGE_VAL,
                          input, distance, a.pair->distance);
            } else {
                outcome_take(out, HUGE_VAL, input, "a spurious pair", "none told");
            }
            out->condition = fmax(out->condition, ldexp(1, power[i])); /* 1/d: of the place of the pair in the series */
        }
        pade_clear(&f);
        pade_analysis_clear(&a);
        arb_poly_clear(c);
        arb_clear(d);
        arb_clear(x);
        arb_clear(distance);
    }
}

/* Sign changes of a polynomial on 4.5e-5 <= beta <= 22026, 100 places to a factor e. p(0) > 0. */
static slong sign_changes(const arb_poly_t p, slong prec)
{
    slong changes = 0;
    int before = 1;
    arb_t x, y;
    arb_init(x);
    arb_init(y);
    for (int k = -1000; k <= 1000; k++) {
        arb_set_d(x, exp(k / 100.0));
        arb_poly_evaluate(y, p, x, prec);
        const int sign = arf_sgn(arb_midref(y));
        changes += sign != before && sign != 0;
        before = sign != 0 ? sign : before;
    }
    arb_clear(x);
    arb_clear(y);
    return changes;
}

/* [0/9] = [0/10] = [1/9], since 1/eps has no beta^10: [1/10] does not exist. */
static bool does_not_exist(slong m, slong n)
{
    return m == 1 && n == 10;
}

/* Padés of eps: as many poles and zeros reported on the positive axis as signs change along it */
static void poles_of_eps(struct outcome *out, bool full)
{
    enum { BITS = 100, PREC = 300 };
    const slong most = full ? 14 : 6;
    for (slong m = 0; m <= most; m++)
        for (slong n = 1; m + n <= most; n++) {
            const struct pade_request request = {PADE_ORDINARY, m, n, END_ZERO_OVERLAP, law_sphere};
            struct pade f;
            struct pade_analysis a;
            char input[160];
            pade_init(&f);
            pade_analysis_init(&a);
            snprintf(input, sizeof input, "[%ld/%ld]", m, n);
            const bool made = pade_compute(&f, &a, &request, BITS) == 0;
            if (made == does_not_exist(m, n)) {
                outcome_take(out, HUGE_VAL, input, made ? "degenerate" : "regular", made ? "served" : "refused");
            } else if (made) {
                const slong poles = sign_changes(f.q, PREC), zeros = sign_changes(f.p, PREC);
                char *const defects = pade_defects(&a);
                const bool right = a.positive_poles == poles && a.positive_zeros == zeros &&
                                   (defects != NULL || (poles == 0 && zeros == 0));
                outcome_take(out, right ? 0 : 1, input, poles ? "a pole" : "no pole", defects ? "refused" : "accepted");
                free(defects);
            } else {
                outcome_take(out, 0, input, "degenerate", "refused");
            }
            pade_clear(&f);
            pade_analysis_clear(&a);
        }
}

static const struct hard_case generator_cases[] = {
    {"beta = -h*", "the fall to h* is a divergent series", "h*^5 (full: 300 bits)",
     "another manifold series, `tests/accuracy/motion.c`", "relative", 1e-30, limit_of_fall},
    {"exact rationals grow", "coefficients outgrow a machine word, or a term is lost",
     "x(t) to order 14 at three (beta, t), one of them pumped (full: order 40)", "the motion by Taylor steps, 160 bits",
     "relative", 1e-27, exact_series},
    {"alternating sums cancel", "the t-series at the turning point, and C_k from y_k",
     "y_k, tau_k, C_k to order 10 for 100 bits (full: 25)",
     "the motion carried in power series of beta, in interval arithmetic", "2^-99", 1, turning_sums},
    {"alternating sums cancel", "too few bits or terms go unnoticed", "30 to 90 terms, 64 to 400 bits for 60 or 100",
     "the same", "false proofs", 0, turning_verdicts},
    {"Padé systems are ill-conditioned", "the condition number consumes the precision",
     "exp, [4/4], [10/10], [20/20] with 20 bits a degree (full: [30/30])", "its closed form", "2^-60", 1,
     exponential_pade},
    {"Padé systems are ill-conditioned", "coefficients with fewer digits than are printed",
     "eps, [3/7] for 100 bits (full: [10/15])", "Q eps - P = O(beta^(m+n+1)), eps by the other route", "2^-98", 1,
     sphere_pade},
    {"spurious pole-zero pairs", "a pair too close to be resolved",
     "1/(1 + z) + d/(1 - z/2), d = 2^-10 to 2^-300, and 0", "pole and zero in closed form",
     "absolute, of their distance", 1e-15, near_defect},
    {"spurious pole-zero pairs", "a header has a pole on the positive axis",
     "every [m/n] of eps with m + n <= 6 (full: 14)", "signs along the axis, 2001 places", "wrong answers", 0,
     poles_of_eps},
};

const struct case_list stability_generator = {generator_cases, sizeof generator_cases / sizeof *generator_cases};
