/* SPDX-License-Identifier: MIT */
/* Array functions that evaluate a row of a table for each number (row_loops.h), for one instruction set (sets.h). No
 * set may fuse a multiplication with an addition, so all sets and the scalar functions give the same bits.
 *
 * Three loops process each block of numbers. The first replaces the numbers that are not in the table. The second finds
 * the row and the variables of every number. The third loads the columns of several rows into vectors and evaluates
 * them. A compiler vectorises the first two. Finally, the numbers that were replaced are computed one by one. */
#include "runtime/table/row_loops.h"

/* Vectors have four elements even where AVX-512 offers eight. On a Zen 4, which computes 512 bits in two halves, an eps
 * takes 1.64 ns with four elements. With eight elements it takes 1.71 ns if rows are inserted, 2.09 ns if rows are
 * loaded by masks, and 6.4 ns with gathers (measured). */
#if defined(__AVX2__)
enum { LANES = 4 };
typedef __m256d lanes;
#define LANES_LOAD(p) _mm256_loadu_pd(p)
#define LANES_STORE(p, v) _mm256_storeu_pd(p, v)
#define LANES_ALL(x) _mm256_set1_pd(x)
/* x < y ? if_true : if_false */
#define LANES_CHOOSE_LESS(x, y, if_true, if_false) _mm256_blendv_pd(if_false, if_true, _mm256_cmp_pd(x, y, _CMP_LT_OQ))

/* Loads columns k to k + 3 of four rows, transposed. */
COR_KERNEL void lanes_columns(lanes c[4], const double *const row[], int k)
{
#define TWO(i, j, k)                                                                                                   \
    _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(row[i] + (k))), _mm_loadu_pd(row[j] + (k)), 1)
    const lanes p = TWO(0, 2, k), q = TWO(1, 3, k), r = TWO(0, 2, k + 2), s = TWO(1, 3, k + 2);
    c[0] = _mm256_unpacklo_pd(p, q);
    c[1] = _mm256_unpackhi_pd(p, q);
    c[2] = _mm256_unpacklo_pd(r, s);
    c[3] = _mm256_unpackhi_pd(r, s);
#undef TWO
}

COR_KERNEL lanes lanes_head(lanes x)
{
    return _mm256_and_pd(x, _mm256_castsi256_pd(_mm256_set1_epi64x((long long)UINT64_C(0xfffffffff8000000))));
}
#else
enum { LANES = 1 };
typedef double lanes;
#define LANES_LOAD(p) (*(p))
#define LANES_STORE(p, v) (*(p) = (v))
#define LANES_ALL(x) (x)
#define LANES_CHOOSE_LESS(x, y, if_true, if_false) ((x) < (y) ? (if_true) : (if_false))

COR_KERNEL void lanes_columns(lanes c[4], const double *const row[], int k)
{
    for (int l = 0; l < 4; l++)
        c[l] = row[0][k + l];
}

COR_KERNEL lanes lanes_head(lanes x)
{
    return cor_inline_head(x);
}
#endif

/* The loops process this many numbers together. The last block of an array is padded to whole vectors. */
enum { BLOCK = COR_ROW_BLOCK };

COR_KERNEL size_t whole_blocks(size_t m)
{
    return (m + LANES - 1) / LANES * LANES;
}

/* ---- first loop: numbers in the table ---- */

/* True if the table contains x, or if x is `also`. */
COR_KERNEL mask table_has(const struct cor_row_table *table, double x)
{
    return is_between(x, table->least, table->end) | is_same(x, table->also);
}

/* Copies m numbers to x. `also` replaces numbers that are not in the table, and pads x to whole vectors of every set.
 * Returns the number of replaced numbers. */
SHARED size_t take(double *restrict x, const struct cor_row_table *table, const double *restrict in, size_t m)
{
    const struct cor_row_table t = *table;
    mask inside = 0;
    for (size_t j = 0; j < m; j++) {
        const mask is_inside = table_has(&t, in[j]);
        x[j] = choose_double(is_inside, in[j], t.also);
        inside -= is_inside;
    }
    for (size_t j = m; j % COR_LANES; j++)
        x[j] = t.also;
    return m - (size_t)inside;
}

