/* SPDX-License-Identifier: MIT */
/* Runs a sweep on threads and writes its file. docs/disks.md. */
#ifndef COR_GEN_SWEEP_RUN_H
#define COR_GEN_SWEEP_RUN_H

#include "sweep/sweep.h"

struct sweep_request {
    struct sweep sweep; /* its lists, tolerance and angles; sweep_run computes the other fields */
    slong threads;      /* 0: one for each processor */
    enum output_format format;
    const char *output; /* file; NULL: standard output */
    const char *plot;   /* a picture of eps over the speed; NULL: none */
};

/* Returns STATUS_OK, or another status after a message. */
int sweep_run(const struct sweep_request *request);

/* ---- journal.c: the rows of an unfinished sweep, kept in FILE.part until FILE can be written (docs/disks.md): a line
 * that identifies the sweep, then its first rows; only the last line may be incomplete ---- */

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
