/* SPDX-License-Identifier: MIT */
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "support/console.h"
#include "support/parallel.h"
#include "sweep/run.h"

struct run {
    const struct threads_work *work;
    uint64_t first;
    pthread_mutex_t mutex; /* guards all below but a result whose task is not ready */
    slong finished, count; /* the first task whose result is not handed back, and all, of this loop */
    int status;
    bool ready[THREADS_AT_A_TIME];
    unsigned char *result;
};

static void work_in_order(void *context, slong i)
{
    struct run *const r = context;
    const size_t size = r->work->result_size;
    pthread_mutex_lock(&r->mutex);
    const bool begins = r->status == 0;
    pthread_mutex_unlock(&r->mutex);
    if (!begins)
        return;
    r->work->work(r->work->context, r->first + (uint64_t)i, r->result + (size_t)i * size);
    pthread_mutex_lock(&r->mutex);
    r->ready[i] = true;
    for (; r->status == 0 && r->finished < r->count && r->ready[r->finished]; r->finished++)
        r->status =
            r->work->finish(r->work->context, r->first + (uint64_t)r->finished, r->result + (size_t)r->finished * size);
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

int threads_run(const struct threads_work *work, uint64_t first, uint64_t end)
{
    struct run run = {.work = work, .first = first, .result = xmalloc(THREADS_AT_A_TIME * work->result_size)};
    pthread_mutex_init(&run.mutex, NULL);
    for (; run.first < end && run.status == 0; run.first += THREADS_AT_A_TIME) {
        run.count = end - run.first < THREADS_AT_A_TIME ? (slong)(end - run.first) : THREADS_AT_A_TIME;
        run.finished = 0;
        memset(run.ready, 0, sizeof run.ready);
        parallel_watched(work_in_order, &run, run.count, tick_in_order);
    }
    pthread_mutex_destroy(&run.mutex);
    free(run.result);
    return run.status;
}
