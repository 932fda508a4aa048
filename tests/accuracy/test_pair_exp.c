/* SPDX-License-Identifier: MIT */
/* pair_exp of runtime/disk/quasistatic.c against exp in interval (ball) arithmetic: the largest error, and the mean
 * error near the ends of its domain, where the series' last coefficient counts most. A double shows none of this. */
#include "runtime/disk/quasistatic.c"

#include "support/formula.h"
#include "support/local.h"

#include <stdio.h>

enum { POINTS = 4001, PREC = 256 };

/* |pair_exp(x)/exp(x) - 1| */
static double pair_exp_error(double x)
{
    const pair computed = pair_exp(x);
    LOCAL(arb, off);
    LET(off, PREC, "(computed.lo + computed.hi)*exp(-x) - 1", computed.lo, computed.hi, x);
    return fabs(arf_get_d(arb_midref(off), ARF_RND_UP));
}

int main(void)
{
    /* measured: 2^-101.85 and 2^-104.3, with a wrong sign in the last coefficient 2^-101.5 and 2^-102.4 */
    const double bound = 0x1p-101, end_bound = 0x1p-103;
    double worst = 0, at = 0, end = 0;
    for (int i = 0; i < POINTS; i++) {
        const double x = nextafter(2, 0) * (2.0 * i / (POINTS - 1) - 1), error = pair_exp_error(x);
        if (fabs(x) >= 1.9)
            end += error / ((double)POINTS / 20.0);
        if (!(error <= worst)) {
            worst = error;
            at = x;
        }
    }
    printf("pair_exp: 2^%.2f at %.17g, mean of |x| > 1.9 2^%.2f, %d points\n", log2(worst), at, log2(end), POINTS);
    flint_cleanup();
    return !(worst <= bound && end <= end_bound);
}
