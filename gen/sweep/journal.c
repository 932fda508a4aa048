/* SPDX-License-Identifier: MIT */
#include "sweep/journal.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "runtime/disk/mode_file.h"
#include "support/clock.h"
#include "support/console.h"
#include "support/output.h"

/* A line ends with a space and a check sum of everything before the sum, as in a mode file. A changed byte therefore
 * shows in its own line and in every later one. */
enum { CHECK_LENGTH = 9, PENDING_MAX = 1 << 20, SYNC_SECONDS = 30 };

static int journal_failure(const char *verb, const struct journal *journal)
{
    return fail("cannot %s %s: %s", verb, journal->path, errno ? strerror(errno) : "write error");
}

static uint32_t line_check(uint32_t check, const char *line, size_t n)
{
    return cor_mode_file_check(cor_mode_file_check(check, line, n), " ", 1);
}

/* If the check sum at the end of the line is right, cuts it off, updates *check and returns true. Otherwise neither
 * changes. */
static bool line_accept(uint32_t *check, char *line, size_t n)
{
    if (n < CHECK_LENGTH + 1 || line[n - 1] != '\n' || memchr(line, '\0', n))
        return false;
    char expected[CHECK_LENGTH + 2];
    const size_t length = n - CHECK_LENGTH - 1;
    const uint32_t so_far = line_check(*check, line, length);
    snprintf(expected, sizeof expected, " %08" PRIx32 "\n", so_far);
    if (memcmp(line + length, expected, CHECK_LENGTH + 1) != 0)
        return false;
    *check = cor_mode_file_check(so_far, expected + 1, CHECK_LENGTH);
    line[length] = '\0';
    return true;
}

void journal_add(struct journal *journal, const char *line)
{
    const size_t n = strlen(line), size = n + CHECK_LENGTH + 1;
    const uint32_t check = line_check(journal->check, line, n);
    if (journal->pending_size + size + 1 > journal->pending_capacity) {
        journal->pending_capacity = 2 * (journal->pending_size + size + 1);
        journal->pending = xrealloc(journal->pending, journal->pending_capacity);
    }
    char *at = journal->pending + journal->pending_size;
    snprintf(at, size + 1, "%s %08" PRIx32 "\n", line, check);
    journal->check = cor_mode_file_check(check, at + n + 1, CHECK_LENGTH);
    journal->pending_size += size;
    journal->lines++;
    if (journal->pending_size > PENDING_MAX)
        journal_flush(journal); /* the caller's next journal_flush reports an error again */
}

int journal_flush(struct journal *journal)
{
    size_t done = 0;
    while (done < journal->pending_size) {
        const ssize_t n = write(journal->fd, journal->pending + done, journal->pending_size - done);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0) {
            /* keep what is not written, so that the file stays a prefix of the journal */
            memmove(journal->pending, journal->pending + done, journal->pending_size - done);
            journal->pending_size -= done;
            return journal_failure("write", journal);
        }
        done += (size_t)n;
    }
    journal->pending_size = 0;
    if (done > 0 && clock_seconds() - journal->synced > (double)SYNC_SECONDS) {
        if (fsync(journal->fd) != 0 && errno != EINVAL)
            return journal_failure("write", journal);
        journal->synced = clock_seconds();
    }
    return STATUS_OK;
}

/* ---- opening ---- */

static int journal_lock(struct journal *journal)
{
    struct flock region = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    if (fcntl(journal->fd, F_SETLK, &region) == 0)
        return STATUS_OK;
    if (errno != EACCES && errno != EAGAIN) { /* the file system has no locks */
        journal_failure("lock", journal);
        fail("continuing without a lock; make sure that no other corgen writes to the same --output");
        return STATUS_OK;
    }
    if (fcntl(journal->fd, F_GETLK, &region) == 0 && region.l_type != F_UNLCK)
        return fail("%s is in use by process %ld; wait for it or choose another --output", journal->path,
                    (long)region.l_pid);
    return fail("%s is in use by another process; wait for it or choose another --output", journal->path);
}

