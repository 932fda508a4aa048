/* SPDX-License-Identifier: MIT */
#include "embed/form.h"

#include <math.h>
#include <stdlib.h>

#include "approximation/far_proof.h"
#include "approximation/law_proof.h"
#include "approximation/row_proof.h"
#include "support/console.h"
#include "support/enclosed_function.h"
#include "support/local.h"
#include "support/parallel.h"

enum {
    FIRST_PARTS = 4, /* of an interval, for a form without a table */
    DEPTH = 12,      /* halvings of a part, at most */
    HALVINGS = 2,    /* of polynomials on a part */
    POINTS = 6,      /* on each side of a part's middle, where the error is evaluated first */
    FAR = -1         /* in place of an interval: beyond the last */
};

/* Longest part in ln(beta) */
#define LOG_PART 0.5
/* A bound is good enough within this factor of an error that is taken, or of the largest sampled error. */
#define NEAR_KNOWN 1.01
#define NEAR_SAMPLED 1.005
/* The error of the interpolant of another law may be this part of the form's error. */
#define LAW_PART_OF_ERROR 1e-3
/* Proofs begin at this times the sticking speed v_s, because their cost grows like 1/(v - v_s). */
#define STICKING_PROVED 1.01
/* More than the rounding of a few functions of libm */
#define SLACK 1e-13

/* lo <= x <= hi in an interval of the interpolant, or in ln(beta), and the row of the table there */
struct part {
    int interval;
    slong row;
    double lo, hi;
};

struct prover {
    const struct embed_form *f;
    const struct embed_scene *s;
    struct interpolant_proof *interpolant; /* spheres */
    struct law_proof *law;                 /* other laws, whose parts are in ln(beta) */
    enum quantity quantity;
    struct far_proof far; /* for beta >= exp(10) at zero force */
    bool far_known;
    arb_t speed_factor; /* of a wet contact: dry speed = speed_factor beta^(1/q) */
    arb_t factor;       /* variable = factor beta^(1/(q root)), q = 1/5 for spheres */
    double enough;
    double from; /* the first speed with a proof */
    struct part *part;
    slong parts;
    double *error; /* of each part */
};

/* ---- a part ---- */

/* eps at zero overlap for beta >= EMBED_FAR, as a function of x = ln(beta) */
static void far_eps_overlap(arb_poly_t eps, const arb_poly_t x, const struct prover *w)
{
    const double error = EMBED_FAR_ERROR;
    LOCAL(arb, radius);
    LET_FUNCTION(eps, "exp(-5*x)*w->s->h_star_5", x, w->s->h_star_5);
    enclosed_range(radius, eps);
    LET(radius, ENCLOSED_BITS, "abs(radius)*error", radius, error);
    enclosed_add_radius(eps, radius);
}

/* eps at zero force beyond the intervals; false without a proof */
static bool far_eps_force(arb_poly_t eps, const arb_poly_t x, const struct prover *w, const struct part *part)
{
    return w->far_known && far_proof_function(eps, &w->far, EPS_ZERO_FORCE, part->lo, part->hi) &&
           LET_FUNCTION(eps, "eps*exp(-5*x/3)", eps, x);
}

/* Dry eps of a closed form; x = ln(speed) */
static bool closed_eps(arb_poly_t eps, arb_poly_t x, const struct embed_scene *s, const struct part *part)
{
    LOCAL(arb_poly, t);
    enclosed_variable(x, part->lo, part->hi);
    if (!s->plastic) {
        arb_poly_set_arb(eps, s->eps);
        return true;
    }
    return LET_FUNCTION(t, "exp(-x)*s->yield_speed", x, s->yield_speed) && LET_FUNCTION(t, "t*sqrt(5/(6 - t^2))", t) &&
           LET_FUNCTION(eps, "sqrt(sqrt(108*t/((t^2 + 5)^2*(t + 2))))", t);
}

