/* SPDX-License-Identifier: MIT */
/* Runs many numbered tasks on threads, and hands their results back in order. */
#ifndef COR_GEN_SWEEP_THREADS_H
#define COR_GEN_SWEEP_THREADS_H

#include <stddef.h>
#include <stdint.h>

/* Tasks of one parallel loop, whose results memory holds */
enum { THREADS_AT_A_TIME = 1 << 14 };

/* The functions of the tasks */
struct threads_work {
    void *context;
    size_t result_size;
    void (*work)(void *context, uint64_t task, void *result);
    /* Gets the results in order, one at a time, on any thread. A value other than 0 ends the run. */
    int (*finish)(void *context, uint64_t task, const void *result);
    void (*tick)(void *context); /* NULL, or called several times a second where threads work */
};

/* Runs tasks first, first + 1, ..., end - 1 on `count` threads, which parallel_use() sets. Returns 0, or the value of
 * finish() that is not 0. */
int threads_run(const struct threads_work *work, int count, uint64_t first, uint64_t end);

#endif
