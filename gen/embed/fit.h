/* SPDX-License-Identifier: MIT */
/* Coefficients of a form. Each function fills f->number for its kind of form, rounded to the scene's type. It returns
 * false if the system is singular, if the denominator is not shown to be positive on the whole range, or if the type
 * cannot hold a coefficient. */
#ifndef COR_GEN_EMBED_FIT_H
#define COR_GEN_EMBED_FIT_H

#include "approximation/pade.h"
#include "embed/form.h"

/* Polynomial or rational interpolation in f->variable, with the degrees of f. The result is close to the best
 * approximation. */
bool embed_fit_rational(struct embed_form *f, const struct embed_scene *s);

/* The quotient of p and q in z = beta^(1/root), converted to the root of the speed that f->variable becomes. q may be
 * 1. */
bool embed_fit_quotient(struct embed_form *f, const struct embed_scene *s, const arb_poly_t p, const arb_poly_t q,
                        slong root);

/* Polynomials of degree f->numerator on f->rows equal pieces of the fifth root */
bool embed_fit_pieces_beta(struct embed_form *f, const struct embed_scene *s);

/* Polynomials on pieces that begin where the leading `bits` bits of the significand change. Returns false also if their
 * table takes more than at_most bytes, or not more than more_than. */
bool embed_fit_pieces_speed(struct embed_form *f, const struct embed_scene *s, int fraction_bits, slong more_than,
                            slong at_most);

#endif
