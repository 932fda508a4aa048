/* SPDX-License-Identifier: MIT */
#include "reference.h"

#include "motion.h"
#include "series/restitution.h"
#include "series/series.h"
#include "support/formula.h"
#include "support/local.h"

#include <math.h>
#include <stdbool.h>

enum {
    BITS = MOTION_BITS,
    /* beta below 2^FIRST_BINADE: series, TERMS in beta and as many in sqrt(beta) */
    FIRST_BINADE = -3,
    TERMS = 24,
    /* beyond 2^LAST_BINADE: powers and logarithms; three binades more serve as their period */
    LAST_BINADE = 45,
    BINADES = LAST_BINADE + 3 - FIRST_BINADE,
    /* cells of a binade: quarters in the first ones, where singularities in the complex plane are near, then halves */
    QUARTERED = 7,
    QUARTERS = 4,
    HALVES = 2,
    CELLS = QUARTERED * QUARTERS + (BINADES - QUARTERED) * HALVES,
    POINTS = 24,
    /* from 2^MANIFOLD_BINADE on the unloading joins the slow manifold long before its end */
    MANIFOLD_BINADE = 4,
    CLOSED_BINADE = 3
};

/* The polynomial c[0] + low + c[1] x + ...; low is what c[0] lost to rounding. */
struct cell {
    long double low, c[POINTS];
};

/* value = beta^power (even(beta) + sqrt(beta) odd(beta)) */
struct small {
    int power;
    long double low, even[TERMS], odd[TERMS];
};

static struct cell cells[QUANTITIES][CELLS];
static struct small series[ALL_QUANTITIES];
static long double h_star_5, ln2;

/* A cell and its range of beta. */
struct place {
    int index;
    long double middle, half;
};

/* Where beta is, 2^FIRST_BINADE <= beta < 2^(LAST_BINADE + 3). */
static struct place place_of(long double beta)
{
    int exponent;
    const long double mantissa = 2 * frexpl(beta, &exponent); /* in [1, 2) */
    const int binade = exponent - 1 - FIRST_BINADE;
    const int parts = binade < QUARTERED ? QUARTERS : HALVES, part = (int)((mantissa - 1) * (long double)parts);
    const int first = binade < QUARTERED ? binade * QUARTERS : QUARTERED * QUARTERS + (binade - QUARTERED) * HALVES;
    const long double half = ldexpl(1, exponent - 2) / (long double)parts;
    return (struct place){first + part, ldexpl(1, exponent - 1) + (long double)(2 * part + 1) * half, half};
}

/* ---- tables ---- */

static long double rounded(const arb_t x)
{
    mpfr_t y;
    mpfr_init2(y, BITS);
    arf_get_mpfr(y, arb_midref(x), MPFR_RNDN);
    const long double value = mpfr_get_ld(y, MPFR_RNDN);
    mpfr_clear(y);
    return value;
}

static void cell_split(long double *high, long double *low, const arb_t x)
{
    LOCAL(arb, rest);
    mpfr_t y;
    mpfr_init2(y, 64);
    *high = rounded(x);
    mpfr_set_ld(y, *high, MPFR_RNDN);
    arf_set_mpfr(arb_midref(rest), y);
    arb_sub(rest, x, rest, BITS);
    *low = rounded(rest);
    mpfr_clear(y);
}

/* From a power series in sqrt(beta) without its first 2 power terms. */
static void small_set(struct small *s, const arb_poly_t f, int power)
{
    LOCAL(arb, c);
    s->power = power;
    for (slong k = 0; k < TERMS; k++) {
        arb_poly_get_coeff_arb(c, f, 2 * (k + power));
        s->even[k] = rounded(c);
        if (k == 0)
            cell_split(&s->even[0], &s->low, c);
        arb_poly_get_coeff_arb(c, f, 2 * (k + power) + 1);
        s->odd[k] = rounded(c);
    }
}

/* f(z^2) */
static void in_root(arb_poly_t g, const arb_poly_t f)
{
    LOCAL(arb, c);
    arb_poly_zero(g);
    for (slong k = 0; k < f->length; k++) {
        arb_poly_get_coeff_arb(c, f, k);
        arb_poly_set_coeff_arb(g, 2 * k, c);
    }
}

/* T_zero_overlap = tau(beta) + eps^(-1/5) tau(-h), h = beta eps^(1/5); T_zero_force = T_zero_overlap - beta T(w),
 * w = h^(5/2). As power series in z = sqrt(beta). */
