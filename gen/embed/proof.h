/* SPDX-License-Identifier: MIT */
/* A proved bound of a form's error at every speed of its scene (docs/embed.md, "Tolerance"). The formula with the
 * header's coefficients is compared with the proved interpolant of the collision as functions (row_proof.h), beyond it
 * with what is proved at large beta (far_proof.h), and the rounding errors are added. */
#ifndef COR_GEN_EMBED_PROOF_H
#define COR_GEN_EMBED_PROOF_H

#include "embed/form.h"

/* eps at zero overlap is h*^5 beta^-5 (1 - d) with 0 < d < EMBED_FAR_ERROR for beta >= EMBED_FAR.
 * tests/gen/test_embed.c encloses d at EMBED_FAR; d falls as beta grows (docs/theory.md, 4). */
#define EMBED_FAR 7.0
#define EMBED_FAR_ERROR 2.7e-17

struct embed_proof {
    double error;    /* relative, of eps from the header; infinite without a proof */
    double formula;  /* of that the formula without rounding */
    double rounding; /* and the rounding */
    bool proved;     /* the error, at every speed of the range from this one on, m/s */
    double from;
};

/* Proves the error of a form of spheres, sampled before. For other laws only the rounding has a bound. Returns
 * STATUS_OK, also without a proof, or STATUS_FAILED after a message if an interpolant is shown to be wrong. */
int embed_prove(struct embed_proof *proof, const struct embed_form *f, const struct embed_scene *s);

/* Proved bounds of the rounding errors of a form in the arithmetic of its header. They assume IEEE 754 arithmetic
 * rounded to nearest with a correctly rounded square root, and hold for fused products and others in any mixture. */
struct embed_rounding {
    double error; /* relative, of the result; includes the error of the root of the speed */
    double root;  /* relative, of that root */
    double place; /* absolute, of the place in a table in beta; 0 for other forms */
};

/* Returns false if no bound was found. */
bool embed_rounding_bound(struct embed_rounding *bound, const struct embed_form *f);

#endif
