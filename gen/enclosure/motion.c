/* SPDX-License-Identifier: MIT */
#include "enclosure/motion.h"

#include "enclosure/slow_manifold.h"
#include "enclosure/taylor.h"
#include "support/console.h"
#include "support/local.h"

/* The motion ends as imprecise if w or t has fewer bits. */
enum { LEAST_BITS = 8 };

/* The scales in which the equation of motion is integrated: x = length X, t = length s,
 * X'' + c1 X^b X' + c2 X^a = 0. Weak scales are 1, beta, 1. Strong scales have length = beta^(-1/(b+1)), c1 = 1 and c2
 * = mu, which is regular for any large beta. */
struct scales {
    arb_t length, c1, c2;
};

static void scales_init(struct scales *s, const arb_t beta, const struct law *law, bool strong, slong prec)
{
    FOR_ALL(arb, init, s->length, s->c1, s->c2);
    if (strong) {
        const struct ratio one = {1, 1};
        LOCAL(arb, inverse);
        arb_inv(inverse, beta, prec);
        arb_pow_ratio(s->c2, inverse, law_mu_power(law), prec);
        arb_pow_ratio(s->length, inverse, ratio_div(one, ratio_add(law->b, one)), prec);
        arb_one(s->c1);
    } else {
        arb_one(s->length);
        arb_set(s->c1, beta);
        arb_one(s->c2);
    }
}

static void scales_clear(struct scales *s)
{
    FOR_ALL(arb, clear, s->length, s->c1, s->c2);
}

struct motion {
    struct collision *c;
    struct scales s;
    struct taylor y;
    bool force_ends; /* whether the force vanishes before the overlap; never without damping or for a <= b */
    bool turned, released, parted;
    arb_t begin; /* begin of the part of the current step after the turning point */
};

static void motion_init(struct motion *m, struct collision *c, const arb_t beta, const struct law *law, bool strong,
                        slong prec)
{
    m->c = c;
    scales_init(&m->s, beta, law, strong, prec);
    taylor_init(&m->y, law, taylor_degree(prec), prec);
    arb_set(m->y.c1, m->s.c1);
    arb_set(m->y.c2, m->s.c2);
    arb_one(m->y.v);
    m->force_ends = law_force_ends(law) && !arb_is_zero(beta);
    m->turned = m->released = m->parted = false;
    arb_init(m->begin);
}

static void motion_clear(struct motion *m)
{
    taylor_clear(&m->y);
    scales_clear(&m->s);
    arb_clear(m->begin);
}

static void motion_record(arb_t eps, arb_t time, const struct motion *m, const arb_t root)
{
    taylor_value(eps, &m->y, TAYLOR_V, root);
    arb_neg(eps, eps);
    taylor_value(time, &m->y, TAYLOR_T, root);
    arb_mul(time, time, m->s.length, m->y.prec);
}

/* The three events. Each function searches the current step for an event and records it. It returns false if the
 * intervals do not decide. */

static bool find_turning_point(struct motion *m)
{
    struct taylor *y = &m->y;
    LOCAL(arb, value, root);
    taylor_value(value, y, TAYLOR_V, y->step);
    arb_zero(m->begin);
    bool decided = arb_is_positive(value);
    if (arb_is_negative(value) && taylor_root(root, y, TAYLOR_V, m->begin, y->step)) {
        decided = true;
        m->turned = true;
        arb_get_ubound_arf(arb_midref(m->begin), root, y->prec);
        taylor_value(value, y, TAYLOR_W, root);
        arb_pow_ui(value, value, (ulong)y->law.d, y->prec);
        arb_mul(m->c->x_max, value, m->s.length, y->prec);
        taylor_value(value, y, TAYLOR_T, root);
        arb_mul(m->c->t_max, value, m->s.length, y->prec);
    }
    return decided;
}

/* Sets `end` to the place where the overlap vanishes, or to the end of the step. */
static bool find_zero_overlap(struct motion *m, arb_t end)
{
    struct taylor *y = &m->y;
    LOCAL(arb, value);
    arb_set(end, y->step);
    taylor_value(value, y, TAYLOR_W, y->step);
    bool decided = arb_is_positive(value);
    if (arb_is_negative(value) && taylor_root(end, y, TAYLOR_W, m->begin, y->step)) {
        decided = true;
        m->parted = true;
        motion_record(m->c->eps_zero_overlap, m->c->t_zero_overlap, m, end);
    }
    return decided;
}

/* Searches before `end`. If the overlap vanishes in the same step, the two events may be too close to be separated. */
static bool find_zero_force(struct motion *m, const arb_t end)
{
    struct taylor *y = &m->y;
    LOCAL(arb, value, root);
    taylor_value(value, y, TAYLOR_FORCE, end);
    bool decided = arb_is_positive(value) || m->parted;
    if (arb_is_negative(value) && taylor_root(root, y, TAYLOR_FORCE, m->begin, end)) {
        decided = true;
        m->released = true;
        motion_record(m->c->eps_zero_force, m->c->t_zero_force, m, root);
    }
    return decided;
}

