/* SPDX-License-Identifier: MIT */
/* The lower real branch of Lambert's W, in the variable in which its branch point loses nothing:
 *
 *     W_-1(-exp(-1 - q)) = -(1 + t),     t - ln(1 + t) = q,     q, t >= 0
 *
 * t is a power series in sqrt(2 q) near 0 and about q + ln(q) far out; its relative error is at most that of q. */
#ifndef COR_RUNTIME_LAMBERT_W_H
#define COR_RUNTIME_LAMBERT_W_H

#include "exact.h"

/* t of q = hi + lo, not added up. Domain: 0 <= q <= 2^1000. Relative error of t.hi + t.lo below 1.5 2^-52, of 1 + t
 * below 2^-53, sampled; NaN for q < 0 and NaN. */
struct cor_inline_pair cor_lambert_t_pair(struct cor_inline_pair q);

/* The same as one double, below 2 ulp */
double cor_lambert_t(double q);

#endif
