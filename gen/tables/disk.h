/* SPDX-License-Identifier: MIT */
/* The modes of one material as a C header and as a file to load, both with the doubles nearest to the exact values. */
#ifndef COR_GEN_TABLES_DISK_H
#define COR_GEN_TABLES_DISK_H

#include <stdbool.h>
#include <stdio.h>

#include "disk/modes.h"
#include "support/decimal.h"

enum { DISK_TABLE_MODES = 1800, DISK_TABLE_POISSON = 60 /* characters */, DISK_TABLE_NAME = 160 };

struct disk_table {
    struct decimal poisson; /* not owned; file names and comments contain its text unchanged */
    slong count;
    bool embed; /* also for C++, with decimal doubles */
    struct disk_modes modes;
};

/* The table's name in C and in file names, as in disk_modes_nu033.h */
const char *disk_table_name(char name[DISK_TABLE_NAME], const struct disk_table *table, const char *extension);

/* Finds the modes, which begin as {0}, and writes them. Each returns STATUS_OK, or STATUS_FAILED after reporting the
 * reason. Call disk_modes_clear(&table->modes) in either case. */
int disk_table_solve(struct disk_table *table);
int disk_header_write(FILE *file, const struct disk_table *table);
int disk_file_write(FILE *file, const struct disk_table *table);

#endif
