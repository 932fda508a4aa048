/* SPDX-License-Identifier: MIT */
/* The tables that the benchmarks write: csv files. A failure to write ends the program with a message. */
#ifndef COR_BENCH_SUPPORT_TABLE_H
#define COR_BENCH_SUPPORT_TABLE_H

#include <stdio.h>

/* Opens DIRECTORY/NAME and writes the heading. */
FILE *table_open(const char *directory, const char *name, const char *heading);
void table_close(FILE *file);

/* Writes one more cell: a comma, and the number unless it is NaN. */
void table_number(FILE *file, const char *format, double value);

#endif
