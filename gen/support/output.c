/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* realpath */

#include "support/output.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/console.h"

/* Unfinished files, for the signal handler: it may run between any two instructions, so a name
 * enters only when its string is whole and leaves before the string is freed. */
enum { OUTPUTS_MAX = 64 };
static char *volatile unfinished[OUTPUTS_MAX];

static const int fatal_signal[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGABRT, SIGXCPU};
enum { FATAL_SIGNALS = sizeof fatal_signal / sizeof *fatal_signal };

static void remove_unfinished(void)
{
    for (int i = 0; i < OUTPUTS_MAX; i++) {
        const char *name = unfinished[i];
        if (name)
            unlink(name);
    }
}

/* The signal goes on to its default action, so the parent sees the death it asked for. Not by
 * SA_RESETHAND: a second signal between the reset and the first line here would end the process at
 * once, and a terminal or timeout(1) sends two. */
static void on_fatal_signal(int number)
{
    remove_unfinished();
    signal(number, SIG_DFL);
    raise(number);
}

static void fatal_signals(sigset_t *set)
{
    sigemptyset(set);
    for (int i = 0; i < FATAL_SIGNALS; i++)
        sigaddset(set, fatal_signal[i]);
}

static void block_signals(sigset_t *before)
{
    sigset_t set;
    fatal_signals(&set);
    sigprocmask(SIG_BLOCK, &set, before);
}

static void restore_signals(const sigset_t *before)
{
    sigprocmask(SIG_SETMASK, before, NULL);
}

static void install_handlers(void)
{
    static bool installed;
    if (installed)
        return;
    installed = true;
    for (int i = 0; i < FATAL_SIGNALS; i++) {
        struct sigaction action;
        /* Ignored by the parent (nohup) stays ignored. */
        if (sigaction(fatal_signal[i], NULL, &action) != 0 || action.sa_handler == SIG_IGN)
            continue;
        memset(&action, 0, sizeof action);
        action.sa_handler = on_fatal_signal;
        fatal_signals(&action.sa_mask);
        sigaction(fatal_signal[i], &action, NULL);
    }
    signal(SIGXFSZ, SIG_IGN); /* a file at its size limit is a failed write, which is reported */
    atexit(remove_unfinished);
}

static int registry_add(char *name)
{
    for (int i = 0; i < OUTPUTS_MAX; i++) {
        if (!unfinished[i]) {
            unfinished[i] = name;
            return 1;
        }
    }
    return 0;
}

static void registry_remove(const char *name)
{
    for (int i = 0; i < OUTPUTS_MAX; i++) {
        if (unfinished[i] == name)
            unfinished[i] = NULL;
    }
}

static const char *name_of(const struct output *out)
{
    return out->path ? out->path : "standard output";
}

static int output_failure(const char *verb, const struct output *out)
{
    return fail("cannot %s %s: %s", verb, name_of(out), errno ? strerror(errno) : "write error");
}

static void output_release(struct output *out)
{
    free(out->target);
    free(out->temporary);
    out->target = NULL;
    out->temporary = NULL;
    out->file = NULL;
}

void output_discard(struct output *out)
{
    if (out->file && out->path)
        fclose(out->file);
    if (out->temporary) {
        unlink(out->temporary);
        registry_remove(out->temporary);
    }
    output_release(out);
}

/* The file that `path` names after its symbolic links; a new file has a directory that exists. */
static char *resolve_links(const char *path)
{
    char *real = realpath(path, NULL);
    if (!real && errno == ENOENT)
        real = xstrdup(path);
    return real;
}

static int make_temporary(struct output *out)
{
    static const char pattern[] = ".corgen-XXXXXX";
    const char *slash = strrchr(out->target, '/');
    size_t directory = slash ? (size_t)(slash - out->target) + 1 : 0;
    out->temporary = xmalloc(directory + sizeof pattern);
    memcpy(out->temporary, out->target, directory);
    memcpy(out->temporary + directory, pattern, sizeof pattern);

    sigset_t before;
    block_signals(&before);
    int fd = mkstemp(out->temporary);
    int registered = fd >= 0 && registry_add(out->temporary);
    if (fd >= 0 && !registered) {
        unlink(out->temporary);
        close(fd);
        errno = EMFILE;
    }
    restore_signals(&before);
    if (!registered) {
        free(out->temporary);
        out->temporary = NULL;
        return -1;
    }

    mode_t mask = umask(0);
    umask(mask);
    if (fchmod(fd, 0666 & ~mask) != 0 || !(out->file = fdopen(fd, "w"))) {
        int reason = errno;
        close(fd);
        errno = reason;
        return -1;
    }
    return 0;
}

int output_open(struct output *out, const char *path)
{
    *out = (struct output){0};
    out->path = path;
    install_handlers();
    errno = 0;
    if (!path) {
        out->file = stdout;
        return STATUS_OK;
    }

    struct stat status;
    if (stat(path, &status) == 0 && !S_ISREG(status.st_mode)) {
        out->file = fopen(path, "w");
    } else if ((out->target = resolve_links(path))) {
        /* rename() would not ask, but a file that its owner made read-only is to be kept. */
        if (access(out->target, F_OK) != 0 || access(out->target, W_OK) == 0)
            make_temporary(out);
    }
    if (!out->file) {
        int reason = errno;
        int result = fail("cannot write %s: %s", path, strerror(reason));
        output_discard(out);
        return result;
    }
    return STATUS_OK;
}

/* Everything but the rename. */
static int output_complete(struct output *out)
{
    errno = 0;
    bool written = fflush(out->file) == 0 && !ferror(out->file);
    if (!written)
        return output_failure("write", out);
    if (!out->path)
        return STATUS_OK;

    if (out->temporary && fsync(fileno(out->file)) != 0)
        return output_failure("write", out);
    int closed = fclose(out->file) == 0;
    out->file = NULL;
    return closed ? STATUS_OK : output_failure("write", out);
}

