/* SPDX-License-Identifier: MIT */
#include "approximation/row_proof.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "support/console.h"
#include "support/enclosed_function.h"
#include "support/local.h"
#include "support/parallel.h"

enum {
    PREC = 320,    /* bits for the interpolants, whose coefficients in powers are large and cancel */
    HALVINGS = 10, /* largest number of halvings of a cell, to bound a polynomial */
    POINTS = 16,   /* points on each side of the middle at which the polynomial is evaluated first */
    LAST_COEFFICIENTS = 6
};

/* Least ln(beta) at which the creep's series proves the duration at zero overlap. Intervals in sqrt(beta) reach it. */
#define CREEP_FROM 2.1

/* ---- the error of the interpolant ---- */

/* Computes Chebyshev point j of n in ascending order exactly. */
static void exact_point(arb_t x, slong j, slong n)
{
    LOCAL(fmpq, angle);
    fmpq_set_si(angle, 2 * j + 1, (ulong)(2 * n));
    arb_cos_pi_fmpq(x, angle, PREC);
    arb_neg(x, x);
}

/* Bounds the Lebesgue constant for the nodes of an interval. For the n Chebyshev points it is L < 1 + (2/pi) ln(n). For
 * nodes within d of these points it is at most L/(1 - L d (n-1)^2), by Markov's inequality. The bound is not finite if
 * d is too large. */
static void bound_lebesgue(arb_t bound, arb_srcptr node, const struct interval *interval)
{
    const slong n = interval->count;
    LOCAL(arb, d, w, x);
    for (slong j = 0; j < n; j++) {
        exact_point(x, j, n);
        unit_place(w, node + j, interval->lo, interval->hi, PREC);
        LET(d, PREC, "max(d, abs(x - w))", d, x, w);
    }
    LET(bound, PREC, "2*log(n)/pi + 1", n);
    LET(d, PREC, "1 - d*bound*(n - 1)^2", d, bound, n);
    if (arb_is_positive(d))
        arb_div(bound, bound, d, PREC);
    else
        arb_pos_inf(bound);
}

/* Bounds the error of the interpolant. The function is within D = 2 M rho^(1-n)/(rho - 1) of a polynomial of degree
 * n - 1. The interpolant is within (1 + L) D, plus L times the error of the values. */
static void polynomial_error(arb_t error, const struct ellipse_bound *bound, enum quantity quantity,
                             const arb_t constant, arb_srcptr value, const struct interval *interval)
{
    const slong n = interval->count;
    const double rho = bound->rho, M = bound->modulus[quantity];
    const slong bits = interval->bits;
    LOCAL(arb, x, largest);
    for (slong j = 0; j < n; j++) {
        arb_abs(x, value + j);
        arb_max(largest, largest, x, PREC);
    }
    LET(error, PREC, "2*M/(rho^(n - 1)*(rho - 1))*(constant + 1) + largest/2^bits*constant", M, rho, n, constant,
        largest, bits);
}

/* True if the last Chebyshev coefficients a_k of the interpolant agree with the proof: |a_k| <= 2 M rho^-k + 2 error. A
 * wrong sample or node would change all coefficients by about the same amount. */
static bool coefficients_agree(const arb_poly_t p, const struct ellipse_bound *bound, enum quantity quantity,
                               const arb_t error, slong n)
{
    LOCAL_VECTOR(value, n);
    const double rho = bound->rho, M = bound->modulus[quantity];
    LOCAL(arb, x, sum);
    LOCAL(fmpq, angle);
    bool agree = true;
    for (slong j = 0; j < n; j++) {
        exact_point(x, j, n);
        arb_poly_evaluate(value + j, p, x, PREC);
    }
    for (slong k = n - LAST_COEFFICIENTS; k < n; k++) {
        arb_zero(sum);
        for (slong j = 0; j < n; j++) { /* T_k(-cos(a)) = +-cos(k a) */
            fmpq_set_si(angle, k * (2 * j + 1), (ulong)(2 * n));
            arb_cos_pi_fmpq(x, angle, PREC);
            arb_addmul(sum, x, value + j, PREC);
        }
        agree = agree && HOLDS(PREC, "abs(2*sum/n) < 2*(M/rho^k + error)", sum, n, M, rho, k, error);
    }
    return agree;
}

