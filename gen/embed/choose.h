/* SPDX-License-Identifier: MIT */
/* The cheapest member of each family of forms that meets a scene's tolerance, the cheapest of them, and its header. */
#ifndef COR_GEN_EMBED_CHOOSE_H
#define COR_GEN_EMBED_CHOOSE_H

#include <stdio.h>

#include "embed/proof.h"

/* Fills form[FAMILIES], one for each family, found or not. */
void embed_search(struct embed_form *form, const struct embed_scene *s);

/* The cheapest family for a purpose, or FAMILIES if none was found. */
enum embed_family embed_choose(const struct embed_form *form, enum embed_purpose purpose);

/* The header for a scene: one function, and a banner that states the choice and its reasons */
void embed_header_write(FILE *file, const struct embed_request *request, const struct embed_scene *s,
                        const struct embed_form *form, enum embed_family chosen, const struct embed_proof *proof);

/* A malloc'ed text about the failed families: "neither a series ..., nor ..." */
char *embed_failures(const struct embed_scene *s, const struct embed_form *form);

#endif
