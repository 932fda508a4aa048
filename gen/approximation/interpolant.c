/* SPDX-License-Identifier: MIT */
#include "approximation/interpolant.h"

#include <math.h>
#include <stdlib.h>

#include "enclosure/collision.h"
#include "support/console.h"

enum { WORKING_BITS = 320, FAR_BITS = 112, GUARD_BITS = 16 };

struct interval {
    double lo, hi; /* of z = sqrt(beta), or of u = ln(beta) */
    slong count, bits;
    bool logarithmic;
    bool unloading; /* zero overlap is known too */
    bool quotient;  /* (1 - eps)/beta stands for eps */
};

/* Zero overlap is expensive where damping is strong, and has a closed form there but for the duration. */
static const struct interval intervals[] = {
    {0, 0.625, 40, 90, false, true, true},      {0.625, 1.25, 40, 90, false, true, false},
    {1.25, 1.875, 40, 90, false, true, false},  {1.875, 2.375, 40, 90, false, true, false},
    {2.375, 2.875, 40, 90, false, true, false}, {2.875, 4.125, 40, 90, false, false, false},
    {2, 10, 52, 76, true, true, false},
};
enum { INTERVALS = sizeof intervals / sizeof *intervals, TAIL = INTERVALS - 1 };

struct samples {
    arb_ptr beta, node, weight, value[QUANTITIES];
};

struct interpolant {
    bool known[INTERVALS];
    struct samples samples[INTERVALS];
    arb_struct far[QUANTITIES][INTERPOLANT_FAR];
};

struct ratio interpolant_tail_power(enum quantity quantity)
{
    switch (quantity) {
    case EPS_ZERO_OVERLAP:
        return ratio_make(-5, 1);
    case EPS_ZERO_FORCE:
        return ratio_make(-5, 3);
    case DURATION_ZERO_OVERLAP:
        return ratio_make(1, 1);
    default:
        return ratio_make(-2, 3);
    }
}

static arb_srcptr field(const struct collision *c, enum quantity quantity)
{
    const arb_srcptr fields[QUANTITIES] = {c->eps_zero_overlap, c->eps_zero_force, c->t_zero_overlap,
                                           c->t_zero_force,     c->x_max,          c->t_max};
    return fields[quantity];
}

static bool sampled(const struct interval *interval, enum quantity quantity)
{
    if (quantity == EPS_ZERO_OVERLAP)
        return interval->unloading && !interval->logarithmic;
    return interval->unloading || quantity != DURATION_ZERO_OVERLAP;
}

/* x rounded to `bits` bits, if the ball proves how. */
static bool rounded(arb_t y, const arb_t x, slong bits)
{
    arf_t lower, upper;
    arf_init(lower);
    arf_init(upper);
    arb_get_lbound_arf(lower, x, WORKING_BITS);
    arb_get_ubound_arf(upper, x, WORKING_BITS);
    arf_set_round(lower, lower, bits, ARF_RND_NEAR);
    arf_set_round(upper, upper, bits, ARF_RND_NEAR);
    const bool decided = arf_equal(lower, upper) && arf_is_finite(lower);
    if (decided)
        arb_set_arf(y, lower);
    arf_clear(lower);
    arf_clear(upper);
    return decided;
}

/* What an interval stores of a collision at its variable x. */
static void scaled(arb_t y, const struct interval *interval, enum quantity quantity, const struct collision *c,
                   const arb_t beta, slong prec)
{
    arb_set(y, field(c, quantity));
    if (interval->quotient && (quantity == EPS_ZERO_OVERLAP || quantity == EPS_ZERO_FORCE)) {
        arb_sub_ui(y, y, 1, prec);
        arb_neg(y, y);
        arb_div(y, y, beta, prec);
    } else if (interval->logarithmic) {
        arb_t power;
        arb_init(power);
        arb_pow_ratio(power, beta, interpolant_tail_power(quantity), prec);
        arb_div(y, y, power, prec);
        arb_clear(power);
    }
}

/* An exact beta near the place x of an interval, since a ball would grow a thousandfold on its way through a strongly
 * damped collision; and the variable that belongs to it. */
