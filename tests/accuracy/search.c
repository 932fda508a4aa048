/* SPDX-License-Identifier: MIT */
#include "search.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

#include "support/flint.h"
#include "ulp.h"

/* ---- the worst point ---- */

void worst_take(struct worst *worst, double error, double at)
{
    worst->points++;
    if (!(error <= worst->error)) {
        worst->error = isnan(error) ? HUGE_VAL : error;
        worst->at = at;
    }
}

static void worst_merge(struct worst *into, const struct worst *from)
{
    into->points += from->points;
    into->rises += from->rises;
    if (from->rises > 0)
        into->rise_at = from->rise_at;
    if (from->error > into->error) {
        into->error = from->error;
        into->at = from->at;
    }
}

/* The value at x, after the value at the double before x. */
static void take_order(struct worst *worst, const struct search_function *f, double before, double y, double x)
{
    if (!f->falls || !(x >= 0))
        return;
    if (!(y >= 0 && y <= 1) || (y > before && bits_of(y) - bits_of(before) > f->largest_rise)) {
        worst->rises++;
        worst->rise_at = x;
    }
}

void worst_random(struct worst *worst, const struct search_function *f, struct random_state *r)
{
    const double x = f->random_argument(r, f->row), y = f->value(x), next = nextafter(x, HUGE_VAL);
    worst_take(worst, f->error(f->row, y, x), x);
    if (f->falls) {
        take_order(worst, f, HUGE_VAL, y, x);
        take_order(worst, f, y, f->value(next), next);
    }
}

void worst_walk(struct worst *worst, const struct search_function *f, double x, uint64_t radius)
{
    const uint64_t middle = bits_of(fabs(x)), last = bits_of(f->last);
    const uint64_t low = middle > radius ? middle - radius : 0, high = middle < last - radius ? middle + radius : last;
    double before = low > 0 ? f->value(copysign(double_of(low - 1), x)) : HUGE_VAL;
    for (uint64_t bits = low; bits <= high; bits++) {
        const double at = copysign(double_of(bits), x), y = f->value(at);
        worst_take(worst, f->error(f->row, y, at), at);
        take_order(worst, f, before, y, at);
        before = y;
    }
}

void worst_climb(struct worst *worst, const struct search_function *f, uint64_t radius, int turns)
{
    for (int turn = 0; turn < turns; turn++) {
        const double error = worst->error;
        worst_walk(worst, f, worst->at, radius);
        if (!(worst->error > error))
            break;
    }
}

/* Where the value is 0 or 1, nothing else will do. */
bool specials_are_good(const struct search_function *f, double bound)
{
    static NUMBERS(specials, 0.0, -0.0, HUGE_VAL, -HUGE_VAL, NAN, -1.0, -2.0, -0x1p-1074, 1.0, 0x1p-1074, 1.5,
                   0x1p-1022, 2.0, 0x1.fffffffffffffp-1, 0x1.0000000000001p+0, -0.5, 0x1p1023);
    bool good = true;
    for (size_t i = 0; i < COUNT_OF(specials); i++) {
        const double x = specials[i], y = f->value(x);
        const bool is_0 = f->error(f->row, 0, x) == 0, is_1 = f->error(f->row, 1, x) == 0; /* both: not judged */
        if (is_0 != is_1 ? y == (is_1 ? 1 : 0) : f->error(f->row, y, x) <= bound)
            continue;
        printf("FAIL  %s(%a) = %a\n", f->name, x, y);
        good = false;
    }
    return good;
}

void worst_heading(uint64_t seed)
{
    printf("seed: %llu\n", (unsigned long long)seed);
    printf("      %-42s  %12s  %10s  %6s  %s\n", "function", "points", "worst ulp", "bound", "argument");
}

bool worst_report(const char *name, const char *suffix, const struct worst *worst, double bound)
{
    const bool good = worst->error <= bound && worst->rises == 0;
    printf("%-4s  %s%-*s  %12llu  %10.6f  %6.2f  %a\n", good ? "ok" : "FAIL", name, 42 - (int)strlen(name), suffix,
           (unsigned long long)worst->points, worst->error, bound, worst->at);
    if (worst->rises > 0)
        printf("      %s rises or leaves [0, 1] %llu times, at %a\n", name, (unsigned long long)worst->rises,
               worst->rise_at);
    fflush(stdout);
    return good;
}

/* ---- random points on threads ---- */

struct job {
    const struct search_function *f;
    uint64_t seed, first, points, step;
    struct worst worst;
};

static void *search_part(void *argument)
{
    struct job *const job = argument;
    struct random_state r = random_seeded(job->seed);
    for (uint64_t i = job->first; i < job->points; i += job->step)
        worst_random(&job->worst, job->f, &r);
    flint_cleanup();
    return NULL;
}

struct worst search_random(const struct search_function *f, const struct search_options *o, uint64_t points)
{
    struct worst worst = {0};
    struct job job[SEARCH_MAX_THREADS];
    for (int i = 0; i < o->threads; i++)
        job[i] = (struct job){
            f, o->seed * SEARCH_MAX_THREADS + (uint64_t)i, (uint64_t)i, points, (uint64_t)o->threads, worst};
    search_on_threads(search_part, job, sizeof *job, o->threads);
    for (int i = 0; i < o->threads; i++)
        worst_merge(&worst, &job[i].worst);
    return worst;
}

/* ---- options and threads ---- */

int search_options_read(struct search_options *o, int argc, char **argv, const char *help)
{
    for (int i = 1; i < argc; i += 2) {
        const double number = i + 1 < argc ? strtod(argv[i + 1], NULL) : 0;
        if (strcmp(argv[i], "--points") == 0 && number >= 1 && number <= 1e15) {
            o->points = (uint64_t)number;
        } else if (strcmp(argv[i], "--threads") == 0 && number >= 1 && number <= (double)SEARCH_MAX_THREADS) {
            o->threads = (int)number;
        } else if (strcmp(argv[i], "--seed") == 0 && number >= 0 && number <= 1e15) {
            o->seed = (uint64_t)number;
        } else if (strcmp(argv[i], "--only") == 0 && i + 1 < argc) {
            o->only = argv[i + 1];
        } else if (strcmp(argv[i], "--stride") == 0 && o->stride > 0 && number >= 1 && number <= 1e6) {
            o->stride = (uint64_t)number;
        } else if (strcmp(argv[i], "--times") == 0 && o->times > 0 && number >= 1 && number <= 1e15) {
            o->times = (uint64_t)number;
        } else if (strcmp(argv[i], "--hashes") == 0 && o->stride > 0 && i + 1 < argc) {
            o->hashes = argv[i + 1];
        } else {
            fputs(help, stderr);
            return 2;
        }
    }
    if (LDBL_MANT_DIG < 64) {
        printf("skipped: long double has only %d bits\n", LDBL_MANT_DIG);
        return 77;
    }
    return 0;
}

bool search_wants(const struct search_options *o, const char *name)
{
    return o->only == NULL || strstr(name, o->only) != NULL;
}

void search_on_threads(void *(*part)(void *), void *jobs, size_t size, int threads)
{
    pthread_t thread[SEARCH_MAX_THREADS];
    bool started[SEARCH_MAX_THREADS];
    for (int i = 0; i < threads; i++) {
        void *const job = (char *)jobs + (size_t)i * size;
        started[i] = i + 1 < threads && pthread_create(&thread[i], NULL, part, job) == 0;
        if (!started[i])
            part(job);
    }
    for (int i = 0; i < threads; i++)
        if (started[i])
            pthread_join(thread[i], NULL);
}
