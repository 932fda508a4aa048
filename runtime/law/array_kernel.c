/* SPDX-License-Identifier: MIT */
/* Array functions for the list COR_LAW_LOOPS, for one instruction set (sets.h): the loops of runtime/table/row_loops.h,
 * without rows, and after them kernels that a compiler vectorises. No set may fuse a multiplication with an addition,
 * so all sets and the scalar functions give the same bits. */
#include "cor/law.h"
#include "runtime/law/array.h"
#include "runtime/table/row_loops.h"

/* The least multiple of COR_LANES from n on, up to which the numbers of a block are filled. A compiler that sees it,
 * and that it is not 0, leaves out the loop over what is no whole vector. */
#define WHOLE(n) (((n) + COR_LANES - 1) / COR_LANES * COR_LANES)

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
    struct cor_row_table interval;
    double (*one)(double x);
    void (*values)(double *restrict y, const double *restrict inside, size_t n);
};
#define LOOP_(name, public, from, largest, value)                                                                      \
    {{.kind = COR_ROW_NONE, .least = from, .end = largest, .also = largest}, cor_##public, values_##name},
static const struct loop loops[] = {COR_LAW_LOOPS(LOOP_)};

static void complete(void *context, const struct cor_row_block *block, double *value)
{
    const struct loop *const loop = context;
    loop->values(value, block->taken, block->m);
    for (size_t j = 0; block->outside && j < block->m; j++)
        if (!is_same(block->x[j], block->taken[j]))
            value[j] = loop->one(block->x[j]);
}

static void run(enum cor_law_loop number, const double *in, double *out, size_t n)
{
    struct loop loop = loops[number];
    const struct cor_row_call call = {&loop.interval, NULL, &loop, NULL, complete, 1};
    if (n >= 3) {
        COR_OF_SET(cor_row_loops).doubles(&call, in, out, n);
        return;
    }
    for (size_t i = 0; i < n; i++) /* the scalar function is faster */
        out[i] = loop.one(in[i]);
}

static void run_floats(enum cor_law_loop number, const float *in, float *out, size_t n)
{
    double wide[COR_ROW_BLOCK];
    for (size_t i = 0; i < n; i += COR_ROW_BLOCK) {
        const size_t m = n - i < COR_ROW_BLOCK ? n - i : COR_ROW_BLOCK;
        for (size_t j = 0; j < m; j++)
            wide[j] = (double)in[i + j];
        run(number, wide, wide, m);
        for (size_t j = 0; j < m; j++)
            out[i + j] = (float)wide[j];
    }
}

const struct cor_law_loops COR_OF_SET(cor_law_loops) = {run, run_floats};
