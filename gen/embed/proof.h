/* SPDX-License-Identifier: MIT */
/* A proved bound of a form's error at every speed of its scene (docs/embed.md, "Tolerance"). The formula with the
 * header's coefficients is compared with the proved interpolant of the collision as functions (row_proof.h), beyond it
 * with what is proved at large beta (far_proof.h), and the rounding errors are added (rounding.h). */
#ifndef COR_GEN_EMBED_PROOF_H
#define COR_GEN_EMBED_PROOF_H

#include "embed/form.h"
#include "embed/rounding.h"

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

#endif
