/* SPDX-License-Identifier: MIT */
#include "support/clock.h"

static double seconds_of(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double clock_seconds(void)
{
    return seconds_of(CLOCK_MONOTONIC);
}

double clock_processor_seconds(void)
{
    return seconds_of(CLOCK_PROCESS_CPUTIME_ID);
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
