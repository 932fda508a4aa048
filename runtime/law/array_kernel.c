/* SPDX-License-Identifier: MIT */
/* Array functions of the linear dashpot's times, for one instruction set (sets.h). The loops of
 * runtime/table/row_loops.h select the numbers in the domain of a kernel; the compiler vectorises the kernel. No set
 * may fuse a multiplication with an addition, so all sets and the scalar functions give the same bits. */
#include "runtime/law/functions.h"
#include "runtime/law/linear.h"
#include "runtime/table/row_loops.h"

/* The smallest multiple of COR_LANES that is at least n. A block is padded to this length. If a compiler
 * sees that the length is such a multiple and not 0, it omits the loop over the rest of a vector. */
#define WHOLE(n) (((n) + COR_LANES - 1) / COR_LANES * COR_LANES)

static void duration_zero_overlap(double *restrict y, const double *restrict x, size_t n)
{
    const size_t end = WHOLE(n);
    for (size_t j = 0; end > 0 && j < end; j++)
        y[j] = cor_linear_inline_duration_zero_overlap_near(x[j]);
}

static void duration_zero_force(double *restrict y, const double *restrict x, size_t n)
{
    const size_t end = WHOLE(n);
    for (size_t j = 0; end > 0 && j < end; j++)
        y[j] = cor_linear_inline_duration_zero_force_near(x[j]);
}

static void time_of_max_overlap(double *restrict y, const double *restrict x, size_t n)
{
    const size_t end = WHOLE(n);
    for (size_t j = 0; end > 0 && j < end; j++)
        y[j] = cor_linear_inline_time_of_max_overlap_near(x[j]);
}

/* `values` and `one` give the same bits for 0 <= x <= largest. */
struct loop {
    void (*values)(double *restrict y, const double *restrict x, size_t n);
    double largest;
    double (*one)(double x);
};
static const struct loop loops[] = {
    [COR_LINEAR_DURATION_ZERO_OVERLAP] = {duration_zero_overlap, COR_RATIO_BELOW_ONE, NULL},
    [COR_LINEAR_DURATION_ZERO_FORCE] = {duration_zero_force, COR_RATIO_FORCE_NEAR, NULL},
    [COR_LINEAR_TIME_OF_MAX_OVERLAP] = {time_of_max_overlap, COR_RATIO_FORCE_NEAR, NULL},
};

static void complete_block(void *context, const struct cor_row_block *block, double *value)
{
    const struct loop *const loop = context;
    loop->values(value, block->taken, block->m);
    for (size_t j = 0; block->outside && j < block->m; j++)
        if (!is_same(block->x[j], block->taken[j]))
            value[j] = loop->one(block->x[j]);
}

static void run_loop(enum cor_law_loop number, double (*one)(double), const double *x, double *y, size_t n)
{
    struct loop loop = {loops[number].values, loops[number].largest, one};
    const struct cor_row_table interval = {.kind = COR_ROW_NONE, .end = loop.largest, .also = loop.largest};
    const struct cor_row_call call = {&interval, NULL, &loop, NULL, complete_block, 1};
    if (n >= 3) {
        COR_OF_SET(cor_row_loops).doubles(&call, x, y, n);
        return;
    }
    for (size_t i = 0; i < n; i++) /* the scalar function is faster */
        y[i] = one(x[i]);
}

const struct cor_law_loops COR_OF_SET(cor_law_loops) = {run_loop};
