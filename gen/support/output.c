/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* open_memstream, mkstemp */

#include "support/output.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/console.h"

/* ---- signals ---- */

static const char *volatile interrupted_text;

/* Raises the signal again with its default action, so that the parent sees the expected exit status. */
static void on_interrupt(int number)
{
    const char *text = interrupted_text;
    if (text && write(STDERR_FILENO, text, strlen(text)) < 0)
        text = NULL;
    signal(number, SIG_DFL);
    raise(number);
}

void output_say_on_interrupt(const char *text)
{
    static const int interrupting[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction before, action = {.sa_handler = on_interrupt};
    sigfillset(&action.sa_mask);
    interrupted_text = text;
    for (size_t i = 0; i < sizeof interrupting / sizeof *interrupting; i++)
        /* a signal that the parent ignores (nohup) remains ignored */
        if (sigaction(interrupting[i], NULL, &before) == 0 && before.sa_handler == SIG_DFL)
            sigaction(interrupting[i], &action, NULL);
}

void output_report_size_limit(void)
{
    signal(SIGXFSZ, SIG_IGN);
}

/* ---- the file of a path ---- */

#define TEMPORARY ".corgen-XXXXXX"
enum { LINKS_MOST = 40 /* the kernel's limit of symbolic links */ };

const char *file_name(const char *path)
{
    const char *const slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* Returns the malloc'ed path of a file named `last` in the folder of `path`. */
static char *path_next_to(const char *path, const char *last)
{
    return xprintf("%.*s%s", (int)(file_name(path) - path), path, last);
}

/* Returns the file that a path names behind all symbolic links, malloc'ed. It need not exist. If its folder exists,
 * two paths of one file have the same target. */
static char *target_of(const char *path)
{
    char *target = xstrdup(path), link[PATH_MAX];
    ssize_t size;
    for (int i = 0; i < LINKS_MOST && (size = readlink(target, link, sizeof link - 1)) >= 0; i++) {
        link[size] = '\0';
        char *const next = *link == '/' ? xstrdup(link) : path_next_to(target, link);
        free(target);
        target = next;
    }
    char *const last = path_next_to(target, "."), *const folder = realpath(last, NULL);
    char *const whole = folder ? xprintf("%s/%s", folder, file_name(target)) : xstrdup(target);
    free(last);
    free(folder);
    free(target);
    return whole;
}

static bool is_standard(const char *path)
{
    return !path || strcmp(path, "/dev/stdout") == 0;
}

bool output_is_direct(const char *path)
{
    struct stat status;
    return is_standard(path) || (stat(path, &status) == 0 && !S_ISREG(status.st_mode));
}

bool output_same_file(const char *path, const char *other)
{
    struct stat x, y;
    char *const target = target_of(path), *const other_target = target_of(other);
    const bool both = stat(path, &x) == 0 && stat(other, &y) == 0, equal = strcmp(target, other_target) == 0;
    free(target);
    free(other_target);
    return both ? S_ISREG(x.st_mode) && x.st_dev == y.st_dev && x.st_ino == y.st_ino : equal;
}

/* ---- opening ---- */

static void signals_block(sigset_t *before)
{
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, before);
}

/* True if the folder of the target accepts a new file. Otherwise errno is the reason. */
static bool folder_accepts(const char *target)
{
    char *const name = path_next_to(target, TEMPORARY);
    sigset_t before; /* block signals: an interruption leaves no file */
    signals_block(&before);
    const int fd = mkstemp(name);
    if (fd >= 0) {
        unlink(name);
        close(fd);
    }
    sigprocmask(SIG_SETMASK, &before, NULL);
    free(name);
    return fd >= 0;
}

int output_check(const char *path)
{
    struct stat status;
    if (is_standard(path))
        return STATUS_OK;
    const bool exists = stat(path, &status) == 0;
    if (exists && S_ISDIR(status.st_mode))
        errno = EISDIR;
    else if (exists ? access(path, W_OK) == 0 : errno == ENOENT)
        errno = 0;
    if (errno != 0)
        return fail("cannot write %s: %s", path, strerror(errno));
    if (exists && !S_ISREG(status.st_mode))
        return STATUS_OK;
    if (exists && status.st_nlink > 1)
        return fail("cannot write %s: the file has %ld names (hard links), and the others would keep the old content; "
                    "remove this name or choose another one",
                    path, (long)status.st_nlink);
    char *const target = target_of(path);
    const bool accepted = folder_accepts(target);
    free(target);
    return accepted ? STATUS_OK
                    : fail("cannot write %s: cannot create a file in its folder: %s; choose another folder", path,
                           strerror(errno));
}

static int output_failure(const char *verb, const struct output *out)
{
    return fail("cannot %s %s: %s", verb, out->path ? out->path : "standard output",
                errno ? strerror(errno) : "write error");
}

void output_show(struct output *out)
{
    if (!out->screen)
        return;
    fflush(out->file);
    progress_hold();
    fwrite(out->bytes, 1, out->size, out->screen);
    fflush(out->screen);
    rewind(out->file);
    progress_resume();
}

void output_discard(struct output *out)
{
    if (out->file && out->file != stdout)
        fclose(out->file);
    if (out->screen && out->screen != stdout)
        fclose(out->screen);
    if (out->temporary)
        unlink(out->temporary);
    free(out->target);
    free(out->temporary);
    free(out->bytes);
    *out = (struct output){.path = out->path};
}

int output_open(struct output *out, const char *path)
{
    *out = (struct output){.path = path, .file = stdout};
    output_report_size_limit();
    const int status = output_check(path);
    if (status != STATUS_OK)
        return status;
    errno = 0;
    if (!is_standard(path) && output_is_direct(path)) {
        out->file = fopen(path, "w");
    } else if (!is_standard(path)) {
        out->file = open_memstream(&out->bytes, &out->size);
        out->target = target_of(path);
    }
    if (out->file && !out->target && isatty(fileno(out->file)) && isatty(STDERR_FILENO)) {
        out->screen = out->file;
        out->file = open_memstream(&out->bytes, &out->size);
    }
    return out->file ? STATUS_OK : output_failure("write", out);
}

/* ---- committing ---- */

/* Closes an output that is written directly. Completes the bytes of an output in memory. */
static int output_complete(struct output *out)
{
    errno = 0;
    output_show(out);
    FILE *const file = out->screen ? out->screen : out->file;
    bool good = fflush(file) == 0 && !ferror(file);
    if (good && out->file != stdout) {
        good = fclose(out->file) == 0;
        out->file = NULL;
    }
    return good ? STATUS_OK : output_failure("write", out);
}

/* Writes the bytes into a temporary file next to the target, with the mode of the target, or of a new file. */
static int output_prepare(struct output *out)
{
    struct stat old;
    const bool exists = stat(out->target, &old) == 0;
    const mode_t mask = umask(0), mode = exists ? old.st_mode & 0777 : 0666 & ~mask;
    umask(mask);
    char *const name = path_next_to(out->target, TEMPORARY);
    const int fd = mkstemp(name);
    FILE *const file = fd < 0 ? NULL : fdopen(fd, "w");
    out->temporary = fd < 0 ? NULL : name;
    if (!file)
        return output_failure("write", out);
    const bool written =
        (fchmod(fd, mode) == 0 || !exists) && fwrite(out->bytes, 1, out->size, file) == out->size && fflush(file) == 0;
    const int reason = errno;
    const bool closed = fclose(file) == 0;
    errno = written ? errno : reason;
    return written && closed ? STATUS_OK : output_failure("write", out);
}

static int output_replace(struct output *out)
{
    if (rename(out->temporary, out->target) != 0)
        return output_failure("replace", out);
    free(out->temporary);
    out->temporary = NULL;
    return STATUS_OK;
}

int output_commit_all(struct output *out, int n)
{
    int result = STATUS_OK;
    for (int i = 0; i < n && result == STATUS_OK; i++)
        result = output_complete(&out[i]);
    sigset_t before; /* block signals: an interruption leaves no temporary file, and either all new files or none */
    signals_block(&before);
    for (int i = 0; i < n && result == STATUS_OK; i++)
        result = out[i].target ? output_prepare(&out[i]) : STATUS_OK;
    for (int i = 0; i < n && result == STATUS_OK; i++)
        result = out[i].target ? output_replace(&out[i]) : STATUS_OK;
    for (int i = 0; i < n; i++)
        output_discard(&out[i]);
    sigprocmask(SIG_SETMASK, &before, NULL);
    return result;
}

int output_commit(struct output *out)
{
    return output_commit_all(out, 1);
}

int output_finish(struct output *out, int status)
{
    if (status == STATUS_OK)
        return output_commit(out);
    output_discard(out);
    return status;
}

int output_text(const char *path, const char *text)
{
    struct output out;
    const int status = output_open(&out, path);
    if (status == STATUS_OK)
        fputs(text, out.file);
    return output_finish(&out, status);
}

char *read_file(const char *path, size_t most, size_t *size)
{
    const bool standard = strcmp(path, "-") == 0;
    FILE *const file = standard ? stdin : fopen(path, "rb");
    if (!file)
        return NULL;
    if (standard && isatty(STDIN_FILENO))
        progress_hold();
    size_t capacity = 1 << 16;
    char *bytes = xmalloc(capacity);
    *size = 0;
    for (size_t got; *size < most && (got = fread(bytes + *size, 1, capacity - *size, file)) > 0;) {
        *size += got;
        if (*size == capacity)
            bytes = xrealloc(bytes, capacity *= 2);
    }
    progress_resume();
    bytes[*size] = '\0';
    const int wrong = ferror(file) ? errno : *size < most ? 0 : EFBIG;
    if (!standard)
        fclose(file);
    if (!wrong)
        return bytes;
    free(bytes);
    errno = wrong;
    return NULL;
}

/* Tables */

void table_init(struct table *t, const char *header, const char *kinds)
{
    *t = (struct table){.header = xstrdup(header), .kinds = xstrdup(kinds)};
    char *rest, *name = strtok_r(t->header, ",", &rest);
    for (; name; name = strtok_r(NULL, ",", &rest)) {
        t->column = xgrow(t->column, (size_t)t->columns, sizeof *t->column);
        t->column[t->columns++] = name;
    }
}

/* Splits a line at its commas into trimmed fields without quotes. Returns their number, at most `most`. */
static int split_fields(char **field, int most, char *line)
{
    int count = 0;
    while (line && count < most) {
        char *const comma = strchr(line, ',');
        if (comma)
            *comma = '\0';
        line += strspn(line, " \t");
        size_t length = strlen(line);
        while (length > 0 && strchr(" \t\r", line[length - 1]))
            length--;
        const bool quoted = length > 1 && *line == '"' && line[length - 1] == '"';
        line[length - quoted] = '\0';
        field[count++] = line + quoted;
        line = comma ? comma + 1 : NULL;
    }
    return count;
}

/* Sets place[k] to the field of the header that is column k of the table, or to -1. Returns an error as text, or
 * NULL. */
static char *read_header(int *place, const struct table *t, char *const *field, int fields, int required, bool others)
{
    for (int k = 0; k < t->columns - 1; k++) {
        place[k] = -1;
        for (int i = 0; i < fields; i++)
            if (strcmp(field[i], t->column[k]) == 0 && place[k] >= 0)
                return xprintf("the column %s appears twice", field[i]);
            else if (strcmp(field[i], t->column[k]) == 0)
                place[k] = i;
        if (place[k] < 0 && k < required)
            return xprintf("the column %s is missing%s", t->column[k],
                           fields == 1 ? "; write commas between the columns" : "");
    }
    for (int i = 0; i < fields && !others; i++) {
        int k = 0;
        while (k < t->columns - 1 && place[k] != i)
            k++;
        if (k == t->columns - 1)
            return xprintf("the column '%s' is unknown", field[i]);
    }
    return NULL;
}

int table_read(struct table *t, const char *option, const char *path, const char *columns, int required, bool others)
{
    enum { COLUMNS = 64, MOST = 1 << 24 };
    int place[COLUMNS], fields = 0, number = 0;
    size_t size;
    char *const all = xprintf("%s,line", columns), *const bytes = read_file(path, MOST, &size), *wrong = NULL;
    table_init(t, all, "");
    free(all);
    if (!bytes)
        return usage_error("--%s: cannot read %s: %s", option, path, strerror(errno));
    char *const start = strncmp(bytes, "\xef\xbb\xbf", 3) == 0 ? bytes + 3 : bytes; /* start after a byte order mark */
    for (char *line = start, *next; line && !wrong; line = next) {
        char *field[COLUMNS];
        next = strchr(line, '\n');
        if (next)
            *next++ = '\0';
        number++;
        if (!next && line + strlen(line) != bytes + size)
            wrong = xstrdup("the line contains a zero byte");
        const int found = line[strspn(line, " \t\r")] == '\0' || *line == '#' ? 0 : split_fields(field, COLUMNS, line);
        for (int i = 0; i < found && !wrong; i++) {
            char *const shown = xprintable(field[i]);
            wrong = strcmp(shown, field[i]) == 0 ? NULL : xprintf("'%s' must be UTF-8 text without tabs", field[i]);
            free(shown);
        }
        if (wrong || found == 0)
            continue;
        if (fields == 0) {
            wrong = read_header(place, t, field, fields = found, required, others);
            continue;
        }
        wrong = found == fields ? NULL : xprintf("%d fields, but the header has %d; write 0.1, not 0,1", found, fields);
        for (int k = 0; k < t->columns - 1 && !wrong; k++)
            table_add(t, xstrdup(place[k] < 0 ? "" : field[place[k]]));
        if (!wrong)
            table_add_integer(t, number);
    }
    if (!wrong && t->cells == 0)
        wrong = xstrdup(fields ? "no row follows the header"
                               : "the header is missing, a line with the names of the columns");
    const int status = wrong ? usage_error("--%s %s, line %d: %s; allowed: csv with the columns %s", option, path,
                                           number, wrong, columns)
                             : STATUS_OK;
    free(wrong);
    free(bytes);
    return status;
}

void table_add(struct table *t, char *cell)
{
    t->cell = xgrow(t->cell, (size_t)t->cells, sizeof *t->cell);
    t->cell[t->cells++] = cell;
}

void table_add_text(struct table *t, const char *text)
{
    table_add(t, xprintable(text));
}

void table_add_integer(struct table *t, long value)
{
    table_add(t, xprintf("%ld", value));
}

void table_add_number(struct table *t, double x, int digits)
{
    table_add(t, isnan(x) ? xstrdup("nan") : xprintf("%.*g", digits, x));
}

void table_add_known(struct table *t, double x, int digits)
{
    table_add(t, isnan(x) ? xstrdup("") : xprintf("%.*g", digits, x));
}

void table_drop_rows(struct table *t)
{
    while (t->cells > 0)
        free(t->cell[--t->cells]);
}

void table_clear(struct table *t)
{
    table_drop_rows(t);
    free(t->cell);
    free(t->header);
    free(t->column);
    free(t->kinds);
    *t = (struct table){0};
}

/* True if a cell is a number, but not nan or inf. corgen begins all numbers with a digit. */
static bool is_number(const char *text)
{
    return isdigit((unsigned char)text[*text == '-']);
}

static bool is_integer(const char *text)
{
    return is_number(text) && text[strspn(text, "-0123456789")] == '\0';
}

/* Updates the progress after every thousandth cell, only on a terminal. */
static void print_progress(const struct table *t, long cell)
{
    if (cell > 0 && cell % 1024 == 0)
        progress("printing rows", cell / t->columns, t->cells / t->columns);
}

/* Prints a text, with `before` in front of each character of `escaped`. */
static void print_escaped(const char *text, const char *escaped, char before, FILE *file)
{
    fputc('"', file);
    for (; *text; text++) {
        if (strchr(escaped, *text))
            fputc(before, file);
        fputc(*text, file);
    }
    fputc('"', file);
}

/* Prints a cell. nan, inf and empty texts become null in JSON. */
static void print_json_cell(const struct table *t, char kind, const char *cell, FILE *file)
{
    if (kind == TABLE_TEXT ? !*cell : !is_number(cell))
        fputs("null", file);
    else if (kind == TABLE_TEXT || (kind == TABLE_DIGITS && t->json_strings))
        print_escaped(cell, "\"\\", '\\', file);
    else
        fputs(cell, file);
}

void table_print_start(const struct table *t, enum output_format format, FILE *file)
{
    for (int j = 0; j < t->columns && format == FORMAT_CSV; j++)
        fprintf(file, "%s%c", t->column[j], j + 1 < t->columns ? ',' : '\n');
    if (format == FORMAT_JSON)
        fputs("[", file);
}

void table_print_rows(const struct table *t, enum output_format format, bool first, FILE *file)
{
    for (long i = 0; i < t->cells; i++) {
        const int j = (int)(i % t->columns);
        const bool last = j + 1 == t->columns;
        print_progress(t, i);
        if (format == FORMAT_CSV) {
            if (strpbrk(t->cell[i], ",\""))
                print_escaped(t->cell[i], "\"", '"', file);
            else
                fputs(!*t->cell[i] && t->kinds[j] != TABLE_TEXT ? "nan" : t->cell[i], file);
            fputc(last ? '\n' : ',', file);
        } else {
            fprintf(file, "%s\"%s\": ", j ? ", " : i || !first ? ",\n  {" : "\n  {", t->column[j]);
            print_json_cell(t, t->kinds[j], t->cell[i], file);
            fputs(last ? "}" : "", file);
        }
    }
}

void table_print_end(enum output_format format, FILE *file)
{
    fputs(format == FORMAT_JSON ? "\n]\n" : "", file);
}

/* The layout of a text column. Integers are aligned right; other numbers left, with signs in a separate column. */
struct text_column {
    int width;
    bool whole, sign;
};

static struct text_column text_column(const struct table *t, int j)
{
    struct text_column c = {.whole = true};
    for (long i = j; i < t->cells; i += t->columns) {
        c.whole = c.whole && is_integer(t->cell[i]);
        c.sign = c.sign || *t->cell[i] == '-';
    }
    c.sign = c.sign && !c.whole;
    c.width = (int)strlen(t->column[j]) + c.sign;
    for (long i = j; i < t->cells; i += t->columns) {
        const int length = (int)strlen(t->cell[i]) + (c.sign && *t->cell[i] != '-');
        c.width = length > c.width ? length : c.width;
    }
    return c;
}

static void print_text(const struct table *t, FILE *file)
{
    struct text_column *const column = xmalloc((size_t)t->columns * sizeof *column);
    for (int j = 0; j < t->columns; j++)
        column[j] = text_column(t, j);
    for (long i = -t->columns; i < t->cells; i++) {
        print_progress(t, i);
        const int j = (int)((i + t->columns) % t->columns), width = column[j].width;
        const char *const text = i < 0 ? t->column[j] : t->cell[i];
        const char *const space = column[j].sign && *text != '-' ? " " : "";
        const bool last = j + 1 == t->columns;
        if (column[j].whole)
            fprintf(file, "%*s%s", width, text, last ? "\n" : "  ");
        else if (last)
            fprintf(file, "%s%s\n", space, text);
        else
            fprintf(file, "%s%-*s  ", space, width - (int)strlen(space), text);
    }
    free(column);
}

void table_print(const struct table *t, enum output_format format, FILE *file)
{
    if (format == FORMAT_CSV || format == FORMAT_JSON) {
        table_print_start(t, format, file);
        table_print_rows(t, format, true, file);
        table_print_end(format, file);
    } else {
        print_text(t, file);
    }
    progress_end();
}