static void place(arb_t beta, arb_t variable, const struct interval *interval, double x)
{
    if (interval->logarithmic) {
        arb_set_d(beta, nearbyint(ldexp(exp(x), 20)));
        arb_mul_2exp_si(beta, beta, -20);
        arb_log(variable, beta, WORKING_BITS);
    } else {
        arb_set_d(variable, nearbyint(ldexp(x, 40)));
        arb_mul_2exp_si(variable, variable, -40);
        arb_sqr(beta, variable, WORKING_BITS);
    }
}

/* All that an interval stores of the collision at an exact beta, each to `bits` bits at least. */
static int solve(arb_ptr value, const struct interval *interval, const arb_t beta, slong bits)
{
    struct collision c;
    collision_init(&c);
    const slong prec = bits + 3 * GUARD_BITS;
    slong more = GUARD_BITS;
    if (interval->quotient)
        more += FLINT_MAX(0, -(slong)arf_abs_bound_lt_2exp_si(arb_midref(beta)) + 1);
    const int status = interval->unloading ? collision_solve(&c, beta, &law_sphere, bits + more)
                                           : collision_solve_force(&c, beta, &law_sphere, bits + more);
    for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++)
        if (sampled(interval, (enum quantity)q))
            scaled(value + q, interval, (enum quantity)q, &c, beta, prec + more);
    collision_clear(&c);
    return status;
}

/* The same rounded to `bits` bits: exact numbers. */
static int solve_rounded(arb_ptr value, const struct interval *interval, const arb_t beta, slong bits)
{
    for (slong extra = 0; extra < 200; extra += 40) {
        bool decided = true;
        if (solve(value, interval, beta, bits + extra))
            return STATUS_FAILED;
        for (int q = 0; q < QUANTITIES; q++)
            if (sampled(interval, (enum quantity)q))
                decided = rounded(value + q, value + q, bits) && decided;
        if (decided)
            return STATUS_OK;
    }
    return fail("a sample of the collision could not be rounded to %ld bits", (long)bits);
}

double chebyshev_point(slong j, slong n)
{
    return -cos((2.0 * (double)j + 1) * acos(-1.0) / (2.0 * (double)n));
}

/* Chebyshev's points; barycentric weights. */
static void place_nodes(struct samples *s, const struct interval *interval)
{
    const slong n = interval->count;
    arb_t d;
    arb_init(d);
    for (slong j = 0; j < n; j++) {
        place(s->beta + j, s->node + j, interval,
              (interval->lo + interval->hi) / 2 + (interval->hi - interval->lo) / 2 * chebyshev_point(j, n));
    }
    for (slong j = 0; j < n; j++) {
        arb_one(s->weight + j);
        for (slong k = 0; k < n; k++) {
            if (k == j)
                continue;
            arb_sub(d, s->node + j, s->node + k, WORKING_BITS);
            arb_mul(s->weight + j, s->weight + j, d, WORKING_BITS);
        }
        arb_inv(s->weight + j, s->weight + j, WORKING_BITS);
    }
    arb_clear(d);
}

/* The polynomial through the samples, at x. */
static void evaluate(arb_t y, const struct interpolant *f, int i, enum quantity quantity, const arb_t x, slong prec)
{
    const struct samples *s = &f->samples[i];
    arb_t d, sum, total;
    arb_init(d);
    arb_init(sum);
    arb_init(total);
    slong hit = -1;
    for (slong j = 0; j < intervals[i].count && hit < 0; j++) {
        arb_sub(d, x, s->node + j, prec);
        if (arb_is_zero(d)) {
            hit = j;
        } else {
            arb_div(d, s->weight + j, d, prec);
            arb_add(total, total, d, prec);
            arb_addmul(sum, d, s->value[quantity] + j, prec);
        }
    }
    if (hit >= 0)
        arb_set(y, s->value[quantity] + hit);
    else
        arb_div(y, sum, total, prec);
    arb_clear(d);
    arb_clear(sum);
    arb_clear(total);
}

static int interval_of(const arb_t z)
{
    const double x = arf_get_d(arb_midref(z), ARF_RND_NEAR);
    int i = 0;
    while (i < TAIL - 1 && x > intervals[i].hi)
        i++;
    return i;
}

