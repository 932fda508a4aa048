/* SPDX-License-Identifier: MIT */
/* corgen tables: everything in generated/, or the proof that it is what corgen would write; or the mode tables of
 * another material. A new file is a new row of files[], and one function that writes it to a stream. */
#define _XOPEN_SOURCE 700 /* open_memstream, mkdir */

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "cli/options.h"
#include "runtime/core/mode_file.h"
#include "support/console.h"
#include "tables/disk.h"
#include "tables/limits.h"
#include "tables/sphere.h"

enum { PATH_MAX_LENGTH = 4096 };

#define DEFAULT_DIRECTORY "generated"
#define DEFAULT_DIRECTORY_OF_MATERIAL "."
#define MANIFEST "MANIFEST.txt"
#define MANIFEST_VERSION_WORD "made-with" /* --check ignores lines that start with it */

struct generated {
    const char *name;
    int (*write)(FILE *file, const struct disk_table *disk); /* disk: of modes */
    struct disk_table disk;
    bool limits; /* of collisions, which are kept */
};

static const struct generated files[] = {
    {"sphere_tables.h", sphere_tables_write, {NULL, 0, false}, false},
    {"cor_sphere.h", sphere_header_write, {NULL, 0, false}, false},
    {"disk_modes_nu033.h", disk_header_write, {"0.33", DISK_TABLE_MODES, false}, false},
    {"disk_modes_nu090.h", disk_header_write, {"0.90", DISK_TABLE_MODES, false}, false},
    {DISK_LIMITS_ROWS_FILE, disk_limits_rows_write, {NULL, 0, false}, true},
    {DISK_LIMITS_HEADER_FILE, disk_limits_header_write, {NULL, 0, false}, true},
};
enum { FILES = sizeof files / sizeof *files, CONTENTS = FILES + 1 /* the manifest */ };

/* One file, complete, in memory; the manifest comes after files[]. */
struct content {
    const char *name;
    char *text;
    size_t size;
};

static int make(struct content *c, const struct generated *row)
{
    c->name = row->name;
    FILE *file = open_memstream(&c->text, &c->size);
    if (!file)
        return fail("no memory for %s", row->name);
    profile_step(row->name);
    int status = row->write(file, &row->disk);
    profile_step(NULL);
    if (fclose(file) && status == STATUS_OK)
        status = fail("no memory for %s", row->name);
    return status;
}

static int make_manifest(struct content *manifest, const struct content *c, int files_made)
{
    manifest->name = MANIFEST;
    FILE *file = open_memstream(&manifest->text, &manifest->size);
    if (!file)
        return fail("no memory for %s", MANIFEST);
    fprintf(file, "Written by `corgen tables`; `corgen tables --check` compares the files below byte for "
                  "byte.\nLines that start with " MANIFEST_VERSION_WORD
                  " tell which libraries made them, and are not compared.\n\n");
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
    return fclose(file) ? fail("no memory for %s", MANIFEST) : STATUS_OK;
}

static int set_path(char path[PATH_MAX_LENGTH], const char *directory, const char *name)
{
    const int n = snprintf(path, PATH_MAX_LENGTH, "%s/%s", directory, name);
    return n < PATH_MAX_LENGTH ? STATUS_OK : fail("the path %.60s... is too long", directory);
}

/* Asked before the minutes of computing, not after them; leaves no trace. */
static int probe_directory(const char *directory)
{
    if (mkdir(directory, 0777) == 0) {
        rmdir(directory);
        return STATUS_OK;
    }
    if (errno != EEXIST)
        return fail("cannot make %s: %s", directory, strerror(errno));
    return access(directory, W_OK | X_OK) == 0 ? STATUS_OK : fail("cannot write in %s: %s", directory, strerror(errno));
}

static int write_all(const struct content *c, int n, const char *directory)
{
    char path[CONTENTS][PATH_MAX_LENGTH];
    struct output out[CONTENTS];
    if (mkdir(directory, 0777) && errno != EEXIST)
        return fail("cannot make %s: %s", directory, strerror(errno));
    for (int i = 0; i < n; i++) {
        int status = set_path(path[i], directory, c[i].name);
        if (status == STATUS_OK)
            status = output_open(&out[i], path[i]);
        if (status == STATUS_OK) {
            fwrite(c[i].text, 1, c[i].size, out[i].file); /* a failure shows at the commit */
            continue;
        }
        while (i-- > 0)
            output_discard(&out[i]);
        return status;
    }
    return output_commit_all(out, n);
}

