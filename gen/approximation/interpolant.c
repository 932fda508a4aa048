/* SPDX-License-Identifier: MIT */
#include "approximation/interpolant.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "approximation/barycentric.h"
#include "enclosure/collision.h"
#include "series/restitution.h"
#include "support/console.h"
#include "support/local.h"
#include "support/parallel.h"

enum {
    WORKING_BITS = 320,
    FAR_BITS = 112,
    SOLVING_BITS = 960, /* for the linear equations of the far coefficients, which may be ill-conditioned */
    GUARD_BITS = 16,
    CONSTANT_BITS = 200, /* of beta_c and v_f */
    BACKWARD_ORDER = 24  /* of order of G and T, which are used for w below 1/8 */
};

/* At strong damping zero overlap is expensive, but has a closed form except for the duration. Zero overlap is singular
 * near 1.7 + 0.45 i, so the ellipse around the third interval would prove too little. The two intervals after it cover
 * the same range; all values still come from the first. */
static const struct interval sphere_intervals[] = {
    {INTERVAL_ROOT, 0, 0.625, 40, 90, FORM_QUOTIENT, SET_ALL},
    {INTERVAL_ROOT, 0.625, 1.25, 40, 90, FORM_VALUE, SET_ALL},
    {INTERVAL_ROOT, 1.25, 1.875, 40, 90, FORM_VALUE, SET_ALL},
    {INTERVAL_ROOT, 1.25, 1.5625, 36, 90, FORM_VALUE, SET_ALL},
    {INTERVAL_ROOT, 1.5625, 1.875, 44, 90, FORM_VALUE, SET_ALL},
    {INTERVAL_ROOT, 1.875, 2.375, 40, 90, FORM_VALUE, SET_ALL},
    {INTERVAL_ROOT, 2.375, 2.875, 40, 90, FORM_VALUE, SET_ALL},
    {INTERVAL_ROOT, 2.875, 4.125, 40, 90, FORM_VALUE, SET_LENGTHS | SET_ZERO_FORCE},
    {INTERVAL_LOG, 2, 10, 52, 76, FORM_POWER, SET_LENGTHS | SET_ZERO_FORCE | 1 << DURATION_ZERO_OVERLAP},
};
const struct interpolant_layout interpolant_sphere_proof = {.law = {{3, 2}, {1, 2}, 2, 3, 1},
                                                            .root = 2,
                                                            .interval = sphere_intervals,
                                                            .intervals =
                                                                sizeof sphere_intervals / sizeof *sphere_intervals,
                                                            .far = true};

struct samples {
    bool known;
    arb_ptr beta, node, weight, value[QUANTITIES];
};

struct interpolant {
    const struct interpolant_layout *layout;
    struct samples *samples;
    arb_struct far[QUANTITIES][INTERPOLANT_FAR];
    arb_t fall;                         /* interpolant_far_fall */
    arb_t threshold, final_speed;       /* beta_c for q < 0 and q = 0, v_f for q > 0; else infinite, 0 */
    arb_poly_t backward, backward_time; /* G and T, if an interval computes zero force from them */
};

const struct law *interpolant_law(const struct interpolant *f)
{
    return &f->layout->law;
}

const struct interpolant_layout *interpolant_layout_of(const struct interpolant *f)
{
    return f->layout;
}

bool interpolant_samples(arb_srcptr *node, arb_srcptr *value, const struct interpolant *f, int i,
                         enum quantity quantity)
{
    *node = f->samples[i].node;
    *value = f->samples[i].value[quantity];
    return f->samples[i].known;
}

slong interpolant_root(const struct interpolant *f)
{
    return f->layout->root;
}

const arb_struct *interpolant_final_speed(const struct interpolant *f)
{
    return f->final_speed;
}

const arb_struct *interpolant_threshold(const struct interpolant *f)
{
    return f->threshold;
}

/* ---- the sampled quantities ---- */

static bool is_eps(enum quantity quantity)
{
    return quantity == EPS_ZERO_OVERLAP || quantity == EPS_ZERO_FORCE;
}

static bool holds(const struct interval *interval, enum quantity quantity)
{
    return interval->set & 1u << quantity;
}

/* Powers of beta that the quantities follow for large beta. A duration at zero overlap is mainly the creep along the
 * slow manifold or, if a - b > 1, the end of the creep. */
struct ratio interpolant_tail_power(const struct law *law, enum quantity quantity)
{
    const struct ratio one = {1, 1}, minus = {-1, 1}, b1 = ratio_add(law->b, one);
    switch (quantity) {
    case EPS_ZERO_OVERLAP:
        return ratio_div(minus, law_speed_exponent(law));
    case EPS_ZERO_FORCE:
        return ratio_mul(minus, law_mu_power(law));
    case DURATION_ZERO_OVERLAP:
        return ratio_sub(ratio_sub(law->a, law->b), one).num > 0
                   ? ratio_div(ratio_sub(law->a, one), law_fall_power(law))
                   : ratio_div(law->a, b1);
    default:
        return ratio_div(minus, b1);
    }
}

/* beta^power at beta = exp(u) */
static void power_of(arb_t y, const arb_t u, struct ratio power, slong prec)
{
    arb_mul_si(y, u, power.num, prec);
    arb_div_ui(y, y, (ulong)power.den, prec);
    arb_exp(y, y, prec);
}

/* q = 0: eps at zero overlap, exp(-pi beta/sqrt(beta_c^2 - beta^2)), and its logarithm */
static void linear_log_eps(arb_t y, const struct interpolant *f, const arb_t beta, slong prec)
{
    LOCAL(arb, square);
    arb_sqr(square, f->threshold, prec);
    arb_sqr(y, beta, prec);
    arb_sub(square, square, y, prec);
    arb_sqrt(square, square, prec);
    arb_const_pi(y, prec);
    arb_mul(y, y, beta, prec);
    arb_div(y, y, square, prec);
    arb_neg(y, y);
}

