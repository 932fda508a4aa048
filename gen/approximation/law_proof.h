/* SPDX-License-Identifier: MIT */
/* Proofs that the polynomials of any law's interpolant are close to eps (docs/theory.md, 9): ellipse_bound_of_law
 * bounds eps in an ellipse around an interval, and row_proof.h the error of the polynomial. Intervals whose ellipses
 * cannot be covered have no proof: those of zero force near beta = 0, and those where eps is tiny. */
#ifndef COR_GEN_APPROXIMATION_LAW_PROOF_H
#define COR_GEN_APPROXIMATION_LAW_PROOF_H

#include "approximation/interpolant.h"

struct law_proof {
    const struct interpolant *f;
    enum quantity eps;
    double *error; /* bound of |polynomial - stored number| on each interval, infinite without a proof */
};

/* Proves the intervals of eps, of one end, that meet beta_min to beta_max, with errors below `wanted` if possible. The
 * ellipses are as small as that allows. Returns NULL after a message if a polynomial is shown to be wrong. */
struct law_proof *law_proof_new(const struct interpolant *f, enum quantity eps, double beta_min, double beta_max,
                                double wanted);
void law_proof_free(struct law_proof *proof);

/* The proved interval that contains u = ln(beta), to 1e-12, and reaches farthest, up to *end; -1 if there is none */
int law_proof_interval(double *end, const struct law_proof *proof, double u);

/* eps for lo <= ln(beta) <= hi in interval i, and ln(beta), as functions of t (enclosed_function.h). Returns false
 * where there is no proof. */
bool law_proof_eps(arb_poly_t eps, arb_poly_t log_beta, const struct law_proof *proof, int i, double lo, double hi);

#endif
