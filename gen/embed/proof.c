/* SPDX-License-Identifier: MIT */
#include "embed/form.h"

#include <math.h>
#include <stdlib.h>

#include "approximation/row_proof.h"
#include "support/console.h"
#include "support/enclosed_function.h"
#include "support/local.h"
#include "support/parallel.h"

enum {
    FIRST_PARTS = 4, /* parts of an interval in sqrt(beta) at the start */
    DEPTH = 12,      /* largest number of halvings of a part */
    HALVINGS = 2,    /* halvings of a part by enclosed_largest_ratio */
    POINTS = 6,      /* points on each side of a part's middle at which the error is evaluated first */
    FAR = -1         /* number of the range beyond the last interval */
};

/* Longest part in ln(beta) */
#define LOG_PART 0.5
/* A bound suffices if it is at most NEAR_KNOWN times an error that really occurs, or NEAR_SAMPLED times the largest
 * sampled error. */
#define NEAR_KNOWN 1.01
#define NEAR_SAMPLED 1.005
/* Allowed error of the interpolant of another law, as a fraction of the form's error */
#define LAW_PART_OF_ERROR 1e-3
/* Proofs begin at this multiple of the sticking speed v_s, because their cost grows like 1/(v - v_s). */
#define STICKING_PROVED 1.01
/* Exceeds the rounding errors of a few functions of libm */
#define SLACK 1e-13

/* A part: the speeds with lo <= x <= hi, their row of the table, and the bound of the error. x is ln(beta), or the
 * variable of an interval of the sphere's interpolant. */
struct part {
    int interval;
    bool by_log;
    slong row;
    double lo, hi, error;
};

struct prover {
    const struct embed_form *f;
    struct embed_program program;
    const struct embed_scene *s;
    struct interpolant_proof *interpolant; /* spheres */
    struct law_proof *law;                 /* other laws */
    enum quantity quantity;
    struct far_proof far; /* the proof at zero force for large beta */
    bool far_known;
    double enough;
    double from; /* the proof holds at this speed and above */
    struct part *part;
    slong parts;
};

/* ---- a part ---- */

/* Encloses x and eps as functions of t, and beta unless x is ln(beta). For a closed form, beta is the speed. False: no
 * proof */
static bool part_functions(arb_poly_t eps, arb_poly_t beta, arb_poly_t x, const struct prover *w,
                           const struct part *part)
{
    const struct embed_scene *const s = w->s;
    const double error = EMBED_FAR_ERROR;
    LOCAL(arb_poly, t);
    LOCAL(arb, radius);
    if (w->law)
        return law_proof_eps(eps, x, w->law, part->interval, part->lo, part->hi);
    if (!s->by_speed && part->interval != FAR) {
        interpolant_proof_eps(eps, beta, x, w->interpolant, part->interval, w->quantity, part->lo, part->hi);
        return true;
    }
    enclosed_variable(x, part->lo, part->hi);
    arb_poly_set_arb(eps, s->eps);
    if (s->own.law)
        return own_law_function(eps, x, &s->own, part->interval);
    if (s->by_speed)
        return !s->plastic || (LET_FUNCTION(t, "exp(-x)*s->yield_speed", x, s->yield_speed) &&
                               LET_FUNCTION(t, "t*sqrt(5/(6 - t^2))", t) &&
                               LET_FUNCTION(eps, "sqrt(sqrt(108*t/((t^2 + 5)^2*(t + 2))))", t));
    if (w->quantity != EPS_ZERO_OVERLAP)
        return w->far_known && far_proof_function(eps, &w->far, EPS_ZERO_FORCE, part->lo, part->hi) &&
               LET_FUNCTION(eps, "eps*exp(-5*x/3)", eps, x);
    LET_FUNCTION(eps, "exp(-5*x)*s->h_star_5", x, s->h_star_5);
    enclosed_range(radius, eps);
    LET(radius, ENCLOSED_BITS, "abs(radius)*error", radius, error);
    enclosed_add_radius(eps, radius);
    return true;
}

/* Encloses the variable of the polynomials, a root of v. In a liquid v = v_d + s, where v_d is the dry speed and s the
 * speed lost to the liquid; eps becomes eps v = eps_d v_d - s. Under a constant force, the origin is subtracted
 * from v. */