static arb_srcptr field(const struct collision *c, enum quantity quantity)
{
    const arb_srcptr fields[QUANTITIES] = {c->eps_zero_overlap, c->eps_zero_force, c->t_zero_overlap,
                                           c->t_zero_force,     c->x_max,          c->t_max};
    return fields[quantity];
}

/* The number that an interval stores for a collision */
static void scaled(arb_t y, const struct law *law, const struct interval *interval, enum quantity quantity,
                   const struct collision *c, const arb_t beta, slong prec)
{
    arb_set(y, field(c, quantity));
    if (interval->form == FORM_POWER && interval->variable == INTERVAL_BELOW) {
        const struct ratio one = {1, 1};
        LOCAL(arb, power);
        arb_pow_ratio(power, c->eps_zero_overlap, ratio_div(ratio_sub(law->a, one), ratio_add(law->a, one)), prec);
        arb_mul(y, y, power, prec);
        return;
    }
    if (interval->form == FORM_QUOTIENT && is_eps(quantity)) {
        arb_sub_ui(y, y, 1, prec);
        arb_neg(y, y);
        arb_div(y, y, beta, prec);
    } else if (interval->form == FORM_LOG && is_eps(quantity)) {
        arb_log(y, y, prec);
    } else if (interval->form == FORM_POWER) {
        LOCAL(arb, power);
        arb_pow_ratio(power, beta, interpolant_tail_power(law, quantity), prec);
        arb_div(y, y, power, prec);
    }
}

/* An exact beta near the place x of an interval, and the value of the variable there. The width of an inexact beta
 * would grow a thousandfold in a strongly damped collision. */
static void place(arb_t beta, arb_t variable, const struct interpolant *f, const struct interval *interval, double x)
{
    const int bits = interval->variable == INTERVAL_LOG && x >= 2 ? 20 : 40;
    switch (interval->variable) {
    case INTERVAL_LOG:
        arb_set_d(beta, nearbyint(ldexp(exp(x), bits)));
        arb_mul_2exp_si(beta, beta, -bits);
        arb_log(variable, beta, WORKING_BITS);
        break;
    case INTERVAL_ROOT:
        arb_set_d(variable, nearbyint(ldexp(x, bits)));
        arb_mul_2exp_si(variable, variable, -bits);
        arb_pow_ui(beta, variable, (ulong)f->layout->root, WORKING_BITS);
        break;
    case INTERVAL_BELOW:
        arb_set_d(variable, exp(x));
        arb_sub(beta, f->threshold, variable, WORKING_BITS);
        arb_get_mid_arb(beta, beta);
        arb_sub(variable, f->threshold, beta, WORKING_BITS);
        arb_log(variable, variable, WORKING_BITS);
        break;
    }
}

/* Computes all numbers that an interval stores for the collision at an exact beta, each to at least `bits` bits. */
static int interval_solve(arb_ptr value, const struct interpolant *f, const struct interval *interval, const arb_t beta,
                          slong bits)
{
    struct collision c;
    collision_init(&c);
    const struct law *law = &f->layout->law;
    const slong prec = bits + 3 * GUARD_BITS;
    slong more = GUARD_BITS;
    if (interval->form == FORM_QUOTIENT)
        more += FLINT_MAX(0, -(slong)arf_abs_bound_lt_2exp_si(arb_midref(beta)) + 1);
    const bool overlap = interval->set & SET_ZERO_OVERLAP, force = interval->set & SET_ZERO_FORCE;
    const int status = overlap && force ? collision_solve(&c, beta, law, bits + more)
                       : overlap        ? collision_solve_overlap(&c, beta, law, bits + more)
                                        : collision_solve_force(&c, beta, law, bits + more);
    for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++)
        if (holds(interval, (enum quantity)q))
            scaled(value + q, law, interval, (enum quantity)q, &c, beta, prec + more);
    collision_clear(&c);
    return status;
}

/* The same, rounded to `bits` bits, as exact numbers */
static int solve_rounded(arb_ptr value, const struct interpolant *f, const struct interval *interval, const arb_t beta,
                         slong bits)
{
    for (slong extra = 0; extra < 200; extra += 40) {
        bool decided = true;
        if (interval_solve(value, f, interval, beta, bits + extra))
            return STATUS_FAILED;
        for (int q = 0; q < QUANTITIES; q++)
            if (holds(interval, (enum quantity)q))
                decided = sample_rounded(value + q, value + q, bits) && decided;
        if (decided)
            return STATUS_OK;
    }
    return fail("a sample of the collision could not be rounded to %ld bits", (long)bits);
}

/* Sets the Chebyshev points and the barycentric weights. */
static void place_nodes(struct samples *s, const struct interpolant *f, const struct interval *interval)
{
    const slong n = interval->count;
    for (slong j = 0; j < n; j++)
        place(s->beta + j, s->node + j, f, interval,
              (interval->lo + interval->hi) / 2 + (interval->hi - interval->lo) / 2 * chebyshev_point(j, n));
    barycentric_weights(s->weight, s->node, n, WORKING_BITS);
}

/* ---- values ---- */

/* The polynomial through the samples, at x. */
static void evaluate(arb_t y, const struct interpolant *f, int i, enum quantity quantity, const arb_t x, slong prec)
{
    const struct samples *s = &f->samples[i];
    barycentric_value(y, s->node, s->weight, s->value[quantity], f->layout->interval[i].count, x, prec);
}

/* The first interval of a variable that samples the quantity and does not end before x, or the last such interval, or
 * -1. If `scaled`, only intervals of FORM_POWER count. */
