/* SPDX-License-Identifier: MIT */
/* Oblique impacts without slip: u'/u = cos(pi D)/cos(pi E) with D = sqrt((a - 1)^2 + 8 (a + 1) kappa)/(2 (a + 1)) and
 * E = (a - 1)/(2 (a + 1)).
 *
 * With the whole number n below D, cos(pi D) is -(-1)^n sin(pi d) for d = D - n - 1/2. Near a zero of the cosine all
 * digits of D may cancel. Therefore d is computed from a polynomial of kappa and a with integer coefficients:
 *
 *     d = P/((a + 1)^2 (D + n + 1/2)),   P = (a + 1) Q - a,   Q = 2 kappa - n (n + 1) (a + 1)
 *
 * The 25 terms of P are exact as doubles. Five passes and a sum add them (Ogita, Rump and Oishi, SIAM J. Sci. Comput.
 * 26, 1955 (2005), SumK with K = 6). The error is at most 2^-95 of P plus 2^-284 of the sum of the terms' absolute
 * values, which is below 2^36. Next to a zero, kappa >= 2^-28 and a >= 2^-20 are multiples of 2^-81 and 2^-73, so P is
 * 0 or at least 2^-154; elsewhere it is larger. The rest uses pairs with errors below 2^-90, and rounds once. */
#include "runtime/law/damping_ratio.h"
#include "runtime/law/functions.h"

enum { PRODUCT_TERMS = 5, Q_TERMS = 4, P_TERMS = Q_TERMS * (PRODUCT_TERMS + 1) + 1, SUM_PASSES = 5, SINE_TERMS = 14 };

/* Sets the terms of x y exactly, if nothing underflows: heads have 26 bits, tails 27. */
static void tangential_product(double term[PRODUCT_TERMS], double x, double y)
{
    const double xh = cor_inline_head(x), xl = x - xh, yh = cor_inline_head(y), yl = y - yh;
    const double ylh = cor_inline_head(yl);
    term[0] = xh * yh;
    term[1] = xh * yl;
    term[2] = xl * yh;
    term[3] = xl * ylh;
    term[4] = xl * (yl - ylh);
}

/* Returns the sum of the terms. Each pass turns the terms into partial sums and rounding errors, whose total is exactly
 * the same. */
static struct cor_inline_pair tangential_sum(double *term, int count)
{
    double rest = 0;
    for (int pass = 0; pass < SUM_PASSES; pass++)
        for (int i = 1; i < count; i++) {
            const struct cor_inline_pair sum = cor_pair_two_sum(term[i], term[i - 1]);
            term[i] = sum.hi;
            term[i - 1] = sum.lo;
        }
    for (int i = 0; i + 1 < count; i++)
        rest += term[i];
    return cor_pair_two_sum(term[count - 1], rest);
}

/* Returns P for m = n (n + 1), an integer below 2^21. */
static struct cor_inline_pair tangential_polynomial(double kappa, double a, double m)
{
    const double head = cor_inline_head(a);
    const double q[Q_TERMS] = {2 * kappa, -m, -m * head, -m * (a - head)};
    double term[P_TERMS];
    for (int i = 0; i < Q_TERMS; i++) {
        term[i] = q[i];
        tangential_product(term + Q_TERMS + PRODUCT_TERMS * i, q[i], a);
    }
    term[P_TERMS - 1] = -a;
    return tangential_sum(term, P_TERMS);
}

/* Returns sin(pi t), |t| <= 1/2, by its series. */
static struct cor_inline_pair tangential_sine(struct cor_inline_pair t)
{
    const struct cor_inline_pair one = cor_pair(1, 0);
    const struct cor_inline_pair x = cor_inline_pair_times(t, cor_pair(COR_PI, COR_PI_TAIL));
    const struct cor_inline_pair minus_square = cor_inline_pair_times(cor_pair(-x.hi, -x.lo), x);
    struct cor_inline_pair sum = one;
    for (int k = SINE_TERMS; k > 0; k--) {
        const double divisor = 2 * k * (2 * k + 1);
        sum = cor_pair_over(cor_inline_pair_times(minus_square, sum), cor_pair(divisor, 0));
        sum = cor_pair_plus(one, sum);
    }
    return cor_inline_pair_times(x, sum);
}

static double tangential_no_slip(double kappa, double elastic_exponent)
{
    const double a = elastic_exponent;
    if (!(kappa >= 0 && kappa <= COR_NO_SLIP_MAX_KAPPA && a >= COR_NO_SLIP_MIN_EXPONENT &&
          a <= COR_NO_SLIP_MAX_EXPONENT))
        return NAN;
    const struct cor_inline_pair plus = cor_pair_two_sum(1, a), square = cor_inline_pair_times(plus, plus);
    const int n = (int)(sqrt((a - 1) * (a - 1) + 8 * plus.hi * kappa) / (2 * plus.hi));
    const double half = n + 0.5;
    const struct cor_inline_pair share = cor_pair_over(tangential_polynomial(kappa, a, (double)n * (n + 1)), square);
    /* The cosine depends on the square of D. For D below 2^-50 it is 1 to 2^-98, so D may be 0. */
    const struct cor_inline_pair d2 = cor_pair_plus(cor_pair(half * half, 0), share);
    const struct cor_inline_pair d = d2.hi > COR_INLINE_2_M60 * COR_INLINE_2_M40 ? cor_pair_root(d2) : cor_pair(0, 0);
    const struct cor_inline_pair rest = cor_pair_over(share, cor_pair_plus(cor_pair(half, 0), d));
    /* cos(pi E) = sin(pi min(a, 1)/(a + 1)) */
    const struct cor_inline_pair elastic = cor_pair_over(cor_pair(a < 1 ? a : 1, 0), plus);
    const double ratio = cor_pair_over(tangential_sine(rest), tangential_sine(elastic)).hi;
    return n % 2 == 0 ? 0 - ratio : 0 + ratio;
}

double cor_tangential_no_slip(double kappa, double elastic_exponent)
{
    return law_value_of_exponent(tangential_no_slip, kappa, elastic_exponent);
}

void cor_tangential_no_slip_array(const double *kappa, double elastic_exponent, double *y, size_t n)
{
    law_array_of_exponent(tangential_no_slip, kappa, elastic_exponent, y, n);
}
