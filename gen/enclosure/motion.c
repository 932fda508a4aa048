/* SPDX-License-Identifier: MIT */
#include "enclosure/motion.h"

#include "enclosure/slow_manifold.h"
#include "enclosure/taylor.h"
#include "support/console.h"
#include "support/local.h"

/* LEAST_BITS: with fewer accurate bits of w or t, the motion ends with MOTION_IMPRECISE. PRESSED_STEPS: more steps of a
 * stiff motion under a constant force would take minutes. */
enum { LEAST_BITS = 8, PRESSED_STEPS = 2000 };

void collision_init(struct collision *c)
{
    for (int i = 0; i < COLLISION_FIELDS; i++)
        arb_init(c->field[i]);
}

void collision_clear(struct collision *c)
{
    for (int i = 0; i < COLLISION_FIELDS; i++)
        arb_clear(c->field[i]);
}

/* State of a motion under a constant force */
struct pressing {
    bool any;         /* true if a force acts */
    bool held, stuck; /* held: the bodies are proved never to reach the surface; stuck: the overlap never vanishes */
    bool has_release; /* 2 (a - b) > 1: only bodies released at w >= release reach the surface */
    bool cut;         /* the last step ended at the overlap of release */
    arb_t release;    /* w at the overlap of release */
    arb_t least;      /* energy of bodies released at `release`; with less they never reach the surface */
};

struct motion {
    struct collision *c;
    arb_t length; /* x = length X, t = length s, X'' + c1 X^b X' + c2 X^a = 0 */
    struct taylor y;
    bool force_ends; /* true if the force vanishes before the overlap; never without damping or for a <= b */
    bool turned, released, parted;
    struct pressing pressing;
    arb_t begin; /* place in the current step after which the ends of contact are searched */
};

/* The scales of weak damping are length = 1, c1 = beta and c2 = 1. The scales of strong damping, which are regular for
 * any large beta, are length = beta^(-1/(b+1)), c1 = 1 and c2 = mu. */
static void motion_init(struct motion *m, struct collision *c, const arb_t beta, const struct cor_exponents *law,
                        bool strong, slong prec)
{
    LOCAL(arb, scale);
    *m = (struct motion){.c = c};
    FOR_ALL(arb, init, m->length, m->begin, m->pressing.release, m->pressing.least);
    taylor_init(&m->y, law, taylor_degree(prec), prec);
    arb_one(scale);
    if (strong)
        arb_inv(scale, beta, prec);
    LET(m->length, prec, "scale^(1/(law->b + 1))", scale, law);
    LET(m->y.c2, prec, "scale^((law->a + 1)/(law->b + 1))", scale, law);
    arb_one(m->y.v);
    arb_set(m->y.c1, strong ? m->y.v : beta);
    m->force_ends = law_force_ends(law) && !arb_is_zero(beta);
}

static void motion_clear(struct motion *m)
{
    taylor_clear(&m->y);
    FOR_ALL(arb, clear, m->length, m->begin, m->pressing.release, m->pressing.least);
}

static void motion_record(arb_t eps, arb_t time, const struct motion *m, const arb_t root)
{
    taylor_value(eps, &m->y, TAYLOR_V, root);
    arb_neg(eps, eps);
    taylor_value(time, &m->y, TAYLOR_T, root);
    arb_mul(time, time, m->length, m->y.prec);
}

/* Each of the find functions below searches the current step for one of the three events and records it. The function
 * returns false if the intervals do not decide. */

static bool find_turning_point(struct motion *m)
{
    struct taylor *y = &m->y;
    LOCAL(arb, value, root);
    arb_zero(m->begin);
    const enum taylor_crossing crossing = taylor_crosses(root, y, TAYLOR_V, m->begin, y->step);
    if (crossing == TAYLOR_CROSSED) {
        m->turned = true;
        arb_get_ubound_arf(arb_midref(m->begin), root, y->prec);
        taylor_value(value, y, TAYLOR_W, root);
        const slong d = y->law.denominator;
        LET(m->c->x_max, y->prec, "value^d*m->length", value, d, m->length);
        taylor_value(value, y, TAYLOR_T, root);
        arb_mul(m->c->t_max, value, m->length, y->prec);
    }
    return crossing != TAYLOR_UNDECIDED;
}

