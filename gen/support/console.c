/* SPDX-License-Identifier: MIT */
#define _GNU_SOURCE /* vasprintf */
#include "support/console.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#include "support/clock.h"
#include "support/flint.h"

static _Thread_local bool console_thread; /* the one that shows progress and measures steps */
static atomic_bool progress_shown;

static void line_erase(void)
{
    if (atomic_exchange(&progress_shown, false))
        fputs("\r\033[K", stderr);
}

static void print_message(const char *format, va_list arguments)
{
    line_erase();
    fputs("corgen: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
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

/* Memory. GMP and FLINT would abort; exit() runs the clean-up of unfinished files. */

static FLINT_NORETURN void library_gave_up(void)
{
    exit(fail("the arithmetic library could not go on; its own message stands above"));
}

static void *granted(void *p, size_t size)
{
    if (!p)
        exit(fail("out of memory: a block of %zu bytes was refused; ask for fewer digits or a lower order", size));
    return p;
}

void *xmalloc(size_t size)
{
    return granted(malloc(size ? size : 1), size);
}

static void *xcalloc(size_t n, size_t size)
{
    return granted(calloc(n ? n : 1, size ? size : 1), n * size);
}

void *xrealloc(void *old, size_t size)
{
    return granted(realloc(old, size ? size : 1), size);
}

/* There is no room behind a power of two. */
void *xgrow(void *old, size_t count, size_t size)
{
    return (count & (count - 1)) == 0 ? xrealloc(old, (count ? 2 * count : 1) * size) : old;
}

char *xstrdup(const char *text)
{
    return xprintf("%s", text);
}

char *xvprintf(const char *format, va_list arguments)
{
    char *text;
    return granted(vasprintf(&text, format, arguments) < 0 ? NULL : text, 0);
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

/* Bytes of the machine; infinite where the system does not tell, as other limits are */
static double physical_memory(void)
{
    const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
    return pages > 0 && page > 0 ? (double)pages * (double)page : (double)INFINITY;
}

int console_need(double bytes, const char *advice, const char *format, ...)
{
    struct rlimit limit;
    double memory = physical_memory();
    if (getrlimit(RLIMIT_DATA, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        memory = fmin(memory, (double)limit.rlim_cur);
    if (bytes <= memory)
        return STATUS_OK;
    va_list arguments;
    va_start(arguments, format);
    char *const what = xvprintf(format, arguments);
    va_end(arguments);
    fail("%s about %.3g GB of memory, and %.3g GB may be used%s", what, bytes / 1e9, memory / 1e9, advice);
    free(what);
    return STATUS_FAILED;
}

/* The shadow memory of a sanitizer exceeds the physical memory. */
#if defined __has_feature
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define SANITIZED 1
#endif
#elif defined __SANITIZE_ADDRESS__ || defined __SANITIZE_THREAD__
#define SANITIZED 1
#endif
#ifndef SANITIZED
#define SANITIZED 0
#endif

/* Beyond the physical memory a machine swaps or kills the process. A refused allocation can be reported. */
static void limit_memory_to_physical(void)
{
    const double physical = physical_memory();
    struct rlimit limit;
    if (SANITIZED || isinf(physical) || getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur <= (rlim_t)physical)
        return;
    limit.rlim_cur = (rlim_t)physical;
    setrlimit(RLIMIT_DATA, &limit);
}

void console_start(void)
{
    /* The first opened file would reuse a missing descriptor, and messages would go into it. The stand-in has the wrong
     * direction, so that output.c reports its use as an error. */
    for (int fd = 0; fd <= 2; fd++) {
        if (fcntl(fd, F_GETFD) == -1 && errno == EBADF && open("/dev/null", fd == 1 ? O_RDONLY : O_WRONLY) != fd)
            exit(STATUS_FAILED);
    }
    console_thread = true;
    limit_memory_to_physical();
    mp_set_memory_functions(xmalloc, gmp_realloc, NULL);
    __flint_set_memory_functions(xmalloc, xcalloc, xrealloc, free);
    flint_set_abort(library_gave_up);
}

/* Progress */

enum { UPDATES_PER_SECOND = 10 };

static double progress_started = -1;
static double progress_updated;
static struct {
    const char *step;
    long total;
    int depth; /* number of entered steps that are not left yet */
} outer;

static void progress_erase(void)
{
    line_erase();
    progress_started = -1;
}

static void progress_show(const char *step, long done, long total, double left)
{
    static int terminal = -1;
    if (terminal < 0)
        terminal = isatty(STDERR_FILENO);
    if (!terminal)
        return;
    const double now = clock_seconds();
    if (progress_started < 0)
        progress_started = now;
    const double elapsed = now - progress_started;
    if (elapsed < 1 || now - progress_updated < 1.0 / (double)UPDATES_PER_SECOND)
        return;
    progress_updated = now;
    progress_shown = true;
    if (total > 0)
        fprintf(stderr, "\r\033[K%s: %ld of %ld, %.0f s", step, done, total, elapsed);
    else
        fprintf(stderr, "\r\033[K%s: %ld, %.0f s", step, done, elapsed);
    if (left >= 36000)
        fprintf(stderr, ", %.0f h left", left / 3600);
    else if (left >= 600)
        fprintf(stderr, ", %.0f min left", left / 60);
    else if (left >= 0)
        fprintf(stderr, ", %.0f s left", left);
    fflush(stderr);
}

void progress_left(const char *step, long done, long total, double left)
{
    if (console_thread && outer.depth == 0)
        progress_show(step, done, total, left);
}

void progress(const char *step, long done, long total)
{
    progress_left(step, done, total, -1);
}

void progress_end(void)
{
    if (console_thread && outer.depth == 0)
        progress_erase();
}

void progress_enter(const char *step, long total)
{
    if (!console_thread || outer.depth++ > 0)
        return;
    outer.step = step;
    outer.total = total;
    progress_erase();
    progress_show(step, 0, total, -1);
}

void progress_at(long done)
{
    if (console_thread && outer.depth == 1)
        progress_show(outer.step, done, outer.total, -1);
}

void progress_leave(void)
{
    if (console_thread && --outer.depth == 0)
        progress_erase();
}

/* Profile */

enum { STEPS_MAX = 64 };

static bool profile_enabled;
static struct {
    const char *name;
    double seconds;
} steps[STEPS_MAX];
static int step_count;
static int step_now = -1;
static double step_started;
static double profile_started;

void profile_enable(void)
{
    profile_enabled = true;
    profile_started = clock_seconds();
}

void profile_step(const char *name)
{
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
    double total = clock_seconds() - profile_started;
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    progress_end();
    double named = 0;
    for (int i = 0; i < step_count; i++) {
        fprintf(stderr, "profile: %10.3f s  %s\n", steps[i].seconds, steps[i].name);
        named += steps[i].seconds;
    }
    fprintf(stderr, "profile: %10.3f s  the rest\n", total > named ? total - named : 0);
    fprintf(stderr, "profile: %10.3f s  total\n", total);
    fprintf(stderr, "profile: %10.1f MB peak memory\n", (double)usage.ru_maxrss / 1024);
}
