/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* realpath */

#include "support/output.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/console.h"

/* Unfinished files, for the signal handler. The handler may run between any two instructions. A name therefore enters
 * the list only when its string is complete, and leaves the list before the string is freed. */
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

/* The handler raises the signal again with its default action, so that the parent sees the expected exit status.
 * SA_RESETHAND would not do: a terminal or timeout(1) sends two signals, and the second could end the process before
 * the first line of the handler. */
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
        /* a signal that the parent ignores (nohup) stays ignored */
        if (sigaction(fatal_signal[i], NULL, &action) != 0 || action.sa_handler == SIG_IGN)
            continue;
        memset(&action, 0, sizeof action);
        action.sa_handler = on_fatal_signal;
        fatal_signals(&action.sa_mask);
        sigaction(fatal_signal[i], &action, NULL);
    }
    signal(SIGXFSZ, SIG_IGN); /* a write beyond the file size limit then fails and is reported */
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

/* ---- the file of a path ---- */

enum { LINKS_MAX = 40, NOT_A_DESCRIPTOR = -1 };

/* The descriptor of this process that a path names, as /dev/fd/3 and /proc/self/fd/3 do, or NOT_A_DESCRIPTOR. */
static int descriptor_named(const char *path)
{
    const char *const slash = strrchr(path, '/');
    const char *const digits = slash ? slash + 1 : path;
    if (!slash || !*digits || strspn(digits, "0123456789") != strlen(digits) || strlen(digits) > 6)
        return NOT_A_DESCRIPTOR;
    char own[64], *directory = xstrdup(path);
    directory[slash - path] = '\0';
    snprintf(own, sizeof own, "/proc/%ld/fd", (long)getpid());
    char *const real = realpath(directory, NULL);
    const bool is = strcmp(directory, "/dev/fd") == 0 || (real && strcmp(real, own) == 0);
    free(real);
    free(directory);
    return is ? (int)strtol(digits, NULL, 10) : NOT_A_DESCRIPTOR;
}

/* The target of a link, malloc'ed. A relative target replaces the last part of `link`. */
static char *link_target(const char *link)
{
    char text[4096];
    const ssize_t n = readlink(link, text, sizeof text - 1);
    if (n < 0)
        return NULL;
    text[n] = '\0';
    const char *const slash = strrchr(link, '/');
    const size_t directory = slash && text[0] != '/' ? (size_t)(slash - link) + 1 : 0;
    char *const target = xmalloc(directory + (size_t)n + 1);
    memcpy(target, link, directory);
    memcpy(target + directory, text, (size_t)n + 1);
    return target;
}

/* The name behind all symbolic links, whether that file exists or not, malloc'ed. Returns NULL and sets *descriptor or
 * errno if no such name exists. */
static char *follow_links(const char *path, int *descriptor)
{
    char *name = xstrdup(path);
    *descriptor = NOT_A_DESCRIPTOR;
    for (int links = 0; name && (*descriptor = descriptor_named(name)) == NOT_A_DESCRIPTOR; links++) {
        struct stat status;
        if (lstat(name, &status) != 0 || !S_ISLNK(status.st_mode))
            return name;
        char *const next = links < LINKS_MAX ? link_target(name) : NULL;
        if (links == LINKS_MAX)
            errno = ELOOP;
        free(name);
        name = next;
    }
    free(name);
    return NULL;
}

bool output_is_direct(const char *path)
{
    struct stat status;
    int descriptor = NOT_A_DESCRIPTOR;
    if (!path || (stat(path, &status) == 0 && !S_ISREG(status.st_mode)))
        return true;
    free(follow_links(path, &descriptor));
    return descriptor != NOT_A_DESCRIPTOR;
}

/* ---- the temporary file ---- */

/* Sets mode, owner and group to those of the file to be replaced. Returns false if that is not permitted; the file is
 * then written in place. */
static bool take_over(int fd, const struct stat *old)
{
    struct stat mine;
    if (fstat(fd, &mine) != 0)
        return false;
    const bool same_owner = mine.st_uid == old->st_uid && mine.st_gid == old->st_gid;
    return (same_owner || fchown(fd, old->st_uid, old->st_gid) == 0) && fchmod(fd, old->st_mode & 07777) == 0;
}

