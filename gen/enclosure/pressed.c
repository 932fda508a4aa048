/* SPDX-License-Identifier: MIT */
/* The threshold of a constant force (docs/theory.md, 24). In units in which the force is 1 the law is
 *
 *   X'' + B X^b X' + X^a = 1,   B = beta f^(n/(2a)),   impact speed V = f^(-(a+1)/(2a)).
 *
 * At the threshold of zero overlap the motion reaches X = 0 with speed 0. At the threshold of the surface, if 2 (a - b)
 * > 1, a flight reaches it with speed 0. The flight begins where the contact force vanishes, at X_s^(2(a-b)-1) = 2 B^2.
 * Backward in time from there the motion arrives at X = 0 with the speed V(B). Hence f = V^(-2a/(a+1)) and
 * beta = B V^q. */
#include <math.h>

#include "enclosure/collision.h"
#include "enclosure/taylor.h"
#include "series/series.h"
#include "support/console.h"
#include "support/local.h"
#include "support/root.h"

enum {
    GUARD_BITS = 60,
    SEARCH_BITS = 128,
    MOST_SEARCH_BITS = 512,
    SEARCH_STEPS = 200,
    ATTEMPTS = 6,
    MOST_FACTOR = 16, /* limit of the precision, as a multiple of the initial precision */
    FAR_BITS = 30,
    WIDE_BITS = 8
};

/* Sets the state in which the backward motion begins. From rest at X = 0, u = v^2/2 obeys du/dX = 1 - X^a + B X^b v. If
 * u/X = 1 + r with |r| < R up to X = delta, one more integration gives r with a relative error of about R. */
static void set_start(struct taylor *y, const arb_t damping, bool flies)
{
    const struct cor_exponents *const law = &y->law;
    const struct ratio law_a = law_elastic(law), law_b = law_damping(law);
    const slong d = law->denominator, n = law->elastic - law->damping, prec = y->prec, power = 2 * n - d;
    LOCAL(arb, x, lost, gained, ball, root);
    if (flies) {
        LET(y->w, prec, "(2*damping^2)^(1/power)", damping, power);
        LET(y->v, prec, "y->w^n/damping", y->w, n, damping);
        return;
    }
    /* delta^a and B delta^(b+1/2) are below 2^-k, so |r| < R = 3 2^-k. The error of r, about R^2, is far below 2^-k. */
    const double size = fmax(arf_get_d(arb_midref(damping), ARF_RND_UP), 1);
    const double k = (double)prec / 2 + 4, a = (double)law->elastic / (double)d, b = (double)law->damping / (double)d;
    const slong small = -(slong)ceil(fmax(k / a, (k + log2(size)) / (b + 0.5)) / (double)d) - 1; /* of w */
    LET(y->w, prec, "2^small", small);
    LET(x, prec, "y->w^d", y->w, d);
    LET(lost, prec, "x^law_a/(law_a + 1)", x, law_a);
    arb_set_ui(ball, 3);
    arb_mul_2exp_si(ball, ball, -(slong)k); /* `gained` is below 2 2^-k, `lost` below 2^-k */
    arb_one(root);
    arb_add_error(root, ball);
    LET(gained, prec, "x^(law_b + 1/2)*damping/(law_b + 3/2)*sqrt(2*root)", x, law_b, damping, root);
    LET(y->v, prec, "sqrt(2*x*(1 + gained - lost))", x, gained, lost);
}

enum backward { FOUND, IMPRECISE, ESCAPED };

/* Computes V of B. */
static enum backward impact_speed(arb_t speed, const arb_t damping, const struct cor_exponents *law, int end,
                                  slong prec)
{
    const struct cor_exponents even = law_even(law);
    LOCAL_INIT(taylor, y, (&y, &even, taylor_degree(prec), prec));
    LOCAL(arb, root, begin);
    const slong power = 2 * (even.elastic - even.damping) - even.denominator;
    bool turned = false;
    arb_neg(y.c1, damping);
    arb_one(y.c2);
    arb_one(y.c3);
    set_start(&y, damping, end == COR_END_ZERO_FORCE && power > 0);
    for (slong step = 0; step < TAYLOR_MAX_STEPS; step++) {
        progress("threshold of the force", step, 0);
        taylor_expand(&y);
        if (!taylor_choose_step(&y))
            return IMPRECISE;
        arb_zero(begin);
        for (bool again = true; again;) { /* first the turning point, then X = 0, which may follow in the same step */
            const enum taylor_crossing crossing = taylor_crosses(root, &y, turned ? TAYLOR_W : TAYLOR_V, begin, y.step);
            if (crossing == TAYLOR_UNDECIDED)
                return IMPRECISE;
            again = crossing == TAYLOR_CROSSED;
            if (again && turned) {
                taylor_value(speed, &y, TAYLOR_V, root);
                arb_neg(speed, speed);
                return FOUND;
            }
            turned = turned || again;
            arb_get_ubound_arf(arb_midref(begin), root, prec);
        }
        taylor_advance(&y, y.step);
        if (arf_cmpabs_2exp_si(arb_midref(y.w), FAR_BITS) > 0)
            return ESCAPED;
        if (arb_rel_accuracy_bits(y.w) < 8)
            return IMPRECISE;
    }
    return ESCAPED;
}

