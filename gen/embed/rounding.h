/* SPDX-License-Identifier: MIT */
/* Proved bounds of the rounding errors of a form in the arithmetic of its header. They assume IEEE 754 arithmetic
 * rounded to nearest with a correctly rounded square root, and hold for fused products and others in any mixture. */
#ifndef COR_GEN_EMBED_ROUNDING_H
#define COR_GEN_EMBED_ROUNDING_H

#include "embed/form.h"

struct embed_rounding {
    double error; /* relative, of the result; includes the error of the root of the speed */
    double root;  /* relative, of that root */
    double place; /* absolute, of the place in a table in beta; 0 for other forms */
};

/* Returns false if no bound was found. */
bool embed_rounding_bound(struct embed_rounding *bound, const struct embed_form *f);

#endif
