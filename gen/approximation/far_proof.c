/* SPDX-License-Identifier: MIT */
#include "approximation/row_proof.h"

#include <math.h>

#include "support/console.h"
#include "support/enclosed_function.h"
#include "support/local.h"

enum {
    HALVINGS = 8, /* largest number of halvings of a cell */
    POINTS = 8    /* points on each side of the middle at which the error is evaluated first */
};

/* Length of cells up to u = WIDE_FROM. Beyond it mu < 4e-28, so the limits of the functions for mu -> 0 suffice, and
 * longer cells enclose mu in a ball around 0. */
#define CELL_LENGTH 0.5
#define WIDE_FROM 38.0

/* The code does not improve a bound below this. */
#define SMALL_ENOUGH 0x1p-73

/* Intervals of u for x_max, t_max, eps and duration at zero force, each divided by its power of beta */
static const struct interval far_intervals[FAR_PROOF_INTERVALS] = {
    {INTERVAL_LOG, 9.4, 20.6, 40, 84, FORM_POWER, SET_LENGTHS | SET_ZERO_FORCE},
    {INTERVAL_LOG, 20, WIDE_FROM + 0.6, 36, 84, FORM_POWER, SET_LENGTHS | SET_ZERO_FORCE},
};
static const double far_rho[FAR_PROOF_INTERVALS] = {4.5, 5.5};

int far_proof_init(struct far_proof *proof, const struct interpolant_proof *rows, double beta_max)
{
    *proof =
        (struct far_proof){.layout = {law_sphere, 2, far_intervals, FAR_PROOF_INTERVALS, false, NULL, 0}, .rows = rows};
    proof->f = interpolant_new(&proof->layout, exp(FAR_PROOF_INVERSE_FROM), beta_max);
    int status = proof->f ? STATUS_OK : STATUS_FAILED;
    for (int i = 0; i < FAR_PROOF_INTERVALS && status == STATUS_OK && proof->f->samples[i].known; i++) {
        struct ellipse_bound bound;
        status = ellipse_bound_make(&bound, &far_intervals[i], far_rho[i]);
        for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++)
            if (far_intervals[i].set & 1u << q)
                status = interpolant_error(&proof->error[i][q], proof->f, i, (enum quantity)q, &bound);
    }
    return status;
}

void far_proof_clear(struct far_proof *proof)
{
    interpolant_free(proof->f);
}

/* ---- functions on a cell ---- */

struct far_cell {
    double lo, hi;
    arb_poly_t u, mu;
};

static void far_cell_init(struct far_cell *cell, double lo, double hi)
{
    LOCAL(arb, x);
    cell->lo = lo;
    cell->hi = hi;
    FOR_ALL(arb_poly, init, cell->u, cell->mu);
    enclosed_variable(cell->u, lo, hi);
    if (hi <= WIDE_FROM) {
        LET_FUNCTION(cell->mu, "exp(-5*cell->u/3)", cell->u);
    } else {
        LET(x, ENCLOSED_BITS, "exp(-5*lo/3)", lo);
        enclosed_add_radius(cell->mu, x);
    }
}

static void far_cell_clear(struct far_cell *cell)
{
    FOR_ALL(arb_poly, clear, cell->u, cell->mu);
}

/* Computes a quantity's limit for mu -> 0. The quantity differs from its limit by at most 210 mu u^2 (docs/theory.md,
 * 8). */
static void limit_on(arb_poly_t y, enum quantity quantity, const struct far_cell *cell)
{
    const slong events = quantity == DURATION_ZERO_FORCE ? 2 : 1; /* slow phases, whose durations grow like ln(1/mu) */
    const double lo = cell->lo;
    LOCAL(arb, x, c);
    arb_poly_zero(y);
    LET(x, ENCLOSED_BITS, "(3/2)^(2/3)");
    if (quantity == MAX_OVERLAP || quantity == EPS_ZERO_FORCE) {
        arb_set(c, x);
    } else {
        LET(c, ENCLOSED_BITS, "10*events*x/9", events, x);
        LET_FUNCTION(y, "c*cell->u", c, cell->u);
        LET(c, ENCLOSED_BITS, "2*x*(log(3/x^(1/events)) + log(3)/2 - pi/sqrt(12))/3", x, events);
    }
    enclosed_add_number(y, c);
    LET(c, ENCLOSED_BITS, "210*lo^2*exp(-5*lo/3)", lo);
    enclosed_add_radius(y, c);
}

/* Computes a sampled quantity. Returns false if it is not known in the cell. */
static bool sampled_on(arb_poly_t y, const struct far_proof *proof, enum quantity quantity, const struct far_cell *cell)
{
    if (quantity >= QUANTITIES || !(far_intervals[0].set & 1u << quantity))
        return false;
    if (cell->lo >= WIDE_FROM) {
        limit_on(y, quantity, cell);
        return true;
    }
    for (int i = 0; i < FAR_PROOF_INTERVALS; i++)
        if (proof->f->samples[i].known && cell->lo >= far_intervals[i].lo && cell->hi <= far_intervals[i].hi) {
            interpolant_on(y, proof->f, i, quantity, proof->error[i][quantity], cell->lo, cell->hi);
            return true;
        }
    return false;
}

