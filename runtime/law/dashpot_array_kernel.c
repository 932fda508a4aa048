/* SPDX-License-Identifier: MIT */
/* Array functions of Hertz's contact with a constant dashpot by the loops of runtime/table/row_lanes.h. The first loop
 * finds the row of each number among those near 0, by octaves of beta and by octaves of beta_c - beta; numbers beyond
 * these rows, and near 0 those whose variable is a cube root, are computed one by one. */
#include "cor/hertz_dashpot.h"
#include "generated/hertz_dashpot_tables.h" /* the geometry alone: no table is used here */
#include "runtime/law/dashpot_array.h"
#include "runtime/table/row_lanes.h"

/* The tables of a quantity, and the least beta > 0 that the loops take */
struct dashpot {
    struct cor_inline_law_quantity q;
    struct form form;
    double least;
};

KERNEL mask dashpot_is_near(const struct dashpot *d, double beta)
{
    return d->q.near.root == 1 ? holds(beta, d->least, d->q.near.end) | is_same(beta, 0) : 0;
}

KERNEL mask dashpot_is_below(const struct dashpot *d, double beta)
{
    return d->q.below.kind ? holds(beta, d->q.middle.end, d->q.threshold.hi) : 0;
}

KERNEL mask dashpot_has(const struct dashpot *d, double beta)
{
    return dashpot_is_near(d, beta) | holds(beta, d->q.near.end, d->q.middle.end) | dashpot_is_below(d, beta);
}

/* Sets the row, t and, for the rows of (1 - eps)/beta, m = beta. *near is set if some number has such a row. Returns
 * whether a number lies outside the rows; such a number gets the first row of the middle. */
KERNEL mask dashpot_reduce(struct reduced *r, const struct dashpot *d, const struct cor_dashpot_rows *rows,
                           const double *in, int count, mask *near)
{
    const struct cor_inline_law_quantity *const q = &d->q;
    mask outside = 0, some_near = 0;
    for (int j = 0; j < count; j++) {
        const mask is_near = dashpot_is_near(d, in[j]), is_below = dashpot_is_below(d, in[j]);
        const mask is_middle = holds(in[j], q->near.end, q->middle.end);
        const double beta = choose(is_middle, in[j], q->near.end);
        uint64_t row = address_of(rows->middle, cor_inline_octaves_row(q->middle.octaves, beta));
        double t = cor_inline_octaves_t(q->middle.octaves, beta);
        if (q->near.root == 1) {
            const double y = choose(is_near, in[j], 0);
            const int i = cor_inline_grid_row(q->near.grid, y);
            row = choose_bits(is_near, address_of(rows->near, (uint64_t)i), row);
            t = choose(is_near, cor_inline_grid_t(q->near.grid, y, i), t);
            r->m[j] = choose(is_near, y, 1);
        } else {
            r->m[j] = 1;
        }
        if (q->below.kind) { /* beta_c - beta exactly, as cor_inline_law_octave_row takes it */
            const double x = choose(is_below, in[j], q->middle.end);
            const struct cor_inline_pair rest = cor_pair_two_sum(q->threshold.hi - x, q->threshold.lo);
            const uint64_t sign_less = UINT64_C(0x7ff0000000000000), twice_bias = UINT64_C(0x7fe0000000000000);
            const double unit = cor_inline_from_bits(twice_bias - (cor_inline_bits(rest.hi) & sign_less));
            row =
                choose_bits(is_below, address_of(rows->below, cor_inline_octaves_row(q->below.octaves, rest.hi)), row);
            t = choose(is_below, cor_inline_octaves_t(q->below.octaves, rest.hi) + rest.lo * unit, t);
        }
        outside |= ~(is_near | is_middle | is_below);
        some_near |= is_near;
        r->row[j] = row;
        r->t[j] = t;
    }
    *near = some_near;
    return outside;
}

KERNEL void dashpot_from_beta(const struct dashpot *d, const struct cor_dashpot_rows *rows, const double *in,
                              double *out, size_t n, scalar *one)
{
    for (size_t i = 0; LANES == 1 && i < n; i++) /* without vectors the scalar function is faster */
        out[i] = one(in[i]);
    for (size_t i = 0, m; LANES > 1 && i < n; i += m) {
        double from[BLOCK], value[BLOCK];
        struct reduced r;
        mask near;
        m = n - i < BLOCK ? n - i : BLOCK;
        const int count = block_read(from, in + i, m);
        const mask outside = dashpot_reduce(&r, d, rows, from, count, &near);
        evaluate(value, &r, near || d->form.loss == EPS_TO_LOSS ? d->form : form_plain, count);
        memcpy(out + i, value, m * sizeof *out);
        for (size_t j = 0; outside && j < m; j++)
            if (!dashpot_has(d, from[j]))
                out[i + j] = one(from[j]);
    }
}

KERNEL void dashpot_from_eps(struct cor_inline_law_inverse inverse, const struct cor_dashpot_rows *rows,
                             const double *in, double *out, size_t n, scalar *one)
{
    const struct inverse_table table = {rows->near, rows->middle, inverse.near.grid, inverse.rows.octaves,
                                        inverse.near.root == 1 ? 0 : 2};
    for (size_t i = 0; LANES == 1 && i < n; i++)
        out[i] = one(in[i]);
    if (LANES > 1)
        from_eps(in, out, n, &table, one);
}

#define DASHPOT_FROM_BETA(function, tables, has_m, loss, least)                                                        \
    static void loop_##function(const struct cor_dashpot_rows *rows, const double *in, double *out, size_t n)          \
    {                                                                                                                  \
        const struct dashpot d = {cor_law_hertz_dashpot_##tables(), {0, has_m, loss}, least};                          \
        dashpot_from_beta(&d, rows, in, out, n, cor_hertz_dashpot_##function);                                         \
    }
#define DASHPOT_LOOP_EPS(function, tables) DASHPOT_FROM_BETA(function, tables, 1, LOSS_TO_EPS, COR_INLINE_2_M900)
#define DASHPOT_LOOP_LOSS(function, tables) DASHPOT_FROM_BETA(function, tables, 1, EPS_TO_LOSS, COR_INLINE_2_M900)
#define DASHPOT_LOOP_VALUE(function, tables) DASHPOT_FROM_BETA(function, tables, 0, AS_IT_IS, 0)
#define DASHPOT_LOOP_BETA(function, tables)                                                                            \
    static void loop_##function(const struct cor_dashpot_rows *rows, const double *in, double *out, size_t n)          \
    {                                                                                                                  \
        dashpot_from_eps(cor_law_hertz_dashpot_##tables(), rows, in, out, n, cor_hertz_dashpot_##function);            \
    }

COR_DASHPOT_LOOPS(DASHPOT_LOOP_EPS, DASHPOT_LOOP_LOSS, DASHPOT_LOOP_VALUE, DASHPOT_LOOP_BETA)

#define DASHPOT_ROW(function, tables) loop_##function,
const struct cor_dashpot_loops COR_OF_SET(cor_dashpot_loops) = {
    {COR_DASHPOT_LOOPS(DASHPOT_ROW, DASHPOT_ROW, DASHPOT_ROW, DASHPOT_ROW)}};