static bool part_variable(arb_poly_t y, arb_poly_t eps, arb_poly_t v, const arb_poly_t beta, const arb_poly_t x,
                          const struct prover *w, bool by_log)
{
    static const char *const of_root[] = {[SPEED] = "beta^5*factor",
                                          [SQRT_OF_SPEED] = "beta^2*x*factor",
                                          [FOURTH_ROOT_OF_SPEED] = "sqrt(x)*beta*factor",
                                          [FIFTH_ROOT_OF_SPEED] = "beta*factor",
                                          [TENTH_ROOT_OF_SPEED] = "x*factor"};
    const struct embed_scene *const s = w->s;
    const bool moved = s->pressed || !arb_is_zero(s->liquid_speed);
    const struct embed_root *const root = &embed_roots[w->f->variable];
    const slong degree = root->degree, first = moved ? 1 : degree;
    const struct ratio q = law_speed_exponent(&s->law), power = RATIO("1/(q*first)", q, first);
    LOCAL(arb, factor);
    LET(factor, EMBED_BITS, "s->beta_enclosed^-power", s->beta_enclosed, power);
    const char *const formula = by_log ? "exp(power*x)*factor" : of_root[moved ? SPEED : w->f->variable];
    bool done = LET_FUNCTION(moved ? v : y, formula, power, x, beta, factor);
    if (!moved)
        return done;
    if (!s->pressed)
        LET_FUNCTION(eps, "eps*v - s->liquid_speed", eps, v, s->liquid_speed);
    LET_FUNCTION(v, s->pressed ? "v - s->origin" : "v + s->liquid_speed", v, s->origin, s->liquid_speed);
    done = LET_FUNCTION(y, root->fifth ? "exp(log(v)/degree)" : "v", v, degree);
    for (int k = 0; k < root->square_roots && !root->fifth && done; k++)
        done = LET_FUNCTION(y, "sqrt(y)", y);
    return done;
}

/* Encloses the polynomials of the program on a row, as functions of its variable y, without rounding. */
static void part_polynomials(arb_poly_t p, arb_poly_t q, const arb_poly_t y, const struct prover *w, slong row)
{
    const struct embed_form *const f = w->f;
    const int first = w->program.x;
    const double start = embed_row_start(f, row);
    LOCAL(arb_poly, v0, v1, v2, v3, v4, v5, v6, v7, v8);
    arb_poly_struct *const value[] = {v0, v1, v2, v3, v4, v5, v6, v7, v8};
    arb_poly_set(v0, y);
    for (int i = first + 1; i < w->program.count; i++) {
        const struct embed_step *const s = &w->program.step[i];
        const double *const c = s->c ? s->c : f->number + row * (s->degree + 1);
        arb_poly_struct *const z = value[i - first], *const x = value[s->x - first];
        if (s->code == STEP_ROW_OF_BITS || s->code == STEP_ROW_OF_SEARCH)
            LET_FUNCTION(z, "x - start", x, start);
        else if (s->code == STEP_ROW_OF_PLACE)
            LET_FUNCTION(z, "x*f->slope + f->shift - row", x, f->slope, f->shift, row);
        else if (s->code != STEP_HORNER && s->code != STEP_DIV)
            enclosed_multiply(z, x, value[s->y - first]);
        if (s->code == STEP_MUL_ADD)
            arb_poly_add(z, z, value[s->z - first], ENCLOSED_BITS);
        for (slong k = s->degree; s->code == STEP_HORNER && k >= 0; k -= s->stride) {
            enclosed_multiply(z, z, x);
            enclosed_add_double(z, c[k]);
        }
    }
    arb_poly_set(p, value[w->program.p - first]);
    if (w->program.q > 0)
        arb_poly_set(q, value[w->program.q - first]);
}

/* Returns a bound of |p/q - eps|/eps on a part; infinite without a proof */
static double part_error(const struct prover *w, const struct part *part, int depth)
{
    LOCAL(arb_poly, eps, beta, x, y, p, q, v);
    double error = HUGE_VAL, known = 0;
    if (part_functions(eps, beta, x, w, part) && part_variable(y, eps, v, beta, x, w, part->by_log)) {
        part_polynomials(p, q, y, w, part->row);
        if (!arb_is_zero(w->s->liquid_speed))
            enclosed_multiply(p, p, v);
        if (w->f->denominator > 0) /* |p - q eps|/|q eps| */
            enclosed_multiply(eps, eps, q);
        arb_poly_sub(p, p, eps, ENCLOSED_BITS);
        for (int k = -POINTS; k <= POINTS; k++)
            known = fmax(known, enclosed_ratio_at(p, eps, k / (double)POINTS));
        known = fmax(known * NEAR_KNOWN, w->enough);
        error = enclosed_largest_ratio(p, eps, known / 1.03, HALVINGS);
    }
    if (error <= known || depth == 0 || !(part->lo < part->hi))
        return error;
    struct part lower = *part, upper = *part;
    lower.hi = upper.lo = part->lo / 2 + part->hi / 2;
    const double first = part_error(w, &lower, depth - 1);
    return isfinite(first) ? fmax(first, part_error(w, &upper, depth - 1)) : first;
}

