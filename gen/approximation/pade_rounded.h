/* SPDX-License-Identifier: MIT */
/* A Padé approximant for evaluation in doubles: its rounded coefficients and its two errors. With z = beta^(1/root),
 * eps = P(z)/Q(z) and 1 - eps = beta L(z)/Q(z), each polynomial by Horner's rule. L = (Q - P)/beta is computed in
 * interval (ball) arithmetic, so that nothing cancels in doubles. */
#ifndef COR_GEN_APPROXIMATION_PADE_ROUNDED_H
#define COR_GEN_APPROXIMATION_PADE_ROUNDED_H

#include "approximation/pade.h"

struct pade_rounded {
    arb_poly_t p, q, l;                      /* intervals, before rounding */
    arb_poly_t p_double, q_double, l_double; /* the doubles, exact */
    slong root;
};

void pade_rounded_init(struct pade_rounded *r);
void pade_rounded_clear(struct pade_rounded *r);
LOCAL_STRUCT(pade_rounded)

/* Returns 0, or 1 after reporting on stderr the coefficient that could not be rounded. */
int pade_round(struct pade_rounded *r, const struct pade *f);

/* eps for both ends of contact at exact rational beta, the sample points of the approximation error */
struct references {
    fmpq *beta;
    arb_ptr eps[2]; /* by enum contact_end */
    slong count, even, far;
};

/* `even` points near i/even, i = 1..even, `small` points near/2^(6 j), j = 1..small, and above `near` the points near
 * (5/4)^j up to beta_max, and beta_max. Returns 0, or 1 after reporting the failure. */
enum { PADE_NEAR = 2 }; /* the usual range, within which no collision is slow */
int references_init(struct references *s, const struct law *law, slong beta_max, slong even, slong small);
void references_clear(struct references *s);

struct pade_error {
    double eps, loss;                 /* largest relative error found, rounded up */
    fmpq_t eps_at_beta, loss_at_beta; /* where */
};

void pade_error_init(struct pade_error *e);
void pade_error_clear(struct pade_error *e);
LOCAL_STRUCT(pade_error)

/* Error of the exact functions of the rounded coefficients, which includes the rounding of the coefficients.
 * Sampled. */
void pade_approximation_error(struct pade_error *e, const struct pade_rounded *r, enum contact_end end,
                              const struct references *s);

/* Error of their evaluation in double (round to nearest, with or without fused multiply-add) for 0 <= beta <= beta_max,
 * with a rounded z. Proved by interval (ball) arithmetic of sum |p_i| z^i / |P(z)| over pieces that cover the range.
 * Infinite if P or Q may vanish or overflow in the range. */
void pade_evaluation_error(double *eps, double *loss, const struct pade_rounded *r, slong beta_max);

#endif
