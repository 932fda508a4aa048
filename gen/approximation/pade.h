/* SPDX-License-Identifier: MIT */
/* Padé approximants P(z)/Q(z) of eps at either end of contact, q_0 = 1 (docs/theory.md, 7).
 *
 * z = beta at zero overlap, z = beta^(1/root) at zero force (root = 2 for the sphere). Coefficients are intervals (Arb
 * balls). The precision of the series is raised until they are narrow enough. */
#ifndef COR_GEN_APPROXIMATION_PADE_H
#define COR_GEN_APPROXIMATION_PADE_H

#include <stdio.h>

#include "series/series.h"

enum pade_kind {
    PADE_ORDINARY,    /* agrees with the series to z^(m+n) */
    PADE_TWO_POINT,   /* [m/m+5], sphere at zero overlap: C_0..C_{m+4} and m+1 terms at infinity */
    PADE_AS_PUBLISHED /* Table I: [1/4] of the printed, cut series, in x = (g/g*)^(1/5) */
};

/* The numbers of PADE_AS_PUBLISHED as printed in the paper of 1999, correct or not: a_1 to a_4 of (32) and (33), d_1 to
 * d_5 of Table I. No table of values may use them. */
extern const char *const published_a[4], *const published_d[5];

struct pade_request {
    enum pade_kind kind;
    slong numerator, denominator;
    enum cor_end end;
    struct cor_exponents law;
};

struct pade {
    arb_poly_t p, q;
    slong numerator, denominator; /* requested degrees; a top coefficient may vanish */
    slong root;                   /* z = beta^(1/root) */
    const char *variable;         /* name of z^root: "beta", or "x" as published */
};

void pade_init(struct pade *f);
void pade_clear(struct pade *f);
LOCAL_STRUCT(pade)

/* Computes the [m/n] of any series c_0 + c_1 z + ..., known to z^(m+n). Returns false if the linear system cannot be
 * proved regular from these intervals, because the precision is too low or the entry is degenerate. */
bool pade_of_series(struct pade *f, const arb_poly_t c, slong m, slong n, slong prec);

/* Computes the [m/m+5] that agrees with c_0..c_{m+4} at 0 and with limit/z^5 (1 + 0/z + ... + 0/z^m) at infinity.
 * Returns false like pade_of_series. */
bool pade_two_point_of_series(struct pade *f, const arb_poly_t c, const arb_t limit, slong m, slong prec);

/* The square block of a degenerate table entry. Every entry of its first row and column is the one fraction [m/n],
 * which agrees with the series to z^(m+n+size-1). The other entries are the same fraction, or do not exist. `open`: the
 * given series is too short to find the end of the block. */
struct pade_block {
    slong m, n, size;
    bool open;
};

/* True if the intervals of c show that the entry [m/n] is degenerate. Then sets its block. */
bool pade_block_of(struct pade_block *b, const arb_poly_t c, slong m, slong n, slong prec);

/* A pole and a zero closer to each other than |pole|/PADE_PAIR_DISTANCE are a pair. A pair is spurious, a defect, if
 * its pole is near the positive axis: Re z > 0, |Im z| < Re z/PADE_PAIR_SLOPE. Other pairs are reported and harmless.
 * They imitate a branch cut of eps. A pair with relative distance d changes the value on the axis by at most about d
 * PADE_PAIR_SLOPE. An undecided comparison counts as true. */
enum { PADE_PAIR_DISTANCE = 100, PADE_PAIR_SLOPE = 4 };

struct pade_pair {
    slong pole, zero; /* indices */
    arb_t distance;   /* |zero/pole - 1| */
    bool spurious;
};

struct pade_roots {
    acb_ptr root;          /* the roots in z, isolated in disjoint balls; real roots have Im = 0 exactly */
    slong count, positive; /* number of roots on z > 0 */
};

struct pade_analysis {
    struct pade_roots poles, zeros;
    struct pade_pair *pair;
    slong pairs, spurious;
    slong root;
    const char *variable;
};

void pade_analysis_init(struct pade_analysis *a);
void pade_analysis_clear(struct pade_analysis *a);
LOCAL_STRUCT(pade_analysis)

/* Isolates all poles and zeros. Returns false if the coefficients are too wide to isolate them or to decide which are
 * real. */
bool pade_analyse(struct pade_analysis *a, const struct pade *f, slong prec);

/* Returns a malloc'ed sentence about the defects on or near z > 0, with their places, or NULL without defects. */
char *pade_defects(const struct pade_analysis *a);

/* Prints the whole analysis. Every line starts with `prefix`. */
void pade_print_analysis(FILE *file, const struct pade_analysis *a, const char *prefix);

/* Returns the reason why no precision meets the request, or NULL. */
const char *pade_refusal(const struct pade_request *request);

/* Computes the requested Padé approximant with `bits` relative bits in every coefficient, and its analysis unless a is
 * NULL. Returns 0, or 1 after reporting the failure on stderr. */
int pade_compute(struct pade *f, struct pade_analysis *a, const struct pade_request *request, slong bits);

/* ---- pade_rounded.c: a Padé approximant for evaluation in doubles, its rounded coefficients and its two errors ----
 *
 * With z = beta^(1/root), eps = P(z)/Q(z) and 1 - eps = beta L(z)/Q(z), each polynomial by Horner's rule.
 * L = (Q - P)/beta is computed in interval (ball) arithmetic, so that nothing cancels in doubles. */

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
    arb_ptr eps[2]; /* index: enum cor_end */
    slong count, even, far;
};

/* Sets the sample points. With c, the smaller of PADE_NEAR and beta_max, they are c i/even, i = 1..even; c/2^(6 j), j =
 * 1..small; above c, c (5/4)^j up to beta_max; and beta_max. Returns 0, or 1 after reporting the failure. */
enum { PADE_NEAR = 2 }; /* the usual range, within which no collision is slow */
int references_init(struct references *s, const struct cor_exponents *law, slong beta_max, slong even, slong small);
void references_clear(struct references *s);

struct pade_error {
    double eps, loss;                 /* largest relative error found, rounded up */
    fmpq_t eps_at_beta, loss_at_beta; /* where */
};

void pade_error_init(struct pade_error *e);
void pade_error_clear(struct pade_error *e);
LOCAL_STRUCT(pade_error)

/* Samples the error of eps and 1 - eps from the rounded coefficients. The evaluation is exact, so the error includes
 * the rounding of the coefficients but no rounding of the evaluation. */
void pade_approximation_error(struct pade_error *e, const struct pade_rounded *r, enum cor_end end,
                              const struct references *s);

/* Bounds the error of the approximant's evaluation in double (round to nearest, with or without fused multiply-add) for
 * 0 <= beta <= beta_max, with a rounded z. Proved by interval (ball) arithmetic of sum |p_i| z^i / |P(z)| over pieces
 * that cover the range. Infinite if P or Q may vanish or overflow in the range. */
void pade_evaluation_error(double *eps, double *loss, const struct pade_rounded *r, slong beta_max);

#endif