void interpolant_value(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t z, slong prec)
{
    const int i = interval_of(z);
    if (quantity == LOSS_QUOTIENT_ZERO_OVERLAP || quantity == LOSS_QUOTIENT_ZERO_FORCE) {
        evaluate(y, f, i, quantity == LOSS_QUOTIENT_ZERO_OVERLAP ? EPS_ZERO_OVERLAP : EPS_ZERO_FORCE, z, prec);
        if (!intervals[i].quotient) {
            arb_sub_ui(y, y, 1, prec);
            arb_neg(y, y);
            arb_div(y, y, z, prec);
            arb_div(y, y, z, prec);
        }
        return;
    }
    evaluate(y, f, i, quantity, z, prec);
    if (intervals[i].quotient && (quantity == EPS_ZERO_OVERLAP || quantity == EPS_ZERO_FORCE)) {
        arb_mul(y, y, z, prec);
        arb_mul(y, y, z, prec);
        arb_sub_ui(y, y, 1, prec);
        arb_neg(y, y);
    }
}

void interpolant_tail(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t u, slong prec)
{
    evaluate(y, f, TAIL, quantity, u, prec);
}

/* ---- the inverse ---- */

/* Where an inverse is looked for: in z = sqrt(beta), or in u = ln(beta) */
struct search {
    const struct interpolant *f;
    enum quantity eps, loss_quotient;
    bool of_loss, logarithmic;
    double lo, hi;
};

/* What shall become 0 at w: the root of the loss, which has a slope at beta = 0 too, or eps, less the value wanted */
static void excess(arb_t y, const struct search *s, const arb_t w, const arb_t wanted)
{
    const slong prec = WORKING_BITS;
    if (s->logarithmic) {
        arb_t power;
        arb_init(power);
        interpolant_tail(y, s->f, s->eps, w, prec);
        arb_mul_si(power, w, -5, prec);
        arb_div_ui(power, power, 3, prec);
        arb_exp(power, power, prec);
        arb_mul(y, y, power, prec);
        arb_clear(power);
    } else if (s->of_loss) {
        interpolant_value(y, s->f, s->loss_quotient, w, prec);
        arb_sqrt(y, y, prec);
        arb_mul(y, y, w, prec);
    } else {
        interpolant_value(y, s->f, s->eps, w, prec);
    }
    arb_sub(y, y, wanted, prec);
    arb_get_mid_arb(y, y);
}

/* Whether w is beyond the place wanted: the loss rises with w, and eps falls. */
static bool beyond(const struct search *s, double w, const arb_t wanted)
{
    arb_t x, y;
    arb_init(x);
    arb_init(y);
    arb_set_d(x, w);
    excess(y, s, x, wanted);
    const int sign = arf_sgn(arb_midref(y));
    arb_clear(x);
    arb_clear(y);
    return s->of_loss ? sign > 0 : sign < 0;
}

/* The secant method, from two places around the root that halving has brought together. */
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
    arb_t before, f0, f1, step;
    arb_init(before);
    arb_init(f0);
    arb_init(f1);
    arb_init(step);
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
    arb_clear(before);
    arb_clear(f0);
    arb_clear(f1);
    arb_clear(step);
    return found ? STATUS_OK : fail("an inverse of the collision was not found");
}

int interpolant_inverse(arb_t y, const struct interpolant *f, enum quantity quantity, const arb_t x, slong prec)
{
    const bool force = quantity == BETA_ZERO_FORCE || quantity == BETA_QUOTIENT_ZERO_FORCE;
    const double z_end = intervals[force ? TAIL - 1 : TAIL - 2].hi;
    struct search s = {.f = f,
                       .eps = force ? EPS_ZERO_FORCE : EPS_ZERO_OVERLAP,
                       .loss_quotient = force ? LOSS_QUOTIENT_ZERO_FORCE : LOSS_QUOTIENT_ZERO_OVERLAP,
                       .of_loss = quantity == BETA_QUOTIENT_ZERO_OVERLAP || quantity == BETA_QUOTIENT_ZERO_FORCE,
                       .lo = 0,
                       .hi = z_end};
    arb_t w, wanted;
    arb_init(w);
    arb_init(wanted);
    if (s.of_loss)
        arb_sqrt(wanted, x, WORKING_BITS);
    else
        arb_set(wanted, x);
    if (force && !beyond(&s, z_end, wanted)) {
        s.logarithmic = true;
        s.lo = 2 * log(z_end);
        s.hi = intervals[TAIL].hi;
    }
    const int status = solve_search(w, &s, wanted);
    if (s.of_loss) { /* (1 - eps)/beta has a value at beta = 0 too */
        interpolant_value(y, f, s.loss_quotient, w, prec);
        arb_inv(y, y, prec);
    } else if (s.logarithmic) {
        arb_exp(y, w, prec);
    } else {
        arb_sqr(y, w, prec);
    }
    arb_clear(w);
    arb_clear(wanted);
    return status;
}

