/* SPDX-License-Identifier: MIT */
/* Speed of the disk functions, error beside every time. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <cor/status.h>

#include "disk.h"
#include "support/table.h"

void disk_must(int status, int other)
{
    if (status != COR_OK && status != other) {
        fprintf(stderr, "bench: %s\n", cor_status_text(status));
        exit(1);
    }
}

void disk_csv(struct disk_bench *bench, const struct disk_row *row)
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

int main(int argc, char **argv)
{
    struct disk_bench bench = {.timing = {.sample_ns = 4e5, .rounds = 64, .slow_share = 16}};
    struct cor_disk_modes modes;
    bench.quick = argc == 4 && strcmp(argv[3], "--quick") == 0;
    if (argc != 3 + bench.quick) {
        fprintf(stderr, "usage: cor_bench_disk DIRECTORY MODES [--quick]\n"
                        "DIRECTORY receives disks.csv; MODES: 20000 modes of nu = 0.33 from corgen tables\n");
        return 2;
    }
    if (bench.quick)
        bench.timing.rounds = 16;
    disk_must(cor_disk_modes_read(argv[2], NULL, 0, &modes, NULL), COR_ERROR_CAPACITY);
    const size_t count = modes.count;
    struct cor_disk_mode *const mode = malloc(count * sizeof *mode);
    disk_must(mode ? COR_OK : COR_ERROR_MEMORY, COR_OK);
    disk_must(cor_disk_modes_read(argv[2], mode, count, &modes, NULL), COR_OK);
    bench.all = &modes;
    bench.csv = table_open(argv[1], "disks.csv", "table,method,speed,setting,modes,seconds,error");

    disk_rayleigh(&bench);
    disk_collision(&bench);

    table_close(bench.csv);
    free(mode);
    return 0;
}