static int interval_at(const struct interpolant *f, enum quantity quantity, enum interval_variable variable,
                       const arb_t x, bool scaled_only)
{
    const double at = arf_get_d(arb_midref(x), ARF_RND_NEAR);
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

/* beta at a place of a variable */
static void beta_at(arb_t beta, const struct interpolant *f, enum interval_variable variable, const arb_t x, slong prec)
{
    if (variable == INTERVAL_ROOT) {
        arb_pow_ui(beta, x, (ulong)f->layout->root, prec);
    } else {
        arb_exp(beta, x, prec);
        if (variable == INTERVAL_BELOW)
            arb_sub(beta, f->threshold, beta, prec);
    }
}

/* The quantity from the number that its interval stores */
static void unscaled(arb_t y, const struct interpolant *f, const struct interval *interval, enum quantity quantity,
                     const arb_t x, slong prec)
{
    LOCAL(arb, scale);
    if (interval->form == FORM_VALUE || (interval->form != FORM_POWER && !is_eps(quantity)))
        return;
    if (interval->form == FORM_QUOTIENT) {
        for (slong k = 0; k < f->layout->root; k++)
            arb_mul(y, y, x, prec);
        arb_sub_ui(y, y, 1, prec);
        arb_neg(y, y);
    } else if (interval->form == FORM_LOG) {
        arb_exp(y, y, prec);
    } else {
        power_of(scale, x, interpolant_tail_power(&f->layout->law, quantity), prec);
        arb_mul(y, y, scale, prec);
    }
}

/* (1 - eps)/beta from the number that the interval stores for eps */
static void loss_quotient(arb_t y, const struct interpolant *f, const struct interval *interval, enum quantity eps,
                          const arb_t x, slong prec)
{
    if (interval->form == FORM_QUOTIENT)
        return;
    if (interval->form == FORM_LOG) {
        arb_expm1(y, y, prec);
    } else {
        unscaled(y, f, interval, eps, x, prec);
        arb_sub_ui(y, y, 1, prec);
    }
    arb_neg(y, y);
    if (interval->variable == INTERVAL_ROOT) {
        for (slong k = 0; k < f->layout->root; k++)
            arb_div(y, y, x, prec);
    } else {
        LOCAL(arb, beta);
        beta_at(beta, f, interval->variable, x, prec);
        arb_div(y, y, beta, prec);
    }
}

/* Zero force from zero overlap, near beta = 0: eps G(w), and the duration less eps^((1-a)/(1+a)) h^(1/(a-b)) T(w), h =
 * beta eps^q, w = h^((a+1)/(a-b)) (docs/derivation.md, 5 and 9). The loss quotient needs only G - 1. */
static void backward(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t x, slong prec)
{
    const struct law *law = &f->layout->law;
    const struct ratio one = {1, 1}, a1 = ratio_add(law->a, one), difference = ratio_sub(law->a, law->b);
    const bool loss = quantity == LOSS_QUOTIENT_ZERO_FORCE;
    LOCAL(arb, beta, eps, h, w, part);
    beta_at(beta, f, INTERVAL_ROOT, x, prec);
    interpolant_value(eps, f, EPS_ZERO_OVERLAP, x, prec);
    arb_pow_ratio(h, eps, law_speed_exponent(law), prec);
    arb_mul(h, h, beta, prec);
    if (arb_is_zero(beta))
        arb_zero(w);
    else
        arb_pow_ratio(w, h, ratio_div(a1, difference), prec);
    if (quantity == DURATION_ZERO_FORCE) {
        arb_poly_evaluate(part, f->backward_time, w, prec);
        if (arb_is_zero(beta))
            arb_zero(h);
        else
            arb_pow_ratio(h, h, ratio_div(one, difference), prec);
        arb_mul(part, part, h, prec);
        arb_pow_ratio(w, eps, ratio_div(ratio_sub(one, law->a), a1), prec);
        arb_mul(part, part, w, prec);
        interpolant_value(y, f, DURATION_ZERO_OVERLAP, x, prec);
        arb_sub(y, y, part, prec);
    } else if (loss) {
        /* (1 - eps G)/beta = (1 - eps)/beta - eps (G - 1)/beta */
        arb_poly_evaluate(part, f->backward, w, prec);
        arb_sub_ui(part, part, 1, prec);
        arb_mul(part, part, eps, prec);
        if (!arb_is_zero(beta))
            arb_div(part, part, beta, prec);
        interpolant_value(y, f, LOSS_QUOTIENT_ZERO_OVERLAP, x, prec);
        arb_sub(y, y, part, prec);
    } else {
        arb_poly_evaluate(part, f->backward, w, prec);
        arb_mul(y, eps, part, prec);
    }
}

/* For a <= b the two ends of contact coincide. */
static enum quantity one_end(const struct interpolant *f, enum quantity quantity)
{
    if (law_force_ends(&f->layout->law))
        return quantity;
    switch (quantity) {
    case EPS_ZERO_FORCE:
        return EPS_ZERO_OVERLAP;
    case DURATION_ZERO_FORCE:
        return DURATION_ZERO_OVERLAP;
    case LOSS_QUOTIENT_ZERO_FORCE:
        return LOSS_QUOTIENT_ZERO_OVERLAP;
    default:
        return quantity;
    }
}

void interpolant_at(arb_t y, const struct interpolant *f, enum quantity quantity, enum interval_variable variable,
                    const arb_t x, slong prec)
{
    quantity = one_end(f, quantity);
    const bool loss = quantity == LOSS_QUOTIENT_ZERO_OVERLAP || quantity == LOSS_QUOTIENT_ZERO_FORCE;
    const enum quantity stored = quantity == LOSS_QUOTIENT_ZERO_OVERLAP ? EPS_ZERO_OVERLAP
                                 : quantity == LOSS_QUOTIENT_ZERO_FORCE ? EPS_ZERO_FORCE
                                                                        : quantity;
    const int i = interval_at(f, stored, variable, x, false);
    if (i < 0 && stored == EPS_ZERO_OVERLAP) { /* q = 0 */
        LOCAL(arb, beta);
        beta_at(beta, f, variable, x, prec);
        linear_log_eps(y, f, beta, prec);
        (loss ? arb_expm1 : arb_exp)(y, y, prec);
        if (loss) {
            arb_neg(y, y);
            arb_div(y, y, beta, prec);
        }
        return;
    }
    if (i < 0) {
        backward(y, f, quantity, x, prec);
        return;
    }
    evaluate(y, f, i, stored, x, prec);
    if (loss)
        loss_quotient(y, f, &f->layout->interval[i], stored, x, prec);
    else
        unscaled(y, f, &f->layout->interval[i], stored, x, prec);
}

void interpolant_value(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t z, slong prec)
{
    interpolant_at(y, f, quantity, INTERVAL_ROOT, z, prec);
}

void interpolant_tail(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t u, slong prec)
{
    quantity = one_end(f, quantity);
    evaluate(y, f, interval_at(f, quantity, INTERVAL_LOG, u, true), quantity, u, prec);
}

void interpolant_below(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t v, slong prec)
{
    const int i = interval_at(f, quantity, INTERVAL_BELOW, v, false);
    evaluate(y, f, i, quantity, v, prec);
    if (f->layout->interval[i].form != FORM_POWER)
        unscaled(y, f, &f->layout->interval[i], quantity, v, prec);
}

/* ---- beyond the last interval ---- */

void interpolant_far(arb_ptr coefficient, const struct interpolant *f, enum quantity quantity)
{
    for (int k = 0; k < INTERPOLANT_FAR; k++)
        arb_set(coefficient + k, &f->far[one_end(f, quantity)][k]);
}

void interpolant_far_fall(arb_t coefficient, const struct interpolant *f)
{
    arb_set(coefficient, f->fall);
}

/* 1, u; mu, mu u, mu u^2; mu^2, mu^2 u, mu^2 u^2, mu^2 u^3 */
static void far_basis(arb_mat_t a, slong row, const arb_t u, const struct law *law, slong prec)
{
    const struct ratio power = law_mu_power(law);
    LOCAL(arb, mu, term);
    arb_mul_si(mu, u, -power.num, prec);
    arb_div_ui(mu, mu, (ulong)power.den, prec);
    arb_exp(mu, mu, prec);
    slong column = 0;
    for (slong order = 0; order < 3; order++) {
        arb_pow_ui(term, mu, (ulong)order, prec);
        for (slong exponent = 0; exponent <= order + 1; exponent++) {
            arb_set(arb_mat_entry(a, row, column++), term);
            arb_mul(term, term, u, prec);
        }
    }
}

/* Whether the duration at zero overlap has a term beta^((a-1)/n) that is not among beta^(a/(b+1)) mu^i: kappa =
 * (b-a+1)/n is neither 0 nor 1. The sphere's is 0. */
static bool falls_apart(const struct law *law)
{
    const struct ratio n = law_fall_power(law);
    if (n.num <= 0)
        return false;
    const struct ratio kappa = ratio_div(ratio_add(ratio_sub(law->b, law->a), (struct ratio){1, 1}), n);
    return kappa.num != 0 && !(kappa.num == 1 && kappa.den == 1);
}

/* The exponent of beta of the sum over mu^i u^j, or of the fall's constant, minus that of the leading power */
static struct ratio far_excess(const struct law *law, bool fall)
{
    const struct ratio one = {1, 1};
    const struct ratio own =
        fall ? ratio_div(ratio_sub(law->a, one), law_fall_power(law)) : ratio_div(law->a, ratio_add(law->b, one));
    return ratio_sub(own, interpolant_tail_power(law, DURATION_ZERO_OVERLAP));
}

/* u of sample k: 9.5, 10, ... for spheres, larger if mu falls more slowly */
static double far_place(const struct law *law, slong k)
{
    const struct ratio power = law_mu_power(law);
    const double sphere = 5.0 / 3, own = (double)power.num / (double)power.den;
    return (9.5 + 0.5 * (double)k) * (own == sphere ? 1 : sphere / own);
}

static bool has_far(const struct interpolant *f, enum quantity quantity)
{
    const struct interpolant_layout *layout = f->layout;
    for (int i = 0; i < layout->intervals; i++)
        if (layout->interval[i].variable == INTERVAL_LOG && layout->interval[i].form == FORM_POWER &&
            holds(&layout->interval[i], quantity))
            return quantity != EPS_ZERO_OVERLAP;
    return false;
}

struct far_sampling {
    const struct interpolant *f;
    const struct interval *interval;
    arb_mat_struct *value; /* a row for each place */
    atomic_bool failed;
};

static void sample_far(void *context, slong k)
{
    struct far_sampling *const work = context;
    arb_ptr value = _arb_vec_init(QUANTITIES);
    LOCAL(arb, beta, u);
    place(beta, u, work->f, work->interval, far_place(&work->f->layout->law, k));
    if (solve_rounded(value, work->f, work->interval, beta, FAR_BITS) != STATUS_OK)
        atomic_store(&work->failed, true);
    for (int q = 0; q < QUANTITIES; q++)
        arb_set(arb_mat_entry(work->value, k, q), value + q);
    _arb_vec_clear(value, QUANTITIES);
}

/* Fits the coefficients to the same number of samples. */
static int make_far(struct interpolant *f)
{
    const struct law *law = &f->layout->law;
    struct interval interval = {INTERVAL_LOG, 0, 0, 0, FAR_BITS, FORM_POWER, 0};
    const slong columns = INTERPOLANT_FAR + (falls_apart(law) && has_far(f, DURATION_ZERO_OVERLAP));
    arb_mat_t a, b, own;
    LOCAL(arb, beta, u, excess);
    int status = STATUS_OK;
    for (int q = 0; q < QUANTITIES; q++)
        if (has_far(f, (enum quantity)q))
            interval.set |= 1u << q;
    arb_mat_init(a, INTERPOLANT_FAR, INTERPOLANT_FAR);
    arb_mat_init(own, columns, columns);
    arb_mat_init(b, columns, QUANTITIES);
    struct far_sampling work = {.f = f, .interval = &interval, .value = b};
    parallel_for(sample_far, &work, columns, "collisions at large beta");
    if (atomic_load(&work.failed))
        status = STATUS_FAILED;
    for (slong k = 0; k < columns; k++) {
        place(beta, u, f, &interval, far_place(law, k));
        arb_log(u, beta, SOLVING_BITS);
        far_basis(own, k, u, law, SOLVING_BITS);
        for (slong j = 0; j < INTERPOLANT_FAR && k < INTERPOLANT_FAR; j++)
            arb_set(arb_mat_entry(a, k, j), arb_mat_entry(own, k, j));
        if (columns > INTERPOLANT_FAR) {
            power_of(excess, u, far_excess(law, false), SOLVING_BITS);
            for (slong j = 0; j < INTERPOLANT_FAR; j++)
                arb_mul(arb_mat_entry(own, k, j), arb_mat_entry(own, k, j), excess, SOLVING_BITS);
            power_of(arb_mat_entry(own, k, INTERPOLANT_FAR), u, far_excess(law, true), SOLVING_BITS);
        }
    }
    arb_mat_t x, y;
    arb_mat_init(x, INTERPOLANT_FAR, QUANTITIES);
    arb_mat_init(y, columns, QUANTITIES);
    for (slong k = 0; k < INTERPOLANT_FAR; k++)
        for (int q = 0; q < QUANTITIES; q++)
            arb_set(arb_mat_entry(x, k, q), arb_mat_entry(b, k, q));
    if (status == STATUS_OK && (!arb_mat_solve(x, a, x, SOLVING_BITS) ||
                                (columns > INTERPOLANT_FAR && !arb_mat_solve(y, own, b, SOLVING_BITS))))
        status = fail("the far coefficients could not be solved for");
    for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++)
        for (int k = 0; k < INTERPOLANT_FAR; k++)
            arb_set(&f->far[q][k], q == DURATION_ZERO_OVERLAP && columns > INTERPOLANT_FAR ? arb_mat_entry(y, k, q)
                                                                                           : arb_mat_entry(x, k, q));
    if (columns > INTERPOLANT_FAR)
        arb_set(f->fall, arb_mat_entry(y, INTERPOLANT_FAR, DURATION_ZERO_OVERLAP));
    arb_mat_clear(a);
    arb_mat_clear(b);
    arb_mat_clear(own);
    arb_mat_clear(x);
    arb_mat_clear(y);
    return status;
}

