/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "approximation/interpolant_parts.h"
#include "support/local.h"

/* Powers of beta that the quantities follow for large beta. A duration at zero overlap is mainly the creep along the
 * slow manifold or, if a - b > 1, the end of the creep. */
struct ratio interpolant_tail_power(const struct law *law, enum quantity quantity)
{
    const struct ratio a = law->a, b = law->b;
    if (law_is_linear(law) && is_of_overlap(quantity)) /* no power */
        return (struct ratio){0, 1};
    switch (quantity) {
    case EPS_ZERO_OVERLAP:
        return RATIO("-(a + 1)/(2*b - a + 1)", a, b);
    case EPS_ZERO_FORCE:
        return RATIO("-(a + 1)/(b + 1)", a, b);
    case DURATION_ZERO_OVERLAP:
        return law->ad - law->bd > law->d ? RATIO("(a - 1)/(2*b - a + 1)", a, b) : RATIO("a/(b + 1)", a, b);
    default:
        return RATIO("-1/(b + 1)", b);
    }
}

void interpolant_power(arb_t y, const arb_t u, struct ratio power, slong prec)
{
    const slong num = power.num, den = power.den;
    LET(y, prec, "exp(u*num/den)", u, num, den);
}

void interpolant_polynomial_at(arb_t y, const struct interpolant *f, int i, enum quantity quantity, const arb_t x,
                               slong prec)
{
    const struct interval *const interval = &f->layout->interval[i];
    const arb_poly_struct *const p = &f->samples[i].polynomial[quantity];
    LOCAL(arb, t, at, slope, rough);
    LOCAL(mag, radius);
    unit_place(t, x, interval->lo, interval->hi, prec + INTERPOLANT_GUARD);
    /* p at the middle of t, and a bound of its slope: powers of the ball t would be far wider */
    arb_get_mid_arb(at, t);
    arb_poly_evaluate(y, p, at, prec + INTERPOLANT_GUARD);
    arb_poly_evaluate2(rough, slope, p, t, INTERPOLANT_GUARD);
    arb_get_mag(radius, slope);
    mag_mul(radius, radius, arb_radref(t));
    arb_add_error_mag(y, radius);
}

/* The first interval of a variable that samples the quantity and does not end before x, or the last such interval, or
 * -1. If `scaled`, only intervals of FORM_POWER count. */
static int interval_at(const struct interpolant *f, enum quantity quantity, enum interval_variable variable,
                       const arb_t x, bool scaled_only)
{
    const double at = ball_middle(x);
    int found = -1;
    for (int i = 0; i < f->layout->intervals; i++) {
        const struct interval *interval = &f->layout->interval[i];
        if (interval->variable != variable || !holds(interval, quantity) ||
            (scaled_only && interval->form != FORM_POWER))
            continue;
        found = i;
        if (at <= interval->hi)
            break;
    }
    return found;
}

void interpolant_beta(arb_t beta, const struct interpolant *f, enum interval_variable variable, const arb_t x,
                      slong prec)
{
    static const char *const of_place[] = {
        [INTERVAL_ROOT] = "x^root", [INTERVAL_LOG] = "exp(x)", [INTERVAL_BELOW] = "f->threshold - exp(x)"};
    const slong root = f->layout->root;
    LET(beta, prec, of_place[variable], x, root, f->threshold);
}

/* The quantity, or (1 - eps)/beta, from the number that an interval stores */
static void restore(arb_t y, const struct interpolant *f, enum quantity stored, bool loss, enum interval_form form,
                    enum interval_variable variable, const arb_t x, slong prec)
{
    static const char *const eps_or_loss[][2] = {[FORM_VALUE] = {"y", "(1 - y)/beta"},
                                                 [FORM_QUOTIENT] = {"1 - y*beta", "y"},
                                                 [FORM_LOG] = {"exp(y)", "-expm1(y)/beta"},
                                                 [FORM_POWER] = {"y*scale", "(1 - y*scale)/beta"}};
    LOCAL(arb, beta, scale);
    if (form == FORM_POWER)
        interpolant_power(scale, x, interpolant_tail_power(&f->layout->law, stored), prec);
    if (loss || form == FORM_QUOTIENT)
        interpolant_beta(beta, f, variable, x, prec);
    if (is_eps(stored) || form == FORM_POWER)
        LET(y, prec, eps_or_loss[form][loss], y, beta, scale);
}

