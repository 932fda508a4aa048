/* SPDX-License-Identifier: MIT */
/* Independent tasks on all processors. The result of a task must not depend on another task, so that the results are
 * the same for any number of threads. */
#ifndef COR_GEN_SUPPORT_PARALLEL_H
#define COR_GEN_SUPPORT_PARALLEL_H

#include "support/flint.h"

enum { PARALLEL_MAX_THREADS = 1024 };

/* Number of threads of parallel_for: of the processors that taskset or a container allows this process, or the argument
 * of the last parallel_use(). parallel_use(0) restores the number of processors. */
int parallel_threads(void);
void parallel_use(int threads);

/* Calls task(context, 0), ..., task(context, count - 1) in any order, and returns when all are done. `step` is the name
 * in the progress line. If a task calls parallel_for, its own thread does the inner tasks in sequence. */
void parallel_for(void (*task)(void *context, slong i), void *context, slong count, const char *step);

/* The same, and finish(context, i) as soon as the tasks up to i are done: in order, one at a time, on any thread. A
 * value other than 0 ends the run, so that no further task begins, and is returned; otherwise 0 is. tick(context),
 * never at the same time as finish(), is called by the calling thread several times a second, or after each task that
 * it does itself, instead of a progress line. */
int parallel_in_order(void (*task)(void *context, slong i), int (*finish)(void *context, slong i),
                      void (*tick)(void *context), void *context, slong count);

#endif
