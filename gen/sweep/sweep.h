/* SPDX-License-Identifier: MIT */
/* Computes collisions of elastic disks for every combination of the values of lists, and their lines of output. A sweep
 * of soft walls (cor_disk_collision) has four lists. A sweep of the rigid wall (cor_disk_hard_wall) has no alpha and
 * uses all modes. Its lists of alpha and modes are empty, with count 0. A sweep of Rayleigh's energy
 * (cor_disk_rayleigh) has no alpha. */
#ifndef COR_GEN_SWEEP_SWEEP_H
#define COR_GEN_SWEEP_SWEEP_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "cor/disk.h"
#include "support/output.h"
#include "sweep/hard_wall.h"
#include "sweep/values.h"

#define SWEEP_MAX_ROWS UINT64_C(1000000000)

enum { SWEEP_COLUMNS = 12, SWEEP_LINE = SWEEP_COLUMNS * DECIMAL_TEXT };

/* Rows are numbered in the order of the lists: speed varies fastest, then modes, alpha and poisson. */
struct sweep {
    struct values speed, poisson, alpha, modes;
    bool hard_wall, rayleigh;
    double tolerance;  /* allowed error of eps, or of 1 - eps^2 for the hard wall */
    slong phi_points;  /* 0: the number that the tolerance needs */
    slong part, parts; /* computes the rows part - 1, part - 1 + parts, ...; 1 of 1: all */
    uint64_t rows;
    double *eps; /* eps of each printed row, or NULL */
};

struct sweep_row {
    double speed, nu, alpha; /* alpha: infinite if its list is empty */
    size_t modes;
};

/* The numbers of a row in the order of its columns, without the status. If the status means that no result exists, they
 * are NaN and 0. */
struct sweep_result {
    double value[SWEEP_COLUMNS];
    int status;
};

extern const struct values_rule sweep_speed, sweep_poisson, sweep_alpha, sweep_modes;

/* Computes the number of rows. Returns STATUS_OK, or STATUS_USAGE after a message if there are too many. */
int sweep_count(struct sweep *sweep);

void sweep_row(struct sweep_row *row, const struct sweep *sweep, uint64_t number);
uint64_t sweep_rows_of_material(const struct sweep *sweep);

/* Collides a row. modes: for soft walls; tables: for the rigid wall */
void sweep_collide(struct sweep_result *result, const struct sweep *sweep, uint64_t number,
                   const struct cor_disk_modes *modes, struct hard_wall_tables *tables);

/* Formats a row as a line of csv without line end. Results have digits up to the second digit of their error. */
void sweep_line(char line[SWEEP_LINE], const struct sweep *sweep, const struct sweep_result *result);

/* Prints lines of csv one by one as a table in any format. */
struct sweep_printer {
    FILE *file;
    enum output_format format;
    const struct sweep *sweep;
    struct table table;                                          /* names and kinds of the columns */
    int width[SWEEP_COLUMNS], digits[SWEEP_COLUMNS];             /* columns of the text format; 0 digits: all */
    uint64_t rows, tolerance_not_reached, beyond_theory, failed; /* failed: rows without eps */
};
void sweep_print_start(struct sweep_printer *printer, const struct sweep *sweep, enum output_format format, FILE *file);
void sweep_print(void *printer, const char *line);
void sweep_print_end(struct sweep_printer *printer);

/* ---- run.c: runs a sweep on threads and writes its file (docs/disks.md) ---- */

struct sweep_request {
    struct sweep sweep; /* contains lists, tolerance and angles; sweep_run computes the rest */
    slong threads;      /* 0: one for each processor */
    enum output_format format;
    const char *output; /* file; NULL: standard output */
    const char *plot;   /* file for a picture of eps(speed); NULL: none */
    bool is_part;       /* writes the rows of a part to FILE.PART-of-PARTS.part */
    bool joins;         /* reads all rows from the files of the parts */
};

/* Returns STATUS_OK, or another status after a message. */
int sweep_run(const struct sweep_request *request);

/* ---- journal.c: FILE.part has the rows of an unfinished sweep until FILE is written (docs/disks.md). Its first line
 * identifies the sweep. Each row has a check of all lines up to it. Only the last line may be incomplete. ---- */

struct journal {
    FILE *stream; /* locked against other processes; writes go to its end */
    char *path;
    uint64_t lines;    /* rows, without the title */
    uint32_t check;    /* check of the title and these rows */
    char *last;        /* the last row that journal_open found; NULL if it found none */
    char *interrupted; /* the text that SIGINT, SIGTERM and SIGHUP print while the journal is open */
};

/* Opens or creates FILE.part. title: its first line, "corgen ...: COMMAND", without the line end. Refuses a file with
 * another title. Otherwise keeps up to `most` correct rows and cuts off the rest, with a message if a complete row is
 * wrong. Until the journal is closed, signals that end the program print how to continue. Returns STATUS_OK, or
 * STATUS_FAILED after a message. */
int journal_open(struct journal *journal, const char *file, const char *title, uint64_t most);

/* Opens the rows of a finished part for journal_next. The file must have this title and `rows` correct rows. It is not
 * changed. Returns STATUS_OK, or STATUS_FAILED after a message. */
int journal_open_part(struct journal *journal, const char *file, const char *title, uint64_t rows);
bool journal_next(struct journal *journal, char **line); /* *line: NULL or the previous row, which is freed */

/* Adds a row, given without its line end. The file then contains the row even if this process is killed. */
int journal_add(struct journal *journal, const char *line);

int journal_read(struct journal *journal, void (*visit)(void *context, const char *line), void *context);

/* Closes the journal, and removes the file if `done`. */
void journal_close(struct journal *journal, bool done);

#endif
