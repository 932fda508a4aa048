/* SPDX-License-Identifier: MIT */
#include "enclosure/far_motion.h"

#include "enclosure/slow_manifold.h"

/* Scaled as in (8.1): X is the overlap, w = dX/ds, Y = sqrt(X), zeta = (2/3) X^(3/2). S = mu X P(r), r = mu/Y, is the
 * slow manifold without its minus sign, f = w + S the distance from it. */
enum {
    BITS = EXPANSION_BITS,
    MANIFOLD_ORDER = 4 /* of P */
};

/* P, dS/dX and what the manifold's equation lacks from r^MANIFOLD_ORDER on, in r */
struct manifold {
    arb_poly_t p, slope, lack;
};

/* What the two parts of the motion have in common */
struct motion {
    struct manifold manifold;
    struct expansion_domain start, fall, event; /* (a, b) = (eta, -), (mu, tau), (mu, mu ln(1/mu)) */
    arb_t limit, root_of_limit;                 /* X* = (3/2)^(2/3) and its root */
    struct expansion first_distance;            /* f where zeta = 1/2, in mu */
    struct expansion first_time;                /* s there */
    struct expansion zeta;                      /* of the fall, in mu, tau, e */
    struct expansion overlap, manifold_speed;   /* X, S/mu */
    struct expansion force_speed;               /* (S - mu X)/mu^2 */
    struct expansion time, time_per_l;          /* s = time + l time_per_l */
    mag_t defect;                               /* f differs from f_0 exp(-l) by mu^(MANIFOLD_ORDER + 2) defect */
    bool proved;
};

/* ---- the slow manifold ---- */

/* y = x - x' r/degree: the coefficients times 1 - k/degree */
static void less_slope(arb_poly_t y, const arb_poly_t x, ulong degree)
{
    LOCAL(arb_poly, term);
    LOCAL(arb, factor);
    arb_set_ui(factor, degree);
    arb_poly_derivative(term, x, BITS);
    arb_poly_shift_left(term, term, 1);
    arb_poly_scalar_div(term, term, factor, BITS);
    arb_poly_sub(y, x, term, BITS);
}

/* Order r^(k+1) of the manifold's equation is p_(k+1) = (1 - k/4) (p^2)_k; from MANIFOLD_ORDER on the right remains. */
static void manifold_init(struct manifold *m)
{
    FOR_ALL(arb_poly, init, m->p, m->slope, m->lack);
    slow_manifold_formal(m->p, &law_sphere, MANIFOLD_ORDER, BITS);
    less_slope(m->slope, m->p, 2);
    arb_poly_mul(m->lack, m->p, m->p, BITS);
    less_slope(m->lack, m->lack, 4);
    arb_poly_shift_right(m->lack, m->lack, MANIFOLD_ORDER);
}

static void manifold_clear(struct manifold *m)
{
    FOR_ALL(arb_poly, clear, m->p, m->slope, m->lack);
}

/* sum of c_k r^(k - first), k >= first */
static void manifold_sum(struct expansion *y, const arb_poly_t c, slong first, const struct expansion *r)
{
    LOCAL_EXPANSION(y->domain, sum);
    for (slong k = arb_poly_degree(c); k >= first; k--) {
        expansion_multiply(sum, sum, r);
        expansion_add_number(sum, 0, 0, arb_poly_get_coeff_ptr(c, k));
    }
    expansion_set(y, sum);
}

/* ---- the start: w as a function of zeta, 0 <= zeta <= 1/2 ---- */

/* 1 - z/2 */
static void set_line(arb_poly_t line)
{
    LOCAL(arb, half);
    arb_set_d(half, -0.5);
    arb_poly_set_coeff_si(line, 0, 1);
    arb_poly_set_coeff_arb(line, 1, half);
}

