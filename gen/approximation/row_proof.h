/* SPDX-License-Identifier: MIT */
/* Proofs that rows of the sphere's tables are close to the functions, everywhere in their cells (docs/theory.md, 8).
 *
 * The interpolant of an interval is within `error` of the function. ellipse_bound.h bounds the function in an ellipse
 * around the interval. This bounds its distance to the best polynomial, and the interpolant is nearly as close. On a
 * cell, row and interpolant become polynomials of one variable, and intervals enclose their difference. */
#ifndef COR_GEN_APPROXIMATION_ROW_PROOF_H
#define COR_GEN_APPROXIMATION_ROW_PROOF_H

#include "approximation/ellipse_bound.h"
#include "approximation/pieces.h"
#include "enclosure/creep_series.h"

/* Bounds the error of the interpolant of interval i from a bound of the function in an ellipse. Returns 0, or 1 after
 * reporting that the polynomial contradicts the bound, because a sample is wrong. */
int interpolant_error(double *error, const struct interpolant *f, int i, enum quantity quantity,
                      const struct ellipse_bound *bound);

/* Computes the interpolant of interval i with its error for lo <= x <= hi, as a function of t (enclosed_function.h). */
void interpolant_on(arb_poly_t y, const struct interpolant *f, int i, enum quantity quantity, double error, double lo,
                    double hi);

struct interpolant_proof {
    const struct interpolant *f;
    double (*error)[QUANTITIES]; /* bound of |polynomial - stored number| on each interval; infinite without a proof */
    struct creep_series creep;
    arb_t creep_constant; /* C of creep_series.h */
};

/* The source of the bounds on ellipses: proved again, which takes seconds, or used as stated */
enum ellipse_source { ELLIPSES_PROVED, ELLIPSES_STATED };

/* Proves the error of the polynomials of an interpolant with the layout interpolant_sphere_proof, for a set of
 * quantities, except the ones that ellipse_bound_set excludes. Returns NULL after reporting on stderr the part that
 * could not be proved. */
struct interpolant_proof *interpolant_proof_new(const struct interpolant *f, unsigned quantities,
                                                enum ellipse_source source);
void interpolant_proof_free(struct interpolant_proof *proof);

/* Computes the interval's variable x, beta and eps at one end for lo <= x <= hi in interval i, as functions of t
 * (enclosed_function.h). Computes eps only if its error is finite. The error of the interpolant is included. */
void interpolant_proof_eps(arb_poly_t eps, arb_poly_t beta, arb_poly_t x, const struct interpolant_proof *proof, int i,
                           enum quantity quantity, double lo, double hi);

/* Computes duration/beta at zero overlap as a function of t from eps beta^(5/3) and duration beta^(2/3) at zero force,
 * u = ln(beta) and mu = beta^(-5/3). duration/beta is the time of zero force plus the creep 2 ln(Y) + C + a_1/Y + ...,
 * where Y = sqrt(eps beta^(5/3))/mu. Returns false if a function is not proved to be positive. */
bool interpolant_proof_creep(arb_poly_t duration, const struct interpolant_proof *proof, const arb_poly_t eps,
                             const arb_poly_t time, const arb_poly_t u, const arb_poly_t mu);

/* Returns -log2 of a proved bound of a row's relative error in its cell, or NaN without a proof. c: the p->degree + 2
 * columns of the row */
double row_proof_bits(const struct interpolant_proof *proof, const struct pieces *p, slong row, const double *c);

/* Proves all rows of p and replaces the sampled p->bits. Returns 0, or 1 after reporting a row that misses its
 * bound. */
int row_proof_table(struct pieces *p, const struct interpolant_proof *proof);

/* ---- far_proof.c: proofs that the formulas of the sphere's tables beyond their rows, in mu = beta^(-5/3) and
 * u = ln(beta), are close to the functions for every finite double (docs/theory.md, 8) ----
 *
 * On cells of u, the last of which are long, formula and function become polynomials of one variable. */

/* The formulas are proved from just below u = 10, their inverse from 9.7, where eps > 2^-23. Both proofs reach the
 * largest double. */
#define FAR_PROOF_FROM 9.99
#define FAR_PROOF_INVERSE_FROM 9.7
#define FAR_PROOF_TO 710.0

enum { FAR_PROOF_INTERVALS = 2 };

struct far_proof {
    struct interpolant_layout layout;
    struct interpolant *f;
    double error[FAR_PROOF_INTERVALS][QUANTITIES];
    const struct interpolant_proof *rows; /* the proof of the duration at zero overlap */
};

/* Encloses the functions up to beta_max, with interpolants through collisions and bounds on ellipses around the
 * intervals. `rows` contains a proof of the duration at zero overlap and must outlive the proof. Returns 0, or 1 after
 * reporting the failure. Call far_proof_clear in either case. */
int far_proof_init(struct far_proof *proof, const struct interpolant_proof *rows, double beta_max);
void far_proof_clear(struct far_proof *proof);

/* Computes the quantity without its power of beta on lo <= u <= hi, as a function of t (enclosed_function.h). Returns
 * false if it is not known there. */
bool far_proof_function(arb_poly_t y, const struct far_proof *proof, enum quantity quantity, double lo, double hi);

/* Returns -log2 of a proved bound of the relative error of a formula, or NaN without a proof. c: the columns of
 * law_tables_far_row or, for BETA_ZERO_FORCE, law_tables_far_inverse_row, as doubles. */
double far_proof_bits(const struct far_proof *proof, enum quantity quantity, const double *c);

/* ---- law_proof.c: proofs that the polynomials of any law's interpolant are close to eps (docs/theory.md, 9) ----
 *
 * ellipse_bound_of_law bounds eps in an ellipse around an interval. Intervals whose ellipses cannot be covered have no
 * proof: intervals of zero force near beta = 0, and intervals where eps is tiny. */

struct law_proof {
    const struct interpolant *f;
    enum quantity eps;
    double *error; /* bound of |polynomial - stored number| on each interval, infinite without a proof */
};

/* Proves the intervals of eps at one end that meet beta_min to beta_max, with errors below `wanted` if possible. The
 * ellipses are as small as `wanted` allows. Returns NULL after a message if a polynomial is proved to be wrong. */
struct law_proof *law_proof_new(const struct interpolant *f, enum quantity eps, double beta_min, double beta_max,
                                double wanted);
void law_proof_free(struct law_proof *proof);

/* Returns the proved interval that contains u = ln(beta) to within 1e-12. If there are several, returns the one that
 * ends last; if none, -1. *end: the end of the interval */
int law_proof_interval(double *end, const struct law_proof *proof, double u);

/* Computes eps for lo <= ln(beta) <= hi in interval i, and ln(beta), as functions of t (enclosed_function.h). Returns
 * false without a proof. */
bool law_proof_eps(arb_poly_t eps, arb_poly_t log_beta, const struct law_proof *proof, int i, double lo, double hi);

#endif
