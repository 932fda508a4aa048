/* SPDX-License-Identifier: MIT */
/* Whole arrays of the functions that COR_LAW_LOOPS lists: compiled once for every instruction set, in array_<set>.c, and chosen
 * in array.c. No set may fuse a multiplication with an addition, so all of them and the scalar functions give the same
 * bits. Blocks of numbers go through a loop that a compiler vectorises; numbers outside the kernel's interval are put right
 * one by one. */
#ifndef COR_RUNTIME_LAW_ARRAY_KERNEL_H
#define COR_RUNTIME_LAW_ARRAY_KERNEL_H

#include "runtime/law/array.h"

/* LANES: whole vectors of every set */
enum { BLOCK = 128, LANES = 8 };

typedef double law_function(double x);

/* The next m numbers of `in`, which may be `out` too, filled up to whole vectors, with numbers outside the interval replaced
 * by its end; whether there were such numbers. */
static inline int next_block(double *from, double *inside, const double *in, size_t m, size_t count, double least,
                             double largest)
{
    int outside = 0;
    memcpy(from, in, m * sizeof *from);
    for (size_t j = m; j < count; j++)
        from[j] = largest;
    for (size_t j = 0; j < count; j++) {
        const int is_inside = (from[j] >= least) & (from[j] <= largest);
        outside |= !is_inside;
        inside[j] = is_inside ? from[j] : largest;
    }
    return outside;
}

static inline void put_block(double *out, const double *to, const double *from, size_t m, int outside, double least,
                             double largest, law_function *function)
{
    memcpy(out, to, m * sizeof *out);
    for (size_t j = 0; outside && j < m; j++)
        if (!(from[j] >= least && from[j] <= largest))
            out[j] = function(from[j]);
}

#define LAW_LOOP(name, least, largest)                                                                                 \
    static void loop_##name(const double *in, double *out, size_t n)                                                   \
    {                                                                                                                  \
        for (size_t i = 0; i < n; i += BLOCK) {                                                                        \
            double from[BLOCK], inside[BLOCK], to[BLOCK];                                                              \
            const size_t m = n - i < BLOCK ? n - i : BLOCK, count = (m + LANES - 1) / LANES * LANES;                   \
            const int outside = next_block(from, inside, in + i, m, count, least, largest);                            \
            for (size_t j = 0; j < count; j++)                                                                         \
                to[j] = cor_##name##_near(inside[j]);                                                                  \
            put_block(out + i, to, from, m, outside, least, largest, cor_##name);                                      \
        }                                                                                                              \
    }

COR_LAW_LOOPS(LAW_LOOP)

#define LAW_LOOP_ROW(name, least, largest) loop_##name,
#define LAW_LOOPS_OF(set)                                                                                              \
    cor_law_array_function *const cor_law_loops_##set[COR_LAW_LOOP_COUNT] = {COR_LAW_LOOPS(LAW_LOOP_ROW)};

#endif
