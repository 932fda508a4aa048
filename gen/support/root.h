/* SPDX-License-Identifier: MIT */
/* Root finders for balls: both find where a function falls through zero. */
#ifndef COR_GEN_SUPPORT_ROOT_H
#define COR_GEN_SUPPORT_ROOT_H

#include "support/local.h"

/* The Illinois method, with f_low > 0 at `low` and f_high < 0 at `high`. Only midpoints count, so the caller must prove
 * the result. It converges as struct cor_bracket (runtime/number/root.h) does, until the rounding errors of f hide its
 * sign. */
struct bracket {
    arb_t low, high, f_low, f_high;
    int side; /* side of the last guess */
};
void bracket_init(struct bracket *b);
void bracket_clear(struct bracket *b);
LOCAL_STRUCT(bracket)
void bracket_guess(arb_t x, const struct bracket *b, slong prec);
void bracket_shrink(struct bracket *b, const arb_t x, const arb_t f); /* x: the guess; f: the function there */

/* Sets low and high to the exact midpoints of x (1 - 2^exponent) and x (1 + 2^exponent). */
void arb_around(arb_t low, arb_t high, const arb_t x, slong exponent, slong prec);

/* Computes a falling function at x to prec bits. Returns false if it fails. */
typedef bool falling_function(arb_t f, const arb_t x, const void *context, slong prec);

/* Encloses the root in the interval x (1 -+ 2^-bits). The given x > 0 is the start value. The signs of f at both ends
 * prove the root. Until they do, the line through f at these ends gives the next x. Near a simple root a step squares
 * the relative error of x, as in Newton's method, if f has more than `bits` correct bits. Returns false if f fails, or
 * if 60 steps give no proof. */
bool root_near(arb_t x, falling_function *f, const void *context, slong bits, slong prec);

#endif
