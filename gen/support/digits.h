/* SPDX-License-Identifier: MIT */
/* Decimal digits that are proved: a ball is printed only if both its ends round to the same string.
 */
#ifndef COR_GEN_SUPPORT_DIGITS_H
#define COR_GEN_SUPPORT_DIGITS_H

#include <stdbool.h>

#include "support/flint.h"

/* The value of x correctly rounded to `digits` significant decimal digits, as a malloc'ed string
 * ("1.0933620739", "-5.04e-12", "0" for an exact zero, "inf" for a midpoint at infinity), or
 * NULL if the ball is too wide to tell. */
char *digits_of_ball(const arb_t x, slong digits);

/* Working precision in bits for so many digits, with guard bits. */
slong digits_to_bits(slong digits);

/* Correctly rounded double of a ball, subnormals included; returns 0 and leaves *y alone if the
 * ball straddles a rounding boundary or zero, or the double would not be finite. */
int digits_to_double(double *y, const arb_t x);

/* The loop that ends when every number asked for is decided:
 *
 *   struct precision p = precision_start(digits);
 *   do compute with p.bits; while (some number is undecided && precision_raise(&p)); */
struct precision {
    slong bits, step, limit;
};

struct precision precision_start(slong digits);

/* More bits, or false: so many have not decided it that it must be zero or a tie, which no ball
 * excludes. */
bool precision_raise(struct precision *p);

/* Says so of `what` on stderr; STATUS_FAILED. */
int precision_spent(const struct precision *p, const char *what, slong digits);

#endif
