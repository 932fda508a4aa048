/* SPDX-License-Identifier: MIT */
/* Array functions for the list COR_LAW_LOOPS, for one instruction set (sets.h). No set may fuse a
 * multiplication with an addition, so all sets and the scalar functions give the same bits. A loop that a compiler
 * vectorises processes blocks of numbers. Numbers outside the kernel's interval are then computed one by one. */
#include "cor/law.h"
#include "runtime/law/array.h"
#include "runtime/number/kernel.h"

/* LANES: a multiple of the vector length of every set */
enum { BLOCK = 128, LANES = 8 };

/* The least multiple of LANES from n on. A compiler that sees it leaves out the loop over what is no whole vector. */
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

#define LAW_LOOP(name, public, least, largest)                                                                         \
    static void loop_##name(const double *in, double *out, size_t n)                                                   \
    {                                                                                                                  \
        for (size_t i = 0; i < n; i += BLOCK) {                                                                        \
            double from[BLOCK], inside[BLOCK], to[BLOCK];                                                              \
            const size_t m = n - i < BLOCK ? n - i : BLOCK, count = WHOLE(m);                                          \
            const int outside = next_block(from, inside, in + i, m, least, largest);                                   \
            for (size_t j = 0; j < count; j++)                                                                         \
                to[j] = cor_##name##_near(inside[j]);                                                                  \
            put_block(out + i, to, from, m, outside, least, largest, cor_##public);                                    \
        }                                                                                                              \
    }

/* The places of a block's numbers: first those of the first kernel, then those of the second. Both parts are filled up
 * to whole vectors with their last number. */
struct parted {
    double x[BLOCK + 2 * LANES], y[BLOCK + 2 * LANES];
    size_t place[BLOCK + 2 * LANES], first, second; /* whole vectors */
};

static inline size_t fill_up(struct parted *p, size_t from, size_t n)
{
    const size_t whole = WHOLE(n);
    for (size_t j = n; j < whole; j++) {
        p->x[from + j] = p->x[from + n - 1];
        p->place[from + j] = p->place[from + n - 1];
    }
    return whole;
}

SHARED void part(struct parted *p, const double *inside, const unsigned char *is_first, size_t count)
{
    size_t n = 0, rest = 0;
    for (size_t j = 0; j < count; j++) {
        p->x[n] = inside[j];
        p->place[n] = j;
        n += is_first[j];
    }
    p->first = n > 0 ? fill_up(p, 0, n) : 0;
    for (size_t j = 0; j < count; j++) {
        p->x[p->first + rest] = inside[j];
        p->place[p->first + rest] = j;
        rest += !is_first[j];
    }
    p->second = rest > 0 ? fill_up(p, p->first, rest) : 0;
}

#define PARTED_LOOP(name, public, least, largest)                                                                      \
    static void loop_##name(const double *in, double *out, size_t n)                                                   \
    {                                                                                                                  \
        for (size_t i = 0; i < n; i += BLOCK) {                                                                        \
            double from[BLOCK], inside[BLOCK], to[BLOCK];                                                              \
            unsigned char is_first[BLOCK];                                                                             \
            struct parted p;                                                                                           \
            const size_t m = n - i < BLOCK ? n - i : BLOCK, count = WHOLE(m);                                          \
            const int outside = next_block(from, inside, in + i, m, least, largest);                                   \
            for (size_t j = 0; j < count; j++)                                                                         \
                is_first[j] = (unsigned char)cor_##name##_is_first(inside[j]);                                         \
            part(&p, inside, is_first, count);                                                                         \
            const size_t first = WHOLE(p.first), second = WHOLE(p.second);                                             \
            for (size_t j = 0; j < first; j++)                                                                         \
                p.y[j] = cor_##name##_first(p.x[j]);                                                                   \
            for (size_t j = 0; j < second; j++)                                                                        \
                p.y[first + j] = cor_##name##_second(p.x[first + j]);                                                  \
            for (size_t j = 0; j < first + second; j++)                                                                \
                to[p.place[j]] = p.y[j];                                                                               \
            put_block(out + i, to, from, m, outside, least, largest, cor_##public);                                    \
        }                                                                                                              \
    }

COR_LAW_LOOPS(LAW_LOOP, PARTED_LOOP)

#define LAW_LOOP_ROW(name, public, least, largest) loop_##name,
const struct cor_law_loops COR_OF_SET(cor_law_loops) = {{COR_LAW_LOOPS(LAW_LOOP_ROW, LAW_LOOP_ROW)}};
