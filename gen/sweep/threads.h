/* SPDX-License-Identifier: MIT */
/* Runs many numbered tasks on threads, and hands their results back in order. */
#ifndef COR_GEN_SWEEP_THREADS_H
#define COR_GEN_SWEEP_THREADS_H

#include <stddef.h>
#include <stdint.h>

enum { THREADS_AHEAD = 1 << 14 };

/* Memory of one thread, or of one caller who begins with NULL and 0 and frees `bytes` */
struct workspace {
    void *bytes;
    size_t size;
};

/* At least `size` bytes; what was there is lost if there were fewer. */
void *workspace_reserve(struct workspace *workspace, size_t size);

/* The functions of the tasks. work() runs on a thread. The thread that calls threads_run calls the other functions. */
struct threads_work {
    void *context;
    size_t result_size;
    void (*work)(void *context, struct workspace *workspace, uint64_t task, void *result);
    /* Gets the results in order. A value other than 0 ends the run. */
    int (*finish)(void *context, uint64_t task, const void *result);
    /* NULL, or called several times a second; a value other than 0 ends the run. */
    int (*tick)(void *context);
};

/* Runs tasks first, first + 1, ..., end - 1 on `count` threads. Returns 0, or the value other than 0 that finish() or
 * tick() returned, or STATUS_FAILED after a message if no thread can be started. Memory holds THREADS_AHEAD results for
 * any number of tasks: a task begins only if it is less than THREADS_AHEAD behind the first unfinished one. */
int threads_run(const struct threads_work *work, int count, uint64_t first, uint64_t end);

#endif
