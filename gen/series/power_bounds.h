/* SPDX-License-Identifier: MIT */
/* Proved bounds of powers of a truncated trajectory: docs/theory.md, 3, equations (3.1) and (3.2).
 *
 * A is the Banach algebra of power series in s whose coefficients are polynomials in u cut after u^order, with the norm
 * |f| = sum |f_kj| U^k rho^j. Z is the truncated X of s-degree J, and P the truncated row polynomial of X^p, p = a and
 * b + 1, which agrees with Z^p up to s^J. With E = Z^p - P and th = s d/ds:
 *
 *   1/|1/Z| >= (1 - |1 - Z V|)/|V| for any V in A,
 *   Z th(E) - p E th(Z) = -N,  N = Z th(P) - p P th(Z) = O(s^(J+1)),
 *   so |E| <= nu |N| / (J + 1 - p nu |th(Z)|) for any nu >= |1/Z|.
 *
 * Norms of columns f^(j), the coefficients of s^j in f, bound both 1 - Z V and N without a product of polynomials: V is
 * the inverse of a small block of Z, and what the block lacks is small where the bounds are useful. */
#ifndef COR_GEN_SERIES_POWER_BOUNDS_H
#define COR_GEN_SERIES_POWER_BOUNDS_H

#include "series/trajectory.h"

/* Norms are needed to a few digits only. */
enum { NORM_BITS = 64 };

/* All data of one trajectory, which must live as long, that the bounds need, except the weights */
struct power_evidence {
    const struct trajectory *t;
    slong J;
    int powers;                        /* 1 if both powers are the same */
    struct ratio exponent[2];          /* p = a, b + 1 */
    slong rows, length, products;      /* of the block B of Z; rows of 1 - B V */
    arb_poly_struct *inverse, *defect; /* V and 1 - B V, `products` rows each */
};

/* B consists of the first `block_rows` rows of Z and of the first `block_length` columns, or of all that Z has. */
void power_evidence_init(struct power_evidence *e, const struct trajectory *t, slong block_rows, slong block_length);
void power_evidence_clear(struct power_evidence *e);

/* Upper bounds for the weights U and rho */
struct power_bounds {
    arb_t inverse;           /* nu of (3.1): |1/Z| */
    arb_t error[2], size[2]; /* |E| and |Z^p| of (3.2) */
    arb_t last_column;       /* norm of the part of Z^a from s^J on */
};

void power_bounds_init(struct power_bounds *b);
void power_bounds_clear(struct power_bounds *b);
LOCAL_STRUCT(power_bounds)

/* Returns false if the weights are too large for a proof. */
bool power_bounds_prove(struct power_bounds *b, const struct power_evidence *e, double U, double rho);

#endif
