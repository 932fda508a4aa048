/* SPDX-License-Identifier: MIT */
/* The random numbers of all tests: xorshift64* (Vigna, ACM Trans. Math. Softw. 42, 30, 2016). It scatters points well
 * enough and is the same on every machine. */
#ifndef COR_TESTS_RANDOM_H
#define COR_TESTS_RANDOM_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* A list of doubles, and the number of elements of an array */
#define NUMBERS(name, ...) const double name[] = {__VA_ARGS__}
#define COUNT_OF(array) (sizeof(array) / sizeof *(array))
/* EACH(x, 1, 2) { ... } runs with x as a pointer to each of the doubles. */
#define EACH(x, ...)                                                                                                   \
    for (const double *x = (const double[]){__VA_ARGS__}, *const x##_end =                                             \
                                                              x + COUNT_OF(((const double[]){__VA_ARGS__}));           \
         x < x##_end; x++)

struct random_state {
    uint64_t state; /* not 0 */
};

static inline struct random_state random_seeded(uint64_t seed)
{
    return (struct random_state){seed * 2 + 1};
}

static inline uint64_t random_bits(struct random_state *r)
{
    r->state ^= r->state >> 12;
    r->state ^= r->state << 25;
    r->state ^= r->state >> 27;
    return r->state * UINT64_C(2685821657736338717);
}

/* Returns 0, 1, ... or n - 1. */
static inline size_t random_below(struct random_state *r, size_t n)
{
    return (size_t)(random_bits(r) % n);
}

static inline double random_uniform(struct random_state *r, double low, double high)
{
    return low + (high - low) * ((double)(random_bits(r) >> 11) * 0x1p-53);
}

/* Returns a log-uniform number, so all magnitudes are equally likely. */
static inline double random_log(struct random_state *r, double low, double high)
{
    return exp(random_uniform(r, log(low), log(high)));
}

/* Returns a nonnegative double below limit; every bit pattern is equally likely. */
static inline double random_pattern(struct random_state *r, double limit)
{
    uint64_t bits;
    double x;
    memcpy(&bits, &limit, sizeof bits);
    bits = random_bits(r) % bits;
    memcpy(&x, &bits, sizeof x);
    return x;
}

#endif
