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

#endif
