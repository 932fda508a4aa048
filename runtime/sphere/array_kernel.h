/* SPDX-License-Identifier: MIT */
/* eps of whole arrays, at either end, from beta or from an impact speed: compiled once for every instruction set, in
 * sphere_array_<set>.c, and chosen in sphere_array.c. No set may fuse a multiplication with an addition, so all of
 * them and the scalar functions give the same bits.
 *
 * Blocks of numbers go through loops that a compiler vectorises: reduce to row, s and t; bring the rows' columns
 * side by side and evaluate; and put right, one by one, what lies outside the tables. */
#ifndef COR_RUNTIME_SPHERE_ARRAY_KERNEL_H
#define COR_RUNTIME_SPHERE_ARRAY_KERNEL_H

#include <stddef.h>

#include "runtime/sphere/array.h"
#include "runtime/sphere/eval.h"

#if defined(__AVX512F__) && defined(__AVX512DQ__)
#include <immintrin.h>
enum { LANES = 8 };
typedef __m512d lanes;
#define LANES_LOAD(p) _mm512_loadu_pd(p)
#define LANES_STORE(p, v) _mm512_storeu_pd(p, v)
#define LANES_STREAM(p, v) _mm512_stream_pd(p, v)

/* Columns k to k + 3 of eight rows, transposed: faster than gathers by 1.8 (bench/). */
static inline void lanes_columns(lanes *c, const double *const row[], int k)
{
#define FOUR(i, j)                                                                                                     \
    _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(row[i] + k)), _mm256_loadu_pd(row[j] + k), 1)
    const lanes p = FOUR(0, 2), q = FOUR(1, 3), r = FOUR(4, 6), s = FOUR(5, 7);
    const lanes even = _mm512_unpacklo_pd(p, q), even4 = _mm512_unpacklo_pd(r, s);
    const lanes odd = _mm512_unpackhi_pd(p, q), odd4 = _mm512_unpackhi_pd(r, s);
    c[k] = _mm512_shuffle_f64x2(even, even4, 0x88);
    c[k + 1] = _mm512_shuffle_f64x2(odd, odd4, 0x88);
    c[k + 2] = _mm512_shuffle_f64x2(even, even4, 0xdd);
    c[k + 3] = _mm512_shuffle_f64x2(odd, odd4, 0xdd);
#undef FOUR
}
#elif defined(__AVX2__)
#include <immintrin.h>
enum { LANES = 4 };
typedef __m256d lanes;
#define LANES_LOAD(p) _mm256_loadu_pd(p)
#define LANES_STORE(p, v) _mm256_storeu_pd(p, v)
#define LANES_STREAM(p, v) _mm256_stream_pd(p, v)

/* Columns k to k + 3 of four rows, transposed: faster than gathers by 2. */
static inline void lanes_columns(lanes *c, const double *const row[], int k)
{
#define TWO(i, j, k)                                                                                                   \
    _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(row[i] + (k))), _mm_loadu_pd(row[j] + (k)), 1)
    const lanes p = TWO(0, 2, k), q = TWO(1, 3, k), r = TWO(0, 2, k + 2), s = TWO(1, 3, k + 2);
    c[k] = _mm256_unpacklo_pd(p, q);
    c[k + 1] = _mm256_unpackhi_pd(p, q);
    c[k + 2] = _mm256_unpacklo_pd(r, s);
    c[k + 3] = _mm256_unpackhi_pd(r, s);
#undef TWO
}
#else
enum { LANES = 1 };
typedef double lanes;
#define LANES_LOAD(p) (*(p))
#define LANES_STORE(p, v) (*(p) = (v))

static inline void lanes_columns(lanes *c, const double *const row[], int k)
{
    for (int l = 0; l < 4; l++)
        c[k + l] = row[0][k + l];
}
#endif

/* Numbers that go through the loops together; the last ones of an array are filled up to whole lanes. */
enum { BLOCK = 256 };

/* What the reducing loop leaves for the others. */
struct reduced {
    double s[BLOCK], t[BLOCK];
    uint64_t row[BLOCK]; /* index into a table */
};

static inline lanes evaluate_lanes(const struct reduced *r, const double *rows, int j)
{
    const double *row[LANES];
    lanes c[COR_INLINE_COLUMNS];
    for (int l = 0; l < LANES; l++)
        /* every block has at least one number, which the analyser does not see */
        row[l] = rows + COR_INLINE_COLUMNS * r->row[j + l]; /* NOLINT(clang-analyzer-core.*) */
    for (int k = 0; k < COR_INLINE_COLUMNS; k += 4)
        lanes_columns(c, row, k);
    const lanes s = LANES_LOAD(r->s + j), t = LANES_LOAD(r->t + j), t2 = t * t, t4 = t2 * t2;
    return c[0] + COR_INLINE_ROW(c, s, t, t2, t4);
}

/* eps[j] = c_0 + rest for a block. */
static inline void evaluate_rows(double *eps, const struct reduced *r, const double *rows, int count)
{
    for (int j = 0; j < count; j += LANES)
        LANES_STORE(eps + j, evaluate_lanes(r, rows, j));
}