static void prove_part(void *context, slong i)
{
    const struct prover *const w = context;
    w->part[i].error = part_error(w, &w->part[i], DEPTH);
}

/* ---- the parts of a range of speeds ---- */

static void add_parts(struct prover *w, struct part part, double longest)
{
    const double lo = part.lo, hi = part.hi;
    const int count = (int)fmax(1, ceil((hi - lo) / longest));
    w->part = xrealloc(w->part, (size_t)(w->parts + count) * sizeof *w->part);
    for (int k = 0; k < count; k++) {
        part.lo = lo + (hi - lo) * k / count;
        part.hi = k + 1 < count ? lo + (hi - lo) * (k + 1) / count : hi;
        w->part[w->parts++] = part;
    }
}

/* Returns ln(beta) at a speed, as the nearest double below it or above it */
static double place_of_speed(const struct prover *w, double speed, bool above)
{
    LOCAL(arb, x);
    arb_set_d(x, speed);
    embed_scene_beta(x, w->s, x, true);
    arb_log(x, x, EMBED_BITS);
    return ball_end(x, above);
}

/* Makes a part that starts at u = ln(beta) in an interval that is proved up to *end. Does not set the part's end.
 * Returns false if no such interval exists. Parts of spheres begin a little before u, because u may be off by SLACK. */
static bool part_from(struct part *part, double *end, const struct prover *w, double u)
{
    const struct interpolant_layout *const layout = &interpolant_sphere_proof;
    *part = (struct part){.by_log = true, .lo = u};
    *end = HUGE_VAL;
    if (w->s->own.law) /* u may be wrong by ulps, because the cubics at a knot agree to first order */
        part->interval = (int)own_law_row(end, &w->s->own, u);
    if (w->s->by_speed)
        return true;
    if (w->law)
        return (part->interval = law_proof_interval(end, w->law, u)) >= 0;
    for (int i = 0; w->interpolant && i < layout->intervals; i++) {
        const struct interval *const interval = &layout->interval[i];
        part->by_log = interval->variable == INTERVAL_LOG;
        *end = part->by_log ? interval->hi : 2 * log(interval->hi) + SLACK;
        if (!isfinite(w->interpolant->error[i][w->quantity]) || !(u < *end) ||
            u < (part->by_log ? interval->lo : 2 * log(interval->lo) + SLACK))
            continue;
        part->interval = i;
        part->lo = fmax(part->by_log ? u - 2 * SLACK : exp(u / 2) * (1 - SLACK), interval->lo);
        return true;
    }
    *end = HUGE_VAL;
    *part = (struct part){.interval = FAR, .by_log = true, .lo = u - 2 * SLACK};
    return u >=
           (w->quantity == EPS_ZERO_OVERLAP ? log(EMBED_FAR) + 3 * SLACK : layout->interval[layout->intervals - 1].hi);
}

/* Adds parts that cover all speeds from lo to hi, where ln(beta) may rise or fall. Returns false if there is a gap. */
static bool cover_range(struct prover *w, slong row, double lo, double hi)
{
    const double last = fmax(place_of_speed(w, lo, true), place_of_speed(w, hi, true));
    double u = fmin(place_of_speed(w, lo, false), place_of_speed(w, hi, false)), end = -HUGE_VAL;
    for (; end < last && u <= last; u = end) {
        struct part part;
        if (!part_from(&part, &end, w, u))
            return false;
        const struct interval *const interval = &interpolant_sphere_proof.interval[part.by_log ? 0 : part.interval];
        part.row = row;
        part.hi = fmin(end, last);
        if (!part.by_log)
            part.hi = fmin(exp(part.hi / 2) * (1 + SLACK), interval->hi);
        add_parts(w, part, part.by_log ? LOG_PART : (interval->hi - interval->lo) / (double)FIRST_PARTS);
    }
    return true;
}

/* ---- the proof ---- */

