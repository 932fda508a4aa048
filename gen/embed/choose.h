/* SPDX-License-Identifier: MIT */
/* The cheapest member of each family of forms that meets a scene's tolerance, the cheapest of them, and its header. */
#ifndef COR_GEN_EMBED_CHOOSE_H
#define COR_GEN_EMBED_CHOOSE_H

#include <stdio.h>

#include "embed/proof.h"
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

/* The header for a scene: one function, and a banner that states the choice and its reasons */
void embed_header_write(FILE *file, const struct embed_request *request, const struct embed_scene *s,
                        const struct embed_form *form, enum embed_family chosen, const struct embed_proof *proof);

/* A malloc'ed text about the failed families: "neither a series ..., nor ..." */
char *embed_failures(const struct embed_scene *s, const struct embed_form *form);

#endif