/* The same past the caches, into an array too large for them that begins on a line of theirs: what would be read in
 * only to be overwritten stays where it is. */
#ifdef LANES_STREAM
static inline void evaluate_rows_streaming(double *eps, const struct reduced *r, const double *rows)
{
    for (int j = 0; j < BLOCK; j += LANES)
        LANES_STREAM(eps + j, evaluate_lanes(r, rows, j));
}
#endif
enum { STREAM_FROM = 1 << 22 /* numbers: 32 MiB */, CACHE_LINE = 64 };

/* beta of a block by the rows in beta, or in sqrt(beta). */
static inline void reduce_overlap(struct reduced *r, const double *beta, int count)
{
    const struct cor_inline_grid grid = COR_INLINE_GRID(COR_ROWS_EPS_ZERO_OVERLAP);
    for (int j = 0; j < count; j++) {
        const int i = cor_inline_grid_row(grid, beta[j]);
        r->row[j] = (uint64_t)i;
        r->s[j] = r->t[j] = cor_inline_grid_t(grid, beta[j], i);
    }
}

static inline void reduce_force(struct reduced *r, const double *beta, int count)
{
    const struct cor_inline_grid grid = COR_INLINE_GRID(COR_ROWS_EPS_ZERO_FORCE);
    for (int j = 0; j < count; j++) {
        const double z = sqrt(beta[j]);
        const int i = cor_inline_grid_row(grid, z);
        const double node = grid.first + i * grid.step, t = z - node, square = beta[j] - node * node;
        r->row[j] = (uint64_t)i;
        r->t[j] = t;
        r->s[j] = node < COR_ROWS_EPS_ZERO_FORCE_PLAIN_ROWS * grid.step ? t : square;
    }
}

typedef void reduce_function(struct reduced *r, const double *beta, int count);

/* What an array function needs to know of an end of contact. */
struct end {
    const double *beta_rows, *power_rows;
    struct cor_inline_octaves power_grid;
    double far, power_near, power_far; /* the tables' ends: in beta, and in x = beta^5 both */
    double (*eps)(double beta);
    double (*contact_eps)(const struct cor_sphere_contact *contact, double speed);
};

/* The next m numbers of `in`, which may be `out` too; how many numbers the block is, whole lanes. */
static inline int next_block(double *block, const double *in, size_t m)
{
    const int count = ((int)m + LANES - 1) / LANES * LANES;
    memcpy(block, in, m * sizeof *block);
    for (int j = (int)m; j < count; j++)
        block[j] = in[0];
    return count;
}

/* Whether results go past the caches; a double at an odd address cannot. */
static inline int streams(const double *out, size_t n)
{
    return n >= STREAM_FROM && (uintptr_t)out % sizeof *out == 0;
}

/* How many numbers the block that begins at i has: where results are streamed, the first one only leads to a line. */
static inline size_t block_length(const double *out, size_t i, size_t n, int stream)
{
    const size_t aside = (size_t)((uintptr_t)out % CACHE_LINE) / sizeof *out;
    const size_t length = stream && i == 0 && aside != 0 ? CACHE_LINE / sizeof *out - aside : BLOCK;
    return n - i < length ? n - i : length;
}

/* Writes a block's results, from the rows alone where `final` says that nothing is left to put right. */
static inline void put_block(double *out, double *eps, const struct reduced *r, const double *rows, size_t m, int count,
                             int final, int stream)
{
#ifdef LANES_STREAM
    if (final && stream && m == BLOCK) {
        evaluate_rows_streaming(out, r, rows);
        return;
    }
#endif
    (void)stream;
    evaluate_rows(final && m == (size_t)count ? out : eps, r, rows, count);
    if (final && m != (size_t)count)
        memcpy(out, eps, m * sizeof *out);
}

/* Asks for the numbers four blocks ahead, which memory takes as long to bring as those blocks take to compute. */
static inline void look_ahead(const double *in, size_t i, size_t n, int stream)
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

static inline void end_streaming(int stream)
{
#ifdef LANES_STREAM
    if (stream)
        _mm_sfence();
#endif
    (void)stream;
}

static inline void from_beta(const double *in, double *out, size_t n, const struct end *end, reduce_function *reduce)
{
    const int stream = streams(out, n);
    for (size_t i = 0, m; i < n; i += m) {
        double from[BLOCK], beta[BLOCK], eps[BLOCK];
        struct reduced r;
        int outside = 0;
        m = block_length(out, i, n, stream);
        look_ahead(in, i, n, stream);
        const int count = next_block(from, in + i, m);
        for (int j = 0; j < count; j++) {
            const int inside = (from[j] >= 0) & (from[j] < end->far);
            outside |= !inside;
            beta[j] = inside ? from[j] : 0;
        }
        reduce(&r, beta, count);
        put_block(out + i, eps, &r, end->beta_rows, m, count, !outside, stream);
        if (!outside)
            continue;
        for (size_t j = 0; j < m; j++)
            if (!(from[j] >= 0 && from[j] < end->far))
                eps[j] = end->eps(from[j]);
        memcpy(out + i, eps, m * sizeof *out);
    }
    end_streaming(stream);
}

