/* SPDX-License-Identifier: MIT */
/* Searches for the worst error of a function of one double, for the programs of this folder. Tests random points on
 * several threads, every double near a place, and points uphill from the worst one. Reads options. */
#ifndef COR_TESTS_ACCURACY_SEARCH_H
#define COR_TESTS_ACCURACY_SEARCH_H

#include <stdbool.h>
#include <stdint.h>

#include "random.h"

/* The shape of a function. EPS: an eps, which decreases from 1 to 0. LOSS: 1 - eps. INVERSE and INVERSE_OF_LOSS: the
 * inverse of an eps and of a loss. OTHER: any other function. */
enum search_shape { EPS, LOSS, OTHER, INVERSE, INVERSE_OF_LOSS };

struct search_function {
    const char *name;
    double (*value)(double);
    enum search_shape shape;
    double max_ulp;
    int law, end, quantity; /* each program defines these numbers, which select the exact value */
    double exponent;
    uint64_t share; /* tests 1/share of the random points; 0: all */
};

struct worst {
    double error, at, rise_at;
    uint64_t points, rises; /* rises: points where eps rose by more than largest_rise, or left [0, 1] */
};

struct search_options {
    uint64_t points, seed, stride, times; /* stride, times: 0 if the program has no such option */
    int threads;
    const char *only; /* part of the names of the selected functions; NULL: all */

    /* From the program. exact: the exact value; for an inverse, the exact value of the eps or the loss that it
     * inverts */
    long double (*exact)(const struct search_function *f, enum search_shape shape, long double x);
    double (*random_argument)(struct random_state *r, const struct search_function *f);
    void (*boundaries)(struct worst *worst, const struct search_function *f, const struct search_options *o);
    bool judges_specials;          /* tests values at 0, 1 and infinity, next to them, and outside the domain */
    uint64_t largest_rise, radius; /* allowed rise of eps, in ulp; number of neighbours of the worst point to test */
};

static inline bool search_is_inverse(const struct search_function *f)
{
    return f->shape >= INVERSE;
}

/* Returns the error in ulp; infinity or NaN if the value is wrong. */
double search_error(const struct search_function *f, const struct search_options *o, double computed, double x);

void worst_take(struct worst *worst, double error, double at);

/* Checks error, order and range at every double from `radius` before |x| to `radius` after it, with the sign of x. */
void worst_walk(struct worst *worst, const struct search_function *f, const struct search_options *o, double x,
                uint64_t radius);

/* Prints the heading for the lines of worst_report. */
void worst_heading(uint64_t seed);

/* Prints one line. True if the worst error is within the bound and `rises` is 0. */
bool worst_report(const char *name, const struct worst *worst, double bound);

/* Searches at random points, at boundaries and uphill, and prints a line. Returns the worst error, infinity if the
 * bound or the order is violated, and 0 for a function that is not selected. */
double search_worst(const struct search_function *f, const struct search_options *o);

enum { SEARCH_MAX_THREADS = 64 };

/* Reads --points, --threads, --seed, --only, --stride and --times. Returns 0 or the exit status: 2 for wrong options,
 * after the help; 77 if long double is too short for a reference. */
int search_options_read(struct search_options *o, int argc, char **argv, const char *help);

bool search_wants(const struct search_options *o, const char *name);

/* Two parts of test_accuracy, which print their results: the reference against balls, and the arrays of floats. */
bool reference_is_good(const struct search_options *o);
bool floats_are_good(const struct search_options *o);

/* Calls part(job) for each of the jobs, which have `size` bytes, on one thread each. */
void search_on_threads(void *(*part)(void *), void *jobs, size_t size, int threads);

#endif