static int set_mode(struct output *out, int fd)
{
    struct stat old;
    if (stat(out->target, &old) == 0) {
        out->in_place = old.st_nlink > 1 || !take_over(fd, &old);
        return out->in_place ? fchmod(fd, 0600) : 0;
    }
    const mode_t mask = umask(0);
    umask(mask);
    return fchmod(fd, 0666 & ~mask);
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

    if (set_mode(out, fd) != 0 || !(out->file = fdopen(fd, "w+"))) {
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

    int descriptor;
    struct stat status;
    out->target = follow_links(path, &descriptor);
    if (descriptor != NOT_A_DESCRIPTOR) {
        const int copy = dup(descriptor);
        out->file = copy < 0 ? NULL : fdopen(copy, "w");
    } else if (stat(path, &status) == 0 && !S_ISREG(status.st_mode)) {
        free(out->target);
        out->target = NULL;
        out->file = fopen(path, "w");
    } else if (out->target) {
        /* rename() would replace a read-only file without asking, but such a file must be kept. */
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

/* Completes the file except for the rename. */
static int output_complete(struct output *out)
{
    errno = 0;
    const bool written = fflush(out->file) == 0 && !ferror(out->file);
    if (!written)
        return output_failure("write", out);
    if (!out->path)
        return STATUS_OK;
    if (out->temporary && fsync(fileno(out->file)) != 0)
        return output_failure("write", out);
    if (out->in_place)
        return STATUS_OK; /* still to be read */
    const bool closed = fclose(out->file) == 0;
    out->file = NULL;
    return closed ? STATUS_OK : output_failure("write", out);
}

/* Copies `size` bytes of the stream to the descriptor. */
static bool copy_bytes(FILE *from, int to, off_t size)
{
    char block[1 << 16];
    rewind(from);
    while (size > 0) {
        const size_t n = fread(block, 1, sizeof block, from);
        if (n == 0)
            return false;
        for (size_t done = 0; done < n;) {
            const ssize_t written = write(to, block + done, n - done);
            if (written < 0 && errno != EINTR)
                return false;
            done += written > 0 ? (size_t)written : 0;
        }
        size -= (off_t)n;
    }
    return true;
}

/* Writes the complete temporary file over the target. Space is reserved first, so that a full disk leaves the old
 * text. */
static bool output_overwrite(struct output *out)
{
    const int fd = open(out->target, O_WRONLY | O_CLOEXEC);
    struct stat old, now;
    if (fd < 0)
        return false;
    bool good = fstat(fd, &old) == 0 && fstat(fileno(out->file), &now) == 0;
    if (good && now.st_size > old.st_size) {
        const int reason = posix_fallocate(fd, old.st_size, now.st_size - old.st_size);
        if (reason != 0 && reason != EINVAL && reason != EOPNOTSUPP) {
            good = false;
            errno = ftruncate(fd, old.st_size) == 0 ? reason : errno;
        }
    }
    good = good && copy_bytes(out->file, fd, now.st_size) && ftruncate(fd, now.st_size) == 0 && fsync(fd) == 0;
    const int reason = errno;
    if (close(fd) != 0 && good)
        return false;
    errno = reason;
    return good;
}

/* Puts a complete temporary file in the place of the target. */
static bool output_replace(struct output *out)
{
    if (!out->in_place)
        return rename(out->temporary, out->target) == 0;
    if (!output_overwrite(out))
        return false;
    fclose(out->file);
    out->file = NULL;
    return unlink(out->temporary) == 0;
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
        if (!output_replace(&out[i])) {
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

/* Whether a JSON reader with doubles, as most have, can hold the number: any fraction, and an integer of at most 2^53 =
 * 9007199254740992. */
static bool is_safe_json_number(const char *text)
{
    static const char largest[] = "9007199254740992";
    if (!is_json_number(text))
        return false;
    const char *const digits = text + (*text == '-');
    const size_t n = span_digits(digits), most = sizeof largest - 1;
    return digits[n] != '\0' || n < most || (n == most && strcmp(digits, largest) <= 0);
}

static bool is_integer(const char *text)
{
    if (*text == '-')
        text++;
    return *text && text[span_digits(text)] == '\0';
}

/* Prints once in a thousand cells, and only on a terminal. */
static void print_progress(const struct table *t, long cell)
{
    if (cell >= 0 && cell % 1024 == 0)
        progress("printing rows", cell / t->columns, t->cells / t->columns);
}

static void print_csv(const struct table *t, FILE *file)
{
    for (int j = 0; j < t->columns; j++)
        fprintf(file, "%s%c", t->column[j], j + 1 < t->columns ? ',' : '\n');
    for (long i = 0; i < t->cells; i++) {
        print_progress(t, i);
        fprintf(file, "%s%c", t->cell[i], (i + 1) % t->columns ? ',' : '\n');
    }
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
        number[j] = column_all(t, j, is_safe_json_number);
    fputs("[", file);
    for (long i = 0; i < t->cells; i++) {
        print_progress(t, i);
        int j = (int)(i % t->columns);
        const char *quote = number[j] ? "" : "\"";
        fputs(j ? ", " : i ? ",\n  {" : "\n  {", file);
        fprintf(file, "\"%s\": %s%s%s", t->column[j], quote, t->cell[i], quote);
        fputs(j + 1 == t->columns ? "}" : "", file);
    }
    fputs("\n]\n", file);
    free(number);
}

/* Integers are aligned right, other numbers left, with their signs in a separate column. */
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
        print_progress(t, i);
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
    progress_end();
}