/* ---- second loop: rows and variables ---- */

/* Input of the third loop, which computes m (c_0 + row(s, t)) */
struct reduced {
    const double *m; /* x, or `factor` */
    double s[BLOCK], t[BLOCK], factor[BLOCK];
    uint64_t row[BLOCK]; /* address of the row */
};

COR_KERNEL uint64_t address_of(const double *rows, uint64_t i)
{
    return (uint64_t)(uintptr_t)rows + i * (COR_INLINE_COLUMNS * sizeof *rows);
}

COR_KERNEL void reduce_grid(struct reduced *r, const struct cor_row_table *table, const double *x, size_t count,
                            int root, int has_s)
{
    const struct cor_inline_grid grid = {0, table->step, table->per_unit};
    const double *const rows = table->near;
    const double plain_end = table->near_end;
    r->m = x;
    for (size_t j = 0; j < count; j++) {
        const double y = root ? sqrt(x[j]) : x[j];
        const int i = cor_inline_grid_row(grid, y);
        const double node = i * grid.step, t = y - node;
        r->row[j] = address_of(rows, (uint64_t)i);
        r->t[j] = t;
        if (has_s)
            r->s[j] = choose_double(mask_of(node < plain_end), t, x[j] - node * node);
    }
}

COR_KERNEL void reduce_octaves(struct reduced *r, const struct cor_row_table *table, const double *x, size_t count)
{
    const struct cor_inline_octaves octaves = table->octaves;
    const double *const rows = table->middle;
    r->m = r->factor;
    for (size_t j = 0; j < count; j++) {
        r->row[j] = address_of(rows, cor_inline_octaves_row(octaves, x[j]));
        r->t[j] = cor_inline_octaves_t(octaves, x[j]);
    }
}

COR_KERNEL void reduce_inverse(struct reduced *r, const struct cor_row_table *table, const double *x, size_t count,
                               int root)
{
    const struct cor_inline_grid grid = {0, table->step, table->per_unit};
    const struct cor_inline_octaves octaves = table->octaves;
    const double *const near_rows = table->near, *const rows = table->middle;
    for (size_t j = 0; j < count; j++) {
        const mask near = is_between(x[j], 0.5, 2);
        const double loss = choose_double(near, 1 - x[j], 0), y = root ? sqrt(loss) : loss;
        const int i = cor_inline_grid_row(grid, y);
        r->row[j] = choose_bits(near, address_of(near_rows, (uint64_t)i),
                                address_of(rows, cor_inline_octaves_row(octaves, x[j])));
        r->t[j] = choose_double(near, y - i * grid.step, cor_inline_octaves_t(octaves, x[j]));
        r->factor[j] = choose_double(near, loss, 1);
    }
    r->m = r->factor;
}

/* Returns true if any number has a near row. */
COR_KERNEL int reduce_parts(struct reduced *r, const struct cor_row_table *table, const double *x, size_t count,
                            int has_below)
{
    const struct cor_inline_grid grid = {0, table->step, table->per_unit};
    const struct cor_inline_octaves octaves = table->octaves, below_octaves = table->below_octaves;
    const double *const near_rows = table->near, *const rows = table->middle, *const below_rows = table->below;
    const double near_end = table->near_end, middle_end = table->middle_end;
    const struct cor_inline_pair threshold = table->threshold;
    mask some_near = 0;
    for (size_t j = 0; j < count; j++) {
        const mask is_middle = is_between(x[j], near_end, middle_end);
        const double of_middle = choose_double(is_middle, x[j], near_end);
        uint64_t row = address_of(rows, cor_inline_octaves_row(octaves, of_middle));
        double t = cor_inline_octaves_t(octaves, of_middle);
        const mask is_near = is_between(x[j], 0, near_end);
        const double near_x = choose_double(is_near, x[j], 0);
        const int i = cor_inline_grid_row(grid, near_x);
        row = choose_bits(is_near, address_of(near_rows, (uint64_t)i), row);
        t = choose_double(is_near, near_x - i * grid.step, t);
        some_near |= is_near;
        if (has_below) { /* threshold - x exactly, as cor_inline_law_octave_row uses it */
            const mask is_below = is_between(x[j], middle_end, threshold.hi);
            const double y = choose_double(is_below, x[j], middle_end);
            const struct cor_inline_pair rest = cor_pair_two_sum(threshold.hi - y, threshold.lo);
            const uint64_t sign_less = UINT64_C(0x7ff0000000000000), twice_bias = UINT64_C(0x7fe0000000000000);
            const double unit = cor_inline_from_bits(twice_bias - (cor_inline_bits(rest.hi) & sign_less));
            row = choose_bits(is_below, address_of(below_rows, cor_inline_octaves_row(below_octaves, rest.hi)), row);
            t = choose_double(is_below, cor_inline_octaves_t(below_octaves, rest.hi) + rest.lo * unit, t);
        }
        r->row[j] = row;
        r->t[j] = t;
        r->factor[j] = choose_double(is_near, near_x, 1);
    }
    r->m = r->factor;
    return some_near != 0;
}

