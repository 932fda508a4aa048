/* SPDX-License-Identifier: MIT */
/* Array functions that evaluate a row of a table (row.h) for each number. A kernel that includes this file is compiled
 * once for every instruction set. No set may fuse a multiplication with an addition, so all sets and the scalar
 * functions give the same bits.
 *
 * Three loops process each block of numbers. The first finds the row and the variables of every number. The second
 * loads the columns of several rows into vectors and evaluates them. The third computes numbers outside the tables one
 * by one. A compiler vectorises the first two. */
#ifndef COR_RUNTIME_ROW_LANES_H
#define COR_RUNTIME_ROW_LANES_H

#include <stddef.h>

#include "runtime/table/row.h"

/* A compiler makes a separate loop of each call with a constant table. */
#ifdef __GNUC__
#define KERNEL static inline __attribute__((always_inline))
#else
#define KERNEL static inline
#endif

/* Vectors have four elements even where AVX-512 offers eight: more of the 12 columns and the powers of t stay in
 * registers, and shuffles across 512 bits cost twice as much. Measured on a Zen 4, an eps takes 1.37 ns instead of
 * 1.46. */
#if defined(__AVX2__)
#include <immintrin.h>
enum { LANES = 4 };
typedef __m256d lanes;
#define LANES_LOAD(p) _mm256_loadu_pd(p)
#define LANES_STORE(p, v) _mm256_storeu_pd(p, v)
#define LANES_STREAM(p, v) _mm256_stream_pd(p, v)
#define LANES_ALL(x) _mm256_set1_pd(x)
/* x < y ? if_true : if_false */
#define LANES_CHOOSE_LESS(x, y, if_true, if_false) _mm256_blendv_pd(if_false, if_true, _mm256_cmp_pd(x, y, _CMP_LT_OQ))

/* Columns k to k + 3 of four rows, transposed. Gathers take twice as long. */
KERNEL void lanes_columns(lanes c[4], const double *const row[], int k)
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

KERNEL lanes lanes_head(lanes x)
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

KERNEL void lanes_columns(lanes c[4], const double *const row[], int k)
{
    for (int l = 0; l < 4; l++)
        c[l] = row[0][k + l];
}

KERNEL lanes lanes_head(lanes x)
{
    return cor_inline_head(x);
}
#endif

/* The loops process this many numbers together. The last block of an array is filled up to whole vectors. */
enum { BLOCK = 256 };

/* Results of the first loop for the second one, which computes m (c_0 + row(s, t)). */
struct reduced {
    double s[BLOCK], t[BLOCK], m[BLOCK];
    uint64_t row[BLOCK]; /* its address */
};

/* Whether s differs from t, and m from 1. Where m < 1 the product may be a loss 1 - eps, while c_0 + row is eps: then
 * LOSS_TO_EPS gives eps for every m, and EPS_TO_LOSS the loss for every m. */
enum form_of_loss { AS_IT_IS, LOSS_TO_EPS, EPS_TO_LOSS };
struct form {
    int has_s, has_m;
    enum form_of_loss loss;
};

static const struct form form_plain = {0, 0, AS_IT_IS}, form_s = {1, 0, AS_IT_IS}, form_m = {0, 1, AS_IT_IS},
                         form_s_m = {1, 1, AS_IT_IS};

KERNEL uint64_t address_of(const double *rows, uint64_t i)
{
    return (uint64_t)(uintptr_t)rows + i * (COR_INLINE_COLUMNS * sizeof *rows);
}

/* The operations of COR_INLINE_ROW and COR_INLINE_ROW_TIMES_S, with the last columns first. Fewer vectors are alive at
 * a time, and the processor computes with the last columns while it loads the first. */
