/* SPDX-License-Identifier: MIT */
#include "reference.h"

#include "ball_value.h"
#include "support/formula.h"
#include "support/local.h"

#include <math.h>
#include <stdbool.h>

enum {
    BITS = 160,
    FEWER_BITS = 128, /* working precision, except in the cell in sqrt(beta) */
    /* below 2^FIRST_BINADE there is one cell, in sqrt(beta) */
    FIRST_BINADE = -3,
    /* above 2^LAST_BINADE the reference scales powers and logarithms of the next three binades */
    LAST_BINADE = 45,
    BINADES = LAST_BINADE + 3 - FIRST_BINADE,
    /* each of the first binades has QUARTERS cells, because singularities in the complex plane are close */
    QUARTERED = 7,
    QUARTERS = 4,
    IN_ROOT = QUARTERED * QUARTERS + BINADES - QUARTERED,
    CELLS,
    POINTS = 27,
    /* for beta >= 2^MANIFOLD_BINADE the end of the unloading comes from the series of the slow manifold */
    MANIFOLD_BINADE = 4,
    CLOSED_BINADE = 3
};

/* The polynomial c[0] + low + c[1] x + ...; low is the rounding error of c[0]. */
static struct cell {
    long double low, c[POINTS];
} cells[ALL_QUANTITIES][CELLS];
static long double h_star_5, ln2;

/* A cell and its range of beta, or, for the first cell, of sqrt(beta). */
struct place {
    int index;
    long double middle, half;
};

/* Returns the place of beta, which is below 2^(LAST_BINADE + 3). */
static struct place place_of(long double beta)
{
    int exponent;
    const long double mantissa = 2 * frexpl(beta, &exponent); /* in [1, 2) */
    const int binade = exponent - 1 - FIRST_BINADE;
    const double root = sqrt(ldexp(1, FIRST_BINADE - 2));
    if (beta < ldexpl(1, FIRST_BINADE))
        return (struct place){IN_ROOT, root, root};
    const int parts = binade < QUARTERED ? QUARTERS : 1, part = (int)((mantissa - 1) * (long double)parts);
    const int first = binade < QUARTERED ? binade * QUARTERS : QUARTERED * QUARTERS + binade - QUARTERED;
    const long double half = ldexpl(1, exponent - 2) / (long double)parts;
    return (struct place){first + part, ldexpl(1, exponent - 1) + (long double)(2 * part + 1) * half, half};
}

/* True for losses, which the cell in sqrt(beta) stores divided by beta. */
static bool is_loss(int quantity)
{
    return quantity == LOSS_ZERO_OVERLAP || quantity == LOSS_ZERO_FORCE || quantity == LOSS_APPROACH_ONLY;
}

/* ---- the motion ----
 *
 * X'' + sqrt(X) X' + mu X^(3/2) = 0, X' = 1 at first contact, by Taylor steps in a special form. With X = w^2, ds = w
 * dsigma and the force divided by -sqrt(X), f = X' + mu X,
 *
 *     dw/dsigma = (f - mu w^2)/2,     df/dsigma = -w (w f - mu f + mu^2 w^2),     ds/dsigma = w
 *
 * so f keeps its relative accuracy while it decays. Only the middles of balls are used, as plain numbers. */

enum { DEGREE = 32, LENGTH };

/* log2 of the relative size of the terms that a step omits. In the cell in sqrt(beta) these terms are smaller, because
 * weak damping makes f large compared with its final value. A motion with a relative transient below 2^JOINED_LOG2
 * counts as joined to the slow manifold. */
static const double STEP_LOG2 = -75, STEP_IN_ROOT_LOG2 = -150, JOINED_LOG2 = -90;

static struct {
    double left_out;
    slong bits; /* working precision */
    arb_t mu, step;
    arb_ptr w, f, s;         /* Taylor coefficients at the current state, LENGTH of each */
    arb_ptr v, square, rest; /* X', w^2, w f - mu f + mu^2 w^2 */
} m;

static double log2_size(const arb_t x)
{
    LOCAL(mag, size);
    arb_get_mag(size, x);
    return mag_is_zero(size) ? -HUGE_VAL : mag_get_d_log2_approx(size);
}

