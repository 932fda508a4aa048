/* SPDX-License-Identifier: MIT */
/* The lower real branch of Lambert's W, in the variable in which its branch point loses nothing:
 *
 *     W_-1(-exp(-1 - q)) = -(1 + t),     t - ln(1 + t) = q,     q, t >= 0
 *
 * t is a power series in sqrt(2 q) near 0 and about q + ln(q) far out; its relative error is at most that of q. */
#ifndef COR_RUNTIME_LAMBERT_W_H
#define COR_RUNTIME_LAMBERT_W_H

#include "runtime/core/exact.h"

/* t of q = hi + lo, not added up. Domain: 0 <= q <= 2^400. Relative error of t.hi + t.lo below 1.5 2^-52, of 1 + t
 * below 2^-53, sampled; NaN for q < 0 and NaN. */
struct cor_inline_pair cor_lambert_t_pair(struct cor_inline_pair q);

/* The same as one double, below 2 ulp */
double cor_lambert_t(double q);

/* W_-1(z), -1/e < z < 0, z taken as it is: error below 2 ulp, sampled. -0 and 0 -> -inf; outside, NaN -> NaN. */
double cor_lambert_w_minus1(double z);

/* The sum of any two numbers, exact */
COR_INLINE struct cor_inline_pair cor_inline_two_sum(double x, double y)
{
    struct cor_inline_pair sum;
    sum.hi = x + y;
    const double part = sum.hi - x;
    sum.lo = (x - (sum.hi - part)) + (y - part);
    return sum;
}

/* A number and its logarithm, each to 2^-104. */
struct cor_logarithm {
    struct cor_inline_pair number, log;
};

/* ln(a/x), 0 < x, from ln(a), to 2^-54 absolute and 2^-53 relative where it is large. */
struct cor_inline_pair cor_log_ratio_far(struct cor_inline_pair log_a, double x);
/* Below this value of the above, the one below is good. */
#define COR_LOG_RATIO_NEAR 0.5
/* ln(a/x) from a, to 2^-53 relative: x <= a, however close, and a < 2 x; NaN for x > a. */
struct cor_inline_pair cor_log_ratio_near(struct cor_inline_pair a, double x);

/* ln(a/x) by the one or the other, 0 < x <= a; NaN for x > a and NaN. */
struct cor_inline_pair cor_log_ratio(const struct cor_logarithm *a, double x);

#endif
