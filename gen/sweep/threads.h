/* SPDX-License-Identifier: MIT */
/* Runs many numbered tasks on threads, and on the other ranks of an mpirun if there are any, and hands their results
 * back in order. */
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
    /* Rank 0: gets the results in order. A value other than 0 ends the run. */
    int (*finish)(void *context, uint64_t task, const void *result);
    /* Rank 0: called several times a second; a value other than 0 ends the run. */
    int (*tick)(void *context);
    /* Other ranks: gets the bytes that rank 0 sends by threads_broadcast. */
    void (*received)(void *context, const void *bytes, size_t n);
};

struct threads;

/* Starts the threads. Returns NULL after a message if no thread can be started. */
struct threads *threads_start(const struct threads_work *work, int count);
void threads_stop(struct threads *threads); /* on rank 0 this also ends threads_serve on every other rank */

/* Rank 0: runs tasks first, first + 1, ..., end - 1. Returns 0, or the value other than 0 that finish() or tick()
 * returned. Memory holds THREADS_AHEAD results for any number of tasks: a task is given out only if it is less than
 * THREADS_AHEAD behind the first unfinished one. */
int threads_run(struct threads *threads, uint64_t first, uint64_t end);

/* Rank 0, between runs: every other rank calls received() with these bytes before it gets further tasks. */
void threads_broadcast(struct threads *threads, const void *bytes, size_t n);

/* The other ranks: does tasks for rank 0 until rank 0 calls threads_stop. */
void threads_serve(struct threads *threads);

#endif
