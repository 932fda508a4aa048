/* SPDX-License-Identifier: MIT */
#include "enclosure/closed_form.h"

#include "support/local.h"

/* acos(zeta)/sqrt(1-zeta^2) = 2F1(1, 1; 3/2; (1-zeta)/2), used where the quotient cancels. */
static void angle_near_one(arb_t angle, const arb_t zeta, slong prec)
{
    LOCAL(arb, one, c, x);
    arb_one(one);
    arb_set_d(c, 1.5);
    arb_sub(x, one, zeta, prec);
    arb_mul_2exp_si(x, x, -1);
    arb_hypgeom_2f1(angle, one, one, c, x, 0, prec);
}

void closed_form_angle(arb_t angle, const arb_t zeta, slong prec)
{
    LOCAL(arb, x);
    arb_sub_ui(x, zeta, 1, prec);
    if (arf_cmpabs_2exp_si(arb_midref(x), -2) < 0) {
        angle_near_one(angle, zeta, prec);
    } else {
        const bool over = arf_sgn(arb_midref(x)) > 0;
        arb_sqr(x, zeta, prec);
        arb_sub_ui(x, x, 1, prec);
        if (!over)
            arb_neg(x, x);
        arb_sqrt(x, x, prec);
        (over ? arb_acosh : arb_acos)(angle, zeta, prec);
        arb_div(angle, angle, x, prec);
    }
}

/* Duration at zero overlap, zeta < 1: w0^(-2a/(a+1)) om^(-2/(a+1)) S(pi), w0^2 = (a+1)/2, om^2 = 1 - zeta^2,
 * S(pi) = int_0^pi e^(c y) sin(y)^-p dy = pi 2^p e^(pi c/2) Gamma(1-p)/|Gamma(1 - p/2 + i c/2)|^2, p = (a-1)/(a+1),
 * c = p zeta/om. */
static void linear_duration(arb_t time, const arb_t zeta, const arb_t om, const struct law *law, slong prec)
{
    const struct ratio one = {1, 1}, two = {2, 1};
    const struct ratio a1 = ratio_add(law->a, one), p = ratio_div(ratio_sub(law->a, one), a1);
    LOCAL(arb, c, x, pi);
    LOCAL(acb, gamma);
    arb_const_pi(pi, prec);

    arb_set_ratio(c, p, prec);
    arb_mul(c, c, zeta, prec);
    arb_div(c, c, om, prec);
    arb_set_ratio(acb_realref(gamma), ratio_sub(one, ratio_div(p, two)), prec);
    arb_mul_2exp_si(acb_imagref(gamma), c, -1);
    acb_gamma(gamma, gamma, prec);
    acb_abs(x, gamma, prec);
    arb_sqr(x, x, prec);

    arb_mul(c, c, pi, prec);
    arb_mul_2exp_si(c, c, -1);
    arb_exp(c, c, prec);
    arb_div(time, c, x, prec);
    arb_mul(time, time, pi, prec);
    arb_set_ratio(x, ratio_sub(one, p), prec);
    arb_gamma(x, x, prec);
    arb_mul(time, time, x, prec);
    arb_set_ui(c, 2);
    arb_pow_ratio(x, c, p, prec);
    arb_mul(time, time, x, prec);

    arb_set_ratio(c, ratio_div(a1, two), prec);
    arb_pow_ratio(x, c, ratio_div(law->a, a1), prec);
    arb_div(time, time, x, prec);
    arb_pow_ratio(x, om, ratio_div(two, a1), prec);
    arb_div(time, time, x, prec);
}

void closed_form_linear(struct collision *c, const arb_t beta, const struct law *law, slong prec)
{
    const struct ratio one = {1, 1}, two = {2, 1};
    const struct ratio a1 = ratio_add(law->a, one);
    LOCAL(arb, critical, zeta, om, x);
    arb_set_ratio(critical, ratio_mul(two, a1), prec); /* beta^2 at zeta = 1 */
    arb_sqrt(zeta, critical, prec);
    arb_div(zeta, beta, zeta, prec);
    closed_form_angle(x, zeta, prec);
    if (law->ad == law->d) {
        arb_set(c->t_max, x);
        arb_mul_2exp_si(c->t_zero_force, x, 1);
    }
    arb_mul(x, x, zeta, prec);
    arb_mul_2exp_si(x, x, 1);
    arb_neg(x, x);
    arb_exp(c->eps_zero_force, x, prec); /* exp(-2 zeta A) */
    arb_mul(x, c->eps_zero_force, critical, prec);
    arb_mul_2exp_si(x, x, -2);
    arb_pow_ratio(c->x_max, x, ratio_div(one, a1), prec); /* ((a+1)/2 eps)^(1/(a+1)) */

    arb_sqr(om, beta, prec);
    arb_sub(om, critical, om, prec); /* exact if beta is exact */
    if (arb_is_nonpositive(om)) {
        arb_zero(c->eps_zero_overlap);
        arb_pos_inf(c->t_zero_overlap);
    } else {
        arb_div(om, om, critical, prec);
        arb_sqrt(om, om, prec);
        arb_const_pi(x, prec);
        arb_mul(x, x, zeta, prec);
        arb_div(x, x, om, prec);
        arb_neg(x, x);
        arb_exp(c->eps_zero_overlap, x, prec);
        linear_duration(c->t_zero_overlap, zeta, om, law, prec);
    }
}

