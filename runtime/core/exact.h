/* SPDX-License-Identifier: MIT */
/* Arithmetic that keeps what rounding loses. Numbers are cut in two by masking bits, never by Veltkamp's trick, so
 * that the results stay right where a compiler fuses multiplications with additions. */
#ifndef COR_RUNTIME_EXACT_H
#define COR_RUNTIME_EXACT_H

#include "runtime/core/inline.h"

/* Powers of two; hexadecimal constants would be C++17. */
#define COR_INLINE_2_M900 1.18305218616677471e-271
#define COR_INLINE_2_M500 3.05493636349960468e-151
#define COR_INLINE_2_M200 6.22301527786114171e-61
#define COR_INLINE_2_M52 2.22044604925031308e-16
#define COR_INLINE_2_M56 1.38777878078144568e-17
#define COR_INLINE_2_M40 9.09494701772928238e-13
#define COR_INLINE_2_40 1.09951162777600000e+12
#define COR_INLINE_2_100 1.26765060022822940e+30
#define COR_INLINE_2_200 1.60693804425899028e+60
#define COR_INLINE_2_250 1.80925139433306555e+75
#define COR_INLINE_2_300 2.03703597633448609e+90
#define COR_INLINE_2_500 3.27339060789614187e+150
#define COR_INLINE_2_900 8.45271249817064394e+270

COR_INLINE uint64_t cor_inline_bits(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

COR_INLINE double cor_inline_from_bits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* The 26 leading bits: products of two such numbers are exact. */
COR_INLINE double cor_inline_head(double x)
{
    return cor_inline_from_bits(cor_inline_bits(x) & UINT64_C(0xfffffffff8000000));
}

/* hi + lo, not added up; |lo| is of the order of hi's last place */
struct cor_inline_pair {
    double hi, lo;
};

COR_INLINE struct cor_inline_pair cor_inline_sum(double hi, double lo)
{
    struct cor_inline_pair sum;
    sum.hi = hi + lo;
    sum.lo = lo - (sum.hi - hi);
    return sum;
}

/* x y to 2^-104, where nothing underflows */
COR_INLINE struct cor_inline_pair cor_inline_product(double x, double y)
{
    const double xh = cor_inline_head(x), xl = x - xh, yh = cor_inline_head(y), yl = y - yh;
    struct cor_inline_pair product;
    product.hi = x * y;
    product.lo = ((xh * yh - product.hi) + xh * yl + xl * yh) + xl * yl;
    return product;
}

COR_INLINE struct cor_inline_pair cor_inline_pair_times(struct cor_inline_pair x, struct cor_inline_pair y)
{
    const struct cor_inline_pair p = cor_inline_product(x.hi, y.hi);
    return cor_inline_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}

COR_INLINE struct cor_inline_pair cor_inline_pair_over(struct cor_inline_pair x, struct cor_inline_pair y)
{
    const double q = x.hi / y.hi;
    const struct cor_inline_pair p = cor_inline_product(q, y.hi);
    return cor_inline_sum(q, (((x.hi - p.hi) - p.lo) + (x.lo - q * y.lo)) / y.hi);
}

#endif
