/* SPDX-License-Identifier: MIT */
/* The modes of one material as a C header and as a file to load, both with the doubles nearest to the exact values. */
#ifndef COR_GEN_TABLES_DISK_H
#define COR_GEN_TABLES_DISK_H

#include <stdbool.h>
#include <stdio.h>

#include "support/decimal.h"

enum { DISK_TABLE_MODES = 1800, DISK_TABLE_POISSON = 60 /* characters */, DISK_TABLE_NAME = 160 };

struct disk_table {
    struct decimal poisson; /* file names and comments contain its text unchanged */
    slong count;
    bool embed; /* also for C++, with decimal doubles */
};

/* The table's name in C and in file names, as in disk_modes_nu033.h */
const char *disk_table_name(char name[DISK_TABLE_NAME], const struct disk_table *table, const char *extension);

/* Each returns STATUS_OK, or STATUS_FAILED after reporting the reason. Both keep the modes of the last table until
 * disk_tables_clear, so that both forms need one computation. */
int disk_header_write(FILE *file, const struct disk_table *table);
int disk_file_write(FILE *file, const struct disk_table *table);
void disk_tables_clear(void);

#endif