/* x, beta and eps as functions of t; for laws other than the sphere's x = ln(beta), and not beta. Returns false without
 * a proof. */
static bool part_functions(arb_poly_t eps, arb_poly_t beta, arb_poly_t x, const struct prover *w,
                           const struct part *part)
{
    if (w->s->by_speed)
        return closed_eps(eps, x, w->s, part);
    if (w->law)
        return law_proof_eps(eps, x, w->law, part->interval, part->lo, part->hi);
    if (part->interval != FAR) {
        interpolant_proof_eps(eps, beta, x, w->interpolant, part->interval, w->quantity, part->lo, part->hi);
        return true;
    }
    enclosed_variable(x, part->lo, part->hi);
    LET_FUNCTION(beta, "exp(x)", x);
    if (w->quantity != EPS_ZERO_OVERLAP)
        return far_eps_force(eps, x, w, part);
    far_eps_overlap(eps, x, w);
    return true;
}

/* The variable of the polynomials as a power of beta: the speed is proportional to beta^(1/q) */
static struct ratio variable_power(const struct embed_scene *s, const struct embed_form *f)
{
    const struct ratio q = law_speed_exponent(&s->law);
    const slong root = embed_roots[f->variable].degree;
    return RATIO("1/(q*root)", q, root);
}

/* The variable of the polynomials; x is sqrt(beta) or ln(beta) */
static bool part_variable(arb_poly_t y, const arb_poly_t beta, const arb_poly_t x, const struct prover *w, bool by_log)
{
    static const char *const of_root[] = {[SPEED] = "beta^5*factor",
                                          [SQRT_OF_SPEED] = "beta^2*x*factor",
                                          [FOURTH_ROOT_OF_SPEED] = "sqrt(x)*beta*factor",
                                          [FIFTH_ROOT_OF_SPEED] = "beta*factor",
                                          [TENTH_ROOT_OF_SPEED] = "x*factor"};
    const struct ratio power = variable_power(w->s, w->f);
    const arb_srcptr factor = w->factor;
    return LET_FUNCTION(y, by_log ? "exp(power*x)*factor" : of_root[w->f->variable], power, x, beta, factor);
}

/* The variable where the speed is not that of beta: a root of v. In a liquid v = v_d + s, where v_d is the dry speed,
 * and eps becomes eps v = eps_d v_d - s; under a constant force v is less by the shift. */
static bool moved_variable(arb_poly_t y, arb_poly_t eps, arb_poly_t v, const arb_poly_t beta, const arb_poly_t x,
                           const struct prover *w, bool by_log)
{
    const struct ratio q = law_speed_exponent(&w->s->law), power = RATIO("1/q", q);
    const double origin = w->s->origin;
    const arb_srcptr lost = w->s->liquid_speed, factor = w->speed_factor;
    LET_FUNCTION(v, by_log ? "exp(power*x)*factor" : "beta^5*factor", power, x, beta, factor);
    if (!w->s->pressed)
        LET_FUNCTION(eps, "eps*v - lost", eps, v, lost);
    LET_FUNCTION(v, w->s->pressed ? "v - origin" : "v + lost", v, origin, lost);
    const struct embed_root *const root = &embed_roots[w->f->variable];
    const slong degree = root->degree;
    bool done = LET_FUNCTION(y, root->fifth ? "exp(log(v)/degree)" : "v", v, degree);
    for (int k = 0; k < root->square_roots && !root->fifth && done; k++)
        done = LET_FUNCTION(y, "sqrt(y)", y);
    return done;
}

/* The argument of the polynomials of a row: its distance from the start of the row */
static void part_place(arb_poly_t y, const struct prover *w, slong row)
{
    const struct embed_form *const f = w->f;
    const double start = embed_row_start(f, row);
    if (f->family == FAMILY_PIECES_SPEED)
        LET_FUNCTION(y, "y - start", y, start);
    else if (f->family == FAMILY_PIECES_BETA)
        LET_FUNCTION(y, "y*f->slope + f->shift - row", y, f->slope, f->shift, row);
}