/* (1 - z/2)^(p/q), |p/q| <= 1. The coefficient of z^n is 2^-n at most. */
static void half_power(struct expansion *y, slong p, slong q)
{
    LOCAL(arb_poly, line);
    LOCAL(arb, exponent);
    LOCAL(mag, tail);
    set_line(line);
    LET(exponent, BITS, "p/q", p, q);
    expansion_zero(y);
    arb_poly_pow_arb_series(expansion_term(y, 0, 0), line, exponent, EXPANSION_LENGTH, BITS);
    mag_set_ui_2exp_si(tail, 1, 1 - EXPANSION_LENGTH);
    expansion_add_rest(y, tail);
}

/* x^(p/q), where 1 - z/2 is what x has without a and b */
static void power_of_half(struct expansion *y, const struct expansion *x, slong p, slong q)
{
    LOCAL_EXPANSION(y->domain, line, factor);
    set_line(expansion_term(line, 0, 0));
    expansion_sub(line, x, line);
    half_power(factor, -1, 1);
    expansion_multiply(line, line, factor);
    expansion_power(y, line, p, q);
    half_power(factor, p, q);
    expansion_multiply(y, y, factor);
}

/* The map of 1/w = V: w = 1 - zeta - integral of mu X V. In eta = X* mu zeta^(5/3) and z = 2 zeta, the integral of
 * mu X eta^k zeta^n is eta^(k+1) zeta^n/(5 (k+1)/3 + n). */
static void speed_map(struct expansion *w, const struct expansion *x, void *context)
{
    (void)context;
    LOCAL(arb, c);
    LOCAL(mag, bound);
    LOCAL_EXPANSION(x->domain, inverse);
    power_of_half(inverse, x, -1, 1);
    expansion_zero(w);
    set_line(expansion_term(w, 0, 0));
    for (slong k = 0; k < EXPANSION_ORDER; k++) {
        const arb_poly_struct *const v = expansion_term_of(inverse, k, 0);
        for (slong n = 0; n < arb_poly_length(v); n++) {
            const arb_srcptr v_n = arb_poly_get_coeff_ptr(v, n);
            LET(c, BITS, "-3*v_n/(5*(k + 1) + 3*n)", v_n, k, n);
            arb_poly_set_coeff_arb(expansion_term(w, k + 1, 0), n, c);
        }
    }
    /* |integral of mu X g| <= (3/5) eta |g| */
    expansion_norm_of_degree(bound, inverse, EXPANSION_ORDER);
    mag_add(bound, bound, inverse->rest);
    mag_mul(bound, bound, x->domain->a);
    expansion_add_rest(w, bound);
}

/* eta/mu = X* 2^(-5/3) where zeta = 1/2 */
static void end_ratio(arb_t ratio, const struct motion *m)
{
    LET(ratio, BITS, "m->limit*(1/2)^(5/3)", m->limit);
}

/* The integral of dzeta/(Y w) up to zeta = 1/2, and w there, as series in mu. With Y = (X*)^(1/2) zeta^(1/3) the
 * integral of eta^k zeta^n/Y is eta^k zeta^(n + 2/3)/(5 k/3 + n + 2/3)/(X*)^(1/2). */
static void start_end(struct motion *m, const struct expansion *w)
{
    LOCAL(arb, ratio, scale, sum, c);
    LOCAL_EXPANSION(w->domain, inverse);
    power_of_half(inverse, w, -1, 1);
    end_ratio(ratio, m);
    arb_one(scale);
    for (slong k = 0; k <= EXPANSION_ORDER; k++) {
        const arb_poly_struct *const speed = expansion_term_of(w, k, 0), *const v = expansion_term_of(inverse, k, 0);
        arb_one(c);
        arb_poly_evaluate(sum, speed, c, BITS);
        arb_mul(sum, sum, scale, BITS);
        expansion_add_number(&m->first_distance, k, 0, sum);
        arb_zero(sum);
        for (slong n = 0; n < arb_poly_length(v); n++) {
            const arb_srcptr v_n = arb_poly_get_coeff_ptr(v, n);
            LET(sum, BITS, "sum + 3*v_n/(5*k + 3*n + 2)", sum, v_n, k, n);
        }
        arb_mul(sum, sum, scale, BITS);
        expansion_add_number(&m->first_time, k, 0, sum);
        arb_mul(scale, scale, ratio, BITS);
    }
    expansion_add_rest(&m->first_distance, w->rest);
    expansion_add_rest(&m->first_time, inverse->rest); /* twice, more than the 3/2 of the integral */
    expansion_add_rest(&m->first_time, inverse->rest);
    /* zeta^(2/3)/(X*)^(1/2) */
    LET(c, BITS, "(1/2)^(2/3)/m->root_of_limit", m->root_of_limit);
    expansion_scale(&m->first_time, &m->first_time, c);
}

