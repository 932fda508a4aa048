/* SPDX-License-Identifier: MIT */
#ifdef __linux__
#define _GNU_SOURCE /* sched_getaffinity */
#endif
#include "support/parallel.h"

#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <unistd.h>

#include "support/console.h"

static int threads_wanted;
static _Thread_local bool within_task;

int parallel_processors(void)
{
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
#ifdef __linux__
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) == 0)
        processors = CPU_COUNT(&set);
#endif
    return processors < 1 ? 1 : processors < PARALLEL_MAX_THREADS ? (int)processors : PARALLEL_MAX_THREADS;
}

int parallel_threads(void)
{
    return threads_wanted > 0 ? threads_wanted : parallel_processors();
}

void parallel_use(int threads)
{
    threads_wanted = threads;
}

int parallel_start_thread(pthread_t *thread, void *(*start)(void *), void *argument)
{
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    const int reason = pthread_create(thread, NULL, start, argument);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return reason;
}

struct loop {
    void (*task)(void *context, slong i);
    void *context;
    slong count;
    atomic_long next, done;
};

static void loop_work(struct loop *loop, bool shows_progress)
{
    within_task = true;
    for (slong i; (i = atomic_fetch_add(&loop->next, 1)) < loop->count;) {
        loop->task(loop->context, i);
        const slong done = atomic_fetch_add(&loop->done, 1) + 1;
        if (shows_progress)
            progress_at(done);
    }
    within_task = false;
}

static void *loop_thread(void *argument)
{
    loop_work(argument, false);
    flint_cleanup(); /* constants that FLINT keeps for each thread */
    return NULL;
}

void parallel_for(void (*task)(void *context, slong i), void *context, slong count, const char *step)
{
    if (within_task) {
        for (slong i = 0; i < count; i++)
            task(context, i);
        return;
    }
    struct loop loop = {.task = task, .context = context, .count = count};
    const slong wanted = parallel_threads() < count ? parallel_threads() : count;
    pthread_t *thread = xmalloc((size_t)FLINT_MAX(wanted, 1) * sizeof *thread);
    slong started = 0;
    progress_enter(step, count);
    while (started + 1 < wanted && parallel_start_thread(&thread[started], loop_thread, &loop) == 0)
        started++;
    loop_work(&loop, true);
    while (started > 0)
        pthread_join(thread[--started], NULL);
    progress_leave();
    free(thread);
}

static void *task_thread(void *argument)
{
    const struct parallel_task *const task = argument;
    within_task = true;
    task->task(task->context);
    flint_cleanup();
    return NULL;
}

void parallel_begin(struct parallel_task *task, void (*work)(void *context), void *context)
{
    *task = (struct parallel_task){.task = work, .context = context};
    task->started =
        !within_task && parallel_threads() > 1 && parallel_start_thread(&task->thread, task_thread, task) == 0;
}

void parallel_end(struct parallel_task *task)
{
    if (task->started)
        pthread_join(task->thread, NULL);
    else
        task->task(task->context);
}