static bool function_on(arb_poly_t y, const struct far_proof *proof, enum quantity quantity,
                        const struct far_cell *cell)
{
    if (quantity != DURATION_ZERO_OVERLAP)
        return sampled_on(y, proof, quantity, cell);
    LOCAL(arb_poly, eps, time);
    return sampled_on(eps, proof, EPS_ZERO_FORCE, cell) && sampled_on(time, proof, DURATION_ZERO_FORCE, cell) &&
           interpolant_proof_creep(y, proof->rows, eps, time, cell->u, cell->mu);
}

bool far_proof_function(arb_poly_t y, const struct far_proof *proof, enum quantity quantity, double lo, double hi)
{
    LOCAL_INIT(far_cell, cell, (&cell, lo, hi));
    return function_on(y, proof, quantity, &cell);
}

/* ---- formulas on a cell ---- */

/* Computes a_0 + a_0' + (a_1 + a_1') u + mu (a_2 + a_3 u + a_4 u^2) + mu^2 (a_5 + ... + a_8 u^3). */
static void formula_on(arb_poly_t y, const double *c, const struct far_cell *cell)
{
    const arb_poly_struct *const u = cell->u, *const mu = cell->mu;
    LOCAL(arb_poly, first, second);
    LET_FUNCTION(first, "c[4] + (c[5] + c[6]*u)*u", c[4], c[5], c[6], u);
    LET_FUNCTION(second, "c[7] + (c[8] + (c[9] + c[10]*u)*u)*u", c[7], c[8], c[9], c[10], u);
    LET_FUNCTION(y, "(second*mu + first)*mu + (c[3] + c[2])*u + c[1] + c[0]", second, mu, first, c[3], c[2], u, c[1],
                 c[0]);
}

/* Computes the logarithm of the quotient of the formula's beta and the exact beta. With q = eps beta^(5/3)/a, e = mu q
 * and v = u - (3/5) ln(q) it is -(3/5) ln(q) + ln(1 + e (b_0 + b_1 v + b_2 v^2) + e^2 (c_0 + ... + c_4 v^4)). */
static bool inverse_on(arb_poly_t y, const struct far_proof *proof, const double *c, const struct far_cell *cell)
{
    LOCAL(arb_poly, q, e, v);
    bool done = sampled_on(q, proof, EPS_ZERO_FORCE, cell) &&
                LET_FUNCTION(e, "q*cell->mu/(c[0] + c[1])", q, cell->mu, c[0], c[1]) &&
                LET_FUNCTION(q, "-3*log(q/(c[0] + c[1]))/5", q, c[0], c[1]);
    LET_FUNCTION(v, "cell->u + q", cell->u, q);
    LET_FUNCTION(y, "(((c[9]*v + c[8])*v + c[7])*v + c[6])*v + c[5]", c[9], v, c[8], c[7], c[6], c[5]);
    return LET_FUNCTION(y, "log(1 + e*((c[4]*v + c[3])*v + c[2] + e*y)) + q", e, c[4], v, c[3], c[2], y, q) && done;
}

/* ---- all cells ---- */

static double cell_error(const struct far_proof *proof, enum quantity quantity, const double *c, double lo, double hi)
{
    LOCAL(arb_poly, difference, scale);
    double known = SMALL_ENOUGH, error;
    LOCAL_INIT(far_cell, cell, (&cell, lo, hi));
    bool done;
    if (quantity == BETA_ZERO_FORCE) {
        done = inverse_on(difference, proof, c, &cell);
        arb_poly_one(scale);
    } else {
        done = function_on(scale, proof, quantity, &cell);
        formula_on(difference, c, &cell);
        arb_poly_sub(difference, difference, scale, ENCLOSED_BITS);
    }
    for (int k = -POINTS; k <= POINTS && done; k++)
        known = fmax(known, enclosed_ratio_at(difference, scale, k / (double)POINTS));
    error = done ? enclosed_largest_ratio(difference, scale, known, HALVINGS) : HUGE_VAL;
    if (quantity != BETA_ZERO_FORCE)
        return error;
    return error < 0x1p-20 ? error * (1 + error) : HUGE_VAL; /* at least exp(error) - 1 */
}

double far_proof_bits(const struct far_proof *proof, enum quantity quantity, const double *c)
{
    double error = 0, hi;
    for (double lo = quantity == BETA_ZERO_FORCE ? FAR_PROOF_INVERSE_FROM : FAR_PROOF_FROM; lo < FAR_PROOF_TO;
         lo = hi) {
        hi = lo < WIDE_FROM ? fmin(lo + CELL_LENGTH, WIDE_FROM) : fmin(2 * lo, FAR_PROOF_TO);
        error = fmax(error, cell_error(proof, quantity, c, lo, hi));
    }
    return isfinite(error) ? -log2(error) : NAN;
}