/* Adds S to w where zeta = 1/2: X = X* 2^(-2/3). */
static void add_manifold(struct motion *m)
{
    LOCAL(arb, x);
    LOCAL_EXPANSION(&m->fall, inverse_root, S);
    LET(x, BITS, "2^(1/3)/m->root_of_limit", m->root_of_limit);
    expansion_add_number(inverse_root, 1, 0, x);
    manifold_sum(S, m->manifold.p, 0, inverse_root);
    LET(x, BITS, "1/x^2", x);
    expansion_scale(S, S, x);
    expansion_times_a(S, S, 1);
    expansion_add(&m->first_distance, &m->first_distance, S);
}

static void solve_start(struct motion *m)
{
    LOCAL_EXPANSION(&m->start, w);
    set_line(expansion_term(w, 0, 0));
    m->proved = expansion_fixed_point(w, speed_map, NULL) && m->proved;
    start_end(m, w);
    add_manifold(m);
}

/* ---- the fall: zeta as a function of l, f = f_0 exp(-l), in mu, tau = mu l and e = exp(-l) ---- */

/* What the equation of motion contains, for a zeta */
struct fall {
    struct expansion X, inverse_root, r;
    struct expansion slope; /* (dS/dX)/mu */
    struct expansion S;     /* S/mu */
    struct expansion Q;     /* 1/(1 - (dS/dX)/Y) */
    struct expansion rate;  /* dl/ds = 1/rate */
    mag_t defect;
};

static void fall_clear(struct fall *f)
{
    FOR_ALL(expansion, clear, &f->X, &f->inverse_root, &f->r, &f->slope, &f->S, &f->Q, &f->rate);
    mag_clear(f->defect);
}

/* |lack of the manifold's equation|/mu^(MANIFOLD_ORDER + 2) times the largest ds/dl */
static void bound_defect(struct fall *f, const struct motion *m)
{
    LOCAL(mag, bound);
    LOCAL_EXPANSION(f->X.domain, sum);
    manifold_sum(sum, m->manifold.lack, 0, &f->r);
    expansion_norm(f->defect, sum);
    /* X^(1 - MANIFOLD_ORDER/2) = 1/X */
    expansion_norm(bound, &f->inverse_root);
    mag_mul(f->defect, f->defect, bound);
    mag_mul(f->defect, f->defect, bound);
    expansion_norm(bound, &f->rate);
    mag_mul(f->defect, f->defect, bound);
}

static void fall_init(struct fall *f, const struct expansion *zeta, const struct motion *m)
{
    LOCAL(arb, c);
    EXPANSIONS_INIT(zeta->domain, &f->X, &f->inverse_root, &f->r, &f->slope, &f->S, &f->Q, &f->rate);
    mag_init(f->defect);
    power_of_half(&f->inverse_root, zeta, -1, 3);
    arb_inv(c, m->root_of_limit, BITS);
    expansion_scale(&f->inverse_root, &f->inverse_root, c);
    expansion_multiply(&f->X, zeta, &f->inverse_root);
    arb_set_d(c, 1.5);
    expansion_scale(&f->X, &f->X, c);
    expansion_times_a(&f->r, &f->inverse_root, 1);
    manifold_sum(&f->slope, m->manifold.slope, 0, &f->r);
    manifold_sum(&f->S, m->manifold.p, 0, &f->r);
    expansion_multiply(&f->S, &f->S, &f->X);
    expansion_multiply(&f->Q, &f->r, &f->slope);
    arb_set_si(c, -1);
    expansion_scale(&f->Q, &f->Q, c);
    expansion_power(&f->Q, &f->Q, -1, 1);
    expansion_multiply(&f->rate, &f->inverse_root, &f->Q);
    bound_defect(f, m);
}

