/* SPDX-License-Identifier: MIT */
#include "sweep/threads.h"

#include <errno.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "support/clock.h"
#include "support/console.h"
#include "support/parallel.h"
#include "sweep/ranks.h"

/* QUEUE: the most tasks that wait for each thread. */
enum { QUEUE = 64, TAG_TASKS = 1, TAG_RESULTS, TAG_BROADCAST, TAG_STOP };

/* seconds of work queued for each thread, so that no thread runs out of tasks between two polls */
#define QUEUE_SECONDS 0.05
#define TICK_SECONDS 0.2
#define POLL_SECONDS 0.0005 /* between two polls for messages: an MPI that waits keeps its processor busy */

struct threads {
    struct threads_work work;
    int count;
    pthread_t *thread;

    pthread_mutex_t mutex; /* guards the fields down to `results` */
    pthread_cond_t has_task, has_result;
    bool stopping;
    uint64_t *task; /* a ring buffer of task numbers */
    size_t task_first, tasks, tasks_max;
    unsigned char *result; /* records of finished tasks */
    size_t results;

    double seconds;         /* average time of recent tasks; 0: not known. From here on for the coordinator only */
    size_t at_work;         /* tasks with threads of this rank whose results are not collected yet */
    size_t *at_rank;        /* the same for each other rank */
    unsigned char *waiting; /* ring buffer of THREADS_AHEAD results that wait for earlier ones */
    bool *waits;
    unsigned char *taken; /* records swapped out of `result` */
};

struct interval {
    uint64_t first, count;
};

/* A record: the number of the task, the seconds it took, the result. */
enum { RECORD_HEAD = sizeof(uint64_t) + sizeof(double) };

static size_t record_size(const struct threads *t)
{
    return RECORD_HEAD + t->work.result_size;
}

/* ---- threads ---- */

void *workspace_reserve(struct workspace *workspace, size_t size)
{
    if (size > workspace->size) {
        free(workspace->bytes);
        *workspace = (struct workspace){xmalloc(size), size};
    }
    return workspace->bytes;
}

static void *thread_main(void *argument)
{
    struct threads *t = argument;
    unsigned char *record = xmalloc(record_size(t));
    struct workspace workspace = {NULL, 0};
    pthread_mutex_lock(&t->mutex);
    for (;;) {
        while (!t->stopping && t->tasks == 0)
            pthread_cond_wait(&t->has_task, &t->mutex);
        if (t->stopping)
            break;
        const uint64_t task = t->task[t->task_first];
        t->task_first = (t->task_first + 1) % t->tasks_max;
        t->tasks--;
        pthread_mutex_unlock(&t->mutex);

        const double start = clock_seconds();
        t->work.work(t->work.context, &workspace, task, record + RECORD_HEAD);
        const double seconds = clock_seconds() - start;
        memcpy(record, &task, sizeof task);
        memcpy(record + sizeof task, &seconds, sizeof seconds);

        pthread_mutex_lock(&t->mutex);
        memcpy(t->result + t->results++ * record_size(t), record, record_size(t));
        pthread_cond_signal(&t->has_result);
    }
    pthread_mutex_unlock(&t->mutex);
    free(record);
    free(workspace.bytes);
    return NULL;
}

static void queue_task(struct threads *t, uint64_t task)
{
    pthread_mutex_lock(&t->mutex);
    t->task[(t->task_first + t->tasks++) % t->tasks_max] = task;
    pthread_cond_signal(&t->has_task);
    pthread_mutex_unlock(&t->mutex);
    t->at_work++;
}

/* Waits up to `wait` seconds for results of this rank's threads, moves them to t->taken and returns their number. */
static size_t take_results(struct threads *t, double wait)
{
    const struct timespec until = clock_deadline(wait);
    pthread_mutex_lock(&t->mutex);
    int status = 0;
    while (t->results == 0 && status == 0)
        status = pthread_cond_timedwait(&t->has_result, &t->mutex, &until);
    const size_t n = t->results;
    unsigned char *const empty = t->taken;
    t->taken = t->result;
    t->result = empty;
    t->results = 0;
    pthread_mutex_unlock(&t->mutex);
    t->at_work -= n;
    return n;
}

struct threads *threads_start(const struct threads_work *work, int count)
{
    struct threads *t = xmalloc(sizeof *t);
    *t = (struct threads){.work = *work};
    const size_t most = (size_t)count * (QUEUE + 1);
    /* tasks of another rank can come in two messages before the first are done */
    t->tasks_max = 2 * most;
    t->task = xmalloc(t->tasks_max * sizeof *t->task);
    t->result = xmalloc(2 * most * record_size(t));
    t->taken = xmalloc(2 * most * record_size(t));
    t->waiting = xmalloc(THREADS_AHEAD * work->result_size);
    t->waits = xmalloc(THREADS_AHEAD * sizeof *t->waits);
    t->at_rank = xmalloc((size_t)ranks_count() * sizeof *t->at_rank);
    memset(t->at_rank, 0, (size_t)ranks_count() * sizeof *t->at_rank);
    t->thread = xmalloc((size_t)count * sizeof *t->thread);
    pthread_mutex_init(&t->mutex, NULL);
    pthread_cond_init(&t->has_task, NULL);
    parallel_condition_init(&t->has_result);
    int reason = 0;
    while (t->count < count && reason == 0) {
        reason = parallel_start_thread(&t->thread[t->count], thread_main, t);
        t->count += reason == 0;
    }
    if (t->count == 0) {
        fail("cannot start a thread: %s", strerror(reason));
        threads_stop(t);
        return NULL;
    }
    return t;
}