int interpolant_error(double *error, const struct interpolant *f, int i, enum quantity quantity,
                      const struct ellipse_bound *bound)
{
    const struct interval *const interval = &f->layout->interval[i];
    const struct samples *const s = &f->samples[i];
    LOCAL(arb, constant, distance);
    bound_lebesgue(constant, s->node, interval);
    polynomial_error(distance, bound, quantity, constant, s->value[quantity], interval);
    *error = ball_magnitude(distance);
    return coefficients_agree(&s->polynomial[quantity], bound, quantity, distance, interval->count)
               ? STATUS_OK
               : fail("the interpolant of quantity %d on [%g, %g] differs from the function: a sample or a node is "
                      "wrong",
                      quantity, interval->lo, interval->hi);
}

void interpolant_on(arb_poly_t y, const struct interpolant *f, int i, enum quantity quantity, double error, double lo,
                    double hi)
{
    const struct interval *const interval = &f->layout->interval[i];
    const double from = interval->lo, to = interval->hi;
    LOCAL(arb, radius, middle, half);
    LET(middle, PREC, "(lo + hi - from - to)/(to - from)", lo, hi, from, to);
    LET(half, PREC, "(hi - lo)/(to - from)", lo, hi, from, to);
    enclosed_rescale(y, &f->samples[i].polynomial[quantity], middle, half, PREC);
    arb_poly_set_round(y, y, ENCLOSED_BITS);
    arb_set_d(radius, error);
    enclosed_add_radius(y, radius);
    enclosed_shorten(y);
}

/* ---- the constant of the creep ---- */

/* Computes the C of creep_series.h from collision j of an interval in ln(beta). C is the time from zero force to zero
 * overlap, divided by beta, minus the other terms. Returns false if the series has no bound for this collision. */
static bool creep_constant_of(arb_t constant, const struct interpolant_proof *proof, int i, slong j)
{
    const slong bits = proof->f->layout->interval[i].bits;
    const struct samples *const s = &proof->f->samples[i];
    LOCAL(arb, x, r, power, eps, time, end);
    const arb_ptr exact[] = {eps, time, end};
    static const enum quantity of[] = {EPS_ZERO_FORCE, DURATION_ZERO_FORCE, DURATION_ZERO_OVERLAP};
    for (int k = 0; k < 3; k++) { /* sample j, which is rounded to `bits` bits */
        arb_set(exact[k], s->value[of[k]] + j);
        arb_mul_2exp_si(x, exact[k], -bits);
        arb_add_error(exact[k], x);
    }
    const arb_srcptr u = s->node + j;          /* ln(beta) */
    LET(x, PREC, "log(eps) + 10*u/3", eps, u); /* 2 ln(Y) at zero force, Y = beta^(5/3) sqrt(eps beta^(5/3)) */
    LET(r, PREC, "exp(-x/2)", x);
    LET(constant, PREC, "end - x - exp(-5*u/3)*time", end, x, u, time);
    arb_one(power);
    for (slong k = 1; k <= CREEP_SERIES_ORDER; k++) {
        arb_mul(power, power, r, PREC);
        arb_submul(constant, power, proof->creep.a + k, PREC);
    }
    creep_series_remainder(x, &proof->creep, r);
    const bool known = arb_is_finite(x);
    arb_add_error(constant, x);
    return known;
}

/* Intersects the C of all collisions of the interval, which must agree. */
static int prove_creep(struct interpolant_proof *proof, int i)
{
    const struct interval *const interval = &proof->f->layout->interval[i];
    int status = STATUS_OK;
    LOCAL(arb, c);
    arb_zero_pm_one(proof->creep_constant);
    arb_mul_2exp_si(proof->creep_constant, proof->creep_constant, 6);
    for (slong j = 0; j < interval->count && status == STATUS_OK; j++)
        if (creep_constant_of(c, proof, i, j) &&
            !arb_intersection(proof->creep_constant, proof->creep_constant, c, PREC))
            status = fail(
                "the duration at zero overlap, sample %ld on [%g, %g], does not match the slow approach to the end",
                (long)j, interval->lo, interval->hi);
    arb_get_rad_arb(c, proof->creep_constant);
    proof->error[i][DURATION_ZERO_OVERLAP] = ball_magnitude(c);
    return status;
}