/* f_0 exp(-l) */
static void distance_of(struct expansion *f, const struct motion *m)
{
    expansion_set(f, &m->first_distance);
    for (slong k = 0; k < EXPANSION_TERMS; k++)
        arb_poly_shift_left(&f->c[k], &f->c[k], 1);
}

/* Adds the integral of c mu^i tau^j e^n over l from 0, n > 0, by parts: that of tau^j e^n is -tau^j e^n/n, between the
 * limits, and j mu/n times that of tau^(j-1) e^n. */
static void add_integral(struct expansion *y, const arb_t c, slong i, slong j, slong n)
{
    LOCAL(arb, term, sum);
    arb_div_si(term, c, -n, BITS);
    for (slong k = 0;; k++) {
        arb_poly_struct *const p = expansion_term(y, i + k, j - k);
        arb_poly_get_coeff_arb(sum, p, n);
        arb_add(sum, sum, term, BITS);
        arb_poly_set_coeff_arb(p, n, sum);
        if (k == j)
            break;
        LET(term, BITS, "term*(j - k)/n", term, j, k, n);
    }
    arb_neg(term, term);
    expansion_add_number(y, i + j, 0, term);
}

/* zeta = 1/2 + f_0 (1 - e) + mu times the integral of h over l */
static void zeta_of(struct expansion *zeta, const struct expansion *h, const struct expansion *distance,
                    const struct motion *m)
{
    LOCAL(arb, c);
    LOCAL(mag, bound);
    LOCAL_EXPANSION(zeta->domain, sum);
    for (slong degree = 0; degree < EXPANSION_ORDER; degree++)
        for (slong j = 0; j <= degree; j++) {
            const slong i = degree - j;
            const arb_poly_struct *const p = expansion_term_of(h, i, j);
            for (slong n = 1; n < arb_poly_length(p); n++)
                add_integral(sum, arb_poly_get_coeff_ptr(p, n), i + 1, j, n);
            arb_poly_get_coeff_arb(c, p, 0);
            arb_div_si(c, c, j + 1, BITS);
            expansion_add_number(sum, i, j + 1, c);
        }
    expansion_norm_of_degree(bound, h, EXPANSION_ORDER);
    mag_add(bound, bound, h->rest);
    mag_mul(bound, bound, h->domain->b);
    expansion_add_rest(sum, bound);
    arb_set_d(c, 0.5);
    expansion_add_number(sum, 0, 0, c);
    expansion_add(sum, sum, &m->first_distance);
    expansion_sub(sum, sum, distance);
    expansion_set(zeta, sum);
}

/* The map dzeta/dl = (f - S)/(1 - (dS/dX)/Y) = f + mu h. f is f_0 e up to the defect. */
static void fall_map(struct expansion *y, const struct expansion *zeta, void *context)
{
    const struct motion *const m = context;
    LOCAL(mag, bound, factor);
    LOCAL_INIT(fall, f, (&f, zeta, m));
    LOCAL_EXPANSION(zeta->domain, distance, h);
    distance_of(distance, m);
    expansion_multiply(h, distance, &f.slope);
    expansion_multiply(h, h, &f.inverse_root);
    expansion_sub(h, h, &f.S);
    expansion_multiply(h, h, &f.Q);
    expansion_norm(bound, &f.Q);
    mag_mul(bound, bound, f.defect);
    mag_pow_ui(factor, zeta->domain->a, MANIFOLD_ORDER + 1);
    mag_mul(bound, bound, factor);
    expansion_add_rest(h, bound);
    zeta_of(y, h, distance, m);
}

