/* SPDX-License-Identifier: MIT */
/* The rows of an unfinished sweep in a file beside the one they are for: FILE.part for FILE. At any moment, whatever
 * ends the program, it is a beginning of what it will be, but for a line half written. docs/disk-collide.md. */
#ifndef COR_GEN_SWEEP_JOURNAL_H
#define COR_GEN_SWEEP_JOURNAL_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

struct journal {
    int fd;       /* locked against other processes */
    FILE *stream; /* of fd, once it has been read */
    char *path;
    uint32_t check;
    uint64_t lines; /* good ones, behind the first */
    char *last;     /* of those found, without check; NULL if none were */
    char *pending;  /* not yet given to the system */
    size_t pending_size, pending_capacity;
    double synced;
};

/* Opens or makes FILE.part. title: its first line, without end. A file whose first line differs before the first colon
 * is refused; of the right one, the lines that are as they were written are kept, up to `most` of them, and what
 * follows is cut off. STATUS_OK, or STATUS_FAILED after saying why. */
int journal_open(struct journal *journal, const char *file, const char *title, uint64_t most);

/* Adds a line, without its end. It survives this process once journal_flush has returned, and the machine's end within
 * half a minute. */
void journal_add(struct journal *journal, const char *line);
int journal_flush(struct journal *journal);

/* Every line again, without its check. */
int journal_read(struct journal *journal, void (*tell)(void *context, const char *line), void *context);

/* From now on, and not any more: SIGINT, SIGTERM and SIGHUP say where the journal is before they end the program. */
void journal_say_on_interrupt(const struct journal *journal);
void journal_silent_on_interrupt(void);

/* Closes it; `done` removes it. */
void journal_close(struct journal *journal, bool done);

#endif