static void part_polynomial(arb_poly_t p, const double *c, slong degree, const arb_poly_t y)
{
    arb_poly_zero(p);
    for (slong k = degree; k >= 0; k--) {
        enclosed_multiply(p, p, y);
        enclosed_add_double(p, c[k]);
    }
}

/* Bound of |p/q - eps|/eps on a part; infinite where there is no proof */
static double part_error(const struct prover *w, const struct part *part, int depth)
{
    const struct embed_form *const f = w->f;
    const double *const c = f->number + (f->rows > 0 ? part->row * (f->numerator + 1) : 0);
    const bool by_log = w->s->by_speed || w->law || part->interval == FAR ||
                        interpolant_sphere_proof.interval[part->interval].variable == INTERVAL_LOG;
    const bool wet = !arb_is_zero(w->s->liquid_speed);
    LOCAL(arb_poly, eps, beta, x, y, p, v);
    double error = HUGE_VAL, known = 0;
    if (part_functions(eps, beta, x, w, part) &&
        (wet || w->s->pressed ? moved_variable(y, eps, v, beta, x, w, by_log) : part_variable(y, beta, x, w, by_log))) {
        part_place(y, w, part->row);
        part_polynomial(p, c, f->numerator, y);
        if (wet)
            enclosed_multiply(p, p, v);
        if (f->denominator > 0) { /* |p - q eps|/|q eps| */
            part_polynomial(x, c + f->numerator + 1, f->denominator, y);
            enclosed_multiply(eps, eps, x);
        }
        arb_poly_sub(p, p, eps, ENCLOSED_BITS);
        for (int k = -POINTS; k <= POINTS; k++)
            known = fmax(known, enclosed_ratio_at(p, eps, k / (double)POINTS));
        known = fmax(known * NEAR_KNOWN, w->enough);
        error = enclosed_largest_ratio(p, eps, known / 1.03, HALVINGS);
    }
    if (error <= known || depth == 0 || !(part->lo < part->hi))
        return error;
    const double middle = part->lo / 2 + part->hi / 2;
    const struct part lower = {part->interval, part->row, part->lo, middle},
                      upper = {part->interval, part->row, middle, part->hi};
    const double first = part_error(w, &lower, depth - 1);
    return isfinite(first) ? fmax(first, part_error(w, &upper, depth - 1)) : first;
}

static void prove_part(void *context, slong i)
{
    const struct prover *const w = context;
    w->error[i] = part_error(w, &w->part[i], DEPTH);
}

/* ---- the parts of a range of speeds ---- */

static void add_parts(struct prover *w, int interval, slong row, double lo, double hi, double longest)
{
    const int count = (int)fmax(1, ceil((hi - lo) / longest));
    w->part = xrealloc(w->part, (size_t)(w->parts + count) * sizeof *w->part);
    for (int k = 0; k < count; k++) {
        const double next = k + 1 < count ? lo + (hi - lo) * (k + 1) / count : hi;
        w->part[w->parts++] = (struct part){interval, row, lo + (hi - lo) * k / count, next};
    }
}

/* sqrt(beta) or ln(beta) at a speed, as the nearest double below it or above it */
static double place_of_speed(const struct prover *w, double speed, bool by_log, bool above)
{
    LOCAL(arb, x);
    arb_set_d(x, speed);
    embed_scene_beta(x, w->s, x, true);
    (by_log ? arb_log : arb_sqrt)(x, x, EMBED_BITS);
    return ball_end(x, above);
}

/* The same for a law other than the sphere's, where ln(beta) may rise or fall with the speed */
static bool cover_law_range(struct prover *w, slong row, double lo, double hi)
{
    const double a = place_of_speed(w, lo, true, false), b = place_of_speed(w, hi, true, false);
    const double last = fmax(place_of_speed(w, lo, true, true), place_of_speed(w, hi, true, true));
    for (double u = fmin(a, b), end; u <= last; u = end) {
        const int i = law_proof_interval(&end, w->law, u);
        if (i < 0)
            return false;
        add_parts(w, i, row, u, fmin(end, last), LOG_PART);
        if (end >= last)
            break;
    }
    return true;
}

