/* SPDX-License-Identifier: MIT */
/* The cheapest member of each family of forms that meets a scene's tolerance, and the cheapest of them. */
#ifndef COR_GEN_EMBED_CHOOSE_H
#define COR_GEN_EMBED_CHOOSE_H

#include "embed/form.h"
#include "support/parallel.h"

/* eps of spheres at one end in powers of beta^(1/root). A thread computes it between embed_series_begin and
 * embed_series_end. */
struct embed_series {
    enum contact_end end;
    bool sphere; /* nothing is computed for another law */
    arb_poly_t eps;
    slong root;
    int status;
    struct parallel_task task;
};
void embed_series_begin(struct embed_series *series, const struct law *law, enum contact_end end);
int embed_series_end(struct embed_series *series); /* returns STATUS_OK, or STATUS_FAILED after a message */
void embed_series_clear(struct embed_series *series);

/* Fills form[FAMILIES], one for each family, found or not. */
void embed_search(struct embed_form *form, const struct embed_scene *s, const struct embed_series *series);

/* The cheapest family for a purpose, or FAMILIES if none was found. */
enum embed_family embed_choose(const struct embed_form *form, enum embed_purpose purpose);

#endif
