/* SPDX-License-Identifier: MIT */
/* The cheapest member of each family of forms that meets a scene's tolerance, and the cheapest of them. */
#ifndef COR_GEN_EMBED_CHOOSE_H
#define COR_GEN_EMBED_CHOOSE_H

#include "embed/form.h"

/* form[FAMILIES], by family; found or not. STATUS_OK, or STATUS_FAILED after saying what failed. */
int embed_search(struct embed_form *form, const struct embed_scene *s);
/* Its two halves, for who has a use for the series himself: eps in powers of beta^(1/root), and the search with it. */
int embed_series(arb_poly_t series, slong *root, const struct embed_scene *s);
void embed_search_series(struct embed_form *form, const struct embed_scene *s, const arb_poly_t series, slong root);

/* The family for a use, or FAMILIES if none was found. balanced: a call of its own counts as much as four numbers of an
 * array. */
enum embed_family embed_choose(const struct embed_form *form, enum embed_purpose purpose);

#endif
