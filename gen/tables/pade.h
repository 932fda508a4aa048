/* SPDX-License-Identifier: MIT */
/* A Padé in a C header: arrays, their lengths, its bounds, and what the bounds rest on. */
#ifndef COR_GEN_TABLES_PADE_H
#define COR_GEN_TABLES_PADE_H

#include "approximation/pade_rounded.h"
#include "support/emit_c.h"

struct pade_header {
    const char *name;  /* prefix of the arrays; in capitals, of the macros */
    const char *title; /* what it is, first line of its comment */
    enum contact_end end;
    slong beta_max;                      /* its bounds hold up to here */
    const struct references *references; /* NULL: no approximation error is stated */
    double limit;                        /* refused if a whole relative error is above this */
};

/* Emits name_p, name_q, name_l (ascending powers of z) and NAME_P, NAME_Q, NAME_L; with references
 * also NAME_{EPS,LOSS}_{APPROXIMATION,EVALUATION,MAX}_REL. Returns 0, or 1 after saying why not. */
int pade_emit(struct emit *e, const struct pade_header *h, const struct pade *f, const struct pade_analysis *a);

#endif
