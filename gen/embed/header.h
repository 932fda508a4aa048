/* SPDX-License-Identifier: MIT */
/* The header for a scene: a banner that says what was chosen and why, and one function. */
#ifndef COR_GEN_EMBED_HEADER_H
#define COR_GEN_EMBED_HEADER_H

#include "embed/choose.h"

void embed_header_write(FILE *file, const struct embed_request *request, const struct embed_scene *s,
                        const struct embed_form *form, enum embed_family chosen);

/* "neither a series ..., nor ...": what was tried and how it failed, for a person. Malloc'ed. */
char *embed_failures(const struct embed_scene *s, const struct embed_form *form);

#endif
