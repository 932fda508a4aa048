/* SPDX-License-Identifier: MIT */
/* Times of short jobs on a machine that does other things too: jobs take turns, so that what slows the machine
 * down for a while slows all of them, and the least time of many turns is each job's time. */
#ifndef COR_BENCH_SUPPORT_TIMING_H
#define COR_BENCH_SUPPORT_TIMING_H

#include <stddef.h>

struct job {
    void (*run)(void *); /* does `evaluations` evaluations */
    void *closure;
    double evaluations;
    double best_ns; /* out: per evaluation */
};

struct timing {
    double sample_ns; /* a turn of a job lasts at least so long */
    int rounds;       /* turns of a job */
    int slow_share;   /* a job whose run takes several such times has one turn in so many */
};

/* Runs every job by turns and fills best_ns. */
void timing_measure(struct job *jobs, size_t n, struct timing timing);

#endif
