/* SPDX-License-Identifier: MIT */
#include "pumped.h"

#include <math.h>
#include <stdbool.h>

#include "enclosure/collision.h"

/* x = w^2, dt = w dsigma: w' = v/2, v' = -w^2 (beta v + w^2), t' = w. The state and its Taylor coefficients. */
struct loading {
    slong degree, prec;
    arb_t step;
    arb_ptr w, v, t, square, force;
};

static void loading_init(struct loading *m, slong prec)
{
    m->prec = prec;
    m->degree = prec / 4 + 8;
    arb_init(m->step);
    m->w = _arb_vec_init(m->degree + 1);
    m->v = _arb_vec_init(m->degree + 1);
    m->t = _arb_vec_init(m->degree + 1);
    m->square = _arb_vec_init(m->degree + 1);
    m->force = _arb_vec_init(m->degree + 1);
    arb_one(m->v);
}

static void loading_clear(struct loading *m)
{
    arb_clear(m->step);
    _arb_vec_clear(m->w, m->degree + 1);
    _arb_vec_clear(m->v, m->degree + 1);
    _arb_vec_clear(m->t, m->degree + 1);
    _arb_vec_clear(m->square, m->degree + 1);
    _arb_vec_clear(m->force, m->degree + 1);
}

static double size(const arb_t x)
{
    return log(fabs(arf_get_d(arb_midref(x), ARF_RND_NEAR)));
}

/* Coefficients at the state in hand, and a step that their decay allows. Midpoints only. */
static void expand(struct loading *m, const arb_t beta)
{
    arb_t c;
    arb_init(c);
    for (slong k = 0; k < m->degree; k++) {
        arb_dot(m->square + k, NULL, 0, m->w, 1, m->w + k, -1, k + 1, m->prec);
        arb_mul(m->force + k, m->v + k, beta, m->prec);
        arb_add(m->force + k, m->force + k, m->square + k, m->prec);
        arb_dot(c, NULL, 0, m->square, 1, m->force + k, -1, k + 1, m->prec);
        arb_div_si(m->v + k + 1, c, -(k + 1), m->prec);
        arb_div_ui(m->w + k + 1, m->v + k, 2 * (ulong)(k + 1), m->prec);
        arb_div_ui(m->t + k + 1, m->w + k, (ulong)(k + 1), m->prec);
        mag_zero(arb_radref(m->v + k + 1));
        mag_zero(arb_radref(m->w + k + 1));
        mag_zero(arb_radref(m->t + k + 1));
    }
    /* the last coefficients that count: 2^-prec of the first ones after the step */
    double log_step = HUGE_VAL;
    for (slong k = m->degree - 2; k <= m->degree; k++) {
        const double bits = -0.6931 * (double)m->prec;
        if (!arb_is_zero(m->v + k))
            log_step = fmin(log_step, (bits - size(m->v + k)) / (double)k);
        if (!arb_is_zero(m->w + k))
            log_step = fmin(log_step, (bits - size(m->w + k)) / (double)k);
    }
    /* exp() of anything, as a double: steps are between 1e-6 and 1e3 */
    arb_set_d(m->step, exp(log_step));
    arb_clear(c);
}

static void value_at(arb_t y, arb_srcptr f, const struct loading *m, const arb_t sigma)
{
    _arb_poly_evaluate(y, f, m->degree, sigma, m->prec);
    mag_zero(arb_radref(y));
}

static void advance(struct loading *m)
{
    arb_t w, v, t;
    arb_init(w);
    arb_init(v);
    arb_init(t);
    value_at(w, m->w, m, m->step);
    value_at(v, m->v, m, m->step);
    value_at(t, m->t, m, m->step);
    arb_swap(m->w, w);
    arb_swap(m->v, v);
    arb_swap(m->t, t);
    arb_clear(w);
    arb_clear(v);
    arb_clear(t);
}

/* sigma in [0, step] with f(sigma) = target, f monotonic: bisection to a tenth, then Newton's method */
static void root(arb_t sigma, arb_srcptr f, const struct loading *m, const arb_t target)
{
    arb_t low, high, y, slope, end;
    arb_init(low);
    arb_init(high);
    arb_init(y);
    arb_init(slope);
    arb_init(end);
    arb_set(high, m->step);
    value_at(end, f, m, high);
    arb_sub(end, end, target, m->prec);
    for (int i = 0; i < 12; i++) {
        arb_add(sigma, low, high, m->prec);
        arb_mul_2exp_si(sigma, sigma, -1);
        value_at(y, f, m, sigma);
        arb_sub(y, y, target, m->prec);
        arb_swap(arf_sgn(arb_midref(y)) == arf_sgn(arb_midref(end)) ? high : low, sigma);
    }
    arb_set(sigma, low);
    for (int i = 0; i < 12; i++) {
        _arb_poly_evaluate2(y, slope, f, m->degree, sigma, m->prec);
        arb_sub(y, y, target, m->prec);
        arb_div(y, y, slope, m->prec);
        arb_sub(sigma, sigma, y, m->prec);
        mag_zero(arb_radref(sigma));
    }
    arb_clear(low);
    arb_clear(high);
    arb_clear(y);
    arb_clear(slope);
    arb_clear(end);
}

