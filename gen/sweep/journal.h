/* SPDX-License-Identifier: MIT */
/* The rows of an unfinished sweep, kept in FILE.part until FILE can be written (docs/disks.md): a line that identifies
 * the sweep, then its first rows; only the last line may be incomplete. */
#ifndef COR_GEN_SWEEP_JOURNAL_H
#define COR_GEN_SWEEP_JOURNAL_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

struct journal {
    FILE *stream; /* locked against other processes; writes go to its end */
    char *path;
    uint64_t lines; /* rows, without the title */
    char *last;     /* the last row that journal_open found; NULL if it found none */
    double synced;
    char *interrupted; /* what SIGINT, SIGTERM and SIGHUP print while the journal is open */
};

/* Opens or creates FILE.part, whose first line is `title` (given without its line end), "corgen ...: COMMAND". A file
 * with another title is refused. Of the right file, up to `most` complete rows are kept, and everything after them
 * is cut off. Until the journal is closed, signals that end the program say how to continue. Returns STATUS_OK, or
 * STATUS_FAILED after a message. */
int journal_open(struct journal *journal, const char *file, const char *title, uint64_t most);

/* Adds a row, given without its line end. It is then safe from the end of this process, and half a minute later from a
 * power cut. */
int journal_add(struct journal *journal, const char *line);

/* Calls visit() for every row. */
int journal_read(struct journal *journal, void (*visit)(void *context, const char *line), void *context);

/* Closes the journal, and removes the file if `done`. */
void journal_close(struct journal *journal, bool done);

#endif