/* Opens and locks the file. Another process may finish the journal and remove it between open and lock; then the name
 * belongs to another file or to none, and the file is opened again. */
static int journal_open_locked(struct journal *journal)
{
    for (;;) {
        struct stat opened, named;
        /* a symbolic link could lead anywhere, so it is not followed */
        journal->fd = open(journal->path, O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (journal->fd < 0 && errno == ELOOP)
            return fail("cannot write %s: it is a symbolic link; remove it or choose another --output", journal->path);
        if (journal->fd < 0 || fstat(journal->fd, &opened) != 0)
            return journal_failure("write", journal);
        if (!S_ISREG(opened.st_mode))
            return fail("cannot write %s: it is not a regular file", journal->path);
        if (journal_lock(journal) != STATUS_OK)
            return STATUS_FAILED;
        if (stat(journal->path, &named) == 0 && named.st_ino == opened.st_ino && named.st_dev == opened.st_dev)
            return STATUS_OK;
        close(journal->fd);
        journal->fd = -1;
    }
}

static int journal_refuse_foreign(const struct journal *journal, const char *title)
{
    enum { SHOWN = 300 };
    static const char start[] = "corgen ";
    if (strncmp(title, start, sizeof start - 1) != 0)
        return fail("%s is not an unfinished sweep of corgen; remove it or choose another --output", journal->path);
    const char *command = strstr(title, ": ");
    return fail("%s holds rows of another sweep, '%.*s%s'; finish it by that command, remove it or choose another "
                "--output",
                journal->path, SHOWN, command ? command + 2 : title,
                command && strlen(command + 2) > SHOWN ? "..." : "");
}

/* A title identifies the sweep before its first colon. The command after the colon may be written in another way. */
static bool same_sweep(const char *title, const char *other)
{
    const char *colon = strchr(title, ':');
    return colon ? strncmp(title, other, (size_t)(colon - title) + 1) == 0 : strcmp(title, other) == 0;
}

/* Reads the lines of a journal without moving its descriptor, to which rows may be added meanwhile. */
struct reader {
    const struct journal *journal;
    char *buffer; /* longer than any line of a journal */
    size_t capacity, size, start;
    off_t at;
    uint32_t check;
    bool failed;
};

static void reader_start(struct reader *r, const struct journal *journal)
{
    enum { LINE = 1 << 16 };
    *r =
        (struct reader){.journal = journal, .capacity = journal->title_size + LINE, .check = COR_MODE_FILE_CHECK_START};
    r->buffer = xmalloc(r->capacity);
}

/* The next line, its check sum cut off, or NULL if it is incomplete or its check is wrong. */
static char *reader_next(struct reader *r)
{
    for (;;) {
        char *const line = r->buffer + r->start, *const end = memchr(line, '\n', r->size - r->start);
        const size_t left = r->size - r->start, n = end ? (size_t)(end - line) + 1 : left;
        if (end) {
            if (!line_accept(&r->check, line, n))
                return NULL;
            r->start += n;
            return line;
        }
        memmove(r->buffer, line, left);
        r->size = left;
        r->start = 0;
        const ssize_t got = pread(r->journal->fd, r->buffer + left, r->capacity - left, r->at);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            journal_failure("read", r->journal);
        r->failed = got < 0;
        if (got <= 0)
            return NULL;
        r->size += (size_t)got;
        r->at += got;
    }
}

/* Finds the good lines, and returns their size in bytes, or -1 after a message. */
static off_t journal_recover(struct journal *journal, const char *title, uint64_t most)
{
    struct reader r;
    reader_start(&r, journal);
    off_t good = 0;
    const char *line = reader_next(&r);
    if (!line) {
        /* a prefix of the title was cut off while it was written; any other first line is from another program */
        const size_t size = r.size, n = strlen(title);
        const bool beginning = size <= n + CHECK_LENGTH && memcmp(r.buffer, title, size < n ? size : n) == 0;
        if (!r.failed && !beginning)
            journal_refuse_foreign(journal, "");
        good = !r.failed && beginning ? 0 : -1;
    } else if (!same_sweep(title, line)) {
        journal_refuse_foreign(journal, line);
        good = -1;
    }
    while (line && good >= 0) {
        journal->check = r.check;
        good = r.at - (off_t)(r.size - r.start);
        if (journal->lines == most)
            break;
        if ((line = reader_next(&r))) {
            free(journal->last);
            journal->last = xstrdup(line);
            journal->lines++;
        }
    }
    free(r.buffer);
    return r.failed ? -1 : good;
}

/* A power cut can lose the name of a new file until its folder is synced. */
static void sync_folder(const char *path)
{
    char *const folder = output_folder(path);
    const int fd = open(folder, O_RDONLY | O_CLOEXEC);
    if (fd >= 0) {
        fsync(fd);
        close(fd);
    }
    free(folder);
}

int journal_open(struct journal *journal, const char *file, const char *title, uint64_t most)
{
    *journal = (struct journal){.fd = -1, .check = COR_MODE_FILE_CHECK_START, .synced = clock_seconds()};
    static const char extension[] = ".part";
    const size_t size = strlen(file) + sizeof extension;
    journal->title_size = strlen(title);
    journal->path = xmalloc(size);
    snprintf(journal->path, size, "%s%s", file, extension);
    output_handle_signals(); /* a write beyond a size limit must fail, which is reported, and not end the program */
    off_t good = -1;
    if (journal_open_locked(journal) == STATUS_OK)
        good = journal_recover(journal, title, most);
    if (good >= 0 && (ftruncate(journal->fd, good) != 0 || lseek(journal->fd, good, SEEK_SET) != good)) {
        journal_failure("write", journal);
        good = -1;
    }
    int status = good >= 0 ? STATUS_OK : STATUS_FAILED;
    if (good == 0) {
        journal_add(journal, title);
        journal->lines = 0;
        status = journal_flush(journal);
        if (status == STATUS_OK && fsync(journal->fd) != 0 && errno != EINVAL)
            status = journal_failure("write", journal);
        sync_folder(journal->path);
    }
    if (status != STATUS_OK)
        journal_close(journal, false);
    return status;
}

int journal_read(struct journal *journal, void (*visit)(void *context, const char *line), void *context)
{
    if (journal_flush(journal) != STATUS_OK)
        return STATUS_FAILED;
    struct reader r;
    reader_start(&r, journal);
    uint64_t number = 0;
    for (const char *line; number <= journal->lines && (line = reader_next(&r)); number++) {
        if (number > 0)
            visit(context, line);
    }
    free(r.buffer);
    if (number == journal->lines + 1)
        return STATUS_OK;
    return r.failed ? STATUS_FAILED
                    : fail("another program has changed %s; its rows from line %" PRIu64 " on are lost", journal->path,
                           number);
}

void journal_close(struct journal *journal, bool done)
{
    if (done && unlink(journal->path) != 0)
        journal_failure("remove", journal);
    if (journal->fd >= 0)
        close(journal->fd);
    free(journal->path);
    free(journal->last);
    free(journal->pending);
    *journal = (struct journal){.fd = -1};
}

/* ---- interruptions ---- */

void journal_say_on_interrupt(struct journal *journal)
{
    static const char format[] = "\ncorgen: interrupted; the same command continues after the last row of %s\n";
    const size_t size = sizeof format + strlen(journal->path);
    journal->interrupted = xmalloc(size);
    snprintf(journal->interrupted, size, format, journal->path);
    output_say_on_interrupt(journal->interrupted);
}

void journal_silent_on_interrupt(struct journal *journal)
{
    output_say_on_interrupt(NULL);
    free(journal->interrupted);
    journal->interrupted = NULL;
}
