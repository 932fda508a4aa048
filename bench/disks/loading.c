/* SPDX-License-Identifier: MIT */
/* Loading 1800 modes, against what a user would write. */
#include <math.h>

#include <cor/status.h>

#include "stages.h"

enum { MODES = 1800, LINE = 256 };

struct load {
    const char *path;
    struct cor_disk_mode mode[MODES];
    size_t count;
};

static void with_cor(void *closure)
{
    struct load *const load = closure;
    struct cor_disk_modes modes;
    load->count = cor_disk_modes_read(load->path, load->mode, MODES, &modes, NULL) == COR_OK ? modes.count : 0;
}

/* The mode lines of a mode file; nothing is checked. */
static void with_sscanf(void *closure)
{
    struct load *const load = closure;
    FILE *const file = fopen(load->path, "r");
    char line[LINE];
    load->count = 0;
    while (file && load->count < MODES && fgets(line, sizeof line, file)) {
        struct cor_disk_mode *const m = &load->mode[load->count];
        load->count += sscanf(line, "mode %d %d %lf %lf %lf", &m->n, &m->l, &m->omega, &m->c, &m->s) == 5;
    }
    if (file)
        fclose(file);
}

/* Largest relative error of a number read. */
static double error_of(const struct load *load)
{
    double worst = load->count == MODES ? 0 : NAN;
    for (size_t i = 0; i < load->count; i++) {
        const struct cor_disk_mode *const exact = &cor_disk_modes_nu033.mode[i], *const m = &load->mode[i];
        const double error[] = {fabs(m->omega / exact->omega - 1), fabs(m->c / exact->c - 1),
                                exact->s != 0 ? fabs(m->s / exact->s - 1) : fabs(m->s)};
        for (int k = 0; k < 3; k++)
            if (!(error[k] <= worst)) /* a NaN too */
                worst = error[k];
    }
    return worst;
}

void disk_loading(struct disk_bench *bench)
{
    enum { WAYS = 2 };
    static const char *const way[WAYS] = {"cor_disk_modes_read", "fgets and sscanf"};
    static struct load load[WAYS];
    if (!bench->modes_file)
        return;
    load[0].path = load[1].path = bench->modes_file;
    struct job job[WAYS] = {{with_cor, &load[0], 1, NAN}, {with_sscanf, &load[1], 1, NAN}};
    timing_measure(job, WAYS, bench->timing);
    for (int i = 0; i < WAYS; i++) {
        disk_must(load[i].count == MODES, "modes are missing in a file");
        disk_csv(bench,
                 &(struct disk_row){"loading", way[i], NAN, NAN, MODES, job[i].best_ns / 1e9, error_of(&load[i])});
    }
}