static void duration_series(arb_poly_t overlap, arb_poly_t force, const struct series *s, slong length)
{
    const slong n = s->order + 1;
    LOCAL(arb_poly, root, h, x, T);
    LOCAL(fmpq_poly, G_exact, T_exact);
    LOCAL(arb, e);

    arb_set_si(e, 5);
    arb_inv(e, e, 2 * BITS);
    arb_poly_pow_arb_series(root, s->c, e, n, 2 * BITS);
    arb_poly_shift_left(h, root, 1);
    arb_poly_truncate(h, n);
    arb_poly_neg(x, h);
    arb_poly_compose_series(x, s->tau, x, n, 2 * BITS);
    arb_poly_div_series(x, x, root, n, 2 * BITS);
    arb_poly_add(x, x, s->tau, 2 * BITS);
    in_root(overlap, x);

    restitution_zero_force_exact(G_exact, T_exact, length / 5 + 1, &law_sphere);
    arb_poly_set_fmpq_poly(T, T_exact, 2 * BITS);
    arb_set_d(e, 0.5);
    arb_poly_pow_arb_series(x, s->c, e, n, 2 * BITS); /* w = beta^(5/2) eps^(1/2) */
    in_root(h, x);
    arb_poly_shift_left(h, h, 5);
    arb_poly_truncate(h, length);
    arb_poly_compose_series(x, T, h, length, 2 * BITS);
    arb_poly_shift_left(x, x, 2);
    arb_poly_sub(force, overlap, x, 2 * BITS);
}

/* (y/y_0)^(5/4) */
static void approach_series(arb_poly_t eps, const arb_poly_t y, slong order)
{
    LOCAL(arb, power);
    arb_poly_get_coeff_arb(power, y, 0);
    arb_poly_scalar_div(eps, y, power, 2 * BITS);
    arb_set_d(power, 1.25);
    arb_poly_pow_arb_series(eps, eps, power, order + 1, 2 * BITS);
}

static int build_series(void)
{
    const slong order = TERMS + 2;
    slong root;
    LOCAL(series, s);
    LOCAL(arb_poly, f, g);
    int failed = series_compute(s, order, &law_sphere, BITS);
    if (!failed) {
        in_root(f, s->y);
        small_set(&series[MAX_OVERLAP], f, 0);
        approach_series(g, s->y, order);
        in_root(f, g);
        small_set(&series[EPS_APPROACH_ONLY], f, 0);
        arb_poly_neg(f, f);
        small_set(&series[LOSS_APPROACH_ONLY], f, 1);
        in_root(f, s->tau);
        small_set(&series[TIME_OF_MAX_OVERLAP], f, 0);
        in_root(f, s->c);
        small_set(&series[EPS_ZERO_OVERLAP], f, 0);
        arb_poly_neg(f, f);
        small_set(&series[LOSS_ZERO_OVERLAP], f, 1);
        duration_series(f, g, s, 2 * order);
        small_set(&series[DURATION_ZERO_OVERLAP], f, 0);
        small_set(&series[DURATION_ZERO_FORCE], g, 0);
        failed = series_eps(f, &root, END_ZERO_FORCE, 2 * order, &law_sphere, BITS);
    }
    if (!failed) {
        small_set(&series[EPS_ZERO_FORCE], f, 0);
        arb_poly_neg(f, f);
        small_set(&series[LOSS_ZERO_FORCE], f, 1);
    }
    return failed;
}

static bool negative_at(const arb_t sigma, arb_srcptr component)
{
    LOCAL(arb, x);
    motion_value(x, component, sigma);
    return arb_is_negative(x);
}