/* s = time + l time_per_l: the integral of the rate over l. Without e it is l tau^j/(j + 1) for tau^j, and mu^(i-1)
 * tau^(j+1)/(j + 1) for mu^i tau^j. */
static void solve_time(struct motion *m, const struct expansion *rate)
{
    LOCAL(arb, c);
    expansion_set(&m->time, &m->first_time);
    expansion_add_rest(&m->time_per_l, rate->rest);
    for (slong degree = 0; degree <= EXPANSION_ORDER; degree++)
        for (slong j = 0; j <= degree; j++) {
            const slong i = degree - j;
            const arb_poly_struct *const p = expansion_term_of(rate, i, j);
            for (slong n = 1; n < arb_poly_length(p); n++)
                add_integral(&m->time, arb_poly_get_coeff_ptr(p, n), i, j, n);
            arb_poly_get_coeff_arb(c, p, 0);
            arb_div_si(c, c, j + 1, BITS);
            if (i > 0)
                expansion_add_number(&m->time, i - 1, j + 1, c);
            else
                expansion_add_number(&m->time_per_l, 0, j, c);
        }
}

static void solve_fall(struct motion *m)
{
    set_line(expansion_term(&m->zeta, 0, 0));
    m->proved = expansion_fixed_point(&m->zeta, fall_map, m) && m->proved;
    LOCAL_INIT(fall, f, (&f, &m->zeta, m));
    expansion_set(&m->overlap, &f.X);
    expansion_set(&m->manifold_speed, &f.S);
    mag_set(m->defect, f.defect);
    /* (S - mu X)/mu^2 = Y (p_1 + p_2 r + ...) */
    manifold_sum(&m->force_speed, m->manifold.p, 1, &f.r);
    expansion_multiply(&m->force_speed, &m->force_speed, &f.X);
    expansion_multiply(&m->force_speed, &m->force_speed, &f.inverse_root);
    solve_time(m, &f.rate);
}

/* ---- the events: f = S, the largest overlap, and f = S - mu X, zero force ---- */

struct event {
    const struct motion *m;
    slong power;                   /* e = mu^power exp(theta) */
    const struct expansion *speed; /* f/mu^power at the event */
};

/* tau = mu l and e at l = power ln(1/mu) - theta */
static void place_of(struct expansion *tau, struct expansion *e, const struct expansion *theta,
                     const struct event *event)
{
    LOCAL_VECTOR(c, EXPANSION_ORDER + 1);
    LOCAL(arb, leading);
    LOCAL_EXPANSION(theta->domain, power);
    arb_poly_get_coeff_arb(leading, &theta->c[0], 0);
    expansion_set(power, theta);
    arb_poly_zero(&power->c[0]);
    arb_one(c);
    for (slong k = 1; k <= EXPANSION_ORDER; k++)
        arb_div_si(c + k, c + k - 1, k, BITS);
    expansion_series(e, power, c);
    arb_exp(leading, leading, BITS);
    expansion_scale(e, e, leading);
    expansion_times_a(e, e, event->power);

    arb_set_si(leading, -1);
    expansion_scale(tau, theta, leading);
    expansion_times_a(tau, tau, 1);
    arb_set_si(leading, event->power);
    expansion_add_number(tau, 0, 1, leading);
}

/* 1/f_0, where f_0 is 1/2 without mu */
static void inverse_distance(struct expansion *y, const struct motion *m)
{
    LOCAL(arb, c);
    arb_set_ui(c, 2);
    expansion_scale(y, &m->first_distance, c);
    arb_set_si(c, -1);
    expansion_add_number(y, 0, 0, c);
    expansion_power(y, y, -1, 1);
    arb_set_ui(c, 2);
    expansion_scale(y, y, c);
}

