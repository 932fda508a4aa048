/* SPDX-License-Identifier: MIT */
#include "table.h"

#include <math.h>
#include <stdlib.h>

static void require(int condition, const char *what)
{
    if (!condition) {
        fprintf(stderr, "bench: cannot write %s\n", what);
        exit(1);
    }
}

FILE *table_open(const char *directory, const char *name, const char *heading)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", directory, name);
    FILE *const file = fopen(path, "w");
    require(file != NULL, path);
    fprintf(file, "%s\n", heading);
    return file;
}

void table_close(FILE *file)
{
    const int failed = ferror(file);
    require(fclose(file) == 0 && !failed, "a table");
}

void table_number(FILE *file, const char *format, double value)
{
    fputc(',', file);
    if (!isnan(value))
        fprintf(file, format, value);
}
