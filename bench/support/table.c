/* SPDX-License-Identifier: MIT */
#include "table.h"

#include <math.h>
#include <stdlib.h>

FILE *table_open(const char *directory, const char *name, const char *heading)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", directory, name);
    FILE *const file = fopen(path, "w");
    if (!file || fprintf(file, "%s\n", heading) < 0) {
        fprintf(stderr, "bench: cannot write %s\n", path);
        exit(1);
    }
    return file;
}

void table_close(FILE *file)
{
    const int failed = ferror(file);
    if (fclose(file) != 0 || failed) {
        fprintf(stderr, "bench: cannot write a table\n");
        exit(1);
    }
}

void table_number(FILE *file, const char *format, double value)
{
    fputc(',', file);
    if (!isnan(value))
        fprintf(file, format, value);
}
