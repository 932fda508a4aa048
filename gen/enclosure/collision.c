/* SPDX-License-Identifier: MIT */
#include "enclosure/collision.h"

#include "enclosure/slow_manifold.h"
#include "enclosure/taylor.h"
#include "series/jet.h"
#include "series/restitution.h"
#include "support/console.h"

#include <math.h>

/* A collision that needs more steps than this has no end in sight (overdamped laws never part). */
#define MAX_STEPS 200000

void collision_init(struct collision *c)
{
    arb_init(c->x_max);
    arb_init(c->t_max);
    arb_init(c->eps_zero_overlap);
    arb_init(c->t_zero_overlap);
    arb_init(c->eps_zero_force);
    arb_init(c->t_zero_force);
}

void collision_clear(struct collision *c)
{
    arb_clear(c->x_max);
    arb_clear(c->t_max);
    arb_clear(c->eps_zero_overlap);
    arb_clear(c->t_zero_overlap);
    arb_clear(c->eps_zero_force);
    arb_clear(c->t_zero_force);
}

/* The scales in which the equation of motion is integrated: x = length X, t = length s,
 * X'' + c1 X^b X' + c2 X^a = 0. Up to beta = 1 they are 1, beta, 1; beyond, length = beta^(-1/(b+1)) makes
 * c1 = 1 and c2 = mu = beta^(-(a+1)/(b+1)), regular however large beta is. */
struct scales {
    arb_t length, c1, c2;
    bool strong;
};

static void scales_init(struct scales *s, const arb_t beta, const struct law *law, slong prec)
{
    const struct ratio one = {1, 1};
    const struct ratio a1 = ratio_add(law->a, one), b1 = ratio_add(law->b, one);
    arb_init(s->length);
    arb_init(s->c1);
    arb_init(s->c2);
    arb_one(s->length);
    arb_set(s->c1, beta);
    arb_one(s->c2);
    arb_sub_si(s->length, beta, 1, prec);
    s->strong = arb_is_positive(s->length);
    arb_one(s->length);
    if (s->strong) {
        arb_inv(s->length, beta, prec);
        arb_pow_ratio(s->c2, s->length, ratio_div(a1, b1), prec);
        arb_pow_ratio(s->length, s->length, ratio_div(one, b1), prec);
        arb_one(s->c1);
    }
}

static void scales_clear(struct scales *s)
{
    arb_clear(s->length);
    arb_clear(s->c1);
    arb_clear(s->c2);
}

/* What integrate() is after. */
enum goal { GOAL_ZERO_OVERLAP, GOAL_ZERO_FORCE, GOAL_SLOW_MANIFOLD };

enum outcome { OUTCOME_DONE, OUTCOME_IMPRECISE, OUTCOME_ENDLESS };

static void record(arb_t eps, arb_t time, const struct taylor *y, const arb_t root, const struct scales *s)
{
    taylor_value(eps, y, TAYLOR_V, 0, root);
    arb_neg(eps, eps);
    taylor_value(time, y, TAYLOR_T, 0, root);
    arb_mul(time, time, s->length, y->prec);
}

/* p = -z'/z = -v/(c2 w^2) and r = z^(-1/2) = c2/w of slow_manifold.h at the state in hand. */
static void fall_state(arb_t r, arb_t p, const struct taylor *y)
{
    arb_div(r, y->c2, y->w, y->prec);
    arb_sqr(p, y->w, y->prec);
    arb_mul(p, p, y->c2, y->prec);
    arb_div(p, y->v, p, y->prec);
    arb_neg(p, p);
}

/* Overdamped: the overlap creeps to zero and never gets there, eps = 0. While u = -x' >= 0, k = u/x^(b+1) obeys
 * k'/x^b = (b+1) k^2 - c1 k + c2 x^(a-2b-1). Where a >= 2b+1 (q <= 0) the last term cannot grow again; once the
 * right side is not positive at K = c1/(2(b+1)) and k < K, k never exceeds K, and x^(b+1) reaches 0 too slowly. */
