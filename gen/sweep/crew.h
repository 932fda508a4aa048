/* SPDX-License-Identifier: MIT */
/* Many numbered tasks on threads, and on the other ranks of MPI if there are any; their results come back in order. */
#ifndef COR_GEN_SWEEP_CREW_H
#define COR_GEN_SWEEP_CREW_H

#include <stddef.h>
#include <stdint.h>

enum { CREW_AHEAD = 1 << 14 };

/* What the tasks are. work runs on a thread, numbered from 0; all else where crew_run was called. */
struct crew_work {
    void *context;
    size_t result_size;
    void (*work)(void *context, int thread, uint64_t task, void *result);
    /* Rank 0: results as they are ready, and in order; with not 0, finish ends the run. */
    void (*ready)(void *context, uint64_t task, const void *result);
    int (*finish)(void *context, uint64_t task, const void *result);
    /* Rank 0: now and then; with not 0 it ends the run too. */
    int (*tick)(void *context);
    /* Other ranks: what rank 0 told by crew_tell. */
    void (*told)(void *context, const void *bytes, size_t n);
};

struct crew;

/* Starts the threads; NULL after a sentence if there can be none. */
struct crew *crew_start(const struct crew_work *work, int threads);
void crew_stop(struct crew *crew); /* on rank 0: and all other ranks' crew_serve returns */

/* Rank 0: tasks first, first + 1, ... end - 1. 0, or what finish or tick returned. Takes memory for
 * CREW_AHEAD results, however many tasks there are: none is given out that many behind the first one not finished. */
int crew_run(struct crew *crew, uint64_t first, uint64_t end);

/* Rank 0, between runs: told() on every other rank, before the tasks to come. */
void crew_tell(struct crew *crew, const void *bytes, size_t n);

/* The other ranks: works for rank 0 till it stops. */
void crew_serve(struct crew *crew);

#endif
