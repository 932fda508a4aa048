/* SPDX-License-Identifier: MIT */
/* The search for the worst error of a function of one double, which test_accuracy.c and test_laws.c share: random
 * points on several threads, every double near a place, uphill from the worst point; options. */
#ifndef COR_TESTS_ACCURACY_SEARCH_H
#define COR_TESTS_ACCURACY_SEARCH_H

#include <stdbool.h>
#include <stdint.h>

#include "random.h"

struct search_function {
    const char *name;
    double (*value)(double);
    double last;           /* the largest argument: 1 of an inverse, else infinity */
    uint64_t largest_rise; /* of a function that falls from 1 to 0, in ulp, from one double >= 0 to the next */
    bool falls;
    double (*error)(const void *row, double computed, double x); /* in ulp; infinite or NaN where it is wrong */
    double (*random_argument)(struct random_state *r, const void *row);
    const void *row; /* of the table of the test */
};

struct worst {
    double error, at, rise_at;
    uint64_t points, rises; /* rises: the function rose too much, or left [0, 1] */
};

void worst_take(struct worst *worst, double error, double at);

/* One random point, and the order of its value and the next double's */
void worst_random(struct worst *worst, const struct search_function *f, struct random_state *r);

/* Every double from `radius` before |x| to as many after it, with the sign of x: error, order, range */
void worst_walk(struct worst *worst, const struct search_function *f, double x, uint64_t radius);

/* Uphill from the worst point so far, while there is a worse one within `radius`, `turns` times at most */
void worst_climb(struct worst *worst, const struct search_function *f, uint64_t radius, int turns);

/* Whether the values at 0, 1 and infinity, next to them and outside of domains are within the bound; prints others */
bool specials_are_good(const struct search_function *f, double bound);

/* Prints the heading of the lines of worst_report. */
void worst_heading(uint64_t seed);

/* Prints one line; returns whether the worst error is within the bound and nothing rose. */
bool worst_report(const char *name, const char *suffix, const struct worst *worst, double bound);

enum { SEARCH_MAX_THREADS = 64 };

struct search_options {
    uint64_t points, seed, stride, times; /* 0: there are no --stride and --hashes, no --times */
    int threads;
    const char *only; /* part of the names of the functions wanted; NULL for all */
    const char *hashes;
};

/* Reads --points, --threads, --seed, --only, --stride, --hashes and --times. Returns 0, or the exit status: 2 after the
 * help for wrong ones, 77 where long double is too short for a reference. */
int search_options_read(struct search_options *o, int argc, char **argv, const char *help);

/* The worst of so many random points, on the threads of the options */
struct worst search_random(const struct search_function *f, const struct search_options *o, uint64_t points);

bool search_wants(const struct search_options *o, const char *name);

/* The parts of test_accuracy: the reference against balls, and the functions of floats. They print what they find. */
bool reference_is_good(const struct search_options *o);
bool floats_are_good(const struct search_options *o);

/* Calls part(job of size `size`) for each of the jobs, on as many threads. */
void search_on_threads(void *(*part)(void *), void *jobs, size_t size, int threads);

#endif