static bool creeps(const struct taylor *y)
{
    const slong d = y->law.d, b1 = y->law.bd + d, excess = y->law.ad - y->law.bd - b1;
    if (excess < 0)
        return false;
    arb_t k, x;
    arb_init(k);
    arb_init(x);
    arb_pow_ui(x, y->w, (ulong)b1, y->prec);
    arb_div(k, y->v, x, y->prec);
    arb_mul_si(k, k, 2 * b1, y->prec);
    arb_div_si(k, k, d, y->prec);
    arb_add(k, k, y->c1, y->prec);
    bool never = arb_is_positive(k);
    if (never) {
        /* c1^2/(4(b+1)) >= c2 x^(a-2b-1); the k above is 2(b+1)(K - k) */
        arb_sqr(k, y->c1, y->prec);
        arb_mul_si(k, k, d, y->prec);
        arb_div_si(k, k, 4 * b1, y->prec);
        arb_pow_ui(x, y->w, (ulong)excess, y->prec);
        arb_mul(x, x, y->c2, y->prec);
        never = arb_ge(k, x);
    }
    arb_clear(k);
    arb_clear(x);
    return never;
}

/* The zero-force end where it is too close to zero overlap to be told apart by signs. While the force is
 * attractive the speed u falls, from u_f <= 1 at x_f = (c1 u_f)^(1/(a-b)) to eps, so
 *
 *   0 <= u_f^2 - eps^2 <= 2 c1 x_f^(b+1)/(b+1),   0 <= t_zero_overlap - t_zero_force <= x_f/eps. */
static void release_at_end(struct collision *c, bool force_ends, const struct law *law, const struct scales *s,
                           slong prec)
{
    const struct ratio one = {1, 1};
    const struct ratio b1 = ratio_add(law->b, one);
    arb_t x, y;
    arb_set(c->eps_zero_force, c->eps_zero_overlap);
    arb_set(c->t_zero_force, c->t_zero_overlap);
    if (!force_ends)
        return;
    arb_init(x);
    arb_init(y);
    arb_pow_ratio(x, s->c1, ratio_div(one, ratio_sub(law->a, law->b)), prec);
    arb_mul(y, x, s->length, prec);
    arb_div(y, y, c->eps_zero_overlap, prec);
    arb_sub(y, c->t_zero_overlap, y, prec);
    arb_union(c->t_zero_force, c->t_zero_force, y, prec);
    arb_pow_ratio(x, x, b1, prec);
    arb_mul(x, x, s->c1, prec);
    arb_mul_2exp_si(x, x, 1);
    arb_set_ratio(y, b1, prec);
    arb_div(x, x, y, prec);
    arb_addmul(x, c->eps_zero_overlap, c->eps_zero_overlap, prec);
    arb_sqrt(x, x, prec);
    arb_union(c->eps_zero_force, c->eps_zero_force, x, prec);
    arb_clear(x);
    arb_clear(y);
}

/* From first contact to zero overlap, or until the slow manifold is reached to `bits`; then *y holds that
 * state. */
