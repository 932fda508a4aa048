/* SPDX-License-Identifier: MIT */
/* What corgen says to a person: errors and progress on stderr. */
#ifndef COR_GEN_SUPPORT_CONSOLE_H
#define COR_GEN_SUPPORT_CONSOLE_H

#include <stdbool.h>
#include <stddef.h>

/* Exit statuses of every subcommand. */
enum { STATUS_OK = 0, STATUS_FAILED = 1, STATUS_USAGE = 2 };

/* Once, first thing in main: file descriptors 0..2 exist, and memory that cannot be had ends the
 * program with a sentence and STATUS_FAILED instead of an abort or the kernel's out-of-memory kill.
 */
void console_start(void);

/* "corgen: <message>\n" on stderr; returns STATUS_FAILED or STATUS_USAGE so callers can return it.
 */
int fail(const char *format, ...) __attribute__((format(printf, 1, 2)));
int usage_error(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Of several processes with one command line, one says what is wrong with it. */
void console_show_usage_errors(bool show);

/* Bytes of physical memory, or 0 where the system does not tell. */
double console_memory(void);

/* One line on a terminal, rewritten in place, from the first second of a step on; silent elsewhere, and in every thread but
 * the one that called console_start.
 * progress("step", done, total), then progress_end() to erase the line. total = 0: unknown. */
void progress(const char *step, long done, long total);
/* The same with the time left in seconds; below 0: not known. */
void progress_left(const char *step, long done, long total, double left);
void progress_end(void);

/* A step that is made of others: the line shows this one alone, with what progress_at says, until progress_leave. Steps
 * entered within it, and progress() and progress_end() of what it calls, show nothing. */
void progress_enter(const char *step, long total);
void progress_at(long done);
void progress_leave(void);

/* --profile: seconds per named step on stderr when the program ends, so that growth can be seen.
 * Steps of one name add up; the names must outlive the program (string literals). */
void profile_enable(void);
void profile_step(const char *name); /* starts a step, ends the one before; NULL ends */
void profile_report(void);

/* malloc, realloc and strdup that end the program with a sentence rather than return NULL. */
void *xmalloc(size_t size);
void *xrealloc(void *old, size_t size);
char *xstrdup(const char *text);

#endif
