/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* open_memstream, mkdir */
#include "tables/files.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "runtime/disk/mode_file.h"
#include "support/console.h"
#include "support/output.h"

#define DEFAULT_DIRECTORY "generated"
#define DEFAULT_DIRECTORY_OF_MATERIAL "."
#define MANIFEST "MANIFEST.txt"
#define MANIFEST_VERSION_WORD "made-with" /* --check ignores lines that start with this word */

struct generated {
    const char *name;
    int (*write)(FILE *file);
    const char *poisson; /* Poisson's ratio of a table of modes, whose `write` is NULL; NULL for other files */
};

static const struct generated files[] = {
    {"cor_sphere.h", sphere_header_write, NULL},
    {"sphere_rows.h", sphere_rows_write, NULL},
    {"sphere_float_tables.h", sphere_float_tables_write, NULL},
    {"hertz_dashpot_tables.h", hertz_dashpot_tables_write, NULL},
    {"closed_form_tables.h", closed_form_tables_write, NULL},
    {"tsuji_tables.h", tsuji_tables_write, NULL},
    {"hunt_crossley_tables.h", hunt_crossley_tables_write, NULL},
    {"wave_tables.h", wave_tables_write, NULL},
    {"disk_law_tables.h", disk_law_tables_write, NULL},
    {"disk_modes_nu033.h", NULL, "0.33"},
    {"disk_modes_nu090.h", NULL, "0.90"},
};
enum { FILES = sizeof files / sizeof *files, CONTENTS = FILES + 2 /* with disk_limits.h and the manifest */ };

/* The files of one material */
static const struct {
    const char *extension;
    int (*write)(FILE *file, const struct disk_table *disk);
} material_file[] = {{"h", disk_header_write}, {"txt", disk_file_write}};
enum { MATERIAL_FILES = sizeof material_file / sizeof *material_file };

/* One complete file in memory */
struct content {
    const char *name;
    char *text;
    size_t size;
};

static int disk_write(FILE *file, const char *poisson)
{
    struct disk_table disk = {.count = DISK_TABLE_MODES};
    decimal_set(&disk.poisson, poisson);
    int status = disk_table_solve(&disk);
    if (status == STATUS_OK)
        status = disk_header_write(file, &disk);
    disk_modes_clear(&disk.modes);
    decimal_clear(&disk.poisson);
    return status;
}

/* Opens a file in memory. content_close returns the status of the writes. */
static FILE *content_open(struct content *c, const char *name)
{
    c->name = name;
    profile_step(name);
    return open_memstream(&c->text, &c->size);
}

static int content_close(const struct content *c, FILE *file, int status)
{
    profile_step(NULL);
    return fclose(file) == 0 || status != STATUS_OK ? status : fail("out of memory for %s", c->name);
}

/* Writes a file of generated/ to memory. */
static int generated_make(struct content *c, const struct generated *row)
{
    FILE *const file = content_open(c, row->name);
    return content_close(c, file, row->poisson ? disk_write(file, row->poisson) : row->write(file));
}

static int manifest_make(struct content *manifest, const struct content *c, int files_made)
{
    FILE *const file = content_open(manifest, MANIFEST);
    fprintf(file, "Written by `corgen tables`; `corgen tables --check` compares the files below byte for "
                  "byte.\nLines that start with " MANIFEST_VERSION_WORD
                  " name the libraries of corgen and are not compared.\n\n");
    for (int i = 0; i < files_made; i++) {
        long lines = 0;
        for (size_t k = 0; k < c[i].size; k++)
            lines += c[i].text[k] == '\n';
        fprintf(file, "file %s %zu bytes %ld lines check %08" PRIx32 "\n", c[i].name, c[i].size, lines,
                cor_mode_file_check(COR_MODE_FILE_CHECK_START, c[i].text, c[i].size));
    }
    fprintf(file, "\n" MANIFEST_VERSION_WORD " FLINT %s\n", flint_version);
#ifndef COR_FLINT_HAS_ARB
    fprintf(file, MANIFEST_VERSION_WORD " Arb %s\n", arb_version);
#endif
    fprintf(file, MANIFEST_VERSION_WORD " MPFR %s\n" MANIFEST_VERSION_WORD " GMP %s\n", mpfr_get_version(),
            gmp_version);
    return content_close(manifest, file, STATUS_OK);
}

