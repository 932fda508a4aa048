/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "approximation/interpolant_parts.h"
#include "support/console.h"
#include "support/local.h"

/* The search range of an inverse */
struct search {
    const struct interpolant *f;
    enum quantity function; /* function to invert: eps or (1 - eps)/beta */
    bool of_loss;
    enum interval_variable variable;
    double lo, hi;
    slong prec;
};

/* Working bits far from the solution: the bits that the coefficients of the polynomials lose, and 64 more */
enum { SEARCH_BITS = 128 };

/* Computes a function of w minus its target value. For the loss the function is loss^(1/root), because its slope is not
 * 0 at beta = 0. For eps it is ln(eps), because eps may fall by many powers of ten in an interval. */
static void set_excess(arb_t y, const struct search *s, const arb_t w, const arb_t wanted)
{
    const slong prec = s->prec, root = s->f->layout->root;
    interpolant_at(y, s->f, s->function, s->variable, w, prec);
    if (!s->of_loss) {
        LET(y, prec, "log(y) - wanted", y, wanted);
    } else if (s->variable == INTERVAL_ROOT) {
        LET(y, prec, "y^(1/root)*w - wanted", y, root, w, wanted);
    } else {
        LOCAL(arb, beta);
        interpolant_beta(beta, s->f, s->variable, w, prec);
        LET(y, prec, "(y*beta)^(1/root) - wanted", y, beta, root, wanted);
    }
    arb_get_mid_arb(y, y);
}

/* True if w is beyond the root. The loss rises with beta; eps and v = ln(beta_c - beta) fall with beta. */
static bool is_beyond_root(const struct search *s, double w, const arb_t wanted)
{
    LOCAL(arb, x, y);
    arb_set_d(x, w);
    set_excess(y, s, x, wanted);
    const int sign = arf_sgn(arb_midref(y));
    return (s->of_loss ? sign > 0 : sign < 0) != (s->variable == INTERVAL_BELOW);
}

/* Bisects to a short bracket, then applies the secant method, which converges with the order 1.6. 18 steps suffice for
 * 110 bits. */
static int solve_search(arb_t w, struct search *s, const arb_t wanted)
{
    enum { HALVINGS = 5, STEPS = 18, NEAR_BITS = 20, ENOUGH_BITS = 110 };
    for (int k = 0; k < HALVINGS; k++) {
        const double middle = (s->lo + s->hi) / 2;
        if (is_beyond_root(s, middle, wanted))
            s->hi = middle;
        else
            s->lo = middle;
    }
    LOCAL(arb, before, f0, f1, step);
    arb_set_d(before, s->lo);
    arb_set_d(w, s->hi);
    set_excess(f0, s, before, wanted);
    bool found = false;
    for (int k = 0; k < STEPS && !found; k++) {
        set_excess(f1, s, w, wanted);
        found = arb_is_zero(f1);
        if (!found) {
            LET(step, INTERPOLANT_BITS, "(w - before)*f1/(f1 - f0)", w, before, f1, f0);
            arb_set(before, w);
            arb_sub(w, w, step, INTERPOLANT_BITS);
            arb_get_mid_arb(w, w);
            arb_set(f0, f1);
            found = arf_cmpabs_2exp_si(arb_midref(step), -ENOUGH_BITS) < 0;
            if (arf_cmpabs_2exp_si(arb_midref(step), -NEAR_BITS) < 0)
                s->prec = INTERPOLANT_BITS;
        }
    }
    return found ? STATUS_OK : fail("found no beta whose collision has the given result");
}

/* Chooses the first variable whose range contains the root. */
static void choose_stretch(struct search *s, const arb_t wanted)
{
    const struct interpolant *f = s->f;
    const struct interpolant_layout *layout = f->layout;
    const enum quantity eps = sampled_quantity(interpolant_end(f, s->function));
    s->variable = INTERVAL_ROOT;
    s->lo = 0;
    s->hi = layout->interval[0].hi; /* becomes the end of the last interval in z that contains eps */
    for (int i = 0; i < layout->intervals; i++)
        if (layout->interval[i].variable == INTERVAL_ROOT && has_quantity(&layout->interval[i], eps) &&
            f->samples[i].known)
            s->hi = fmax(s->hi, layout->interval[i].hi);
    if (interpolant_last(f, eps, INTERVAL_LOG) > -HUGE_VAL && !is_beyond_root(s, s->hi, wanted)) {
        s->variable = INTERVAL_LOG;
        s->lo = (double)layout->root * log(s->hi);
        s->hi = interpolant_last(f, eps, INTERVAL_LOG);
        if (interpolant_last(f, eps, INTERVAL_BELOW) > -HUGE_VAL && !is_beyond_root(s, s->hi, wanted)) {
            s->variable = INTERVAL_BELOW;
            s->hi = log(ball_middle(f->threshold) - exp(s->hi));
            s->lo = HUGE_VAL;
            for (int i = 0; i < layout->intervals; i++)
                if (layout->interval[i].variable == INTERVAL_BELOW && has_quantity(&layout->interval[i], eps))
                    s->lo = fmin(s->lo, layout->interval[i].lo);
        }
    }
}

int interpolant_inverse(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t x, slong prec)
{
    static const enum quantity function[] = {[BETA_ZERO_OVERLAP] = EPS_ZERO_OVERLAP,
                                             [BETA_ZERO_FORCE] = EPS_ZERO_FORCE,
                                             [BETA_QUOTIENT_ZERO_OVERLAP] = LOSS_QUOTIENT_ZERO_OVERLAP,
                                             [BETA_QUOTIENT_ZERO_FORCE] = LOSS_QUOTIENT_ZERO_FORCE,
                                             [BETA_APPROACH_ONLY] = EPS_APPROACH_ONLY,
                                             [BETA_QUOTIENT_APPROACH_ONLY] = LOSS_QUOTIENT_APPROACH_ONLY};
    struct search s = {.f = f,
                       .prec = SEARCH_BITS,
                       .function = function[quantity],
                       .of_loss = quantity == BETA_QUOTIENT_ZERO_OVERLAP || quantity == BETA_QUOTIENT_ZERO_FORCE ||
                                  quantity == BETA_QUOTIENT_APPROACH_ONLY};
    LOCAL(arb, w, wanted);
    if (s.of_loss)
        arb_root_ui(wanted, x, (ulong)f->layout->root, INTERPOLANT_BITS);
    else
        arb_log(wanted, x, INTERPOLANT_BITS);
    choose_stretch(&s, wanted);
    const int status = solve_search(w, &s, wanted);
    if (s.of_loss) { /* invert (1 - eps)/beta, which has a limit at beta = 0 */
        interpolant_at(y, f, s.function, s.variable, w, prec);
        arb_inv(y, y, prec);
    } else {
        interpolant_beta(y, f, s.variable, w, prec);
    }
    return status;
}
