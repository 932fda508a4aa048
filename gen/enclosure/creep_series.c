/* SPDX-License-Identifier: MIT */
#include "enclosure/creep_series.h"

#include "support/formula.h"
#include "support/local.h"

enum {
    BOUND_BITS = 96,
    FIRST_Y = 6, /* Y at which the bounds begin */
    STEPS_PER_Y = 2,
    FIRST_ORDER = 3
};

/* ---- the formal time Theta_n(r, k) = -2 ln(r) + sum_j r^j q_j(k) ---- */

/* Polynomials in e = k - 1 for 1 <= j <= CREEP_SERIES_ORDER. q[j] is q_j. source[j] is s_j = (1 + j/2) q_j' + k q_j'',
 * the source in (8.5) of docs/theory.md. */
struct formal_time {
    fmpq_poly_struct q[CREEP_SERIES_ORDER + 1], source[CREEP_SERIES_ORDER + 1];
};

/* Computes q_j from q_1' = -1 and (k - 1) q_(j+1)' = k (j q_j/2 + k q_j'). The right side vanishes at k = 1, which
 * gives q_j(1). */
static void formal_time_init(struct formal_time *f)
{
    LOCAL(fmpq_poly, k, sum, term);
    LOCAL(fmpq, constant, ratio);
    fmpq_poly_set_coeff_si(k, 0, 1);
    fmpq_poly_set_coeff_si(k, 1, 1);
    fmpq_poly_set_si(sum, -1);
    for (slong j = 1; j <= CREEP_SERIES_ORDER; j++) {
        FOR_ALL(fmpq_poly, init, &f->q[j], &f->source[j]);
        fmpq_poly_integral(&f->q[j], sum);
        fmpq_poly_get_coeff_fmpq(constant, sum, 0);
        fmpq_set_si(ratio, -2, (ulong)j);
        fmpq_mul(constant, constant, ratio);
        fmpq_poly_set_coeff_fmpq(&f->q[j], 0, constant);

        fmpq_poly_mul(sum, k, sum);
        fmpq_poly_scalar_mul_si(term, &f->q[j], j);
        fmpq_poly_scalar_div_si(term, term, 2);
        fmpq_poly_add(sum, sum, term);
        fmpq_poly_derivative(&f->source[j], sum);
        fmpq_poly_mul(sum, sum, k);
        fmpq_poly_shift_right(sum, sum, 1);
    }
}

static void formal_time_clear(struct formal_time *f)
{
    for (slong j = 1; j <= CREEP_SERIES_ORDER; j++) {
        FOR_ALL(fmpq_poly, clear, &f->q[j], &f->source[j]);
    }
}

/* ---- the bound of dTheta/dk - dTheta_n/dk ---- */

/* Bounds r^power |p| in the tube 1 <= k <= 1 + r + 2 r^2, which no motion leaves for r <= 1/6. */
static void largest_in_tube(arb_t bound, const fmpq_poly_t p, const arb_t r, slong power)
{
    LOCAL(arb, width);
    LOCAL(fmpq, x);
    LET(width, BOUND_BITS, "r*(1 + 2*r)", r); /* largest k - 1 */
    arb_zero(bound);
    for (slong i = fmpq_poly_degree(p); i >= 0; i--) {
        fmpq_poly_get_coeff_fmpq(x, p, i);
        fmpq_abs(x, x);
        LET(bound, BOUND_BITS, "bound*width + x", bound, width, x);
    }
    LET(bound, BOUND_BITS, "bound*r^power", bound, r, power);
}

/* Computes 1 - 3 r - r^2, which is at most 1/k^2 - r in the tube. */
static void least_contraction(arb_t least, const arb_t r)
{
    LET(least, BOUND_BITS, "1 - r*(3 + r)", r);
}

/* Computes exp of minus the integral of (2/s^2) (1 - 3 s - s^2) from `low` to `high`. */
static void bound_contraction(arb_t factor, const arb_t low, const arb_t high)
{
    LET(factor, BOUND_BITS, "exp(2*(1/high - 1/low + (high - low)) + 6*log(high/low))", low, high);
}

/* Adds bounds of the terms of dTheta_n/dk with first < j <= last. */
static void add_terms(arb_t bound, const struct formal_time *f, const arb_t r, slong first, slong last)
{
    LOCAL(arb, term);
    LOCAL(fmpq_poly, slope);
    for (slong j = first + 1; j <= last; j++) {
        fmpq_poly_derivative(slope, &f->q[j]);
        largest_in_tube(term, slope, r, j);
        arb_add(bound, bound, term, BOUND_BITS);
    }
}

