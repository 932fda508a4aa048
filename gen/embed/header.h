/* SPDX-License-Identifier: MIT */
/* The header for a scene: one function, and a banner that states the choice and its reasons */
#ifndef COR_GEN_EMBED_HEADER_H
#define COR_GEN_EMBED_HEADER_H

#include "embed/choose.h"
#include "embed/proof.h"

void embed_header_write(FILE *file, const struct embed_request *request, const struct embed_scene *s,
                        const struct embed_form *form, enum embed_family chosen, const struct embed_proof *proof);

/* A malloc'ed text about the failed families: "neither a series ..., nor ..." */
char *embed_failures(const struct embed_scene *s, const struct embed_form *form);

#endif
