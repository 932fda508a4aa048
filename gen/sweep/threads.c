/* SPDX-License-Identifier: MIT */
#include "sweep/threads.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "support/clock.h"
#include "support/console.h"
#include "support/parallel.h"

static const double TICK_SECONDS = 0.2;

struct run {
    const struct threads_work *work;
    pthread_mutex_t mutex; /* guards the fields down to `ready`; a slot of `result` belongs to its task until `ready` */
    pthread_cond_t may_begin, has_result;
    uint64_t next, finished, end; /* the next task to begin, the first whose result is not handed back */
    bool *ready;
    unsigned char *result; /* a ring of THREADS_AHEAD */
};

void *workspace_reserve(struct workspace *workspace, size_t size)
{
    if (size > workspace->size) {
        free(workspace->bytes);
        *workspace = (struct workspace){xmalloc(size), size};
    }
    return workspace->bytes;
}

static void *work_in_order(void *argument)
{
    struct run *const r = argument;
    struct workspace workspace = {NULL, 0};
    pthread_mutex_lock(&r->mutex);
    for (;;) {
        while (r->next < r->end && r->next - r->finished >= THREADS_AHEAD)
            pthread_cond_wait(&r->may_begin, &r->mutex);
        if (r->next >= r->end)
            break;
        const uint64_t task = r->next++;
        const size_t slot = task % THREADS_AHEAD;
        pthread_mutex_unlock(&r->mutex);
        r->work->work(r->work->context, &workspace, task, r->result + slot * r->work->result_size);
        pthread_mutex_lock(&r->mutex);
        r->ready[slot] = true;
        if (task == r->finished)
            pthread_cond_signal(&r->has_result);
    }
    pthread_mutex_unlock(&r->mutex);
    free(workspace.bytes);
    return NULL;
}

/* Hands the results back in order. The mutex is locked, except within finish() and tick(). */
static int finish_in_order(struct run *r)
{
    const struct threads_work *const work = r->work;
    int status = 0;
    struct timespec until = clock_deadline(TICK_SECONDS);
    double ticked = clock_seconds();
    while (status == 0 && r->finished < r->end) {
        const size_t slot = r->finished % THREADS_AHEAD;
        if (!r->ready[slot])
            pthread_cond_timedwait(&r->has_result, &r->mutex, &until);
        const bool ready = r->ready[slot];
        pthread_mutex_unlock(&r->mutex);
        if (ready)
            status = work->finish(work->context, r->finished, r->result + slot * work->result_size);
        if (status == 0 && clock_seconds() - ticked > TICK_SECONDS) {
            status = work->tick ? work->tick(work->context) : 0;
            ticked = clock_seconds();
            until = clock_deadline(TICK_SECONDS);
        }
        pthread_mutex_lock(&r->mutex);
        if (ready) {
            r->ready[slot] = false;
            r->finished++;
            pthread_cond_signal(&r->may_begin);
        }
    }
    return status;
}

int threads_run(const struct threads_work *work, int count, uint64_t first, uint64_t end)
{
    struct run run = {.work = work, .next = first, .finished = first, .end = end};
    pthread_t *const thread = xmalloc((size_t)count * sizeof *thread);
    run.result = xmalloc(THREADS_AHEAD * work->result_size);
    run.ready = xmalloc(THREADS_AHEAD * sizeof *run.ready);
    memset(run.ready, 0, THREADS_AHEAD * sizeof *run.ready);
    pthread_mutex_init(&run.mutex, NULL);
    pthread_cond_init(&run.may_begin, NULL);
    parallel_condition_init(&run.has_result);

    int started = 0, reason = 0;
    while (started < count && (reason = parallel_start_thread(&thread[started], work_in_order, &run)) == 0)
        started++;
    int status = started > 0 ? 0 : fail("cannot start a thread: %s", strerror(reason));
    pthread_mutex_lock(&run.mutex);
    if (started > 0)
        status = finish_in_order(&run);
    run.end = run.finished;
    pthread_cond_broadcast(&run.may_begin);
    pthread_mutex_unlock(&run.mutex);
    while (started > 0)
        pthread_join(thread[--started], NULL);

    pthread_cond_destroy(&run.has_result);
    pthread_cond_destroy(&run.may_begin);
    pthread_mutex_destroy(&run.mutex);
    free(thread);
    free(run.result);
    free(run.ready);
    return status;
}
