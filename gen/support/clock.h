/* SPDX-License-Identifier: MIT */
/* The clock of corgen, of the benchmarks and of the figures of the papers */
#ifndef COR_GEN_SUPPORT_CLOCK_H
#define COR_GEN_SUPPORT_CLOCK_H

#include <time.h>

/* Returns the seconds of a monotonic clock. Only differences have a meaning. */
static inline double clock_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

#endif
