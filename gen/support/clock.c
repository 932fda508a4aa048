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
    struct timespec until;
    clock_gettime(CLOCK_MONOTONIC, &until);
    const long second = 1000000000;
    until.tv_sec += (time_t)seconds;
    until.tv_nsec += (long)((double)second * (seconds - (double)(time_t)seconds));
    until.tv_sec += until.tv_nsec / second;
    until.tv_nsec %= second;
    return until;
}
