/* SPDX-License-Identifier: MIT */
#include "approximation/chebyshev.h"

#include <math.h>

#include "support/formula.h"
#include "support/local.h"

double chebyshev_point(slong j, slong n)
{
    return -cos((2.0 * (double)j + 1) * acos(-1.0) / (2.0 * (double)n));
}

void unit_place(arb_t t, const arb_t x, double lo, double hi, slong prec)
{
    LET(t, prec, "(2*x - lo - hi)/(hi - lo)", x, lo, hi);
}

bool sample_rounded(arb_t y, const arb_t x, slong bits)
{
    enum { ENOUGH_BITS = 320 };
    LOCAL(arf, lower, upper);
    arb_get_lbound_arf(lower, x, ENOUGH_BITS);
    arb_get_ubound_arf(upper, x, ENOUGH_BITS);
    arf_set_round(lower, lower, bits, ARF_RND_NEAR);
    arf_set_round(upper, upper, bits, ARF_RND_NEAR);
    const bool decided = arf_equal(lower, upper) && arf_is_finite(lower);
    if (decided)
        arb_set_arf(y, lower);
    return decided;
}