/* ---- all intervals ---- */

static int prove_interval(struct interpolant_proof *proof, int i, unsigned quantities, enum ellipse_source source)
{
    const struct interval *const interval = &proof->f->layout->interval[i];
    const unsigned set = ellipse_bound_set(interval) & quantities;
    if (!proof->f->samples[i].known)
        return STATUS_OK;
    const struct ellipse_bound *const stated = &ellipse_stated[i];
    struct ellipse_bound bound = *stated;
    int status = source == ELLIPSES_PROVED ? ellipse_bound_make(&bound, interval, stated->rho) : STATUS_OK;
    for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++)
        if (!(bound.modulus[q] <= stated->modulus[q]))
            status = fail("quantity %d on the ellipse around [%g, %g]: the proved bound %g is above the stated %g", q,
                          interval->lo, interval->hi, bound.modulus[q], stated->modulus[q]);
    for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++)
        if (set & 1u << q)
            status = interpolant_error(&proof->error[i][q], proof->f, i, (enum quantity)q, &bound);
    if (status == STATUS_OK && interval->variable == INTERVAL_LOG && quantities & 1u << DURATION_ZERO_OVERLAP)
        status = prove_creep(proof, i);
    return status;
}

struct interpolant_proof *interpolant_proof_new(const struct interpolant *f, unsigned quantities,
                                                enum ellipse_source source)
{
    const int intervals = f->layout->intervals;
    struct interpolant_proof *proof = xmalloc(sizeof *proof);
    proof->f = f;
    creep_series_init(&proof->creep, PREC);
    arb_init(proof->creep_constant);
    proof->error = xmalloc((size_t)intervals * sizeof *proof->error);
    for (int i = 0; i < intervals; i++)
        for (int q = 0; q < QUANTITIES; q++)
            proof->error[i][q] = HUGE_VAL;
    int status = STATUS_OK;
    if (!law_is_sphere(&f->layout->law) || intervals != ELLIPSES)
        status = fail("only the interpolant of interpolant_sphere_proof can be proved");
    for (int i = 0; i < intervals && status == STATUS_OK; i++)
        if (ellipse_stated[i].rho > 0)
            status = prove_interval(proof, i, quantities, source);
    if (status == STATUS_OK)
        return proof;
    interpolant_proof_free(proof);
    return NULL;
}

void interpolant_proof_free(struct interpolant_proof *proof)
{
    if (!proof)
        return;
    creep_series_clear(&proof->creep);
    arb_clear(proof->creep_constant);
    free(proof->error);
    free(proof);
}

/* ---- a row on a piece of its cell ---- */

/* The part of a cell in one interval, lo <= x <= hi, and functions of x on it */
struct piece {
    const struct interpolant_proof *proof;
    const struct pieces *p;
    struct cell cell;
    int i;
    const struct interval *interval;
    arb_poly_t x, stored; /* the interval's variable; the number that it stores, with its error */
    arb_poly_t beta;
};

/* True if the creep's series, not a polynomial, gives a quantity. */
static bool is_creep(const struct interval *interval, enum quantity quantity)
{
    return interval->variable == INTERVAL_LOG && quantity == DURATION_ZERO_OVERLAP;
}

/* Computes C + a_1 r + a_2 r^2 + ..., with the remainder. */
static void creep_sum(arb_poly_t y, const struct interpolant_proof *proof, const arb_poly_t r)
{
    LOCAL(arb, most, remainder);
    arb_poly_zero(y);
    for (slong k = CREEP_SERIES_ORDER; k >= 1; k--) {
        enclosed_add_number(y, proof->creep.a + k);
        enclosed_multiply(y, y, r);
    }
    enclosed_add_number(y, proof->creep_constant);
    enclosed_range(most, r);
    arb_get_ubound_arf(arb_midref(most), most, ENCLOSED_BITS);
    mag_zero(arb_radref(most));
    creep_series_remainder(remainder, &proof->creep, most);
    enclosed_add_radius(y, remainder);
}