/* Sets `end`, the end of the step, to the zero of the overlap. */
static bool find_zero_overlap(struct motion *m, arb_t end)
{
    struct taylor *y = &m->y;
    const enum taylor_crossing crossing = taylor_crosses(end, y, TAYLOR_W, m->begin, y->step);
    m->parted = crossing == TAYLOR_CROSSED;
    if (m->parted)
        motion_record(m->c->eps_zero_overlap, m->c->t_zero_overlap, m, end);
    return crossing != TAYLOR_UNDECIDED;
}

/* Shortens a step that passes the overlap of release under a constant force, so that it ends just above that overlap. A
 * contact force that vanishes on the way to x = 0 can grow again only below that overlap. After the cut, the signs of
 * the force at both ends of a step therefore show whether it vanishes in the step. Returns true if `end` moved. */
static bool cut_at_release(struct motion *m, arb_t end)
{
    struct taylor *y = &m->y;
    struct pressing *const p = &m->pressing;
    LOCAL(arb, w, middle);
    taylor_value(w, y, TAYLOR_W, end);
    if (!p->has_release || p->cut || m->parted || arb_gt(w, p->release) || !arb_gt(y->w, p->release))
        return false;
    LOCAL(arb, low, high);
    arb_set(low, m->begin);
    arb_set(high, end);
    for (slong i = 0; i < y->prec / 2; i++) {
        arb_add(middle, low, high, y->prec);
        arb_mul_2exp_si(middle, middle, -1);
        arb_get_mid_arb(middle, middle);
        taylor_value(w, y, TAYLOR_W, middle);
        arb_set(arb_gt(w, p->release) ? low : high, middle);
    }
    arb_get_mid_arb(end, low);
    arb_set(y->step, end);
    return p->cut = true;
}

/* Records the zero-force end, or under a constant force the flight from there to the surface. Returns false if the
 * intervals do not decide whether the flight reaches it. */
static bool record_release(struct motion *m, const arb_t root)
{
    struct collision *const c = m->c;
    const struct taylor *const y = &m->y;
    motion_record(c->eps_zero_force, c->t_zero_force, m, root);
    if (!m->pressing.any)
        return true;
    const slong d = y->law.denominator;
    LOCAL(arb, x, rest);
    taylor_value(x, y, TAYLOR_W, root);
    LET(x, y->prec, "x^d", x, d);
    LET(rest, y->prec, "c->eps_zero_force^2 - 2*y->c3*x", c->eps_zero_force, y->c3, x);
    if (!arb_is_positive(rest))
        return false;
    LET(c->t_zero_force, y->prec, "c->t_zero_force + 2*x*m->length/(c->eps_zero_force + sqrt(rest))", c->t_zero_force,
        x, m->length, c->eps_zero_force, rest);
    arb_sqrt(c->eps_zero_force, rest, y->prec);
    return true;
}

/* Searches the step before `end` for a zero of the force. If a zero of the overlap in the same step is too close, the
 * function does not separate the two. */
static bool find_zero_force(struct motion *m, arb_t end)
{
    LOCAL(arb, root);
    const bool passed = m->pressing.cut;
    if (m->pressing.any && !cut_at_release(m, end) && passed)
        return false; /* the step starts at the overlap of release, where the energy did not decide `held` */
    const enum taylor_crossing crossing = taylor_crosses(root, &m->y, TAYLOR_FORCE, m->begin, end);
    m->released = crossing == TAYLOR_CROSSED;
    if (m->released && !record_release(m, root))
        return false;
    return crossing != TAYLOR_UNDECIDED || m->parted;
}

/* Records the zero-force end if it is too close to zero overlap to be separated by signs. While the force is attractive
 * the speed u falls from u_f <= 1 at x_f = (c1 u_f)^(1/(a-b)) to eps, so
 *
 *   0 <= u_f^2 - eps^2 <= 2 c1 x_f^(b+1)/(b+1),   0 <= t_zero_overlap - t_zero_force <= x_f/eps. */
