/* SPDX-License-Identifier: MIT */
/* Messages of corgen to its user: errors and progress on stderr. */
#ifndef COR_GEN_SUPPORT_CONSOLE_H
#define COR_GEN_SUPPORT_CONSOLE_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

/* Exit statuses of every subcommand */
enum { STATUS_OK = 0, STATUS_FAILED = 1, STATUS_USAGE = 2 };

/* main calls this first, once. Afterwards a failed allocation ends the program with a message and STATUS_FAILED. */
void console_start(void);

/* Prints "corgen: <message>\n" on stderr, escaped as by xprintable. Returns STATUS_FAILED or STATUS_USAGE, which
 * callers return. */
int fail(const char *format, ...) __attribute__((format(printf, 1, 2)));
int usage_error(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Reports that `quantity` cannot be enclosed to that many bits. Returns STATUS_FAILED. */
int fail_accuracy(const char *quantity, long bits);

/* Progress: one line on a terminal. A thread rewrites it five times per second, even while a computation calls none of
 * these functions. progress_start starts it for a subcommand. It does nothing if stderr is not a terminal. The line
 * shows the name of the subcommand, or of the last profile_step. progress("step", done, total) shows a step inside it
 * instead, until progress_end(); total = 0: unknown. Only the thread that called console_start changes the line. */
void progress_start(const char *command);
void progress(const char *step, long done, long total);
/* Like progress, with the remaining time in seconds; a negative number means unknown. */
void progress_left(const char *step, long done, long total, double left);
void progress_end(void);

/* Erase the line while other text is printed or read on the terminal, and show it again. */
void progress_hold(void);
void progress_resume(void);

/* Enters a step that consists of other steps. Until progress_leave, the line shows only this step, with the numbers
 * given to progress_at. Inner steps and inner calls of progress() and progress_end() print nothing. */
void progress_enter(const char *step, long total);
void progress_at(long done);
void progress_leave(void);

/* --profile: prints the seconds of each named step on stderr when the program ends. Steps of the same name are added.
 * The names must be string literals. */
void profile_enable(void);
void profile_step(const char *name); /* ends the current step and starts the next one; NULL: starts none */
void profile_report(void);

/* malloc, realloc, strdup and a printf that allocates. They end the program with a message and never return NULL. */
void *xmalloc(size_t size);
void *xrealloc(void *old, size_t size);
void *xgrow(void *old, size_t count, size_t size); /* makes room for element `count`, which grows by 1 in each call */
char *xstrdup(const char *text);
/* Returns a printable copy: \xNN replaces each byte that belongs to a control character or is not UTF-8. */
char *xprintable(const char *text);
char *xprintf(const char *format, ...) __attribute__((format(printf, 1, 2)));
char *xvprintf(const char *format, va_list arguments) __attribute__((format(printf, 1, 0)));

/* ---- words.c: unknown words of a command line, and names that a C function cannot have ---- */

/* Returns the edit distance of two words of at most WORD_MOST letters: the number of letters omitted, inserted,
 * replaced, or swapped with their neighbour. Ignores case. */
enum { WORD_MOST = 63 };
size_t slips_between(const char *a, const char *b);

/* Reports a usage error about a word that is not in `words`, a list that ends with NULL. Prints the message, the word
 * that was probably meant, if one is close, and all words, each after `dashes`. Returns STATUS_USAGE. */
int refuse_word(const char *word, const char *const *words, const char *dashes, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* True for a keyword of C99 to C23 or C++11 to C++23, and for std. Compilers themselves refuse other reserved names. */
bool c_name_is_reserved(const char *name);

#endif
