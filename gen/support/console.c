/* SPDX-License-Identifier: MIT */
#define _GNU_SOURCE /* vasprintf */
#include "support/console.h"

#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#include "support/clock.h"
#include "support/flint.h"

static _Thread_local bool console_thread; /* true in the thread that called console_start */

/* The line of progress. A thread prints it repeatedly, so that no computation is silent. */
enum { STEP_NAME = 64, UPDATES_PER_SECOND = 5, PRINTABLE = 5 };
static const double SILENT_SECONDS = 0.5;

struct step {
    char name[STEP_NAME];
    long done, total; /* done: number of parts done, negative if unknown */
    double left, since;
};

static pthread_mutex_t line_lock = PTHREAD_MUTEX_INITIALIZER; /* protects the variables below */
static struct step whole, part;                               /* `part` is shown if it has a name */
static bool line_shown, line_held = true;

static void line_erase(void)
{
    if (line_shown)
        fputs("\r\033[K", stderr);
    line_shown = false;
}

/* Returns the bytes of the first character, or 0 if it is a control character, a noncharacter or not UTF-8. */
static size_t character_length(const char *text)
{
    static const unsigned least[] = {0x20, 0xa0, 0x800, 0x10000};
    const unsigned char *const byte = (const unsigned char *)text;
    const size_t more = *byte < 0x80 ? 0 : *byte < 0xe0 ? 1 : *byte < 0xf0 ? 2 : 3;
    unsigned code = more == 0 ? *byte : *byte & (0x3fU >> more);
    for (size_t i = 1; i <= more; i++) {
        if ((byte[i] & 0xc0) != 0x80)
            return 0;
        code = code << 6 | (byte[i] & 0x3f);
    }
    const bool valid = (*byte & 0xc0) != 0x80 && *byte < 0xf8 && code >= least[more] && code <= 0x10ffff;
    return valid && code != 0x7f && code >> 11 != 0x1b && (code & 0xfffe) != 0xfffe ? more + 1 : 0;
}

/* Writes the first character of a text, or \xNN for its first byte. Returns the number of bytes that were read. */
static size_t print_piece(char piece[PRINTABLE], const char *text)
{
    const size_t length = character_length(text);
    snprintf(piece, PRINTABLE, length ? "%.*s" : "%.*s\\x%02x", (int)length, text, (unsigned)(unsigned char)*text);
    return length ? length : 1;
}

/* Prints without malloc, which may have failed. */
static void print_message(const char *format, va_list arguments)
{
    static char message[1 << 16];
    char piece[PRINTABLE];
    pthread_mutex_lock(&line_lock);
    line_erase();
    vsnprintf(message, sizeof message, format, arguments);
    fputs("corgen: ", stderr);
    for (const char *at = message; *at; fputs(piece, stderr))
        at += print_piece(piece, at);
    fputc('\n', stderr);
    pthread_mutex_unlock(&line_lock);
}

int fail(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_message(format, arguments);
    va_end(arguments);
    return STATUS_FAILED;
}

int usage_error(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_message(format, arguments);
    va_end(arguments);
    return STATUS_USAGE;
}

int fail_accuracy(const char *quantity, long bits)
{
    return fail("cannot prove %s to %ld bits; use fewer digits or less damping", quantity, bits);
}

/* Handles a failure of GMP or FLINT, which would abort: exit() cleans up unfinished files. */

static FLINT_NORETURN void library_gave_up(void)
{
    exit(fail("the arithmetic library stopped; its own message is above"));
}

static void *check_granted(void *p, size_t size)
{
    if (!p)
        exit(fail("out of memory: cannot allocate a block of %zu bytes; use fewer digits or a lower order", size));
    return p;
}

void *xmalloc(size_t size)
{
    return check_granted(malloc(size ? size : 1), size);
}

static void *allocate_zeros(size_t n, size_t size)
{
    return check_granted(calloc(n ? n : 1, size ? size : 1), n * size);
}

void *xrealloc(void *old, size_t size)
{
    return check_granted(realloc(old, size ? size : 1), size);
}

/* The array is full if `count` is a power of two. */
void *xgrow(void *old, size_t count, size_t size)
{
    return (count & (count - 1)) == 0 ? xrealloc(old, (count ? 2 * count : 1) * size) : old;
}

char *xstrdup(const char *text)
{
    return xprintf("%s", text);
}

char *xprintable(const char *text)
{
    char *const whole = xmalloc(4 * strlen(text) + PRINTABLE), *to = whole;
    for (*to = '\0'; *text; to += strlen(to))
        text += print_piece(to, text);
    return whole;
}

char *xvprintf(const char *format, va_list arguments)
{
    char *text;
    return check_granted(vasprintf(&text, format, arguments) < 0 ? NULL : text, 0);
}

char *xprintf(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *const text = xvprintf(format, arguments);
    va_end(arguments);
    return text;
}

static void *gmp_realloc(void *old, size_t old_size, size_t size)
{
    (void)old_size;
    return xrealloc(old, size);
}

