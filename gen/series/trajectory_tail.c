/* SPDX-License-Identifier: MIT */
/* The proof of the truncation error of a trajectory: docs/theory.md, 3, equations (3.3) and (3.4).
 *
 * In the algebra A of power_bounds.h, X = Z + R. The tail R is the fixed point of
 *
 *   G(R)_kj = -([X^(b+1)]_(k-1),j / (b+1) + 2^shift [X^a]_k,(j-1) / e) / (e + 1),
 *                                                              e = k(b+1) + j(a+1), j > J.
 *
 * Iterating G from 0 makes one coefficient after the other correct. Therefore delta bounds R if G maps the ball |R| <=
 * delta of A into itself. With nu >= |1/Z|:
 *
 *   |(Z+R)^p - Z^p| <= |Z^p| ((1 - nu |R|)^(-p) - 1).
 *
 * The radius rho may come close to the nearest singularity, for spheres the pole of 1/X at s = 2^(a+1) s_0. The bound
 * is therefore about as small as the remainder of the series. */
#include "series/power_bounds.h"

#include "support/local.h"

#include <math.h>

enum {
    /* Size of the first block of Z whose inverse is computed. With the best weights, Z outside this block is tiny. */
    BLOCK_ROWS = 16,
    BLOCK_LENGTH = 48,
    /* Number of circles for Cauchy's estimate in trajectory_tail_jet */
    CIRCLES = 16
};

/* Computes (3.3), the radius of the image under G of the ball |R| <= delta,
 *
 *   (U/(b+1) |[X^(b+1)] beyond s^J| + 2^shift rho/e |[X^a] from s^J on|)/(e + 1).
 *
 * Here e is the value at the tail's first coefficient. |(Z+R)^p - Z^p| <= |Z^p| ((1 - nu delta)^(-p) - 1) is evaluated
 * by expm1, so that a tiny nu delta does not cancel. Returns false if nu delta is not below 1. */
static bool image_of_ball(arb_t image, const arb_t delta, const struct power_bounds *b, const struct power_evidence *e,
                          const struct trajectory *t, double U, double rho)
{
    const struct ratio a = e->exponent[0], b1 = e->exponent[1];
    const arb_srcptr size = b->size[e->powers - 1], error = b->error[e->powers - 1];
    const slong shift = t->shift;
    LOCAL(arb, eta, by_b, by_a, first);
    LET(first, NORM_BITS, "(a + 1)*(e->J + 1)", a, e->J);
    LET(eta, NORM_BITS, "b->inverse*delta", b->inverse, delta);
    LET(by_b, NORM_BITS, "(expm1(-b1*log1p(-eta))*size + error)*U/b1", b1, eta, size, error, U);
    LET(by_a, NORM_BITS, "(expm1(-a*log1p(-eta))*b->size[0] + b->last_column)*rho*2^shift/first", a, eta, b->size[0],
        b->last_column, rho, shift, first);
    LET(image, NORM_BITS, "(by_b + by_a)/(first + 1)", by_b, by_a, first);
    return HOLDS(NORM_BITS, "eta < 1", eta);
}

/* Finds delta of (3.4), for which G maps the ball |R| <= delta into itself. The image of the point 0 is a lower bound
 * on delta. The first trial is twice that bound, and the second twice the image of the first ball. Returns false if the
 * proof does not succeed with these weights. */
static bool prove_at(struct trajectory_tail *tail, const struct power_evidence *e, const struct trajectory *t)
{
    enum { BALLS = 3 };
    LOCAL(power_bounds, bounds);
    LOCAL(arb, image);
    LOCAL(mag, radius);
    bool proved = false;
    arb_zero(tail->delta);
    if (!power_bounds_prove(bounds, e, tail->U, tail->rho))
        return false;
    for (int ball = 0; ball < BALLS && !proved && image_of_ball(image, tail->delta, bounds, e, t, tail->U, tail->rho);
         ball++) {
        proved = arb_le(image, tail->delta);
        if (!proved) {
            arb_get_mag(radius, image);
            arb_set_upper(tail->delta, radius);
            arb_mul_2exp_si(tail->delta, tail->delta, 1);
        }
    }
    return proved;
}

void trajectory_tail_init(struct trajectory_tail *tail)
{
    arb_init(tail->delta);
}

void trajectory_tail_clear(struct trajectory_tail *tail)
{
    arb_clear(tail->delta);
}

/* Returns log2 of the largest error that the tail causes in x_k^(m)(t0) t0^m/m!, for m = 0, order/2 and order, and
 * k = order - m. */