static enum outcome integrate(struct collision *c, struct taylor *y, const struct scales *s, enum goal goal,
                              const struct slow_manifold *m, slong bits)
{
    /* Without damping, and where a <= b, the force lasts as long as the overlap. */
    const bool force_ends = ratio_sub(y->law.a, y->law.b).num > 0 && !arb_is_zero(s->c1);
    bool turned = false, released = false;
    enum outcome outcome = OUTCOME_ENDLESS;
    arb_t value, root, end, r, p;
    arb_init(value);
    arb_init(root);
    arb_init(end);
    arb_init(r);
    arb_init(p);
    arb_set(y->c1, s->c1);
    arb_set(y->c2, s->c2);
    arb_one(y->v);

    for (slong step = 0; step < MAX_STEPS; step++) {
        progress("collision", step, 0);
        outcome = OUTCOME_IMPRECISE;
        taylor_expand(y);
        if (!taylor_choose_step(y))
            break;
        taylor_value(value, y, TAYLOR_V, 0, y->step);
        if (!turned && !arb_is_positive(value)) {
            if (!arb_is_negative(value) || !taylor_root(root, y, TAYLOR_V, y->step))
                break;
            turned = true;
            taylor_value(value, y, TAYLOR_W, 0, root);
            arb_pow_ui(value, value, (ulong)y->law.d, y->prec);
            arb_mul(c->x_max, value, s->length, y->prec);
            taylor_value(value, y, TAYLOR_T, 0, root);
            arb_mul(c->t_max, value, s->length, y->prec);
        }
        taylor_value(value, y, TAYLOR_W, 0, y->step);
        const bool parted = turned && !arb_is_positive(value);
        arb_set(end, y->step);
        if (parted) {
            if (!arb_is_negative(value) || !taylor_root(end, y, TAYLOR_W, y->step))
                break;
            record(c->eps_zero_overlap, c->t_zero_overlap, y, end, s);
        }
        if (turned && force_ends && !released) {
            taylor_value(value, y, TAYLOR_FORCE, 0, end);
            if (arb_is_negative(value) && taylor_root(root, y, TAYLOR_FORCE, end)) {
                released = true;
                record(c->eps_zero_force, c->t_zero_force, y, root, s);
            } else if (!arb_is_positive(value) && !parted) {
                break;
            }
        }
        if (parted) {
            if (!released)
                release_at_end(c, force_ends, &y->law, s, y->prec);
            outcome = OUTCOME_DONE;
            break;
        }
        if (released && goal == GOAL_ZERO_FORCE) {
            outcome = OUTCOME_DONE;
            break;
        }
        taylor_advance(y, y->step);
        if (arb_rel_accuracy_bits(y->w) < 8 || arb_rel_accuracy_bits(y->t) < 8)
            break;
        if (m && released) { /* the goal is the slow manifold */
            fall_state(r, p, y);
            if (slow_manifold_reached(m, r, p, bits)) {
                outcome = OUTCOME_DONE;
                break;
            }
            if (arb_gt(r, m->r1)) /* the manifold's own domain is left, and it was not reached */
                break;
        }
        if (released && creeps(y)) {
            arb_zero(c->eps_zero_overlap);
            arb_pos_inf(c->t_zero_overlap);
            outcome = OUTCOME_DONE;
            break;
        }
        outcome = OUTCOME_ENDLESS;
    }
    arb_clear(value);
    arb_clear(root);
    arb_clear(end);
    arb_clear(r);
    arb_clear(p);
    return outcome;
}

/* Degree of the Taylor polynomials: a step is an eighth of the radius of convergence, 3 bits a term. */
static slong degree_for(slong prec)
{
    return prec / 3 + 10;
}

static enum outcome solve_directly(struct collision *c, const arb_t beta, const struct law *law, enum goal goal,
                                   slong prec)
{
    struct scales s;
    struct taylor y;
    scales_init(&s, beta, law, prec);
    taylor_init(&y, law, 1, degree_for(prec), prec);
    const enum outcome outcome = integrate(c, &y, &s, goal, NULL, 0);
    taylor_clear(&y);
    scales_clear(&s);
    return outcome;
}

/* Strong damping, sphere: integrate loading, turning point and zero force, then let the slow manifold take over:
 * eps = beta^-5 h*^5 and t_zero_overlap = t + beta (time on the manifold + time of the last fall). */
