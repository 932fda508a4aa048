/* SPDX-License-Identifier: MIT */
/* Cuts tables from the collision's interpolant or from any function of one variable: piecewise polynomials on a uniform
 * grid or by octaves.
 *
 * The cell of row i extends half a step to either side of its node y_i = first + i step, in the variable y. The row has
 * the columns c_0, c_0', c_1, ..., c_degree:
 *
 *     f = c_0 + (c_0' + s (c_1 + c_2 t + ... + c_degree t^(degree-1))),     t = y - y_i
 *
 * In the first `plain` rows s = t. In the other rows of y = sqrt(beta), s = beta - y_i^2, which is exact in floating
 * point, while t is not. The first rows do not use this s, because its zero at y = -y_i is too near. Column c_0 is the
 * number of `head_bits` bits, or the double, nearest to f(y_i), and c_0' is its remainder. The other coefficients
 * interpolate (f - f(y_i))/s at the Chebyshev points of the cell and are rounded once.
 *
 * Rows of floats are cubics in beta. Row 0 belongs to 0 <= beta < 2^first, and its node is 0. Each octave from there to
 * `end` has 2^octave_bits equal cells, whose nodes are their middles. A row consists of four floats,
 *
 *     f = c_0 + (c_0' + t (c_1 + t (c_2 + t c_3))),     t = beta - node
 *
 * The remainder c_0' of c_0 has 8 bits. They are the lower half of the bits of c_3. Moved to the upper half, these bits
 * are the float c_0'. Only the upper half of c_3 is free, so c_3 has a relative error of 2^-8. The columns c_1 and c_2
 * compensate three quarters of the effect. */
#ifndef COR_GEN_APPROXIMATION_PIECES_H
#define COR_GEN_APPROXIMATION_PIECES_H

#include "approximation/interpolant.h"
#include "support/emit_c.h"

/* The variable y of a table. In tables by octaves 2^k <= x < 2^(k+1), y is x 2^-k. The 2^octave_bits rows of an octave
 * have their nodes in the middle of equal cells. Here x is eps, beta, ln(beta), beta_c - beta, or beta^5, which is
 * proportional to the impact speed of spheres. VARIABLE_LOSS is 1 - eps. VARIABLE_ROOT_... are roots of
 * beta or of the loss, square roots for spheres. */
enum variable {
    VARIABLE_BETA,
    VARIABLE_ROOT_BETA,
    VARIABLE_LOG_BETA,
    VARIABLE_LOSS,
    VARIABLE_ROOT_LOSS,
    VARIABLE_OTHER, /* for a function that is not a quantity of the collision */
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
    slong root;         /* y = beta^(1/root) or (1 - eps)^(1/root) */
    double first, step; /* grid of the nodes; octaves: `first` is the first k */
    double end;         /* the table ends before this beta, ln(beta), beta^5, loss, eps or beta_c - beta */
    slong octave_bits;  /* log2 of the number of rows in an octave */
    slong rows, degree, plain;
    slong head_bits;     /* bits of c_0; 0: the bits of a double or float */
    bool floats;         /* rows of floats; `first` is an octave */
    const char *words;   /* text for y if its usual name does not apply, otherwise NULL */
    const char *name;    /* name of the function that returns a row, cor_rows_...; the macros COR_ROWS_..._FIRST, ...
                          * describe its geometry */
    const char *title;   /* first line of the comment */
    double least_bits;   /* accuracy that every row must reach */
    double most_rest;    /* upper limit of |row/c_0 - 1|; 0: no limit */
    arb_ptr coefficient; /* rows x columns, intervals that round to the doubles of the table */
    double *value;       /* the coefficients, rounded to doubles; with `floats`, to floats */
    double *bits;        /* accuracy of the rounded row: sampled, or proved */
    bool to_prove;       /* row_proof.h will prove the rows, so they are not sampled before */
    bool proved;         /* row_proof.h has proved all rows */
};

/* The cell of a row: its node and its ends as values of y. In tables by octaves y = x 2^-octave. */
struct cell {
    double node, lo, hi;
    slong octave;
    bool plain; /* s = t */
};
struct cell pieces_cell(const struct pieces *p, slong row);

enum { PIECES_FLOATS = 4 };
slong pieces_columns(const struct pieces *p);

/* The function from which rows are cut: computes f at y in a cell. Returns 0, or 1 after reporting the failure. */
struct pieces_function {
    int (*at)(arb_t f, const void *context, const struct pieces *p, const struct cell *cell, const arb_t y);
    const void *context;
};
struct pieces_function pieces_of_collision(const struct interpolant *f);

/* Computes the rows of p from the fields up to most_rest. Fails if a row misses its bound. Call pieces_clear in either
 * case. */
int pieces_make(struct pieces *p, struct pieces_function f);
void pieces_clear(struct pieces *p);

/* Computes the rows of p with the widest cells that meet the bounds. Halves the cells until no row misses a bound. The
 * caller sets `first`, `end` and the first step or octave_bits. The function sets `rows` and `plain`. */
int pieces_fit(struct pieces *p, struct pieces_function f);

/* Writes the geometry of the table as macros, under NAME in capitals, and the function NAME(i) that returns row i. The
 * comment above them contains the grid, the worst error and the bits of each row.
 *
 *     _FIRST, _STEP, _PER_UNIT, _ROWS   nodes FIRST + i STEP, 0 <= i < ROWS, PER_UNIT = 1/STEP
 *     _END                              as the field `end`
 *     _PLAIN_ROWS                       number of rows with s = t, if not all have it
 *
 * Octaves have the following, where FIRST is the first x:
 *
 *     _FIRST, _FIRST_OCTAVE, _OCTAVE_BITS, _ROWS, _END   FIRST = 2^FIRST_OCTAVE; 2^OCTAVE_BITS rows to an octave
 *
 * Floats have no _FIRST_OCTAVE, and FIRST is the end of row 0. */
int pieces_emit(struct emit *e, const struct pieces *p);

/* Computes a table by pieces_make, or by pieces_fit if rows = 0, and writes it. Returns 0, or 1 after reporting the
 * failure. */
int pieces_write(struct emit *e, struct pieces *p, struct pieces_function f);

/* ---- sampled_function.c: rows of a function of one variable that can be enclosed ----
 *
 * The function is computed at the Chebyshev points of blocks of rows, and rounded to SAMPLE_BITS. Rows are cut from the
 * polynomials through these samples, so that all later steps are arithmetic with the same result for every library. The
 * polynomials are compared with enclosures at two places of each block, between the samples. */

/* Computes f(y), where y is x for tables by octaves. If `proved`, encloses it with `prec` working bits, otherwise
 * samples it. */
typedef void function_of_ball(arb_t f, const void *what, const arb_t y, bool proved, slong prec);

/* Cuts the table p and writes it, as pieces_write does. p->variable is VARIABLE_OTHER or one by octaves. */
int sampled_function_write(struct emit *e, struct pieces *p, function_of_ball *value, const void *what);

#endif
