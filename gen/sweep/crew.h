/* SPDX-License-Identifier: MIT */
/* Runs many numbered tasks on threads, and on the other ranks of an mpirun if there are any, and hands their results
 * back in order. */
#ifndef COR_GEN_SWEEP_CREW_H
#define COR_GEN_SWEEP_CREW_H

#include <stddef.h>
#include <stdint.h>

enum { CREW_AHEAD = 1 << 14 };

/* The functions of the tasks. work() runs on a thread, which is numbered from 0. The thread that calls crew_run calls
 * the other functions. */
struct crew_work {
    void *context;
    size_t result_size;
    void (*work)(void *context, int thread, uint64_t task, void *result);
    /* Rank 0: ready() gets each result as soon as it is there, finish() in order. A finish() that returns a value other
     * than 0 ends the run. */
    void (*ready)(void *context, uint64_t task, const void *result);
    int (*finish)(void *context, uint64_t task, const void *result);
    /* Rank 0: called several times a second; a value other than 0 ends the run. */
    int (*tick)(void *context);
    /* Other ranks: gets the bytes that rank 0 sends by crew_broadcast. */
    void (*received)(void *context, const void *bytes, size_t n);
};

struct crew;

/* Starts the threads. Returns NULL after a message if no thread can be started. */
struct crew *crew_start(const struct crew_work *work, int threads);
void crew_stop(struct crew *crew); /* on rank 0 this also ends crew_serve on every other rank */

/* Rank 0: runs tasks first, first + 1, ..., end - 1. Returns 0, or the value other than 0 that finish() or tick()
 * returned. Memory holds CREW_AHEAD results for any number of tasks: a task is given out only if it is less than
 * CREW_AHEAD behind the first unfinished one. */
int crew_run(struct crew *crew, uint64_t first, uint64_t end);

/* Rank 0, between runs: every other rank calls received() with these bytes before it gets further tasks. */
void crew_broadcast(struct crew *crew, const void *bytes, size_t n);

/* The other ranks: does tasks for rank 0 until rank 0 calls crew_stop. */
void crew_serve(struct crew *crew);

#endif
