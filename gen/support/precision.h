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

/* For decimal digits: steps of 32, 64, 128, ... bits. Where three times the bits of the digits and 512 more have not
 * decided a number, it must be zero or a tie, which no interval (ball) arithmetic excludes. */
struct precision precision_start(slong digits);

/* From so many bits, doubled each time: so many attempts in all. */
struct precision precision_doubling(slong bits, int attempts);

/* From so many bits, doubled as long as that is no more than `limit`. */
struct precision precision_doubling_to(slong bits, slong limit);

/* More bits, or false at the limit. */
bool precision_raise(struct precision *p);

/* Says on stderr that the digits of `what` were not decided; STATUS_FAILED. */
int precision_spent(const struct precision *p, const char *what, slong digits);

#endif