void console_start(void)
{
    console_thread = true;
    mp_set_memory_functions(xmalloc, gmp_realloc, NULL);
    __flint_set_memory_functions(xmalloc, allocate_zeros, xrealloc, free);
    flint_set_abort(library_gave_up);
}

/* Progress */

static bool line_watched;
static const char *command_name = "";
static int steps_entered; /* number of steps entered and not yet left */

static void line_show(const struct step *step)
{
    const double elapsed = clock_seconds() - step->since, left = step->left;
    const double unit = left >= 36000 ? 3600 : left >= 600 ? 60 : 1;
    fprintf(stderr, "\r\033[K%s: ", step->name);
    if (step->done >= 0)
        fprintf(stderr, step->total > 0 ? "%ld of %ld, " : "%ld, ", step->done, step->total);
    fprintf(stderr, "%.0f s", elapsed);
    if (left >= 0)
        fprintf(stderr, ", %.0f %s left", left / unit, unit == 3600 ? "h" : unit == 60 ? "min" : "s");
    fflush(stderr);
    line_shown = true;
}

static void *line_watch(void *nothing)
{
    static const struct timespec pause = {0, 1000000000 / UPDATES_PER_SECOND};
    const double start = clock_seconds();
    while (true) {
        nanosleep(&pause, NULL);
        pthread_mutex_lock(&line_lock);
        if (!line_held && clock_seconds() - start >= SILENT_SECONDS)
            line_show(*part.name ? &part : &whole);
        pthread_mutex_unlock(&line_lock);
    }
    return nothing;
}

void progress_hold(void)
{
    pthread_mutex_lock(&line_lock);
    line_erase();
    line_held = true;
    pthread_mutex_unlock(&line_lock);
}

void progress_resume(void)
{
    pthread_mutex_lock(&line_lock);
    line_held = !line_watched;
    pthread_mutex_unlock(&line_lock);
}

/* Updates a step. A new name begins a new step, timed from now. */
static void step_set(struct step *step, const char *name, long done, long total, double left)
{
    if (!console_thread || !line_watched)
        return;
    pthread_mutex_lock(&line_lock);
    if (strncmp(step->name, name, STEP_NAME - 1) != 0) {
        snprintf(step->name, STEP_NAME, "%s", name);
        step->since = clock_seconds();
    }
    step->done = done;
    step->total = total;
    step->left = left;
    pthread_mutex_unlock(&line_lock);
}

void progress_start(const char *command)
{
    pthread_t watch;
    sigset_t all, before; /* signals go to the thread that cleans up, as in parallel.c */
    command_name = command;
    if (!isatty(STDERR_FILENO) || line_watched)
        return;
    line_watched = true;
    step_set(&whole, command, -1, 0, -1);
    progress_resume();
    atexit(progress_hold);
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    if (pthread_create(&watch, NULL, line_watch, NULL) == 0)
        pthread_detach(watch);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
}

void progress_left(const char *step, long done, long total, double left)
{
    if (steps_entered == 0)
        step_set(&part, step, done, total, left);
}

void progress(const char *step, long done, long total)
{
    progress_left(step, done, total, -1);
}

void progress_end(void)
{
    progress("", -1, 0);
}

void progress_enter(const char *step, long total)
{
    if (console_thread && steps_entered++ == 0)
        step_set(&part, step, 0, total, -1);
}

void progress_at(long done)
{
    if (console_thread && steps_entered == 1)
        step_set(&part, part.name, done, part.total, -1);
}

void progress_leave(void)
{
    if (console_thread && --steps_entered == 0)
        progress_end();
}

/* Profile */

enum { STEPS_MAX = 64 };

static bool profile_enabled;
static struct {
    const char *name;
    double seconds;
} steps[STEPS_MAX];
static int step_count, step_now = -1;
static double step_started, profile_started;

void profile_enable(void)
{
    profile_enabled = true;
    profile_started = clock_seconds();
}

void profile_step(const char *name)
{
    step_set(&whole, name ? name : command_name, -1, 0, -1);
    if (!profile_enabled || !console_thread)
        return;
    double now = clock_seconds();
    if (step_now >= 0)
        steps[step_now].seconds += now - step_started;
    step_started = now;
    for (step_now = name ? 0 : -1; step_now >= 0 && step_now < step_count; step_now++)
        if (strcmp(steps[step_now].name, name) == 0)
            return;
    if (step_now == STEPS_MAX)
        step_now = -1;
    else if (step_now >= 0)
        steps[step_count++].name = name;
}

void profile_report(void)
{
    if (!profile_enabled)
        return;
    profile_step(NULL);
    double total = clock_seconds() - profile_started, named = 0;
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    progress_hold();
    for (int i = 0; i < step_count; i++) {
        fprintf(stderr, "profile: %10.3f s  %s\n", steps[i].seconds, steps[i].name);
        named += steps[i].seconds;
    }
    fprintf(stderr, "profile: %10.3f s  the rest\n", total > named ? total - named : 0);
    fprintf(stderr, "profile: %10.3f s  total\n", total);
    fprintf(stderr, "profile: %10.1f MB peak memory\n", (double)usage.ru_maxrss / 1024);
}