static enum outcome solve_by_slow_manifold(struct collision *c, const arb_t beta, slong bits, slong prec)
{
    struct scales s;
    struct taylor y;
    struct slow_manifold m;
    arb_t r, p, time;
    enum outcome outcome = OUTCOME_IMPRECISE;
    arb_init(r);
    arb_init(p);
    arb_init(time);
    scales_init(&s, beta, &law_sphere, prec);
    taylor_init(&y, &law_sphere, 1, degree_for(prec), prec);
    if (slow_manifold_init(&m, bits, prec)) {
        outcome = integrate(c, &y, &s, GOAL_SLOW_MANIFOLD, &m, bits);
        if (outcome == OUTCOME_DONE) {
            fall_state(r, p, &y);
            arb_mul(c->t_zero_overlap, y.t, s.length, prec);
            if (slow_manifold_time(time, &m, r, p, bits)) {
                arb_add(time, time, m.t_fall, prec);
                arb_addmul(c->t_zero_overlap, time, beta, prec);
                arb_pow_ui(p, beta, 5, prec);
                arb_div(c->eps_zero_overlap, m.h_star_5, p, prec);
            } else {
                outcome = OUTCOME_IMPRECISE;
            }
        }
    }
    slow_manifold_clear(&m);
    taylor_clear(&y);
    scales_clear(&s);
    arb_clear(r);
    arb_clear(p);
    arb_clear(time);
    return outcome;
}

static slong accuracy(const struct collision *c, enum goal goal)
{
    const arb_srcptr field[6] = {c->x_max,         c->t_max, c->eps_zero_force, c->t_zero_force, c->eps_zero_overlap,
                                 c->t_zero_overlap};
    const int fields = goal == GOAL_ZERO_FORCE ? 4 : 6;
    slong bits = WORD_MAX;
    for (int i = 0; i < fields; i++)
        if (!arb_is_exact(field[i]))
            bits = FLINT_MIN(bits, arb_rel_accuracy_bits(field[i]));
    return bits;
}

int collision_solve(struct collision *c, const arb_t beta, const struct law *law, slong bits)
{
    if (!arb_is_finite(beta) || !arb_is_nonnegative(beta))
        return fail("the damping beta of a collision must be a number >= 0");

    /* The unloading forgets its past by exp(-2.29 beta^(5/3)); what is forgotten costs as many bits in balls. */
    const double b = arf_get_d(arb_midref(beta), ARF_RND_NEAR);
    const double forgotten = 2.29 / log(2.0) * pow(b, 5.0 / 3.0);
    bool slow = law_is_sphere(law) && forgotten > 1.35 * (double)(bits + 60);
    slong prec = bits + 60 + (slong)fmin(slow ? 1.3 * (double)bits : 1.1 * forgotten, 1e9);
    if (!slow && !law_is_sphere(law))
        prec = bits + 100;

    for (int attempt = 0; attempt < 12; attempt++) {
        const enum outcome outcome = slow ? solve_by_slow_manifold(c, beta, bits + 12, prec)
                                          : solve_directly(c, beta, law, GOAL_ZERO_OVERLAP, prec);
        progress_end();
        if (outcome == OUTCOME_ENDLESS)
            return fail("no end of contact within %d steps: this law at this beta is too stiff to be integrated",
                        MAX_STEPS);
        if (outcome == OUTCOME_DONE) {
            if (arb_is_zero(beta)) {
                arb_one(c->eps_zero_overlap);
                arb_one(c->eps_zero_force);
            }
            if (accuracy(c, GOAL_ZERO_OVERLAP) >= bits)
                return STATUS_OK;
            prec += bits - accuracy(c, GOAL_ZERO_OVERLAP) + 20;
        } else if (slow && forgotten < 2.0 * (double)(bits + 60)) {
            /* near the border between the two the manifold may be reached too late */
            slow = false;
            prec = bits + 60 + (slong)(1.1 * forgotten);
        } else {
            prec += prec / 2;
        }
    }
    return fail("the collision could not be enclosed to %ld bits; the last attempt worked with %ld", (long)bits,
                (long)prec);
}

int collision_solve_force(struct collision *c, const arb_t beta, const struct law *law, slong bits)
{
    if (!arb_is_finite(beta) || !arb_is_positive(beta))
        return fail("the damping beta of a collision that ends without force must be a number > 0");
    slong prec = bits + 60;
    for (int attempt = 0; attempt < 12; attempt++) {
        arb_indeterminate(c->eps_zero_overlap);
        arb_indeterminate(c->t_zero_overlap);
        const enum outcome outcome = solve_directly(c, beta, law, GOAL_ZERO_FORCE, prec);
        progress_end();
        if (outcome == OUTCOME_DONE && accuracy(c, GOAL_ZERO_FORCE) >= bits)
            return STATUS_OK;
        prec += prec / 2;
    }
    return fail("the loading of the collision could not be enclosed to %ld bits", (long)bits);
}

