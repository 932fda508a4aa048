/* SPDX-License-Identifier: MIT */
#include "series/restitution.h"

#include "series/jet.h"
#include "series/trajectory.h"
#include "support/console.h"
#include "support/local.h"

void turning_point_elastic(arb_t y0, arb_t tau0, const struct cor_exponents *law, slong prec)
{
    LOCAL(fmpq, p);
    EXACT(p, "1/(law->a + 1)", law);
    LET(y0, prec, "((law->a + 1)/2)^p", law, p);
    /* B(p, 1/2) = Gamma(p) sqrt(pi) / Gamma(p + 1/2) */
    LET(tau0, prec, "gamma(p)/gamma(p + 1/2)*sqrt(pi)*p*y0", p, y0);
}

/* Computes the Taylor coefficients of x at t0 as polynomials in beta: jet[m] = sum_k x_k^(m)(t0)/m! beta^k for
 * m < count, k + m <= order + 1. Returns true if the truncation limits their accuracy. */
static bool jets_at(arb_poly_struct *jet, slong count, const struct trajectory *t, const struct trajectory_tail *tail,
                    const arb_t t0, slong prec)
{
    const slong d = t->law.denominator, du = t->law.damping + d, ds = t->law.elastic + d;
    const slong shift = t->shift;
    LOCAL_VECTOR(term, t->terms + 1);
    LOCAL(arb, s0, u0, power, sum, scale, inverse);
    LOCAL(mag, missing);
    slong truncated = 0, rounded = 0;
    LET(s0, prec, "t0^(t->law.a + 1)/2^shift", t0, &t->law, shift);
    LET(u0, prec, "t0^(t->law.b + 1)", t0, &t->law);
    arb_inv(inverse, t0, prec);

    for (slong k = 0; k <= t->order; k++) {
        progress("turning point", k, t->order);
        /* term_j = c_kj t0^(e+1) (e+1) e (e-1) ... d^m, with one more factor for each m */
        arb_pow_ui(power, u0, (ulong)k, prec);
        arb_mul(power, power, t0, prec);
        for (slong j = 0; j <= t->terms; j++) {
            arb_poly_get_coeff_arb(term + j, t->x + k, j);
            arb_mul(term + j, term + j, power, prec);
            arb_mul(power, power, s0, prec);
        }
        arb_one(scale);
        for (slong m = 0; m < count && m + k <= t->order + 1; m++) {
            arb_zero(sum);
            for (slong j = 0; j <= t->terms; j++)
                arb_add(sum, sum, term + j, prec);
            arb_mul(sum, sum, scale, prec);
            trajectory_tail_jet(missing, tail, t, k, m, t0);
            if (mag_cmp(missing, arb_radref(sum)) > 0)
                truncated++;
            else
                rounded++;
            arb_add_error_mag(sum, missing);
            arb_poly_set_coeff_arb(jet + m, k, sum);
            for (slong j = 0; j <= t->terms; j++)
                arb_mul_si(term + j, term + j, k * du + j * ds + d - m * d, prec);
            arb_div_si(scale, scale, d * (m + 1), prec);
            arb_mul(scale, scale, inverse, prec);
        }
    }

    return truncated > rounded;
}

enum turning_point_verdict turning_point_series(arb_poly_t y, arb_poly_t tau, slong order, slong terms,
                                                const struct cor_exponents *law, slong bits, slong prec)
{
    enum turning_point_verdict verdict = TURNING_POINT_FEW_TERMS;
    const slong count = order + 2;
    LOCAL(trajectory_tail, tail);
    LOCAL(arb, y0, t0);
    turning_point_elastic(y0, t0, law, prec);
    profile_step("trajectory");
    LOCAL_INIT(trajectory, t, (&t, order, terms, law, prec));
    profile_step("truncation bound");

    if (trajectory_tail_prove(tail, &t, t0)) {
        arb_poly_struct *jet = jet_new(count), *velocity = jet_new(count - 1);
        profile_step("Taylor coefficients at t_0");
        const bool truncated = jets_at(jet, count, &t, tail, t0, prec);
        profile_step("turning point");
        jet_derivative(velocity, jet, count, prec);
        jet_solve(tau, velocity, count - 1, order + 1, prec);
        jet_compose(y, jet, count, tau, order + 1, prec);
        arb_poly_set_coeff_arb(tau, 0, t0);
        arb_poly_set_coeff_arb(y, 0, y0);
        verdict = TURNING_POINT_OK;
        for (slong k = 0; k <= order; k++) {
            LOCAL(arb, c);
            arb_poly_get_coeff_arb(c, y, k);
            slong reached = arb_rel_accuracy_bits(c);
            arb_poly_get_coeff_arb(c, tau, k);
            reached = FLINT_MIN(reached, arb_rel_accuracy_bits(c));
            if (reached < bits) {
                verdict = truncated ? TURNING_POINT_FEW_TERMS : TURNING_POINT_FEW_BITS;
                break;
            }
        }
        jet_free(jet, count);
        jet_free(velocity, count - 1);
    }
    return verdict;
}
