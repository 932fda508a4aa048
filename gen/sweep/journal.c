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

/* Cuts the check sum off the end of the line, if it is right, and updates *check. Otherwise neither changes. */
static bool line_accept(uint32_t *check, char *line)
{
    const size_t n = strlen(line);
    if (n < CHECK_LENGTH + 1)
        return false;
    char expected[CHECK_LENGTH + 2];
    const size_t length = n - CHECK_LENGTH - 1;
    const uint32_t so_far = line_check(*check, line, length);
    snprintf(expected, sizeof expected, " %08" PRIx32 "\n", so_far);
    if (strcmp(line + length, expected) != 0)
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
        journal->fd = open(journal->path, O_RDWR | O_APPEND | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (journal->fd < 0 && errno == ELOOP)
            return fail("cannot write %s: it is a symbolic link; remove it or choose another --output", journal->path);
        if (journal->fd < 0 || fstat(journal->fd, &opened) != 0)
            return journal_failure("write", journal);
        journal->stream = fdopen(journal->fd, "r");
        if (!journal->stream)
            return journal_failure("read", journal);
        if (!S_ISREG(opened.st_mode))
            return fail("cannot write %s: it is not a regular file", journal->path);
        if (journal_lock(journal) != STATUS_OK)
            return STATUS_FAILED;
        if (stat(journal->path, &named) == 0 && named.st_ino == opened.st_ino && named.st_dev == opened.st_dev)
            return STATUS_OK;
        fclose(journal->stream);
        journal->stream = NULL;
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

/* Reads the first line, or the next one, into journal->line and cuts off its check sum. False at the end, or if the
 * line is incomplete or its check is wrong. */
static bool read_line(struct journal *journal, bool first, uint32_t *check)
{
    if (first) {
        *check = COR_MODE_FILE_CHECK_START;
        fflush(journal->stream); /* forgets what was read before rows were added */
        rewind(journal->stream);
    }
    journal->line[0] = '\0';
    return fgets(journal->line, (int)journal->line_size, journal->stream) && line_accept(check, journal->line);
}

/* Finds the good lines, and returns their size in bytes, or -1 after a message. */
static off_t journal_recover(struct journal *journal, const char *title, uint64_t most)
{
    struct stat status;
    const size_t n = strlen(title);
    off_t good = 0;
    if (!read_line(journal, true, &journal->check)) {
        /* a prefix of the title was cut off while it was written; any other first line is from another program */
        const size_t size = strlen(journal->line);
        const bool beginning = fstat(journal->fd, &status) == 0 && status.st_size == (off_t)size &&
                               size <= n + CHECK_LENGTH && memcmp(journal->line, title, size < n ? size : n) == 0;
        if (ferror(journal->stream))
            return journal_failure("read", journal), -1;
        if (!beginning)
            journal_refuse_foreign(journal, "");
        return beginning ? 0 : -1;
    }
    if (!same_sweep(title, journal->line)) {
        journal_refuse_foreign(journal, journal->line);
        return -1;
    }
    for (uint32_t check = journal->check;; journal->lines++) {
        journal->check = check;
        good = ftello(journal->stream);
        if (journal->lines == most || !read_line(journal, false, &check))
            break;
        free(journal->last);
        journal->last = xstrdup(journal->line);
    }
    return ferror(journal->stream) ? journal_failure("read", journal), -1 : good;
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
    enum { LINE = 1 << 16 };
    static const char extension[] = ".part";
    *journal = (struct journal){.fd = -1, .synced = clock_seconds(), .line_size = strlen(title) + LINE};
    journal->line = xmalloc(journal->line_size);
    const size_t size = strlen(file) + sizeof extension;
    journal->path = xmalloc(size);
    snprintf(journal->path, size, "%s%s", file, extension);
    output_report_size_limit();
    off_t good = -1;
    if (journal_open_locked(journal) == STATUS_OK)
        good = journal_recover(journal, title, most);
    int status = good >= 0 ? STATUS_OK : STATUS_FAILED;
    if (status == STATUS_OK && ftruncate(journal->fd, good) != 0)
        status = journal_failure("write", journal);
    if (status == STATUS_OK && good == 0) {
        journal->check = COR_MODE_FILE_CHECK_START;
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
    uint32_t check;
    uint64_t number = 0;
    for (; number <= journal->lines && read_line(journal, number == 0, &check); number++)
        if (number > 0)
            visit(context, journal->line);
    if (number == journal->lines + 1)
        return STATUS_OK;
    if (ferror(journal->stream))
        return journal_failure("read", journal);
    return fail("another program has changed %s; its rows from line %" PRIu64 " on are lost", journal->path, number);
}

void journal_close(struct journal *journal, bool done)
{
    if (done && unlink(journal->path) != 0)
        journal_failure("remove", journal);
    if (journal->stream)
        fclose(journal->stream);
    free(journal->path);
    free(journal->line);
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
