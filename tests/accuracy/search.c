/* SPDX-License-Identifier: MIT */
#include "search.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

#include "support/flint.h"
#include "ulp.h"

/* ---- the error at a point ---- */

/* Returns the error of a computed inverse in ulp: the error of eps there (of 1 - eps if this is small), divided by the
 * slope. */
static double inverse_error(const struct search_function *f, const struct search_options *o, double computed, double x)
{
    const bool of_loss = f->shape == INVERSE_OF_LOSS;
    if (!(x >= 0 && x <= 1))
        return isnan(computed) ? 0 : HUGE_VAL;
    if (x == 0 || x == 1) { /* beta is 0 for eps = 1. For eps = 0 it is 1 or infinity. */
        const double last = o->exact(f, EPS, 1) == 0 ? 1 : HUGE_VAL;
        return computed == ((x == 1) != of_loss ? 0 : last) ? 0 : HUGE_VAL;
    }
    const long double other = 1 - (long double)x, eps = of_loss ? other : x, loss = of_loss ? x : other;
    if (isinf(computed)) /* infinity is right if eps at the largest double exceeds x */
        return o->exact(f, EPS, DBL_MAX) >= eps ? 0 : HUGE_VAL;
    if (of_loss && x < DBL_MIN) /* a subnormal loss is proportional to beta */
        return ulp_error(computed, (long double)f->value(0x1p-1000) * 0x1p1000L * x);
    if (!(computed > 0))
        return HUGE_VAL;
    const enum search_shape small = loss < 0.5L ? LOSS : EPS;
    const long double value = o->exact(f, small, computed), h = computed * 0x1p-20L;
    const long double off = value - (small == LOSS ? loss : eps), rise = value - o->exact(f, small, computed - h);
    return (double)(fabsl(off * h / rise) / ulp(computed));
}

double search_error(const struct search_function *f, const struct search_options *o, double computed, double x)
{
    if (search_is_inverse(f))
        return inverse_error(f, o, computed, x);
    const long double exact = o->exact(f, f->shape, x);
    return exact < 0 ? ulp_error(-computed, -exact) : ulp_error(computed, exact);
}

/* ---- the worst point ---- */

void worst_take(struct worst *worst, double error, double at)
{
    worst->points++;
    if (!(error <= worst->error)) {
        worst->error = isnan(error) ? HUGE_VAL : error;
        worst->at = at;
    }
}

/* Counts a point where eps leaves [0, 1], or rises from `before`, the value at the previous double. */
static void take_order(struct worst *worst, const struct search_function *f, const struct search_options *o,
                       double before, double y, double x)
{
    if (f->shape != EPS || !(x >= 0))
        return;
    if (!(y >= 0 && y <= 1) || (y > before && bits_of(y) - bits_of(before) > o->largest_rise)) {
        worst->rises++;
        worst->rise_at = x;
    }
}

void worst_walk(struct worst *worst, const struct search_function *f, const struct search_options *o, double x,
                uint64_t radius)
{
    const uint64_t middle = bits_of(fabs(x)), last = bits_of(search_is_inverse(f) ? 1 : HUGE_VAL);
    const uint64_t low = middle > radius ? middle - radius : 0, high = middle < last - radius ? middle + radius : last;
    double before = low > 0 ? f->value(copysign(double_of(low - 1), x)) : HUGE_VAL;
    for (uint64_t bits = low; bits <= high; bits++) {
        const double at = copysign(double_of(bits), x), y = f->value(at);
        worst_take(worst, search_error(f, o, y, at), at);
        take_order(worst, f, o, before, y, at);
        before = y;
    }
}

/* True if every value that must be 0 or 1 is correct. */
static bool specials_are_good(const struct search_function *f, const struct search_options *o)
{
    static NUMBERS(specials, 0.0, -0.0, HUGE_VAL, -HUGE_VAL, NAN, -1.0, -2.0, -0x1p-1074, 1.0, 0x1p-1074, 1.5,
                   0x1p-1022, 2.0, 0x1.fffffffffffffp-1, 0x1.0000000000001p+0, -0.5, 0x1p1023);
    bool good = true;
    for (size_t i = 0; i < COUNT_OF(specials); i++) {
        const double x = specials[i], y = f->value(x);
        const bool is_0 = search_error(f, o, 0, x) == 0, is_1 = search_error(f, o, 1, x) == 0;
        if (is_0 != is_1 ? y == (is_1 ? 1 : 0) : search_error(f, o, y, x) <= f->max_ulp)
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

bool worst_report(const char *name, const struct worst *worst, double bound)
{
    const bool good = worst->error <= bound && worst->rises == 0;
    printf("%-4s  %-42s  %12llu  %10.6f  %6.2f  %a\n", good ? "ok" : "FAIL", name, (unsigned long long)worst->points,
           worst->error, bound, worst->at);
    if (worst->rises > 0)
        printf("      %s rises or leaves [0, 1] %llu times, at %a\n", name, (unsigned long long)worst->rises,
               worst->rise_at);
    fflush(stdout);
    return good;
}

/* ---- random points on threads ---- */

struct job {
    const struct search_function *f;
    const struct search_options *o;
    uint64_t seed, first;
    struct worst worst;
};

static void *search_part(void *argument)
{
    struct job *const job = argument;
    struct random_state r = random_seeded(job->seed);
    const uint64_t points = job->o->points / (job->f->share > 0 ? job->f->share : 1);
    for (uint64_t i = job->first; i < points; i += (uint64_t)job->o->threads) {
        const double x = job->o->random_argument(&r, job->f), next = nextafter(x, HUGE_VAL), y = job->f->value(x);
        worst_take(&job->worst, search_error(job->f, job->o, y, x), x);
        take_order(&job->worst, job->f, job->o, HUGE_VAL, y, x);
        if (job->f->shape == EPS)
            take_order(&job->worst, job->f, job->o, y, job->f->value(next), next);
    }
    flint_cleanup();
    return NULL;
}

double search_worst(const struct search_function *f, const struct search_options *o)
{
    if (!search_wants(o, f->name))
        return 0;
    struct worst worst = {0};
    struct job job[SEARCH_MAX_THREADS];
    for (int i = 0; i < o->threads; i++)
        job[i] = (struct job){f, o, o->seed * SEARCH_MAX_THREADS + (uint64_t)i, (uint64_t)i, worst};
    search_on_threads(search_part, job, sizeof *job, o->threads);
    for (int i = 0; i < o->threads; i++) {
        const struct worst *const part = &job[i].worst;
        const uint64_t points = worst.points + part->points;
        worst.rises += part->rises;
        if (part->rises > 0)
            worst.rise_at = part->rise_at;
        worst_take(&worst, part->error, part->at);
        worst.points = points;
    }
    o->boundaries(&worst, f, o);
    double before = -1;
    for (int turn = 0; turn < 16 && worst.error > before; turn++) { /* search uphill from the worst point so far */
        before = worst.error;
        worst_walk(&worst, f, o, worst.at, f->share > 100 ? 2 : o->radius);
    }
    const bool good = worst_report(f->name, &worst, f->max_ulp);
    return (!o->judges_specials || specials_are_good(f, o)) && good ? worst.error : HUGE_VAL;
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
