/* SPDX-License-Identifier: MIT */
/* Computes sums of products X_i P_(k-i) of rows, which are power series in s:
 *
 *   S_k = p.den sum_{0<i<k} ((p+1) i - k) X_i P_(k-i).
 *
 * They give the next row of a power P = X^p of a trajectory (trajectory.c).
 *
 * Every row is a factor of many products. row_sums.c therefore transforms every row only once, modulo many primes. A
 * product then costs one multiplication per prime and point. The sums of the midpoints, cut to integers, are exact.
 * Sums of upper bounds bound the radii. */
#ifndef COR_GEN_SERIES_ROW_SUMS_H
#define COR_GEN_SERIES_ROW_SUMS_H

#include "series/law.h"

/* With fewer rows, products of polynomials are as fast. They preserve the relative accuracy of small coefficients,
 * which proofs for steep laws such as (24, 1/16) need. */
enum { ROW_SUMS_MIN_ROWS = 12 };

struct row_sums {
    struct ratio p;
    slong rows, length, prec;
    slong known;                /* rows 1..known-1 of both factors are stored */
    int depth;                  /* transforms have 2^depth points */
    int weight_bits;            /* weights and numbers of rows are below 2^weight_bits */
    slong primes;               /* number of primes in use */
    struct row_prime *mod;      /* the rows modulo one prime each */
    fmpz *integer[2];           /* the midpoints of the rows X_i and P_i in units of 2^(-prec - ROW_BITS i) */
    struct row_bound *bound[2]; /* bounds of these rows */
    slong row, exponent;        /* number of the current sum; exponent of the unit of `error` */
    double *error;
};

/* Returns ((p+1) i - k) p.den. */
slong row_sums_weight(struct ratio p, slong i, slong k);

/* Prepares sums up to s^(length-1) for k < rows. The midpoints of row i are cut after 2^(-prec - 2 i). */
void row_sums_init(struct row_sums *s, struct ratio p, slong rows, slong length, slong prec);

void row_sums_clear(struct row_sums *s);

/* Computes sum = S_k. Calls must have k = 1, 2, ... in this order. Call k reads rows 1..k-1 of x and power, which must
 * not change afterwards. */
void row_sums_next(arb_poly_struct *sum, struct row_sums *s, const arb_poly_struct *x, const arb_poly_struct *power,
                   slong k);

#endif