/* Adds parts that cover all speeds from lo to hi. Returns false if there is a gap. */
static bool cover_range(struct prover *w, slong row, double lo, double hi)
{
    if (w->s->by_speed) {
        add_parts(w, 0, row, place_of_speed(w, lo, true, false), place_of_speed(w, hi, true, true), LOG_PART);
        return true;
    }
    if (w->law)
        return cover_law_range(w, row, lo, hi);
    const double last = interpolant_sphere_proof.interval[interpolant_sphere_proof.intervals - 1].hi;
    const double far = w->quantity == EPS_ZERO_OVERLAP ? log(EMBED_FAR) + SLACK : last;
    const double root_end = place_of_speed(w, hi, false, true), log_end = place_of_speed(w, hi, true, true);
    double root = place_of_speed(w, lo, false, false), log_place = place_of_speed(w, lo, true, false);
    bool covered = false;
    for (int i = 0; w->interpolant && i < interpolant_sphere_proof.intervals && !covered; i++) {
        const struct interval *const interval = &interpolant_sphere_proof.interval[i];
        const bool by_log = interval->variable == INTERVAL_LOG;
        const double place = by_log ? log_place : root, end = by_log ? log_end : root_end;
        if (!isfinite(w->interpolant->error[i][w->quantity]) || place < interval->lo || place >= interval->hi)
            continue;
        covered = end <= interval->hi;
        add_parts(w, i, row, place, covered ? end : interval->hi,
                  by_log ? LOG_PART : (interval->hi - interval->lo) / (double)FIRST_PARTS);
        root = by_log ? root_end : interval->hi;
        log_place = by_log ? interval->hi : 2 * log(root) - SLACK;
    }
    if (!covered && log_place >= far) {
        add_parts(w, FAR, row, log_place, log_end, LOG_PART);
        covered = true;
    }
    return covered;
}

/* Adds the parts of a form. Returns false if there is a gap. */
static bool cover_form(struct prover *w, const struct embed_rounding *rounding)
{
    const struct embed_form *const f = w->f;
    bool covered = true;
    if (f->rows == 0)
        covered = cover_range(w, 0, w->from, f->speed_max);
    for (slong row = 0; row < f->rows; row++) {
        double lo, hi;
        if (f->family == FAMILY_PIECES_SPEED) {
            lo = embed_row_start(f, row);
            hi = embed_row_start(f, row + 1);
        } else {
            lo = pow(fmax((double)row - rounding->place - f->shift, 0) / f->slope, 5) * (1 - 10 * SLACK);
            hi = pow(((double)row + 1 + rounding->place - f->shift) / f->slope, 5) * (1 + 10 * SLACK);
        }
        lo = fmax(lo, w->from);
        hi = fmin(hi, f->speed_max);
        if (lo <= hi)
            covered = cover_range(w, row, lo, hi) && covered;
    }
    return covered;
}

/* ---- the proof ---- */

static void prove_formula(struct embed_proof *proof, struct prover *w, const struct embed_rounding *rounding)
{
    proof->proved = cover_form(w, rounding);
    proof->from = w->from + w->s->origin;
    w->error = xmalloc((size_t)(w->parts + 1) * sizeof *w->error);
    parallel_for(prove_part, w, w->parts, "proof");
    proof->formula = w->parts > 0 ? 0 : HUGE_VAL;
    for (slong i = 0; i < w->parts; i++)
        proof->formula = fmax(proof->formula, isnan(w->error[i]) ? HUGE_VAL : w->error[i]);
    /* (1 + formula)(1 + rounding) - 1 */
    proof->error = (proof->formula + proof->rounding * (1 + proof->formula)) * (1 + 1e-12);
    if (!isfinite(proof->error) || !proof->proved) {
        proof->proved = false;
        proof->formula = proof->error = HUGE_VAL;
    }
}