static double tail_quality(const struct trajectory_tail *tail, const struct trajectory *t, const arb_t t0)
{
    double worst = -HUGE_VAL;
    LOCAL(mag, bound, power);
    arb_get_mag(power, t0);
    for (int i = 0; i <= 2; i++) {
        const slong m = t->order * i / 2;
        trajectory_tail_jet(bound, tail, t, t->order - m, m, t0);
        worst = fmax(worst, mag_get_d_log2_approx(bound) + (double)m * mag_get_d_log2_approx(power));
    }
    return worst;
}

/* Trial radii for rho, as fractions of the way from t0 to the nearest singularity, and trial weights U = 2^k */
static const double trial_part[] = {0.9, 0.8, 0.7, 0.5, 0.25};
enum { TRIAL_PARTS = sizeof trial_part / sizeof *trial_part, TRIAL_U_MAX = 3, TRIAL_U_MIN = -7 };

/* Finds the pair of weights with the least tail_quality. Returns false if no pair proves a bound. */
static bool best_trial(struct trajectory_tail *tail, const struct power_evidence *e, const struct trajectory *t,
                       const arb_t t0)
{
    const struct ratio a = law_elastic(&t->law);
    const slong shift = t->shift;
    LOCAL(trajectory_tail, trial);
    double best = HUGE_VAL;
    LOCAL(arb, s0, rho);
    LET(s0, NORM_BITS, "t0^(a + 1)/2^shift", t0, a, shift);
    for (int i = 0; i < TRIAL_PARTS; i++) {
        double best_here = HUGE_VAL;
        const double radius = 1 + trial_part[i] * (law_elastic_radius(&t->law) - 1);
        LET(rho, NORM_BITS, "radius^(a + 1)*s0", radius, a, s0);
        trial->rho = ball_middle(rho);
        for (int k = TRIAL_U_MAX; k >= TRIAL_U_MIN; k--) {
            trial->U = exp2(k);
            if (!prove_at(trial, e, t))
                continue;
            const double quality = tail_quality(trial, t, t0);
            if (quality < best) {
                arb_swap(tail->delta, trial->delta);
                tail->U = trial->U;
                tail->rho = trial->rho;
                best = quality;
            }
            if (quality >= best_here)
                break; /* a smaller U only makes the bound worse */
            best_here = quality;
        }
    }
    return best < HUGE_VAL;
}

bool trajectory_tail_prove(struct trajectory_tail *tail, const struct trajectory *t, const arb_t t0)
{
    struct power_evidence e;
    bool proved = false, whole = false;
    for (slong rows = BLOCK_ROWS, length = BLOCK_LENGTH; !proved && !whole; rows *= 2, length *= 2) {
        power_evidence_init(&e, t, rows, length);
        proved = best_trial(tail, &e, t, t0);
        power_evidence_clear(&e);
        whole = rows > t->order && length > t->terms;
    }
    return proved;
}

void trajectory_tail_jet(mag_t bound, const struct trajectory_tail *tail, const struct trajectory *t, slong k, slong m,
                         const arb_t t0)
{
    /* For any r > 0 with s = (t0 + r)^(a+1)/2^shift <= rho, the sum over m of the jets times r^m is the tail of x_k at
     * t0 + r, which is at most (t0 + r)^(k(b+1)+1) delta U^-k (s/rho)^(terms+1). */
    const struct ratio a = law_elastic(&t->law), b = law_damping(&t->law);
    const slong shift = t->shift, terms = t->terms;
    LOCAL(arb, r, room, reach, ratio);
    LOCAL(mag, candidate);
    mag_inf(bound);
    /* Circles between t0 and the radius that corresponds to rho */
    LET(room, NORM_BITS, "(tail->rho*2^shift)^(1/(a + 1)) - t0", tail->rho, shift, a, t0);
    for (int i = 1; i <= CIRCLES; i++) {
        LET(r, NORM_BITS, "room*i/(CIRCLES + 1)", room, i, CIRCLES);
        arb_add(reach, t0, r, NORM_BITS);
        LET(ratio, NORM_BITS, "reach^(a + 1)/2^shift/tail->rho", reach, a, shift, tail->rho);
        if (!HOLDS(NORM_BITS, "ratio < 1", ratio))
            break;
        LET(ratio, NORM_BITS, "ratio^(terms + 1)*(reach^(b + 1)/tail->U)^k*reach*tail->delta/r^m", ratio, terms, reach,
            b, tail->U, k, tail->delta, r, m);
        arb_get_mag(candidate, ratio);
        mag_min(bound, bound, candidate);
    }
}
