/* SPDX-License-Identifier: MIT */
#include "disk.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support/table.h"

void disk_must(int condition, const char *message)
{
    if (!condition) {
        fprintf(stderr, "bench: %s\n", message);
        exit(1);
    }
}

enum { CACHE_LINE = 64 };

void *disk_memory(size_t n, size_t size)
{
    const size_t bytes = (n * size + CACHE_LINE - 1) / CACHE_LINE * CACHE_LINE;
    void *const memory = aligned_alloc(CACHE_LINE, bytes);
    disk_must(memory != NULL, "no memory");
    return memset(memory, 0, bytes);
}

void disk_csv(struct disk_bench *bench, const struct disk_row *row)
{
    FILE *const files[2] = {bench->csv, stdout};
    disk_must(!strchr(row->table, ',') && !strchr(row->method, ','), "a comma in a cell");
    for (int i = 0; i < 2; i++) {
        fprintf(files[i], "%s,%s", row->table, row->method);
        table_number(files[i], "%.6g", row->speed);
        table_number(files[i], "%.4g", row->setting);
        table_number(files[i], "%.0f", row->modes ? (double)row->modes : NAN);
        table_number(files[i], "%.4g", row->seconds);
        table_number(files[i], "%.2e", row->error);
        fputc('\n', files[i]);
    }
    fflush(stdout);
}

long double disk_constant_b(double nu)
{
    return -2 * logl(2) - (1 + (long double)nu) / 4;
}
