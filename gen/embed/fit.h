/* SPDX-License-Identifier: MIT */
/* Coefficients of a form. Each function fills f->number for the kind of form that f is, rounded to the scene's type,
 * and returns false where there is no such fit: a singular system, a denominator that is not seen to be positive on
 * the whole range, a coefficient that the type cannot hold. */
#ifndef COR_GEN_EMBED_FIT_H
#define COR_GEN_EMBED_FIT_H

#include "approximation/pade.h"
#include "embed/form.h"

/* Polynomial or rational interpolation in f->variable, of the degrees set in f; near to the best there is. */
bool embed_fit_rational(struct embed_form *f, const struct embed_scene *s);

/* p and q in z = beta^(1/root), q may be 1: in the root of the speed that f->variable becomes. */
bool embed_fit_quotient(struct embed_form *f, const struct embed_scene *s, const arb_poly_t p, const arb_poly_t q,
                        slong root);

/* Polynomials of degree f->numerator on f->rows even pieces of the fifth root. */
bool embed_fit_pieces_beta(struct embed_form *f, const struct embed_scene *s);

/* On pieces that begin where so many leading bits of the fraction change; false also if their table takes more bytes
 * than at_most, or not more than more_than. */
bool embed_fit_pieces_speed(struct embed_form *f, const struct embed_scene *s, int fraction_bits, slong more_than,
                            slong at_most);

#endif
