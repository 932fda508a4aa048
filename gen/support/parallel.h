/* SPDX-License-Identifier: MIT */
/* Independent tasks on all processors. The result of a task must not depend on another task, so that the results are
 * the same for any number of threads. */
#ifndef COR_GEN_SUPPORT_PARALLEL_H
#define COR_GEN_SUPPORT_PARALLEL_H

#include "support/flint.h"

enum { PARALLEL_MAX_THREADS = 1024 };

/* Returns the number of threads of parallel_for: the processors allowed by taskset or a container, or the argument of
 * the last parallel_use(). The call parallel_use(0) restores the number of processors. */
int parallel_threads(void);
void parallel_use(int threads);

/* Calls task(context, 0), ..., task(context, count - 1) in any order, and returns when all are done. `step` is the name
 * in the progress line. If a task calls parallel_for, its own thread does the inner tasks in sequence. */
void parallel_for(void (*task)(void *context, slong i), void *context, slong count, const char *step);

/* Runs the tasks like parallel_for, and calls finish(context, i) once the tasks up to i are done: in order, one at a
 * time, on any thread. If finish returns a value other than 0, no further task begins, and the value is returned.
 * Otherwise returns 0. Instead of a progress line, the calling thread calls tick(context) several times a second, or
 * after each task that it does itself. No tick runs at the same time as a finish. */
int parallel_in_order(void (*task)(void *context, slong i), int (*finish)(void *context, slong i),
                      void (*tick)(void *context), void *context, slong count);

#endif