int output_commit_all(struct output *out, int n)
{
    int result = STATUS_OK;
    for (int i = 0; i < n && result == STATUS_OK; i++)
        result = output_complete(&out[i]);

    sigset_t before;
    block_signals(&before);
    for (int i = 0; i < n && result == STATUS_OK; i++) {
        if (!out[i].temporary)
            continue;
        if (rename(out[i].temporary, out[i].target) != 0) {
            result = output_failure("replace", &out[i]);
        } else {
            registry_remove(out[i].temporary);
            output_release(&out[i]);
        }
    }
    restore_signals(&before);

    for (int i = 0; i < n; i++)
        output_discard(&out[i]);
    return result;
}

int output_commit(struct output *out)
{
    return output_commit_all(out, 1);
}

/* Tables */

void table_init(struct table *t, const char *const *column, int columns)
{
    *t = (struct table){.column = column, .columns = columns};
}

void table_add(struct table *t, char *cell)
{
    if (t->cells == t->capacity) {
        t->capacity = t->capacity ? 2 * t->capacity : 64;
        t->cell = xrealloc(t->cell, (size_t)t->capacity * sizeof *t->cell);
    }
    t->cell[t->cells++] = cell;
}

void table_add_integer(struct table *t, long value)
{
    char text[32];
    snprintf(text, sizeof text, "%ld", value);
    table_add(t, xstrdup(text));
}

void table_clear(struct table *t)
{
    for (long i = 0; i < t->cells; i++)
        free(t->cell[i]);
    free(t->cell);
    *t = (struct table){0};
}

static size_t span_digits(const char *text)
{
    return strspn(text, "0123456789");
}

static bool is_json_number(const char *text)
{
    if (*text == '-')
        text++;
    size_t n = span_digits(text);
    if (n == 0 || (n > 1 && *text == '0'))
        return false;
    text += n;
    if (*text == '.') {
        n = span_digits(++text);
        if (n == 0)
            return false;
        text += n;
    }
    if (*text == 'e' || *text == 'E') {
        text++;
        if (*text == '+' || *text == '-')
            text++;
        n = span_digits(text);
        if (n == 0)
            return false;
        text += n;
    }
    return *text == '\0';
}

static bool is_integer(const char *text)
{
    if (*text == '-')
        text++;
    return *text && text[span_digits(text)] == '\0';
}

static void print_csv(const struct table *t, FILE *file)
{
    for (int j = 0; j < t->columns; j++)
        fprintf(file, "%s%c", t->column[j], j + 1 < t->columns ? ',' : '\n');
    for (long i = 0; i < t->cells; i++)
        fprintf(file, "%s%c", t->cell[i], (i + 1) % t->columns ? ',' : '\n');
}

static bool column_all(const struct table *t, int column, bool (*is)(const char *))
{
    bool all = true;
    for (long i = column; i < t->cells; i += t->columns)
        all = all && is(t->cell[i]);
    return all;
}

static void print_json(const struct table *t, FILE *file)
{
    bool *number = xmalloc((size_t)t->columns * sizeof *number);
    for (int j = 0; j < t->columns; j++)
        number[j] = column_all(t, j, is_json_number);
    fputs("[", file);
    for (long i = 0; i < t->cells; i++) {
        int j = (int)(i % t->columns);
        const char *quote = number[j] ? "" : "\"";
        fputs(j ? ", " : i ? ",\n  {" : "\n  {", file);
        fprintf(file, "\"%s\": %s%s%s", t->column[j], quote, t->cell[i], quote);
        fputs(j + 1 == t->columns ? "}" : "", file);
    }
    fputs("\n]\n", file);
    free(number);
}

/* Whole numbers stand right; other numbers left, with their signs in a column of their own. */
static void print_text(const struct table *t, FILE *file)
{
    size_t columns = (size_t)t->columns;
    int *width = xmalloc(columns * sizeof *width);
    bool *whole = xmalloc(columns * sizeof *whole);
    bool *sign = xmalloc(columns * sizeof *sign);
    for (int j = 0; j < t->columns; j++) {
        whole[j] = column_all(t, j, is_integer);
        sign[j] = false;
        for (long i = j; i < t->cells; i += t->columns)
            sign[j] = sign[j] || (!whole[j] && *t->cell[i] == '-');
        width[j] = (int)strlen(t->column[j]) + sign[j];
        for (long i = j; i < t->cells; i += t->columns) {
            int length = (int)strlen(t->cell[i]) + (sign[j] && *t->cell[i] != '-');
            width[j] = length > width[j] ? length : width[j];
        }
    }
    for (long i = -t->columns; i < t->cells; i++) {
        int j = (int)((i + t->columns) % t->columns);
        const char *text = i < 0 ? t->column[j] : t->cell[i];
        const char *space = sign[j] && *text != '-' ? " " : "";
        bool last = j + 1 == t->columns;
        if (whole[j])
            fprintf(file, "%*s%s", width[j], text, last ? "\n" : "  ");
        else if (last)
            fprintf(file, "%s%s\n", space, text);
        else
            fprintf(file, "%s%-*s  ", space, width[j] - (int)strlen(space), text);
    }
    free(width);
    free(whole);
    free(sign);
}

void table_print(const struct table *t, enum output_format format, FILE *file)
{
    switch (format) {
    case FORMAT_CSV:
        print_csv(t, file);
        break;
    case FORMAT_JSON:
        print_json(t, file);
        break;
    case FORMAT_TEXT:
    case FORMAT_LATEX:
        print_text(t, file);
        break;
    }
}
