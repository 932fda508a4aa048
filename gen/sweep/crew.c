/* SPDX-License-Identifier: MIT */
#include "sweep/crew.h"

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

#define QUEUE_SECONDS                                                                                                  \
    0.05 /* seconds of work queued for each thread, so that no thread runs out of tasks between two
                            * polls */
#define TICK_SECONDS 0.2
#define POLL_SECONDS 0.0005 /* between two polls for messages: an MPI that waits keeps its processor busy */

struct crew {
    struct crew_work work;
    int threads;
    pthread_t *thread;

    pthread_mutex_t mutex; /* guards the fields down to `started` */
    pthread_cond_t has_task, has_result;
    bool stopping;
    uint64_t *task; /* a ring buffer of task numbers */
    size_t task_first, tasks, tasks_max;
    unsigned char *result; /* records of finished tasks */
    size_t results;
    int started;

    double seconds;         /* average time of recent tasks; 0: not known. From here on for the coordinator only */
    size_t at_work;         /* tasks with threads of this rank whose results are not collected yet */
    size_t *at_rank;        /* the same for each other rank */
    unsigned char *waiting; /* ring buffer of CREW_AHEAD results that wait for earlier ones */
    bool *waits;
    unsigned char *taken; /* records swapped out of `result` */
};

struct interval {
    uint64_t first, count;
};

/* A record: the number of the task, the seconds it took, the result. */
enum { RECORD_HEAD = sizeof(uint64_t) + sizeof(double) };

static size_t record_size(const struct crew *crew)
{
    return RECORD_HEAD + crew->work.result_size;
}

/* ---- threads ---- */

static void *crew_thread(void *argument)
{
    struct crew *crew = argument;
    unsigned char *record = xmalloc(record_size(crew));
    pthread_mutex_lock(&crew->mutex);
    const int number = crew->started++;
    for (;;) {
        while (!crew->stopping && crew->tasks == 0)
            pthread_cond_wait(&crew->has_task, &crew->mutex);
        if (crew->stopping)
            break;
        const uint64_t task = crew->task[crew->task_first];
        crew->task_first = (crew->task_first + 1) % crew->tasks_max;
        crew->tasks--;
        pthread_mutex_unlock(&crew->mutex);

        const double start = clock_seconds();
        crew->work.work(crew->work.context, number, task, record + RECORD_HEAD);
        const double seconds = clock_seconds() - start;
        memcpy(record, &task, sizeof task);
        memcpy(record + sizeof task, &seconds, sizeof seconds);

        pthread_mutex_lock(&crew->mutex);
        memcpy(crew->result + crew->results++ * record_size(crew), record, record_size(crew));
        pthread_cond_signal(&crew->has_result);
    }
    pthread_mutex_unlock(&crew->mutex);
    free(record);
    return NULL;
}

static void crew_queue_task(struct crew *crew, uint64_t task)
{
    pthread_mutex_lock(&crew->mutex);
    crew->task[(crew->task_first + crew->tasks++) % crew->tasks_max] = task;
    pthread_cond_signal(&crew->has_task);
    pthread_mutex_unlock(&crew->mutex);
    crew->at_work++;
}

/* Waits up to `wait` seconds for results of this rank's threads, moves them to crew->taken and returns their number. */
static size_t crew_take_results(struct crew *crew, double wait)
{
    const struct timespec until = clock_deadline(wait);
    pthread_mutex_lock(&crew->mutex);
    int status = 0;
    while (crew->results == 0 && status == 0)
        status = pthread_cond_timedwait(&crew->has_result, &crew->mutex, &until);
    const size_t n = crew->results;
    unsigned char *const empty = crew->taken;
    crew->taken = crew->result;
    crew->result = empty;
    crew->results = 0;
    pthread_mutex_unlock(&crew->mutex);
    crew->at_work -= n;
    return n;
}