/* e = mu (1 + mu q_1(u) + mu^2 q_2(u)), u = -(3/5) ln(mu), solved for beta = mu^(-3/5) in powers of e: to first order
 * (3/5) q_1(v), to second (9/25) (q_1 q_1' - 2 q_1^2) + (3/5) q_2. */
void interpolant_far_inverse(arb_ptr coefficient, const struct interpolant *f)
{
    const slong prec = WORKING_BITS;
    arb_srcptr far = f->far[EPS_ZERO_FORCE]; /* 1, u; mu (1, u, u^2); mu^2 (1, ..., u^3) */
    arb_poly_t q1, q2, second;
    arb_t c, d;
    arb_poly_init(q1);
    arb_poly_init(q2);
    arb_poly_init(second);
    arb_init(c);
    arb_init(d);
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
    arb_clear(c);
    arb_clear(d);
    arb_poly_clear(q1);
    arb_poly_clear(q2);
    arb_poly_clear(second);
}

void interpolant_far(arb_ptr coefficient, const struct interpolant *f, enum quantity quantity)
{
    for (int k = 0; k < INTERPOLANT_FAR; k++)
        arb_set(coefficient + k, &f->far[quantity][k]);
}

/* 1, u; mu, mu u, mu u^2; mu^2, mu^2 u, mu^2 u^2, mu^2 u^3 */
static void far_basis(arb_mat_t a, slong row, const arb_t u)
{
    arb_t mu, term;
    arb_init(mu);
    arb_init(term);
    arb_mul_si(mu, u, -5, WORKING_BITS);
    arb_div_ui(mu, mu, 3, WORKING_BITS);
    arb_exp(mu, mu, WORKING_BITS);
    slong column = 0;
    for (slong order = 0; order < 3; order++) {
        arb_pow_ui(term, mu, (ulong)order, WORKING_BITS);
        for (slong power = 0; power <= order + 1; power++) {
            arb_set(arb_mat_entry(a, row, column++), term);
            arb_mul(term, term, u, WORKING_BITS);
        }
    }
    arb_clear(mu);
    arb_clear(term);
}

/* Through as many samples as there are coefficients, u = 9.5, 10, ..., 13.5. */
static int make_far(struct interpolant *f)
{
    arb_mat_t a, b;
    arb_t beta, u;
    arb_ptr value = _arb_vec_init(QUANTITIES);
    int status = STATUS_OK;
    arb_mat_init(a, INTERPOLANT_FAR, INTERPOLANT_FAR);
    arb_mat_init(b, INTERPOLANT_FAR, QUANTITIES);
    arb_init(beta);
    arb_init(u);
    for (slong k = 0; k < INTERPOLANT_FAR && status == STATUS_OK; k++) {
        place(beta, u, &intervals[TAIL], 9.5 + 0.5 * (double)k);
        far_basis(a, k, u);
        status = solve_rounded(value, &intervals[TAIL], beta, FAR_BITS);
        for (int q = 0; q < QUANTITIES; q++)
            arb_set(arb_mat_entry(b, k, q), value + q);
    }
    if (status == STATUS_OK && !arb_mat_solve(b, a, b, WORKING_BITS))
        status = fail("the far coefficients could not be solved for");
    for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++)
        for (int k = 0; k < INTERPOLANT_FAR; k++)
            arb_set(&f->far[q][k], arb_mat_entry(b, k, q));
    arb_mat_clear(a);
    arb_mat_clear(b);
    arb_clear(beta);
    arb_clear(u);
    _arb_vec_clear(value, QUANTITIES);
    return status;
}

