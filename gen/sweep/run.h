/* SPDX-License-Identifier: MIT */
/* Runs a sweep on threads and writes its file. docs/disks.md. */
#ifndef COR_GEN_SWEEP_RUN_H
#define COR_GEN_SWEEP_RUN_H

#include "sweep/sweep.h"

struct sweep_request {
    struct sweep sweep; /* its lists, tolerance and angles; sweep_run computes the other fields */
    slong threads;      /* 0: one for each processor */
    enum output_format format;
    const char *output; /* file; NULL: standard output */
    const char *plot;   /* a picture of eps over the speed; NULL: none */
};

/* Returns STATUS_OK, or another status after a message. */
int sweep_run(const struct sweep_request *request);

/* ---- many numbered tasks on threads, whose results are handed back in order ---- */

/* Tasks of one parallel loop, whose results memory holds */
enum { THREADS_AT_A_TIME = 1 << 14 };

struct threads_work {
    void *context;
    size_t result_size;
    void (*work)(void *context, uint64_t task, void *result);
    /* Gets the results in order, one at a time, on any thread. A value other than 0 ends the run. */
    int (*finish)(void *context, uint64_t task, const void *result);
    void (*tick)(void *context); /* NULL, or called several times a second where threads work */
};

/* Runs tasks first, first + 1, ..., end - 1 on parallel_threads(). Returns 0, or the value of finish() that is not 0.
 */
int threads_run(const struct threads_work *work, uint64_t first, uint64_t end);

#endif