/* Starts at first contact: w = 0, f = 1, s = 0. */
static void motion_start(void)
{
    _arb_vec_zero(m.w, 6 * LENGTH);
    arb_one(m.f);
}

static void convolve(arb_t out, arb_srcptr x, arb_srcptr y, slong n)
{
    arb_approx_dot(out, NULL, 0, x, 1, y + n, -1, n + 1, m.bits);
}

/* Returns log2 of the longest step h for which the last terms |c_n| h^n stay below 2^(m.left_out + scale). */
static double step_log2(arb_srcptr c, double scale)
{
    double least = HUGE_VAL;
    for (slong n = DEGREE - 3; n <= DEGREE; n++)
        least = fmin(least, (m.left_out + scale - log2_size(c + n)) / (double)n);
    return least;
}

/* Expands at the current state and chooses the step. */
static void motion_expand(void)
{
    LOCAL(arb, x);
    for (slong n = 0; n <= DEGREE; n++) {
        convolve(m.square + n, m.w, m.w, n);
        arb_set(m.v + n, m.f + n);
        arb_submul(m.v + n, m.mu, m.square + n, m.bits);
        if (n == DEGREE)
            break;
        convolve(m.rest + n, m.w, m.f, n);
        arb_submul(m.rest + n, m.mu, m.v + n, m.bits);
        convolve(x, m.w, m.rest, n);
        arb_div_si(m.f + n + 1, x, -(n + 1), m.bits);
        arb_div_si(m.w + n + 1, m.v + n, 2 * (n + 1), m.bits);
        arb_div_si(m.s + n + 1, m.w + n, n + 1, m.bits);
    }
    /* log2 of the sizes of f and w. Near a zero of f, its term mu^2 w^2 is the size; near a zero of w, the speed is. */
    const double scale_f = fmax(log2_size(m.f), log2_size(m.square) + 2 * log2_size(m.mu));
    const double scale_w = fmax(log2_size(m.w), log2_size(m.v));
    arb_set_d(m.step, exp2(fmin(step_log2(m.f, scale_f), step_log2(m.w, scale_w))));
}

static void motion_value(arb_t value, arb_srcptr component, const arb_t sigma)
{
    LOCAL(arb, x);
    _arb_poly_evaluate_horner(x, component, LENGTH, sigma, m.bits);
    arb_get_mid_arb(value, x);
}

static void motion_advance(void)
{
    arb_ptr const state[] = {m.w, m.f, m.s};
    for (int i = 0; i < 3; i++)
        motion_value(state[i], state[i], m.step);
}

static bool negative_at_end(arb_srcptr component)
{
    LOCAL(arb, x);
    motion_value(x, component, m.step);
    return arb_is_negative(x);
}

/* Finds the zero of a component that is positive at 0 and negative at the end of the step, by halvings, then Newton
 * steps. */
static void motion_zero(arb_t sigma, arb_srcptr component)
{
    enum { HALVINGS = 12, NEWTON = 5 }; /* halvings give 12 bits, and each Newton step doubles their number */
    LOCAL(arb, low, high, middle, y, slope);
    arb_set(high, m.step);
    for (int i = 0; i < HALVINGS; i++) {
        LET(middle, m.bits, "(low + high)/2", low, high);
        motion_value(y, component, middle);
        arb_set(arb_is_positive(y) ? low : high, middle);
    }
    for (int i = 0; i < NEWTON; i++) {
        _arb_poly_evaluate2_horner(y, slope, component, LENGTH, high, m.bits);
        LET(high, m.bits, "high - y/slope", high, y, slope);
        arb_get_mid_arb(high, high);
    }
    arb_set(sigma, high);
}

/* ---- the slow manifold ----
 *
 * Every strongly damped unloading joins it. With z = X/mu^2, t' = mu s, r = z^(-1/2) = mu/w and p = -dz/dt'/z it is
 * p = P(r), a divergent series, used here for r <= 1/FALL_DEGREE. */
enum { FALL_DEGREE = 40, FALL_LENGTH };

static arb_ptr fall_p;      /* coefficients of P */
static arb_ptr fall_series; /* t' from r to the end = constant - 2 ln r - sum of series[n] r^n, n >= 1 */
static arb_t fall_constant;