bool interpolant_proof_creep(arb_poly_t duration, const struct interpolant_proof *proof, const arb_poly_t eps,
                             const arb_poly_t time, const arb_poly_t u, const arb_poly_t mu)
{
    LOCAL(arb_poly, r, sum);
    const bool done = LET_FUNCTION(r, "mu/sqrt(eps)", mu, eps);
    creep_sum(sum, proof, r);
    return LET_FUNCTION(duration, "time*mu + log(eps) + 10/3*u + sum", time, mu, eps, u, sum) && done;
}

static void stored_on(arb_poly_t y, const struct piece *w, enum quantity quantity, double lo, double hi)
{
    interpolant_on(y, w->proof->f, w->i, quantity, w->proof->error[w->i][quantity], lo, hi);
}

static void piece_init(struct piece *w, const struct interpolant_proof *proof, const struct pieces *p, slong row, int i,
                       double lo, double hi)
{
    const enum quantity stored = sampled_quantity(p->quantity);
    *w = (struct piece){.proof = proof, .p = p, .i = i, .interval = &proof->f->layout->interval[i]};
    w->cell = pieces_cell(p, row);
    FOR_ALL(arb_poly, init, w->x, w->stored, w->beta);
    enclosed_variable(w->x, lo, hi);
    if (is_creep(w->interval, stored)) {
        LOCAL(arb_poly, eps, time, mu);
        stored_on(eps, w, EPS_ZERO_FORCE, lo, hi);
        stored_on(time, w, DURATION_ZERO_FORCE, lo, hi);
        LET_FUNCTION(mu, "exp(-5*w->x/3)", w->x);
        interpolant_proof_creep(w->stored, w->proof, eps, time, w->x, mu); /* not finite without a proof */
    } else {
        stored_on(w->stored, w, stored, lo, hi);
    }
    if (w->interval->variable == INTERVAL_ROOT)
        enclosed_multiply(w->beta, w->x, w->x);
    else
        LET_FUNCTION(w->beta, "exp(w->x)", w->x);
}

static void piece_clear(struct piece *w)
{
    FOR_ALL(arb_poly, clear, w->x, w->stored, w->beta);
}

static bool is_inverse(const struct pieces *p)
{
    return p->variable == VARIABLE_LOSS || p->variable == VARIABLE_ROOT_LOSS || p->variable == VARIABLE_EPS_OCTAVES;
}

/* Computes 1 - eps from the number that the interval stores for eps. */
static void loss_of(arb_poly_t y, const struct piece *w)
{
    static const char *const of_stored[] = {[FORM_VALUE] = "1 - w->stored",
                                            [FORM_QUOTIENT] = "w->stored*w->beta",
                                            [FORM_POWER] = "1 - w->stored*exp(-5*w->x/3)"};
    LET_FUNCTION(y, of_stored[w->interval->form], w->stored, w->beta, w->x);
}

void interpolant_proof_eps(arb_poly_t eps, arb_poly_t beta, arb_poly_t x, const struct interpolant_proof *proof, int i,
                           enum quantity quantity, double lo, double hi)
{
    const struct pieces p = {.quantity = quantity};
    LOCAL_INIT(piece, w, (&w, proof, &p, 0, i, lo, hi));
    loss_of(eps, &w);
    LET_FUNCTION(eps, "1 - eps", eps);
    arb_poly_set(beta, w.beta);
    arb_poly_set(x, w.x);
}