static void logarithm(struct expansion *y, const struct expansion *x)
{
    LOCAL_VECTOR(c, EXPANSION_ORDER + 1);
    LOCAL(arb, leading, inverse);
    arb_poly_get_coeff_arb(leading, &x->c[0], 0);
    arb_get_mid_arb(leading, leading);
    arb_inv(inverse, leading, BITS);
    expansion_scale(y, x, inverse);
    arb_set_si(inverse, -1);
    expansion_add_number(y, 0, 0, inverse);
    for (slong k = 1; k <= EXPANSION_ORDER; k++) {
        arb_set_si(c + k, k % 2 ? 1 : -1);
        arb_div_si(c + k, c + k, k, BITS);
    }
    expansion_series(y, y, c);
    arb_log(leading, leading, BITS);
    expansion_add_number(y, 0, 0, leading);
}

/* The map of theta = ln((speed - defect)/f_0) */
static void event_map(struct expansion *y, const struct expansion *theta, void *context)
{
    const struct event *const event = context;
    LOCAL(mag, bound);
    LOCAL_EXPANSION(theta->domain, tau, e, inverse);
    place_of(tau, e, theta, event);
    expansion_substitute(y, event->speed, tau, e);
    mag_pow_ui(bound, theta->domain->a, (ulong)(MANIFOLD_ORDER + 2 - event->power));
    mag_mul(bound, bound, event->m->defect);
    expansion_add_rest(y, bound);
    inverse_distance(inverse, event->m);
    expansion_multiply(y, y, inverse);
    logarithm(y, y);
}

/* ---- results ---- */

static void far_series_init(struct far_series *s)
{
    for (slong k = 0; k <= EXPANSION_ORDER; k++)
        arb_poly_init(&s->order[k]);
    FOR_ALL(mag, init, s->rest, s->rest_per_u);
}

static void far_series_clear(struct far_series *s)
{
    for (slong k = 0; k <= EXPANSION_ORDER; k++)
        arb_poly_clear(&s->order[k]);
    FOR_ALL(mag, clear, s->rest, s->rest_per_u);
}

/* Adds u^logarithms x. mu^i (mu ln(1/mu))^j is mu^(i+j) ((5/3) u)^j. */
static void add_series(struct far_series *s, const struct expansion *x, slong logarithms)
{
    LOCAL(arb, c, sum);
    for (slong degree = 0; degree <= EXPANSION_ORDER; degree++)
        for (slong j = 0; j <= degree; j++) {
            arb_poly_get_coeff_arb(c, expansion_term_of(x, degree - j, j), 0);
            arb_poly_get_coeff_arb(sum, &s->order[degree], j + logarithms);
            LET(sum, BITS, "sum + c*(5/3)^j", sum, c, j);
            arb_poly_set_coeff_arb(&s->order[degree], j + logarithms, sum);
        }
    if (logarithms)
        mag_add(s->rest_per_u, s->rest_per_u, x->rest);
    else
        mag_add(s->rest, s->rest, x->rest);
}

/* Overlap and time at an event. l = power (5/3) u - theta. */
static void solve_event(struct far_series *overlap, struct far_series *time, struct motion *m, slong power,
                        const struct expansion *speed)
{
    struct event event = {.m = m, .power = power, .speed = speed};
    LOCAL(arb, c);
    LOCAL_EXPANSION(&m->event, theta, tau, e, x, per_l);
    m->proved = expansion_fixed_point(theta, event_map, &event) && m->proved;
    place_of(tau, e, theta, &event);
    expansion_substitute(x, &m->overlap, tau, e);
    add_series(overlap, x, 0);
    expansion_substitute(per_l, &m->time_per_l, tau, e);
    expansion_multiply(theta, theta, per_l);
    expansion_substitute(x, &m->time, tau, e);
    expansion_sub(x, x, theta);
    add_series(time, x, 0);
    LET(c, BITS, "5*power/3", power);
    expansion_scale(per_l, per_l, c);
    add_series(time, per_l, 1);
}

/* ---- all of it ---- */

enum { SERIES = 4 };

