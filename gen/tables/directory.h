/* SPDX-License-Identifier: MIT */
/* A directory of tables: all files of generated/, or the mode tables of one material. corgen writes the files, or
 * checks that it would write the same bytes. A new file needs a new row of files[] and a function that writes it to a
 * stream. */
#ifndef COR_GEN_TABLES_DIRECTORY_H
#define COR_GEN_TABLES_DIRECTORY_H

#include <stdbool.h>

#include "support/decimal.h"

#define TABLES_MAX_SEED 1000000000

struct tables_request {
    struct decimal poisson; /* Poisson's ratio of the material; text NULL: generated/ */
    slong modes;            /* number of modes of that material; 0: DISK_TABLE_MODES */
    const char *directory;  /* NULL: generated, or the current directory for a material */
    bool check;             /* compare without writing */
    bool digits;            /* write the digits of the coefficients to standard output instead, as csv */
    bool all;               /* compute the collisions at all points of disk_limits.h */
    slong seed;             /* chooses the points at which a check recomputes collisions; below 0: the time does */
};

/* Returns STATUS_OK, or another status after a message. */
int tables_run(const struct tables_request *request);

#endif
