/* SPDX-License-Identifier: MIT */
/* A table of proved digits: filled with more and more bits until every digit is decided, then printed. */
#ifndef COR_GEN_CLI_PROVED_TABLE_H
#define COR_GEN_CLI_PROVED_TABLE_H

#include "cli/options.h"

enum { PROVED_TABLE_NAME = 64 };

struct proved_table {
    slong digits;
    const void *arguments; /* for `fill` */
    /* Fills a table that it initialises, computing with so many bits. STATUS_OK or STATUS_FAILED; `undecided` stays empty,
     * or names the first number whose digits are not decided yet. */
    int (*fill)(struct table *table, char undecided[PROVED_TABLE_NAME], const void *arguments, slong bits);
    void (*print_text)(FILE *file, const struct table *table); /* FORMAT_TEXT; NULL: as every table */
};

/* Exit status. */
int proved_table_write(const struct proved_table *proved, const struct option_common *common);

#endif