/* The quantity at beta = exp(u) from the far coefficients */
static void far_value(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t u, slong prec)
{
    const struct law *law = &f->layout->law;
    LOCAL(arb, term, power);
    arb_mat_t basis;
    arb_mat_init(basis, 1, INTERPOLANT_FAR);
    far_basis(basis, 0, u, law, WORKING_BITS);
    arb_zero(y);
    for (slong k = 0; k < INTERPOLANT_FAR; k++)
        arb_addmul(y, arb_mat_entry(basis, 0, k), &f->far[quantity][k], prec);
    if (quantity == DURATION_ZERO_OVERLAP && !arb_is_zero(f->fall)) {
        power_of(power, u, far_excess(law, false), prec);
        arb_mul(y, y, power, prec);
        power_of(power, u, far_excess(law, true), prec);
        arb_addmul(y, f->fall, power, prec);
    }
    power_of(power, u, interpolant_tail_power(law, quantity), prec);
    arb_mul(y, y, power, prec);
    arb_mat_clear(basis);
}

/* ---- the quantity at any beta ---- */

/* The last place of a variable at which the quantity is sampled; if it is not sampled, a number below all places */
static double last_place(const struct interpolant *f, enum quantity quantity, enum interval_variable variable)
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
    quantity = one_end(f, quantity);
    const double b = arf_get_d(arb_midref(beta), ARF_RND_NEAR);
    const double root_end = pow(fmax(last_place(f, quantity, INTERVAL_ROOT), 0), (double)layout->root);
    const bool overlap = quantity == EPS_ZERO_OVERLAP || quantity == DURATION_ZERO_OVERLAP;
    LOCAL(arb, x);
    if (b <= root_end ||
        (!holds(&layout->interval[0], quantity) && b <= pow(layout->interval[0].hi, (double)layout->root))) {
        arb_root_ui(x, beta, (ulong)layout->root, prec);
        interpolant_at(y, f, quantity, INTERVAL_ROOT, x, prec);
    } else if (overlap && arb_is_finite(f->threshold) && b > exp(last_place(f, quantity, INTERVAL_LOG))) {
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
        if (log(b) <= last_place(f, quantity, INTERVAL_LOG)) {
            interpolant_at(y, f, quantity, INTERVAL_LOG, x, prec);
        } else if (quantity == EPS_ZERO_OVERLAP) {
            power_of(y, x, interpolant_tail_power(&layout->law, quantity), prec);
            arb_mul(y, y, f->final_speed, prec);
        } else {
            far_value(y, f, quantity, x, prec);
        }
    }
}

