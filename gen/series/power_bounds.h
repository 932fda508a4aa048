/* SPDX-License-Identifier: MIT */
/* Proves bounds of powers of a truncated trajectory: docs/theory.md, 3, equations (3.1) and (3.2).
 *
 * A is the Banach algebra of power series in s whose coefficients are polynomials in u cut after u^order, with the norm
 * |f| = sum |f_kj| U^k rho^j. Z is X truncated after s^J. P is the truncated row polynomial of X^p, where p is a or
 * b + 1. It agrees with Z^p up to s^J. With E = Z^p - P and th = s d/ds:
 *
 *   1/|1/Z| >= (1 - |1 - Z V|)/|V| for any V in A,
 *   Z th(E) - p E th(Z) = -N,  N = Z th(P) - p P th(Z) = O(s^(J+1)),
 *   so |E| <= nu |N| / (J + 1 - p nu |th(Z)|) for any nu >= |1/Z|.
 *
 * The norms of columns f^(j), the coefficients of s^j in f, bound both 1 - Z V and N without a product of polynomials.
 * V is the inverse of a small block of Z. Wherever the bounds are useful, Z is small outside this block. */
#ifndef COR_GEN_SERIES_POWER_BOUNDS_H
#define COR_GEN_SERIES_POWER_BOUNDS_H

#include "series/trajectory.h"

/* Norms are needed to a few digits only. */
enum { NORM_BITS = 64 };

/* The data of one trajectory that the bounds need, except the weights. The trajectory must outlive it. */
struct power_evidence {
    const struct trajectory *t;
    slong J;
    int powers;                        /* 1 if both powers are equal */
    struct ratio exponent[2];          /* p = a, b + 1 */
    slong rows, length, products;      /* size of the block B of Z; number of rows of 1 - B V */
    arb_poly_struct *inverse, *defect; /* V and 1 - B V, `products` rows each */
};

/* B has the first `block_rows` rows and `block_length` columns of Z, or fewer if Z has fewer. */
void power_evidence_init(struct power_evidence *e, const struct trajectory *t, slong block_rows, slong block_length);
void power_evidence_clear(struct power_evidence *e);

/* Upper bounds in the norm with the weights U and rho */
struct power_bounds {
    arb_t inverse;           /* nu of (3.1): |1/Z| */
    arb_t error[2], size[2]; /* |E| and |Z^p| of (3.2) */
    arb_t last_column;       /* norm of Z^a without its terms below s^J */
};

void power_bounds_init(struct power_bounds *b);
void power_bounds_clear(struct power_bounds *b);
LOCAL_STRUCT(power_bounds)

/* Computes the bounds. Returns false if the weights are too large for a proof. */
bool power_bounds_prove(struct power_bounds *b, const struct power_evidence *e, double U, double rho);

#endif