static void prove_formula(struct embed_proof *proof, struct prover *w, const struct embed_rounding *rounding)
{
    const struct embed_form *const f = w->f;
    bool covered = true;
    if (f->rows == 0)
        covered = cover_range(w, 0, w->from, f->speed_max);
    for (slong row = 0; row < f->rows; row++) {
        double lo = embed_row_start(f, row), hi = embed_row_start(f, row + 1);
        if (f->family == FAMILY_PIECES_BETA) {
            lo = pow(fmax((double)row - rounding->place - f->shift, 0) / f->slope, 5) * (1 - 10 * SLACK);
            hi = pow(((double)row + 1 + rounding->place - f->shift) / f->slope, 5) * (1 + 10 * SLACK);
        }
        lo = fmax(lo, w->from);
        hi = fmin(hi, f->speed_max);
        if (lo <= hi)
            covered = cover_range(w, row, lo, hi) && covered;
    }
    proof->proved = covered;
    proof->from = w->from + w->s->origin;
    parallel_for(prove_part, w, w->parts, "proof");
    proof->formula = w->parts > 0 ? 0 : HUGE_VAL;
    for (slong i = 0; i < w->parts; i++)
        proof->formula = fmax(proof->formula, isnan(w->part[i].error) ? HUGE_VAL : w->part[i].error);
    /* (1 + formula)(1 + rounding) - 1 */
    proof->error = (proof->formula + proof->rounding * (1 + proof->formula)) * (1 + 1e-12);
    if (!isfinite(proof->error) || !proof->proved) {
        proof->proved = false;
        proof->formula = proof->error = HUGE_VAL;
    }
}

int embed_prove(struct embed_proof *proof, const struct embed_form *f, const struct embed_scene *s)
{
    if (s->constant) { /* a constant eps: the form has one coefficient */
        LOCAL(arb, error);
        LET(error, EMBED_BITS, "abs(f->number[0]/s->eps - 1)", f->number[0], s->eps);
        *proof = (struct embed_proof){.error = ball_end(error, true), .proved = true};
        proof->formula = proof->error;
        return STATUS_OK;
    }
    struct embed_rounding rounding;
    *proof = (struct embed_proof){.error = HUGE_VAL, .formula = HUGE_VAL, .rounding = HUGE_VAL};
    if (!embed_rounding_bound(&rounding, f))
        return STATUS_OK;
    proof->rounding = rounding.error;
    const bool overlap = s->end == COR_END_ZERO_OVERLAP || !law_force_ends(&s->law); /* ends coincide if a <= b */
    struct prover w = {.f = f,
                       .program = embed_program_of(f),
                       .s = s,
                       .quantity = overlap ? EPS_ZERO_OVERLAP : EPS_ZERO_FORCE,
                       .enough = f->error * NEAR_SAMPLED,
                       .from = f->speed_min};
    int status = STATUS_OK;
    if (!s->by_speed && (!law_is_sphere(&s->law) || s->pressed)) {
        double beta[2] = {s->beta_min, s->beta_max};
        if (s->pressed) { /* see STICKING_PROVED */
            const double speed = arf_get_d(arb_midref(s->sticking_speed), ARF_RND_UP) * STICKING_PROVED - s->origin;
            LOCAL(arb, x);
            w.from = fmax(s->speed_min, speed);
            arb_set_d(x, w.from);
            embed_scene_beta(x, s, x, false);
            beta[law_speed_exponent(&s->law).num > 0 ? 0 : 1] = ball_middle(x);
        }
        w.law = law_proof_new(s->interpolant, w.quantity, beta[0], beta[1], LAW_PART_OF_ERROR * f->error);
        status = w.law ? STATUS_OK : STATUS_FAILED;
    } else if (!s->by_speed && s->interpolant) {
        w.interpolant = interpolant_proof_new(s->interpolant, 1u << w.quantity, ELLIPSES_STATED);
        status = w.interpolant ? STATUS_OK : STATUS_FAILED;
    }
    w.far_known = w.interpolant && w.quantity == EPS_ZERO_FORCE && s->beta_max > exp(FAR_PROOF_FROM);
    if (w.far_known)
        status = far_proof_init(&w.far, NULL, s->beta_max);
    if (status == STATUS_OK)
        prove_formula(proof, &w, &rounding);
    if (w.far_known)
        far_proof_clear(&w.far);
    interpolant_proof_free(w.interpolant);
    law_proof_free(w.law);
    free(w.part);
    return status;
}
