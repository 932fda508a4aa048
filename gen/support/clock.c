/* SPDX-License-Identifier: MIT */
#include "support/clock.h"

double clock_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

struct timespec clock_deadline(double seconds)
{
    const double until = clock_seconds() + seconds;
    const time_t whole = (time_t)until;
    return (struct timespec){whole, (long)(1e9 * (until - (double)whole))};
}
