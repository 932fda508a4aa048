/* SPDX-License-Identifier: MIT */
/* Rows of short polynomials on a uniform grid, as in pieces.h, for any function of one variable that can be enclosed.
 *
 * Row i belongs to the cell of half a step to either side of its node y_i = first + i step and holds columns c_0, c_0',
 * c_1, ..., c_degree: f = c_0 + (c_0' + t (c_1 + ... + c_degree t^(degree-1))), t = y - y_i.
 *
 * The function is computed at the Chebyshev points of blocks of cells, and rounded to SAMPLE_BITS. Rows are cut from
 * the polynomials through these samples, so that all later steps are arithmetic with the same result for every library.
 * Between the samples, at two places of each block, the polynomials are compared with enclosures. */
#ifndef COR_GEN_APPROXIMATION_FUNCTION_ROWS_H
#define COR_GEN_APPROXIMATION_FUNCTION_ROWS_H

#include "support/emit_c.h"

/* y = f(x), enclosed with a working precision of `prec` bits */
typedef void function_of_ball(arb_t y, const arb_t x, slong prec);

struct function_rows {
    const char *name;     /* name of the function that returns a row, cor_rows_...; the macros COR_ROWS_..._FIRST, ...
                           * give its geometry */
    const char *title;    /* first line of its comment */
    const char *variable; /* y in words: "ln(1 + beta)" */
    function_of_ball *value, *enclosure; /* for the samples; proved */
    double first, step, end;             /* first node and step of the grid; end of the table */
    slong rows;
    double least_bits;   /* accuracy that every row must reach */
    arb_ptr coefficient; /* rows x FUNCTION_ROWS_COLUMNS intervals that round to the doubles of the table */
    double *bits;        /* accuracy of the rounded row, sampled */
};
enum { FUNCTION_ROWS_DEGREE = 10, FUNCTION_ROWS_COLUMNS = FUNCTION_ROWS_DEGREE + 2 };

/* Computes the rows of r, whose fields up to least_bits are set. Fails if a row misses its bound. */
int function_rows_make(struct function_rows *r);
void function_rows_clear(struct function_rows *r);

/* The geometry as macros, _FIRST, _STEP, _PER_UNIT, _ROWS and _END under NAME in capitals, and the function NAME(i)
 * that returns row i. */
int function_rows_emit(struct emit *e, const struct function_rows *r);

#endif
