/* SPDX-License-Identifier: MIT */
#include "enclosure/collision.h"

#include <math.h>

#include "enclosure/closed_form.h"
#include "enclosure/motion.h"
#include "enclosure/slow_manifold.h"
#include "enclosure/taylor.h"
#include "series/restitution.h"
#include "series/series.h"
#include "support/console.h"

/* The ends of contact whose fields are requested, besides x_max and t_max */
enum ends { ENDS_BOTH, ENDS_ZERO_OVERLAP, ENDS_ZERO_FORCE };

static slong accuracy_bits(const struct collision *c, enum ends ends)
{
    slong bits = WORD_MAX;
    for (int i = 0; i < COLLISION_FIELDS; i++) {
        const bool asked = i > 3 || ends == ENDS_BOTH || (ends == ENDS_ZERO_FORCE) == (i % 2 == 1);
        if (asked && !arb_is_exact(c->field[i]))
            bits = FLINT_MIN(bits, arb_rel_accuracy_bits(c->field[i]));
    }
    return bits;
}

/* The method of a solution, and its number of bits */
struct route {
    enum motion_goal goal;
    bool slow;           /* true if the slow manifold is used */
    slong manifold_bits; /* the motion must come within 2^-manifold_bits of the slow manifold */
    slong prec;
    slong direct_prec; /* value of prec if the slow manifold is not used */
};

enum {
    GUARD_BITS = 60,
    ROUTE_GUARD_BITS = 16,
    MANIFOLD_BITS = 12, /* manifold_bits minus the bits of the result */
    ATTEMPTS = 12
};

/* Lost bits for each bit of the motion's contraction: slightly more than measured in 20 laws. If a motion loses more
 * bits than this, the code tries again with higher precision. */
#define GROWTH_LOADING 2.0
#define GROWTH_UNLOADING 1.13
/* Lost bits for each halving of the distance from beta to the threshold, for Hertz's law with a dashpot */
#define GROWTH_BELOW 2.7

/* Chooses the route. The motion contracts by a factor whose logarithm is ln(1/mu) for loading, ln(1/mu) for release
 * (docs/theory.md, 8), and k/mu for unloading to zero overlap (9). If k/mu is large enough, unloading reaches the slow
 * manifold to within manifold_bits, and the manifold replaces the rest. This estimate neglects a power of beta, so a
 * motion just above the limit may miss the manifold at any precision. Then the unloading is integrated. */
static struct route route_of(const arb_t beta, double below, const struct cor_exponents *law, enum ends ends,
                             slong bits)
{
    const double ln_beta = fmax(ball_middle(beta), 0x1p-1000);
    const struct ratio power = law_mu_power(law);
    const double ln_mu = -log(ln_beta) * ratio_double(power), nat = 1 / log(2);
    const double loading = 2 * nat * fmax(-ln_mu, 0);
    struct route r = {.goal = MOTION_ZERO_OVERLAP, .manifold_bits = bits + MANIFOLD_BITS};
    double lost = ROUTE_GUARD_BITS + GROWTH_LOADING * loading, lost_slowly = 0;
    if (ends == ENDS_ZERO_FORCE && law_force_ends(law)) {
        r.goal = MOTION_ZERO_FORCE;
    } else if (law_fall_power(law).num > 0) {
        const double forgets = law_forgetting(law) * exp(-ln_mu), depth = slow_manifold_depth(law, r.manifold_bits);
        const double entry = (double)r.manifold_bits / nat + loading / nat;
        r.slow = forgets > depth + entry;
        lost += GROWTH_UNLOADING * nat * forgets;
        lost_slowly = GUARD_BITS + loading + nat * fmax(entry, depth);
    } else {
        lost += GROWTH_BELOW * fmax(-log2(below), 0);
    }
    r.direct_prec = bits + (slong)fmin(lost, 1e9);
    r.prec = r.slow ? bits + (slong)fmin(lost_slowly, 1e9) : r.direct_prec;
    return r;
}

/* Solves by the route. Closed forms replace results that the motion encloses less tightly, or, near zeta = 1, not at
 * all. */
