/* SPDX-License-Identifier: MIT */
/* exp without a call, a jump or a table, for the loops of disk/rayleigh_kernel.c and disk/collision_kernel.c. */
#ifndef COR_RUNTIME_KERNEL_EXP_H
#define COR_RUNTIME_KERNEL_EXP_H

#include "runtime/number/kernel.h"

/* x + 1.5 2^52 - 1.5 2^52 is x rounded to an integer, |x| < 2^51. */
#define ROUND_TO_INTEGER 6755399441055744.0

/* exp(x) for |x| <= 700; the result is undefined beyond. Taylor's series on |r| <= ln(2)/2 with terms down to 2^-55. */
KERNEL double kernel_exp(double x)
{
    const double shifted = x * 1.4426950408889634 + ROUND_TO_INTEGER, k = shifted - ROUND_TO_INTEGER;
    const double r = (x - k * 0x1.62e42feep-1) - k * 0x1.a39ef35793c76p-33;
    const double p =
        1.0 / 5040 +
        r * (1.0 / 40320 +
             r * (1.0 / 362880 +
                  r * (1.0 / 3628800 + r * (1.0 / 39916800 + r * (1.0 / 479001600 + r * (1.0 / 6227020800))))));
    const double e =
        1 + (r + r * r * (0.5 + r * (1.0 / 6 + r * (1.0 / 24 + r * (1.0 / 120 + r * (1.0 / 720 + r * p))))));
    uint64_t bits;
    double scale;
    memcpy(&bits, &shifted, sizeof bits);
    bits = (bits + 1023) << 52; /* the last bits hold the integer */
    memcpy(&scale, &bits, sizeof scale);
    return e * scale;
}

#endif
