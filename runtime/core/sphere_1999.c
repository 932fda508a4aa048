/* SPDX-License-Identifier: MIT */
/* The approximations of 1999, as they were published. */
#include <math.h>

#include "cor/sphere.h"
#include "runtime/number/fifth_root.h"

double cor_sphere_eps_simple(double beta)
{
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    if (beta > COR_INLINE_2_900) /* eps decreases like beta^(-5/3) */
        return 0;
    const double c = -COR_SPHERE_C1 * beta;
    /* With y = eps^(1/5), (27) is f(y) = y^3 (y^2 + c) - 1 = 0, increasing and convex for y > 0. Both 1 and c^(-1/3)
     * are above the root, and from above Newton's method decreases to the root. It takes at most five steps (c near 1).
     * The sixth step removes the error of the first y. Every C library gives the same upper half of cbrt. */
    double y = c > 1 ? 1 / cor_inline_head(cbrt(c)) : 1;
    for (int i = 0; i < 6; i++) {
        const double y2 = y * y, y3 = y2 * y;
        y -= (y3 * (y2 + c) - 1) / (5 * y2 * y2 + 3 * c * y2);
    }
    /* If the difference loses no digits, it is more accurate than the power, which has five times the error of y. */
    const double y2 = y * y, gone = c * (y2 * y);
    return gone < 0.5 ? 1 - gone : y2 * y2 * y;
}

double cor_sphere_eps_simple_fraction(double beta, int depth)
{
    if (cor_inline_is_refused(beta) || depth < 0)
        return cor_inline_nan();
    /* For large beta, 1 is negligible compared with c = |C_1| beta, and t would overflow where 1/t is still a double. t
     * is therefore in units of 2^500 = (2^100)^5. */
    const int far = beta > COR_INLINE_2_500;
    const double one = far ? 0 : 1, factor = -COR_SPHERE_C1 * (far ? beta * COR_INLINE_2_M300 : beta);
    double t = far ? COR_INLINE_2_M500 : 1;
    for (int k = 0; k < depth; k++) {
        const double root = cor_inline_fifth_root(t), next = one + factor * (root * root);
        if (next == t) /* a fixed point: a greater depth gives the same value */
            break;
        t = next;
        if (far && t > COR_INLINE_2_600) /* each level increases t, so the quotient stays below 2^-1100 */
            return 0;
    }
    return far ? COR_INLINE_2_M500 / t : 1 / t;
}

double cor_sphere_eps_published_pade(double beta)
{
    static const double d1 = 2.5839, d2 = 3.5839, d3 = 2.9839, d4 = 1.1487, d5 = 0.3265;
    if (cor_inline_is_refused(beta))
        return cor_inline_nan();
    if (beta > COR_INLINE_2_900) /* eps decreases like beta^(-3) */
        return 0;
    const double s = -COR_SPHERE_C1 * beta;
    if (s <= 1)
        return (1 + d1 * s) / (1 + s * (d2 + s * (d3 + s * (d4 + s * d5))));
    /* the same quotient in r = 1/s, in which no power overflows */
    const double r = 1 / s;
    return r * r * r * ((d1 + r) / (d5 + r * (d4 + r * (d3 + r * (d2 + r)))));
}
