/* SPDX-License-Identifier: MIT */
/* The tables that the benchmarks write: csv files. What cannot be written ends the program with a message. */
#ifndef COR_BENCH_SUPPORT_TABLE_H
#define COR_BENCH_SUPPORT_TABLE_H

#include <stdio.h>

/* DIRECTORY/NAME, which begins with the heading */
FILE *table_open(const char *directory, const char *name, const char *heading);
void table_close(FILE *file);

/* One more cell: a comma, and the number unless it is NaN */
void table_number(FILE *file, const char *format, double value);

#endif
