/* SPDX-License-Identifier: MIT */
/* Computes the series of restitution at either end, with a guaranteed accuracy. */
#ifndef COR_GEN_SERIES_SERIES_H
#define COR_GEN_SERIES_SERIES_H

#include "cor/law.h"
#include "series/law.h"

/* The surface replaces zero force under a constant force. Only options and names use END_SURFACE; all other code uses
 * COR_END_ZERO_FORCE for both. */
enum { END_SURFACE = COR_END_ZERO_FORCE + 1 };
extern const char *const contact_end_options[];         /* "zero-overlap", "zero-force", NULL */
extern const char *const contact_end_options_pressed[]; /* also "surface" */
extern const char *const contact_end_options_all[];     /* also "approach-only", COR_END_APPROACH_ONLY */
extern const char *const contact_end_names[];           /* "zero_overlap", "zero_force", "surface" */

/* contact_end_given converts END_SURFACE of an option to COR_END_ZERO_FORCE. It returns STATUS_OK, or STATUS_USAGE
 * after a message if there is no such end. contact_end_named converts back. pressed: a constant force acts */
int contact_end_given(int *end, bool pressed);
int contact_end_named(int end, bool pressed);

struct series {
    arb_poly_t y;   /* x_max = sum y_k beta^k */
    arb_poly_t tau; /* t_max = sum tau_k beta^k */
    arb_poly_t c;   /* eps = sum C_k beta^k at zero overlap */
    slong order;    /* highest power of beta */
};

void series_init(struct series *s);
void series_clear(struct series *s);
LOCAL_STRUCT(series)

/* Computes all coefficients 0..order to at least `bits` relative bits each (absolute bits for coefficients that are 0).
 * Returns 0, or 1 after reporting the failure on stderr. */
int series_compute(struct series *s, slong order, const struct cor_exponents *law, slong bits);

/* Computes eps at an end as a power series in z = beta^(1/root) up to z^order. The root is 1 at zero overlap, and 2 at
 * zero force for the sphere. Accuracy and result are as for series_compute. */
int series_eps(arb_poly_t eps, slong *root, enum cor_end end, slong order, const struct cor_exponents *law, slong bits);

#endif