/* ---- third loop ---- */

/* Performs the operations of COR_INLINE_ROW and COR_INLINE_ROW_TIMES_S, beginning with the last columns of a row. Fewer
 * vectors are then live at a time, and the processor computes with the last columns while it loads the first ones. */
COR_KERNEL lanes evaluate_lanes(const struct reduced *r, size_t j, int has_s, enum cor_row_value kind)
{
    const double *row[LANES];
    lanes c[4], rest;
    for (size_t l = 0; l < LANES; l++)
        row[l] = (const double *)(uintptr_t)r->row[j + l];
    const lanes t = LANES_LOAD(r->t + j), p2 = t * t, p4 = p2 * p2, p6 = p4 * p2, p8 = p4 * p4;
    lanes_columns(c, row, 8);
    if (has_s) {
        const lanes last = p8 * (c[2] + c[3] * t), upper = p6 * (c[0] + c[1] * t);
        lanes_columns(c, row, 4);
        const lanes lower = p2 * (c[0] + c[1] * t) + (p4 * (c[2] + c[3] * t) + upper);
        lanes_columns(c, row, 0);
        rest = c[1] + LANES_LOAD(r->s + j) * (((c[2] + c[3] * t) + last) + lower);
    } else {
        const lanes last = (p6 * p4) * c[3], upper = p8 * (c[1] + c[2] * t), c8 = c[0];
        lanes_columns(c, row, 4);
        const lanes middle = p6 * (c[3] + c8 * t) + upper, lower = p4 * (c[1] + c[2] * t), c4 = c[0];
        lanes_columns(c, row, 0);
        rest = ((c[1] + t * c[2]) + last) + ((p2 * (c[3] + c4 * t) + lower) + middle);
    }
    if (kind == COR_ROW_SUM)
        return c[0] + rest;
    const lanes m = LANES_LOAD(r->m + j), head = lanes_head(m), one = LANES_ALL(1.0);
    const lanes product = head * c[0] + ((m - head) * c[0] + m * rest);
    if (kind == COR_ROW_EPS) /* if m = 1, the product is c_0 + row to the last bit */
        return LANES_CHOOSE_LESS(m, one, one - product, product);
    if (kind == COR_ROW_LOSS) { /* 1 - c_0 exactly, in two parts */
        const lanes hi = one - c[0], part = hi - one;
        return LANES_CHOOSE_LESS(m, one, product, hi + (((one - (hi - part)) + (-c[0] - part)) - rest));
    }
    return product;
}

COR_KERNEL void evaluate_rows(double *out, const struct reduced *r, size_t count, int has_s, enum cor_row_value kind)
{
    for (size_t j = 0; j < count; j += LANES)
        LANES_STORE(out + j, evaluate_lanes(r, j, has_s, kind));
}