static void fall_time(arb_t time, const arb_t r)
{
    LOCAL(arb, x);
    _arb_poly_evaluate(x, fall_series, FALL_LENGTH, r, 2 * BITS);
    LET(time, 2 * BITS, "fall_constant - 2*log(r) - x", fall_constant, r, x);
    arb_get_mid_arb(time, time);
}

/* Computes P(r) at the current state. */
static void fall_rate(arb_t p, arb_t r)
{
    arb_div(r, m.mu, m.w, BITS);
    arb_get_mid_arb(r, r);
    _arb_poly_evaluate(p, fall_p, FALL_LENGTH, r, 2 * BITS);
}

/* Computes the formal solution p of 1 - p + r p^2 - r^2 p p'/2 = 0, and the integral of 2/(r p). Then follows the
 * motion from the manifold at r = 1/FALL_DEGREE to the end, with mu = 1 and X = z. The end speed -dz/dt' is the limit
 * h*^5 of beta^5 eps. */
static void fall_build(arb_t end_speed)
{
    LOCAL(arb, r, p);
    arb_one(fall_p);
    for (slong n = 1; n <= FALL_DEGREE; n++) {
        arb_dot(fall_p + n, NULL, 0, fall_p, 1, fall_p + n - 1, -1, n, 2 * BITS);
        arb_mul_si(fall_p + n, fall_p + n, 5 - n, 2 * BITS);
        arb_mul_2exp_si(fall_p + n, fall_p + n, -2);
    }
    _arb_poly_inv_series(fall_series, fall_p, FALL_LENGTH, FALL_LENGTH, 2 * BITS);
    arb_zero(fall_series);
    for (slong n = 1; n <= FALL_DEGREE; n++) {
        arb_mul_2exp_si(fall_series + n, fall_series + n, 1);
        arb_div_si(fall_series + n, fall_series + n, n, 2 * BITS);
    }
    m.left_out = STEP_LOG2;
    m.bits = FEWER_BITS;
    arb_one(m.mu);
    motion_start();
    arb_set_si(m.w, FALL_DEGREE);
    fall_rate(p, r);
    LET(m.f, BITS, "(1 - p)*m.w^2", p, m.w);
    arb_get_mid_arb(m.f, m.f);
    for (motion_expand(); !negative_at_end(m.w); motion_expand())
        motion_advance();
    motion_zero(m.step, m.w);
    motion_advance();
    arb_neg(end_speed, m.f);
    fall_time(p, r);
    arb_sub(fall_constant, m.s, p, BITS);
    arb_get_mid_arb(fall_constant, fall_constant);
}

/* True if the current state has joined the manifold: p - 1 = -f/(mu w^2). */
static bool fall_joined(void)
{
    LOCAL(arb, r, p);
    fall_rate(p, r);
    LET(p, BITS, "p - 1 + m.f/(m.mu*m.w^2)", p, m.f, m.mu, m.w);
    arb_get_mid_arb(p, p);
    return log2_size(r) <= -log2(FALL_DEGREE) && log2_size(p) < JOINED_LOG2;
}

/* ---- tables ---- */

/* Splits the first coefficient of a polynomial into two parts. */
static void first_split(long double *c, long double *low, const arb_t x)
{
    const double high = arf_get_d(arb_midref(x), ARF_RND_NEAR);
    LOCAL(arb, less);
    LET(less, BITS, "x - high", x, high);
    *c = high;
    *low = ball_value(less);
}

/* Computes the quantities at one beta > 0, except DURATION_APPROACH_ONLY. Also omits eps at zero overlap if the motion
 * ends on the slow manifold. */