/* ---- the inverse ---- */

/* The search range of an inverse */
struct search {
    const struct interpolant *f;
    enum quantity eps, loss_quotient;
    bool of_loss;
    enum interval_variable variable;
    double lo, hi;
};

/* The function of w whose zero is the inverse, minus its value for the given number: the root of the loss, which has a
 * slope also at beta = 0; or ln(eps), because eps may fall by many powers of ten within an interval */
static void excess(arb_t y, const struct search *s, const arb_t w, const arb_t wanted)
{
    const slong prec = WORKING_BITS, root = s->f->layout->root;
    interpolant_at(y, s->f, s->of_loss ? s->loss_quotient : s->eps, s->variable, w, prec);
    if (s->of_loss) {
        if (s->variable == INTERVAL_ROOT) {
            arb_root_ui(y, y, (ulong)root, prec);
            arb_mul(y, y, w, prec);
        } else {
            LOCAL(arb, beta);
            beta_at(beta, s->f, s->variable, w, prec);
            arb_mul(y, y, beta, prec);
            arb_root_ui(y, y, (ulong)root, prec);
        }
    } else {
        arb_log(y, y, prec);
    }
    arb_sub(y, y, wanted, prec);
    arb_get_mid_arb(y, y);
}

/* Whether w is beyond the zero. The loss rises with beta, eps falls, and v falls with beta. */
static bool beyond(const struct search *s, double w, const arb_t wanted)
{
    LOCAL(arb, x, y);
    arb_set_d(x, w);
    excess(y, s, x, wanted);
    const int sign = arf_sgn(arb_midref(y));
    return (s->of_loss ? sign > 0 : sign < 0) != (s->variable == INTERVAL_BELOW);
}