/* Computes the values of `count` numbers in the table, which fill whole vectors. */
SHARED void evaluate_block(double *out, const struct cor_row_table *table, const double *x, size_t count)
{
    struct reduced r;
    enum cor_row_value kind = table->value;
    switch (table->kind) {
    case COR_ROW_NONE:
        memcpy(out, x, count * sizeof *out);
        return;
    case COR_ROW_GRID:
        reduce_grid(&r, table, x, count, 0, 0);
        break;
    case COR_ROW_ROOT:
        reduce_grid(&r, table, x, count, 1, 0);
        break;
    case COR_ROW_ROOT_S:
        reduce_grid(&r, table, x, count, 1, 1);
        if (kind == COR_ROW_SUM)
            evaluate_rows(out, &r, count, 1, COR_ROW_SUM);
        else
            evaluate_rows(out, &r, count, 1, COR_ROW_PRODUCT);
        return;
    case COR_ROW_OCTAVES:
        reduce_octaves(&r, table, x, count);
        for (size_t j = 0; kind != COR_ROW_SUM && j < count; j++)
            r.factor[j] = 1;
        break;
    case COR_ROW_INVERSE:
        reduce_inverse(&r, table, x, count, 0);
        break;
    case COR_ROW_INVERSE_ROOT:
        reduce_inverse(&r, table, x, count, 1);
        break;
    case COR_ROW_PARTS:
        if (!(table->below ? reduce_parts(&r, table, x, count, 1) : reduce_parts(&r, table, x, count, 0)) &&
            kind == COR_ROW_EPS)
            kind = COR_ROW_SUM; /* m = 1 */
        break;
    }
    switch (kind) {
    case COR_ROW_SUM:
        evaluate_rows(out, &r, count, 0, COR_ROW_SUM);
        return;
    case COR_ROW_PRODUCT:
        evaluate_rows(out, &r, count, 0, COR_ROW_PRODUCT);
        return;
    case COR_ROW_EPS:
        evaluate_rows(out, &r, count, 0, COR_ROW_EPS);
        return;
    case COR_ROW_LOSS:
        evaluate_rows(out, &r, count, 0, COR_ROW_LOSS);
        return;
    }
}

/* True if the scalar function is faster: n is small, or the build has no vectors and the kind is COR_ROW_PARTS. */
COR_KERNEL int one_by_one(const struct cor_row_table *table, size_t n)
{
    return n < 8 || (LANES == 1 && table->kind == COR_ROW_PARTS);
}

/* ---- arrays of doubles ---- */

/* Stores are plain: on a Zen 4, non-temporal stores and prefetches are slower for arrays that exceed the caches. */
static void loop_doubles(const struct cor_row_call *call, const double *in, double *out, size_t n)
{
    const struct cor_row_table *const table = call->table;
    if (call->one && one_by_one(table, n)) {
        for (size_t i = 0; i < n; i++)
            out[i] = call->one(in[i]);
        return;
    }
    for (size_t i = 0, m; i < n; i += m) {
        double given[BLOCK], taken[BLOCK], value[BLOCK];
        m = n - i < BLOCK ? n - i : BLOCK;
        if (call->before)
            call->before(call->context, in + i, given, m);
        const double *const x = call->before ? given : in + i;
        const size_t outside = take(taken, table, x, m);
        const int to_complete = outside || call->always_after, final = !to_complete && m == whole_blocks(m);
        if (outside < m)
            evaluate_block(final ? out + i : value, table, taken, whole_blocks(m));
        if (final)
            continue;
        if (to_complete && call->after) {
            const struct cor_row_block block = {i, m, outside, in + i, x, taken};
            call->after(call->context, &block, value);
        } else if (to_complete && call->one) {
            for (size_t j = 0; j < m; j++)
                if (!is_same(x[j], taken[j]))
                    value[j] = call->one(x[j]);
        }
        memcpy(out + i, value, m * sizeof *out);
    }
}

static void one_block(const struct cor_row_table *table, const double *x, double *taken, double *value, size_t m)
{
    take(taken, table, x, m);
    evaluate_block(value, table, taken, whole_blocks(m));
}

/* ---- arrays in float arithmetic ---- */

/* Calls a separate loop for each kind of table, so that `product` is a constant of the loop. */
static void loop_floats(const struct float_table *table, double (*one)(double), const float *in, float *out, size_t n)
{
    struct float_table t = *table;
    if (table->product) {
        t.product = 1;
        floats_from_beta(in, out, n, &t, one);
    } else {
        t.product = 0;
        floats_from_beta(in, out, n, &t, one);
    }
}

const struct cor_row_loops COR_OF_SET(cor_row_loops) = {COR_SET_NAME, loop_doubles, loop_floats, one_block};
