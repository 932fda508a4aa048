/* SPDX-License-Identifier: MIT */
/* What the benchmarks of disks share. */
#ifndef COR_BENCH_DISKS_DISK_H
#define COR_BENCH_DISKS_DISK_H

#include <stdio.h>

#include <cor/disk.h>

#include "support/timing.h"

struct disk_bench {
    FILE *csv;
    const char *directory;            /* for files to be read */
    const char *modes_file;           /* 1800 modes of nu = 0.33 that corgen wrote; NULL: this program writes it */
    const struct cor_disk_modes *all; /* many more modes of nu = 0.33; NULL: none */
    int quick, report;                /* report: the work-precision curves, in a quick run too */
    int missed;                       /* targets */
    struct timing timing;
};

/* A line of disk.csv; NaN and 0 modes leave their field empty. The error is relative. */
struct disk_row {
    const char *table, *method;
    double speed, setting; /* setting: a tolerance, a panel's points, a step, alpha, or angles */
    size_t modes;
    double seconds, error;
};

void disk_csv(struct disk_bench *bench, const struct disk_row *row);

/* Prints that a target is missed, at the end of a line. */
void disk_judge(struct disk_bench *bench, const char *what, int met);

/* Exits with the message if the condition is false. */
void disk_must(int condition, const char *message);

/* Memory full of zeros from the begin of a cache line, or exits; for free(). */
void *disk_memory(size_t n, size_t size);

/* The constant b of the contact law measured from the centre of mass */
long double disk_constant_b(double nu);

/* The tables, one file each. */
void disk_loading(struct disk_bench *bench);
void disk_law(struct disk_bench *bench);
void disk_rayleigh(struct disk_bench *bench);
void disk_tolerance(struct disk_bench *bench);
void disk_curves(struct disk_bench *bench);
void disk_collision(struct disk_bench *bench);
void disk_hard_wall(struct disk_bench *bench);

#endif