/* Computes the variable y of the table. Returns false if it is not proved to be defined. */
static bool variable_of(arb_poly_t y, const struct piece *w)
{
    const bool by_root = w->interval->variable == INTERVAL_ROOT, quotient = w->interval->form == FORM_QUOTIENT;
    const char *const of_place[] = {[VARIABLE_BETA] = "w->beta",
                                    [VARIABLE_ROOT_BETA] = "w->x",
                                    [VARIABLE_LOG_BETA] = by_root ? "log(w->beta)" : "w->x",
                                    [VARIABLE_LOSS] = "loss",
                                    [VARIABLE_ROOT_LOSS] = quotient ? "sqrt(w->stored)*w->x" : "sqrt(loss)",
                                    [VARIABLE_POWER_OCTAVES] = "w->beta^5",
                                    [VARIABLE_EPS_OCTAVES] = "1 - loss"};
    const char *const text = w->p->variable <= VARIABLE_EPS_OCTAVES ? of_place[w->p->variable] : NULL;
    LOCAL(arb_poly, loss);
    if (is_inverse(w->p))
        loss_of(loss, w);
    const bool done = text && LET_FUNCTION(y, text, w->beta, w->x, w->stored, loss);
    arb_poly_scalar_mul_2exp_si(y, y, -w->cell.octave);
    return done;
}

/* Computes the row, c_0 + (c_0' + s (c_1 + c_2 t + ...)). */
static bool row_of(arb_poly_t row, const struct piece *w, const double *c)
{
    const double node = w->cell.node;
    LOCAL(arb_poly, t, s);
    const bool done = variable_of(t, w);
    LET_FUNCTION(s, w->cell.plain ? "t - node" : "t^2 - node^2", t, node);
    LET_FUNCTION(t, "t - node", t, node);
    arb_poly_zero(row);
    for (slong k = w->p->degree + 1; k >= 2; k--) {
        enclosed_multiply(row, row, t);
        enclosed_add_double(row, c[k]);
    }
    LET_FUNCTION(row, "row*s + c[1] + c[0]", row, s, c[1], c[0]);
    return done;
}

/* Computes the relative error of the row as difference/scale. */
static bool relative_error(arb_poly_t difference, arb_poly_t scale, const struct piece *w, const double *c)
{
    const bool quotient = w->interval->form == FORM_QUOTIENT, by_root = w->interval->variable == INTERVAL_ROOT;
    const char *value = "row", *of = "w->stored"; /* formulas of the row and of the number that it approximates */
    LOCAL(arb_poly, row, loss);
    const bool done = row_of(row, w, c);
    if (is_eps(sampled_quantity(w->p->quantity)))
        loss_of(loss, w);
    switch (w->p->quantity) {
    case LOSS_QUOTIENT_ZERO_OVERLAP:
    case LOSS_QUOTIENT_ZERO_FORCE:
        value = quotient ? "row" : "row*w->beta";
        of = quotient ? "w->stored" : "loss";
        break;
    case BETA_QUOTIENT_ZERO_OVERLAP:
    case BETA_QUOTIENT_ZERO_FORCE:
        value = quotient ? "row*w->stored" : "row*loss";
        of = quotient ? "1" : "w->beta";
        break;
    case BETA_ZERO_OVERLAP:
    case BETA_ZERO_FORCE:
        of = "w->beta";
        break;
    case EPS_ZERO_OVERLAP:
    case EPS_ZERO_FORCE:
        of = quotient ? "1 - loss" : "w->stored";
        break;
    case DURATION_ZERO_OVERLAP:
        value = w->p->variable == VARIABLE_LOG_BETA && by_root ? "row*w->beta" : "row";
        break;
    default:
        break;
    }
    LET_FUNCTION(scale, of, w->stored, w->beta, loss);
    LET_FUNCTION(difference, value, row, w->stored, w->beta, loss);
    arb_poly_sub(difference, difference, scale, ENCLOSED_BITS);
    return done;
}

/* Bounds the row's relative error for lo <= x <= hi in interval i. The bound is infinite without a proof. */
static double piece_error(const struct interpolant_proof *proof, const struct pieces *p, slong row, const double *c,
                          int i, double lo, double hi)
{
    LOCAL_INIT(piece, w, (&w, proof, p, row, i, lo, hi));
    LOCAL(arb_poly, difference, scale);
    const bool done = relative_error(difference, scale, &w, c);
    enclosed_shorten(difference);
    double known = 0;
    for (int k = -POINTS; k <= POINTS && done; k++)
        known = fmax(known, enclosed_ratio_at(difference, scale, k / (double)POINTS));
    return done ? enclosed_largest_ratio(difference, scale, known, HALVINGS) : HUGE_VAL;
}