int collision_sticking_speed(arb_t speed, const arb_t damping, const struct cor_exponents *law, int end, slong bits)
{
    slong prec = bits + GUARD_BITS;
    if (law->elastic == 0)
        return fail("a law with the elastic exponent 0 has no sticking speed; use an exponent above 0");
    for (int i = 0; i < ATTEMPTS; i++, prec += prec / 2) {
        const enum backward outcome = impact_speed(speed, damping, law, end, prec);
        progress_end();
        if (outcome == ESCAPED)
            return fail("the bodies stay together at every speed up to 1e9 in dimensionless units; use less damping");
        if (outcome == FOUND && arb_rel_accuracy_bits(speed) >= bits)
            return STATUS_OK;
    }
    return fail_accuracy("the sticking speed", bits);
}

/* ---- the threshold at a given beta ---- */

/* Computes rest = ln(beta) - ln(B V^q), and the force f. If the motion escapes, f = 0 and rest = -infinity. */
static bool follow_curve(arb_t rest, arb_t force, const arb_t beta, const arb_t damping,
                         const struct cor_exponents *law, int end, slong prec)
{
    const struct ratio q = law_speed_exponent(law);
    LOCAL(arb, speed);
    const enum backward outcome = impact_speed(speed, damping, law, end, prec);
    if (outcome == ESCAPED) {
        arb_zero(force);
        arb_neg_inf(rest);
        return true;
    }
    if (outcome == IMPRECISE)
        return false;
    arb_log(speed, speed, prec);
    LET(force, prec, "exp(-speed*(2*law->a/(law->a + 1)))", speed, law);
    LET(rest, prec, "log(beta/damping) - speed*q", beta, damping, speed, q);
    return true;
}

/* Calls follow_curve with more and more bits until they suffice. */
static bool curve_at(arb_t rest, arb_t force, const arb_t beta, const arb_t damping, const struct cor_exponents *law,
                     int end)
{
    slong prec = SEARCH_BITS;
    while (prec <= MOST_SEARCH_BITS && !follow_curve(rest, force, beta, damping, law, end, prec))
        prec *= 2;
    return prec <= MOST_SEARCH_BITS;
}

/* For strong damping and q > 0, B is just below the smallest B at which the motion escapes, and f = (B/beta)^(2a/n) is
 * known as accurately as B. Halves a bracket with proved signs at both ends. A motion counts as escaping if it reaches
 * w = 2^FAR_BITS: the energy there gives V^q > beta/B, which the function checks. */
static int squeeze_force(arb_t force, arb_t low, arb_t high, const arb_t beta, const struct cor_exponents *law, int end,
                         slong bits)
{
    const struct ratio n = law_fall_power(law), q = law_speed_exponent(law);
    const double far = FAR_BITS * (double)(law->elastic + law->denominator) / 2 / (law->denominator == 1 ? 0.5 : 1) - 4;
    slong prec = bits + GUARD_BITS;
    bool proved[2] = {false, false};
    LOCAL(arb, rest, middle);
    arb_div(rest, beta, low, prec);
    if (!(log2(arf_get_d(arb_midref(rest), ARF_RND_UP)) * (double)q.den / (double)q.num < far))
        return fail_accuracy("the threshold of the force", bits);
    for (slong i = 0; i < 4 * (bits + SEARCH_STEPS) && prec <= MOST_FACTOR * (bits + GUARD_BITS); i++) {
        const bool narrow = HOLDS(prec, "(high - low)*2^(bits + 8) < low", high, low, bits);
        if (narrow && proved[0] && proved[1]) {
            arb_union(middle, low, high, prec);
            LET(force, prec, "(middle/beta)^(2*law->a/n)", middle, beta, law, n);
            return STATUS_OK;
        }
        LET(middle, prec, "(low + high)/2", low, high);
        if (narrow) /* try the end whose sign is not yet proved */
            arb_set(middle, proved[0] ? high : low);
        arb_get_mid_arb(middle, middle);
        const bool known = follow_curve(rest, force, beta, middle, law, end, prec), above = arb_is_negative(rest);
        if (!known || !(above || arb_is_positive(rest))) {
            prec += prec / 4;
            continue;
        }
        arb_set(above ? high : low, middle);
        proved[above] = true;
    }
    return fail_accuracy("the threshold of the force", bits);
}

