/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "approximation/interpolant_parts.h"
#include "enclosure/collision.h"
#include "series/restitution.h"
#include "support/console.h"
#include "support/local.h"
#include "support/parallel.h"

enum {
    GUARD_BITS = 10, /* beyond those of a sample, which decide its rounding nearly always */
    SCALING_BITS = 32,
    CHECK_BITS = 70,     /* of collisions to check with */
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

struct ratio interpolant_press_power(const struct law *law)
{
    return RATIO("-2*law->a/(2*law->b - law->a + 1)", law->a, law->b);
}

/* ---- samples ---- */

double chebyshev_point(slong j, slong n)
{
    return -cos((2.0 * (double)j + 1) * acos(-1.0) / (2.0 * (double)n));
}

void unit_place(arb_t t, const arb_t x, double lo, double hi, slong prec)
{
    LET(t, prec, "(2*x - lo - hi)/(hi - lo)", x, lo, hi);
}

bool sample_rounded(arb_t y, const arb_t x, slong bits)
{
    enum { ENOUGH_BITS = 320 };
    LOCAL(arf, lower, upper);
    arb_get_lbound_arf(lower, x, ENOUGH_BITS);
    arb_get_ubound_arf(upper, x, ENOUGH_BITS);
    arf_set_round(lower, lower, bits, ARF_RND_NEAR);
    arf_set_round(upper, upper, bits, ARF_RND_NEAR);
    const bool decided = arf_equal(lower, upper) && arf_is_finite(lower);
    if (decided)
        arb_set_arf(y, lower);
    return decided;
}

/* The number that an interval stores for a collision */
static void scaled(arb_t y, const struct law *law, const struct interval *interval, enum quantity quantity,
                   const struct collision *c, const arb_t beta, slong prec)
{
    const struct ratio power = interpolant_tail_power(law, quantity);
    const arb_srcptr number = c->field[quantity];
    const char *const text = interval->form == FORM_POWER && interval->variable == INTERVAL_BELOW
                                 ? "number*c->eps_zero_overlap^((law->a - 1)/(law->a + 1))"
                             : interval->form == FORM_POWER                      ? "number/beta^power"
                             : !is_eps(quantity) || interval->form == FORM_VALUE ? "number"
                             : interval->form == FORM_QUOTIENT                   ? "(1 - number)/beta"
                                                                                 : "log(number)";
    LET(y, prec, text, number, c->eps_zero_overlap, law->a, beta, power);
}

void interpolant_place(arb_t beta, arb_t variable, const struct interpolant *f, const struct interval *interval,
                       double x)
{
    const int bits = interval->variable == INTERVAL_LOG && x >= 2 ? 20 : 40;
    switch (interval->variable) {
    case INTERVAL_LOG:
        arb_set_d(beta, f->layout->press ? exp(x) : ldexp(nearbyint(ldexp(exp(x), bits)), -bits));
        arb_log(variable, beta, INTERPOLANT_NODE_BITS);
        break;
    case INTERVAL_ROOT:
        arb_set_d(variable, nearbyint(ldexp(x, bits)));
        arb_mul_2exp_si(variable, variable, -bits);
        arb_pow_ui(beta, variable, (ulong)f->layout->root, INTERPOLANT_BITS);
        break;
    case INTERVAL_BELOW:
        arb_set_d(variable, exp(x));
        arb_sub(beta, f->threshold, variable, INTERPOLANT_BITS);
        arb_get_mid_arb(beta, beta);
        arb_sub(variable, f->threshold, beta, INTERPOLANT_NODE_BITS);
        arb_log(variable, variable, INTERPOLANT_NODE_BITS);
        break;
    }
}

/* Computes all numbers that an interval stores for the collision at an exact beta, each to at least `bits` bits. */
static int interval_solve(arb_ptr value, const struct interpolant *f, const struct interval *interval, const arb_t beta,
                          slong bits)
{
    LOCAL_INIT(collision, c, (&c));
    const struct law *law = &f->layout->law;
    const slong prec = bits + GUARD_BITS + SCALING_BITS;
    slong more = GUARD_BITS;
    if (interval->form == FORM_QUOTIENT)
        more += FLINT_MAX(0, -(slong)arf_abs_bound_lt_2exp_si(arb_midref(beta)) + 1);
    const bool overlap = interval->set & SET_ZERO_OVERLAP, force = interval->set & SET_ZERO_FORCE;
    LOCAL(arb, press, x);
    arb_sub(x, f->threshold, beta, prec);
    const double below = ball_middle(x);
    if (f->layout->press) {
        const struct ratio power = interpolant_press_power(law);
        LET(press, 4 * prec, "beta^power*f->layout->press", beta, power, f->layout->press);
    }
    const int status = f->layout->press   ? collision_solve_pressed(&c, beta, press, law, force ? 1 : 0, bits + more)
                       : overlap && force ? collision_solve(&c, beta, law, bits + more)
                       : overlap          ? collision_solve_below(&c, beta, below, law, bits + more)
                                          : collision_solve_force(&c, beta, law, bits + more);
    for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++)
        if (holds(interval, (enum quantity)q))
            scaled(value + q, law, interval, (enum quantity)q, &c, beta, prec + more);
    return status;
}

/* The same, rounded to `bits` bits, as exact numbers */
static int interval_sample(arb_ptr value, const struct interpolant *f, const struct interval *interval,
                           const arb_t beta, slong bits)
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

void interpolant_through_samples(arb_poly_t p, const struct samples *s, const struct interval *interval,
                                 enum quantity quantity)
{
    const slong n = interval->count;
    LOCAL_VECTOR(t, n);
    for (slong j = 0; j < n; j++)
        unit_place(t + j, s->node + j, interval->lo, interval->hi, INTERPOLANT_NODE_BITS);
    arb_poly_interpolate_newton(p, t, s->value[quantity], n, INTERPOLANT_NODE_BITS);
    arb_poly_set_round(p, p, INTERPOLANT_BITS + INTERPOLANT_GUARD);
}

