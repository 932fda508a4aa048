/* SPDX-License-Identifier: MIT */
/* Declarations that the benchmarks of disks share. */
#ifndef COR_BENCH_DISKS_DISK_H
#define COR_BENCH_DISKS_DISK_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <cor/disk.h>
#include <cor/status.h>

#include "support/table.h"
#include "support/timing.h"

struct disk_bench {
    FILE *csv;
    const struct cor_disk_modes *all; /* modes of nu = 0.33, many more than the library has */
    int quick;
    struct timing timing;
};

/* Each function writes rows of disks.csv. disk_rayleigh: the energy of 1800 modes at low to high speeds, and error
 * against time. disk_collision: error against time, and the errors of fewer modes and softer walls. */
void disk_rayleigh(struct disk_bench *bench);
void disk_collision(struct disk_bench *bench);

/* A line of disks.csv. The program also prints it. NaN and 0 modes become empty fields. Errors of collisions are
 * absolute errors of eps; all others are relative. */
struct disk_row {
    const char *table, *method;
    double speed, setting; /* setting: a tolerance, the points of a panel, or alpha */
    size_t modes;
    double seconds, error;
};

static inline void disk_csv(struct disk_bench *bench, const struct disk_row *row)
{
    FILE *const files[2] = {bench->csv, stdout};
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

/* Prints the text of the status and exits, unless the status is COR_OK or `other`. */
static inline void disk_must(int status, int other)
{
    if (status != COR_OK && status != other) {
        fprintf(stderr, "bench: %s\n", cor_status_text(status));
        exit(1);
    }
}

#endif
