/* SPDX-License-Identifier: MIT */
/* Rows of cubics for float arithmetic, by octaves of beta, cut from the interpolant of the collision.
 *
 * Row 0 belongs to 0 <= beta < first = 2^first_octave, and its node is 0. Each octave from there to `end` =
 * 2^end_octave has 2^octave_bits cells of equal width with a row each, whose node is the middle of the cell. A row
 * holds four floats c_0, c_1, c_2, c_3:
 *
 *     f = c_0 + (c_0' + t (c_1 + t (c_2 + t c_3))),     t = beta - node
 *
 * c_0 alone would be off by half a unit of its last place. Its remainder c_0' has 8 bits. They are the lower half of
 * the bits of c_3: moved to the upper half, these bits are the float c_0'. The upper half of c_3 gives it a relative
 * error of 2^-8. c_1 and c_2 compensate three quarters of the effect. */
#ifndef COR_GEN_APPROXIMATION_FLOAT_ROWS_H
#define COR_GEN_APPROXIMATION_FLOAT_ROWS_H

#include "approximation/interpolant.h"
#include "support/emit_c.h"

struct float_rows {
    const char *name;  /* name of the function that returns a row, cor_rows_...; the macros COR_ROWS_..._FIRST, ...
                        * give its geometry */
    const char *title; /* first line of its comment */
    enum quantity quantity;
    int first_octave, end_octave, octave_bits;
    int head_bits;     /* bits of c_0; 0: those of a float */
    double least_bits; /* accuracy that every row must reach */
    slong rows;
    float *column; /* rows x FLOAT_ROWS_COLUMNS */
    double *bits;  /* accuracy of each row, sampled */
};
enum { FLOAT_ROWS_COLUMNS = 4 };

/* Computes the rows of r, whose fields up to least_bits are set. Returns 0, or 1 after reporting the row that misses
 * its bound. Call float_rows_clear in either case. */
int float_rows_make(struct float_rows *r, const struct interpolant *f);
void float_rows_clear(struct float_rows *r);

/* The geometry as macros, _FIRST, _OCTAVE_BITS, _ROWS and _END under NAME in capitals, and the function NAME(i) that
 * returns row i. */
void float_rows_emit(struct emit *e, const struct float_rows *r);

#endif
