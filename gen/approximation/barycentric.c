/* SPDX-License-Identifier: MIT */
#include "approximation/barycentric.h"

#include <math.h>

#include "support/local.h"

double chebyshev_point(slong j, slong n)
{
    return -cos((2.0 * (double)j + 1) * acos(-1.0) / (2.0 * (double)n));
}

void barycentric_weights(arb_ptr weight, arb_srcptr node, slong n, slong prec)
{
    LOCAL(arb, d);
    for (slong j = 0; j < n; j++) {
        arb_one(weight + j);
        for (slong k = 0; k < n; k++) {
            if (k == j)
                continue;
            arb_sub(d, node + j, node + k, prec);
            arb_mul(weight + j, weight + j, d, prec);
        }
        arb_inv(weight + j, weight + j, prec);
    }
}

void barycentric_value(arb_t y, arb_srcptr node, arb_srcptr weight, arb_srcptr value, slong n, const arb_t x,
                       slong prec)
{
    LOCAL(arb, d, sum, total);
    for (slong j = 0; j < n; j++) {
        arb_sub(d, x, node + j, prec);
        if (arb_is_zero(d)) {
            arb_set(y, value + j);
            return;
        }
        arb_div(d, weight + j, d, prec);
        arb_add(total, total, d, prec);
        arb_addmul(sum, d, value + j, prec);
    }
    arb_div(y, sum, total, prec);
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
