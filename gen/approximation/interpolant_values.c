/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "approximation/interpolant_parts.h"
#include "enclosure/collision.h"
#include "series/restitution.h"
#include "support/console.h"
#include "support/local.h"

enum {
    CHECK_BITS = 70,     /* bits of the collisions in interpolant_check */
    CONSTANT_BITS = 200, /* bits of beta_c and v_f */
    BACKWARD_ORDER = 24  /* order of the series G and T (restitution.h), whose argument is below 1/8 */
};

/* Evaluates the polynomial through the samples of interval i at x. */
static void polynomial_at(arb_t y, const struct interpolant *f, int i, enum quantity quantity, const arb_t x,
                          slong prec)
{
    const struct interval *const interval = &f->layout->interval[i];
    const arb_poly_struct *const p = &f->samples[i].polynomial[quantity];
    LOCAL(arb, t, at, slope, rough);
    LOCAL(mag, radius);
    unit_place(t, x, interval->lo, interval->hi, prec + INTERPOLANT_GUARD);
    /* evaluate p at the middle of t, and bound its slope; powers of the ball t would be far wider */
    arb_get_mid_arb(at, t);
    arb_poly_evaluate(y, p, at, prec + INTERPOLANT_GUARD);
    arb_poly_evaluate2(rough, slope, p, t, INTERPOLANT_GUARD);
    arb_get_mag(radius, slope);
    mag_mul(radius, radius, arb_radref(t));
    arb_add_error_mag(y, radius);
}

/* Returns the index of the interval at x among the intervals of a variable that sample the quantity. Beyond the last of
 * them it returns the last, and -1 if none exists. scaled_only: only intervals of FORM_POWER count. */
static int interval_at(const struct interpolant *f, enum quantity quantity, enum interval_variable variable,
                       const arb_t x, bool scaled_only)
{
    const double at = ball_middle(x);
    int found = -1;
    for (int i = 0; i < f->layout->intervals; i++) {
        const struct interval *interval = &f->layout->interval[i];
        if (interval->variable != variable || !has_quantity(interval, quantity) ||
            (scaled_only && interval->form != FORM_POWER))
            continue;
        found = i;
        if (at <= interval->hi)
            break;
    }
    return found;
}

/* Computes the quantity, or (1 - eps)/beta, from the number that an interval stores. */
static void restore_quantity(arb_t y, const struct interpolant *f, enum quantity stored, bool loss,
                             enum interval_form form, enum interval_variable variable, const arb_t x, slong prec)
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

/* Computes a quantity of zero force from zero overlap near beta = 0 (docs/theory.md, 5 and 9). eps is multiplied by
 * G(w), and the duration is reduced by eps^((1-a)/(1+a)) h^(1/(a-b)) T(w), where h = beta eps^q and w =
 * h^((a+1)/(a-b)). The loss quotient needs only G - 1. */