static void release_at_end(struct motion *m)
{
    struct collision *c = m->c;
    const struct ratio a = law_elastic(&m->y.law), b = law_damping(&m->y.law);
    const slong prec = m->y.prec;
    const arb_srcptr c1 = m->y.c1, length = m->length, eps = c->eps_zero_overlap, time = c->t_zero_overlap;
    LOCAL(arb, x, y);
    arb_set(c->eps_zero_force, eps);
    arb_set(c->t_zero_force, time);
    if (!m->force_ends)
        return;
    LET(x, prec, "c1^(1/(a - b))", c1, a, b);
    LET(y, prec, "time - x*length/eps", time, x, length, eps);
    arb_union(c->t_zero_force, c->t_zero_force, y, prec);
    LET(x, prec, "sqrt(2*x^(b + 1)*c1/(b + 1) + eps^2)", x, b, c1, eps);
    arb_union(c->eps_zero_force, c->eps_zero_force, x, prec);
}

/* True if the overlap is proved to creep to zero without reaching it, so that eps = 0. While u = -x' >= 0,
 * k = u/x^(b+1) obeys k'/x^b = (b+1) k^2 - c1 k + c2 x^(a-2b-1). If a >= 2b+1 (q <= 0) the last term cannot grow again.
 * Once the right side is not positive at K = c1/(2(b+1)) and k < K, k never exceeds K, and x^(b+1) does not reach 0. */
static bool is_slow(const struct taylor *y)
{
    const struct ratio b = law_damping(&y->law);
    const slong b1 = y->law.damping + y->law.denominator, excess = y->law.elastic - y->law.damping - b1;
    if (excess < 0)
        return false;
    /* k < K, and c1^2/(4(b+1)) >= c2 x^(a-2b-1) */
    return HOLDS(y->prec, "2*(b + 1)*y->v/y->w^b1 + y->c1 > 0", b, b1, y->v, y->w, y->c1) &&
           HOLDS(y->prec, "y->c1^2/(4*(b + 1)) > y->c2*y->w^excess", y->c1, b, y->c2, y->w, excess);
}

/* ---- a constant force: docs/theory.md, 24 ---- */

/* Computes the energy v^2/2 + c2 X^(a+1)/(a+1) - c3 X, X = w^d, which never grows. */
static void set_energy(arb_t e, const struct taylor *y, const arb_t w, const arb_t v)
{
    const slong d = y->law.denominator, ad = y->law.elastic;
    LET(e, y->prec, "(y->c2*w^ad*d/(ad + d) - y->c3)*w^d + v^2/2", y->c2, w, ad, d, y->c3, v);
}

/* Sets the constant force, in the scales of the motion, and the fields that depend on it. */
static void set_pressing(struct motion *m, const arb_t force)
{
    struct taylor *const y = &m->y;
    struct pressing *const p = &m->pressing;
    const slong d = y->law.denominator, ad = y->law.elastic, power = 2 * (ad - y->law.damping) - d;
    LOCAL(arb, ratio);
    p->any = true;
    arb_mul(y->c3, force, m->length, y->prec);
    if (!m->force_ends)
        return;
    p->has_release = power > 0;
    if (power <= 0)
        return; /* the least energy of a release is 0 */
    /* At the release the contact force vanishes, so v = (c2/c1) X^(a-b). The flight just reaches the surface if
     * v^2 = 2 c3 X. Together: (c2/c1)^2 X^(2(a-b)-1) = 2 c3. */
    arb_div(ratio, y->c1, y->c2, y->prec);
    LET(p->release, y->prec, "(2*ratio^2*y->c3)^(1/power)", ratio, y->c3, power);
    LET(p->least, y->prec, "p->release^(ad + d)*y->c2*d/(ad + d)", p->release, ad, d, y->c2);
}

/* True if the overlap is proved to rise towards its value at rest, X_e, without passing it. Let k be half of the
 * damping coefficient at the current X. Once v < k (X_e - X), this remains true if k^2 is at least the largest slope of
 * c2 X^a up to X_e. */
