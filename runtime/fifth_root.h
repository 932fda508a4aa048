/* SPDX-License-Identifier: MIT */
/* x^(1/5) over the whole range of a double. */
#ifndef COR_RUNTIME_FIFTH_ROOT_H
#define COR_RUNTIME_FIFTH_ROOT_H

#include <math.h>

/* x^(1/5) for x >= 0; 0, +inf and NaN are returned as they are. Error below one unit of the last
 * place where pow's is below 0.6. pow(x, 0.2) alone would be off by up to 36 units at the ends of
 * the range, because 0.2 is not a double: its error grows as |ln x| 1.1e-17. With a power of 32
 * taken out, which is exact, |ln| <= ln 32 and that costs a third of a unit. */
static inline double fifth_root(double x)
{
    if (!(x > 0) || isinf(x))
        return x;
    int exponent;
    const double fraction = frexp(x, &exponent);
    return ldexp(pow(ldexp(fraction, exponent % 5), 0.2), exponent / 5);
}

#endif