/* Bisects to a short bracket and then applies the secant method. */
static int solve_search(arb_t w, struct search *s, const arb_t wanted)
{
    enum { HALVINGS = 5, STEPS = 18, ENOUGH_BITS = 110 };
    for (int k = 0; k < HALVINGS; k++) {
        const double middle = (s->lo + s->hi) / 2;
        if (beyond(s, middle, wanted))
            s->hi = middle;
        else
            s->lo = middle;
    }
    LOCAL(arb, before, f0, f1, step);
    arb_set_d(before, s->lo);
    arb_set_d(w, s->hi);
    excess(f0, s, before, wanted);
    bool found = false;
    for (int k = 0; k < STEPS && !found; k++) {
        excess(f1, s, w, wanted);
        arb_sub(f0, f1, f0, WORKING_BITS);
        arb_sub(step, w, before, WORKING_BITS);
        arb_set(before, w);
        found = arb_is_zero(f1);
        if (!found) {
            arb_mul(step, step, f1, WORKING_BITS);
            arb_div(step, step, f0, WORKING_BITS);
            arb_sub(w, w, step, WORKING_BITS);
            arb_get_mid_arb(w, w);
            arb_set(f0, f1);
            found = arf_cmpabs_2exp_si(arb_midref(step), -ENOUGH_BITS) < 0;
        }
    }
    return found ? STATUS_OK : fail("an inverse of the collision was not found");
}

/* The end of the last interval in the root of beta that holds samples of eps */
static double last_sampled_root(const struct interpolant *f, enum quantity eps)
{
    double last = f->layout->interval[0].hi;
    for (int i = 0; i < f->layout->intervals; i++) {
        const struct interval *const interval = &f->layout->interval[i];
        if (interval->variable == INTERVAL_ROOT && holds(interval, eps) && f->samples[i].known)
            last = fmax(last, interval->hi);
    }
    return last;
}

/* Chooses the first variable whose range reaches the zero. */
static void choose_stretch(struct search *s, const arb_t wanted)
{
    const struct interpolant *f = s->f;
    const struct interpolant_layout *layout = f->layout;
    const enum quantity eps = one_end(f, s->eps);
    s->variable = INTERVAL_ROOT;
    s->lo = 0;
    s->hi = last_sampled_root(f, eps);
    if (last_place(f, eps, INTERVAL_LOG) > -HUGE_VAL && !beyond(s, s->hi, wanted)) {
        s->variable = INTERVAL_LOG;
        s->lo = (double)layout->root * log(s->hi);
        s->hi = last_place(f, eps, INTERVAL_LOG);
        if (last_place(f, eps, INTERVAL_BELOW) > -HUGE_VAL && !beyond(s, s->hi, wanted)) {
            s->variable = INTERVAL_BELOW;
            s->hi = log(arf_get_d(arb_midref(f->threshold), ARF_RND_NEAR) - exp(s->hi));
            s->lo = HUGE_VAL;
            for (int i = 0; i < layout->intervals; i++)
                if (layout->interval[i].variable == INTERVAL_BELOW && holds(&layout->interval[i], eps))
                    s->lo = fmin(s->lo, layout->interval[i].lo);
        }
    }
}

int interpolant_inverse(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t x, slong prec)
{
    const bool force = quantity == BETA_ZERO_FORCE || quantity == BETA_QUOTIENT_ZERO_FORCE;
    struct search s = {.f = f,
                       .eps = force ? EPS_ZERO_FORCE : EPS_ZERO_OVERLAP,
                       .loss_quotient = force ? LOSS_QUOTIENT_ZERO_FORCE : LOSS_QUOTIENT_ZERO_OVERLAP,
                       .of_loss = quantity == BETA_QUOTIENT_ZERO_OVERLAP || quantity == BETA_QUOTIENT_ZERO_FORCE};
    LOCAL(arb, w, wanted);
    if (s.of_loss)
        arb_root_ui(wanted, x, (ulong)f->layout->root, WORKING_BITS);
    else
        arb_log(wanted, x, WORKING_BITS);
    choose_stretch(&s, wanted);
    const int status = solve_search(w, &s, wanted);
    if (s.of_loss) { /* (1 - eps)/beta has a limit at beta = 0 */
        interpolant_at(y, f, s.loss_quotient, s.variable, w, prec);
        arb_inv(y, y, prec);
    } else {
        beta_at(y, f, s.variable, w, prec);
    }
    return status;
}