/* Whether [beta_min, beta_max] meets an interval. */
static bool needed(const struct interval *interval, double beta_min, double beta_max)
{
    const double lo = interval->logarithmic ? exp(interval->lo) : interval->lo * interval->lo;
    const double hi = interval->logarithmic ? INFINITY : interval->hi * interval->hi;
    return beta_max >= lo && beta_min <= hi;
}

struct interpolant *interpolant_new(double beta_min, double beta_max)
{
    struct interpolant *f = xmalloc(sizeof *f);
    arb_ptr value = _arb_vec_init(QUANTITIES);
    int status = STATUS_OK;
    for (int i = 0; i < INTERVALS; i++) {
        struct samples *s = &f->samples[i];
        s->beta = _arb_vec_init(intervals[i].count);
        s->node = _arb_vec_init(intervals[i].count);
        s->weight = _arb_vec_init(intervals[i].count);
        for (int q = 0; q < QUANTITIES; q++)
            s->value[q] = _arb_vec_init(intervals[i].count);
    }
    for (int q = 0; q < QUANTITIES; q++)
        for (int k = 0; k < INTERPOLANT_FAR; k++)
            arb_init(&f->far[q][k]);
    for (int i = 0; i < INTERVALS && status == STATUS_OK; i++) {
        struct samples *s = &f->samples[i];
        f->known[i] = needed(&intervals[i], beta_min, beta_max);
        if (!f->known[i])
            continue;
        place_nodes(s, &intervals[i]);
        for (slong j = 0; j < intervals[i].count && status == STATUS_OK; j++) {
            progress("collisions", i * 40 + (long)j, INTERVALS * 40);
            status = solve_rounded(value, &intervals[i], s->beta + j, intervals[i].bits);
            for (int q = 0; q < QUANTITIES; q++)
                arb_set(s->value[q] + j, value + q);
        }
    }
    if (status == STATUS_OK && beta_max > exp(intervals[TAIL].hi))
        status = make_far(f);
    progress_end();
    _arb_vec_clear(value, QUANTITIES);
    if (status == STATUS_OK)
        return f;
    interpolant_free(f);
    return NULL;
}

void interpolant_free(struct interpolant *f)
{
    if (!f)
        return;
    for (int i = 0; i < INTERVALS; i++) {
        _arb_vec_clear(f->samples[i].beta, intervals[i].count);
        _arb_vec_clear(f->samples[i].node, intervals[i].count);
        _arb_vec_clear(f->samples[i].weight, intervals[i].count);
        for (int q = 0; q < QUANTITIES; q++)
            _arb_vec_clear(f->samples[i].value[q], intervals[i].count);
    }
    for (int q = 0; q < QUANTITIES; q++)
        for (int k = 0; k < INTERPOLANT_FAR; k++)
            arb_clear(&f->far[q][k]);
    free(f);
}

int interpolant_check(double *error, const struct interpolant *f, int points)
{
    arb_ptr value = _arb_vec_init(QUANTITIES);
    arb_t beta, x, y;
    int status = STATUS_OK;
    arb_init(beta);
    arb_init(x);
    arb_init(y);
    *error = 0;
    for (int i = 0; i < INTERVALS; i++) {
        const struct interval *interval = &intervals[i];
        for (int k = 0; k < points && f->known[i] && status == STATUS_OK; k++) {
            /* the ends, where interpolation is worst, and between */
            const double s = points > 1 ? k / (double)(points - 1) : 0;
            place(beta, x, interval,
                  interval->lo + (interval->hi - interval->lo) * (k == 0 && interval->lo == 0 ? 1e-6 : s));
            status = solve(value, interval, beta, interval->bits);
            for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++) {
                if (!sampled(interval, (enum quantity)q))
                    continue;
                evaluate(y, f, i, (enum quantity)q, x, WORKING_BITS);
                arb_div(y, y, value + q, WORKING_BITS);
                arb_sub_ui(y, y, 1, WORKING_BITS);
                *error = fmax(*error, fabs(arf_get_d(arb_midref(y), ARF_RND_UP)));
            }
        }
    }
    progress_end();
    arb_clear(beta);
    arb_clear(x);
    arb_clear(y);
    _arb_vec_clear(value, QUANTITIES);
    return status;
}