/* The next line that counts, or NULL; *number is its own. */
static const char *next_line(const char **at, const char *end, bool manifest, size_t *length, long *number)
{
    while (*at < end) {
        const char *line = *at, *newline = memchr(line, '\n', (size_t)(end - line));
        *length = newline ? (size_t)(newline - line) + 1 : (size_t)(end - line);
        *at = line + *length;
        ++*number;
        const size_t word = strlen(MANIFEST_VERSION_WORD);
        if (!manifest || *length < word || memcmp(line, MANIFEST_VERSION_WORD, word) != 0)
            return line;
    }
    return NULL;
}

/* Line in which the file first differs from what it should be, 0 if nowhere. */
static long first_difference(const struct content *c, const char *text, size_t size)
{
    const bool manifest = strcmp(c->name, MANIFEST) == 0;
    const char *made = c->text, *found = text;
    long made_number = 0, found_number = 0;
    for (;;) {
        size_t made_length = 0, found_length = 0;
        const char *a = next_line(&made, c->text + c->size, manifest, &made_length, &made_number);
        const char *b = next_line(&found, text + size, manifest, &found_length, &found_number);
        if (!a && !b)
            return 0;
        if (!a || !b || made_length != found_length || memcmp(a, b, made_length) != 0)
            return b ? found_number : found_number + 1;
    }
}

/* The whole file, or NULL with errno set. */
static char *read_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return NULL;
    size_t capacity = 1 << 16;
    char *text = xmalloc(capacity);
    *size = 0;
    for (size_t got; (got = fread(text + *size, 1, capacity - *size, file)) > 0;) {
        *size += got;
        if (*size == capacity)
            text = xrealloc(text, capacity *= 2);
    }
    const int error = ferror(file) ? errno : 0;
    fclose(file);
    if (error) {
        free(text);
        errno = error;
        return NULL;
    }
    return text;
}

static int check_all(const struct content *c, int n, const char *directory)
{
    int status = STATUS_OK;
    for (int i = 0; i < n; i++) {
        char path[PATH_MAX_LENGTH];
        size_t size = 0;
        if (set_path(path, directory, c[i].name))
            return STATUS_FAILED;
        char *text = read_file(path, &size);
        const long line = text ? first_difference(&c[i], text, size) : 0;
        if (!text)
            status = fail("cannot read %s: %s", path, strerror(errno));
        else if (line)
            status = fail("%s is not what corgen writes: it differs in line %ld", path, line);
        free(text);
    }
    return status;
}

/* The collisions of the long table: those of the directory, or else of generated/, or made anew. *known: whether there
 * are any. */
static int know_limits(bool *known, const struct options *o, const char *directory)
{
    static const char *const minutes = "some minutes of processor time";
    if (o->all && !o->check) {
        profile_step(DISK_LIMITS_ROWS_FILE);
        const int status = disk_limits_collide();
        profile_step(NULL);
        *known = status == STATUS_OK;
        return status;
    }
    char path[PATH_MAX_LENGTH];
    size_t size = 0;
    if (set_path(path, directory, DISK_LIMITS_ROWS_FILE))
        return STATUS_FAILED;
    char *text = read_file(path, &size);
    if (!text && errno == ENOENT && !o->check && strcmp(directory, DEFAULT_DIRECTORY) != 0 &&
        set_path(path, DEFAULT_DIRECTORY, DISK_LIMITS_ROWS_FILE) == STATUS_OK)
        text = read_file(path, &size);
    *known = text != NULL;
    if (!text && errno != ENOENT)
        return fail("cannot read %s: %s", path, strerror(errno));
    if (!text) {
        fprintf(stderr, "corgen: " DISK_LIMITS_HEADER_FILE " is left out, for there is no %s; --all makes it, in %s\n",
                path, minutes);
        return STATUS_OK;
    }
    const int status = disk_limits_read(text, size, path);
    free(text);
    return status;
}

