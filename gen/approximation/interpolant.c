/* SPDX-License-Identifier: MIT */
#include "approximation/interpolant.h"

#include <math.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>

#include "enclosure/collision.h"
#include "support/console.h"
#include "support/parallel.h"

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
enum { INTERVALS = sizeof intervals / sizeof *intervals, TAIL = INTERVALS - 1, MOST_SAMPLES = 64 };

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
        evaluate(y, f, 0, quantity == LOSS_QUOTIENT_ZERO_OVERLAP ? EPS_ZERO_OVERLAP : EPS_ZERO_FORCE, z, prec);
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

struct far_system {
    arb_mat_t basis, value;
    atomic_bool failed;
};

static void sample_far(void *context, slong k)
{
    struct far_system *const system = context;
    arb_ptr value = _arb_vec_init(QUANTITIES);
    arb_t beta, u;
    arb_init(beta);
    arb_init(u);
    place(beta, u, &intervals[TAIL], 9.5 + 0.5 * (double)k);
    far_basis(system->basis, k, u);
    if (solve_rounded(value, &intervals[TAIL], beta, FAR_BITS) != STATUS_OK)
        atomic_store(&system->failed, true);
    for (int q = 0; q < QUANTITIES; q++)
        arb_set(arb_mat_entry(system->value, k, q), value + q);
    arb_clear(beta);
    arb_clear(u);
    _arb_vec_clear(value, QUANTITIES);
}

/* Through as many samples as there are coefficients, u = 9.5, 10, ..., 13.5. */
static int make_far(struct interpolant *f)
{
    struct far_system system = {.failed = false};
    arb_mat_init(system.basis, INTERPOLANT_FAR, INTERPOLANT_FAR);
    arb_mat_init(system.value, INTERPOLANT_FAR, QUANTITIES);
    parallel_for(sample_far, &system, INTERPOLANT_FAR, "collisions at large beta");
    int status = atomic_load(&system.failed) ? STATUS_FAILED : STATUS_OK;
    if (status == STATUS_OK && !arb_mat_solve(system.value, system.basis, system.value, WORKING_BITS))
        status = fail("the far coefficients could not be solved for");
    for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++)
        for (int k = 0; k < INTERPOLANT_FAR; k++)
            arb_set(&f->far[q][k], arb_mat_entry(system.value, k, q));
    arb_mat_clear(system.basis);
    arb_mat_clear(system.value);
    return status;
}

/* Whether [beta_min, beta_max] meets an interval. */
static bool needed(const struct interval *interval, double beta_min, double beta_max)
{
    const double lo = interval->logarithmic ? exp(interval->lo) : interval->lo * interval->lo;
    const double hi = interval->logarithmic ? INFINITY : interval->hi * interval->hi;
    return beta_max >= lo && beta_min <= hi;
}

/* One sample, or one of the far ones: a task of its own. */
struct sampling {
    struct interpolant *f;
    struct {
        int interval;
        slong sample;
    } task[INTERVALS * MOST_SAMPLES];
    slong tasks;
    atomic_bool failed;
};

static void sample(void *context, slong i)
{
    struct sampling *const work = context;
    const int interval = work->task[i].interval;
    const slong j = work->task[i].sample;
    struct samples *const s = &work->f->samples[interval];
    if (atomic_load(&work->failed))
        return;
    arb_ptr value = _arb_vec_init(QUANTITIES);
    if (solve_rounded(value, &intervals[interval], s->beta + j, intervals[interval].bits) != STATUS_OK)
        atomic_store(&work->failed, true);
    for (int q = 0; q < QUANTITIES; q++)
        arb_set(s->value[q] + j, value + q);
    _arb_vec_clear(value, QUANTITIES);
}

struct interpolant *interpolant_new(double beta_min, double beta_max)
{
    struct interpolant *f = xmalloc(sizeof *f);
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
    struct sampling work = {.f = f};
    for (int i = INTERVALS - 1; i >= 0; i--) { /* the longest collisions first */
        f->known[i] = needed(&intervals[i], beta_min, beta_max);
        if (!f->known[i])
            continue;
        place_nodes(&f->samples[i], &intervals[i]);
        for (slong j = intervals[i].count - 1; j >= 0; j--) {
            work.task[work.tasks].interval = i;
            work.task[work.tasks++].sample = j;
        }
    }
    parallel_for(sample, &work, work.tasks, "collisions");
    status = atomic_load(&work.failed) ? STATUS_FAILED : STATUS_OK;
    if (status == STATUS_OK && beta_max > exp(intervals[TAIL].hi))
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

struct checking {
    const struct interpolant *f;
    int points;
    double *error; /* of each task */
    atomic_bool failed;
};

/* Point i % points of interval i / points: the ends, where interpolation is worst, and between. */
static void check_point(void *context, slong i)
{
    struct checking *const work = context;
    const int index = (int)(i / work->points), k = (int)(i % work->points);
    const struct interval *const interval = &intervals[index];
    work->error[i] = 0;
    if (!work->f->known[index])
        return;
    arb_ptr value = _arb_vec_init(QUANTITIES);
    arb_t beta, x, y;
    arb_init(beta);
    arb_init(x);
    arb_init(y);
    const double s = work->points > 1 ? k / (double)(work->points - 1) : 0;
    place(beta, x, interval, interval->lo + (interval->hi - interval->lo) * (k == 0 && interval->lo == 0 ? 1e-6 : s));
    const int status = solve(value, interval, beta, interval->bits);
    for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++) {
        if (!sampled(interval, (enum quantity)q))
            continue;
        evaluate(y, work->f, index, (enum quantity)q, x, WORKING_BITS);
        arb_div(y, y, value + q, WORKING_BITS);
        arb_sub_ui(y, y, 1, WORKING_BITS);
        work->error[i] = fmax(work->error[i], fabs(arf_get_d(arb_midref(y), ARF_RND_UP)));
    }
    if (status != STATUS_OK)
        atomic_store(&work->failed, true);
    arb_clear(beta);
    arb_clear(x);
    arb_clear(y);
    _arb_vec_clear(value, QUANTITIES);
}

int interpolant_check(double *error, const struct interpolant *f, int points)
{
    const slong tasks = (slong)INTERVALS * points;
    struct checking work = {.f = f, .points = points, .error = xmalloc((size_t)tasks * sizeof *work.error)};
    parallel_for(check_point, &work, tasks, "collisions to check with");
    *error = 0;
    for (slong i = 0; i < tasks; i++)
        *error = fmax(*error, work.error[i]);
    free(work.error);
    return atomic_load(&work.failed) ? STATUS_FAILED : STATUS_OK;
}
