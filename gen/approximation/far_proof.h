/* SPDX-License-Identifier: MIT */
/* Proofs that the formulas of the sphere's tables beyond their rows, in mu = beta^(-5/3) and u = ln(beta), are close to
 * the functions for every finite double (docs/theory.md, 8). On cells of u, the last of which are long, formula and
 * function become polynomials of one variable. */
#ifndef COR_GEN_APPROXIMATION_FAR_PROOF_H
#define COR_GEN_APPROXIMATION_FAR_PROOF_H

#include "approximation/interpolant.h"
#include "approximation/row_proof.h"

/* The formulas are proved from just below u = 10 on, their inverse from 9.7 on, where eps > 2^-23; both up to the
 * largest double. */
#define FAR_PROOF_FROM 9.99
#define FAR_PROOF_INVERSE_FROM 9.7
#define FAR_PROOF_TO 710.0

enum { FAR_PROOF_INTERVALS = 2 };

struct far_proof {
    struct interpolant_layout layout;
    struct interpolant *f;
    double error[FAR_PROOF_INTERVALS][QUANTITIES];
    const struct interpolant_proof *rows; /* for the duration at zero overlap */
};

/* Encloses the functions up to beta_max, with interpolants through collisions and bounds on ellipses around them as
 * row_proof.h. `rows`, which must live as long as the proof, has a proof of the duration at zero overlap. Returns 0, or
 * 1 after reporting the failure. Call far_proof_clear in either case. */
int far_proof_init(struct far_proof *proof, const struct interpolant_proof *rows, double beta_max);
void far_proof_clear(struct far_proof *proof);

/* The quantity without its power of beta on lo <= u <= hi, as a function of t (enclosed_function.h). Returns false if
 * nothing is known of it there. */
bool far_proof_function(arb_poly_t y, const struct far_proof *proof, enum quantity quantity, double lo, double hi);

/* -log2 of a proved bound of the relative error of a formula, whose coefficients are the columns of law_tables_far_row
 * or, for BETA_ZERO_FORCE, law_tables_far_inverse_row, as doubles; NaN if there is no proof. */
double far_proof_bits(const struct far_proof *proof, enum quantity quantity, const double *c);

#endif
