/* SPDX-License-Identifier: MIT */
/* The modes of one material as a C header and as a file to load, both with the doubles nearest to the exact values. */
#ifndef COR_GEN_TABLES_DISK_H
#define COR_GEN_TABLES_DISK_H

#include <stdbool.h>
#include <stdio.h>

#include "support/decimal.h"

enum { DISK_TABLE_MODES = 1800, DISK_TABLE_POISSON = 60 /* characters */, DISK_TABLE_NAME = 160 };

struct disk_table {
    struct decimal poisson; /* file names and comments have it as it is written */
    slong count;
    bool embed; /* for C++ too: decimal doubles */
};

/* disk_modes_nu033.h: what nu is called in names of files and of C. */
const char *disk_table_name(char name[DISK_TABLE_NAME], const struct disk_table *table, const char *extension);

/* Each returns STATUS_OK, or STATUS_FAILED after saying why. The modes of the last table are kept, so that both forms cost
 * one computation, until disk_tables_clear. */
int disk_header_write(FILE *file, const struct disk_table *table);
int disk_file_write(FILE *file, const struct disk_table *table);
void disk_tables_clear(void);

#endif
