/* SPDX-License-Identifier: MIT */
/* Output of corgen's results: tables in three formats, and files that are replaced completely or not at all. */
#ifndef COR_GEN_SUPPORT_OUTPUT_H
#define COR_GEN_SUPPORT_OUTPUT_H

#include <stdbool.h>
#include <stdio.h>

enum output_format { FORMAT_TEXT, FORMAT_CSV, FORMAT_JSON, FORMAT_LATEX };

/* If the path names a regular file or no file, the output stays in memory until it is committed. A commit writes a
 * temporary file in the same folder, .corgen-XXXXXX, and renames it over the file. Signals are blocked meanwhile, so
 * only SIGKILL can leave the temporary file. The new file has the mode of the file that it replaces. For a symbolic
 * link, the file behind all links is created or replaced. A file with several hard links is refused.
 *
 * All other paths are written directly: standard output (path NULL or /dev/stdout), a terminal, a pipe, /dev/null. */
struct output {
    FILE *file;
    FILE *screen;     /* if the output and stderr are terminals: the output, to which output_show moves `bytes` */
    const char *path; /* path as given, for messages; NULL: standard output */
    char *target;     /* the file to be replaced, behind all links; NULL = written directly */
    char *temporary;  /* the temporary file with the new text, during a commit */
    char *bytes;      /* text for the target or the screen */
    size_t size;
};

/* Makes a write beyond the limit of a file's size fail with an error, instead of ending the process. output_open also
 * does this. */
void output_report_size_limit(void);

/* Sets the text that SIGINT, SIGTERM and SIGHUP print before they end the process, or NULL. The caller owns it. */
void output_say_on_interrupt(const char *text);

/* True if the path, or NULL, is written directly, so that no file can be stored next to it. */
bool output_is_direct(const char *path);

/* True if two paths name one regular file, perhaps by links or by different names of its folder. */
bool output_same_file(const char *path, const char *other);

/* These functions return STATUS_OK, or STATUS_FAILED after reporting the reason on stderr. A failure leaves no files
 * behind. output_check refuses every path that output_open would refuse, so that no computation is wasted. */
int output_check(const char *path);
int output_open(struct output *out, const char *path);
int output_commit(struct output *out); /* also reports a full disk at standard output */

/* Commits a set of files. Every file is complete before the first rename, and signals are blocked between
 * the renames. If one file fails, all are discarded. */
int output_commit_all(struct output *out, int n);

/* On a terminal, shows the text written so far. Progress is hidden meanwhile. */
void output_show(struct output *out);

void output_discard(struct output *out);
int output_text(const char *path, const char *text); /* opens, writes and commits */
int output_finish(struct output *out, int status);   /* commits if the status is STATUS_OK, otherwise discards */

/* Returns the last part of a path. */
const char *file_name(const char *path);

/* Returns the malloc'ed contents of a file ("-": standard input), followed by a zero byte. Returns NULL with errno if
 * the file cannot be read or has `most` bytes or more. */
char *read_file(const char *path, size_t most, size_t *size);

/* A table of strings. An empty cell is a missing number or text. In JSON the table is an array of objects, and missing
 * or infinite numbers are null. In csv missing numbers are nan. */
enum {
    TABLE_NUMBER = 'n',
    TABLE_DIGITS = 'd', /* numbers that may have more digits than a double; JSON strings if json_strings */
    TABLE_TEXT = 't'
};
struct table {
    char *header;  /* names, separated by zeros in place of commas; column[] points into it */
    char **column; /* names */
    int columns;
    char *kinds; /* kinds of the columns, a letter each */
    bool json_strings;
    char **cell; /* row-major, malloc'ed strings */
    long cells;
};

/* Sets the names of the columns, separated by commas, and their kinds. A table begins as {0} or cleared. */
void table_init(struct table *t, const char *header, const char *kinds);
/* Reads a csv file ("-": standard input) for an option: the named columns, in any order in the file, and the number of
 * the line as the last column. The first `required` columns must exist. Without `others` the file may have no other
 * columns. Lines that are empty or begin with # are skipped. Returns STATUS_OK, or STATUS_USAGE after a message with
 * the option, the file and the line. The caller clears the table in both cases. */
int table_read(struct table *t, const char *option, const char *path, const char *columns, int required, bool others);
void table_add(struct table *t, char *cell);            /* takes ownership, row-major order */
void table_add_text(struct table *t, const char *text); /* escaped as by xprintable */
void table_add_integer(struct table *t, long value);
void table_add_number(struct table *t, double x, int digits);                   /* adds nan if x is NaN */
void table_add_known(struct table *t, double x, int digits);                    /* adds an empty cell if x is NaN */
void table_print(const struct table *t, enum output_format format, FILE *file); /* not FORMAT_LATEX */
/* Print the current rows of a table as a part of a longer table; only csv and json. first: no rows precede. */
void table_print_start(const struct table *t, enum output_format format, FILE *file);
void table_print_rows(const struct table *t, enum output_format format, bool first, FILE *file);
void table_print_end(enum output_format format, FILE *file);
void table_drop_rows(struct table *t);
void table_clear(struct table *t);

#endif
