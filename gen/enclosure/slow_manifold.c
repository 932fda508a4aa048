/* SPDX-License-Identifier: MIT */
#include "enclosure/slow_manifold.h"

#include "enclosure/taylor.h"
#include "support/console.h"

/* Upper bound of sum_{n >= first} |p_n| r^n / n^(divide ? 1 : 0). */
static void abs_tail(arb_t sum, const arb_poly_t p, slong first, const arb_t r, bool divide, slong prec)
{
    arb_t term, power;
    arb_init(term);
    arb_init(power);
    arb_zero(sum);
    arb_pow_ui(power, r, (ulong)first, prec);
    for (slong n = first; n < p->length; n++) {
        arb_abs(term, p->coeffs + n);
        arb_mul(term, term, power, prec);
        if (divide)
            arb_div_si(term, term, n, prec);
        arb_add(sum, sum, term, prec);
        arb_mul(power, power, r, prec);
    }
    arb_get_ubound_arf(arb_midref(sum), sum, prec);
    mag_zero(arb_radref(sum));
    arb_clear(term);
    arb_clear(power);
}

/* p_0 = 1, p_n = (p^2)_(n-1) (5 - n)/4: order r^n of N(p) = 0, since p p' = (p^2)'/2. */
static void formal_sum(arb_poly_t p, slong degree, slong prec)
{
    arb_t c;
    arb_init(c);
    arb_poly_one(p);
    arb_poly_fit_length(p, degree + 1);
    for (slong n = 1; n <= degree; n++) {
        arb_dot(c, NULL, 0, p->coeffs, 1, p->coeffs + n - 1, -1, n, prec);
        arb_mul_si(c, c, 5 - n, prec);
        arb_mul_2exp_si(c, c, -2);
        arb_set(p->coeffs + n, c);
        _arb_poly_set_length(p, n + 1);
    }
    arb_clear(c);
}

/* eta at a given radius: what is promised plus four times the defect. */
static void eta_of(arb_t eta, const struct slow_manifold *m, slong bits)
{
    arb_one(eta);
    arb_mul_2exp_si(eta, eta, -bits);
    arb_addmul_si(eta, m->nu, 4, m->prec);
}

/* One thin trajectory from r1 with slope p down to z = 0, in w = sqrt(z): its end speed and time. */
static bool fall(arb_t speed, arb_t time, const arb_t r1, const arb_t p, slong prec)
{
    const struct law *law = &law_sphere;
    struct taylor y;
    bool fallen = false, sound = true;
    arb_t value;
    arb_init(value);
    taylor_init(&y, law, 1, prec / 3 + 10, prec);
    arb_one(y.c1);
    arb_one(y.c2);
    arb_inv(y.w, r1, prec);
    arb_sqr(y.v, y.w, prec);
    arb_mul(y.v, y.v, p, prec);
    arb_neg(y.v, y.v);
    for (slong step = 0; sound && !fallen; step++) {
        progress("fall along the slow manifold", step, 0);
        taylor_expand(&y);
        sound = taylor_choose_step(&y);
        if (!sound)
            break;
        taylor_value(value, &y, TAYLOR_W, 0, y.step);
        if (arb_is_positive(value)) {
            taylor_advance(&y, y.step);
        } else if (arb_is_negative(value)) {
            fallen = taylor_root(value, &y, TAYLOR_W, y.step);
            sound = fallen;
        } else {
            sound = false;
        }
    }
    if (fallen) {
        taylor_value(speed, &y, TAYLOR_V, 0, value);
        arb_neg(speed, speed);
        taylor_value(time, &y, TAYLOR_T, 0, value);
    }
    taylor_clear(&y);
    arb_clear(value);
    return fallen;
}