/* A form that is one number, its coefficient */
static void prove_constant(struct embed_proof *proof, const struct embed_form *f, const struct embed_scene *s)
{
    LOCAL(arb, error);
    LET(error, EMBED_BITS, "abs(f->number[0]/s->eps - 1)", f->number[0], s->eps);
    *proof = (struct embed_proof){.error = ball_end(error, true), .proved = true};
    proof->formula = proof->error;
}

/* The first speed of a scene with a constant force at which the cost of a proof is bounded, like every speed less the
 * origin. Sets the end of beta[] next to the sticking speed to that of this speed. */
static double first_proved(double beta[2], const struct embed_scene *s)
{
    const double speed =
        fmax(s->speed_min, arf_get_d(arb_midref(s->sticking_speed), ARF_RND_UP) * STICKING_PROVED - s->origin);
    const bool rises = law_speed_exponent(&s->law).num > 0;
    LOCAL(arb, x);
    arb_set_d(x, speed);
    embed_scene_beta(x, s, x, false);
    beta[rises ? 0 : 1] = ball_middle(x);
    return speed;
}

int embed_prove(struct embed_proof *proof, const struct embed_form *f, const struct embed_scene *s)
{
    if (s->constant) {
        prove_constant(proof, f, s);
        return STATUS_OK;
    }
    struct embed_rounding rounding;
    *proof = (struct embed_proof){.error = HUGE_VAL, .formula = HUGE_VAL, .rounding = HUGE_VAL};
    if (!embed_rounding_bound(&rounding, f))
        return STATUS_OK;
    proof->rounding = rounding.error;
    const bool overlap = s->end == END_ZERO_OVERLAP || !law_force_ends(&s->law); /* otherwise the ends coincide */
    struct prover w = {.f = f,
                       .s = s,
                       .quantity = overlap ? EPS_ZERO_OVERLAP : EPS_ZERO_FORCE,
                       .enough = f->error * NEAR_SAMPLED,
                       .from = f->speed_min};
    int status = STATUS_OK;
    if (!s->by_speed && (!law_is_sphere(&s->law) || s->pressed)) {
        double beta[2] = {s->beta_min, s->beta_max};
        if (s->pressed)
            w.from = first_proved(beta, s);
        w.law = law_proof_new(s->interpolant, w.quantity, beta[0], beta[1], LAW_PART_OF_ERROR * f->error);
        status = w.law ? STATUS_OK : STATUS_FAILED;
    } else if (!s->by_speed && s->interpolant) {
        w.interpolant = interpolant_proof_new(s->interpolant, 1u << w.quantity, ELLIPSES_STATED);
        status = w.interpolant ? STATUS_OK : STATUS_FAILED;
    }
    w.far_known = w.interpolant && w.quantity == EPS_ZERO_FORCE && s->beta_max > exp(FAR_PROOF_FROM);
    if (w.far_known)
        status = far_proof_init(&w.far, NULL, s->beta_max);
    if (status == STATUS_OK) {
        const struct ratio q = law_speed_exponent(&s->law), power = variable_power(s, f);
        FOR_ALL(arb, init, w.factor, w.speed_factor);
        LET(w.speed_factor, EMBED_BITS, "s->beta_enclosed^(-1/q)", s->beta_enclosed, q);
        LET(w.factor, EMBED_BITS, "s->beta_enclosed^-power", s->beta_enclosed, power);
        prove_formula(proof, &w, &rounding);
        FOR_ALL(arb, clear, w.factor, w.speed_factor);
    }
    if (w.far_known)
        far_proof_clear(&w.far);
    interpolant_proof_free(w.interpolant);
    law_proof_free(w.law);
    free(w.part);
    free(w.error);
    return status;
}