/* The rows in x = scale speed = beta^5; where x is beyond them, the rows in its root; beyond those, one by one. */
static inline void from_speed(const struct cor_sphere_contact *contact, const double *in, double *out, size_t n,
                              const struct end *end, reduce_function *reduce)
{
    const double scale = contact->beta5_per_speed, least = COR_INLINE_2_M900, most = COR_INLINE_2_900;
    const int stream = streams(out, n);
    for (size_t i = 0, m; i < n; i += m) {
        double from[BLOCK], x[BLOCK], beta[BLOCK], eps[BLOCK], other[BLOCK];
        struct reduced r;
        int beyond = 0, within = 0;
        m = block_length(out, i, n, stream);
        look_ahead(in, i, n, stream);
        const int count = next_block(from, in + i, m);
        for (int j = 0; j < count; j++) {
            x[j] = scale * from[j];
            const int inside = (x[j] >= end->power_near) & (x[j] < end->power_far);
            beyond |= !inside;
            within |= inside;
            const double y = inside ? x[j] : 1;
            r.row[j] = cor_inline_octaves_row(end->power_grid, y);
            r.s[j] = r.t[j] = cor_inline_octaves_t(end->power_grid, y);
        }
        if (within)
            put_block(out + i, eps, &r, end->power_rows, m, count, !beyond, stream);
        if (!beyond)
            continue;
        int outside = 0;
        for (int j = 0; j < count; j++) {
            /* below 2^-180 beta is not told apart: eps is 1 to the last bit */
            const double root = cor_inline_fifth_root_normal(((x[j] > least) & (x[j] < most)) ? x[j] : least);
            /* the speed's sign: a small negative one may leave x = -0 */
            const int inside = (from[j] >= 0) & (x[j] < most) & (root < end->far);
            outside |= !inside;
            beta[j] = inside ? root : 0;
        }
        reduce(&r, beta, count);
        evaluate_rows(other, &r, end->beta_rows, count);
        for (size_t j = 0; j < m; j++)
            out[i + j] = within && x[j] >= end->power_near && x[j] < end->power_far ? eps[j] : other[j];
        for (size_t j = 0; outside && j < m; j++)
            if (beta[j] == 0 && !(x[j] >= end->power_near && x[j] < end->power_far))
                out[i + j] = end->contact_eps(contact, from[j]);
    }
    end_streaming(stream);
}

#define END_OF_CONTACT(name, NAME)                                                                                     \
    static inline struct end end_##name(void)                                                                          \
    {                                                                                                                  \
        const struct end end = {cor_rows_eps_zero_##name(0),                                                           \
                                cor_rows_power_eps_zero_##name(0),                                                     \
                                COR_INLINE_OCTAVES(COR_ROWS_POWER_EPS_ZERO_##NAME),                                    \
                                COR_ROWS_EPS_ZERO_##NAME##_END,                                                        \
                                COR_ROWS_POWER_EPS_ZERO_##NAME##_FIRST,                                                \
                                COR_ROWS_POWER_EPS_ZERO_##NAME##_END,                                                  \
                                cor_inline_eps_zero_##name,                                                            \
                                cor_contact_eps_zero_##name};                                                          \
        return end;                                                                                                    \
    }
END_OF_CONTACT(overlap, OVERLAP)
END_OF_CONTACT(force, FORCE)

#define ARRAYS(set)                                                                                                    \
    void cor_array_eps_zero_overlap_##set(const struct cor_sphere_contact *contact, const double *in, double *out,     \
                                          size_t n)                                                                    \
    {                                                                                                                  \
        const struct end end = end_overlap();                                                                          \
        (void)contact;                                                                                                 \
        from_beta(in, out, n, &end, reduce_overlap);                                                                   \
    }                                                                                                                  \
    void cor_array_eps_zero_force_##set(const struct cor_sphere_contact *contact, const double *in, double *out,       \
                                        size_t n)                                                                      \
    {                                                                                                                  \
        const struct end end = end_force();                                                                            \
        (void)contact;                                                                                                 \
        from_beta(in, out, n, &end, reduce_force);                                                                     \
    }                                                                                                                  \
    void cor_array_speed_zero_overlap_##set(const struct cor_sphere_contact *contact, const double *in, double *out,   \
                                            size_t n)                                                                  \
    {                                                                                                                  \
        const struct end end = end_overlap();                                                                          \
        from_speed(contact, in, out, n, &end, reduce_overlap);                                                         \
    }                                                                                                                  \
    void cor_array_speed_zero_force_##set(const struct cor_sphere_contact *contact, const double *in, double *out,     \
                                          size_t n)                                                                    \
    {                                                                                                                  \
        const struct end end = end_force();                                                                            \
        from_speed(contact, in, out, n, &end, reduce_force);                                                           \
    }

#endif
