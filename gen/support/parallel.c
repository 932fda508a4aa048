/* SPDX-License-Identifier: MIT */
#ifdef __linux__
#define _GNU_SOURCE /* sched_getaffinity */
#endif
#include "support/parallel.h"

#include <math.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "support/clock.h"
#include "support/console.h"

static int threads_wanted;
static _Thread_local bool within_task;

int parallel_threads(void)
{
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
#ifdef __linux__
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) == 0)
        processors = CPU_COUNT(&set);
#endif
    return threads_wanted > 0                  ? threads_wanted
           : processors < 1                    ? 1
           : processors < PARALLEL_MAX_THREADS ? (int)processors
                                               : PARALLEL_MAX_THREADS;
}

void parallel_use(int threads)
{
    threads_wanted = threads;
}

static const double PROGRESS_SECONDS = 0.2;

struct loop {
    void (*task)(void *context, slong i);
    void *context;
    int (*finish)(void *context, slong i); /* NULL if tasks need no order; then `tick` and `ready` are unused */
    void (*tick)(void *context);
    slong count;
    atomic_long next;
    atomic_int status;
    pthread_mutex_t mutex; /* protects the fields below */
    pthread_cond_t is_done;
    slong done, finished;
    bool *ready;
};

/* Does one task, if any remains. */
static bool loop_step(struct loop *loop)
{
    const slong i = atomic_fetch_add(&loop->next, 1);
    if (i >= loop->count || loop->status)
        return false;
    within_task = true;
    loop->task(loop->context, i);
    within_task = false;
    pthread_mutex_lock(&loop->mutex);
    if (loop->finish)
        for (loop->ready[i] = true; !loop->status && loop->finished < loop->count && loop->ready[loop->finished];)
            loop->status = loop->finish(loop->context, loop->finished++);
    if (++loop->done == loop->count || loop->status)
        pthread_cond_signal(&loop->is_done);
    pthread_mutex_unlock(&loop->mutex);
    return true;
}

static void *loop_thread(void *argument)
{
    while (loop_step(argument))
        continue;
    flint_cleanup(); /* frees the constants that FLINT keeps for each thread */
    return NULL;
}

static void loop_tick(struct loop *loop)
{
    if (loop->finish)
        loop->tick(loop->context);
    else
        progress_at(loop->done);
}

/* Updates the progress line while other threads work, because a task may take minutes. */
static void loop_watch(struct loop *loop)
{
    pthread_mutex_lock(&loop->mutex);
    while (loop->done < loop->count && !loop->status) {
        const double time = clock_seconds() + PROGRESS_SECONDS, whole = floor(time);
        const struct timespec until = {(time_t)whole, (long)(1e9 * (time - whole))};
        pthread_cond_timedwait(&loop->is_done, &loop->mutex, &until);
        loop_tick(loop);
    }
    pthread_mutex_unlock(&loop->mutex);
}

static void loop_run(struct loop *loop)
{
    const slong wanted = FLINT_MIN((slong)parallel_threads(), loop->count);
    pthread_t *thread = xmalloc((size_t)FLINT_MAX(wanted, 1) * sizeof *thread);
    pthread_condattr_t attributes;
    sigset_t all, before; /* only the thread that cleans up receives signals */
    slong started = 0;
    pthread_condattr_init(&attributes);
    pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC); /* the clock of clock_seconds */
    pthread_cond_init(&loop->is_done, &attributes);
    pthread_condattr_destroy(&attributes);
    pthread_mutex_init(&loop->mutex, NULL);
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    while (wanted > 1 && started < wanted && pthread_create(&thread[started], NULL, loop_thread, loop) == 0)
        started++;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    if (started > 0)
        loop_watch(loop);
    else
        while (loop_step(loop))
            loop_tick(loop);
    while (started > 0)
        pthread_join(thread[--started], NULL);
    pthread_cond_destroy(&loop->is_done);
    pthread_mutex_destroy(&loop->mutex);
    free(thread);
}

void parallel_for(void (*task)(void *context, slong i), void *context, slong count, const char *step)
{
    if (within_task) {
        for (slong i = 0; i < count; i++)
            task(context, i);
        return;
    }
    struct loop loop = {.task = task, .context = context, .count = count};
    progress_enter(step, count);
    loop_run(&loop);
    progress_leave();
}

int parallel_in_order(void (*task)(void *context, slong i), int (*finish)(void *context, slong i),
                      void (*tick)(void *context), void *context, slong count)
{
    struct loop loop = {.task = task, .context = context, .finish = finish, .tick = tick, .count = count};
    loop.ready = xmalloc((size_t)count);
    memset(loop.ready, 0, (size_t)count);
    loop_run(&loop);
    free(loop.ready);
    return loop.status;
}