/* Zero force from zero overlap, near beta = 0: eps G(w), and the duration less eps^((1-a)/(1+a)) h^(1/(a-b)) T(w), h =
 * beta eps^q, w = h^((a+1)/(a-b)) (docs/theory.md, 5 and 9). The loss quotient needs only G - 1. */
static void backward(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t x, slong prec)
{
    const struct ratio a = f->layout->law.a, b = f->layout->law.b, q = law_speed_exponent(&f->layout->law);
    LOCAL(arb, beta, eps, h, w, part);
    interpolant_beta(beta, f, INTERVAL_ROOT, x, prec);
    interpolant_at(eps, f, EPS_ZERO_OVERLAP, INTERVAL_ROOT, x, prec);
    const bool elastic = arb_is_zero(beta); /* h = w = 0 */
    if (!elastic) {
        LET(h, prec, "(eps^q*beta)^(1/(a - b))", eps, q, beta, a, b);
        LET(w, prec, "h^(a + 1)", h, a);
    }
    if (quantity == DURATION_ZERO_FORCE) {
        arb_poly_evaluate(part, f->backward_time, w, prec);
        interpolant_at(y, f, DURATION_ZERO_OVERLAP, INTERVAL_ROOT, x, prec);
        LET(y, prec, "y - part*h*eps^((1 - a)/(1 + a))", y, part, h, eps, a);
        return;
    }
    arb_poly_evaluate(part, f->backward, w, prec);
    if (quantity == LOSS_QUOTIENT_ZERO_FORCE) {
        /* (1 - eps G)/beta = (1 - eps)/beta - eps (G - 1)/beta */
        interpolant_at(y, f, LOSS_QUOTIENT_ZERO_OVERLAP, INTERVAL_ROOT, x, prec);
        if (!elastic)
            LET(y, prec, "y - (part - 1)*eps/beta", y, part, eps, beta);
    } else {
        arb_mul(y, eps, part, prec);
    }
}

enum quantity interpolant_end(const struct interpolant *f, enum quantity quantity)
{
    const bool force = is_of_force(quantity) || quantity == LOSS_QUOTIENT_ZERO_FORCE;
    return force && !law_force_ends(&f->layout->law) ? (enum quantity)(quantity - 1) : quantity;
}

/* Damping during the approach only: the rebound is elastic, eps^2/2 = X^(a+1)/(a+1) with the largest overlap X, and
 * takes half of an elastic collision at the impact speed eps. To first order in beta the loss is half of the full one,
 * because the approach and the rebound lose the same. */
static void approach_only(arb_t y, const struct interpolant *f, enum quantity quantity, enum interval_variable variable,
                          const arb_t x, slong prec)
{
    const struct ratio a = f->layout->law.a;
    LOCAL(arb, beta, eps, part, zero);
    interpolant_beta(beta, f, variable, x, prec);
    if (quantity == LOSS_QUOTIENT_APPROACH_ONLY && arf_cmpabs_2exp_si(arb_midref(beta), -90) < 0) {
        /* the next order is negligible */
        interpolant_at(y, f, LOSS_QUOTIENT_ZERO_OVERLAP, INTERVAL_ROOT, zero, prec);
        arb_mul_2exp_si(y, y, -1);
        return;
    }
    interpolant_at(eps, f, MAX_OVERLAP, variable, x, prec);
    LET(eps, prec, "sqrt(eps^(a + 1)*(2/(a + 1)))", eps, a);
    if (quantity == EPS_APPROACH_ONLY) {
        arb_set(y, eps);
    } else if (quantity == LOSS_QUOTIENT_APPROACH_ONLY) {
        LET(y, prec, "(1 - eps)/beta", eps, beta);
    } else {
        interpolant_at(part, f, TIME_OF_MAX_OVERLAP, INTERVAL_ROOT, zero, prec);
        interpolant_at(y, f, TIME_OF_MAX_OVERLAP, variable, x, prec);
        LET(y, prec, "y + part*eps^((1 - a)/(1 + a))", y, part, eps, a);
    }
}

