/* SPDX-License-Identifier: MIT */
/* Proved decimal digits: an interval is printed only if both of its ends round to the same string.
 */
#ifndef COR_GEN_SUPPORT_DIGITS_H
#define COR_GEN_SUPPORT_DIGITS_H

#include <stdbool.h>

#include "support/flint.h"

/* The value of x correctly rounded to `digits` significant decimal digits, as a malloc'ed string ("1.0933620739",
 * "-5.04e-12", "0" for an exact zero, "inf" for a midpoint at infinity), or NULL if the interval is too wide to decide
 * the digits. */
char *digits_of_ball(const arb_t x, slong digits);

/* Working precision in bits for `digits` decimal digits, with guard bits. */
slong digits_to_bits(slong digits);

/* Sets *y to the correctly rounded double of an interval, subnormals included. Returns 0 and leaves *y unchanged if the
 * interval contains a rounding boundary or zero, or if the double would not be finite. */
int digits_to_double(double *y, const arb_t x);

#endif
