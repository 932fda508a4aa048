/* SPDX-License-Identifier: MIT */
/* Finds the root of a function of one double between two ends, by halving or by the Illinois method */
#ifndef COR_RUNTIME_NUMBER_ROOT_H
#define COR_RUNTIME_NUMBER_ROOT_H

#include "runtime/number/inline.h"

/* Sets *middle between two ends. Returns 0 if no double is between them. After each call the caller sets one end to the
 * middle, which halves the interval. At most 1076 + 53 calls are needed for ends of one sign, and about 53 calls if the
 * ends are within a factor of two. */
COR_INLINE int cor_halve(double *middle, double low, double high)
{
    *middle = low + (high - low) / 2;
    return *middle > low && *middle < high;
}

/* State of the Illinois method for a decreasing function; initially all 0. Once the values at the two ends differ in
 * sign, the ends always enclose the root. Near a simple root each value raises the error to the power 1.44. */
struct cor_bracket {
    double low, high, above, below, last;
};

COR_INLINE int cor_is_bracketed(const struct cor_bracket *b)
{
    return b->above > 0 && b->below < 0;
}

/* Stores the value at x. Returns the next place, or `otherwise` while all values have one sign. */
COR_INLINE double cor_next_place(struct cor_bracket *b, double x, double value, double otherwise)
{
    if (value > 0) {
        b->below *= b->last > 0 ? 0.5 : 1;
        b->low = x;
        b->above = value;
    } else {
        b->above *= b->last < 0 ? 0.5 : 1;
        b->high = x;
        b->below = value;
    }
    b->last = value;
    return cor_is_bracketed(b) ? (b->low * b->below - b->high * b->above) / (b->below - b->above) : otherwise;
}

#endif
