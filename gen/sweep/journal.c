/* SPDX-License-Identifier: MIT */
#include "sweep/journal.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "runtime/core/mode_file.h"
#include "support/clock.h"
#include "support/console.h"

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

/* Returns the size of the good lines in bytes, or -1 after a message. */
static off_t journal_recover(struct journal *journal, const char *title, uint64_t most)
{
    enum { BLOCK = 1 << 16, LINE = 1 << 12 };
    const size_t longest = strlen(title) + LINE; /* no line of a journal is longer */
    size_t capacity = BLOCK, size = 0, start = 0;
    char *buffer = xmalloc(capacity);
    off_t good = 0;
    bool titled = false, ended = false;
    uint32_t check = COR_MODE_FILE_CHECK_START;
    journal->lines = 0;
    for (;;) {
        char *end = memchr(buffer + start, '\n', size - start);
        if (!end && !ended && size - start <= longest) {
            memmove(buffer, buffer + start, size - start);
            size -= start;
            start = 0;
            if (size == capacity) {
                capacity *= 2;
                buffer = xrealloc(buffer, capacity);
            }
            const ssize_t n = read(journal->fd, buffer + size, capacity - size);
            if (n < 0 && errno != EINTR) {
                free(buffer);
                journal_failure("read", journal);
                return -1;
            }
            ended = n == 0;
            size += n > 0 ? (size_t)n : 0;
            continue;
        }
        if (!end)
            break;
        const size_t n = (size_t)(end - (buffer + start)) + 1;
        if (!line_accept(&check, buffer + start, n))
            break;
        if (!titled) {
            if (!same_sweep(title, buffer + start)) {
                journal_refuse_foreign(journal, buffer + start);
                free(buffer);
                return -1;
            }
            titled = true;
        } else if (journal->lines == most) {
            break;
        } else {
            free(journal->last);
            journal->last = xstrdup(buffer + start);
            journal->lines++;
        }
        journal->check = check;
        good += (off_t)n;
        start += n;
    }
    if (!titled) {
        /* a prefix of the title was cut off while it was written; any other first line is from another program */
        const size_t n = strlen(title);
        const size_t same = size < n ? size : n;
        const bool beginning = size <= n + CHECK_LENGTH && memcmp(buffer, title, same) == 0;
        if (!beginning) {
            journal_refuse_foreign(journal, "");
            free(buffer);
            return -1;
        }
    }
    free(buffer);
    return good;
}

/* A power cut can lose the name of a new file until its directory is synced. */
static void sync_directory(const char *path)
{
    char *directory = xstrdup(path);
    char *slash = strrchr(directory, '/');
    if (slash)
        slash[slash == directory] = '\0';
    const int fd = open(slash ? directory : ".", O_RDONLY | O_CLOEXEC);
    if (fd >= 0) {
        fsync(fd);
        close(fd);
    }
    free(directory);
}

int journal_open(struct journal *journal, const char *file, const char *title, uint64_t most)
{
    *journal = (struct journal){.fd = -1, .check = COR_MODE_FILE_CHECK_START, .synced = clock_seconds()};
    static const char extension[] = ".part";
    const size_t size = strlen(file) + sizeof extension;
    journal->path = xmalloc(size);
    snprintf(journal->path, size, "%s%s", file, extension);
    /* a write beyond a size limit must fail, which is reported, and not end the program */
    signal(SIGXFSZ, SIG_IGN);
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
        sync_directory(journal->path);
    }
    if (status != STATUS_OK)
        journal_close(journal, false);
    return status;
}

int journal_read(struct journal *journal, void (*visit)(void *context, const char *line), void *context)
{
    if (journal_flush(journal) != STATUS_OK)
        return STATUS_FAILED;
    /* not by a second descriptor: closing either one releases the lock */
    errno = 0;
    FILE *file = lseek(journal->fd, 0, SEEK_SET) == 0 ? fdopen(journal->fd, "r") : NULL;
    if (!file)
        return journal_failure("read", journal);
    journal->stream = file;
    char *line = NULL;
    size_t capacity = 0;
    uint64_t number = 0;
    uint32_t check = COR_MODE_FILE_CHECK_START;
    bool good = true;
    for (ssize_t n; good && number <= journal->lines && (n = getline(&line, &capacity, file)) > 0; number++) {
        good = line_accept(&check, line, (size_t)n);
        if (good && number > 0)
            visit(context, line);
    }
    free(line);
    good = good && number == journal->lines + 1;
    if (!good) {
        fail("another program has changed %s; its rows from line %" PRIu64 " on are lost", journal->path, number);
    }
    return good ? STATUS_OK : STATUS_FAILED;
}

void journal_close(struct journal *journal, bool done)
{
    if (done && unlink(journal->path) != 0)
        journal_failure("remove", journal);
    if (journal->stream)
        fclose(journal->stream);
    else if (journal->fd >= 0)
        close(journal->fd);
    free(journal->path);
    free(journal->last);
    free(journal->pending);
    *journal = (struct journal){.fd = -1};
}

/* ---- interruptions ---- */

static char *interrupted_text;
static struct sigaction before_interrupt[3];
static const int interrupts[] = {SIGINT, SIGTERM, SIGHUP};

/* Added rows are safe at any moment, so the handler only prints a message and passes the signal on to its default
 * action. */
static void on_interrupt(int number)
{
    const char *text = interrupted_text;
    if (text && write(STDERR_FILENO, text, strlen(text)) < 0)
        text = NULL;
    signal(number, SIG_DFL);
    raise(number);
}

void journal_say_on_interrupt(const struct journal *journal)
{
    const char *const path = journal->path;
    static const char format[] = "\ncorgen: interrupted; the same command continues after the last row of %s\n";
    interrupted_text = xmalloc(sizeof format + strlen(path));
    snprintf(interrupted_text, sizeof format + strlen(path), format, path);
    for (size_t i = 0; i < sizeof interrupts / sizeof *interrupts; i++) {
        sigaction(interrupts[i], NULL, &before_interrupt[i]);
        if (before_interrupt[i].sa_handler == SIG_IGN)
            continue; /* the parent, such as nohup, ignores it */
        struct sigaction action;
        memset(&action, 0, sizeof action);
        action.sa_handler = on_interrupt;
        sigfillset(&action.sa_mask);
        sigaction(interrupts[i], &action, NULL);
    }
}

void journal_silent_on_interrupt(void)
{
    for (size_t i = 0; i < sizeof interrupts / sizeof *interrupts; i++)
        sigaction(interrupts[i], &before_interrupt[i], NULL);
    free(interrupted_text);
    interrupted_text = NULL;
}