void threads_stop(struct threads *t)
{
    if (!t)
        return;
    for (int rank = 1; ranks_mine() == 0 && rank < ranks_count(); rank++)
        ranks_send(rank, TAG_STOP, NULL, 0);
    pthread_mutex_lock(&t->mutex);
    t->stopping = true;
    pthread_cond_broadcast(&t->has_task);
    pthread_mutex_unlock(&t->mutex);
    for (int i = 0; i < t->count; i++)
        pthread_join(t->thread[i], NULL);
    pthread_cond_destroy(&t->has_task);
    pthread_cond_destroy(&t->has_result);
    pthread_mutex_destroy(&t->mutex);
    free(t->thread);
    free(t->task);
    free(t->result);
    free(t->taken);
    free(t->waiting);
    free(t->waits);
    free(t->at_rank);
    free(t);
}

/* ---- rank 0 ---- */

/* The number of tasks that a rank should hold: one for each thread, and enough to fill QUEUE_SECONDS. */
static size_t tasks_wanted(const struct threads *t)
{
    size_t each = 1;
    if (t->seconds > 0) {
        const double more = QUEUE_SECONDS / t->seconds;
        each += more < (double)QUEUE ? (size_t)more : QUEUE;
    }
    return each * (size_t)t->count;
}

static void note_results(struct threads *t, const unsigned char *record, size_t n)
{
    for (; n > 0; n--, record += record_size(t)) {
        uint64_t task;
        double seconds;
        memcpy(&task, record, sizeof task);
        memcpy(&seconds, record + sizeof task, sizeof seconds);
        t->seconds = t->seconds > 0 ? 0.9 * t->seconds + 0.1 * seconds : seconds;
        memcpy(t->waiting + task % THREADS_AHEAD * t->work.result_size, record + RECORD_HEAD, t->work.result_size);
        t->waits[task % THREADS_AHEAD] = true;
    }
}

static size_t tasks_away(const struct threads *t)
{
    size_t away = t->at_work;
    for (int rank = 1; rank < ranks_count(); rank++)
        away += t->at_rank[rank];
    return away;
}

/* Gives tasks to every rank that holds less than it should. Another rank gets new ones only below half of that number,
 * which keeps the number of messages low. Returns the next task to give out. */
static uint64_t give_out(struct threads *t, uint64_t next, uint64_t end)
{
    const size_t wanted = tasks_wanted(t);
    for (int rank = 1; rank < ranks_count() && next < end; rank++) {
        if (2 * t->at_rank[rank] > wanted && wanted > (size_t)t->count)
            continue;
        struct interval tasks = {next, wanted > t->at_rank[rank] ? wanted - t->at_rank[rank] : 0};
        if (tasks.count > end - next)
            tasks.count = end - next;
        if (tasks.count == 0)
            continue;
        ranks_send(rank, TAG_TASKS, &tasks, sizeof tasks);
        t->at_rank[rank] += (size_t)tasks.count;
        next += tasks.count;
    }
    for (; t->at_work < wanted && next < end; next++)
        queue_task(t, next);
    return next;
}

/* Removes the tasks that no thread has begun. */
static void drop_queue(struct threads *t)
{
    pthread_mutex_lock(&t->mutex);
    t->at_work -= t->tasks;
    t->tasks = 0;
    pthread_mutex_unlock(&t->mutex);
}

int threads_run(struct threads *t, uint64_t first, uint64_t end)
{
    uint64_t next = first; /* first task not given out yet */
    uint64_t finished = first;
    int status = 0;
    double ticked = clock_seconds();
    memset(t->waits, 0, THREADS_AHEAD * sizeof *t->waits);
    while (status == 0 ? finished < end : tasks_away(t) > 0) {
        if (status != 0)
            drop_queue(t);
        else
            next = give_out(t, next, end - finished < THREADS_AHEAD ? end : finished + THREADS_AHEAD);
        const size_t n = take_results(t, ranks_count() > 1 ? POLL_SECONDS : TICK_SECONDS);
        note_results(t, t->taken, n);
        int rank, tag;
        void *bytes;
        size_t size;
        while (ranks_receive(&rank, &tag, &bytes, &size)) {
            const size_t count = size / record_size(t);
            t->at_rank[rank] -= count;
            note_results(t, bytes, count);
            free(bytes);
        }
        for (; status == 0 && finished < end && t->waits[finished % THREADS_AHEAD]; finished++) {
            t->waits[finished % THREADS_AHEAD] = false;
            status =
                t->work.finish(t->work.context, finished, t->waiting + finished % THREADS_AHEAD * t->work.result_size);
        }
        const double now = clock_seconds();
        if (status == 0 && t->work.tick && (now - ticked > TICK_SECONDS || finished == end)) {
            ticked = now;
            status = t->work.tick(t->work.context);
        }
    }
    return status;
}

void threads_broadcast(struct threads *t, const void *bytes, size_t n)
{
    (void)t;
    for (int rank = 1; rank < ranks_count(); rank++)
        ranks_send(rank, TAG_BROADCAST, bytes, n);
}

/* ---- the other ranks ---- */

void threads_serve(struct threads *t)
{
    for (bool stop = false; !stop || t->at_work > 0;) {
        const size_t n = take_results(t, POLL_SECONDS);
        if (n > 0)
            ranks_send(0, TAG_RESULTS, t->taken, n * record_size(t));
        int rank, tag;
        void *bytes;
        size_t size;
        while (!stop && ranks_receive(&rank, &tag, &bytes, &size)) {
            if (tag == TAG_TASKS) {
                struct interval tasks;
                memcpy(&tasks, bytes, sizeof tasks);
                for (uint64_t i = 0; i < tasks.count; i++)
                    queue_task(t, tasks.first + i);
            } else if (tag == TAG_BROADCAST) {
                t->work.received(t->work.context, bytes, size);
            }
            stop = tag == TAG_STOP;
            free(bytes);
        }
    }
}
