/* SPDX-License-Identifier: MIT */
/* Independent tasks on all processors. What a task computes may not depend on another one, so that the results are the
 * same for any number of threads. */
#ifndef COR_GEN_SUPPORT_PARALLEL_H
#define COR_GEN_SUPPORT_PARALLEL_H

#include <pthread.h>
#include <stdbool.h>

#include "support/flint.h"

enum { PARALLEL_MAX_THREADS = 1024 };

/* Processors that this process may use: as many as taskset or a container allows. */
int parallel_processors(void);

/* Threads that parallel_for works on: as many as processors, or as many as the last parallel_use() said; 0: the former
 * again. */
int parallel_threads(void);
void parallel_use(int threads);

/* task(context, 0), ..., task(context, count - 1), in any order; returns when all are done. `step` names them in the
 * progress line. A task that calls parallel_for does its tasks itself, one after the other. */
void parallel_for(void (*task)(void *context, slong i), void *context, slong count, const char *step);

/* A task beside what its owner does from parallel_begin to parallel_end; done within parallel_end where there is one thread
 * only. Its own parallel_for does its tasks itself. */
struct parallel_task {
    void (*task)(void *context);
    void *context;
    pthread_t thread;
    bool started;
};
void parallel_begin(struct parallel_task *task, void (*work)(void *context), void *context);
void parallel_end(struct parallel_task *task);

/* A condition whose pthread_cond_timedwait ends at a clock_deadline. */
void parallel_condition_init(pthread_cond_t *condition);

/* Starts a thread that no signal interrupts: signals are for the thread that cleans up. 0, or an error number. */
int parallel_start_thread(pthread_t *thread, void *(*start)(void *), void *argument);

#endif