static enum motion_outcome try_precision(struct collision *c, const arb_t beta, const struct cor_exponents *law,
                                         const struct route *r)
{
    if (law_is_linear(law)) {
        const bool times_known = law->elastic == law->denominator;
        const enum motion_outcome outcome =
            times_known ? MOTION_DONE : motion_solve(c, beta, law, MOTION_ZERO_FORCE, r->prec);
        closed_form_linear(c, beta, law, r->prec);
        return outcome;
    }
    const enum motion_outcome outcome = r->slow ? motion_solve_slow(c, beta, law, r->manifold_bits, r->prec)
                                                : motion_solve(c, beta, law, r->goal, r->prec);
    if (law_is_hunt_crossley(law))
        closed_form_hunt_crossley(c, beta, law, r->prec);
    return outcome;
}

/* Solves for the requested ends. below: the distance from beta up to the threshold of zero overlap, if known */
static int ends_solve(struct collision *c, const arb_t beta, double below, const struct cor_exponents *law,
                      enum ends ends, slong bits)
{
    const bool force = ends == ENDS_ZERO_FORCE;
    if (!arb_is_finite(beta) || !(force ? arb_is_positive(beta) : arb_is_nonnegative(beta)))
        return fail("beta must be a finite number%s",
                    force ? " above 0 if the contact ends at zero force" : ", 0 or more");
    if (arb_is_zero(beta)) { /* (51) */
        turning_point_elastic(c->x_max, c->t_max, law, bits + GUARD_BITS);
        arb_one(c->eps_zero_overlap);
        arb_one(c->eps_zero_force);
        arb_mul_2exp_si(c->t_zero_overlap, c->t_max, 1);
        arb_set(c->t_zero_force, c->t_zero_overlap);
        return STATUS_OK;
    }
    struct route r = route_of(beta, below, law, ends, bits);
    for (int i = 0; i < ATTEMPTS; i++) {
        arb_indeterminate(c->eps_zero_overlap);
        arb_indeterminate(c->t_zero_overlap);
        const enum motion_outcome outcome = try_precision(c, beta, law, &r);
        progress_end();
        if (outcome == MOTION_ENDLESS)
            return fail("the contact does not end within %d steps of the integration: the damping is too strong for "
                        "this law; use less damping",
                        TAYLOR_MAX_STEPS);
        if (outcome == MOTION_MISSED) {
            r.slow = false;
            r.prec = r.direct_prec;
            continue;
        }
        const slong reached = outcome == MOTION_DONE ? accuracy_bits(c, ends) : -1;
        if (reached >= bits)
            return STATUS_OK;
        r.prec += reached > 0 ? bits - reached + ROUTE_GUARD_BITS : r.prec / 2;
    }
    return fail_accuracy("the collision", bits);
}

int collision_solve(struct collision *c, const arb_t beta, const struct cor_exponents *law, slong bits)
{
    return ends_solve(c, beta, 1, law, ENDS_BOTH, bits);
}

int collision_solve_below(struct collision *c, const arb_t beta, double below, const struct cor_exponents *law,
                          slong bits)
{
    return ends_solve(c, beta, below, law, ENDS_ZERO_OVERLAP, bits);
}

int collision_solve_overlap(struct collision *c, const arb_t beta, const struct cor_exponents *law, slong bits)
{
    return collision_solve_below(c, beta, 1, law, bits);
}

int collision_solve_force(struct collision *c, const arb_t beta, const struct cor_exponents *law, slong bits)
{
    return ends_solve(c, beta, 1, law, ENDS_ZERO_FORCE, bits);
}

/* Sets the result for x'' + beta x^b x' = force - 1 >= 0. The overlap grows without bound if force > 1. If force = 1 it
 * grows until the damping has consumed the speed. */
static void never_parts(struct collision *c, const arb_t beta, const arb_t force, const struct cor_exponents *law,
                        slong prec)
{
    const struct ratio b = law_damping(law);
    for (int i = 0; i < COLLISION_FIELDS; i++)
        arb_pos_inf(c->field[i]);
    arb_zero(c->eps_zero_overlap);
    arb_zero(c->eps_zero_force);
    if (arb_is_one(force) && !arb_is_zero(beta))
        LET(c->x_max, prec, "((b + 1)/beta)^(1/(b + 1))", b, beta);
}