/* All quantities at one beta >= 1/8; those of zero overlap that have a closed form there stay 0. */
static void fall_solve(arb_ptr value, const arb_t beta, const struct fall *fall)
{
    enum { NOTHING, TURNED, RELEASED } seen = NOTHING;
    struct motion m;
    LOCAL(arb, length, mu, x);
    bool done = false;
    LET(length, 2 * BITS, "beta^(-2/3)", beta);
    LET(mu, 2 * BITS, "beta^(-5/3)", beta);
    const bool manifold = arf_cmpabs_2exp_si(arb_midref(beta), MANIFOLD_BINADE) >= 0;
    const bool closed = arf_cmpabs_2exp_si(arb_midref(beta), CLOSED_BINADE) >= 0;

    _arb_vec_zero(value, QUANTITIES);
    motion_init(&m, mu);
    while (!done) {
        motion_expand(&m);
        if (seen == NOTHING && negative_at(m.step, m.v)) {
            seen = TURNED;
            motion_zero(x, m.v, m.step);
            motion_value(value + TIME_OF_MAX_OVERLAP, m.s, x);
            motion_value(value + MAX_OVERLAP, m.square, x);
        }
        const bool parted = negative_at(m.step, m.w);
        if (parted) {
            done = true;
            motion_zero(m.step, m.w, m.step);
            motion_value(value + DURATION_ZERO_OVERLAP, m.s, m.step);
            motion_value(value + EPS_ZERO_OVERLAP, m.f, m.step);
            arb_neg(value + EPS_ZERO_OVERLAP, value + EPS_ZERO_OVERLAP);
        }
        if (seen == TURNED && negative_at(m.step, m.f)) {
            seen = RELEASED;
            motion_zero(x, m.f, m.step);
            motion_value(value + DURATION_ZERO_FORCE, m.s, x);
            motion_value(value + EPS_ZERO_FORCE, m.v, x);
            arb_neg(value + EPS_ZERO_FORCE, value + EPS_ZERO_FORCE);
        }
        if (!done)
            motion_advance(&m, m.step);
        if (manifold && seen == RELEASED && fall_joined(fall, &m)) {
            done = true;
            fall_time(value + DURATION_ZERO_OVERLAP, fall, &m);
            arb_div(value + DURATION_ZERO_OVERLAP, value + DURATION_ZERO_OVERLAP, m.mu, BITS);
            arb_add(value + DURATION_ZERO_OVERLAP, value + DURATION_ZERO_OVERLAP, m.s, BITS);
        }
    }
    const enum quantity scaled[] = {DURATION_ZERO_OVERLAP, DURATION_ZERO_FORCE, MAX_OVERLAP, TIME_OF_MAX_OVERLAP};
    for (size_t i = 0; i < sizeof scaled / sizeof *scaled; i++)
        arb_mul(value + scaled[i], value + scaled[i], length, BITS);
    arb_sub_si(value + LOSS_ZERO_FORCE, value + EPS_ZERO_FORCE, 1, BITS);
    arb_neg(value + LOSS_ZERO_FORCE, value + LOSS_ZERO_FORCE);
    arb_sub_si(value + LOSS_ZERO_OVERLAP, value + EPS_ZERO_OVERLAP, 1, BITS);
    arb_neg(value + LOSS_ZERO_OVERLAP, value + LOSS_ZERO_OVERLAP);
    if (closed) {
        arb_zero(value + EPS_ZERO_OVERLAP);
        arb_zero(value + LOSS_ZERO_OVERLAP);
    }
    motion_clear(&m);
}

/* The polynomials of a cell through the values at x_j of [-1, 1] */
static void build_cell(struct place place, arb_srcptr x, const struct fall *fall)
{
    arb_ptr values = _arb_vec_init(QUANTITIES * POINTS), value = _arb_vec_init(QUANTITIES);
    LOCAL(arb, beta, c);
    LOCAL(arb_poly, f);
    const double middle = (double)place.middle, half = (double)place.half;
    for (slong j = 0; j < POINTS; j++) {
        arb_srcptr at = x + j;
        LET(beta, BITS, "middle + half*at", middle, half, at);
        arb_get_mid_arb(beta, beta);
        fall_solve(value, beta, fall);
        for (int q = 0; q < QUANTITIES; q++)
            arb_swap(values + q * POINTS + j, value + q);
    }
    for (int q = 0; q < QUANTITIES; q++) {
        struct cell *cell = &cells[q][place.index];
        arb_poly_interpolate_barycentric(f, x, values + q * POINTS, POINTS, 2 * BITS);
        for (slong k = 0; k < POINTS; k++) {
            arb_poly_get_coeff_arb(c, f, k);
            cell->c[k] = rounded(c);
            if (k == 0)
                cell_split(&cell->c[0], &cell->low, c);
        }
    }
    _arb_vec_clear(values, QUANTITIES * POINTS);
    _arb_vec_clear(value, QUANTITIES);
}

int reference_build(void)
{
    struct fall fall;
    if (build_series() != 0)
        return 1;
    fall_init(&fall);
    arb_ptr x = _arb_vec_init(POINTS); /* Chebyshev's points cos(pi (2 j + 1)/(2 POINTS)) */
    LOCAL(arb, c);
    for (slong j = 0; j < POINTS; j++) {
        arb_set_si(c, 2 * j + 1);
        arb_div_si(c, c, 2 * (slong)POINTS, 2 * BITS);
        arb_cos_pi(c, c, BITS);
        arb_get_mid_arb(x + j, c);
    }
    for (long double beta = ldexpl(1, FIRST_BINADE); beta < ldexpl(1, LAST_BINADE + 3);) {
        const struct place place = place_of(beta);
        build_cell(place, x, &fall);
        beta = place.middle + place.half;
    }
    h_star_5 = rounded(fall.h_star_5);
    arb_const_log2(c, BITS);
    ln2 = rounded(c);
    _arb_vec_clear(x, POINTS);
    fall_clear(&fall);
    return 0;
}

