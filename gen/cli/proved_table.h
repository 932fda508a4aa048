/* SPDX-License-Identifier: MIT */
/* A table of proved digits, filled with more and more bits until every digit is decided, and then printed. A table of
 * exact numbers is filled once. */
#ifndef COR_GEN_CLI_PROVED_TABLE_H
#define COR_GEN_CLI_PROVED_TABLE_H

#include "cli/options.h"

enum { PROVED_TABLE_NAME = 64 };

struct proved_table {
    slong digits;
    const void *arguments; /* for `fill` */
    /* Initialises a table and fills it, computing with `bits` bits. Returns STATUS_OK or STATUS_FAILED. `undecided`
     * stays empty, or becomes the name of the first number whose digits are undecided. */
    int (*fill)(struct table *table, char undecided[PROVED_TABLE_NAME], const void *arguments, slong bits);
    /* prints FORMAT_TEXT and FORMAT_LATEX; NULL: the common text format */
    void (*print_text)(FILE *file, const struct table *table, const void *arguments);
};

/* Returns the exit status. */
int proved_table_write(const struct proved_table *proved, const struct option_common *common);

#endif
