/* SPDX-License-Identifier: MIT */
/* Array functions for the list COR_LAW_LOOPS, for one instruction set (sets.h). No set may fuse a multiplication with
 * an addition, so all sets and the scalar functions give the same bits. A compiler vectorises the loops over blocks of
 * numbers. Numbers outside the interval are then computed one by one. */
#include "cor/law.h"
#include "runtime/law/array.h"
#include "runtime/number/kernel.h"

/* LANES: a multiple of the vector length of every set */
enum { BLOCK = 128, LANES = 8 };

/* The least multiple of LANES from n on. A compiler that sees it, and that it is not 0, leaves out the loop over what
 * is no whole vector. */
#define WHOLE(n) (((n) + LANES - 1) / LANES * LANES)

typedef double law_function(double x);

/* Copies the next m numbers of `in`, which may be the array of results, to `from` and to `inside`, where an end of the
 * interval replaces numbers outside it and fills the block up to whole vectors. Returns whether there were such
 * numbers. */
SHARED int next_block(double *restrict from, double *restrict inside, const double *restrict in, size_t m, double least,
                      double largest)
{
    int outside = 0;
    for (size_t j = 0; j < m; j++) {
        const double x = in[j];
        const int is_inside = (x >= least) & (x <= largest);
        outside |= !is_inside;
        from[j] = x;
        inside[j] = is_inside ? x : largest;
    }
    for (size_t j = m; j < WHOLE(m); j++)
        inside[j] = largest;
    return outside;
}

SHARED void put_block(double *restrict out, const double *restrict to, const double *restrict from, size_t m,
                      int outside, double least, double largest, law_function *function)
{
    /* cppcheck-suppress uninitvar ; the loop before has filled `to` */
    for (size_t j = 0; j < m; j++)
        out[j] = to[j];
    for (size_t j = 0; outside && j < m; j++)
        if (!(from[j] >= least && from[j] <= largest))
            out[j] = function(from[j]);
}

/* ---- loops ---- */

#define VALUES_(name, public, least, largest, value)                                                                   \
    static void values_##name(double *restrict y, const double *restrict inside, size_t n)                             \
    {                                                                                                                  \
        const size_t end = WHOLE(n);                                                                                   \
        for (size_t j = 0; end > 0 && j < end; j++) {                                                                  \
            const double x = inside[j];                                                                                \
            y[j] = value;                                                                                              \
        }                                                                                                              \
    }
COR_LAW_LOOPS(VALUES_)

struct loop {
    double least, largest;
    law_function *one;
    void (*values)(double *restrict y, const double *restrict inside, size_t n);
};
#define LOOP_(name, public, least, largest, value) {least, largest, cor_##public, values_##name},
static const struct loop loops[] = {COR_LAW_LOOPS(LOOP_)};

static void run(enum cor_law_loop number, const double *in, double *out, size_t n)
{
    const struct loop *const loop = &loops[number];
    if (n < 3) { /* the scalar function is faster */
        for (size_t i = 0; i < n; i++)
            out[i] = loop->one(in[i]);
        return;
    }
    for (size_t i = 0; i < n; i += BLOCK) {
        double from[BLOCK], inside[BLOCK], to[BLOCK];
        const size_t m = n - i < BLOCK ? n - i : BLOCK;
        const int outside = next_block(from, inside, in + i, m, loop->least, loop->largest);
        loop->values(to, inside, m);
        put_block(out + i, to, from, m, outside, loop->least, loop->largest, loop->one);
    }
}

static void run_floats(enum cor_law_loop number, const float *in, float *out, size_t n)
{
    double wide[BLOCK];
    for (size_t i = 0; i < n; i += BLOCK) {
        const size_t m = n - i < BLOCK ? n - i : BLOCK;
        for (size_t j = 0; j < m; j++)
            wide[j] = (double)in[i + j];
        run(number, wide, wide, m);
        for (size_t j = 0; j < m; j++)
            out[i + j] = (float)wide[j];
    }
}

const struct cor_law_loops COR_OF_SET(cor_law_loops) = {run, run_floats};
