/* SPDX-License-Identifier: MIT */
#include "sweep/threads.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "support/clock.h"
#include "support/console.h"
#include "support/parallel.h"
#include "sweep/ranks.h"

static const double TICK_SECONDS = 0.2;

/* Each thread of another rank has a thread of rank 0 that takes tasks from the queue in its place. The two exchange
 * messages with a tag of their own: a task, then its result; an empty message ends the run. */
enum { TAG_FIRST = 1 };

struct run {
    const struct threads_work *work;
    pthread_mutex_t mutex; /* guards the fields down to `ready`; a slot of `result` belongs to its task until `ready` */
    pthread_cond_t may_begin, has_result;
    uint64_t next, finished, end; /* the next task to begin, the first whose result is not handed back */
    bool *ready;
    unsigned char *result; /* a ring of THREADS_AHEAD */
};

struct worker {
    struct run *run; /* rank 0 only */
    const struct threads_work *work;
    pthread_t thread;
    bool started;
    int rank, tag;
};

void *workspace_reserve(struct workspace *workspace, size_t size)
{
    if (size > workspace->size) {
        free(workspace->bytes);
        *workspace = (struct workspace){xmalloc(size), size};
    }
    return workspace->bytes;
}

static void do_task(const struct worker *worker, struct workspace *workspace, uint64_t task, void *result)
{
    const struct threads_work *const work = worker->work;
    if (worker->rank == 0) {
        work->work(work->context, workspace, task, result);
        return;
    }
    size_t size;
    ranks_send(worker->rank, worker->tag, &task, sizeof task);
    void *const message = ranks_receive(worker->rank, worker->tag, &size);
    memcpy(result, message, size);
    free(message);
}

static void *work_in_order(void *argument)
{
    struct worker *const worker = argument;
    struct run *const r = worker->run;
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
        do_task(worker, &workspace, task, r->result + slot * r->work->result_size);
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

/* Starts the workers and returns how many could be started; sets *reason if not all could. */
static int start_workers(struct worker *worker, int count, void *(*start)(void *), int *reason)
{
    int started = 0;
    for (int i = 0; i < count; i++) {
        const int error = parallel_start_thread(&worker[i].thread, start, &worker[i]);
        worker[i].started = error == 0;
        started += error == 0;
        *reason = error ? error : *reason;
    }
    return started;
}

static void join_workers(struct worker *worker, int count)
{
    for (int i = 0; i < count; i++)
        if (worker[i].started)
            pthread_join(worker[i].thread, NULL);
    free(worker);
}

int threads_run(const struct threads_work *work, int count, uint64_t first, uint64_t end)
{
    struct run run = {.work = work, .next = first, .finished = first, .end = end};
    const int workers = count * ranks_count();
    struct worker *const worker = xmalloc((size_t)workers * sizeof *worker);
    for (int i = 0; i < workers; i++)
        worker[i] = (struct worker){.run = &run, .work = work, .rank = i / count, .tag = TAG_FIRST + i % count};
    run.result = xmalloc(THREADS_AHEAD * work->result_size);
    run.ready = xmalloc(THREADS_AHEAD * sizeof *run.ready);
    memset(run.ready, 0, THREADS_AHEAD * sizeof *run.ready);
    pthread_mutex_init(&run.mutex, NULL);
    pthread_cond_init(&run.may_begin, NULL);
    parallel_condition_init(&run.has_result);

    int reason = 0;
    const int started = start_workers(worker, workers, work_in_order, &reason);
    int status = started > 0 ? 0 : fail("cannot start a thread: %s", strerror(reason));
    pthread_mutex_lock(&run.mutex);
    if (started > 0)
        status = finish_in_order(&run);
    run.end = run.finished;
    pthread_cond_broadcast(&run.may_begin);
    pthread_mutex_unlock(&run.mutex);
    join_workers(worker, workers);
    for (int i = count; i < workers; i++)
        ranks_send(i / count, TAG_FIRST + i % count, NULL, 0);

    pthread_cond_destroy(&run.has_result);
    pthread_cond_destroy(&run.may_begin);
    pthread_mutex_destroy(&run.mutex);
    free(run.result);
    free(run.ready);
    return status;
}

/* ---- the other ranks ---- */

static void *work_for_rank_0(void *argument)
{
    const struct worker *const worker = argument;
    const struct threads_work *const work = worker->work;
    unsigned char *const result = xmalloc(work->result_size);
    struct workspace workspace = {NULL, 0};
    size_t size;
    for (uint64_t *task; (task = ranks_receive(0, worker->tag, &size)); free(task)) {
        work->work(work->context, &workspace, *task, result);
        ranks_send(0, worker->tag, result, work->result_size);
    }
    free(workspace.bytes);
    free(result);
    return NULL;
}

void threads_serve(const struct threads_work *work, int count)
{
    struct worker *const worker = xmalloc((size_t)count * sizeof *worker);
    for (int i = 0; i < count; i++)
        worker[i] = (struct worker){.work = work, .tag = TAG_FIRST + i};
    int reason = 0;
    if (start_workers(worker, count, work_for_rank_0, &reason) < count) { /* rank 0 would wait for ever */
        fail("cannot start a thread: %s", strerror(reason));
        exit(STATUS_FAILED);
    }
    join_workers(worker, count);
}
