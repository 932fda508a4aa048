/* SPDX-License-Identifier: MIT */
#include "fit/likelihood.h"

#include <math.h>

#include "support/flint.h"
#include "support/local.h"

enum { PRECISION = 256, MANY = 10000, MAX_STEPS = 60 };

static const double level_probability[] = {[LEVEL_68] = 0.68268949213708590, [LEVEL_95] = 0.95};

double normal_quantile(enum distribution_level level)
{
    return level == LEVEL_68 ? 1 : 1.9599639845400542;
}

/* The regularised incomplete beta function I_x(a, b), x = part/(part + rest) */
static double incomplete_beta(double a, double b, double part, double rest)
{
    LOCAL(arb, x, first, second);
    arb_set_d(x, part);
    arb_set_d(second, rest);
    arb_add(second, second, x, PRECISION);
    arb_div(x, x, second, PRECISION);
    arb_set_d(first, a);
    arb_set_d(second, b);
    arb_hypgeom_beta_lower(x, first, second, x, 1, PRECISION);
    return ball_middle(x);
}

/* Newton's method from the normal quantile, which is smaller. P(|T| < t) is concave in t > 0, so that the steps ascend.
 */
double student_quantile(enum distribution_level level, size_t degrees_of_freedom)
{
    const double n = (double)degrees_of_freedom;
    const double pi = 3.14159265358979323846,
                 density = exp(lgamma((n + 1) / 2) - lgamma(n / 2)) / sqrt(n * pi); /* at 0 */
    double t = normal_quantile(level);
    for (int i = 0; i < MAX_STEPS; i++) {
        /* P(|T| < t) = I_x(1/2, n/2), x = t^2/(n + t^2) */
        const double missing = level_probability[level] - incomplete_beta(0.5, n / 2, t * t, n);
        t += missing / (2 * density * exp(-(n + 1) / 2 * log1p(t * t / n)));
        if (fabs(missing) < 1e-13)
            break;
    }
    return t;
}

/* The regularised incomplete gamma function Q(nu/2, chi2/2) */
double chi_squared_tail(double chi2, size_t degrees_of_freedom)
{
    if (!(chi2 > 0))
        return 1;
    LOCAL(arb, shape, x);
    arb_set_d(shape, (double)degrees_of_freedom / 2);
    arb_set_d(x, chi2 / 2);
    arb_hypgeom_gamma_upper(x, shape, x, 1, PRECISION);
    return ball_middle(x);
}

/* I_x(d2/2, d1/2), x = d2/(d2 + d1 f) */
double fisher_tail(double f, size_t numerator, size_t denominator)
{
    if (!(f > 0))
        return 1;
    if (denominator > MANY)
        return chi_squared_tail(f * (double)numerator, numerator);
    const double d1 = (double)numerator, d2 = (double)denominator;
    return incomplete_beta(d2 / 2, d1 / 2, d2, d1 * f);
}
