/* SPDX-License-Identifier: MIT */
#include "runtime/number/lambert_w.h"

#include "runtime/number/elementary.h"

/* Below this q the series applies. Above it the iteration loses at most two bits in the subtraction t - ln(1 + t). */
#define SERIES_END 0.1

/* t - p for p = sqrt(2 q) <= sqrt(0.2): the sum of a_n p^n for n >= 2, where t dt/dp = p (1 + t) gives
 *     a_1 = 1,     (n + 1) a_n = a_(n-1) - sum_(i=2)^(n-1) (n + 1 - i) a_i a_(n+1-i).
 * The series converges for p < sqrt(4 pi). The omitted terms are below 2^-57 p. */
static const double lambert_series[] = {1.0 / 3,
                                        1.0 / 36,
                                        -1.0 / 270,
                                        1.0 / 4320,
                                        1.0 / 17010,
                                        -139.0 / 5443200,
                                        1.0 / 204120,
                                        -571.0 / 2351462400,
                                        -281.0 / 1515591000,
                                        163879.0 / 2172751257600.0,
                                        -5221.0 / 354648294000.0,
                                        5246819.0 / 10168475885568000.0,
                                        5459.0 / 7447614174000.0,
                                        -534703531.0 / 1830325659402240000.0,
                                        91207079.0 / 1595278956070800000.0};

static double series_rest(double p)
{
    const double *const a = lambert_series;
    const double p2 = p * p, p4 = p2 * p2;
    const double low = ((a[0] + a[1] * p) + (a[2] + a[3] * p) * p2) + ((a[4] + a[5] * p) + (a[6] + a[7] * p) * p2) * p4;
    const double high = ((a[8] + a[9] * p) + (a[10] + a[11] * p) * p2) + ((a[12] + a[13] * p) + a[14] * p2) * p4;
    return p2 * (low + high * (p4 * p4));
}

/* Returns ln(x) from the bits, with an absolute error of 0.03. */
static double rough_log(double x)
{
    const double two52 = 4503599627370496.0;
    const double top = cor_inline_from_bits((cor_inline_bits(x) >> 32) | UINT64_C(0x4330000000000000)) - two52;
    return (top * (1 / 1048576.0) - (1023 - 0.043)) * COR_LN2;
}

/* Returns 1 + t with a relative error of 0.6 %; p = sqrt(2 q). */
static double start_of(double q, double p)
{
    return q < 3 ? 1 + p * (1 + p * (1.0 / 3 + p * (1.0 / 36 - p * (1.0 / 270)))) : 1 + q + rough_log(3 + q);
}

struct cor_inline_pair cor_lambert_t_pair(struct cor_inline_pair q)
{
    struct cor_inline_pair t = {NAN, 0};
    if (cor_inline_is_refused(q.hi))
        return t;
    const struct cor_inline_pair twice = cor_pair(2 * q.hi, 2 * q.lo);
    const double p = sqrt(twice.hi);
    if (q.hi < SERIES_END) {
        t.hi = p;
        if (q.hi < COR_INLINE_2_M500) { /* p^2 may underflow; q may be 0 */
            t.lo = q.hi * (2.0 / 3);
            return t;
        }
        t.lo = cor_pair_root_with(twice, p, 1 / p).lo + series_rest(p);
        return t;
    }
    /* y = 1 + t, and the next y is y (1 + e). With r = q - (t - ln(1 + t)), e solves t e + e - ln(1 + e) = r. The
     * fourth-order step of Fritsch, Shafer and Crowley (1973) reduces e from 0.6 % to 5e-12, and a step of Newton's
     * method then reduces it to 2^-78. y - 1 and, in two parts, q - t are exact. The rounding error is half an ulp of
     * ln(y). In t it is larger by the factor (1 + t)/t. */
    double y = start_of(q.hi, p);
    double u = y - 1;
    double r = (q.hi - u) + log(y);
    const double b = 2 * u * (u + r * (2.0 / 3));
    y += y * (r / u * ((b + r) / (b + 2 * r)));
    u = y - 1;
    const struct cor_inline_pair minus_log = cor_inline_sum(-u, q.hi);
    r = (minus_log.hi + log(y)) + (minus_log.lo + q.lo);
    t.hi = u;
    t.lo = y * (r / u);
    return t;
}

double cor_lambert_t(double q)
{
    struct cor_inline_pair parts;
    parts.hi = q;
    parts.lo = 0;
    const struct cor_inline_pair t = cor_lambert_t_pair(parts);
    return t.hi + t.lo;
}

struct cor_inline_pair cor_log_ratio_parts(struct cor_inline_pair log_a, double x)
{
    /* ln 2 in two parts; the first has 42 bits, so that its product with an exponent is exact */
    const double ln2 = 0.69314718055989033019, ln2_rest = 5.4979230187083711747e-14;
    const uint64_t bias = UINT64_C(1023) << 52, root_half = UINT64_C(0x3fe6a09e00000000);
    int exponent = -1023;
    if (x < COR_INLINE_2_M900) {
        x *= COR_INLINE_2_200;
        exponent -= 200;
    }
    /* x = m 2^exponent, sqrt(1/2) < m < sqrt(2) */
    const uint64_t bits = cor_inline_bits(x), power = (bits + (bias - root_half)) >> 52;
    exponent += (int)power;
    const double m = cor_inline_from_bits(bits - (power << 52) + bias);
    const struct cor_inline_pair large = cor_pair_two_sum(log_a.hi, -exponent * ln2),
                                 all = cor_pair_two_sum(large.hi, -log(m));
    return cor_pair(all.hi, all.lo + (large.lo + (log_a.lo - exponent * ln2_rest)));
}

struct cor_inline_pair cor_log_ratio_far(struct cor_inline_pair log_a, double x)
{
    const struct cor_inline_pair parts = cor_log_ratio_parts(log_a, x);
    return cor_inline_sum(parts.hi, parts.lo);
}

struct cor_inline_pair cor_log_ratio_near(struct cor_inline_pair a, double x)
{
    struct cor_inline_pair q;
    const double difference = (a.hi - x) + a.lo; /* one rounding: the first subtraction is exact */
    if (difference < 0) {
        q.hi = q.lo = NAN;
        return q;
    }
    const double d = difference / x;
    q.hi = log1p(d);
    q.lo = 0;
    if (d > COR_INLINE_2_M500) { /* remainder of the quotient */
        const struct cor_inline_pair back = cor_inline_product(d, x);
        q.lo = ((difference - back.hi) - back.lo) / (x + difference);
    }
    return q;
}

struct cor_inline_pair cor_log_ratio(const struct cor_logarithm *a, double x)
{
    const struct cor_inline_pair q = cor_log_ratio_far(a->log, x);
    return q.hi > COR_LOG_RATIO_NEAR ? q : cor_log_ratio_near(a->number, x);
}