/* Computes the bound at r = low from the bound at r = high by (8.5) with n = order. Towards smaller r the difference
 * decays, and the source 2 r^(n-1) s_n adds to it. */
static void bound_step(arb_t bound, const struct formal_time *f, slong order, const arb_t low, const arb_t high)
{
    LOCAL(arb, factor, source, least);
    bound_contraction(factor, low, high);
    largest_in_tube(source, &f->source[order], high, order + 1);
    least_contraction(least, high);
    LET(bound, BOUND_BITS, "bound*factor + source/least", bound, factor, source, least);
}

/* Computes the bound at r = 1/CREEP_SERIES_LEAST_Y. It starts with |dTheta/dk| <= (24/25)/r^2 at r = 1/FIRST_Y. */
static void start_bound(arb_t bound, const struct formal_time *f)
{
    LOCAL(arb, low, high);
    LET(bound, BOUND_BITS, "24*FIRST_Y^2/25", FIRST_Y);
    slong order = 0;
    for (slong i = FIRST_Y * STEPS_PER_Y; i < CREEP_SERIES_LEAST_Y * STEPS_PER_Y; i++) {
        /* use the best order at 1/r = i/STEPS_PER_Y: its last term is nearly the smallest term */
        const slong next = FLINT_MAX(FLINT_MIN(i / STEPS_PER_Y, CREEP_SERIES_ORDER), FIRST_ORDER);
        LET(high, BOUND_BITS, "STEPS_PER_Y/i", STEPS_PER_Y, i);
        LET(low, BOUND_BITS, "STEPS_PER_Y/(i + 1)", STEPS_PER_Y, i);
        add_terms(bound, f, high, order, next);
        bound_step(bound, f, next, low, high);
        order = next;
    }
    add_terms(bound, f, low, order, CREEP_SERIES_ORDER);
}

/* ---- the series ---- */

void creep_series_init(struct creep_series *s, slong prec)
{
    const slong n = CREEP_SERIES_ORDER;
    LOCAL(fmpq, constant);
    LOCAL(arb, r, x, least);
    FOR_ALL(arb, init, s->start, s->factor);
    LOCAL_INIT(formal_time, f, (&f));
    s->a = _arb_vec_init(CREEP_SERIES_ORDER + 1);
    for (slong j = 1; j <= CREEP_SERIES_ORDER; j++) {
        fmpq_poly_get_coeff_fmpq(constant, &f.q[j], 0);
        arb_set_fmpq(s->a + j, constant, prec);
    }
    start_bound(s->start, &f);
    /* With A = 2 s_n/(2 (1 - 3 r - r^2) - (n + 1) r), A r^(n+1) bounds the effect of the source. */
    LET(r, BOUND_BITS, "1/CREEP_SERIES_LEAST_Y", CREEP_SERIES_LEAST_Y);
    least_contraction(least, r);
    largest_in_tube(x, &f.source[CREEP_SERIES_ORDER], r, 0);
    LET(s->factor, BOUND_BITS, "2*x/(2*least - r*(n + 1))", x, least, r, n);
}

void creep_series_clear(struct creep_series *s)
{
    _arb_vec_clear(s->a, CREEP_SERIES_ORDER + 1);
    FOR_ALL(arb, clear, s->start, s->factor);
}

/* Integrates (2/s) |dTheta/dk - dTheta_n/dk| from 0 to r. */
void creep_series_remainder(arb_t bound, const struct creep_series *s, const arb_t r)
{
    const slong n = CREEP_SERIES_ORDER;
    LOCAL(arb, first, x, least);
    LET(first, BOUND_BITS, "1/CREEP_SERIES_LEAST_Y", CREEP_SERIES_LEAST_Y);
    arb_pos_inf(bound);
    if (!arb_is_positive(r) || !arb_le(r, first))
        return;
    bound_contraction(x, r, first);
    least_contraction(least, r);
    LET(bound, BOUND_BITS, "x*s->start*r/least + 2*r^(n + 1)*s->factor/(n + 1)", x, s->start, r, least, n, s->factor);
    arb_get_ubound_arf(arb_midref(bound), bound, BOUND_BITS);
    mag_zero(arb_radref(bound));
}
