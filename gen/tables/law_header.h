/* SPDX-License-Identifier: MIT */
/* Headers of one law x'' + beta x^b x' + x^a = 0: its tables (approximation/law_layout.h) with the functions that
 * evaluate them by runtime/table/law.h (docs/internals.md). */
#ifndef COR_GEN_TABLES_LAW_HEADER_H
#define COR_GEN_TABLES_LAW_HEADER_H

#include <stdio.h>

#include "series/law.h"

enum { LAW_NAME_MAX = 48 };

/* Writes the header of `corgen law`, which needs no other file, with functions NAME_eps_zero_overlap, ... The name is a
 * C identifier of at most LAW_NAME_MAX characters. Returns STATUS_OK, or another status after reporting the failure. */
int law_header_write(FILE *file, const struct law *law, const char *name);

/* generated/hertz_dashpot_tables.h, the law (3/2, 0) */
int hertz_dashpot_tables_write(FILE *file);

#endif
