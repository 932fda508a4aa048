/* SPDX-License-Identifier: MIT */
#include "motion.h"
#include "support/formula.h"
#include "support/local.h"

#include <math.h>

/* Relative size of the terms that a step leaves out, and of what is left of the past on the slow manifold. */
static const double STEP_LOG2 = -90, JOINED_LOG2 = -90;

static double log2_size(const arb_t x)
{
    LOCAL(mag, m);
    arb_get_mag(m, x);
    return mag_is_zero(m) ? -HUGE_VAL : mag_get_d_log2_approx(m);
}

void motion_init(struct motion *m, const arb_t mu)
{
    arb_init(m->mu);
    arb_init(m->step);
    arb_get_mid_arb(m->mu, mu);
    arb_ptr *const component[] = {&m->w, &m->f, &m->s, &m->v, &m->square, &m->rest};
    arb_ptr all = _arb_vec_init(6 * (MOTION_DEGREE + 1));
    for (int i = 0; i < 6; i++)
        *component[i] = all + i * (MOTION_DEGREE + 1);
    arb_one(m->f);
}

void motion_clear(struct motion *m)
{
    arb_clear(m->mu);
    arb_clear(m->step);
    _arb_vec_clear(m->w, 6 * (MOTION_DEGREE + 1));
}

static void convolve(arb_t out, arb_srcptr f, arb_srcptr g, slong n)
{
    arb_approx_dot(out, NULL, 0, f, 1, g + n, -1, n + 1, MOTION_BITS);
}

/* log2 of the longest step at which coefficients of this size, relative to scale, stay below STEP_LOG2. */
static double step_log2(arb_srcptr c, double scale)
{
    double step = HUGE_VAL;
    for (slong n = MOTION_DEGREE - 3; n <= MOTION_DEGREE; n++)
        step = fmin(step, (STEP_LOG2 + scale - log2_size(c + n)) / (double)n);
    return step;
}

void motion_expand(struct motion *m)
{
    LOCAL(arb, x);
    for (slong n = 0; n <= MOTION_DEGREE; n++) {
        /* v = f - mu w^2,  rest = w f - mu v */
        convolve(m->square + n, m->w, m->w, n);
        arb_mul(x, m->mu, m->square + n, MOTION_BITS);
        arb_sub(m->v + n, m->f + n, x, MOTION_BITS);
        arb_get_mid_arb(m->v + n, m->v + n);
        if (n == MOTION_DEGREE)
            break;
        convolve(m->rest + n, m->w, m->f, n);
        arb_submul(m->rest + n, m->mu, m->v + n, MOTION_BITS);
        arb_get_mid_arb(m->rest + n, m->rest + n);
        convolve(x, m->w, m->rest, n);
        arb_div_si(m->f + n + 1, x, -(n + 1), MOTION_BITS);
        arb_get_mid_arb(m->f + n + 1, m->f + n + 1);
        arb_div_si(m->w + n + 1, m->v + n, 2 * (n + 1), MOTION_BITS);
        arb_get_mid_arb(m->w + n + 1, m->w + n + 1);
        arb_div_si(m->s + n + 1, m->w + n, n + 1, MOTION_BITS);
        arb_get_mid_arb(m->s + n + 1, m->s + n + 1);
    }
    /* f passes zero where mu^2 w^2 takes over, w where the speed does */
    const double scale_f = fmax(log2_size(m->f), log2_size(m->square) + 2 * log2_size(m->mu));
    const double scale_w = fmax(log2_size(m->w), log2_size(m->v));
    const double step = fmin(step_log2(m->f, scale_f), step_log2(m->w, scale_w));
    arb_set_d(m->step, exp2(step));
}

void motion_value(arb_t value, arb_srcptr component, const arb_t sigma)
{
    LOCAL(arb, sum);
    arb_set(sum, component + MOTION_DEGREE);
    for (slong n = MOTION_DEGREE - 1; n >= 0; n--) {
        arb_mul(sum, sum, sigma, MOTION_BITS);
        arb_add(sum, sum, component + n, MOTION_BITS);
        mag_zero(arb_radref(sum));
    }
    arb_swap(value, sum);
}

void motion_advance(struct motion *m, const arb_t sigma)
{
    motion_value(m->w, m->w, sigma);
    motion_value(m->f, m->f, sigma);
    motion_value(m->s, m->s, sigma);
}

/* Secants between two points of opposite sign; the one that stays behind counts half (Illinois). */
void motion_zero(arb_t sigma, arb_srcptr component, const arb_t end)
{
    LOCAL(arb, low, high, f_low, f_high, x, f);
    arb_set(high, end);
    motion_value(f_low, component, low);
    motion_value(f_high, component, high);
    const double enough = log2_size(f_low) - (double)MOTION_BITS;
    int side = 0;
    for (int i = 0; i < 200; i++) {
        arb_sub(f, f_low, f_high, MOTION_BITS);
        arb_sub(x, high, low, MOTION_BITS);
        arb_mul(x, x, f_low, MOTION_BITS);
        arb_div(x, x, f, MOTION_BITS);
        arb_add(x, x, low, MOTION_BITS);
        mag_zero(arb_radref(x));
        motion_value(f, component, x);
        if (log2_size(f) < enough)
            break;
        const int now = arb_is_positive(f) ? 1 : -1;
        arb_set(now > 0 ? low : high, x);
        arb_set(now > 0 ? f_low : f_high, f);
        if (now == side)
            arb_mul_2exp_si(now > 0 ? f_high : f_low, now > 0 ? f_high : f_low, -1);
        side = now;
    }
    arb_set(sigma, x);
}