int collision_h_star(arb_t h_star, slong bits)
{
    slong prec = 23 * bits / 10 + 60;
    for (int attempt = 0; attempt < 12; attempt++) {
        struct slow_manifold m;
        const bool closed = slow_manifold_init(&m, bits + 12, prec);
        progress_end();
        arb_root_ui(h_star, m.h_star_5, 5, prec);
        slow_manifold_clear(&m);
        if (closed && arb_rel_accuracy_bits(h_star) >= bits)
            return STATUS_OK;
        prec += prec / 2;
    }
    return fail("h* could not be enclosed to %ld bits", (long)bits);
}

/* A component's Taylor coefficients at the state in hand, as power series in beta. */
static void component_jets(arb_poly_struct *jet, slong count, arb_srcptr f, const struct taylor *y)
{
    for (slong n = 0; n < count; n++) {
        arb_poly_zero(jet + n);
        for (slong l = 0; l < y->jets; l++)
            arb_poly_set_coeff_arb(jet + n, l, f + l * (y->degree + 1) + n);
    }
}

int collision_series(arb_poly_t y_series, arb_poly_t tau, arb_poly_t c, slong order, const struct law *law, slong prec)
{
    const slong count = order + 1;
    struct taylor y;
    arb_poly_struct *w = jet_new(count), *v = jet_new(count), *t = jet_new(count);
    arb_poly_t delta;
    arb_t value, root;
    bool turned = false, done = false;
    arb_poly_init(delta);
    arb_init(value);
    arb_init(root);

    taylor_init(&y, law, count, FLINT_MAX(degree_for(prec), count), prec);
    /* beta itself is the parameter; series are measured at |beta| = 1/2, well inside |h*| for the sphere. */
    mag_set_ui_2exp_si(y.weight, 1, -1);
    if (count > 1)
        arb_one(y.c1 + 1);
    arb_one(y.c2);
    arb_one(y.v);
    for (slong step = 0; step < MAX_STEPS && !done; step++) {
        progress("series by the equation of motion", step, 0);
        taylor_expand(&y);
        if (!taylor_choose_step(&y))
            break;
        const enum taylor_component event = turned ? TAYLOR_W : TAYLOR_V;
        taylor_value(value, &y, event, 0, y.step);
        if (arb_is_positive(value)) {
            taylor_advance(&y, y.step);
            continue;
        }
        if (!arb_is_negative(value) || !taylor_root(root, &y, event, y.step))
            break;
        /* At the elastic event the rest is formal: nothing but power series in beta. */
        taylor_advance(&y, root);
        arb_zero(turned ? y.w : y.v);
        taylor_expand(&y);
        component_jets(w, count, y.w, &y);
        component_jets(v, count, y.v, &y);
        component_jets(t, count, y.t, &y);
        jet_solve(delta, turned ? w : v, count, count, prec);
        if (!turned) {
            jet_compose(y_series, w, count, delta, count, prec);
            arb_poly_pow_ui_trunc_binexp(y_series, y_series, (ulong)law->d, count, prec);
            jet_compose(tau, t, count, delta, count, prec);
            turned = true;
            /* Past the turning point by an exact step, so that the same event is not met again. */
            if (!taylor_choose_step(&y))
                break;
            arb_get_mid_arb(root, y.step);
            taylor_advance(&y, root);
        } else {
            jet_compose(c, v, count, delta, count, prec);
            arb_poly_neg(c, c);
            done = true;
        }
    }
    progress_end();
    taylor_clear(&y);
    jet_free(w, count);
    jet_free(v, count);
    jet_free(t, count);
    arb_poly_clear(delta);
    arb_clear(value);
    arb_clear(root);
    return done ? STATUS_OK
                : fail("the equation of motion could not be carried to order %ld with %ld bits", (long)order,
                       (long)prec);
}