/* The files of generated/ and their manifest, or those of one material. */
static int make_all(struct content *c, int *n, const struct options *o, const char *directory)
{
    const slong count = o->count == OPTIONS_NOT_GIVEN ? DISK_TABLE_MODES : o->count;
    const struct generated material[] = {{NULL, disk_header_write, {o->real[OPTIONS_POISSON], count, true}, false},
                                         {NULL, disk_file_write, {o->real[OPTIONS_POISSON], count, true}, false}};
    static const char *const extension[] = {"h", "txt"};
    static char name[2][DISK_TABLE_NAME];
    int status = STATUS_OK;
    if (!o->real[OPTIONS_POISSON]) {
        bool asked = false, known = false;
        *n = 0;
        for (int i = 0; i < FILES && status == STATUS_OK; i++) {
            if (files[i].limits && !asked) {
                status = know_limits(&known, o, directory);
                asked = true;
            }
            if (status == STATUS_OK && (known || !files[i].limits))
                status = make(&c[(*n)++], &files[i]);
        }
        if (status == STATUS_OK)
            status = make_manifest(&c[*n], c, *n);
        *n += status == STATUS_OK;
        return status;
    }
    for (*n = 0; *n < 2 && status == STATUS_OK; ++*n) {
        struct generated row = material[*n];
        row.name = disk_table_name(name[*n], &row.disk, extension[*n]);
        status = make(&c[*n], &row);
    }
    return status;
}

/* Collides again, where the table is not what says so itself: byte for byte it is its own rows that it is made of. */
static int check_limits(const struct options *o)
{
    if (o->all)
        return disk_limits_check_all();
    const uint64_t seed = o->seed != OPTIONS_NOT_GIVEN
                              ? (uint64_t)o->seed
                              : ((uint64_t)time(NULL) * 1000 + (uint64_t)getpid()) % OPTIONS_MAX_SEED;
    return disk_limits_check_sample(seed);
}

int command_tables(const struct options *o)
{
    if ((o->all || o->seed != OPTIONS_NOT_GIVEN) && o->real[OPTIONS_POISSON])
        return usage_error("--%s is about the collisions of generated/" DISK_LIMITS_ROWS_FILE ", not about --poisson",
                           o->all ? "all" : "seed");
    if (o->seed != OPTIONS_NOT_GIVEN && (o->all || !o->check))
        return usage_error("--seed chooses the sample of --check without --all");
    if (o->count != OPTIONS_NOT_GIVEN && !o->real[OPTIONS_POISSON])
        return usage_error("--modes needs --poisson: the tables of generated/ have %d modes", DISK_TABLE_MODES);
    if (o->real[OPTIONS_POISSON] && strlen(o->real[OPTIONS_POISSON]) > DISK_TABLE_POISSON)
        return usage_error("--poisson: a name of a file is made of it; %d characters at most, as 0.33",
                           DISK_TABLE_POISSON);
    const char *directory = o->output                  ? o->output
                            : o->real[OPTIONS_POISSON] ? DEFAULT_DIRECTORY_OF_MATERIAL
                                                       : DEFAULT_DIRECTORY;
    struct content c[CONTENTS] = {{NULL, NULL, 0}};
    int n = 0, status = o->check ? STATUS_OK : probe_directory(directory);
    if (status == STATUS_OK)
        status = make_all(c, &n, o, directory);
    if (status == STATUS_OK)
        status = o->check ? check_all(c, n, directory) : write_all(c, n, directory);
    for (int i = 0; i < n && status == STATUS_OK; i++)
        printf("%s %s/%s: %zu bytes\n", o->check ? "same" : "wrote", directory, c[i].name, c[i].size);
    if (status == STATUS_OK && o->check && disk_limits_known())
        status = check_limits(o);
    if (status == STATUS_OK && !o->check && !o->all && disk_limits_known())
        printf("kept the collisions of " DISK_LIMITS_ROWS_FILE "; --all makes them anew\n");
    if (fflush(stdout) && status == STATUS_OK)
        status = fail("standard output: %s", strerror(errno));
    for (int i = 0; i < CONTENTS; i++)
        free(c[i].text);
    sphere_tables_clear();
    disk_tables_clear();
    disk_limits_clear();
    return status;
}