struct crew *crew_start(const struct crew_work *work, int threads)
{
    struct crew *crew = xmalloc(sizeof *crew);
    *crew = (struct crew){.work = *work};
    const size_t most = (size_t)threads * (QUEUE + 1);
    /* tasks of another rank can come in two messages before the first are done */
    crew->tasks_max = 2 * most;
    crew->task = xmalloc(crew->tasks_max * sizeof *crew->task);
    crew->result = xmalloc(2 * most * record_size(crew));
    crew->taken = xmalloc(2 * most * record_size(crew));
    crew->waiting = xmalloc(CREW_AHEAD * work->result_size);
    crew->waits = xmalloc(CREW_AHEAD * sizeof *crew->waits);
    crew->at_rank = xmalloc((size_t)ranks_count() * sizeof *crew->at_rank);
    memset(crew->at_rank, 0, (size_t)ranks_count() * sizeof *crew->at_rank);
    crew->thread = xmalloc((size_t)threads * sizeof *crew->thread);
    pthread_mutex_init(&crew->mutex, NULL);
    pthread_cond_init(&crew->has_task, NULL);
    parallel_condition_init(&crew->has_result);
    int reason = 0;
    while (crew->threads < threads && reason == 0) {
        reason = parallel_start_thread(&crew->thread[crew->threads], crew_thread, crew);
        crew->threads += reason == 0;
    }
    if (crew->threads == 0) {
        fail("cannot start a thread: %s", strerror(reason));
        crew_stop(crew);
        return NULL;
    }
    return crew;
}

void crew_stop(struct crew *crew)
{
    if (!crew)
        return;
    for (int rank = 1; ranks_mine() == 0 && rank < ranks_count(); rank++)
        ranks_send(rank, TAG_STOP, NULL, 0);
    pthread_mutex_lock(&crew->mutex);
    crew->stopping = true;
    pthread_cond_broadcast(&crew->has_task);
    pthread_mutex_unlock(&crew->mutex);
    for (int i = 0; i < crew->threads; i++)
        pthread_join(crew->thread[i], NULL);
    pthread_cond_destroy(&crew->has_task);
    pthread_cond_destroy(&crew->has_result);
    pthread_mutex_destroy(&crew->mutex);
    free(crew->thread);
    free(crew->task);
    free(crew->result);
    free(crew->taken);
    free(crew->waiting);
    free(crew->waits);
    free(crew->at_rank);
    free(crew);
}

/* ---- rank 0 ---- */

/* The number of tasks that a rank should hold: one for each thread, and enough to fill QUEUE_SECONDS. */
static size_t crew_tasks_wanted(const struct crew *crew)
{
    size_t each = 1;
    if (crew->seconds > 0) {
        const double more = QUEUE_SECONDS / crew->seconds;
        each += more < (double)QUEUE ? (size_t)more : QUEUE;
    }
    return each * (size_t)crew->threads;
}

static void crew_note_result(struct crew *crew, const unsigned char *record)
{
    uint64_t task;
    double seconds;
    memcpy(&task, record, sizeof task);
    memcpy(&seconds, record + sizeof task, sizeof seconds);
    crew->seconds = crew->seconds > 0 ? 0.9 * crew->seconds + 0.1 * seconds : seconds;
    memcpy(crew->waiting + task % CREW_AHEAD * crew->work.result_size, record + RECORD_HEAD, crew->work.result_size);
    crew->waits[task % CREW_AHEAD] = true;
    if (crew->work.ready)
        crew->work.ready(crew->work.context, task, record + RECORD_HEAD);
}

static void crew_note_results(struct crew *crew, const unsigned char *record, size_t n)
{
    for (size_t i = 0; i < n; i++)
        crew_note_result(crew, record + i * record_size(crew));
}

static size_t crew_tasks_away(const struct crew *crew)
{
    size_t away = crew->at_work;
    for (int rank = 1; rank < ranks_count(); rank++)
        away += crew->at_rank[rank];
    return away;
}

/* Gives tasks to every rank that holds less than it should. Another rank gets new ones only below half of that number,
 * which keeps the number of messages low. Returns the next task to give out. */
