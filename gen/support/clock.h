/* SPDX-License-Identifier: MIT */
/* The clocks of corgen, of the benchmarks and of the figures of the papers. */
#ifndef COR_GEN_SUPPORT_CLOCK_H
#define COR_GEN_SUPPORT_CLOCK_H

#include <time.h>

/* Seconds of a monotonic clock; only differences have a meaning. */
double clock_seconds(void);

/* The time `seconds` from now, for a condition that waits by CLOCK_MONOTONIC */
struct timespec clock_deadline(double seconds);

#endif