static bool creeps_up(arb_t rest, const struct taylor *y)
{
    const struct ratio a = law_elastic(&y->law);
    const slong d = y->law.denominator, bd = y->law.damping;
    LOCAL(arb, x, k, slope);
    LET(rest, y->prec, "(y->c3/y->c2)^(1/a)", y->c3, y->c2, a);
    LET(x, y->prec, "y->w^d", y->w, d);
    LET(k, y->prec, "y->w^bd*y->c1/2", y->w, bd, y->c1);
    LET(slope, y->prec, "max(rest^(a - 1), x^(a - 1))*y->c2*a", rest, a, x, y->c2);
    return arb_lt(x, rest) && HOLDS(y->prec, "k^2 > slope", k, slope) && arb_is_positive(y->v) &&
           HOLDS(y->prec, "y->v < k*(rest - x)", y->v, k, rest, x);
}

static void set_stay(arb_t eps, arb_t time)
{
    arb_zero(eps);
    arb_pos_inf(time);
}

/* Records events that are proved never to happen. True if all events that the goal requires are then known. */
static bool proves_stay(struct motion *m, enum motion_goal goal)
{
    struct collision *const c = m->c;
    struct pressing *const p = &m->pressing;
    LOCAL(arb, level);
    if (!m->turned && creeps_up(level, &m->y)) {
        arb_mul(c->x_max, level, m->length, m->y.prec);
        arb_pos_inf(c->t_max);
        m->turned = true;
    }
    if (!m->turned)
        return false;
    set_energy(level, &m->y, m->y.w, m->y.v);
    if (!p->stuck && arb_is_negative(level)) {
        p->stuck = true;
        set_stay(c->eps_zero_overlap, c->t_zero_overlap);
        if (!m->force_ends)
            set_stay(c->eps_zero_force, c->t_zero_force);
    }
    if (m->force_ends && !m->released && !p->held && arb_lt(level, p->least)) {
        p->held = true;
        set_stay(c->eps_zero_force, c->t_zero_force);
    }
    const bool force_known = !m->force_ends || m->released || p->held;
    return force_known && (p->stuck || goal == MOTION_ZERO_FORCE);
}

/* Computes y = mu X^-n and p = -X'/(mu X^(a-b)) of slow_manifold.h for a state in strong scales, where X = w^d. */
static void manifold_state(arb_t place, arb_t slope, const struct taylor *y)
{
    const slong difference = y->law.elastic - y->law.damping, n = y->law.damping - difference + y->law.denominator;
    LET(place, y->prec, "y->c2/y->w^n", y->c2, y->w, n);
    LET(slope, y->prec, "-(y->v/(y->w^difference*y->c2))", y->v, y->w, difference, y->c2);
}

/* Finds the events after the turning point in the current step. Returns false if the intervals do not decide. */
static bool find_ends(struct motion *m)
{
    const struct pressing *const p = &m->pressing;
    LOCAL(arb, end);
    arb_set(end, m->y.step);
    if ((!p->stuck && !find_zero_overlap(m, end)) ||
        (m->force_ends && !m->released && !p->held && !find_zero_force(m, end)))
        return false;
    const bool at_end = m->parted && !m->released;
    if (at_end)
        release_at_end(m);
    return !at_end || !p->any || !m->force_ends;
}

/* Makes steps until the goal is reached, or until the motion is within 2^-bits of a given slow manifold. */
static enum motion_outcome motion_follow(struct motion *m, enum motion_goal goal, const struct slow_manifold *manifold,
                                         slong bits)
{
    struct taylor *y = &m->y;
    const slong most = m->pressing.any ? PRESSED_STEPS : TAYLOR_MAX_STEPS;
    LOCAL(arb, place, slope);
    for (slong step = 0; step < most; step++) {
        progress("collision", step, 0);
        taylor_expand(y);
        if (!taylor_choose_step(y) || (!m->turned && !find_turning_point(m)))
            return MOTION_IMPRECISE;
        if (m->turned && goal == MOTION_TURNING_POINT)
            return MOTION_DONE;
        if (m->turned && !find_ends(m))
            return MOTION_IMPRECISE;
        if (m->parted || (m->released && goal == MOTION_ZERO_FORCE))
            return MOTION_DONE;
        taylor_advance(y, y->step);
        arb_zero(m->begin);
        if (arb_rel_accuracy_bits(y->w) < LEAST_BITS || arb_rel_accuracy_bits(y->t) < LEAST_BITS)
            return MOTION_IMPRECISE;
        if (m->pressing.any) {
            if (proves_stay(m, goal))
                return MOTION_DONE;
        } else if (manifold && m->turned && (m->released || !m->force_ends)) {
            manifold_state(place, slope, y);
            if (slow_manifold_reached(manifold, place, slope, bits))
                return MOTION_DONE;
            if (arb_gt(place, manifold->last)) /* the motion left the domain of the manifold */
                return arb_rel_accuracy_bits(slope) > bits ? MOTION_MISSED : MOTION_IMPRECISE;
        } else if (m->released && is_slow(y)) {
            set_stay(m->c->eps_zero_overlap, m->c->t_zero_overlap);
            return MOTION_DONE;
        }
    }
    return MOTION_ENDLESS;
}

