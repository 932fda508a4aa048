/* SPDX-License-Identifier: MIT */
/* A Padé approximant in a C header: two functions, their arrays, the bounds, and the origin of the bounds. */
#ifndef COR_GEN_TABLES_PADE_H
#define COR_GEN_TABLES_PADE_H

#include "approximation/pade_rounded.h"
#include "support/emit_c.h"

struct pade_header {
    const char *name;  /* prefix of the arrays; in capitals, of the macros */
    const char *title; /* first line of its comment, which describes it */
    enum contact_end end;
    slong beta_max;                      /* its bounds hold up to this beta */
    const struct references *references; /* NULL: no approximation error is stated */
};

/* Emits name_p, name_q, name_l (ascending powers of z), NAME_P, NAME_Q, NAME_L, name_eps(beta) and name_loss(beta),
 * which need math.h; with references also NAME_{EPS,LOSS}_{APPROXIMATION,EVALUATION,MAX}_REL up to NAME_BETA_MAX.
 * Returns 0, or 1 after reporting the reason. */
int pade_emit(struct emit *e, const struct pade_header *h, const struct pade *f, const struct pade_analysis *a);

#endif