/* ---- cells ---- */

/* Exceeds the rounding errors of a few functions of libm */
#define SLACK 1e-13

/* A range of sqrt(beta), or of ln(beta) for tables in that variable */
struct range {
    enum interval_variable variable;
    double lo, hi;
};

/* Computes an approximate sqrt(beta) at which an inverse function has the argument x. */
static bool inverse_place(double *z, const struct interpolant_proof *proof, enum quantity quantity, double x)
{
    LOCAL(arb, place, value);
    arb_set_d(place, x);
    const bool found = interpolant_inverse(value, proof->f, quantity, place, PREC) == STATUS_OK;
    if (quantity == BETA_QUOTIENT_ZERO_OVERLAP || quantity == BETA_QUOTIENT_ZERO_FORCE)
        arb_mul(value, value, place, PREC);
    *z = sqrt(ball_middle(value));
    return found;
}

/* Computes a range that should contain every place of the cell. */
static bool cell_range(struct range *range, const struct interpolant_proof *proof, const struct pieces *p,
                       const struct cell *cell)
{
    double lo = ldexp(cell->lo, (int)cell->octave), hi = ldexp(cell->hi, (int)cell->octave);
    range->variable = INTERVAL_ROOT;
    switch (p->variable) {
    case VARIABLE_LOG_BETA:
        *range = (struct range){INTERVAL_LOG, lo, hi};
        return true;
    case VARIABLE_ROOT_BETA:
        *range = (struct range){INTERVAL_ROOT, lo, hi};
        return true;
    case VARIABLE_BETA:
        lo = sqrt(lo);
        hi = sqrt(hi);
        break;
    case VARIABLE_POWER_OCTAVES:
        lo = pow(lo, 0.1);
        hi = pow(hi, 0.1);
        break;
    case VARIABLE_ROOT_LOSS:
        lo *= lo;
        hi *= hi;
        /* fall through */
    case VARIABLE_LOSS:
    case VARIABLE_EPS_OCTAVES:
        if (!inverse_place(&range->lo, proof, p->quantity, p->variable == VARIABLE_EPS_OCTAVES ? hi : lo) ||
            !inverse_place(&range->hi, proof, p->quantity, p->variable == VARIABLE_EPS_OCTAVES ? lo : hi))
            return false;
        lo = range->lo;
        hi = range->hi;
        break;
    default:
        return false;
    }
    range->lo = lo * (1 - SLACK);
    range->hi = hi * (1 + SLACK);
    return true;
}

/* Returns the sign of y - limit, with the table's variable y at x in interval i: 1 or -1 if proved, otherwise 0. */
static int side_of(const struct interpolant_proof *proof, const struct pieces *p, slong row, int i, double x,
                   double limit)
{
    LOCAL_INIT(piece, w, (&w, proof, p, row, i, x, x));
    LOCAL(arb_poly, y);
    LOCAL(arb, range);
    const bool done = variable_of(y, &w);
    enclosed_add_double(y, -limit);
    enclosed_range(range, y);
    return !done ? 0 : arb_is_nonnegative(range) ? 1 : arb_is_nonpositive(range) ? -1 : 0;
}

/* The part of a cell in interval i, lo <= x <= hi */
struct part {
    int interval;
    double lo, hi;
};
enum { MOST_PARTS = 16 };

/* Computes the part of a range that is in an interval. The part begins at `reached`, in the range's variable. Moves
 * `reached` to the end of the part. A range in sqrt(beta) may continue in intervals of ln(beta). For the duration at
 * zero overlap, intervals of sqrt(beta) cover a range in ln(beta) up to CREEP_FROM or beyond. Returns 1, 0 if the
 * interval has no part, or -1 if it leaves a gap after `reached`. */
