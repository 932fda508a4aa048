/* SPDX-License-Identifier: MIT */
/* Rows of short polynomials on a uniform grid, as in pieces.h, of any function of one variable that can be enclosed.
 *
 * Row i belongs to the cell of half a step to either side of its node y_i = first + i step and holds columns c_0, c_0',
 * c_1, ..., c_degree: f = c_0 + (c_0' + t (c_1 + ... + c_degree t^(degree-1))), t = y - y_i.
 *
 * The function is computed at Chebyshev's points of blocks of cells and rounded there to SAMPLE_BITS; rows are cut from
 * the polynomials through these samples, so that everything after them is arithmetic, the same with every library.
 * Between the samples the polynomials are compared with enclosures, at two places of each block. */
#ifndef COR_GEN_APPROXIMATION_FUNCTION_ROWS_H
#define COR_GEN_APPROXIMATION_FUNCTION_ROWS_H

#include "support/emit_c.h"

/* y = f(x), enclosed with `prec` bits of work */
typedef void function_of_ball(arb_t y, const arb_t x, slong prec);

struct function_rows {
    const char *name;     /* of the function that returns a row, cor_rows_...; COR_ROWS_..._FIRST is of its geometry */
    const char *title;    /* of its comment */
    const char *variable; /* y in words: "ln(1 + beta)" */
    function_of_ball *value, *enclosure; /* for the samples; proved */
    double first, step, end;             /* of the nodes; first y that the table is not for */
    slong rows;
    double least_bits;   /* every row must reach so many */
    arb_ptr coefficient; /* rows x FUNCTION_ROWS_COLUMNS, balls that round to the doubles of the table */
    double *bits;        /* reached by the rounded row, sampled */
};
enum { FUNCTION_ROWS_DEGREE = 10, FUNCTION_ROWS_COLUMNS = FUNCTION_ROWS_DEGREE + 2 };

/* Cuts the rows, whose fields up to least_bits are set. Fails where a row misses its bound. */
int function_rows_make(struct function_rows *r);
void function_rows_clear(struct function_rows *r);

/* The geometry as macros, _FIRST, _STEP, _PER_UNIT, _ROWS and _END under NAME in capitals, and the function NAME(i)
 * that returns row i. */
int function_rows_emit(struct emit *e, const struct function_rows *r);

#endif
