/* SPDX-License-Identifier: MIT */
#include "enclosure/closed_form.h"

#include "support/local.h"

/* computes acos(zeta)/sqrt(1-zeta^2) as 2F1(1, 1; 3/2; (1-zeta)/2) where the quotient cancels */
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

/* Computes the duration at zero overlap for zeta < 1, w0^(-2a/(a+1)) om^(-2/(a+1)) S(pi), with w0^2 = (a+1)/2,
 * om^2 = 1 - zeta^2, p = (a-1)/(a+1) and c = p zeta/om. The integral S(pi) = int_0^pi e^(c y) sin(y)^-p dy is pi 2^p
 * e^(pi c/2) Gamma(1-p)/|Gamma(1 - p/2 + i c/2)|^2. */
static void linear_duration(arb_t time, const arb_t zeta, const arb_t om, const struct cor_exponents *law, slong prec)
{
    LOCAL(fmpq, p);
    LOCAL(arb, c, x);
    LOCAL(acb, gamma);
    EXACT(p, "(law->a - 1)/(law->a + 1)", law);
    LET(c, prec, "p*zeta/om", p, zeta, om);
    LET(acb_realref(gamma), prec, "1 - p/2", p);
    arb_mul_2exp_si(acb_imagref(gamma), c, -1);
    acb_gamma(gamma, gamma, prec);
    acb_abs(x, gamma, prec);
    LET(time, prec, "exp(pi*c/2)/x^2*pi*gamma(1 - p)*2^p/((law->a + 1)/2)^(law->a/(law->a + 1))/om^(2/(law->a + 1))", c,
        x, p, law, om);
}

void closed_form_linear(struct collision *c, const arb_t beta, const struct cor_exponents *law, slong prec)
{
    LOCAL(fmpq, critical); /* at zeta = 1, beta^2 is 2 (a + 1) */
    LOCAL(arb, zeta, om, x);
    EXACT(critical, "2*(law->a + 1)", law);
    LET(zeta, prec, "beta/sqrt(critical)", beta, critical);
    closed_form_angle(x, zeta, prec);
    if (law->elastic == law->denominator) {
        arb_set(c->t_max, x);
        arb_mul_2exp_si(c->t_zero_force, x, 1);
    }
    LET(c->eps_zero_force, prec, "exp(-2*zeta*x)", zeta, x);
    LET(c->x_max, prec, "((law->a + 1)/2*c->eps_zero_force)^(1/(law->a + 1))", law, c->eps_zero_force);
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

/* Sets eps = (1 + W_0(-x))/beta, x = (1 + beta) exp(-1 - beta), and x_max. Near beta = 0, the branch point of W, eps
 * and x_max lose 2 log2(1/beta) bits. */
void closed_form_hunt_crossley(struct collision *c, const arb_t beta, const struct cor_exponents *law, slong prec)
{
    LOCAL(arb, w);
    prec += 2 * FLINT_MAX(0, -(slong)arf_abs_bound_lt_2exp_si(arb_midref(beta)));
    LET(w, prec, "-(1 + beta)*exp(-1 - beta)", beta);
    arb_lambertw(w, w, 0, prec);
    LET(c->eps_zero_overlap, prec, "(1 + w)/beta", w, beta);
    arb_set(c->eps_zero_force, c->eps_zero_overlap);
    LET(c->x_max, prec, "((law->a + 1)*((beta - log1p(beta))/beta/beta))^(1/(law->a + 1))", law, beta);
}