/* F(y) = 2 y/(1 - exp(-2 y)) - 1 - beta, increasing and convex. */
static void speed_sum_defect(arb_t f, const arb_t y, const arb_t beta, slong prec)
{
    arb_mul_2exp_si(f, y, 1);
    arb_neg(f, f);
    arb_expm1(f, f, prec);
    arb_div(f, y, f, prec);
    arb_mul_2exp_si(f, f, 1);
    arb_neg(f, f);
    arb_sub(f, f, beta, prec);
    arb_sub_ui(f, f, 1, prec);
}

/* F'(y) = 2/(1 - e) - 4 y e/(1 - e)^2, e = exp(-2y), which is between 1 and 2. */
static void speed_sum_slope(arb_t slope, const arb_t y, slong prec)
{
    LOCAL(arb, x);
    arb_mul_2exp_si(x, y, 1);
    arb_neg(x, x);
    arb_exp(slope, x, prec);
    arb_mul(slope, slope, y, prec);
    arb_expm1(x, x, prec); /* e - 1 */
    arb_div(slope, slope, x, prec);
    arb_mul_2exp_si(slope, slope, 1);
    arb_add_ui(slope, slope, 1, prec);
    arb_div(slope, slope, x, prec);
    arb_mul_2exp_si(slope, slope, 1);
    arb_neg(slope, slope);
}

/* Encloses the y > 0 with F(y) = 0. Newton's method starts from min(beta, (1 + beta)/2), which is above the root, and
 * ends when its steps are below half of the bits. The radius covers the rounding errors of F and the interval of beta
 * (dy/dbeta <= 1). The signs of F on both sides prove the enclosure. The result is not finite if the proof fails. */
static void half_speed_sum(arb_t y, const arb_t beta, slong prec)
{
    enum { MOST_STEPS = 64, ROUNDING = 8 };
    LOCAL(arb, exact_beta, f, slope, radius);
    arb_get_mid_arb(exact_beta, beta);
    arb_add_ui(radius, exact_beta, 1, prec);
    arb_mul_2exp_si(y, radius, -1);
    arb_min(y, y, exact_beta, prec);
    bool near = false;
    for (int i = 0; i < MOST_STEPS && !near; i++) {
        speed_sum_defect(f, y, exact_beta, prec);
        speed_sum_slope(slope, y, prec);
        arb_div(f, f, slope, prec);
        arb_sub(y, y, f, prec);
        arb_get_mid_arb(y, y);
        arb_div(f, f, y, prec);
        near = arf_cmpabs_2exp_si(arb_midref(f), -prec / 2) < 0;
    }
    arb_mul_2exp_si(radius, radius, ROUNDING - prec);
    arf_set_mag(arb_midref(f), arb_radref(beta));
    mag_zero(arb_radref(f));
    arb_addmul_si(radius, f, 2, prec);
    arb_sub(slope, y, radius, prec);
    speed_sum_defect(f, slope, beta, prec);
    bool proved = arb_is_negative(f);
    arb_add(slope, y, radius, prec);
    speed_sum_defect(f, slope, beta, prec);
    proved = proved && arb_is_positive(f);
    arb_add_error(y, radius);
    if (!proved)
        arb_indeterminate(y);
}

void closed_form_hunt_crossley(struct collision *c, const arb_t beta, const struct law *law, slong prec)
{
    const struct ratio one = {1, 1}, a1 = ratio_add(law->a, one);
    LOCAL(arb, y, x);
    half_speed_sum(y, beta, prec);
    arb_mul_2exp_si(y, y, 1);
    arb_sub(y, y, beta, prec); /* beta eps */
    arb_div(c->eps_zero_overlap, y, beta, prec);
    arb_set(c->eps_zero_force, c->eps_zero_overlap);
    /* ((a+1) (beta - ln(1+beta))/beta^2)^(1/(a+1)) */
    arb_log1p(x, beta, prec);
    arb_sub(x, beta, x, prec);
    arb_div(x, x, beta, prec);
    arb_div(x, x, beta, prec);
    arb_set_ratio(y, a1, prec);
    arb_mul(x, x, y, prec);
    arb_pow_ratio(c->x_max, x, ratio_div(one, a1), prec);
}