/* ---- evaluation ---- */

static long double small_value(const struct small *s, long double beta)
{
    long double even = s->even[TERMS - 1], odd = s->odd[TERMS - 1];
    for (int k = TERMS - 2; k > 0; k--) {
        even = even * beta + s->even[k];
        odd = odd * beta + s->odd[k];
    }
    odd = odd * beta + s->odd[0];
    const long double value = s->even[0] + (s->low + (even * beta + odd * sqrtl(beta)));
    return s->power == 0 ? value : value * beta;
}

static long double cell_value(enum quantity quantity, long double beta)
{
    const struct place place = place_of(beta);
    const struct cell *cell = &cells[quantity][place.index];
    const long double x = (beta - place.middle) / place.half;
    long double sum = cell->c[POINTS - 1];
    for (int k = POINTS - 2; k > 0; k--)
        sum = sum * x + cell->c[k];
    return cell->c[0] + (cell->low + sum * x);
}

/* From beta = 8^k b with b in the last binades: what is next to the leading powers and logarithms is too small. */
static long double large_value(enum quantity quantity, long double beta)
{
    int exponent;
    frexpl(beta, &exponent);
    const int k = (exponent - 1 - LAST_BINADE) / 3;
    const long double b = ldexpl(beta, -3 * k), value = cell_value(quantity, b);
    switch (quantity) {
    case EPS_ZERO_FORCE: /* ~ beta^(-5/3) */
        return ldexpl(value, -5 * k);
    case DURATION_ZERO_OVERLAP: /* ~ beta (const + (10/3) ln beta) */
        return ldexpl(value + 10 * k * ln2 * b, 3 * k);
    case MAX_OVERLAP: /* ~ X beta^(-2/3), X = (3/2)^(2/3) */
        return ldexpl(value, -2 * k);
    /* ~ beta^(-2/3) (const + (5/3) ln beta/sqrt(X)), and twice the logarithm at zero force */
    case TIME_OF_MAX_OVERLAP:
        return ldexpl(value + 10 * k * ln2 / 3 * cell_value(MAX_OVERLAP, b), -2 * k);
    case DURATION_ZERO_FORCE:
        return ldexpl(value + 20 * k * ln2 / 3 * cell_value(MAX_OVERLAP, b), -2 * k);
    default:
        return NAN;
    }
}

static long double limit_value(enum quantity quantity)
{
    switch (quantity) {
    case LOSS_ZERO_OVERLAP:
    case LOSS_ZERO_FORCE:
    case LOSS_APPROACH_ONLY:
        return 1;
    case DURATION_ZERO_OVERLAP:
    case DURATION_APPROACH_ONLY:
        return HUGE_VALL;
    default:
        return 0;
    }
}

/* eps = sqrt(4/5) x_max^(5/4); the duration: t_max + tau_0 eps^(-1/5) */
static long double approach_value(enum quantity quantity, long double beta)
{
    if (quantity != DURATION_APPROACH_ONLY && beta < ldexpl(1, FIRST_BINADE))
        return small_value(&series[quantity], beta);
    const long double eps = sqrtl(0.8L) * powl(reference_value(MAX_OVERLAP, beta), 1.25L);
    if (quantity != DURATION_APPROACH_ONLY)
        return quantity == EPS_APPROACH_ONLY ? eps : 1 - eps;
    return reference_value(TIME_OF_MAX_OVERLAP, beta) + reference_value(TIME_OF_MAX_OVERLAP, 0) * powl(eps, -0.2L);
}

long double reference_value(enum quantity quantity, long double beta)
{
    if (!(beta >= 0))
        return NAN;
    if (isinf(beta))
        return limit_value(quantity);
    if (quantity >= QUANTITIES)
        return approach_value(quantity, beta);
    if (beta < ldexpl(1, FIRST_BINADE))
        return small_value(&series[quantity], beta);
    if (beta >= ldexpl(1, CLOSED_BINADE) && (quantity == EPS_ZERO_OVERLAP || quantity == LOSS_ZERO_OVERLAP)) {
        const long double square = beta * beta, eps = h_star_5 / (square * square * beta);
        return quantity == EPS_ZERO_OVERLAP ? eps : 1 - eps;
    }
    if (beta < ldexpl(1, LAST_BINADE + 3))
        return cell_value(quantity, beta);
    return quantity == LOSS_ZERO_FORCE ? 1 - large_value(EPS_ZERO_FORCE, beta) : large_value(quantity, beta);
}

long double reference_slope(enum quantity quantity, long double beta)
{
    const long double half = beta * 0x1p-16L;
    return (reference_value(quantity, beta + half) - reference_value(quantity, beta - half)) / (2 * half);
}
