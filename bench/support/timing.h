/* SPDX-License-Identifier: MIT */
/* Times of short jobs on a machine that also does other work. Jobs alternate, so a temporary slowdown of the machine
 * affects all of them. The time of a job is the least of many rounds. */
#ifndef COR_BENCH_SUPPORT_TIMING_H
#define COR_BENCH_SUPPORT_TIMING_H

#include <stddef.h>

struct job {
    void (*run)(void *); /* does `evaluations` evaluations */
    void *closure;
    double evaluations;
    double best_ns; /* the result: time of one evaluation */
};

struct timing {
    double sample_ns; /* shortest duration of a job in a round */
    int rounds;       /* rounds of a job */
    int slow_share;   /* a job that takes several sample_ns runs only in every slow_share-th round */
};

/* Runs all jobs in turn and sets best_ns. */
void timing_measure(struct job *jobs, size_t n, struct timing timing);

#endif
