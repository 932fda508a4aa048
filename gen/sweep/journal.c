/* SPDX-License-Identifier: MIT */
#include "sweep/sweep.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "runtime/disk/mode_file.h"
#include "support/console.h"
#include "support/output.h"

static int journal_failure(const char *verb, const struct journal *journal)
{
    return fail("cannot %s %s: %s", verb, journal->path, errno ? strerror(errno) : "write error");
}

/* Updates the checksum of all previous lines by one line. */
static void check_line(uint32_t *check, const char *line)
{
    *check = cor_mode_file_check(*check, line, strlen(line) + 1);
}

static int journal_put(struct journal *journal, const char *line)
{
    const bool written = fprintf(journal->stream, "%s\n", line) >= 0 && fflush(journal->stream) == 0;
    return written ? STATUS_OK : journal_failure("write", journal);
}

int journal_add(struct journal *journal, const char *line)
{
    check_line(&journal->check, line);
    char *const row = xprintf("%s,%08" PRIx32, line, journal->check);
    const int status = journal_put(journal, row);
    free(row);
    journal->lines++;
    return status;
}

/* ---- opening ---- */

/* Opens and locks the file: a part for reading, a journal for writing. A file system without locks is accepted. */
static int journal_open_locked(struct journal *journal, bool part)
{
    struct flock region = {.l_type = part ? F_RDLCK : F_WRLCK, .l_whence = SEEK_SET};
    const int flags = part ? O_RDONLY | O_NONBLOCK : O_RDWR | O_APPEND | O_CREAT;
    const char *const verb = part ? "read" : "write";
    struct stat opened;
    /* a symbolic link could lead anywhere, so it is not followed */
    const int fd = open(journal->path, flags | O_NOFOLLOW | O_CLOEXEC, 0666);
    journal->stream = fd < 0 ? NULL : fdopen(fd, part ? "r" : "a+");
    if (!journal->stream || fstat(fd, &opened) != 0)
        return journal_failure(verb, journal);
    if (!S_ISREG(opened.st_mode))
        return fail("cannot %s %s: it is not a regular file", verb, journal->path);
    if (fcntl(fd, F_SETLK, &region) != 0 && (errno == EACCES || errno == EAGAIN))
        return fail("another process uses %s; wait for it or choose another --output", journal->path);
    return STATUS_OK;
}

static int journal_refuse_foreign(const struct journal *journal, const char *title)
{
    const char *const command = strncmp(title, "corgen ", 7) == 0 ? strstr(title, ": ") : NULL;
    if (!command)
        return fail("%s is not an unfinished sweep of corgen; remove the file or choose another --output",
                    journal->path);
    return fail(
        "%s contains rows of another sweep, '%.300s'; finish that sweep, remove the file or choose another --output",
        journal->path, command + 2);
}

/* Reads a line and cuts off its end; *line is malloc'ed. False at the end, or if the line is incomplete. */
static bool read_line(struct journal *journal, char **line)
{
    size_t size = 0;
    free(*line);
    *line = NULL;
    const ssize_t n = getline(line, &size, journal->stream);
    if (n < 0) {
        free(*line);
        *line = xstrdup("");
    }
    char *const end = strchr(*line, '\n');
    if (end)
        *end = '\0';
    return end && end == *line + n - 1;
}

/* Reads a row and cuts off its checksum. Updates *check by a correct row. Returns false at the end of the file or if
 * the row is wrong. Sets *damaged to true if a complete line has the wrong checksum. */
static bool read_row(struct journal *journal, char **line, uint32_t *check, bool *damaged)
{
    char expected[16];
    uint32_t next = *check;
    *damaged = read_line(journal, line);
    char *const sum = strrchr(*line, ',');
    if (!*damaged || !sum)
        return false;
    *sum = '\0';
    check_line(&next, *line);
    snprintf(expected, sizeof expected, "%08" PRIx32, next);
    if (strcmp(sum + 1, expected) != 0)
        return false;
    *check = next;
    *damaged = false;
    return true;
}

