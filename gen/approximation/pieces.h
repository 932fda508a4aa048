/* SPDX-License-Identifier: MIT */
/* Piecewise polynomials on a uniform grid, cut from the interpolant of the collision.
 *
 * Row i belongs to the cell of half a step to either side of its node y_i = first + i step, in the variable y, and
 * holds columns c_0, c_0', c_1, ..., c_degree:
 *
 *     f = c_0 + (c_0' + s (c_1 + c_2 t + ... + c_degree t^(degree-1))),     t = y - y_i
 *
 * with s = t in the first `plain` rows and s = beta - y_i^2 in the others, of y = sqrt(beta): that is exact in
 * floating point, where t is not, but has a zero at -y_i that the first rows are too near to. c_0 is the number of
 * `head_bits` bits, or the double, nearest to f(y_i), and c_0' what it lacks; the other coefficients interpolate
 * (f - f(y_i))/s at Chebyshev's points of the cell and are rounded once. */
#ifndef COR_GEN_APPROXIMATION_PIECES_H
#define COR_GEN_APPROXIMATION_PIECES_H

#include "approximation/interpolant.h"
#include "support/emit_c.h"

/* The variable y of a table. By octaves 2^k <= x < 2^(k+1) of some x, y is x 2^-k, and the 2^octave_bits rows of an
 * octave have their nodes in the middle of as many equal cells: of x = beta^5, which an impact speed on spheres is
 * proportional to, of eps, of beta, of ln(beta), and of beta_c - beta. VARIABLE_LOSS is 1 - eps, and roots are those of
 * the interpolant's layout, square roots for spheres. */
enum variable {
    VARIABLE_BETA,
    VARIABLE_ROOT_BETA,
    VARIABLE_LOG_BETA,
    VARIABLE_LOSS,
    VARIABLE_ROOT_LOSS,
    VARIABLE_POWER_OCTAVES,
    VARIABLE_EPS_OCTAVES,
    VARIABLE_BETA_OCTAVES,
    VARIABLE_LOG_OCTAVES,
    VARIABLE_BELOW_OCTAVES
};
enum { PIECES_OCTAVE_BITS = 3, PIECES_PER_OCTAVE = 1 << PIECES_OCTAVE_BITS };

struct pieces {
    enum quantity quantity;
    enum variable variable;
    slong root;         /* of VARIABLE_ROOT_... */
    double first, step; /* of the nodes; octaves: first k */
    double end;         /* first beta, ln(beta), beta^5, loss, eps or beta_c - beta that the table is not for */
    slong octave_bits;  /* of octaves */
    slong rows, degree, plain;
    slong head_bits;     /* of c_0, or 0: as many as a double has */
    const char *name;    /* of the function that returns a row, cor_rows_...; COR_ROWS_..._FIRST is of its geometry */
    const char *title;   /* of its comment */
    double least_bits;   /* every piece must reach so many */
    double most_rest;    /* |row/c_0 - 1| must not be more, or 0: it may */
    arb_ptr coefficient; /* rows x (degree + 2), balls that round to the doubles of the table */
    double *value;       /* the same as doubles */
    double *bits;        /* reached by the rounded row, sampled */
};

/* Cuts p, whose fields up to most_rest are set. Fails where a piece misses its bound. */
int pieces_make(struct pieces *p, const struct interpolant *f);
void pieces_clear(struct pieces *p);

/* The same with the widest cells that meet the bounds: from p's own, halved as long as a piece misses one. `first`,
 * `end` and the first step or octave_bits are set, `rows` and `plain` follow. */
int pieces_fit(struct pieces *p, const struct interpolant *f);

/* The geometry of the table as macros, under NAME in capitals, and the function NAME(i) that returns row i, with the
 * intervals and bits beside the numbers:
 *
 *     _FIRST, _STEP, _PER_UNIT, _ROWS   nodes FIRST + i STEP, 0 <= i < ROWS, PER_UNIT = 1/STEP
 *     _END                              as the field `end`
 *     _PLAIN_ROWS                       rows with s = t, where not all have it
 *
 * and of octaves, where FIRST is the first x:
 *
 *     _FIRST, _FIRST_OCTAVE, _OCTAVE_BITS, _ROWS, _END   FIRST = 2^FIRST_OCTAVE; 2^OCTAVE_BITS rows to an octave */
int pieces_emit(struct emit *e, const struct pieces *p);

#endif
