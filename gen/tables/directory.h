/* SPDX-License-Identifier: MIT */
/* A directory of tables: everything in generated/, or the mode tables of one material; written, or proved to be what
 * corgen would write. A new file is a new row of files[] and one function that writes it to a stream. */
#ifndef COR_GEN_TABLES_DIRECTORY_H
#define COR_GEN_TABLES_DIRECTORY_H

#include <stdbool.h>
#include <stdint.h>

#include "support/decimal.h"

#define TABLES_MAX_SEED 1000000000

struct tables_request {
    const struct decimal *poisson; /* of the one material; NULL: generated/ */
    slong modes;                   /* of that material; 0: DISK_TABLE_MODES */
    const char *directory;         /* NULL: generated, or the current one for a material */
    bool check;                    /* compare, write nothing */
    bool all;                      /* collide at all places of disk_limits.h */
    bool seeded;                   /* `seed` chooses the places at which a check collides; otherwise the time does */
    uint64_t seed;
};

/* STATUS_OK, or another status after a sentence. */
int tables_run(const struct tables_request *request);

#endif