/* ---- construction ---- */

double interpolant_beta_near(const struct interpolant *f, const struct interval *interval, double x)
{
    LOCAL(arb, beta, place);
    arb_set_d(place, x);
    interpolant_beta(beta, f, interval->variable, place, INTERPOLANT_BITS);
    return ball_middle(beta);
}

static int make_constants(struct interpolant *f, double beta_max)
{
    const struct law *law = &f->layout->law;
    arb_pos_inf(f->threshold);
    if (f->layout->press)
        return STATUS_OK;
    if (law_fall_power(law).num <= 0) {
        LOCAL(arb, height);
        const int status = collision_threshold(f->threshold, height, law, INTERPOLANT_BITS);
        arb_get_mid_arb(f->threshold, f->threshold); /* v counts from this number */
        return status;
    }
    const double root_end = pow(fmax(interpolant_last(f, EPS_ZERO_OVERLAP, INTERVAL_ROOT), 0), (double)f->layout->root);
    const bool beyond_samples = beta_max >= fmax(root_end, exp(interpolant_last(f, EPS_ZERO_OVERLAP, INTERVAL_LOG)));
    return beyond_samples ? collision_final_speed(f->final_speed, law, CONSTANT_BITS) : STATUS_OK;
}

void samples_init(struct samples *s, slong count)
{
    s->known = true;
    s->beta = _arb_vec_init(count);
    s->node = _arb_vec_init(count);
    for (int q = 0; q < QUANTITIES; q++) {
        s->value[q] = _arb_vec_init(count);
        arb_poly_init(&s->polynomial[q]);
    }
}

void samples_clear(struct samples *s, slong count)
{
    _arb_vec_clear(s->beta, count);
    _arb_vec_clear(s->node, count);
    for (int q = 0; q < QUANTITIES; q++) {
        _arb_vec_clear(s->value[q], count);
        arb_poly_clear(&s->polynomial[q]);
    }
}

/* The samples of several intervals as tasks */
struct sampling {
    struct samples *s;
    const struct interpolant *f;
    const struct interval *interval;
    int intervals;
    atomic_bool failed;
};

/* The longest collisions are the last ones, and the first tasks. */
static void sample(void *context, slong task)
{
    struct sampling *const work = context;
    int i = work->intervals - 1;
    for (; task >= work->interval[i].count; i--)
        task -= work->interval[i].count;
    const struct interval *const interval = &work->interval[i];
    struct samples *const s = &work->s[i];
    const slong j = interval->count - 1 - task;
    if (!s->known || atomic_load(&work->failed))
        return;
    LOCAL_VECTOR(value, QUANTITIES);
    if (interval_sample(value, work->f, interval, s->beta + j, interval->bits) != STATUS_OK)
        atomic_store(&work->failed, true);
    for (int q = 0; q < QUANTITIES; q++)
        arb_set(s->value[q] + j, value + q);
}

int samples_collide(struct samples *s, int intervals, const struct interpolant *f, const struct interval *interval,
                    const char *step)
{
    struct sampling work = {.s = s, .f = f, .interval = interval, .intervals = intervals};
    slong tasks = 0;
    for (int i = 0; i < intervals; i++)
        tasks += interval[i].count;
    parallel_for(sample, &work, tasks, step);
    return atomic_load(&work.failed) ? STATUS_FAILED : STATUS_OK;
}

static int make_samples(struct interpolant *f, double beta_min, double beta_max)
{
    const struct interpolant_layout *const layout = f->layout;
    for (int i = 0; i < layout->intervals; i++) {
        /* [beta_min, beta_max] meets the interval; the far coefficients continue the last u */
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
            if (holds(&layout->interval[i], (enum quantity)q))
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
    if (!layout->press && !holds(&layout->interval[0], EPS_ZERO_FORCE) && law_force_ends(&layout->law)) {
        LOCAL(fmpq_poly, G, T); /* near beta = 0 nothing samples zero force */
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

/* The relative error of the polynomial at sample k of interval i */
static double error_at(const struct interpolant *f, int i, enum quantity quantity, const struct samples *s, slong k)
{
    const arb_srcptr known = s->value[quantity] + k;
    LOCAL(arb, y);
    interpolant_polynomial_at(y, f, i, quantity, s->node + k, INTERPOLANT_BITS);
    if (f->layout->interval[i].form == FORM_LOG && is_eps(quantity))
        LET(y, INTERPOLANT_BITS, "y - known", y, known); /* for a logarithm the absolute error counts */
    else
        LET(y, INTERPOLANT_BITS, "y/known - 1", y, known);
    return fabs(arf_get_d(arb_midref(y), ARF_RND_UP));
}

/* The places include the ends, where interpolation is worst. */
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
            const double place = at_zero ? 1e-6 : points > 1 ? (double)k / (points - 1) : 0;
            interpolant_place(s[i].beta + k, s[i].node + k, f, interval,
                              interval->lo + (interval->hi - interval->lo) * place);
        }
    }
    const int status = samples_collide(s, intervals, f, checked, "collisions to check with");
    *error = 0;
    for (int i = 0; i < intervals; i++) {
        for (int q = 0; q < QUANTITIES && s[i].known; q++)
            for (slong k = 0; k < points && holds(&checked[i], (enum quantity)q); k++)
                *error = fmax(*error, error_at(f, i, (enum quantity)q, &s[i], k));
        samples_clear(&s[i], points);
    }
    free(checked);
    free(s);
    return status;
}