static uint64_t crew_give_out(struct crew *crew, uint64_t next, uint64_t end)
{
    const size_t wanted = crew_tasks_wanted(crew);
    for (int rank = 1; rank < ranks_count() && next < end; rank++) {
        if (2 * crew->at_rank[rank] > wanted && wanted > (size_t)crew->threads)
            continue;
        struct interval tasks = {next, wanted - (crew->at_rank[rank] < wanted ? crew->at_rank[rank] : wanted)};
        if (tasks.count > end - next)
            tasks.count = end - next;
        if (tasks.count == 0)
            continue;
        ranks_send(rank, TAG_TASKS, &tasks, sizeof tasks);
        crew->at_rank[rank] += (size_t)tasks.count;
        next += tasks.count;
    }
    for (; crew->at_work < wanted && next < end; next++)
        crew_queue_task(crew, next);
    return next;
}

/* Removes the tasks that no thread has begun. */
static void crew_drop_queue(struct crew *crew)
{
    pthread_mutex_lock(&crew->mutex);
    crew->at_work -= crew->tasks;
    crew->tasks = 0;
    pthread_mutex_unlock(&crew->mutex);
}

int crew_run(struct crew *crew, uint64_t first, uint64_t end)
{
    uint64_t next = first; /* first task not given out yet */
    uint64_t finished = first;
    int status = 0;
    double ticked = clock_seconds();
    memset(crew->waits, 0, CREW_AHEAD * sizeof *crew->waits);
    while (status == 0 ? finished < end : crew_tasks_away(crew) > 0) {
        if (status != 0)
            crew_drop_queue(crew);
        if (status == 0)
            next = crew_give_out(crew, next, end - finished < CREW_AHEAD ? end : finished + CREW_AHEAD);
        const size_t n = crew_take_results(crew, ranks_count() > 1 ? POLL_SECONDS : TICK_SECONDS);
        crew_note_results(crew, crew->taken, n);
        int rank, tag;
        void *bytes;
        size_t size;
        while (ranks_receive(&rank, &tag, &bytes, &size)) {
            const size_t count = size / record_size(crew);
            crew->at_rank[rank] -= count;
            crew_note_results(crew, bytes, count);
            free(bytes);
        }
        for (; status == 0 && finished < end && crew->waits[finished % CREW_AHEAD]; finished++) {
            crew->waits[finished % CREW_AHEAD] = false;
            status = crew->work.finish(crew->work.context, finished,
                                       crew->waiting + finished % CREW_AHEAD * crew->work.result_size);
        }
        const double now = clock_seconds();
        if (status == 0 && crew->work.tick && (now - ticked > TICK_SECONDS || finished == end)) {
            ticked = now;
            status = crew->work.tick(crew->work.context);
        }
    }
    return status;
}

void crew_broadcast(struct crew *crew, const void *bytes, size_t n)
{
    (void)crew;
    for (int rank = 1; rank < ranks_count(); rank++)
        ranks_send(rank, TAG_BROADCAST, bytes, n);
}

/* ---- the other ranks ---- */

void crew_serve(struct crew *crew)
{
    for (bool stop = false; !stop || crew->at_work > 0;) {
        const size_t n = crew_take_results(crew, POLL_SECONDS);
        if (n > 0)
            ranks_send(0, TAG_RESULTS, crew->taken, n * record_size(crew));
        int rank, tag;
        void *bytes;
        size_t size;
        while (!stop && ranks_receive(&rank, &tag, &bytes, &size)) {
            if (tag == TAG_TASKS) {
                struct interval tasks;
                memcpy(&tasks, bytes, sizeof tasks);
                for (uint64_t i = 0; i < tasks.count; i++)
                    crew_queue_task(crew, tasks.first + i);
            } else if (tag == TAG_BROADCAST) {
                crew->work.received(crew->work.context, bytes, size);
            }
            stop = tag == TAG_STOP;
            free(bytes);
        }
    }
}