KERNEL lanes evaluate_lanes(const struct reduced *r, struct form form, int j)
{
    const double *row[LANES];
    lanes c[4], rest;
    for (int l = 0; l < LANES; l++)
        row[l] = (const double *)(uintptr_t)r->row[j + l];
    const lanes t = LANES_LOAD(r->t + j), p2 = t * t, p4 = p2 * p2, p6 = p4 * p2, p8 = p4 * p4;
    lanes_columns(c, row, 8);
    if (form.has_s) {
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
    if (!form.has_m)
        return c[0] + rest;
    const lanes m = LANES_LOAD(r->m + j), head = lanes_head(m), one = LANES_ALL(1.0);
    const lanes product = head * c[0] + ((m - head) * c[0] + m * rest);
    if (form.loss == LOSS_TO_EPS) /* m = 1: the product is c_0 + row to the last bit */
        return LANES_CHOOSE_LESS(m, one, one - product, product);
    if (form.loss == EPS_TO_LOSS) { /* 1 - c_0 exactly, in two parts */
        const lanes hi = one - c[0], part = hi - one;
        return LANES_CHOOSE_LESS(m, one, product, hi + (((one - (hi - part)) + (-c[0] - part)) - rest));
    }
    return product;
}

KERNEL void evaluate(double *out, const struct reduced *r, struct form form, int count)
{
    for (int j = 0; j < count; j += LANES)
        LANES_STORE(out + j, evaluate_lanes(r, form, j));
}

/* Stores past the caches, for an array that is too large for them and begins at a cache line. The processor then does
 * not read the lines that it overwrites. */
#ifdef LANES_STREAM
KERNEL void evaluate_streaming(double *out, const struct reduced *r, struct form form)
{
    for (int j = 0; j < BLOCK; j += LANES)
        LANES_STREAM(out + j, evaluate_lanes(r, form, j));
}
#endif
enum { STREAM_FROM = 1 << 22 /* numbers: 32 MiB */, CACHE_LINE = 64 };

/* ---- blocks ---- */

/* Copies the next m numbers of `in`, which may be the same array as `out`. Returns the length of the block, a multiple
 * of the vector length. */
KERNEL int block_read(double *block, const double *in, size_t m)
{
    const int count = ((int)m + LANES - 1) / LANES * LANES;
    memcpy(block, in, m * sizeof *block);
    for (int j = (int)m; j < count; j++)
        block[j] = in[0];
    return count;
}

/* Whether results are stored past the caches; doubles at unaligned addresses cannot be. */
KERNEL int streams(const double *out, size_t n)
{
    return n >= STREAM_FROM && (uintptr_t)out % sizeof *out == 0;
}

/* Length of the block that begins at i. If results are stored past the caches, the first block only reaches to the next
 * cache line. */
KERNEL size_t block_length(const double *out, size_t i, size_t n, int stream)
{
    const size_t aside = (size_t)((uintptr_t)out % CACHE_LINE) / sizeof *out;
    const size_t length = stream && i == 0 && aside != 0 ? CACHE_LINE / sizeof *out - aside : BLOCK;
    return n - i < length ? n - i : length;
}

/* Writes the results of a block: to `out` if `final` says that all of them are computed, otherwise to `value`. */
KERNEL void block_evaluate(double *out, double *value, const struct reduced *r, struct form form, size_t m, int count,
                           int final, int stream)
{
#ifdef LANES_STREAM
    if (final && stream && m == BLOCK) {
        evaluate_streaming(out, r, form);
        return;
    }
#endif
    (void)stream;
    evaluate(final && m == (size_t)count ? out : value, r, form, count);
    if (final && m != (size_t)count)
        memcpy(out, value, m * sizeof *out);
}

/* Prefetches the numbers four blocks ahead. Memory delivers them in about the time that four blocks take to compute. */
KERNEL void look_ahead(const double *in, size_t i, size_t n, int stream)
{
#ifdef LANES_STREAM
    if (stream && n - i > 5 * (size_t)BLOCK)
        for (int k = 0; k < BLOCK; k += CACHE_LINE / 8)
            _mm_prefetch((const char *)(in + i + 4 * BLOCK + k), _MM_HINT_T0);
#endif
    (void)in;
    (void)i;
    (void)n;
    (void)stream;
}

KERNEL void end_streaming(int stream)
{
#ifdef LANES_STREAM
    if (stream)
        _mm_sfence();
#endif
    (void)stream;
}

/* Conditions are masks with all bits 1 or all bits 0, and selections use them. Compilers always vectorise masks, but
 * conditional expressions only sometimes. */
typedef int64_t mask;

KERNEL mask mask_of(int condition)
{
    return -(mask)condition;
}

/* Whether first <= x < end. The bits as integers have the order of nonnegative doubles, and are negative for other
 * doubles. */
KERNEL mask holds(double x, double first, double end)
{
    const int64_t bits = (int64_t)cor_inline_bits(x);
    return mask_of(bits >= (int64_t)cor_inline_bits(first)) & mask_of(bits < (int64_t)cor_inline_bits(end));
}

KERNEL mask is_same(double x, double y)
{
    return mask_of(cor_inline_bits(x) == cor_inline_bits(y));
}

KERNEL uint64_t choose_bits(mask choice, uint64_t if_true, uint64_t if_false)
{
    return (if_true & (uint64_t)choice) | (if_false & ~(uint64_t)choice);
}

KERNEL double choose(mask choice, double if_true, double if_false)
{
    return cor_inline_from_bits(choose_bits(choice, cor_inline_bits(if_true), cor_inline_bits(if_false)));
}

/* ---- arrays of eps: the inverse ---- */

struct inverse_table {
    const double *near_rows, *rows;
    struct cor_inline_grid near_grid;
    struct cor_inline_octaves grid;
    int root; /* 0: near_rows are rows of the loss; 1: of its square root; 2: of another root, and not used */
};

KERNEL mask inverse_has(const struct inverse_table *table, double eps)
{
    return table->root < 2 ? holds(eps, table->grid.first, 1) | is_same(eps, 1) : holds(eps, table->grid.first, 0.5);
}

KERNEL mask inverse_reduce(struct reduced *r, const struct inverse_table *table, const double *in, int count)
{
    mask outside = 0;
    for (int j = 0; j < count; j++) {
        const mask has = inverse_has(table, in[j]);
        const double eps = choose(has, in[j], table->root < 2 ? 1 : table->grid.first);
        const mask near = holds(eps, 0.5, 2);
        const double loss = choose(near, 1 - eps, 0), y = table->root == 1 ? sqrt(loss) : loss;
        const int i = cor_inline_grid_row(table->near_grid, y);
        const uint64_t near_row = address_of(table->near_rows, (uint64_t)i);
        const uint64_t row = address_of(table->rows, cor_inline_octaves_row(table->grid, eps));
        outside |= ~has;
        r->row[j] = choose_bits(near, near_row, row);
        r->t[j] = choose(near, cor_inline_grid_t(table->near_grid, y, i), cor_inline_octaves_t(table->grid, eps));
        r->m[j] = choose(near, loss, 1);
    }
    return outside;
}

typedef double scalar(double x);

KERNEL void from_eps(const double *in, double *out, size_t n, const struct inverse_table *table, scalar *one)
{
    const int stream = streams(out, n);
    for (size_t i = 0, m; i < n; i += m) {
        double from[BLOCK], value[BLOCK];
        struct reduced r;
        m = block_length(out, i, n, stream);
        look_ahead(in, i, n, stream);
        const int count = block_read(from, in + i, m);
        const mask outside = inverse_reduce(&r, table, from, count);
        block_evaluate(out + i, value, &r, form_m, m, count, !outside, stream);
        if (!outside)
            continue;
        for (size_t j = 0; j < m; j++)
            out[i + j] = inverse_has(table, from[j]) ? value[j] : one(from[j]);
    }
    end_streaming(stream);
}

#endif
