/* SPDX-License-Identifier: MIT */
#include "enclosure/closed_form.h"

#include "support/local.h"

/* acos(zeta)/sqrt(1-zeta^2) = 2F1(1, 1; 3/2; (1-zeta)/2), used where the quotient cancels. */
void closed_form_angle(arb_t angle, const arb_t zeta, slong prec)
{
    LOCAL(arb, x, one, c);
    LET(x, prec, "(1 - zeta)/2", zeta);
    arb_one(one);
    arb_set_d(c, 1.5);
    if (arf_cmpabs_2exp_si(arb_midref(x), -21) < 0)
        arb_hypgeom_2f1(angle, one, one, c, x, 0, prec);
    else if (arf_sgn(arb_midref(x)) > 0)
        LET(angle, prec, "acos(zeta)/sqrt((1 - zeta)*(1 + zeta))", zeta);
    else
        LET(angle, prec, "acosh(zeta)/sqrt((zeta - 1)*(zeta + 1))", zeta);
}

/* Duration at zero overlap, zeta < 1: w0^(-2a/(a+1)) om^(-2/(a+1)) S(pi), w0^2 = (a+1)/2, om^2 = 1 - zeta^2,
 * S(pi) = int_0^pi e^(c y) sin(y)^-p dy = pi 2^p e^(pi c/2) Gamma(1-p)/|Gamma(1 - p/2 + i c/2)|^2, p = (a-1)/(a+1),
 * c = p zeta/om. */
static void linear_duration(arb_t time, const arb_t zeta, const arb_t om, const struct law *law, slong prec)
{
    LOCAL(fmpq, p);
    LOCAL(arb, c, x);
    LOCAL(acb, gamma);
    EXACT(p, "(law->a - 1)/(law->a + 1)", law->a);
    LET(c, prec, "p*zeta/om", p, zeta, om);
    LET(acb_realref(gamma), prec, "1 - p/2", p);
    arb_mul_2exp_si(acb_imagref(gamma), c, -1);
    acb_gamma(gamma, gamma, prec);
    acb_abs(x, gamma, prec);
    LET(time, prec, "exp(pi*c/2)/x^2*pi*gamma(1 - p)*2^p/((law->a + 1)/2)^(law->a/(law->a + 1))/om^(2/(law->a + 1))", c,
        x, p, law->a, om);
}

void closed_form_linear(struct collision *c, const arb_t beta, const struct law *law, slong prec)
{
    LOCAL(fmpq, critical); /* beta^2 at zeta = 1 */
    LOCAL(arb, zeta, om, x);
    EXACT(critical, "2*(law->a + 1)", law->a);
    LET(zeta, prec, "beta/sqrt(critical)", beta, critical);
    closed_form_angle(x, zeta, prec);
    if (law->ad == law->d) {
        arb_set(c->t_max, x);
        arb_mul_2exp_si(c->t_zero_force, x, 1);
    }
    LET(c->eps_zero_force, prec, "exp(-2*zeta*x)", zeta, x);
    LET(c->x_max, prec, "((law->a + 1)/2*c->eps_zero_force)^(1/(law->a + 1))", law->a, c->eps_zero_force);
    LET(om, prec, "critical - beta^2", critical, beta); /* exact if beta is exact */
    if (arb_is_nonpositive(om)) {
        arb_zero(c->eps_zero_overlap);
        arb_pos_inf(c->t_zero_overlap);
    } else {
        LET(om, prec, "sqrt(om/critical)", om, critical);
        LET(c->eps_zero_overlap, prec, "exp(-pi*zeta/om)", zeta, om);
        linear_duration(c->t_zero_overlap, zeta, om, law, prec);
    }
}

/* F(y) = 2 y/(1 - exp(-2 y)) - 1 - beta, increasing and convex. */
static void speed_sum_defect(arb_t f, const arb_t y, const arb_t beta, slong prec)
{
    LET(f, prec, "-2*y/expm1(-2*y) - beta - 1", y, beta);
}

/* F'(y) = 2/(1 - e) - 4 y e/(1 - e)^2, e = exp(-2y), which is between 1 and 2. */
static void speed_sum_slope(arb_t slope, const arb_t y, slong prec)
{
    LOCAL(arb, x);
    LET(x, prec, "expm1(-2*y)", y); /* e - 1 */
    LET(slope, prec, "-2*(2*y*exp(-2*y)/x + 1)/x", y, x);
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
    LET(y, prec, "min(radius/2, exact_beta)", radius, exact_beta);
    bool near = false;
    for (int i = 0; i < MOST_STEPS && !near; i++) {
        speed_sum_defect(f, y, exact_beta, prec);
        speed_sum_slope(slope, y, prec);
        LET(y, prec, "y - f/slope", y, f, slope);
        arb_get_mid_arb(y, y);
        LET(f, prec, "f/slope/y", f, slope, y);
        near = arf_cmpabs_2exp_si(arb_midref(f), -prec / 2) < 0;
    }
    arb_mul_2exp_si(radius, radius, ROUNDING - prec);
    arb_set_upper(f, arb_radref(beta));
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
    LOCAL(arb, y);
    prec += 2 * FLINT_MAX(0, -(slong)arf_abs_bound_lt_2exp_si(arb_midref(beta))); /* which x_max loses near beta = 0 */
    half_speed_sum(y, beta, prec);
    LET(c->eps_zero_overlap, prec, "(2*y - beta)/beta", y, beta);
    arb_set(c->eps_zero_force, c->eps_zero_overlap);
    LET(c->x_max, prec, "((law->a + 1)*((beta - log1p(beta))/beta/beta))^(1/(law->a + 1))", law->a, beta);
}