bool slow_manifold_init(struct slow_manifold *m, slong bits, slong prec)
{
    arb_poly_t square, defect, term;
    arb_t x, eta, low, high, t_low, t_high;
    arb_poly_init(m->p);
    arb_poly_init(m->inverse);
    arb_init(m->r1);
    arb_init(m->nu);
    arb_init(m->inverse_error);
    arb_init(m->h_star_5);
    arb_init(m->t_fall);
    m->prec = prec;
    arb_poly_init(square);
    arb_poly_init(defect);
    arb_poly_init(term);
    arb_init(x);
    arb_init(eta);
    arb_init(low);
    arb_init(high);
    arb_init(t_low);
    arb_init(t_high);

    /* Cut at n = 1/r1, half way to the smallest term: the defect is about exp(-(1 + ln 2)/r1). */
    const slong degree = (slong)(0.415 * (double)(bits + 24)) + 4;
    formal_sum(m->p, degree, prec);
    arb_set_si(m->r1, degree);
    arb_inv(m->r1, m->r1, prec);
    arb_get_mid_arb(m->r1, m->r1);

    /* N(P) = 1 - P + r P^2 - r^2 (P^2)'/4 starts at r^(degree+1). */
    arb_poly_mul(square, m->p, m->p, prec);
    arb_poly_shift_left(defect, square, 1);
    arb_poly_sub(defect, defect, m->p, prec);
    arb_poly_derivative(term, square, prec);
    arb_poly_shift_left(term, term, 2);
    arb_poly_scalar_mul_2exp_si(term, term, -2);
    arb_poly_sub(defect, defect, term, prec);
    abs_tail(m->nu, defect, degree + 1, m->r1, false, prec);

    /* At p = P +- eta the field points inwards if |N(P)| < eta |1 - 2 r P - r eta + r^2 P'/2|; |P|, |P'| r by
     * their sums of absolute values. That factor is above 1/2 and P above 3/4 for the r1 in use. */
    eta_of(eta, m, bits);
    abs_tail(low, m->p, 1, m->r1, false, prec);
    arb_poly_derivative(term, m->p, prec);
    abs_tail(high, term, 0, m->r1, false, prec);
    arb_mul(high, high, m->r1, prec);
    arb_mul_2exp_si(x, low, 1);
    arb_add(x, x, high, prec);
    arb_add(x, x, eta, prec);
    arb_add_si(x, x, 2, prec);
    arb_mul(x, x, m->r1, prec);
    arb_mul_2exp_si(x, x, 1);
    arb_sub_si(x, x, 1, prec);
    bool closed = arb_is_negative(x);
    arb_mul_2exp_si(x, low, 2);
    arb_sub_si(x, x, 1, prec);
    closed = closed && arb_is_negative(x);

    if (closed) {
        arb_poly_inv_series(m->inverse, m->p, degree + 1, prec);
        /* 1/P - inverse = (1 - P inverse)/P, |1/P| < 4/3, times 2/r and integrated */
        arb_poly_mul(term, m->p, m->inverse, prec);
        abs_tail(m->inverse_error, term, degree + 1, m->r1, true, prec);
        arb_mul_si(m->inverse_error, m->inverse_error, 3, prec);

        /* -z' as a function of z obeys a scalar equation, so trajectories keep their order: the two edges
         * enclose all between, and the fall draws them together. A faster one takes less time. */
        arb_poly_evaluate(x, m->p, m->r1, prec);
        arb_sub(low, x, eta, prec);
        arb_add(high, x, eta, prec);
        closed = fall(m->h_star_5, t_low, m->r1, low, prec) && fall(x, t_high, m->r1, high, prec);
        arb_union(m->h_star_5, m->h_star_5, x, prec);
        arb_union(m->t_fall, t_low, t_high, prec);
    }
    arb_poly_clear(square);
    arb_poly_clear(defect);
    arb_poly_clear(term);
    arb_clear(x);
    arb_clear(eta);
    arb_clear(low);
    arb_clear(high);
    arb_clear(t_low);
    arb_clear(t_high);
    return closed;
}

void slow_manifold_clear(struct slow_manifold *m)
{
    arb_poly_clear(m->p);
    arb_poly_clear(m->inverse);
    arb_clear(m->r1);
    arb_clear(m->nu);
    arb_clear(m->inverse_error);
    arb_clear(m->h_star_5);
    arb_clear(m->t_fall);
}

bool slow_manifold_reached(const struct slow_manifold *m, const arb_t r, const arb_t p, slong bits)
{
    arb_t x, bound;
    arb_init(x);
    arb_init(bound);
    arb_poly_evaluate(x, m->p, r, m->prec);
    arb_sub(x, x, p, m->prec);
    arb_abs(x, x);
    arb_one(bound);
    arb_mul_2exp_si(bound, bound, -bits);
    const bool reached = arb_lt(r, m->r1) && arb_lt(x, bound);
    arb_clear(x);
    arb_clear(bound);
    return reached;
}

bool slow_manifold_time(arb_t time, const struct slow_manifold *m, const arb_t r, const arb_t p, slong bits)
{
    arb_poly_t rest;
    arb_t x, eta;
    if (!slow_manifold_reached(m, r, p, bits))
        return false;
    arb_poly_init(rest);
    arb_init(x);
    arb_init(eta);
    /* int_r^r1 2 (inverse - 1)/r dr + 2 ln(r1/r) */
    arb_poly_shift_right(rest, m->inverse, 1);
    arb_poly_integral(rest, rest, m->prec);
    arb_poly_evaluate(time, rest, m->r1, m->prec);
    arb_poly_evaluate(x, rest, r, m->prec);
    arb_sub(time, time, x, m->prec);
    arb_div(x, m->r1, r, m->prec);
    arb_log(x, x, m->prec);
    arb_add(time, time, x, m->prec);
    arb_mul_2exp_si(time, time, 1);
    arb_add_error(time, m->inverse_error);
    /* |1/p - 1/P| <= eta/(3/4 - eta)^2 < 2 eta, times 2 ln(r1/r) */
    eta_of(eta, m, bits);
    arb_mul(x, x, eta, m->prec);
    arb_mul_2exp_si(x, x, 2);
    arb_add_error(time, x);
    arb_poly_clear(rest);
    arb_clear(x);
    arb_clear(eta);
    return true;
}
