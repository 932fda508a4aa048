/* SPDX-License-Identifier: MIT */
#include "sweep/journal.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "runtime/core/mode_file.h"
#include "support/console.h"

/* A line ends with a space and the check of all that stands before that, as in a mode file: what is not as it was
 * written, for whatever reason, is found, and all behind it is in doubt. */
enum { CHECK_LENGTH = 9, PENDING_MAX = 1 << 20, SYNC_SECONDS = 30 };

static double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int cannot(const char *verb, const struct journal *journal)
{
    return fail("cannot %s %s: %s", verb, journal->path, errno ? strerror(errno) : "write error");
}

static uint32_t check_of(uint32_t check, const char *line, size_t n)
{
    return cor_mode_file_check(cor_mode_file_check(check, line, n), " ", 1);
}

/* Takes the check off a line that was read, with its end, if it is right; otherwise leaves both alone. */
static bool accept(uint32_t *check, char *line, size_t n)
{
    if (n < CHECK_LENGTH + 1 || line[n - 1] != '\n' || memchr(line, '\0', n))
        return false;
    char expected[CHECK_LENGTH + 2];
    const size_t length = n - CHECK_LENGTH - 1;
    const uint32_t so_far = check_of(*check, line, length);
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
    const uint32_t check = check_of(journal->check, line, n);
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
        journal_flush(journal); /* an error is met again by the caller's own */
}

int journal_flush(struct journal *journal)
{
    size_t done = 0;
    while (done < journal->pending_size) {
        const ssize_t n = write(journal->fd, journal->pending + done, journal->pending_size - done);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0) {
            /* what is there stays a beginning */
            memmove(journal->pending, journal->pending + done, journal->pending_size - done);
            journal->pending_size -= done;
            return cannot("write", journal);
        }
        done += (size_t)n;
    }
    journal->pending_size = 0;
    if (done > 0 && seconds_now() - journal->synced > SYNC_SECONDS) {
        if (fsync(journal->fd) != 0 && errno != EINVAL)
            return cannot("write", journal);
        journal->synced = seconds_now();
    }
    return STATUS_OK;
}

/* ---- opening ---- */

static int lock(struct journal *journal)
{
    struct flock region = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    if (fcntl(journal->fd, F_SETLK, &region) == 0)
        return STATUS_OK;
    if (errno != EACCES && errno != EAGAIN) { /* a file system without locks */
        cannot("lock", journal);
        fail("going on; see to it that no other corgen has the same --output");
        return STATUS_OK;
    }
    if (fcntl(journal->fd, F_GETLK, &region) == 0 && region.l_type != F_UNLCK)
        return fail("%s is in use by process %ld; wait for it or choose another --output", journal->path,
                    (long)region.l_pid);
    return fail("%s is in use by another process; wait for it or choose another --output", journal->path);
}

/* The file of that name, locked: not one that another process finished and removed in between. */
static int open_locked(struct journal *journal)
{
    for (;;) {
        struct stat opened, named;
        journal->fd = open(journal->path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (journal->fd < 0 || fstat(journal->fd, &opened) != 0)
            return cannot("write", journal);
        if (!S_ISREG(opened.st_mode))
            return fail("cannot write %s: it is no regular file", journal->path);
        if (lock(journal) != STATUS_OK)
            return STATUS_FAILED;
        if (stat(journal->path, &named) == 0 && named.st_ino == opened.st_ino && named.st_dev == opened.st_dev)
            return STATUS_OK;
        close(journal->fd);
        journal->fd = -1;
    }
}

static int foreign(const struct journal *journal, const char *title)
{
    enum { SHOWN = 300 };
    static const char start[] = "corgen ";
    if (strncmp(title, start, sizeof start - 1) != 0)
        return fail("%s is no unfinished sweep of corgen; remove it or choose another --output", journal->path);
    const char *command = strstr(title, ": ");
    return fail("%s holds rows of another sweep, '%.*s%s'; finish it by that command, remove it or choose another "
                "--output",
                journal->path, SHOWN, command ? command + 2 : title,
                command && strlen(command + 2) > SHOWN ? "..." : "");
}

/* A title says what the sweep is, and behind a colon how the command was written, which does not matter. */
static bool same_sweep(const char *title, const char *other)
{
    const char *colon = strchr(title, ':');
    return colon ? strncmp(title, other, (size_t)(colon - title) + 1) == 0 : strcmp(title, other) == 0;
}

/* Where the good lines end, or -1 after a sentence. */
static off_t recover(struct journal *journal, const char *title, uint64_t most)
{
    enum { BLOCK = 1 << 16, LINE = 1 << 12 };
    const size_t longest = strlen(title) + LINE; /* what is longer is no line of ours */
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
                cannot("read", journal);
                return -1;
            }
            ended = n == 0;
            size += n > 0 ? (size_t)n : 0;
            continue;
        }
        if (!end)
            break;
        const size_t n = (size_t)(end - (buffer + start)) + 1;
        if (!accept(&check, buffer + start, n))
            break;
        if (!titled) {
            if (!same_sweep(title, buffer + start)) {
                foreign(journal, buffer + start);
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
        /* a first line half written is the beginning of the right one; anything else is somebody's file */
        const size_t n = strlen(title);
        const size_t same = size < n ? size : n;
        const bool beginning = size <= n + CHECK_LENGTH && memcmp(buffer, title, same) == 0;
        if (!beginning) {
            foreign(journal, "");
            free(buffer);
            return -1;
        }
    }
    free(buffer);
    return good;
}