static int part_of(struct part *part, double *reached, const struct range *range, const struct interval *interval,
                   enum quantity stored)
{
    const bool same = interval->variable == range->variable, by_log = !same && interval->variable == INTERVAL_LOG;
    const bool by_root = !same && !by_log && stored == DURATION_ZERO_OVERLAP && *reached < CREEP_FROM;
    double lo = *reached, hi = range->hi;
    if (by_log) {
        lo = 2 * log(lo) - SLACK;
        hi = 2 * log(hi) + SLACK;
    } else if (by_root) {
        lo = exp(lo / 2) * (1 - SLACK);
        hi = exp(hi / 2) * (1 + SLACK);
    } else if (!same) {
        return 0;
    }
    if (lo >= interval->hi || (is_creep(interval, stored) && lo < CREEP_FROM))
        return 0;
    if (lo < interval->lo)
        return -1;
    part->lo = lo;
    part->hi = fmin(hi, interval->hi);
    *reached = hi <= interval->hi ? range->hi : by_root ? 2 * log(part->hi) - SLACK : part->hi;
    return 1;
}

/* Splits a cell into parts within intervals whose error is known. Returns their number, or 0 if they do not cover the
 * cell. */
static int split_cell(struct part *part, const struct interpolant_proof *proof, const struct pieces *p, slong row)
{
    const struct interpolant_layout *const layout = proof->f->layout;
    const enum quantity stored = sampled_quantity(p->quantity);
    const struct cell cell = pieces_cell(p, row);
    struct range range;
    int parts = 0;
    if (!cell_range(&range, proof, p, &cell))
        return 0;
    double reached = range.lo;
    for (int i = 0; i < layout->intervals && reached < range.hi && parts < MOST_PARTS; i++) {
        if (!isfinite(proof->error[i][stored]))
            continue;
        part[parts].interval = i;
        const int more = part_of(&part[parts], &reached, &range, &layout->interval[i], stored);
        if (more < 0)
            return 0;
        parts += more;
    }
    return reached < range.hi ? 0 : parts;
}

/* True if the first or last part of an inverse's range is proved to reach the end of the cell. At beta = 0 no proof is
 * needed, because 1 - eps is exactly 0 there. */
static bool end_reached(const struct interpolant_proof *proof, const struct pieces *p, slong row,
                        const struct part *part, bool first)
{
    const struct cell cell = pieces_cell(p, row);
    const bool falls = p->variable == VARIABLE_EPS_OCTAVES, high = falls == first;
    const double x = first ? part->lo : part->hi;
    if (!is_inverse(p) || (first && x == 0 && cell.lo == 0))
        return true;
    return side_of(proof, p, row, part->interval, x, high ? cell.hi : cell.lo) == (high ? 1 : -1);
}

/* Bounds the row's relative error in its whole cell. The bound is infinite without a proof. */
static double row_error(const struct interpolant_proof *proof, const struct pieces *p, slong row, const double *c)
{
    struct part part[MOST_PARTS];
    const int parts = split_cell(part, proof, p, row);
    if (parts == 0 || !end_reached(proof, p, row, &part[0], true) ||
        !end_reached(proof, p, row, &part[parts - 1], false))
        return HUGE_VAL;
    double error = 0;
    for (int i = 0; i < parts; i++)
        error = fmax(error, piece_error(proof, p, row, c, part[i].interval, part[i].lo, part[i].hi));
    return error;
}

double row_proof_bits(const struct interpolant_proof *proof, const struct pieces *p, slong row, const double *c)
{
    const double error = row_error(proof, p, row, c);
    return isfinite(error) ? -log2(error) : NAN;
}

struct proving {
    struct pieces *p;
    const struct interpolant_proof *proof;
};

static void prove_row(void *context, slong row)
{
    struct proving *const work = context;
    struct pieces *const p = work->p;
    p->bits[row] = row_proof_bits(work->proof, p, row, p->value + row * (p->degree + 2));
}

int row_proof_table(struct pieces *p, const struct interpolant_proof *proof)
{
    struct proving work = {.p = p, .proof = proof};
    parallel_for(prove_row, &work, p->rows, p->name);
    for (slong row = 0; row < p->rows; row++)
        if (!(p->bits[row] >= p->least_bits))
            return fail("%s, row %ld: %.2f bits proved, %.1f required", p->name, (long)row, p->bits[row],
                        p->least_bits);
    p->proved = true;
    return STATUS_OK;
}
