/* SPDX-License-Identifier: MIT */
/* Speed of the disk functions, error beside every time. */
#include <stdlib.h>
#include <string.h>

#include <cor/status.h>

#include "stages.h"
#include "support/table.h"

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
    fprintf(stderr, "usage: cor_bench_disk DIRECTORY [--quick] [--modes FILE] [--all FILE]\n"
                    "DIRECTORY receives disks.csv; FILE: modes of nu = 0.33 from corgen tables, 1800 and many more\n");
    return 2;
}

int main(int argc, char **argv)
{
    struct disk_bench bench = {.timing = {.sample_ns = 4e5, .rounds = 64, .slow_share = 16}};
    if (argc < 2)
        return usage();
    for (int i = 2; i < argc; i++) {
        if (strcmp(argv[i], "--quick") == 0)
            bench.quick = 1;
        else if (strcmp(argv[i], "--modes") == 0 && i + 1 < argc)
            bench.modes_file = argv[++i];
        else if (strcmp(argv[i], "--all") == 0 && i + 1 < argc)
            disk_must((bench.all = read_all(argv[++i])) != NULL, "cannot read the file of all modes");
        else
            return usage();
    }
    if (bench.quick)
        bench.timing.rounds = 16;
    bench.csv = table_open(argv[1], "disks.csv", "table,method,speed,setting,modes,seconds,error");

    disk_rayleigh(&bench);
    disk_tolerance(&bench);
    disk_curves(&bench);
    disk_loading(&bench);
    collision_curves(&bench);
    collision_models(&bench);
    disk_hard_wall(&bench);

    table_close(bench.csv);
    if (bench.all)
        free((void *)(size_t)bench.all->mode);
    return 0;
}
