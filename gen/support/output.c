/* SPDX-License-Identifier: MIT */
#define _GNU_SOURCE /* O_TMPFILE, realpath */

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

static const char *volatile interrupted_text;

void output_say_on_interrupt(const char *text)
{
    interrupted_text = text;
}

/* The handler raises the signal again with its default action, so that the parent sees the expected exit status.
 * SA_RESETHAND would not do: a terminal or timeout(1) sends two signals, and the second could end the process before
 * the first line of the handler. */
static void on_fatal_signal(int number)
{
    remove_unfinished();
    const char *text = interrupted_text;
    if (text && (number == SIGINT || number == SIGTERM || number == SIGHUP) &&
        write(STDERR_FILENO, text, strlen(text)) < 0)
        text = NULL;
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

void output_handle_signals(void)
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

char *output_folder(const char *path)
{
    const char *const slash = strrchr(path, '/');
    char *const folder = xstrdup(slash ? path : ".");
    if (slash)
        folder[slash == path ? 1 : slash - path] = '\0';
    return folder;
}

static const char *last_part(const char *path)
{
    const char *const slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* The descriptor of this process that a path names, as /dev/fd/3 and /proc/self/fd/3 do, or NOT_A_DESCRIPTOR. */
static int descriptor_named(const char *path)
{
    const char *const digits = last_part(path);
    if (!*digits || digits == path || strspn(digits, "0123456789") != strlen(digits) || strlen(digits) > 6)
        return NOT_A_DESCRIPTOR;
    char *const folder = output_folder(path), *const real = realpath(folder, NULL),
                *const own = realpath("/dev/fd", NULL);
    const bool is = real && own && strcmp(real, own) == 0;
    free(folder);
    free(real);
    free(own);
    return is ? (int)strtol(digits, NULL, 10) : NOT_A_DESCRIPTOR;
}

/* The name beside the path: its folder and `last`, malloc'ed */
static char *beside(const char *path, const char *last)
{
    const size_t folder = (size_t)(last_part(path) - path), size = strlen(last) + 1;
    char *const name = xmalloc(folder + size);
    memcpy(name, path, folder);
    memcpy(name + folder, last, size);
    return name;
}

/* The target of a link, malloc'ed, or NULL. A relative target replaces the last part of `link`. */
static char *link_target(const char *link)
{
    char text[4096];
    const ssize_t n = readlink(link, text, sizeof text - 1);
    if (n < 0)
        return NULL;
    text[n] = '\0';
    return *text == '/' ? xstrdup(text) : beside(link, text);
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

/* The file system's number of the folder in which a name stands */
static bool folder_status(struct stat *folder, const char *name)
{
    char *const path = output_folder(name);
    const bool found = stat(path, folder) == 0;
    free(path);
    return found;
}

static bool same_inode(const struct stat *x, const struct stat *y)
{
    return x->st_dev == y->st_dev && x->st_ino == y->st_ino;
}

static int status_of(struct stat *status, const char *path)
{
    return path ? stat(path, status) : fstat(STDOUT_FILENO, status);
}

bool output_same_file(const char *path, const char *other)
{
    struct stat x, y;
    const bool exists = status_of(&x, path) == 0, other_exists = status_of(&y, other) == 0;
    if (exists || other_exists || !path || !other)
        return exists && other_exists && S_ISREG(x.st_mode) && same_inode(&x, &y);
    int descriptor;
    char *const name = follow_links(path, &descriptor), *const other_name = follow_links(other, &descriptor);
    const bool same = name && other_name && folder_status(&x, name) && folder_status(&y, other_name) &&
                      same_inode(&x, &y) && strcmp(last_part(name), last_part(other_name)) == 0;
    free(name);
    free(other_name);
    return same;
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

enum { OWN_PATH = 64, NAME_ATTEMPTS = 100 };

/* The path under which the kernel shows an open file to its process */
static void own_path(char path[OWN_PATH], int fd)
{
    snprintf(path, OWN_PATH, "/proc/self/fd/%d", fd);
}

/* A file without a name in the target's folder, which vanishes however the process ends; negative where the file system
 * has none, or where it could get no name later. */
static int open_nameless(const char *target)
{
#ifdef O_TMPFILE
    char path[OWN_PATH], *const folder = output_folder(target);
    const int fd = open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    free(folder);
    if (fd < 0)
        return fd;
    own_path(path, fd);
    if (access(path, F_OK) == 0)
        return fd;
    close(fd);
#else
    (void)target;
#endif
    return -1;
}

/* A file with a name that the handler of signals removes. Negative after setting errno. */
static int open_named(struct output *out)
{
    sigset_t before;
    out->temporary = beside(out->target, ".corgen-XXXXXX");
    block_signals(&before);
    int fd = mkstemp(out->temporary);
    if (fd >= 0 && !registry_add(out->temporary)) {
        unlink(out->temporary);
        close(fd);
        fd = -1;
        errno = EMFILE;
    }
    restore_signals(&before);
    if (fd < 0) {
        free(out->temporary);
        out->temporary = NULL;
    }
    return fd;
}

static int make_temporary(struct output *out)
{
    int fd = open_nameless(out->target);
    if (fd < 0)
        fd = open_named(out);
    if (fd >= 0 && (set_mode(out, fd) != 0 || !(out->file = fdopen(fd, "w+")))) {
        int reason = errno;
        close(fd);
        errno = reason;
        return -1;
    }
    return fd < 0 ? -1 : 0;
}

int output_open(struct output *out, const char *path)
{
    *out = (struct output){0};
    out->path = path;
    output_handle_signals();
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
    if (out->target && fsync(fileno(out->file)) != 0)
        return output_failure("write", out);
    if (out->target && (out->in_place || !out->temporary))
        return STATUS_OK; /* still to be read, or without a name */
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

/* Gives a file without a name that of the target, or a temporary one if the target exists: no call replaces a file by
 * one without a name. */
static bool give_name(struct output *out)
{
    char path[OWN_PATH], last[OWN_PATH];
    own_path(path, fileno(out->file));
    if (linkat(AT_FDCWD, path, AT_FDCWD, out->target, AT_SYMLINK_FOLLOW) == 0)
        return true;
    for (int i = 0; i < NAME_ATTEMPTS && errno == EEXIST; i++) {
        snprintf(last, sizeof last, ".corgen-%ld-%d", (long)getpid(), i);
        char *const name = beside(out->target, last);
        if (linkat(AT_FDCWD, path, AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0) {
            out->temporary = name;
            return true;
        }
        const int reason = errno;
        free(name);
        errno = reason;
    }
    return false;
}

/* Puts a complete temporary file in the place of the target. */
static bool output_replace(struct output *out)
{
    const bool good = out->in_place ? output_overwrite(out) : out->temporary || give_name(out);
    if (!good)
        return false;
    if (out->file)
        fclose(out->file);
    out->file = NULL;
    if (!out->temporary)
        return true;
    return out->in_place ? unlink(out->temporary) == 0 : rename(out->temporary, out->target) == 0;
}

int output_commit_all(struct output *out, int n)
{
    int result = STATUS_OK;
    for (int i = 0; i < n && result == STATUS_OK; i++)
        result = output_complete(&out[i]);

    sigset_t before;
    block_signals(&before);
    for (int i = 0; i < n && result == STATUS_OK; i++) {
        if (!out[i].target)
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
    text += *text == '-';
    size_t n = span_digits(text);
    if (n > 1 && *text == '0')
        return false;
    text += n;
    if (n > 0 && *text == '.') {
        n = span_digits(++text);
        text += n;
    }
    if (n > 0 && (*text == 'e' || *text == 'E')) {
        text++;
        text += *text == '+' || *text == '-';
        n = span_digits(text);
        text += n;
    }
    return n > 0 && *text == '\0';
}

static bool is_integer(const char *text)
{
    text += *text == '-';
    return *text && text[span_digits(text)] == '\0';
}

/* Prints once in a thousand cells, and only on a terminal. */
static void print_progress(const struct table *t, long cell)
{
    if (cell >= 0 && cell % 1024 == 0)
        progress("printing rows", cell / t->columns, t->cells / t->columns);
}

static char kind_of(const struct table *t, long cell)
{
    return t->kinds ? t->kinds[cell % t->columns] : TABLE_NUMBER;
}

/* A text, with `before` in front of each character of `escaped` */
static void print_escaped(const char *text, const char *escaped, char before, FILE *file)
{
    fputc('"', file);
    for (; *text; text++) {
        if (strchr(escaped, *text))
            fputc(before, file);
        fputc((unsigned char)*text < ' ' ? ' ' : *text, file);
    }
    fputc('"', file);
}

static void print_csv(const struct table *t, FILE *file)
{
    for (int j = 0; j < t->columns; j++)
        fprintf(file, "%s%c", t->column[j], j + 1 < t->columns ? ',' : '\n');
    for (long i = 0; i < t->cells; i++) {
        print_progress(t, i);
        const bool missing = !*t->cell[i] && kind_of(t, i) != TABLE_TEXT;
        if (strpbrk(t->cell[i], ",\"\n"))
            print_escaped(t->cell[i], "\"", '"', file);
        else
            fputs(missing ? "nan" : t->cell[i], file);
        fputc((i + 1) % t->columns ? ',' : '\n', file);
    }
}

/* A cell that is no number of JSON, as nan and inf, is null, and so is an empty text. */
static void print_json_cell(const struct table *t, char kind, const char *cell, FILE *file)
{
    if (kind == TABLE_TEXT ? !*cell : !is_json_number(cell))
        fputs("null", file);
    else if (kind == TABLE_TEXT || (kind == TABLE_DIGITS && t->json_strings))
        print_escaped(cell, "\"\\", '\\', file);
    else
        fputs(cell, file);
}

static void print_json(const struct table *t, FILE *file)
{
    fputs("[", file);
    for (long i = 0; i < t->cells; i++) {
        print_progress(t, i);
        int j = (int)(i % t->columns);
        fputs(j ? ", " : i ? ",\n  {" : "\n  {", file);
        fprintf(file, "\"%s\": ", t->column[j]);
        print_json_cell(t, kind_of(t, i), t->cell[i], file);
        fputs(j + 1 == t->columns ? "}" : "", file);
    }
    fputs("\n]\n", file);
}

/* Integers are aligned right, other numbers left, with their signs in a separate column. */
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
    if (format == FORMAT_CSV)
        print_csv(t, file);
    else if (format == FORMAT_JSON)
        print_json(t, file);
    else
        print_text(t, file);
    progress_end();
}
