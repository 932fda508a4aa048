/* SPDX-License-Identifier: MIT */
/* Speed of the disk functions, with the error next to every time. */
#include <stdlib.h>
#include <string.h>

#include "disk.h"

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