/* Checks that the files can be written, before minutes of computation. Leaves no files. */
static int probe_directory(const char *directory, const struct tables_request *request)
{
    const struct disk_table disk = {.poisson = request->poisson};
    char name[DISK_TABLE_NAME];
    if (mkdir(directory, 0777) == 0) {
        rmdir(directory);
        return STATUS_OK;
    }
    if (errno != EEXIST)
        return fail("cannot make %s: %s", directory, strerror(errno));
    int status = STATUS_OK;
    for (int i = 0; i < (disk.poisson.text ? MATERIAL_FILES : CONTENTS) && status == STATUS_OK; i++) {
        char *const path = xprintf("%s/%s", directory,
                                   disk.poisson.text ? disk_table_name(name, &disk, material_file[i].extension)
                                   : i < FILES       ? files[i].name
                                   : i == FILES      ? DISK_LIMITS_FILE
                                                     : MANIFEST);
        status = output_check(path);
        free(path);
    }
    return status;
}

static int write_all(const struct content *c, int n, const char *directory)
{
    char *path[CONTENTS] = {NULL};
    struct output out[CONTENTS] = {{.file = NULL}};
    int status = STATUS_OK;
    if (mkdir(directory, 0777) && errno != EEXIST)
        return fail("cannot make %s: %s", directory, strerror(errno));
    for (int i = 0; i < n && status == STATUS_OK; i++) {
        path[i] = xprintf("%s/%s", directory, c[i].name);
        status = output_open(&out[i], path[i]);
        if (status == STATUS_OK)
            fwrite(c[i].text, 1, c[i].size, out[i].file); /* output_commit reports a failure */
    }
    if (status == STATUS_OK)
        status = output_commit_all(out, n);
    for (int i = 0; i < n; i++) {
        output_discard(&out[i]); /* files that were not committed */
        free(path[i]);
    }
    return status;
}

/* Skips lines that are not compared, and returns the rest of the text. */
static const char *skip_versions(const char *at)
{
    while (strncmp(at, MANIFEST_VERSION_WORD, strlen(MANIFEST_VERSION_WORD)) == 0)
        at += strcspn(at, "\n") + (at[strcspn(at, "\n")] == '\n');
    return at;
}

/* Returns the number of the first line in which the file differs from the expected text, or 0. */
static long first_difference(const struct content *c, const char *text, size_t size)
{
    const char *made = skip_versions(c->text), *found = skip_versions(text);
    while (*made && *made == *found) {
        const bool line_ends = *made == '\n';
        made = line_ends ? skip_versions(made + 1) : made + 1;
        found = line_ends ? skip_versions(found + 1) : found + 1;
    }
    if (!*made && found == text + size)
        return 0;
    long line = 1;
    while (text < found)
        line += *text++ == '\n';
    return line;
}

static int check_all(const struct content *c, int n, const char *directory)
{
    int status = STATUS_OK;
    for (int i = 0; i < n; i++) {
        size_t size = 0;
        char *const path = xprintf("%s/%s", directory, c[i].name), *const text = read_file(path, SIZE_MAX, &size);
        const long line = text ? first_difference(&c[i], text, size) : 0;
        if (!text)
            status = fail("cannot read %s: %s", path, strerror(errno));
        else if (line)
            status = fail("%s, line %ld, differs from the output of corgen; corgen tables writes the file again", path,
                          line);
        free(text);
        free(path);
    }
    return status;
}

