/* SPDX-License-Identifier: MIT */
#include "approximation/far_proof.h"

#include <math.h>

#include "approximation/enclosed_function.h"
#include "support/console.h"
#include "support/local.h"

enum {
    HALVINGS = 8, /* of a cell, at most */
    POINTS = 8    /* on each side of its middle, where the error is evaluated first */
};

/* Cells of u have this length up to WIDE_FROM. There mu < 2e-29, so that any number up to mu can stand for it in longer
 * cells. */
#define CELL_LENGTH 0.5
#define WIDE_FROM 40.0

/* A bound below this is not made smaller. */
#define SMALL_ENOUGH 0x1p-76

int far_proof_init(struct far_proof *proof, const struct interpolant_proof *rows)
{
    proof->rows = rows;
    if (far_motion_init(&proof->motion))
        return STATUS_OK;
    return fail("the series for large beta could not be proved");
}

void far_proof_clear(struct far_proof *proof)
{
    far_motion_clear(&proof->motion);
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
        enclosed_exponential(cell->mu, -5, 3, cell->u);
    } else {
        LET(x, ENCLOSED_BITS, "exp(-5*lo/3)", lo);
        enclosed_add_radius(cell->mu, x);
    }
}

static void far_cell_clear(struct far_cell *cell)
{
    FOR_ALL(arb_poly, clear, cell->u, cell->mu);
}

/* sum_k mu^k order_k(u), 0 <= k < orders */
static void sum_of_orders(arb_poly_t y, const arb_poly_struct *order, slong orders, const struct far_cell *cell)
{
    LOCAL(arb_poly, term);
    arb_poly_zero(y);
    for (slong k = orders - 1; k >= 0; k--) {
        enclosed_multiply(y, y, cell->mu);
        arb_poly_compose(term, &order[k], cell->u, ENCLOSED_BITS);
        arb_poly_add(y, y, term, ENCLOSED_BITS);
    }
}

static void series_on(arb_poly_t y, const struct far_series *s, const struct far_cell *cell)
{
    LOCAL(mag, rest);
    LOCAL(arb, radius);
    sum_of_orders(y, s->order, EXPANSION_ORDER + 1, cell);
    mag_set_d(rest, cell->hi);
    mag_mul(rest, rest, s->rest_per_u);
    mag_add(rest, rest, s->rest);
    if (!(cell->lo >= FAR_MOTION_LEAST_U))
        mag_inf(rest);
    arf_set_mag(arb_midref(radius), rest);
    enclosed_add_radius(y, radius);
}

static bool function_on(arb_poly_t y, const struct far_proof *proof, enum quantity quantity,
                        const struct far_cell *cell)
{
    const struct far_motion *const m = &proof->motion;
    switch (quantity) {
    case EPS_ZERO_FORCE:
        series_on(y, &m->eps_zero_force, cell);
        return true;
    case DURATION_ZERO_FORCE:
        series_on(y, &m->duration_zero_force, cell);
        return true;
    case MAX_OVERLAP:
        series_on(y, &m->max_overlap, cell);
        return true;
    case TIME_OF_MAX_OVERLAP:
        series_on(y, &m->time_of_max_overlap, cell);
        return true;
    case DURATION_ZERO_OVERLAP: {
        LOCAL(arb_poly, eps, time);
        series_on(eps, &m->eps_zero_force, cell);
        series_on(time, &m->duration_zero_force, cell);
        const bool done = interpolant_proof_creep(y, proof->rows, eps, time, cell->u, cell->mu);
        return done;
    }
    default:
        return false;
    }
}

bool far_proof_function(arb_poly_t y, const struct far_proof *proof, enum quantity quantity, double lo, double hi)
{
    LOCAL_INIT(far_cell, cell, (&cell, lo, hi));
    return function_on(y, proof, quantity, &cell);
}

/* ---- formulas on a cell ---- */

/* Adds c_k u^power to a polynomial. */
static void add_coefficient(arb_poly_t p, slong power, double c)
{
    LOCAL(arb, x, sum);
    arb_set_d(x, c);
    arb_poly_get_coeff_arb(sum, p, power);
    arb_add(sum, sum, x, ENCLOSED_BITS);
    arb_poly_set_coeff_arb(p, power, sum);
}

/* a_0 + a_0' + (a_1 + a_1') u + mu (a_2 + a_3 u + a_4 u^2) + mu^2 (a_5 + ... + a_8 u^3) */
static void formula_on(arb_poly_t y, const double *c, const struct far_cell *cell)
{
    arb_poly_struct order[3];
    for (int k = 0; k < 3; k++)
        arb_poly_init(&order[k]);
    for (int k = 0; k < 4; k++) {
        add_coefficient(&order[0], k / 2, c[k]);
        add_coefficient(&order[2], k, c[7 + k]);
    }
    for (int k = 0; k < 3; k++)
        add_coefficient(&order[1], k, c[4 + k]);
    sum_of_orders(y, order, 3, cell);
    for (int k = 0; k < 3; k++)
        arb_poly_clear(&order[k]);
}

/* ln of the formula's beta over beta: with q = eps beta^(5/3)/a and e = mu q it is -(3/5) ln(q) + ln(1 + e (b_0 + b_1 v
 * + b_2 v^2) + e^2 (c_0 + ... + c_4 v^4)), v = u - (3/5) ln(q). */
static bool inverse_on(arb_poly_t y, const struct far_proof *proof, const double *c, const struct far_cell *cell)
{
    LOCAL(arb_poly, q, e, v, sum);
    LOCAL(arb, x);
    add_coefficient(v, 0, c[0]);
    add_coefficient(v, 0, c[1]);
    series_on(q, &proof->motion.eps_zero_force, cell);
    arb_poly_get_coeff_arb(x, v, 0);
    arb_poly_scalar_div(q, q, x, ENCLOSED_BITS);
    enclosed_multiply(e, q, cell->mu);
    bool done = enclosed_logarithm(q, q);
    arb_set_si(x, -3);
    arb_div_ui(x, x, 5, ENCLOSED_BITS);
    arb_poly_scalar_mul(q, q, x, ENCLOSED_BITS);
    arb_poly_add(v, cell->u, q, ENCLOSED_BITS);
    for (int k = 9; k >= 5; k--) {
        enclosed_multiply(sum, sum, v);
        enclosed_add_double(sum, c[k]);
    }
    enclosed_multiply(sum, sum, e);
    arb_poly_zero(y);
    for (int k = 4; k >= 2; k--) {
        enclosed_multiply(y, y, v);
        enclosed_add_double(y, c[k]);
    }
    arb_poly_add(sum, sum, y, ENCLOSED_BITS);
    enclosed_multiply(sum, sum, e);
    enclosed_add_double(sum, 1);
    done = done && enclosed_logarithm(y, sum);
    arb_poly_add(y, y, q, ENCLOSED_BITS);
    return done;
}

/* ---- all cells ---- */

/* exp(x) - 1 for a bound x of a logarithm's modulus */
static double relative(double x)
{
    return x < 0x1p-20 ? x * (1 + x) : HUGE_VAL;
}

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
    return quantity == BETA_ZERO_FORCE ? relative(error) : error;
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