/* e = mu (1 + mu q_1(u) + mu^2 q_2(u)), u = -(3/5) ln(mu), solved for beta = mu^(-3/5) in powers of e: to first order
 * (3/5) q_1(v), to second (9/25) (q_1 q_1' - 2 q_1^2) + (3/5) q_2. */
void interpolant_far_inverse(arb_ptr coefficient, const struct interpolant *f)
{
    const slong prec = WORKING_BITS;
    arb_srcptr far = f->far[EPS_ZERO_FORCE]; /* 1, u; mu (1, u, u^2); mu^2 (1, ..., u^3) */
    LOCAL(arb_poly, q1, q2, second);
    LOCAL(arb, c, d);
    for (slong k = 0; k < 3; k++)
        arb_poly_set_coeff_arb(q1, k, far + 2 + k);
    for (slong k = 0; k < 4; k++)
        arb_poly_set_coeff_arb(q2, k, far + 5 + k);
    arb_poly_scalar_div(q1, q1, far, prec);
    arb_poly_scalar_div(q2, q2, far, prec);
    arb_poly_derivative(second, q1, prec);
    arb_poly_sub(second, second, q1, prec);
    arb_poly_sub(second, second, q1, prec);
    arb_poly_mul(second, second, q1, prec);
    arb_set(coefficient, far);
    for (slong k = 0; k < INTERPOLANT_FAR_INVERSE - 1; k++) {
        const slong power = k < 3 ? k : k - 3;
        arb_poly_get_coeff_arb(c, k < 3 ? q1 : q2, power);
        arb_mul_ui(c, c, 15, prec);
        if (k >= 3) {
            arb_poly_get_coeff_arb(d, second, power);
            arb_addmul_ui(c, d, 9, prec);
        }
        arb_div_ui(coefficient + 1 + k, c, 25, prec);
    }
}

/* ---- construction ---- */

/* beta at a place of an interval, as a double */
static double beta_near(const struct interpolant *f, const struct interval *interval, double x)
{
    switch (interval->variable) {
    case INTERVAL_ROOT:
        return pow(x, (double)f->layout->root);
    case INTERVAL_LOG:
        return exp(x);
    default:
        return arf_get_d(arb_midref(f->threshold), ARF_RND_NEAR) - exp(x);
    }
}

/* Whether [beta_min, beta_max] meets an interval. The far coefficients continue the last u. */
static bool needed(const struct interpolant *f, const struct interval *interval, double beta_min, double beta_max)
{
    const double x = beta_near(f, interval, interval->lo), y = beta_near(f, interval, interval->hi);
    const bool last = interval == &f->layout->interval[f->layout->intervals - 1];
    return beta_max >= fmin(x, y) && (beta_min <= fmax(x, y) || (last && interval->variable == INTERVAL_LOG));
}

static int make_constants(struct interpolant *f, double beta_max)
{
    const struct law *law = &f->layout->law;
    const struct ratio n = law_fall_power(law);
    arb_pos_inf(f->threshold);
    if (n.num < 0) {
        LOCAL(arb, height);
        const int status = collision_threshold(f->threshold, height, law, WORKING_BITS);
        return status;
    }
    if (n.num == 0) {
        arb_set_ratio(f->threshold, ratio_mul((struct ratio){2, 1}, ratio_add(law->a, (struct ratio){1, 1})),
                      WORKING_BITS);
        arb_sqrt(f->threshold, f->threshold, WORKING_BITS);
        return STATUS_OK;
    }
    const double root_end = pow(fmax(last_place(f, EPS_ZERO_OVERLAP, INTERVAL_ROOT), 0), (double)f->layout->root);
    const bool beyond_samples = beta_max >= fmax(root_end, exp(last_place(f, EPS_ZERO_OVERLAP, INTERVAL_LOG)));
    return beyond_samples ? collision_final_speed(f->final_speed, law, CONSTANT_BITS) : STATUS_OK;
}

/* Computes G and T if the intervals near beta = 0 do not sample zero force. */
static void make_backward(struct interpolant *f)
{
    const struct interpolant_layout *layout = f->layout;
    if (holds(&layout->interval[0], EPS_ZERO_FORCE) || !law_force_ends(&layout->law))
        return;
    LOCAL(fmpq_poly, G, T);
    restitution_zero_force_exact(G, T, BACKWARD_ORDER, &layout->law);
    arb_poly_set_fmpq_poly(f->backward, G, WORKING_BITS);
    arb_poly_set_fmpq_poly(f->backward_time, T, WORKING_BITS);
}

static void samples_init(struct samples *s, slong count)
{
    s->known = false;
    s->beta = _arb_vec_init(count);
    s->node = _arb_vec_init(count);
    s->weight = _arb_vec_init(count);
    for (int q = 0; q < QUANTITIES; q++)
        s->value[q] = _arb_vec_init(count);
}

static void samples_clear(struct samples *s, slong count)
{
    _arb_vec_clear(s->beta, count);
    _arb_vec_clear(s->node, count);
    _arb_vec_clear(s->weight, count);
    for (int q = 0; q < QUANTITIES; q++)
        _arb_vec_clear(s->value[q], count);
}

