/* SPDX-License-Identifier: MIT */
/* Where corgen's results go: tables in three formats, and files that are replaced whole or not at all. */
#ifndef COR_GEN_SUPPORT_OUTPUT_H
#define COR_GEN_SUPPORT_OUTPUT_H

#include <stdbool.h>
#include <stdio.h>

enum output_format { FORMAT_TEXT, FORMAT_CSV, FORMAT_JSON, FORMAT_LATEX };

/* A path that names a regular file, or none yet: a temporary file is opened beside it. A commit flushes and syncs it and
 * renames it over the path. Any failure, exit() at any place, and SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGABRT or
 * SIGXCPU at any time removes it. The new file has the mode, owner and group of the one it replaces. A file with several
 * names, or with an owner that cannot be given away, is overwritten in place from the complete temporary file, so that
 * every name shows the new text. A symbolic link stays: what it points to is written, even if that does not exist yet.
 *
 * Everything else is written directly: standard output (path NULL), a terminal, a pipe, /dev/null, and an open
 * descriptor by its name, as /dev/stdout or /dev/fd/3, which keeps its position and appends where it was opened to. */
struct output {
    FILE *file;
    const char *path; /* as given, for messages; NULL = standard output */
    char *target;     /* the file to be replaced, links resolved; NULL = written directly */
    char *temporary;
    bool in_place; /* overwrite the target instead of renaming */
};

/* Whether the path, or NULL, is written directly: nothing can be kept beside it. */
bool output_is_direct(const char *path);

/* Each returns STATUS_OK, or STATUS_FAILED after saying why on stderr; then nothing is left behind. */
int output_open(struct output *out, const char *path);
int output_commit(struct output *out); /* also reports a full disk behind standard output */

/* Commits a set: every file is complete on the disk before the first one is renamed, and no signal
 * comes between the renames. Discards them all if one fails. */
int output_commit_all(struct output *out, int n);

void output_discard(struct output *out);

/* A table of strings: the header row names the columns exactly as the contract does. In json it is an array of objects; a
 * column is unquoted if every cell in it is a JSON number that a double holds: no whole number beyond 2^53. */
struct table {
    const char *const *column;
    int columns;
    char **cell; /* row-major, malloc'ed strings */
    long cells, capacity;
};

void table_init(struct table *t, const char *const *column, int columns);
void table_add(struct table *t, char *cell); /* takes ownership, row-major order */
void table_add_integer(struct table *t, long value);
void table_print(const struct table *t, enum output_format format, FILE *file); /* not FORMAT_LATEX */
void table_clear(struct table *t);

#endif