/* Finds a B for which ln(beta) - ln(B V^q) is below 2^-40: brackets B by factors of 2, halves the bracket in ln(B), and
 * applies the Illinois method. If the motion escapes at the upper end of even a tiny bracket, sets only the bracket,
 * low_end and high_end. */
static int find_damping(arb_t damping, arb_t low_end, arb_t high_end, const arb_t beta, const struct cor_exponents *law,
                        int end)
{
    enum { DOUBLINGS = 60, ENOUGH = 40 };
    LOCAL(bracket, b);
    LOCAL(arb, rest, force);
    double low = -HUGE_VAL, high = HUGE_VAL; /* log2 of the ends of the bracket so far */
    double place = log2(fmin(ball_middle(beta), 0.5));
    for (int i = 0; i < SEARCH_STEPS; i++) {
        arb_set_d(damping, exp2(place));
        if (!curve_at(rest, force, beta, damping, law, end))
            return fail_accuracy("the threshold of the force", SEARCH_BITS);
        const bool is_low = arf_sgn(arb_midref(rest)) > 0;
        *(is_low ? &low : &high) = place;
        arb_get_mid_arb(is_low ? b->low : b->high, damping);
        arb_get_mid_arb(is_low ? b->f_low : b->f_high, rest);
        const bool both = isfinite(low) && isfinite(high);
        if ((both && (arb_is_finite(b->f_high) || high - low < 1e-12)) || place > DOUBLINGS || place < -1000)
            break;
        place = both ? (low + high) / 2 : place + (is_low ? 1 : -1);
    }
    const bool both = isfinite(low) && isfinite(high);
    if (both && !arb_is_finite(b->f_high) && law_speed_exponent(law).num > 0) {
        arb_set(low_end, b->low);
        arb_set(high_end, b->high);
        return STATUS_OK;
    }
    if (!(both && arb_is_finite(b->f_high)))
        return fail("the threshold of the force does not exist: at this damping the bodies never part, even without a "
                    "force; use less damping");
    for (int i = 0; i < SEARCH_STEPS; i++) {
        bracket_guess(damping, b, SEARCH_BITS);
        if (!curve_at(rest, force, beta, damping, law, end))
            return fail_accuracy("the threshold of the force", SEARCH_BITS);
        if (arb_contains_zero(rest) || arf_cmpabs_2exp_si(arb_midref(rest), -ENOUGH) < 0)
            return STATUS_OK;
        bracket_shrink(b, damping, rest);
    }
    return fail_accuracy("the threshold of the force", SEARCH_BITS);
}

int collision_sticking_force(arb_t force, const arb_t beta, const struct cor_exponents *law, int end, slong bits)
{
    LOCAL(arb, damping, found, low, high, f_low, f_high, other, at);
    slong prec = bits + GUARD_BITS, width = 30, narrowest = bits + GUARD_BITS / 3;
    if (law->elastic == 0) { /* a = 0: x'' + beta x^b x' = force - 1, so the threshold is 1 */
        arb_one(force);
        return STATUS_OK;
    }
    arb_get_mid_arb(at, beta);
    const int status = find_damping(damping, low, high, at, law, end);
    if (status != STATUS_OK)
        return status;
    if (!arb_is_zero(high))
        return squeeze_force(force, low, high, beta, law, end, bits);
    arb_get_mid_arb(found, damping);
    /* secants over narrower and narrower intervals, until the signs at both ends prove an interval of 2^-bits */
    for (int i = 0; i < SEARCH_STEPS && prec <= MOST_FACTOR * (bits + GUARD_BITS); i++) {
        arb_get_mid_arb(damping, damping);
        arb_around(low, high, damping, -width, prec);
        const bool known = follow_curve(f_low, force, beta, low, law, end, prec) &&
                           follow_curve(f_high, other, beta, high, law, end, prec);
        if (known && !(arb_is_finite(f_low) && arb_is_finite(f_high)))
            break;
        if (!known || arb_contains_zero(f_low) || arb_contains_zero(f_high)) {
            prec += prec / 2;
            continue;
        }
        progress_end();
        const bool proved = arb_is_positive(f_low) && arb_is_negative(f_high);
        arb_union(force, force, other, prec);
        if (proved && arb_rel_accuracy_bits(force) >= bits)
            return STATUS_OK;
        if (proved && width == narrowest) { /* rounding errors limit the force, or the force depends strongly on B */
            prec += prec / 4;
            narrowest += GUARD_BITS / 3;
        }
        if (proved)
            width = FLINT_MIN(2 * width - 6, narrowest);
        LET(damping, prec, "low - (high - low)*f_low/(f_high - f_low)", low, high, f_low, f_high);
    }
    if (law_speed_exponent(law).num > 0) { /* the motion escapes at a B next to the solution */
        arb_around(low, high, found, -WIDE_BITS, prec);
        return squeeze_force(force, low, high, beta, law, end, bits);
    }
    return fail_accuracy("the threshold of the force", bits);
}