/* The zero-force end if it is too close to zero overlap to be separated by signs. While the force is attractive the
 * speed u falls, from u_f <= 1 at x_f = (c1 u_f)^(1/(a-b)) to eps, so
 *
 *   0 <= u_f^2 - eps^2 <= 2 c1 x_f^(b+1)/(b+1),   0 <= t_zero_overlap - t_zero_force <= x_f/eps. */
static void release_at_end(struct motion *m)
{
    struct collision *c = m->c;
    const struct law *law = &m->y.law;
    const slong prec = m->y.prec;
    const struct ratio one = {1, 1}, b1 = ratio_add(law->b, one);
    LOCAL(arb, x, y);
    arb_set(c->eps_zero_force, c->eps_zero_overlap);
    arb_set(c->t_zero_force, c->t_zero_overlap);
    if (!m->force_ends)
        return;
    arb_pow_ratio(x, m->s.c1, ratio_div(one, ratio_sub(law->a, law->b)), prec);
    arb_mul(y, x, m->s.length, prec);
    arb_div(y, y, c->eps_zero_overlap, prec);
    arb_sub(y, c->t_zero_overlap, y, prec);
    arb_union(c->t_zero_force, c->t_zero_force, y, prec);
    arb_pow_ratio(x, x, b1, prec);
    arb_mul(x, x, m->s.c1, prec);
    arb_mul_2exp_si(x, x, 1);
    arb_set_ratio(y, b1, prec);
    arb_div(x, x, y, prec);
    arb_addmul(x, c->eps_zero_overlap, c->eps_zero_overlap, prec);
    arb_sqrt(x, x, prec);
    arb_union(c->eps_zero_force, c->eps_zero_force, x, prec);
}

/* Whether the overlap creeps to zero and never reaches it, so that eps = 0. While u = -x' >= 0, k = u/x^(b+1) obeys
 * k'/x^b = (b+1) k^2 - c1 k + c2 x^(a-2b-1). If a >= 2b+1 (q <= 0) the last term cannot grow again. Once the right side
 * is not positive at K = c1/(2(b+1)) and k < K, k never exceeds K, and x^(b+1) does not reach 0. */
static bool creeps(const struct taylor *y)
{
    const slong d = y->law.d, b1 = y->law.bd + d, excess = y->law.ad - y->law.bd - b1;
    if (excess < 0)
        return false;
    LOCAL(arb, k, x);
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
    return never;
}

/* The place y = mu X^-n and slope p = -X'/(mu X^(a-b)) of slow_manifold.h, of a state in strong scales, w^d = X. */
static void manifold_state(arb_t place, arb_t slope, const struct taylor *y)
{
    const slong difference = y->law.ad - y->law.bd, n = y->law.bd - difference + y->law.d;
    arb_pow_ui(place, y->w, (ulong)n, y->prec);
    arb_div(place, y->c2, place, y->prec);
    arb_pow_ui(slope, y->w, (ulong)FLINT_ABS(difference), y->prec);
    if (difference < 0)
        arb_inv(slope, slope, y->prec);
    arb_mul(slope, slope, y->c2, y->prec);
    arb_div(slope, y->v, slope, y->prec);
    arb_neg(slope, slope);
}

/* Whether the motion goes on after the current state. If not, sets the outcome. */
static bool motion_goes_on(enum motion_outcome *outcome, const struct motion *m, const struct slow_manifold *manifold,
                           slong bits)
{
    bool ends = false;
    *outcome = MOTION_DONE;
    if (manifold && m->turned && (m->released || !m->force_ends)) {
        LOCAL(arb, place, slope);
        manifold_state(place, slope, &m->y);
        ends = slow_manifold_reached(manifold, place, slope, bits);
        if (!ends && arb_gt(place, manifold->last)) { /* the state left the domain of the manifold without reaching
                                                       * it */
            *outcome = arb_rel_accuracy_bits(slope) > bits ? MOTION_MISSED : MOTION_IMPRECISE;
            ends = true;
        }
    } else if (m->released && creeps(&m->y)) {
        arb_zero(m->c->eps_zero_overlap);
        arb_pos_inf(m->c->t_zero_overlap);
        ends = true;
    }
    return !ends;
}

/* Makes one step: records its events and advances the state. Returns true while the motion goes on. */
static bool motion_step(enum motion_outcome *outcome, struct motion *m, enum motion_goal goal)
{
    struct taylor *y = &m->y;
    LOCAL(arb, end);
    *outcome = MOTION_IMPRECISE;
    taylor_expand(y);
    bool decided = taylor_choose_step(y) && (m->turned || find_turning_point(m));
    bool reached = m->turned && goal == MOTION_TURNING_POINT;
    if (decided && m->turned && !reached) {
        decided = find_zero_overlap(m, end);
        if (decided && m->force_ends && !m->released)
            decided = find_zero_force(m, end);
        if (decided && m->parted && !m->released)
            release_at_end(m);
        reached = m->parted || (m->released && goal == MOTION_ZERO_FORCE);
    }
    if (decided && reached)
        *outcome = MOTION_DONE;
    if (decided && !reached) {
        taylor_advance(y, y->step);
        arb_zero(m->begin);
        decided = arb_rel_accuracy_bits(y->w) >= LEAST_BITS && arb_rel_accuracy_bits(y->t) >= LEAST_BITS;
    }
    return decided && !reached;
}

