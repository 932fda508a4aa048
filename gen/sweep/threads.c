/* SPDX-License-Identifier: MIT */
#include "sweep/threads.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"
#include "support/parallel.h"

enum { AT_A_TIME = 1 << 20 /* tasks of one parallel loop, which goes on to its end after a failure */ };

struct run {
    const struct threads_work *work;
    uint64_t first;
    pthread_mutex_t mutex; /* guards all below but a result whose task is not ready */
    pthread_cond_t may_begin;
    uint64_t finished, end; /* the first task whose result is not handed back */
    int status;
    bool *ready;
    unsigned char *result; /* a ring of THREADS_AHEAD */
};

static void finish_in_order(struct run *r)
{
    while (r->status == 0 && r->finished < r->end && r->ready[r->finished % THREADS_AHEAD]) {
        const size_t slot = r->finished % THREADS_AHEAD;
        r->status = r->work->finish(r->work->context, r->finished, r->result + slot * r->work->result_size);
        r->ready[slot] = false;
        r->finished++;
    }
    pthread_cond_broadcast(&r->may_begin);
}

static void work_in_order(void *context, slong i)
{
    struct run *const r = context;
    const uint64_t task = r->first + (uint64_t)i;
    const size_t slot = task % THREADS_AHEAD;
    pthread_mutex_lock(&r->mutex);
    while (r->status == 0 && task - r->finished >= THREADS_AHEAD)
        pthread_cond_wait(&r->may_begin, &r->mutex);
    const bool begins = r->status == 0;
    pthread_mutex_unlock(&r->mutex);
    if (!begins)
        return;
    r->work->work(r->work->context, task, r->result + slot * r->work->result_size);
    pthread_mutex_lock(&r->mutex);
    r->ready[slot] = true;
    finish_in_order(r);
    pthread_mutex_unlock(&r->mutex);
}

static void tick_in_order(void *context)
{
    struct run *const r = context;
    pthread_mutex_lock(&r->mutex);
    if (r->work->tick)
        r->work->tick(r->work->context);
    pthread_mutex_unlock(&r->mutex);
}

int threads_run(const struct threads_work *work, int count, uint64_t first, uint64_t end)
{
    struct run run = {.work = work, .first = first, .finished = first, .end = end};
    run.result = xmalloc(THREADS_AHEAD * work->result_size);
    run.ready = xmalloc(THREADS_AHEAD * sizeof *run.ready);
    memset(run.ready, 0, THREADS_AHEAD * sizeof *run.ready);
    pthread_mutex_init(&run.mutex, NULL);
    pthread_cond_init(&run.may_begin, NULL);
    parallel_use(count);
    for (; run.first < end && run.status == 0; run.first += AT_A_TIME)
        parallel_watched(work_in_order, &run, end - run.first < AT_A_TIME ? (slong)(end - run.first) : AT_A_TIME,
                         tick_in_order);
    pthread_cond_destroy(&run.may_begin);
    pthread_mutex_destroy(&run.mutex);
    free(run.result);
    free(run.ready);
    return run.status;
}
