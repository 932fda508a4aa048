/* SPDX-License-Identifier: MIT */
/* Encloses functions of t, -1 <= t <= 1. A polynomial with intervals as coefficients represents a function if, at every
 * t, some numbers in the intervals give the function's value. The numbers may depend on t. Sums and products of such
 * polynomials represent sums and products. Terms of high degree, which the sum of their coefficients bounds, become
 * part of the constant term's radius. */
#ifndef COR_GEN_SUPPORT_ENCLOSED_FUNCTION_H
#define COR_GEN_SUPPORT_ENCLOSED_FUNCTION_H

#include <stdbool.h>

#include "support/formula.h"

enum { ENCLOSED_BITS = 160 };

/* LET_FUNCTION(y, "mu/sqrt(1 - x^2)", mu, x) is LET of formula.h for operands that may be functions. The operations are
 * + - * /, whole powers > 0, exp, log and sqrt. LET_FUNCTION returns false, and y is not finite, if an operation is not
 * proved to be defined. */
extern const struct formula_algebra enclosed_algebra;
#define LET_FUNCTION(y, ...) formula_function(y, &enclosed_algebra, FORMULA(__VA_ARGS__))

/* Moves negligible terms to the radius of the constant term. */
void enclosed_shorten(arb_poly_t p);

void enclosed_multiply(arb_poly_t z, const arb_poly_t x, const arb_poly_t y);
void enclosed_add_number(arb_poly_t p, const arb_t c);
void enclosed_add_double(arb_poly_t p, double c);
void enclosed_add_radius(arb_poly_t p, const arb_t radius);

/* Computes the interval of all values, by the sum of the coefficients. */
void enclosed_range(arb_t range, const arb_poly_t p);

/* Computes p(middle + half t). */
void enclosed_rescale(arb_poly_t y, const arb_poly_t p, const arb_t middle, const arb_t half, slong prec);

/* Computes the variable x itself as a function of t, on lo <= x <= hi. */
void enclosed_variable(arb_poly_t x, double lo, double hi);

/* Computes exp(p). The radius is small if p differs by less than 1 from its value at t = 0. Returns true. */
bool enclosed_exp(arb_poly_t y, const arb_poly_t p);

/* Computes the root of a positive function. Returns false if it is not proved to be positive. */
bool enclosed_square_root(arb_poly_t y, const arb_poly_t p);

/* Compute ln(p) and 1/p of a function that is positive at t = 0 and differs from p(0) by less than p(0)/2. Return false
 * for other functions. */
bool enclosed_logarithm(arb_poly_t y, const arb_poly_t p);
bool enclosed_inverse(arb_poly_t y, const arb_poly_t p);

/* Returns an approximate |f/g| at t. */
double enclosed_ratio_at(const arb_poly_t f, const arb_poly_t g, double t);

/* Bounds |f/g| from above. The bound is infinite if g may vanish. Halves the range, at most `halvings` times, until the
 * bound is near `known`, a value that the ratio reaches or that is small enough. */
double enclosed_largest_ratio(const arb_poly_t f, const arb_poly_t g, double known, int halvings);

#endif
