/* SPDX-License-Identifier: MIT */
/* Loading 1800 modes, against what a user would write and against reading the bytes. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include <cor/status.h>

#include "disk.h"

enum { MODES = 1800, LINE = 256 };

struct load {
    const char *path;
    struct cor_disk_mode mode[MODES];
    size_t count;
    char *bytes;
    size_t room;
};

static void with_cor(void *closure)
{
    struct load *const load = closure;
    struct cor_disk_modes modes;
    load->count = cor_disk_modes_read(load->path, load->mode, MODES, &modes, NULL) == COR_OK ? modes.count : 0;
}

/* The mode lines of a mode file, or lines of five numbers with commas between them; nothing is checked. */
static void with_sscanf(void *closure)
{
    struct load *const load = closure;
    FILE *const file = fopen(load->path, "r");
    char line[LINE];
    load->count = 0;
    while (file && load->count < MODES && fgets(line, sizeof line, file)) {
        struct cor_disk_mode *const m = &load->mode[load->count];
        const char *const format = line[0] == 'm' ? "mode %d %d %lf %lf %lf" : "%d,%d,%lf,%lf,%lf";
        load->count += sscanf(line, format, &m->n, &m->l, &m->omega, &m->c, &m->s) == 5;
    }
    if (file)
        fclose(file);
}

static void bytes_only(void *closure)
{
    struct load *const load = closure;
    FILE *const file = fopen(load->path, "rb");
    load->count = file && fread(load->bytes, 1, load->room, file) > 0 ? MODES : 0;
    if (file)
        fclose(file);
}

/* Largest relative error of a number read; 0 for the bytes alone. */
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

/* ---- files, where corgen has written none ---- */

static uint32_t hash(uint32_t check, const char *text)
{
    for (; *text; text++)
        check = (check ^ (unsigned char)*text) * UINT32_C(16777619);
    return check;
}

/* A line that ends in a space, and its check */
static void put_line(FILE *file, uint32_t *check, const char *line)
{
    char end[16];
    *check = hash(*check, line);
    snprintf(end, sizeof end, "%08lx\n", (unsigned long)*check);
    *check = hash(*check, end);
    fprintf(file, "%s%s", line, end);
}

/* As docs/mode-file.md has it */
static void write_mode_file(FILE *file)
{
    uint32_t check = UINT32_C(2166136261);
    char line[LINE];
    put_line(file, &check, "cor-disk-modes 1 ");
    put_line(file, &check, "source cor_bench_disk ");
    put_line(file, &check, "poisson 0x1.51eb851eb851fp-2 0.33 ");
    put_line(file, &check, "modes 1800 ");
    for (int i = 0; i < MODES; i++) {
        const struct cor_disk_mode *const m = &cor_disk_modes_nu033.mode[i];
        snprintf(line, sizeof line, "mode %d %d %a %a %a ", m->n, m->l, m->omega, m->c, m->s);
        put_line(file, &check, line);
    }
    put_line(file, &check, "end ");
}

static void write_decimal_file(FILE *file)
{
    for (int i = 0; i < MODES; i++) {
        const struct cor_disk_mode *const m = &cor_disk_modes_nu033.mode[i];
        fprintf(file, "%d,%d,%.17g,%.17g,%.17g\n", m->n, m->l, m->omega, m->c, m->s);
    }
}

static void make(const char *path, void write(FILE *))
{
    FILE *const file = fopen(path, "w");
    disk_must(file != NULL, "cannot write a file of modes");
    write(file);
    disk_must(fclose(file) == 0, "cannot write a file of modes");
}

void disk_loading(struct disk_bench *bench)
{
    static struct load load[4];
    static char written[4096], decimal[4096];
    snprintf(written, sizeof written, "%s/disk_modes.txt", bench->directory);
    snprintf(decimal, sizeof decimal, "%s/disk_modes.csv", bench->directory);
    make(decimal, write_decimal_file);
    if (!bench->modes_file)
        make(written, write_mode_file);
    const char *const path = bench->modes_file ? bench->modes_file : written;
    const struct {
        const char *name;
        void (*run)(void *);
        const char *path;
    } row[4] = {{"cor_disk_modes_read (checks every line)", with_cor, path},
                {"fgets and sscanf %lf of the same file", with_sscanf, path},
                {"fgets and sscanf %lf of decimal numbers", with_sscanf, decimal},
                {"fread of the bytes alone", bytes_only, path}};
    enum { ROWS = sizeof row / sizeof *row };
    struct job job[ROWS];
    for (int i = 0; i < ROWS; i++) {
        load[i].path = row[i].path;
        if (row[i].run == bytes_only)
            load[i].bytes = disk_memory(load[i].room = 1 << 20, 1);
        job[i] = (struct job){row[i].run, &load[i], 1, NAN};
    }
    timing_measure(job, ROWS, bench->timing);

    printf("loading 1800 modes%s\n", bench->modes_file ? ", a file of corgen tables" : "");
    printf("%-46s %9s %8s %10s\n", "", "ms", "ratio", "max error");
    for (int i = 0; i < ROWS; i++) {
        const double error = row[i].run == bytes_only ? NAN : error_of(&load[i]);
        disk_must(load[i].count == MODES, "modes are missing in a file");
        printf("%-46s %9.3f %8.2f", row[i].name, job[i].best_ns / 1e6, job[i].best_ns / job[0].best_ns);
        if (!isnan(error))
            printf(" %10.1e", error);
        if (i == 0)
            disk_judge(bench, "1 ms", job[i].best_ns < 1e6);
        printf("\n");
        disk_csv(bench, &(struct disk_row){"loading", row[i].name, NAN, NAN, MODES, job[i].best_ns / 1e9, error});
        free(load[i].bytes);
    }
    printf("\n");
}