/* The name of a new file is on the disk only when its directory is. */
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
    *journal = (struct journal){.fd = -1, .check = COR_MODE_FILE_CHECK_START, .synced = seconds_now()};
    static const char extension[] = ".part";
    const size_t size = strlen(file) + sizeof extension;
    journal->path = xmalloc(size);
    snprintf(journal->path, size, "%s%s", file, extension);
    signal(SIGXFSZ, SIG_IGN); /* a file at its size limit is a failed write, which is reported */
    off_t good = -1;
    if (open_locked(journal) == STATUS_OK)
        good = recover(journal, title, most);
    if (good >= 0 && (ftruncate(journal->fd, good) != 0 || lseek(journal->fd, good, SEEK_SET) != good)) {
        cannot("write", journal);
        good = -1;
    }
    int status = good >= 0 ? STATUS_OK : STATUS_FAILED;
    if (good == 0) {
        journal_add(journal, title);
        journal->lines = 0;
        status = journal_flush(journal);
        if (status == STATUS_OK && fsync(journal->fd) != 0 && errno != EINVAL)
            status = cannot("write", journal);
        sync_directory(journal->path);
    }
    if (status != STATUS_OK)
        journal_close(journal, false);
    return status;
}

int journal_read(struct journal *journal, void (*tell)(void *context, const char *line), void *context)
{
    if (journal_flush(journal) != STATUS_OK)
        return STATUS_FAILED;
    /* not by a second descriptor: whichever of the two is closed first takes the lock away */
    errno = 0;
    FILE *file = lseek(journal->fd, 0, SEEK_SET) == 0 ? fdopen(journal->fd, "r") : NULL;
    if (!file)
        return cannot("read", journal);
    journal->stream = file;
    char *line = NULL;
    size_t capacity = 0;
    uint64_t number = 0;
    uint32_t check = COR_MODE_FILE_CHECK_START;
    bool good = true;
    for (ssize_t n; good && number <= journal->lines && (n = getline(&line, &capacity, file)) > 0; number++) {
        good = accept(&check, line, (size_t)n);
        if (good && number > 0)
            tell(context, line);
    }
    free(line);
    good = good && number == journal->lines + 1;
    if (!good) {
        fail("%s has been changed by another program; the rows from line %" PRIu64 " on are lost", journal->path,
             number);
    }
    return good ? STATUS_OK : STATUS_FAILED;
}

void journal_close(struct journal *journal, bool done)
{
    if (done && unlink(journal->path) != 0)
        cannot("remove", journal);
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

/* What has been added is safe at any moment; the signal goes on to end the program as its sender expects. */
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
    static const char format[] = "\ncorgen: interrupted; the same command goes on where %s ends\n";
    interrupted_text = xmalloc(sizeof format + strlen(path));
    snprintf(interrupted_text, sizeof format + strlen(path), format, path);
    for (size_t i = 0; i < sizeof interrupts / sizeof *interrupts; i++) {
        sigaction(interrupts[i], NULL, &before_interrupt[i]);
        if (before_interrupt[i].sa_handler == SIG_IGN)
            continue; /* by the parent: nohup */
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