static void collide(arb_ptr value, const arb_t beta)
{
    static const enum quantity scaled[] = {DURATION_ZERO_OVERLAP, DURATION_ZERO_FORCE, MAX_OVERLAP,
                                           TIME_OF_MAX_OVERLAP};
    enum { NOTHING, TURNED, RELEASED } seen = NOTHING;
    LOCAL(arb, x);
    LET(m.mu, 2 * BITS, "beta^(-5/3)", beta);
    arb_get_mid_arb(m.mu, m.mu);
    const bool manifold = arf_cmpabs_2exp_si(arb_midref(beta), MANIFOLD_BINADE) >= 0;
    bool done = false;
    for (motion_start(); !done; motion_advance()) {
        motion_expand();
        if (seen == NOTHING && negative_at_end(m.v)) {
            seen = TURNED;
            motion_zero(x, m.v);
            motion_value(value + TIME_OF_MAX_OVERLAP, m.s, x);
            motion_value(value + MAX_OVERLAP, m.square, x);
        } else if (manifold && seen == RELEASED && fall_joined()) {
            done = true;
            arb_div(x, m.mu, m.w, BITS);
            fall_time(x, x);
            LET(value + DURATION_ZERO_OVERLAP, BITS, "x/m.mu + m.s", x, m.mu, m.s);
        } else if (negative_at_end(m.w)) {
            done = true;
            motion_zero(m.step, m.w);
            motion_value(value + DURATION_ZERO_OVERLAP, m.s, m.step);
            motion_value(x, m.f, m.step);
            arb_neg(value + EPS_ZERO_OVERLAP, x);
        }
        if (seen == TURNED && negative_at_end(m.f)) {
            seen = RELEASED;
            motion_zero(x, m.f);
            motion_value(value + DURATION_ZERO_FORCE, m.s, x);
            motion_value(x, m.v, x);
            arb_neg(value + EPS_ZERO_FORCE, x);
        }
    }
    LET(x, 2 * BITS, "beta^(-2/3)", beta);
    for (size_t i = 0; i < sizeof scaled / sizeof *scaled; i++)
        arb_mul(value + scaled[i], value + scaled[i], x, BITS);
    arb_set(x, value + MAX_OVERLAP);
    LET(value + EPS_APPROACH_ONLY, BITS, "sqrt(4/5)*x^(5/4)", x);
    for (int eps = 0; eps < ALL_QUANTITIES; eps++)
        if (is_loss(eps + LOSS_OF_EPS)) {
            arb_sub_si(x, value + eps, 1, BITS);
            arb_neg(value + eps + LOSS_OF_EPS, x);
        }
}

/* Computes the polynomials of a cell through the values at x_j of [-1, 1]. */
static void build_cell(struct place place, arb_srcptr x)
{
    LOCAL_VECTOR(values, ALL_QUANTITIES * POINTS);
    LOCAL_VECTOR(value, ALL_QUANTITIES);
    LOCAL(arb, beta, c);
    LOCAL(arb_poly, g);
    const double middle = (double)place.middle, half = (double)place.half;
    m.left_out = place.index == IN_ROOT ? STEP_IN_ROOT_LOG2 : STEP_LOG2;
    m.bits = place.index == IN_ROOT ? BITS : FEWER_BITS;
    for (slong j = 0; j < POINTS; j++) {
        arb_srcptr at = x + j;
        LET(beta, BITS, "middle + half*at", middle, half, at);
        if (place.index == IN_ROOT)
            arb_mul(beta, beta, beta, BITS);
        arb_get_mid_arb(beta, beta);
        collide(value, beta);
        for (int q = 0; q < ALL_QUANTITIES; q++)
            if (place.index == IN_ROOT && is_loss(q))
                arb_div(values + q * POINTS + j, value + q, beta, 2 * BITS);
            else
                arb_set(values + q * POINTS + j, value + q);
    }
    for (int q = 0; q < ALL_QUANTITIES; q++) {
        struct cell *cell = &cells[q][place.index];
        arb_poly_interpolate_barycentric(g, x, values + q * POINTS, POINTS, 2 * BITS);
        for (slong k = 0; k < POINTS; k++) {
            arb_poly_get_coeff_arb(c, g, k);
            cell->c[k] = ball_value(c);
            if (k == 0)
                first_split(&cell->c[0], &cell->low, c);
        }
    }
}

