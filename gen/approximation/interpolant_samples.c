/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "approximation/interpolant_parts.h"
#include "enclosure/collision.h"
#include "support/console.h"
#include "support/local.h"
#include "support/parallel.h"

enum {
    GUARD_BITS = 10, /* extra bits, which nearly always suffice to round a sample correctly */
    SCALING_BITS = 32
};

/* At strong damping zero overlap is slow to compute, but all of its quantities except the duration have a closed form.
 * Zero overlap is singular near z = 1.7 + 0.45 i, so the ellipse around the third interval is too small for the proof.
 * For the proof, the next two intervals cover the range of the third; the values still come from the third. */
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
const struct interpolant_layout interpolant_sphere_proof = {.law = {3, 1, 2},
                                                            .root = 2,
                                                            .interval = sphere_intervals,
                                                            .intervals =
                                                                sizeof sphere_intervals / sizeof *sphere_intervals,
                                                            .far = true};

struct ratio interpolant_press_power(const struct cor_exponents *law)
{
    return RATIO("-2*law->a/(2*law->b - law->a + 1)", law);
}

/* Returns the power of beta that a quantity follows for large beta. A duration at zero overlap is mainly the creep
 * along the slow manifold or, if a - b > 1, the end of the creep. */
struct ratio interpolant_tail_power(const struct cor_exponents *law, enum quantity quantity)
{
    const struct ratio a = law_elastic(law), b = law_damping(law);
    if (law_is_linear(law) && is_of_overlap(quantity)) /* no power */
        return (struct ratio){0, 1};
    switch (quantity) {
    case EPS_ZERO_OVERLAP:
        return RATIO("-(a + 1)/(2*b - a + 1)", a, b);
    case EPS_ZERO_FORCE:
        return RATIO("-(a + 1)/(b + 1)", a, b);
    case DURATION_ZERO_OVERLAP:
        return law->elastic - law->damping > law->denominator ? RATIO("(a - 1)/(2*b - a + 1)", a, b)
                                                              : RATIO("a/(b + 1)", a, b);
    default:
        return RATIO("-1/(b + 1)", b);
    }
}

void interpolant_power(arb_t y, const arb_t u, struct ratio power, slong prec)
{
    const slong num = power.num, den = power.den;
    LET(y, prec, "exp(u*num/den)", u, num, den);
}

void interpolant_beta(arb_t beta, const struct interpolant *f, enum interval_variable variable, const arb_t x,
                      slong prec)
{
    static const char *const of_place[] = {
        [INTERVAL_ROOT] = "x^root", [INTERVAL_LOG] = "exp(x)", [INTERVAL_BELOW] = "f->threshold - exp(x)"};
    const slong root = f->layout->root;
    LET(beta, prec, of_place[variable], x, root, f->threshold);
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

/* Computes the number that an interval stores for a collision. */
static void set_scaled_quantity(arb_t y, const struct cor_exponents *law, const struct interval *interval,
                                enum quantity quantity, const struct collision *c, const arb_t beta, slong prec)
{
    const struct ratio power = interpolant_tail_power(law, quantity);
    const arb_srcptr number = c->field[quantity];
    const char *const text = interval->form == FORM_POWER && interval->variable == INTERVAL_BELOW
                                 ? "number*c->eps_zero_overlap^((law->a - 1)/(law->a + 1))"
                             : interval->form == FORM_POWER                      ? "number/beta^power"
                             : !is_eps(quantity) || interval->form == FORM_VALUE ? "number"
                             : interval->form == FORM_QUOTIENT                   ? "(1 - number)/beta"
                                                                                 : "log(number)";
    LET(y, prec, text, number, c->eps_zero_overlap, law, beta, power);
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
    const struct cor_exponents *law = &f->layout->law;
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
        if (has_quantity(interval, (enum quantity)q))
            set_scaled_quantity(value + q, law, interval, (enum quantity)q, &c, beta, prec + more);
    return status;
}

/* Computes the numbers of interval_solve, rounded to `bits` bits, as exact numbers. */
static int interval_sample(arb_ptr value, const struct interpolant *f, const struct interval *interval,
                           const arb_t beta, slong bits)
{
    for (slong extra = 0; extra < 200; extra += 40) {
        bool decided = true;
        if (interval_solve(value, f, interval, beta, bits + extra))
            return STATUS_FAILED;
        for (int q = 0; q < QUANTITIES; q++)
            if (has_quantity(interval, (enum quantity)q))
                decided = sample_rounded(value + q, value + q, bits) && decided;
        if (decided)
            return STATUS_OK;
    }
    return fail("cannot round a sample of the collision to %ld bits", (long)bits);
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

double interpolant_beta_near(const struct interpolant *f, const struct interval *interval, double x)
{
    LOCAL(arb, beta, place);
    arb_set_d(place, x);
    interpolant_beta(beta, f, interval->variable, place, INTERPOLANT_BITS);
    return ball_middle(beta);
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

/* Computes one sample. The last collisions take longest and are the first tasks. */
static void sample_node(void *context, slong task)
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
    parallel_for(sample_node, &work, tasks, step);
    return atomic_load(&work.failed) ? STATUS_FAILED : STATUS_OK;
}
