/* SPDX-License-Identifier: MIT */
/* A function of one variable that can be enclosed, as something that pieces.h cuts rows from.
 *
 * It is computed at the Chebyshev points of blocks of rows, and rounded to SAMPLE_BITS. Rows are cut from the
 * polynomials through these samples, so that all later steps are arithmetic with the same result for every library.
 * Between the samples, at two places of each block, the polynomials are compared with enclosures. */
#ifndef COR_GEN_APPROXIMATION_SAMPLED_FUNCTION_H
#define COR_GEN_APPROXIMATION_SAMPLED_FUNCTION_H

#include "approximation/pieces.h"

/* f at y, or at y 2^k of octave k, enclosed with a working precision of `prec` bits if `proved`, otherwise a sample */
typedef void function_of_ball(arb_t f, const void *what, const arb_t y, bool proved, slong prec);

/* Cuts p, a table of VARIABLE_OTHER or one of octaves, and writes it, as pieces_write. */
int sampled_function_write(struct emit *e, struct pieces *p, function_of_ball *value, const void *what);

#endif