/* Finds the first rows that are complete and correct, and cuts off the rest. */
static int journal_recover(struct journal *journal, const char *title, uint64_t most)
{
    char *line = NULL;
    off_t good;
    bool damaged = false;
    int status = STATUS_OK;
    rewind(journal->stream);
    const bool whole = read_line(journal, &line);
    /* an incomplete first line must be a prefix of the title; any other first line is from another program */
    const bool ours = whole ? strcmp(line, title) == 0
                            : ftello(journal->stream) == (off_t)strlen(line) && strncmp(line, title, strlen(line)) == 0;
    if (!ours && !ferror(journal->stream))
        status = journal_refuse_foreign(journal, whole ? line : "");
    journal->check = COR_MODE_FILE_CHECK_START;
    check_line(&journal->check, title);
    good = whole && ours ? ftello(journal->stream) : 0;
    while (good > 0 && journal->lines < most && read_row(journal, &line, &journal->check, &damaged)) {
        free(journal->last);
        journal->last = xstrdup(line);
        journal->lines++;
        good = ftello(journal->stream);
    }
    free(line);
    if (damaged)
        fail("%s: line %" PRIu64
             " was changed or is from an earlier version; corgen computes its row and all later rows again",
             journal->path, journal->lines + 2);
    if (ferror(journal->stream))
        return journal_failure("read", journal);
    if (status == STATUS_OK && (fflush(journal->stream) != 0 || ftruncate(fileno(journal->stream), good) != 0 ||
                                fseek(journal->stream, 0, SEEK_END) != 0))
        status = journal_failure("write", journal);
    if (status == STATUS_OK && good == 0)
        status = journal_put(journal, title);
    return status;
}

int journal_open(struct journal *journal, const char *file, const char *title, uint64_t most)
{
    *journal = (struct journal){.path = xprintf("%s.part", file)};
    char *const shown = xprintable(journal->path);
    journal->interrupted =
        xprintf("\ncorgen: interrupted; the same command continues after the last row of %s\n", shown);
    free(shown);
    output_report_size_limit();
    int status = journal_open_locked(journal, false);
    if (status == STATUS_OK)
        status = journal_recover(journal, title, most);
    if (status == STATUS_OK)
        output_say_on_interrupt(journal->interrupted);
    else
        journal_close(journal, false);
    return status;
}

int journal_open_part(struct journal *journal, const char *file, const char *title, uint64_t rows)
{
    const char *const part = strstr(title, " --part ");
    char *line = NULL;
    bool damaged = false;
    *journal = (struct journal){.path = xprintf("%s.part", file), .check = COR_MODE_FILE_CHECK_START};
    int status = journal_open_locked(journal, true);
    if (status == STATUS_OK && (!read_line(journal, &line) || strcmp(line, title) != 0))
        status = journal_refuse_foreign(journal, line);
    if (status == STATUS_OK) {
        check_line(&journal->check, line);
        const uint32_t start = journal->check;
        while (read_row(journal, &line, &journal->check, &damaged))
            journal->lines++;
        if (damaged || *line || journal->lines != rows)
            status =
                fail("%s, line %" PRIu64 " %s: %" PRIu64 " of %" PRIu64 " rows are correct. Run the command with%.*s "
                     "instead of --join. It keeps the correct rows",
                     journal->path, journal->lines + 2,
                     damaged                 ? "was changed"
                     : *line                 ? "is incomplete"
                     : journal->lines < rows ? "is missing"
                                             : "is one too many",
                     journal->lines, rows, (int)strcspn(part, "#"), part);
        journal->check = start;
        rewind(journal->stream);
        read_line(journal, &line);
    }
    free(line);
    return status;
}

bool journal_next(struct journal *journal, char **line)
{
    bool damaged;
    return read_row(journal, line, &journal->check, &damaged);
}

int journal_read(struct journal *journal, void (*visit)(void *context, const char *line), void *context)
{
    char *line = NULL;
    uint64_t rows = 0;
    uint32_t check = COR_MODE_FILE_CHECK_START;
    bool damaged;
    fflush(journal->stream); /* discards buffered input, because the file may have changed */
    rewind(journal->stream);
    if (read_line(journal, &line))
        check_line(&check, line);
    for (; rows < journal->lines && read_row(journal, &line, &check, &damaged); rows++)
        visit(context, line);
    free(line);
    if (rows == journal->lines)
        return STATUS_OK;
    if (ferror(journal->stream))
        return journal_failure("read", journal);
    return fail("another program has changed %s; its rows from line %" PRIu64 " onward are lost", journal->path,
                rows + 2);
}

void journal_close(struct journal *journal, bool done)
{
    output_say_on_interrupt(NULL);
    if (done && unlink(journal->path) != 0)
        journal_failure("remove", journal);
    if (journal->stream)
        fclose(journal->stream);
    free(journal->path);
    free(journal->last);
    free(journal->interrupted);
    *journal = (struct journal){0};
}