/* The formal solution of 1 - p + r p^2 - r^2 p p'/2 = 0 and of 2/(r p) dr. */
static void fall_series(struct fall *fall)
{
    LOCAL(arb_poly, p, inverse);
    LOCAL(arb, c);
    arb_one(fall->p);
    for (slong n = 1; n <= FALL_DEGREE; n++) {
        arb_dot(c, NULL, 0, fall->p, 1, fall->p + n - 1, -1, n, 2 * MOTION_BITS);
        arb_mul_si(c, c, 5 - n, 2 * MOTION_BITS);
        arb_mul_2exp_si(fall->p + n, c, -2);
    }
    for (slong n = 0; n <= FALL_DEGREE; n++)
        arb_poly_set_coeff_arb(p, n, fall->p + n);
    arb_poly_inv_series(inverse, p, FALL_DEGREE + 1, 2 * MOTION_BITS);
    for (slong n = 1; n <= FALL_DEGREE; n++) {
        arb_poly_get_coeff_arb(c, inverse, n);
        arb_mul_2exp_si(c, c, 1);
        arb_div_si(fall->time + n, c, n, 2 * MOTION_BITS);
    }
}

/* t' without the constant. */
static void fall_time_series(arb_t time, const struct fall *fall, const arb_t r)
{
    LOCAL(arb, x);
    _arb_poly_evaluate(x, fall->time, FALL_DEGREE + 1, r, 2 * MOTION_BITS);
    LET(time, 2 * MOTION_BITS, "-2*log(r) - x", r, x);
    arb_get_mid_arb(time, time);
}

void fall_init(struct fall *fall)
{
    struct motion m;
    LOCAL(arb, r, p);
    fall->p = _arb_vec_init(FALL_DEGREE + 1);
    fall->time = _arb_vec_init(FALL_DEGREE + 1);
    arb_init(fall->constant);
    arb_init(fall->h_star_5);
    fall_series(fall);

    /* from the manifold at r = 1/FALL_DEGREE to the end: mu = 1, X = z */
    arb_one(p);
    motion_init(&m, p);
    arb_set_si(m.w, FALL_DEGREE);
    arb_inv(r, m.w, MOTION_BITS);
    _arb_poly_evaluate(p, fall->p, FALL_DEGREE + 1, r, 2 * MOTION_BITS);
    LET(m.f, MOTION_BITS, "(1 - p)*m.w^2", p, m.w);
    arb_get_mid_arb(m.f, m.f);
    for (;;) {
        motion_expand(&m);
        motion_value(p, m.w, m.step);
        if (!arb_is_positive(p))
            break;
        motion_advance(&m, m.step);
    }
    motion_zero(p, m.w, m.step);
    motion_value(fall->h_star_5, m.f, p);
    arb_neg(fall->h_star_5, fall->h_star_5);
    motion_value(fall->constant, m.s, p);
    fall_time_series(p, fall, r);
    arb_sub(fall->constant, fall->constant, p, MOTION_BITS);
    arb_get_mid_arb(fall->constant, fall->constant);
    motion_clear(&m);
}

void fall_clear(struct fall *fall)
{
    _arb_vec_clear(fall->p, FALL_DEGREE + 1);
    _arb_vec_clear(fall->time, FALL_DEGREE + 1);
    arb_clear(fall->constant);
    arb_clear(fall->h_star_5);
}

bool fall_joined(const struct fall *fall, const struct motion *m)
{
    LOCAL(arb, r, p, x);
    arb_div(r, m->mu, m->w, MOTION_BITS);
    arb_mul_si(x, r, FALL_DEGREE, MOTION_BITS);
    bool joined = log2_size(x) <= 0;
    if (joined) {
        /* p - 1 = -f/(mu w^2) */
        _arb_poly_evaluate(p, fall->p, FALL_DEGREE + 1, r, MOTION_BITS);
        LET(p, MOTION_BITS, "p - 1 + m->f/(m->mu*m->w^2)", p, m->f, m->mu, m->w);
        arb_get_mid_arb(p, p);
        joined = log2_size(p) < JOINED_LOG2;
    }
    return joined;
}

void fall_time(arb_t time, const struct fall *fall, const struct motion *m)
{
    LOCAL(arb, r);
    arb_div(r, m->mu, m->w, MOTION_BITS);
    arb_get_mid_arb(r, r);
    fall_time_series(time, fall, r);
    arb_add(time, time, fall->constant, MOTION_BITS);
}