int collision_solve_pressed(struct collision *c, const arb_t beta, const arb_t force, const struct cor_exponents *law,
                            int end, slong bits)
{
    enum { MOST_BITS = 1 << 11 };
    const bool elastic = arb_is_zero(beta), alone = end == COR_END_ZERO_FORCE && law_force_ends(law) && !elastic;
    const enum ends ends = alone ? ENDS_ZERO_FORCE : end == COR_END_ZERO_OVERLAP ? ENDS_ZERO_OVERLAP : ENDS_BOTH;
    if (arb_is_zero(force))
        return ends_solve(c, beta, 1, law, end == COR_END_ZERO_FORCE && !elastic ? ENDS_ZERO_FORCE : ends, bits);
    if (!arb_is_finite(beta) || !arb_is_nonnegative(beta) || !arb_is_positive(force))
        return fail("beta must be a finite number, 0 or more, and the constant force a number above 0");
    const bool below = law->elastic > 0 || HOLDS(bits, "force < 1", force);
    if (!below && (arb_is_one(force) || HOLDS(bits, "force > 1", force))) {
        never_parts(c, beta, force, law, bits + 2 * GUARD_BITS);
        return STATUS_OK;
    }
    for (slong prec = bits + 2 * GUARD_BITS; below && prec < MOST_BITS + 2 * bits; prec += prec / 2) {
        arb_indeterminate(c->eps_zero_overlap);
        arb_indeterminate(c->t_zero_overlap);
        const enum motion_outcome outcome =
            motion_solve_pressed(c, beta, force, law, alone ? MOTION_ZERO_FORCE : MOTION_ZERO_OVERLAP, prec);
        progress_end();
        if (outcome == MOTION_ENDLESS)
            break;
        if (elastic) {
            arb_one(c->eps_zero_overlap);
            arb_one(c->eps_zero_force);
        }
        if (outcome == MOTION_DONE && accuracy_bits(c, ends) >= bits)
            return STATUS_OK;
    }
    return fail(
        "cannot enclose the collision under a constant force to %ld bits: the force is too close to the threshold "
        "above which the bodies stay together, or the damping is too strong; change the force or use less damping",
        (long)bits);
}

int collision_force_max(arb_t force, const arb_t beta, const struct cor_exponents *law, slong bits)
{
    slong prec = bits + GUARD_BITS;
    if (!law_force_has_one_peak(law))
        return fail("cannot prove the largest force of the law %s, because the force may have several maxima; give "
                    "--beta instead of SI units to omit the largest force",
                    law_equation(law).text);
    if (arb_is_zero(beta)) {
        LOCAL(arb, time);
        turning_point_elastic(force, time, law, prec);
        LET(force, prec, "force^law->a", force, law);
        return STATUS_OK;
    }
    for (int i = 0; i < ATTEMPTS; i++) {
        const enum motion_outcome outcome = motion_force_max(force, beta, law, prec);
        progress_end();
        if (outcome == MOTION_DONE && arb_rel_accuracy_bits(force) >= bits)
            return STATUS_OK;
        prec += prec / 2;
    }
    return fail_accuracy("the largest force", bits);
}

int collision_final_speed(arb_t v_f, const struct cor_exponents *law, slong bits)
{
    if (law_fall_power(law).num <= 0)
        return fail("beta^(1/q) eps has a limit only for q > 0");
    /* the motion on the manifold from `last` contracts by exp(-depth), and its intervals grow by exp(depth) */
    const slong manifold_bits = bits + MANIFOLD_BITS;
    slong prec = bits + GUARD_BITS + (slong)(slow_manifold_depth(law, manifold_bits) / log(2));
    for (int i = 0; i < ATTEMPTS; i++) {
        const struct slow_manifold *const m = slow_manifold_of(law, manifold_bits, prec);
        progress_end();
        if (m)
            arb_set(v_f, m->final_speed);
        if (m && arb_rel_accuracy_bits(v_f) >= bits)
            return STATUS_OK;
        prec += prec / 2;
    }
    return fail_accuracy("eps at large beta", bits);
}

int collision_h_star(arb_t h_star, slong bits)
{
    const int status = collision_final_speed(h_star, &law_sphere, bits);
    arb_root_ui(h_star, h_star, 5, bits + GUARD_BITS);
    return status;
}