void reference_build(void)
{
    LOCAL_VECTOR(x, POINTS); /* Chebyshev points cos(pi (2 j + 1)/(2 POINTS)) */
    LOCAL_VECTOR(of_motion, 6 * LENGTH);
    LOCAL_VECTOR(of_fall, 2 * FALL_LENGTH);
    LOCAL(arb, c);
    arb_ptr *const component[] = {&m.w, &m.f, &m.s, &m.v, &m.square, &m.rest};
    for (int i = 0; i < 6; i++)
        *component[i] = of_motion + i * LENGTH;
    fall_p = of_fall;
    fall_series = of_fall + FALL_LENGTH;
    FOR_ALL(arb, init, m.mu, m.step, fall_constant);
    fall_build(c);
    h_star_5 = ball_value(c);
    for (slong j = 0; j < POINTS; j++) {
        const slong odd = 2 * j + 1, points = POINTS;
        LET(c, 2 * BITS, "odd/(2*points)", odd, points);
        arb_cos_pi(c, c, BITS);
        arb_get_mid_arb(x + j, c);
    }
    build_cell(place_of(0), x);
    for (long double beta = ldexpl(1, FIRST_BINADE); beta < ldexpl(1, LAST_BINADE + 3);) {
        const struct place place = place_of(beta);
        build_cell(place, x);
        beta = place.middle + place.half;
    }
    arb_const_log2(c, BITS);
    ln2 = ball_value(c);
    FOR_ALL(arb, clear, m.mu, m.step, fall_constant);
}

/* ---- evaluation ---- */

static long double cell_value(enum quantity quantity, long double beta)
{
    const struct place place = place_of(beta);
    const struct cell *cell = &cells[quantity][place.index];
    const bool in_root = place.index == IN_ROOT;
    const long double x = ((in_root ? sqrtl(beta) : beta) - place.middle) / place.half;
    long double sum = cell->c[POINTS - 1];
    for (int k = POINTS - 2; k > 0; k--)
        sum = sum * x + cell->c[k];
    return (cell->c[0] + (cell->low + sum * x)) * (in_root && is_loss((int)quantity) ? beta : 1);
}

/* The value of a quantity at beta = 8^k b, where b is in the last binades, is 2^(power k) (value at b + log k ln(2) x).
 * x is b for the duration at zero overlap, otherwise the largest overlap at b. With X = (3/2)^(2/3), the leading terms
 * are const beta^(-5/3) for eps at zero force, beta (const + (10/3) ln(beta)) for the duration at zero overlap, and X
 * beta^(-2/3) for the largest overlap. The times of the largest overlap (c = 5/3) and of zero force (c = 10/3) are
 * beta^(-2/3) (const + c ln(beta)/sqrt(X)). Later terms are negligible. */
static const struct {
    int power, thirds; /* log = thirds/3 */
    long double limit; /* at infinity */
} large[ALL_QUANTITIES] = {
    [EPS_ZERO_FORCE] = {-5, 0, 0},
    [DURATION_ZERO_OVERLAP] = {3, 30, HUGE_VALL},
    [MAX_OVERLAP] = {-2, 0, 0},
    [TIME_OF_MAX_OVERLAP] = {-2, 10, 0},
    [DURATION_ZERO_FORCE] = {-2, 20, 0},
    [LOSS_ZERO_OVERLAP] = {0, 0, 1},
    [LOSS_ZERO_FORCE] = {0, 0, 1},
    [LOSS_APPROACH_ONLY] = {0, 0, 1},
    [DURATION_APPROACH_ONLY] = {0, 0, HUGE_VALL},
};

static long double large_value(enum quantity quantity, long double beta)
{
    int exponent;
    frexpl(beta, &exponent);
    const int k = (exponent - 1 - LAST_BINADE) / 3;
    const long double b = ldexpl(beta, -3 * k), x = quantity == DURATION_ZERO_OVERLAP ? b : cell_value(MAX_OVERLAP, b);
    return ldexpl(cell_value(quantity, b) + large[quantity].thirds * k * ln2 / 3 * x, large[quantity].power * k);
}

/* Returns eps = sqrt(4/5) x_max^(5/4), or the duration, t_max + tau_0 eps^(-1/5). */
static long double approach_value(enum quantity quantity, long double beta)
{
    if (quantity != DURATION_APPROACH_ONLY && beta < ldexpl(1, FIRST_BINADE))
        return cell_value(quantity, beta);
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
        return large[quantity].limit;
    if (beta == 0 && (quantity == EPS_ZERO_OVERLAP || quantity == EPS_ZERO_FORCE || quantity == EPS_APPROACH_ONLY))
        return 1;
    if (quantity >= QUANTITIES)
        return approach_value(quantity, beta);
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