/* mu at FAR_MOTION_LEAST_U bounds mu, and 5/2 times mu ln(1/mu) there should bound tau. */
static void set_domains(struct motion *m)
{
    const double least = FAR_MOTION_LEAST_U;
    LOCAL(arb, u, mu, x);
    LET(u, BITS, "5*least/3", least);
    LET(mu, BITS, "exp(-u)", u);
    arb_get_mag(m->fall.a, mu);
    arb_get_mag(m->event.a, mu);
    end_ratio(x, m);
    arb_mul(x, x, mu, BITS);
    arb_get_mag(m->start.a, x);
    arb_mul(x, u, mu, BITS);
    arb_get_mag(m->event.b, x);
    LET(x, BITS, "5*x/2", x);
    arb_get_mag(m->fall.b, x);
}

static void motion_init(struct motion *m)
{
    m->proved = true;
    manifold_init(&m->manifold);
    FOR_ALL(mag, init, m->defect, m->start.a, m->start.b, m->fall.a, m->fall.b, m->event.a, m->event.b);
    FOR_ALL(arb, init, m->limit, m->root_of_limit);
    LET(m->root_of_limit, BITS, "(3/2)^(1/3)");
    arb_sqr(m->limit, m->root_of_limit, BITS);
    set_domains(m);
    EXPANSIONS_INIT(&m->fall, &m->first_distance, &m->first_time, &m->zeta, &m->overlap, &m->manifold_speed,
                    &m->force_speed, &m->time, &m->time_per_l);
}

static void motion_clear(struct motion *m)
{
    FOR_ALL(expansion, clear, &m->first_distance, &m->first_time, &m->zeta, &m->overlap, &m->manifold_speed,
            &m->force_speed, &m->time, &m->time_per_l);
    FOR_ALL(mag, clear, m->defect, m->start.a, m->start.b, m->fall.a, m->fall.b, m->event.a, m->event.b);
    FOR_ALL(arb, clear, m->limit, m->root_of_limit);
    manifold_clear(&m->manifold);
}

bool far_motion_init(struct far_motion *m)
{
    struct far_series *const series[SERIES] = {&m->max_overlap, &m->time_of_max_overlap, &m->eps_zero_force,
                                               &m->duration_zero_force};
    bool proved = true;
    for (int k = 0; k < SERIES; k++)
        far_series_init(series[k]);
    LOCAL_INIT(motion, motion, (&motion));
    solve_start(&motion);
    solve_fall(&motion);
    solve_event(&m->max_overlap, &m->time_of_max_overlap, &motion, 1, &motion.manifold_speed);
    solve_event(&m->eps_zero_force, &m->duration_zero_force, &motion, 2, &motion.force_speed);
    proved = motion.proved;
    for (int k = 0; k < SERIES; k++)
        proved = proved && mag_is_finite(series[k]->rest) && mag_is_finite(series[k]->rest_per_u);
    return proved;
}

void far_motion_clear(struct far_motion *m)
{
    far_series_clear(&m->max_overlap);
    far_series_clear(&m->time_of_max_overlap);
    far_series_clear(&m->eps_zero_force);
    far_series_clear(&m->duration_zero_force);
}

void far_series_value(arb_t y, const struct far_series *s, const arb_t u, slong prec)
{
    LOCAL(arb, mu, x);
    LOCAL(mag, bound);
    LET(mu, prec, "exp(-5*u/3)", u);
    arb_zero(y);
    for (slong k = EXPANSION_ORDER; k >= 0; k--) {
        arb_poly_evaluate(x, &s->order[k], u, prec);
        LET(y, prec, "y*mu + x", y, mu, x);
    }
    arb_get_mag(bound, u);
    mag_mul(bound, bound, s->rest_per_u);
    mag_add(bound, bound, s->rest);
    arb_add_error_mag(y, bound);
    arb_set_d(mu, FAR_MOTION_LEAST_U);
    if (!arb_ge(u, mu))
        arb_indeterminate(y);
}
