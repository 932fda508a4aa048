/* SPDX-License-Identifier: MIT */
/* The lower real branch of Lambert's W, in the variable q that loses no accuracy at the branch point:
 *
 *     W_-1(-exp(-1 - q)) = -(1 + t),     t - ln(1 + t) = q,     q, t >= 0
 *
 * t is a power series in sqrt(2 q) near 0 and about q + ln(q) for large q. A relative error of q causes at most the
 * same relative error of t. */
#ifndef COR_RUNTIME_LAMBERT_W_H
#define COR_RUNTIME_LAMBERT_W_H

#include "runtime/number/pair.h"

/* Returns t of the unevaluated sum q = hi + lo. Domain: 0 <= q <= 2^400; q < 0 and NaN -> NaN. The relative error of
 * t.hi + t.lo is below 1.5 2^-52, and the relative error of 1 + t is below 2^-53. Both bounds are proved for q <= 2000
 * by tests/proof/run if log is within 0.55 ulp (docs/theory.md, 18), and sampled beyond. */
struct cor_inline_pair cor_lambert_t_pair(struct cor_inline_pair q);

/* Returns t as one double, with an error below 2 ulp: proved and sampled as above. */
double cor_lambert_t(double q);

/* A number and its logarithm, each with relative error 2^-104. */
struct cor_logarithm {
    struct cor_inline_pair number, log;
};

/* Returns ln(a/x) from ln(a) for 0 < x. The absolute error is 2^-54 (1 + 2^-20) if log is within 1 ulp (proved). */
struct cor_inline_pair cor_log_ratio_far(struct cor_inline_pair log_a, double x);
/* Returns the same sum as two numbers that are not normalised: |lo| may exceed half an ulp of hi. */
struct cor_inline_pair cor_log_ratio_parts(struct cor_inline_pair log_a, double x);
/* Below this result, cor_log_ratio_near is the more accurate function. */
#define COR_LOG_RATIO_NEAR 0.5
/* Returns ln(a/x) from a for x <= a < 2 x, where x may be arbitrarily close to a. The relative error is 1.5 2^-52 if
 * log1p is within 1 ulp (proved); NaN for x > a. */
struct cor_inline_pair cor_log_ratio_near(struct cor_inline_pair a, double x);

/* Returns ln(a/x) by the more accurate of the two functions, for 0 < x <= a; NaN for x > a and NaN. */
struct cor_inline_pair cor_log_ratio(const struct cor_logarithm *a, double x);

#endif