void interpolant_at(arb_t y, const struct interpolant *f, enum quantity quantity, enum interval_variable variable,
                    const arb_t x, slong prec)
{
    if (quantity >= EPS_APPROACH_ONLY) {
        approach_only(y, f, quantity, variable, x, prec);
        return;
    }
    quantity = interpolant_end(f, quantity);
    const enum quantity stored = sampled_quantity(quantity);
    const int i = interval_at(f, stored, variable, x, false);
    enum interval_form form = FORM_LOG;
    if (i >= 0) {
        interpolant_polynomial_at(y, f, i, stored, x, prec);
        form = f->layout->interval[i].form;
    } else if (stored == EPS_ZERO_OVERLAP) { /* q = 0: exp(-pi beta/sqrt(beta_c^2 - beta^2)) */
        LOCAL(arb, beta);
        interpolant_beta(beta, f, variable, x, prec);
        LET(y, prec, "-(pi*beta/sqrt(f->threshold^2 - beta^2))", beta, f->threshold);
    } else {
        backward(y, f, quantity, x, prec);
        return;
    }
    restore(y, f, stored, quantity != stored, form, variable, x, prec);
}

void interpolant_tail(arb_t y, const struct interpolant *f, enum quantity quantity, enum interval_variable variable,
                      const arb_t x, slong prec)
{
    quantity = interpolant_end(f, quantity);
    const int i = interval_at(f, quantity, variable, x, variable == INTERVAL_LOG);
    const enum interval_form form = f->layout->interval[i].form;
    interpolant_polynomial_at(y, f, i, quantity, x, prec);
    if (form != FORM_POWER)
        restore(y, f, quantity, false, form, variable, x, prec);
}

/* ---- the quantity at any beta ---- */

double interpolant_last(const struct interpolant *f, enum quantity quantity, enum interval_variable variable)
{
    double last = -HUGE_VAL;
    for (int i = 0; i < f->layout->intervals; i++)
        if (f->layout->interval[i].variable == variable && holds(&f->layout->interval[i], quantity))
            last = fmax(last, f->layout->interval[i].hi);
    return last;
}

void interpolant_at_beta(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t beta, slong prec)
{
    const struct interpolant_layout *layout = f->layout;
    quantity = interpolant_end(f, quantity);
    const enum quantity stored = sampled_quantity(quantity);
    const double b = ball_middle(beta);
    const double root_end = pow(fmax(interpolant_last(f, stored, INTERVAL_ROOT), 0), (double)layout->root);
    LOCAL(arb, x);
    if (b <= root_end ||
        (!holds(&layout->interval[0], stored) && b <= pow(layout->interval[0].hi, (double)layout->root))) {
        arb_root_ui(x, beta, (ulong)layout->root, prec);
        interpolant_at(y, f, quantity, INTERVAL_ROOT, x, prec);
    } else if (is_of_overlap(quantity) && arb_is_finite(f->threshold) &&
               b > exp(interpolant_last(f, quantity, INTERVAL_LOG))) {
        arb_sub(x, f->threshold, beta, prec);
        if (arb_is_positive(x)) {
            arb_log(x, x, prec);
            interpolant_at(y, f, quantity, INTERVAL_BELOW, x, prec);
        } else if (quantity == EPS_ZERO_OVERLAP) {
            arb_zero(y);
        } else {
            arb_pos_inf(y);
        }
    } else {
        arb_log(x, beta, prec);
        if (log(b) <= interpolant_last(f, stored, INTERVAL_LOG)) {
            interpolant_at(y, f, quantity, INTERVAL_LOG, x, prec);
        } else if (quantity == EPS_ZERO_OVERLAP) {
            interpolant_power(y, x, interpolant_tail_power(&layout->law, quantity), prec);
            arb_mul(y, y, f->final_speed, prec);
        } else {
            interpolant_far_value(y, f, quantity, x, prec);
        }
    }
}