enum motion_outcome motion_solve(struct collision *c, const arb_t beta, const struct cor_exponents *law,
                                 enum motion_goal goal, slong prec)
{
    LOCAL_INIT(motion, m, (&m, c, beta, law, arf_cmp_si(arb_midref(beta), 1) > 0, prec));
    return motion_follow(&m, goal, NULL, 0);
}

enum motion_outcome motion_solve_pressed(struct collision *c, const arb_t beta, const arb_t force,
                                         const struct cor_exponents *law, enum motion_goal goal, slong prec)
{
    const struct cor_exponents even = law_even(law); /* w = v = 0 is a point of rest only if d > 1 */
    LOCAL_INIT(motion, m, (&m, c, beta, &even, arf_cmp_si(arb_midref(beta), 1) > 0, prec));
    set_pressing(&m, force);
    return motion_follow(&m, goal, NULL, 0);
}

/* Adds the motion on the slow manifold. Its unit of length is beta^(-2/n), of speed beta^(-1/q), of time
 * beta^((a-1)/n). */
static bool add_fall(struct collision *c, const struct motion *m, const struct slow_manifold *manifold,
                     const arb_t beta, slong bits)
{
    const struct cor_exponents *law = &m->y.law;
    const struct ratio a = law_elastic(law), n = law_fall_power(law), q = law_speed_exponent(law);
    LOCAL(arb, place, slope, time);
    manifold_state(place, slope, &m->y);
    const bool reached = slow_manifold_time(time, manifold, place, slope, bits);
    if (reached) {
        LET(c->t_zero_overlap, m->y.prec, "m->y.t*m->length + (time + manifold->t_fall)*beta^((a - 1)/n)", m->y.t,
            m->length, time, manifold->t_fall, beta, a, n);
        LET(c->eps_zero_overlap, m->y.prec, "manifold->final_speed*beta^(-1/q)", manifold->final_speed, beta, q);
        if (!m->released) { /* the two ends coincide */
            arb_set(c->eps_zero_force, c->eps_zero_overlap);
            arb_set(c->t_zero_force, c->t_zero_overlap);
        }
    }
    return reached;
}

enum motion_outcome motion_solve_slow(struct collision *c, const arb_t beta, const struct cor_exponents *law,
                                      slong bits, slong prec)
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

/* While the bodies approach, the force has one maximum, where its slope falls through zero (docs/theory.md, 9). If b =
 * 0, the force at the first moment may be larger. Then a zero of the slope is a minimum if the damping force still
 * exceeds a/(a - 1) times the elastic force. */
enum motion_outcome motion_force_max(arb_t force, const arb_t beta, const struct cor_exponents *law, slong prec)
{
    LOCAL_INIT(motion, m, (&m, NULL, beta, law, arf_cmp_si(arb_midref(beta), 1) > 0, prec));
    struct taylor *const y = &m.y;
    LOCAL(arb, root, value, zero);
    arb_zero(force);
    if (law->damping == 0) {
        arb_set(force, beta);
        if (law->elastic > law->denominator) {
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
    const slong power = FLINT_MIN(law->elastic, law->damping);
    LET(force, prec, "max(force, value*root^power/m.length)", force, value, root, power, m.length);
    return MOTION_DONE;
}
