/* SPDX-License-Identifier: MIT */
/* Speed of the disk functions, error beside every time. */
#include "collision.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <cor/status.h>

void disk_must(int condition, const char *message)
{
    if (!condition) {
        fprintf(stderr, "bench: %s\n", message);
        exit(1);
    }
}

void disk_judge(struct disk_bench *bench, const char *what, int met)
{
    if (!met) {
        printf("  missed: %s", what);
        bench->missed++;
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

static void field(FILE *file, const char *format, double value)
{
    fputc(',', file);
    if (!isnan(value))
        fprintf(file, format, value);
}

void disk_csv(struct disk_bench *bench, const struct disk_row *row)
{
    fprintf(bench->csv, "%s,%s", row->table, row->method);
    field(bench->csv, "%.6g", row->speed);
    field(bench->csv, "%.3g", row->setting);
    field(bench->csv, "%.0f", row->modes ? (double)row->modes : NAN);
    field(bench->csv, "%.4g", row->seconds);
    field(bench->csv, "%.2e", row->error);
    fputc('\n', bench->csv);
}

long double disk_constant_b(double nu)
{
    return -2 * logl(2) - (1 + (long double)nu) / 4;
}

/* Modes from a file that may not be there. */
static const struct cor_disk_modes *read_all(const char *path)
{
    static struct cor_disk_modes modes;
    if (cor_disk_modes_read(path, NULL, 0, &modes, NULL) != COR_ERROR_CAPACITY)
        return NULL;
    const size_t capacity = modes.count;
    struct cor_disk_mode *const mode = disk_memory(capacity, sizeof *mode);
    const int status = cor_disk_modes_read(path, mode, capacity, &modes, NULL);
    disk_must(status == COR_OK, cor_status_text(status));
    return &modes;
}

static int usage(void)
{
    fprintf(stderr, "usage: cor_bench_disk DIRECTORY [--quick] [--collisions | --report] [--modes FILE] [--all FILE]\n"
                    "--collisions: these alone; --report: error against time alone\n"
                    "DIRECTORY receives disk.csv; FILE: modes of nu = 0.33 from corgen tables, 1800 and many more\n");
    return 2;
}

int main(int argc, char **argv)
{
    struct disk_bench bench = {.timing = {.sample_ns = 4e5, .rounds = 64, .slow_share = 16}};
    int collisions = 0;
    if (argc < 2)
        return usage();
    for (int i = 2; i < argc; i++) {
        if (strcmp(argv[i], "--quick") == 0)
            bench.quick = 1;
        else if (strcmp(argv[i], "--collisions") == 0)
            collisions = 1;
        else if (strcmp(argv[i], "--report") == 0)
            bench.report = 1;
        else if (strcmp(argv[i], "--modes") == 0 && i + 1 < argc)
            bench.modes_file = argv[++i];
        else if (strcmp(argv[i], "--all") == 0 && i + 1 < argc)
            disk_must((bench.all = read_all(argv[++i])) != NULL, "cannot read the file of all modes");
        else
            return usage();
    }
    if (bench.quick)
        bench.timing.rounds = 16;
    bench.directory = argv[1];
    char path[4096];
    snprintf(path, sizeof path, "%s/disk.csv", bench.directory);
    bench.csv = fopen(path, "w");
    disk_must(bench.csv != NULL, "cannot write disk.csv");
    fprintf(bench.csv, "table,method,speed,setting,modes,seconds,max_relative_error\n");

    if (bench.report) {
        disk_curves(&bench);
        collision_curves(&bench);
        collision_models(&bench);
    } else if (!collisions) {
        disk_rayleigh(&bench);
        disk_tolerance(&bench);
        disk_curves(&bench);
        disk_loading(&bench);
        disk_law(&bench);
    }
    if (!bench.report) {
        disk_hard_wall(&bench);
        disk_collision(&bench);
    }
    printf("disks: %d targets missed\n\n", bench.missed);

    const int failed = ferror(bench.csv);
    disk_must(fclose(bench.csv) == 0 && !failed, "cannot write disk.csv");
    if (bench.all)
        free((void *)(size_t)bench.all->mode);
    return 0;
}