static enum motion_outcome motion_follow(struct motion *m, enum motion_goal goal, const struct slow_manifold *manifold,
                                         slong bits)
{
    enum motion_outcome outcome;
    for (slong step = 0; step < TAYLOR_MAX_STEPS; step++) {
        progress("collision", step, 0);
        if (!motion_step(&outcome, m, goal) || !motion_goes_on(&outcome, m, manifold, bits))
            return outcome;
    }
    return MOTION_ENDLESS;
}

enum motion_outcome motion_solve(struct collision *c, const arb_t beta, const struct law *law, enum motion_goal goal,
                                 slong prec)
{
    LOCAL_INIT(motion, m, (&m, c, beta, law, arf_cmp_si(arb_midref(beta), 1) > 0, prec));
    const enum motion_outcome outcome = motion_follow(&m, goal, NULL, 0);
    return outcome;
}

/* In units of the slow manifold, x = beta^(-2/n) z: a speed is beta^(-1/q), a time beta^((a-1)/n). */
static bool add_fall(struct collision *c, const struct motion *m, const struct slow_manifold *manifold,
                     const arb_t beta, slong bits)
{
    const struct law *law = &m->y.law;
    const slong prec = m->y.prec;
    const struct ratio one = {1, 1};
    const struct ratio to_speed = ratio_div((struct ratio){-1, 1}, law_speed_exponent(law));
    const struct ratio to_time = ratio_div(ratio_sub(law->a, one), law_fall_power(law));
    LOCAL(arb, place, slope, time, unit);
    manifold_state(place, slope, &m->y);
    const bool reached = slow_manifold_time(time, manifold, place, slope, bits);
    if (reached) {
        arb_add(time, time, manifold->t_fall, prec);
        arb_pow_ratio(unit, beta, to_time, prec);
        arb_mul(c->t_zero_overlap, m->y.t, m->s.length, prec);
        arb_addmul(c->t_zero_overlap, time, unit, prec);
        arb_pow_ratio(unit, beta, to_speed, prec);
        arb_mul(c->eps_zero_overlap, manifold->final_speed, unit, prec);
        if (!m->released) { /* the two ends coincide */
            arb_set(c->eps_zero_force, c->eps_zero_overlap);
            arb_set(c->t_zero_force, c->t_zero_overlap);
        }
    }
    return reached;
}

enum motion_outcome motion_solve_slow(struct collision *c, const arb_t beta, const struct law *law, slong bits,
                                      slong prec)
{
    const struct slow_manifold *const manifold = slow_manifold_of(law, bits, prec);
    if (!manifold)
        return MOTION_IMPRECISE;
    LOCAL_INIT(motion, m, (&m, c, beta, law, true, prec));
    enum motion_outcome outcome = motion_follow(&m, MOTION_ZERO_OVERLAP, manifold, bits);
    if (outcome == MOTION_DONE && !m.parted && !add_fall(c, &m, manifold, beta, bits))
        outcome = MOTION_IMPRECISE;
    return outcome;
}

/* docs/theory.md, 9. The force has one largest value within the contact, where its slope falls through zero while
 * the bodies approach. Where b = 0 the first moment may have more; then a zero of the slope is a least value while the
 * damping force exceeds the elastic one a/(a - 1) times. */
enum motion_outcome motion_force_max(arb_t force, const arb_t beta, const struct law *law, slong prec)
{
    LOCAL_INIT(motion, m, (&m, NULL, beta, law, arf_cmp_si(arb_midref(beta), 1) > 0, prec));
    struct taylor *const y = &m.y;
    LOCAL(arb, root, value, zero);
    arb_zero(force);
    if (law->bd == 0) {
        arb_set(force, beta);
        if (law->ad > law->d) {
            if (!taylor_follow(root, y, TAYLOR_DAMPING_EXCESS, "largest force"))
                return MOTION_IMPRECISE;
            taylor_advance(y, root);
        }
        taylor_value(value, y, TAYLOR_FORCE_SLOPE, zero);
        if (arb_is_nonpositive(value))
            return MOTION_DONE;
        if (!arb_is_positive(value))
            return MOTION_IMPRECISE;
    }
    if (!taylor_follow(root, y, TAYLOR_FORCE_SLOPE, "largest force"))
        return MOTION_IMPRECISE;
    taylor_value(value, y, TAYLOR_V, root);
    if (!arb_is_positive(value))
        return MOTION_IMPRECISE;
    taylor_value(value, y, TAYLOR_FORCE, root);
    taylor_value(root, y, TAYLOR_W, root);
    arb_pow_ui(root, root, (ulong)FLINT_MIN(law->ad, law->bd), prec);
    arb_mul(value, value, root, prec);
    arb_div(value, value, m.s.length, prec);
    arb_max(force, force, value, prec);
    return MOTION_DONE;
}
