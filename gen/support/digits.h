/* SPDX-License-Identifier: MIT */
/* Proved decimal digits: an interval is printed only if both of its ends round to the same string. */
#ifndef COR_GEN_SUPPORT_DIGITS_H
#define COR_GEN_SUPPORT_DIGITS_H

#include <stdbool.h>

#include "support/flint.h"

/* Returns the value of x correctly rounded to `digits` significant decimal digits, as a malloc'ed string
 * ("1.0933620739", "-5.04e-12", "0" for an exact zero, "inf" for a midpoint at infinity). Returns NULL if the interval
 * is too wide to decide the digits. */
char *digits_of_ball(const arb_t x, slong digits);

/* Returns the working precision in bits for `digits` decimal digits, with guard bits. */
slong digits_to_bits(slong digits);

/* Sets *y to the correctly rounded double of an interval, subnormals included. Returns 0 and leaves *y unchanged if the
 * interval contains a rounding boundary or zero, or if the double would not be finite. */
int digits_to_double(double *y, const arb_t x);

/* The loop that repeats a computation with more bits until its results are good enough:
 *
 *     struct precision p = precision_start(digits);
 *     do compute with p.bits; while (some number is undecided && precision_raise(&p)); */
struct precision {
    slong bits, step, limit;
};

/* Starts a loop with b = digits_to_bits(digits) bits. It adds 32, 64, 128, ... bits until 3 b + 512 are reached. A
 * number that is still undecided must be zero or a tie, which interval (ball) arithmetic cannot exclude. */
struct precision precision_start(slong digits);

/* Starts a loop from `bits` bits, which double up to `limit` at most. */
struct precision precision_doubling(slong bits, slong limit);

/* Raises the number of bits. Returns false at the limit. */
bool precision_raise(struct precision *p);

/* Reports on stderr that the digits of `what` were not decided. Returns STATUS_FAILED. */
int precision_spent(const struct precision *p, const char *what, slong digits);

#endif
