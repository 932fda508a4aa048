/* SPDX-License-Identifier: MIT */
#include "timing.h"

#include <math.h>
#include <stdlib.h>

#include "gen/support/clock.h"

enum { SLOW_SAMPLES = 4 };

static double sample(const struct job *job, long repeats)
{
    const double start = clock_seconds();
    for (long i = 0; i < repeats; i++)
        job->run(job->closure);
    return 1e9 * (clock_seconds() - start) / (double)repeats;
}

void timing_measure(struct job *jobs, size_t n, struct timing timing)
{
    long *repeats = malloc(n * sizeof *repeats);
    if (!repeats)
        abort();
    for (size_t i = 0; i < n; i++) {
        sample(&jobs[i], 1); /* fills caches and branch predictors */
        const double run_ns = sample(&jobs[i], 1);
        /* 0 marks a slow job */
        repeats[i] = run_ns > SLOW_SAMPLES * timing.sample_ns ? 0 : (long)ceil(timing.sample_ns / fmax(run_ns, 1));
        jobs[i].best_ns = HUGE_VAL;
    }
    for (int round = 0; round < timing.rounds; round++)
        for (size_t i = 0; i < n; i++) {
            const int slow = repeats[i] == 0;
            if (slow && round % timing.slow_share != 0)
                continue;
            const double run_ns = sample(&jobs[i], slow ? 1 : repeats[i]);
            jobs[i].best_ns = fmin(jobs[i].best_ns, run_ns / jobs[i].evaluations);
        }
    free(repeats);
}
