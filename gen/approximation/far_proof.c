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

/* Cells of u have this length up to WIDE_FROM. From there on, where mu < 4e-28, any number up to mu can stand for it in
 * longer cells, and the limits of the functions for mu -> 0 suffice. */
#define CELL_LENGTH 0.5
#define WIDE_FROM 38.0

/* A bound below this is not made smaller. */
#define SMALL_ENOUGH 0x1p-73

/* x_max, t_max, eps and duration at zero force without their powers of beta, at these u */
static const struct interval far_intervals[FAR_PROOF_INTERVALS] = {
    {INTERVAL_LOG, 9.4, 20.6, 40, 84, FORM_POWER, SET_LENGTHS | SET_ZERO_FORCE},
    {INTERVAL_LOG, 20, WIDE_FROM + 0.6, 36, 84, FORM_POWER, SET_LENGTHS | SET_ZERO_FORCE},
};
static const double far_rho[FAR_PROOF_INTERVALS] = {4.5, 5.5};

int far_proof_init(struct far_proof *proof, const struct interpolant_proof *rows, double beta_max)
{
    *proof =
        (struct far_proof){.layout = {law_sphere, 2, far_intervals, FAR_PROOF_INTERVALS, false, NULL, 0}, .rows = rows};
    for (int i = 0; i < FAR_PROOF_INTERVALS; i++)
        for (int q = 0; q < QUANTITIES; q++) {
            arb_poly_init(&proof->polynomial[i][q]);
            arb_init(&proof->error[i][q]);
        }
    proof->f = interpolant_new(&proof->layout, exp(FAR_PROOF_INVERSE_FROM), beta_max);
    int status = proof->f ? STATUS_OK : STATUS_FAILED;
    for (int i = 0; i < FAR_PROOF_INTERVALS && status == STATUS_OK && proof->f->samples[i].known; i++) {
        struct ellipse_bound bound;
        status = ellipse_bound_make(&bound, &far_intervals[i], far_rho[i]);
        for (int q = 0; q < QUANTITIES && status == STATUS_OK; q++)
            if (far_intervals[i].set & 1u << q)
                status = interpolant_polynomial(&proof->polynomial[i][q], &proof->error[i][q], proof->f, i,
                                                (enum quantity)q, &bound);
    }
    return status;
}

void far_proof_clear(struct far_proof *proof)
{
    interpolant_free(proof->f);
    for (int i = 0; i < FAR_PROOF_INTERVALS; i++)
        for (int q = 0; q < QUANTITIES; q++) {
            arb_poly_clear(&proof->polynomial[i][q]);
            arb_clear(&proof->error[i][q]);
        }
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

/* The limit for mu -> 0, from which a quantity differs by 210 mu u^2 at most (docs/theory.md, 8) */
static void limit_on(arb_poly_t y, enum quantity quantity, const struct far_cell *cell)
{
    const slong events = quantity == DURATION_ZERO_FORCE ? 2 : 1; /* each takes ln(1/mu) */
    const double lo = cell->lo;
    LOCAL(arb, x, c);
    arb_poly_zero(y);
    LET(x, ENCLOSED_BITS, "(3/2)^(2/3)");
    if (quantity == MAX_OVERLAP || quantity == EPS_ZERO_FORCE) {
        arb_set(c, x);
    } else {
        LET(c, ENCLOSED_BITS, "10*events*x/9", events, x);
        arb_poly_scalar_mul(y, cell->u, c, ENCLOSED_BITS);
        LET(c, ENCLOSED_BITS, "2*x*(log(3/x^(1/events)) + log(3)/2 - pi/sqrt(12))/3", x, events);
    }
    enclosed_add_number(y, c);
    LET(c, ENCLOSED_BITS, "210*lo^2*exp(-5*lo/3)", lo);
    enclosed_add_radius(y, c);
}

/* A sampled quantity. Returns false if nothing is known of it in the cell. */
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
            interpolant_polynomial_on(y, &proof->polynomial[i][quantity], &proof->error[i][quantity], &far_intervals[i],
                                      cell->lo, cell->hi);
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
    bool done = sampled_on(q, proof, EPS_ZERO_FORCE, cell);
    arb_poly_get_coeff_arb(x, v, 0);
    arb_poly_scalar_div(q, q, x, ENCLOSED_BITS);
    enclosed_multiply(e, q, cell->mu);
    done = done && enclosed_logarithm(q, q);
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