static void set_way_back(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t x, slong prec)
{
    const struct ratio a = law_elastic(&f->layout->law), b = law_damping(&f->layout->law),
                       q = law_speed_exponent(&f->layout->law);
    LOCAL(arb, beta, eps, h, w, part);
    interpolant_beta(beta, f, INTERVAL_ROOT, x, prec);
    interpolant_at(eps, f, EPS_ZERO_OVERLAP, INTERVAL_ROOT, x, prec);
    const bool elastic = arb_is_zero(beta); /* then h = w = 0 */
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

/* Computes a quantity with damping during the approach only. The rebound is elastic: eps^2/2 = X^(a+1)/(a+1) with the
 * largest overlap X. The rebound takes half as long as an elastic collision at the impact speed eps. To first order in
 * beta the loss is half of the full loss, because approach and rebound lose equal parts. */
static void approach_only(arb_t y, const struct interpolant *f, enum quantity quantity, enum interval_variable variable,
                          const arb_t x, slong prec)
{
    const struct ratio a = law_elastic(&f->layout->law);
    LOCAL(arb, beta, eps, part, zero);
    interpolant_beta(beta, f, variable, x, prec);
    if (quantity == LOSS_QUOTIENT_APPROACH_ONLY && arf_cmpabs_2exp_si(arb_midref(beta), -90) < 0) {
        /* beta is small, so terms of the next order are negligible */
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
        polynomial_at(y, f, i, stored, x, prec);
        form = f->layout->interval[i].form;
    } else if (stored == EPS_ZERO_OVERLAP) { /* for q = 0, eps = exp(-pi beta/sqrt(beta_c^2 - beta^2)) */
        LOCAL(arb, beta);
        interpolant_beta(beta, f, variable, x, prec);
        LET(y, prec, "-(pi*beta/sqrt(f->threshold^2 - beta^2))", beta, f->threshold);
    } else {
        set_way_back(y, f, quantity, x, prec);
        return;
    }
    restore_quantity(y, f, stored, quantity != stored, form, variable, x, prec);
}

void interpolant_tail(arb_t y, const struct interpolant *f, enum quantity quantity, enum interval_variable variable,
                      const arb_t x, slong prec)
{
    quantity = interpolant_end(f, quantity);
    const int i = interval_at(f, quantity, variable, x, variable == INTERVAL_LOG);
    const enum interval_form form = f->layout->interval[i].form;
    polynomial_at(y, f, i, quantity, x, prec);
    if (form != FORM_POWER)
        restore_quantity(y, f, quantity, false, form, variable, x, prec);
}

/* ---- the quantity at any beta ---- */

double interpolant_last(const struct interpolant *f, enum quantity quantity, enum interval_variable variable)
{
    double last = -HUGE_VAL;
    for (int i = 0; i < f->layout->intervals; i++)
        if (f->layout->interval[i].variable == variable && has_quantity(&f->layout->interval[i], quantity))
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
        (!has_quantity(&layout->interval[0], stored) && b <= pow(layout->interval[0].hi, (double)layout->root))) {
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

arb_srcptr interpolant_far(const struct interpolant *f, enum quantity quantity)
{
    return f->far[interpolant_end(f, quantity)];
}

/* ---- construction ---- */

static int make_constants(struct interpolant *f, double beta_max)
{
    const struct cor_exponents *law = &f->layout->law;
    arb_pos_inf(f->threshold);
    if (f->layout->press)
        return STATUS_OK;
    if (law_fall_power(law).num <= 0) {
        LOCAL(arb, height);
        const int status = collision_threshold(f->threshold, height, law, INTERPOLANT_BITS);
        arb_get_mid_arb(f->threshold, f->threshold); /* v = ln(beta_c - beta) needs an exact beta_c */
        return status;
    }
    const double root_end = pow(fmax(interpolant_last(f, EPS_ZERO_OVERLAP, INTERVAL_ROOT), 0), (double)f->layout->root);
    const bool beyond_samples = beta_max >= fmax(root_end, exp(interpolant_last(f, EPS_ZERO_OVERLAP, INTERVAL_LOG)));
    return beyond_samples ? collision_final_speed(f->final_speed, law, CONSTANT_BITS) : STATUS_OK;
}

static int make_samples(struct interpolant *f, double beta_min, double beta_max)
{
    const struct interpolant_layout *const layout = f->layout;
    for (int i = 0; i < layout->intervals; i++) {
        /* sample the intervals that meet [beta_min, beta_max], and the last interval of u, which the far coefficients
         * continue */
        const struct interval *const interval = &layout->interval[i];
        struct samples *const s = &f->samples[i];
        const double lo = interval->lo, hi = interval->hi;
        const double x = interpolant_beta_near(f, interval, lo), y = interpolant_beta_near(f, interval, hi);
        const bool continued = i == layout->intervals - 1 && interval->variable == INTERVAL_LOG;
        s->known = beta_max >= fmin(x, y) && (beta_min <= fmax(x, y) || continued);
        for (slong j = 0; j < interval->count && s->known; j++)
            interpolant_place(s->beta + j, s->node + j, f, interval,
                              (lo + hi) / 2 + (hi - lo) / 2 * chebyshev_point(j, interval->count));
    }
    const int status = samples_collide(f->samples, layout->intervals, f, layout->interval, "collisions");
    for (int i = 0; i < layout->intervals; i++)
        for (int q = 0; q < QUANTITIES && f->samples[i].known; q++)
            if (has_quantity(&layout->interval[i], (enum quantity)q))
                interpolant_through_samples(&f->samples[i].polynomial[q], &f->samples[i], &layout->interval[i],
                                            (enum quantity)q);
    return status;
}

struct interpolant *interpolant_new(const struct interpolant_layout *layout, double beta_min, double beta_max)
{
    struct interpolant *f = xmalloc(sizeof *f);
    f->layout = layout;
    f->samples = xmalloc((size_t)layout->intervals * sizeof *f->samples);
    for (int i = 0; i < layout->intervals; i++)
        samples_init(&f->samples[i], layout->interval[i].count);
    for (int q = 0; q < QUANTITIES; q++)
        f->far[q] = _arb_vec_init(INTERPOLANT_FAR);
    FOR_ALL(arb, init, f->fall, f->threshold, f->final_speed);
    FOR_ALL(arb_poly, init, f->backward, f->backward_time);

    int status = make_constants(f, beta_max);
    if (!layout->press && !has_quantity(&layout->interval[0], EPS_ZERO_FORCE) && law_force_ends(&layout->law)) {
        LOCAL(fmpq_poly, G, T); /* the first interval has no samples of eps at zero force */
        restitution_zero_force_exact(G, T, BACKWARD_ORDER, &layout->law);
        arb_poly_set_fmpq_poly(f->backward, G, INTERPOLANT_BITS);
        arb_poly_set_fmpq_poly(f->backward_time, T, INTERPOLANT_BITS);
    }
    if (status == STATUS_OK)
        status = make_samples(f, beta_min, beta_max);
    const struct interval *last = &layout->interval[layout->intervals - 1];
    if (status == STATUS_OK && layout->far && beta_max > exp(last->hi))
        status = interpolant_make_far(f);
    if (status == STATUS_OK)
        return f;
    interpolant_free(f);
    return NULL;
}

void interpolant_free(struct interpolant *f)
{
    if (!f)
        return;
    for (int i = 0; i < f->layout->intervals; i++)
        samples_clear(&f->samples[i], f->layout->interval[i].count);
    free(f->samples);
    for (int q = 0; q < QUANTITIES; q++)
        _arb_vec_clear(f->far[q], INTERPOLANT_FAR);
    FOR_ALL(arb, clear, f->fall, f->threshold, f->final_speed);
    FOR_ALL(arb_poly, clear, f->backward, f->backward_time);
    free(f);
}

/* Returns the relative error of the polynomial at sample k of interval i. */
static double error_at(const struct interpolant *f, int i, enum quantity quantity, const struct samples *s, slong k)
{
    const arb_srcptr known = s->value[quantity] + k;
    LOCAL(arb, y);
    polynomial_at(y, f, i, quantity, s->node + k, INTERPOLANT_BITS);
    if (f->layout->interval[i].form == FORM_LOG && is_eps(quantity))
        LET(y, INTERPOLANT_BITS, "y - known", y, known); /* the relative error of a number is the absolute error of its
                                                          * logarithm */
    else
        LET(y, INTERPOLANT_BITS, "y/known - 1", y, known);
    return fabs(arf_get_d(arb_midref(y), ARF_RND_UP));
}

/* The checked places include the ends of an interval, where interpolation is worst. */
int interpolant_check(double *error, const struct interpolant *f, int points)
{
    const int intervals = f->layout->intervals;
    struct samples *const s = xmalloc((size_t)intervals * sizeof *s);
    struct interval *const checked = xmalloc((size_t)intervals * sizeof *checked);
    for (int i = 0; i < intervals; i++) {
        const struct interval *const interval = &f->layout->interval[i];
        checked[i] = *interval;
        checked[i].count = points;
        checked[i].bits = CHECK_BITS;
        samples_init(&s[i], points);
        s[i].known = f->samples[i].known;
        for (slong k = 0; k < points; k++) {
            const bool at_zero = k == 0 && interval->variable == INTERVAL_ROOT && interval->lo == 0;
            const double place = at_zero ? 1e-6 : (double)k / (points - 1);
            interpolant_place(s[i].beta + k, s[i].node + k, f, interval,
                              interval->lo + (interval->hi - interval->lo) * place);
        }
    }
    const int status = samples_collide(s, intervals, f, checked, "collisions to check with");
    *error = 0;
    for (int i = 0; i < intervals; i++) {
        for (int q = 0; q < QUANTITIES && s[i].known; q++)
            for (slong k = 0; k < points && has_quantity(&checked[i], (enum quantity)q); k++)
                *error = fmax(*error, error_at(f, i, (enum quantity)q, &s[i], k));
        samples_clear(&s[i], points);
    }
    free(checked);
    free(s);
    return status;
}
