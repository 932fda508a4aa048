/* SPDX-License-Identifier: MIT */
/* Exact trajectory x(t) = t X, X = sum_{k,j} c[k][j] u^k s^j, u = beta t^(b+1), s = t^(a+1), (48), (49). */
#ifndef COR_GEN_SERIES_TRAJECTORY_H
#define COR_GEN_SERIES_TRAJECTORY_H

#include "series/law.h"

/* Computes rows k = 0..order, sum_j c[k][j] s^j, j = 0..terms. */
fmpq_poly_struct *trajectory_exact(slong order, slong terms, const struct cor_exponents *law);
void trajectory_exact_free(fmpq_poly_struct *row, slong rows);

/* The rows of trajectory_exact in interval (ball) arithmetic, and the rows of two powers of X, which the recurrence
 * also computes.
 *
 * The elastic constant of the solved law is 2^shift, about R^(a+1), where R is the radius of convergence. Row k is
 * therefore sum_j c[k][j] 2^(shift j) s^j with s = t^(a+1)/2^shift. Its coefficients have similar size. */
struct trajectory {
    struct cor_exponents law;
    slong order, terms, prec, shift;
    arb_poly_struct *x;       /* order + 1 rows of X */
    arb_poly_struct *x_to_a;  /* X^a */
    arb_poly_struct *x_to_b1; /* X^(b+1); the same pointer if b + 1 = a */
};

void trajectory_init(struct trajectory *t, slong order, slong terms, const struct cor_exponents *law, slong prec);
void trajectory_clear(struct trajectory *t);

/* A proved bound on the terms beyond s^terms (trajectory_tail.c), over the rows k = 0..order:
 *
 *   sum_k U^k sum_{j > terms} |row[k]_j| rho^j <= delta */
struct trajectory_tail {
    arb_t delta;
    double U, rho;
};

void trajectory_tail_init(struct trajectory_tail *tail);
void trajectory_tail_clear(struct trajectory_tail *tail);
LOCAL_STRUCT(trajectory_tail)

/* Finds delta, U and rho that make the bound useful at the interval t0. Returns false if the number of terms is too
 * small for the proof; the caller then uses more terms. */
bool trajectory_tail_prove(struct trajectory_tail *tail, const struct trajectory *t, const arb_t t0);

/* Bounds sum_{j > terms} |c[k][j]| binomial(e+1, m) t0^(e+1-m), e = k (b+1) + j (a+1), from above. This is the missing
 * part of the m-th Taylor coefficient of x_k(t) at t0. */
void trajectory_tail_jet(mag_t bound, const struct trajectory_tail *tail, const struct trajectory *t, slong k, slong m,
                         const arb_t t0);

#endif
