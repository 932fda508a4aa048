/* SPDX-License-Identifier: MIT */

#include <math.h>
#include <stdlib.h>

#include "approximation/row_proof.h"
#include "support/console.h"
#include "support/enclosed_function.h"
#include "support/local.h"

enum { PREC = 320 /* bits for the polynomials, whose coefficients are large and cancel */, COVERS = 3 };

#define LEAST_RHO 1.4
#define MOST_RHO 16
/* The shared ends of neighbouring intervals are rounded. Polynomial and error bound hold beyond an interval up to this
 * distance, in units of half its length: |T_k(1 + d)| <= exp(k sqrt(2 d)), which MORE_ERROR covers for k < 100. */
#define BEYOND 1e-9
#define MORE_ERROR 1.01
#define SLACK 1e-12

/* ---- the intervals ---- */

/* Computes ln(beta) at the ends of an interval. */
static void log_range(double range[2], const struct interpolant *f, const struct interval *interval)
{
    const bool falls = interval->variable == INTERVAL_BELOW;
    range[falls] = log(interpolant_beta_near(f, interval, interval->lo));
    range[!falls] = log(interpolant_beta_near(f, interval, interval->hi));
}

/* Returns the rho of an ellipse. A bound `modulus` of |eps| on this ellipse proves an error slightly below `wanted`. */
static double radius_for(const struct interval *interval, double modulus, double wanted)
{
    return pow(20 * modulus / wanted, 1 / ((double)interval->count - 1));
}

/* Proves interval i. The bound of the modulus on one ellipse shows if a larger ellipse is needed. */
static int prove_interval(struct law_proof *proof, int i, double wanted)
{
    const struct interval *const interval = &proof->f->layout->interval[i];
    double rho = radius_for(interval, 1, wanted);
    int status = STATUS_OK;
    for (int k = 0; k < COVERS && status == STATUS_OK; k++) {
        struct ellipse_bound bound;
        rho = fmin(fmax(rho, LEAST_RHO), MOST_RHO);
        if (!ellipse_bound_of_law(&bound, proof->f, interval, proof->eps, rho))
            break;
        status = interpolant_error(&proof->error[i], proof->f, i, proof->eps, &bound);
        const double next = 1.05 * radius_for(interval, bound.modulus[proof->eps], wanted);
        if (proof->error[i] <= wanted || next < 1.02 * rho)
            break;
        rho = next;
    }
    return status;
}

struct law_proof *law_proof_new(const struct interpolant *f, enum quantity eps, double beta_min, double beta_max,
                                double wanted)
{
    const struct interpolant_layout *const layout = f->layout;
    struct law_proof *proof = xmalloc(sizeof *proof);
    *proof = (struct law_proof){.f = f, .eps = eps};
    proof->error = xmalloc((size_t)layout->intervals * sizeof *proof->error);
    for (int i = 0; i < layout->intervals; i++)
        proof->error[i] = HUGE_VAL;
    int status = STATUS_OK;
    for (int i = 0; i < layout->intervals && status == STATUS_OK; i++) {
        double range[2];
        log_range(range, f, &layout->interval[i]);
        if (layout->interval[i].set & 1u << eps && f->samples[i].known && range[0] <= log(beta_max) + SLACK &&
            range[1] >= log(beta_min) - SLACK)
            status = prove_interval(proof, i, wanted);
    }
    if (status == STATUS_OK)
        return proof;
    law_proof_free(proof);
    return NULL;
}

void law_proof_free(struct law_proof *proof)
{
    if (!proof)
        return;
    free(proof->error);
    free(proof);
}

int law_proof_interval(double *end, const struct law_proof *proof, double u)
{
    const struct interpolant_layout *const layout = proof->f->layout;
    int found = -1;
    for (int i = 0; i < layout->intervals; i++) {
        double range[2];
        log_range(range, proof->f, &layout->interval[i]);
        if (!isfinite(proof->error[i]) || u < range[0] - SLACK || u >= range[1] - SLACK ||
            (found >= 0 && range[1] <= *end))
            continue;
        found = i;
        *end = range[1];
    }
    return found;
}

/* ---- eps on a part of an interval ---- */

/* Computes the variable x from ln(beta) and beta as functions of t. Returns false if x is not proved to be defined. */
static bool variable_of(arb_poly_t x, const struct law_proof *proof, const struct interval *interval,
                        const arb_poly_t log_beta, const arb_poly_t beta)
{
    static const char *const of_beta[] = {/* root = 1 */
                                          [INTERVAL_ROOT] = "beta",
                                          [INTERVAL_LOG] = "log_beta",
                                          [INTERVAL_BELOW] = "log(proof->f->threshold - beta)"};
    return LET_FUNCTION(x, of_beta[interval->variable], beta, log_beta, proof->f->threshold);
}

/* Computes w = (x - middle)/half. Returns false if w is not within [-1, 1] widened by BEYOND. */
static bool to_unit(arb_poly_t w, const arb_poly_t x, const struct interval *interval)
{
    const double lo = interval->lo, hi = interval->hi, most = 1 + BEYOND;
    LOCAL(arb, end);
    LET_FUNCTION(w, "(2*x - lo - hi)/(hi - lo)", x, lo, hi);
    /* x is monotone in t, so its ends are at t = -1 and t = 1 */
    bool inside = true;
    for (int t = -1; t <= 1; t += 2) {
        arb_set_si(end, t);
        arb_poly_evaluate(end, w, end, ENCLOSED_BITS);
        inside = inside && HOLDS(ENCLOSED_BITS, "abs(end) < most", end, most);
    }
    return inside;
}

/* Computes p(w), with the error of p. */
static void compose_rows(arb_poly_t y, const arb_poly_t p, const arb_poly_t w, double error)
{
    LOCAL(arb, c);
    arb_poly_zero(y);
    for (slong k = arb_poly_degree(p); k >= 0; k--) {
        arb_poly_get_coeff_arb(c, p, k);
        arb_poly_mul(y, y, w, PREC);
        enclosed_shorten(y);
        enclosed_add_number(y, c);
    }
    const double more = MORE_ERROR;
    LET(c, ENCLOSED_BITS, "error*more", error, more);
    enclosed_add_radius(y, c);
}

bool law_proof_eps(arb_poly_t eps, arb_poly_t log_beta, const struct law_proof *proof, int i, double lo, double hi)
{
    static const char *const stored[] = {[FORM_VALUE] = "eps",
                                         [FORM_QUOTIENT] = "1 - eps*beta",
                                         [FORM_LOG] = "exp(eps)",
                                         [FORM_POWER] = "eps*exp(power*log_beta)"};
    const struct interval *const interval = &proof->f->layout->interval[i];
    const struct ratio power = interpolant_tail_power(&proof->f->layout->law, proof->eps);
    LOCAL(arb_poly, beta, w);
    enclosed_variable(log_beta, lo, hi);
    LET_FUNCTION(beta, "exp(log_beta)", log_beta);
    const bool done =
        isfinite(proof->error[i]) && variable_of(w, proof, interval, log_beta, beta) && to_unit(w, w, interval);
    if (done) {
        compose_rows(eps, &proof->f->samples[i].polynomial[proof->eps], w, proof->error[i]);
        LET_FUNCTION(eps, stored[interval->form], eps, beta, power, log_beta);
    }
    return done;
}