/* Steps until a component minus `target` changes its sign within the next one. */
static void approach(struct loading *m, arb_srcptr component, const arb_t beta, const arb_t target, bool rising)
{
    arb_t y;
    arb_init(y);
    for (;;) {
        expand(m, beta);
        value_at(y, component, m, m->step);
        const int side = arf_cmp(arb_midref(y), arb_midref(target));
        if (rising ? side >= 0 : side <= 0)
            break;
        advance(m);
    }
    arb_clear(y);
}

void pumped_max_overlap(arb_t x, const arb_t beta, slong prec)
{
    struct loading m;
    arb_t zero;
    arb_init(zero);
    loading_init(&m, prec);
    approach(&m, m.v, beta, zero, false);
    root(x, m.v, &m, zero);
    value_at(x, m.w, &m, x);
    arb_sqr(x, x, prec);
    loading_clear(&m);
    arb_clear(zero);
}

void pumped_position(arb_t x, const arb_t beta, const arb_t t, slong prec)
{
    struct loading m;
    loading_init(&m, prec);
    approach(&m, m.t, beta, t, true);
    root(x, m.t, &m, t);
    value_at(x, m.w, &m, x);
    arb_sqr(x, x, prec);
    loading_clear(&m);
}

/* ln(beta Y(beta)^(1/4)) */
static void log_psi(arb_t y, const arb_t h, const arb_t damping, slong prec)
{
    arb_t x;
    arb_init(x);
    pumped_max_overlap(y, damping, prec);
    arb_log(y, y, prec);
    arb_mul_2exp_si(y, y, -2);
    arb_log(x, h, prec);
    arb_add(y, y, x, prec);
    mag_zero(arb_radref(y));
    arb_clear(x);
}

/* The zero of ln psi(h* - exp(-u)) - ln psi at -beta: increasing, and smooth in u. A bracket, then secants that are
 * not let out of it. */
int pumped_eps(arb_t eps, arb_t h, double beta)
{
    const double lost = 2.29 * pow(beta, 5.0 / 3) + 1; /* -ln(h* - h), about */
    const slong prec = 100 + (slong)(1.5 * lost);
    arb_t h_star, goal, u[3], f[3], x;
    int failed = 1, last = -1;
    arb_init(h_star);
    arb_init(goal);
    arb_init(x);
    for (int i = 0; i < 3; i++) {
        arb_init(u[i]);
        arb_init(f[i]);
    }
    collision_h_star(h_star, prec + 20);
    mag_zero(arb_radref(h_star));
    arb_set_d(x, beta);
    log_psi(goal, x, x, prec);
    arb_set_d(u[0], -0.3); /* h = 0.04 */
    arb_set_d(u[1], lost + 4);
    for (int i = -2; i < 60 && failed; i++) {
        const int at = i < 0 ? i + 2 : 2;
        if (i >= 0) {
            /* secant; every fourth time the middle, so that both ends move */
            if (i % 4 == 3) {
                arb_add(u[2], u[0], u[1], prec);
                arb_mul_2exp_si(u[2], u[2], -1);
            } else {
                arb_sub(x, u[1], u[0], prec);
                arb_mul(x, x, f[0], prec);
                arb_sub(u[2], f[1], f[0], prec);
                arb_div(x, x, u[2], prec);
                arb_sub(u[2], u[0], x, prec);
            }
            mag_zero(arb_radref(u[2]));
        }
        arb_neg(h, u[at]);
        arb_exp(h, h, prec);
        arb_sub(h, h_star, h, prec);
        mag_zero(arb_radref(h));
        arb_neg(x, h);
        log_psi(f[at], h, x, prec);
        arb_sub(f[at], f[at], goal, prec);
        if (at == 2) {
            const int side = arf_sgn(arb_midref(f[2])) > 0;
            failed = arf_cmpabs_2exp_si(arb_midref(f[2]), -75) > 0;
            /* an end that stays twice counts for less (Illinois) */
            if (side == last)
                arb_mul_2exp_si(f[1 - side], f[1 - side], -1);
            last = side;
            arb_swap(u[side], u[2]);
            arb_swap(f[side], f[2]);
        }
        if (i == -1 && !(arf_sgn(arb_midref(f[0])) < 0 && arf_sgn(arb_midref(f[1])) > 0))
            break;
    }
    arb_set_d(x, beta);
    arb_div(eps, h, x, prec);
    arb_pow_ui(eps, eps, 5, prec);
    arb_clear(h_star);
    arb_clear(goal);
    arb_clear(x);
    for (int i = 0; i < 3; i++) {
        arb_clear(u[i]);
        arb_clear(f[i]);
    }
    return failed;
}