/* Makes the file of the collisions in memory, from a new computation, the copy in corgen or the directory. */
static int limits_make(struct content *c, const struct tables_request *request, const char *directory)
{
    const struct generated row = {DISK_LIMITS_FILE, disk_limits_write, NULL};
    profile_step(DISK_LIMITS_FILE);
    if (request->all && !request->check && disk_limits_collide() != STATUS_OK)
        return STATUS_FAILED;
    if (disk_limits_known(NULL))
        return generated_make(c, &row);
    c->name = DISK_LIMITS_FILE;
    char *const path = xprintf("%s/%s", directory, DISK_LIMITS_FILE);
    c->text = read_file(path, SIZE_MAX, &c->size);
    const int status =
        c->text ? STATUS_OK : fail("cannot read %s: %s; corgen tables --all computes it", path, strerror(errno));
    free(path);
    return status;
}

/* Writes the files of generated/ and their manifest to memory. */
static int make_generated(struct content *c, int *n, const struct tables_request *request, const char *directory)
{
    int status = STATUS_OK;
    for (int i = 0; i < FILES && status == STATUS_OK; i++)
        status = generated_make(&c[(*n)++], &files[i]);
    if (status == STATUS_OK)
        status = limits_make(&c[(*n)++], request, directory);
    if (status == STATUS_OK)
        status = manifest_make(&c[*n], c, *n);
    *n += status == STATUS_OK;
    return status;
}

/* Writes the two files of one material to memory. */
static int make_material(struct content *c, int *n, const struct tables_request *request)
{
    static char name[MATERIAL_FILES][DISK_TABLE_NAME];
    struct disk_table disk = {
        .poisson = request->poisson, .count = request->modes ? request->modes : DISK_TABLE_MODES, .embed = true};
    profile_step("modes");
    int status = disk_table_solve(&disk);
    for (*n = 0; *n < MATERIAL_FILES && status == STATUS_OK; ++*n) {
        FILE *const file = content_open(&c[*n], disk_table_name(name[*n], &disk, material_file[*n].extension));
        status = content_close(&c[*n], file, material_file[*n].write(file, &disk));
    }
    disk_modes_clear(&disk.modes);
    return status;
}

/* Recomputes a sample of collisions, because equal bytes prove only that the text follows from its numbers. */
static int check_limits(const struct tables_request *request)
{
    if (request->all)
        return disk_limits_check_all();
    return disk_limits_check_sample(request->seed >= 0
                                        ? (uint64_t)request->seed
                                        : ((uint64_t)time(NULL) * 1000 + (uint64_t)getpid()) % TABLES_MAX_SEED);
}

int tables_run(const struct tables_request *request)
{
    const bool material = request->poisson.text;
    const char *directory = request->directory ? request->directory
                            : material         ? DEFAULT_DIRECTORY_OF_MATERIAL
                                               : DEFAULT_DIRECTORY;
    struct content c[CONTENTS] = {{NULL, NULL, 0}};
    struct output out;
    output_open(&out, NULL);
    int n = 0, status = request->check || request->digits ? STATUS_OK : probe_directory(directory, request);
    emit_digits(request->digits ? out.file : NULL);
    if (status == STATUS_OK)
        status = material ? make_material(c, &n, request) : make_generated(c, &n, request, directory);
    emit_digits(NULL);
    if (status == STATUS_OK && !request->digits)
        status = request->check ? check_all(c, n, directory) : write_all(c, n, directory);
    char *const shown = xprintable(directory);
    for (int i = 0; i < n && status == STATUS_OK && !request->digits; i++)
        fprintf(out.file, "%s %s/%s: %zu bytes\n", request->check ? "same" : "wrote", shown, c[i].name, c[i].size);
    free(shown);
    if (status == STATUS_OK && request->check && !material && disk_limits_known(NULL))
        status = check_limits(request);
    if (status == STATUS_OK && !request->check && !request->digits && !request->all && !material)
        fprintf(out.file, "left the collisions of " DISK_LIMITS_FILE " unchanged; --all computes them again\n");
    if (output_commit(&out) != STATUS_OK)
        status = STATUS_FAILED;
    for (int i = 0; i < CONTENTS; i++)
        free(c[i].text);
    sphere_tables_clear();
    return status;
}