/* The samples of all intervals that are needed, as tasks */
struct sampling {
    struct interpolant *f;
    struct {
        int interval;
        slong sample;
    } * task;
    slong tasks;
    atomic_bool failed;
};

static void sample(void *context, slong i)
{
    struct sampling *const work = context;
    const struct interval *const interval = &work->f->layout->interval[work->task[i].interval];
    struct samples *const s = &work->f->samples[work->task[i].interval];
    const slong j = work->task[i].sample;
    if (atomic_load(&work->failed))
        return;
    arb_ptr value = _arb_vec_init(QUANTITIES);
    if (solve_rounded(value, work->f, interval, s->beta + j, interval->bits) != STATUS_OK)
        atomic_store(&work->failed, true);
    for (int q = 0; q < QUANTITIES; q++)
        arb_set(s->value[q] + j, value + q);
    _arb_vec_clear(value, QUANTITIES);
}

static int make_samples(struct interpolant *f, double beta_min, double beta_max)
{
    const struct interpolant_layout *const layout = f->layout;
    struct sampling work = {.f = f};
    slong most = 0;
    for (int i = 0; i < layout->intervals; i++)
        most += layout->interval[i].count;
    work.task = xmalloc((size_t)most * sizeof *work.task);
    for (int i = layout->intervals - 1; i >= 0; i--) { /* the longest collisions first */
        f->samples[i].known = needed(f, &layout->interval[i], beta_min, beta_max);
        if (!f->samples[i].known)
            continue;
        place_nodes(&f->samples[i], f, &layout->interval[i]);
        for (slong j = layout->interval[i].count - 1; j >= 0; j--) {
            work.task[work.tasks].interval = i;
            work.task[work.tasks++].sample = j;
        }
    }
    parallel_for(sample, &work, work.tasks, "collisions");
    free(work.task);
    return atomic_load(&work.failed) ? STATUS_FAILED : STATUS_OK;
}

struct interpolant *interpolant_new(const struct interpolant_layout *layout, double beta_min, double beta_max)
{
    struct interpolant *f = xmalloc(sizeof *f);
    f->layout = layout;
    f->samples = xmalloc((size_t)layout->intervals * sizeof *f->samples);
    for (int i = 0; i < layout->intervals; i++)
        samples_init(&f->samples[i], layout->interval[i].count);
    for (int q = 0; q < QUANTITIES; q++)
        for (int k = 0; k < INTERPOLANT_FAR; k++)
            arb_init(&f->far[q][k]);
    arb_init(f->fall);
    arb_init(f->threshold);
    arb_init(f->final_speed);
    arb_poly_init(f->backward);
    arb_poly_init(f->backward_time);

    int status = make_constants(f, beta_max);
    make_backward(f);
    if (status == STATUS_OK)
        status = make_samples(f, beta_min, beta_max);
    const struct interval *last = &layout->interval[layout->intervals - 1];
    if (status == STATUS_OK && layout->far && beta_max > exp(last->hi))
        status = make_far(f);
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
        for (int k = 0; k < INTERPOLANT_FAR; k++)
            arb_clear(&f->far[q][k]);
    arb_clear(f->fall);
    arb_clear(f->threshold);
    arb_clear(f->final_speed);
    arb_poly_clear(f->backward);
    arb_poly_clear(f->backward_time);
    free(f);
}

/* The largest relative error of interval i at the place x */
static int check_place(double *error, const struct interpolant *f, int i, double x)
{
    const struct interval *interval = &f->layout->interval[i];
    arb_ptr value = _arb_vec_init(QUANTITIES);
    LOCAL(arb, beta, variable, y);
    place(beta, variable, f, interval, x);
    const int status = interval_solve(value, f, interval, beta, interval->bits);
    for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++) {
        if (!holds(interval, (enum quantity)q))
            continue;
        evaluate(y, f, i, (enum quantity)q, variable, WORKING_BITS);
        if (interval->form == FORM_LOG && is_eps((enum quantity)q)) {
            arb_sub(y, y, value + q, WORKING_BITS); /* for a logarithm the absolute error counts */
        } else {
            arb_div(y, y, value + q, WORKING_BITS);
            arb_sub_ui(y, y, 1, WORKING_BITS);
        }
        *error = fmax(*error, fabs(arf_get_d(arb_midref(y), ARF_RND_UP)));
    }
    _arb_vec_clear(value, QUANTITIES);
    return status;
}

struct checking {
    const struct interpolant *f;
    int points;
    double *error; /* of each task */
    atomic_bool failed;
};

/* Checks point i % points of interval i / points. The points include the ends, where interpolation is worst. */
static void check_point(void *context, slong i)
{
    struct checking *const work = context;
    const int index = (int)(i / work->points), k = (int)(i % work->points);
    const struct interval *const interval = &work->f->layout->interval[index];
    const double s = work->points > 1 ? k / (double)(work->points - 1) : 0;
    const bool at_zero = k == 0 && interval->variable == INTERVAL_ROOT && interval->lo == 0;
    work->error[i] = 0;
    if (work->f->samples[index].known &&
        check_place(&work->error[i], work->f, index,
                    interval->lo + (interval->hi - interval->lo) * (at_zero ? 1e-6 : s)))
        atomic_store(&work->failed, true);
}

int interpolant_check(double *error, const struct interpolant *f, int points)
{
    const slong tasks = (slong)f->layout->intervals * points;
    struct checking work = {.f = f, .points = points, .error = xmalloc((size_t)tasks * sizeof *work.error)};
    parallel_for(check_point, &work, tasks, "collisions to check with");
    *error = 0;
    for (slong i = 0; i < tasks; i++)
        *error = fmax(*error, work.error[i]);
    free(work.error);
    return atomic_load(&work.failed) ? STATUS_FAILED : STATUS_OK;
}
