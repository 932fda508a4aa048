/* SPDX-License-Identifier: MIT */
/* The loop that repeats a computation with more bits until its results are good enough:
 *
 *     struct precision p = precision_start(digits);
 *     do compute with p.bits; while (some number is undecided && precision_raise(&p)); */
#ifndef COR_GEN_SUPPORT_PRECISION_H
#define COR_GEN_SUPPORT_PRECISION_H

#include <stdbool.h>

#include "support/flint.h"

struct precision {
    slong bits, step, limit;
};

/* Start for decimal digits, with steps of 32, 64, 128, ... bits up to three times the bits of the digits plus 512. A
 * number that is undecided there must be zero or a tie, which interval (ball) arithmetic cannot exclude. */
struct precision precision_start(slong digits);

/* Start from `bits` bits, which double with each attempt, for `attempts` attempts in all. */
struct precision precision_doubling(slong bits, int attempts);

/* Start from `bits` bits, which double as long as they do not exceed `limit`. */
struct precision precision_doubling_to(slong bits, slong limit);

/* Raises the number of bits. Returns false at the limit. */
bool precision_raise(struct precision *p);

/* Reports on stderr that the digits of `what` were not decided. Returns STATUS_FAILED. */
int precision_spent(const struct precision *p, const char *what, slong digits);

#endif
