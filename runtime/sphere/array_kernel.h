/* SPDX-License-Identifier: MIT */
/* Array functions of the sphere, of beta, eps or an impact speed. array_<set>.c compiles them for its instruction set,
 * and array.c chooses a set. No set may fuse a multiplication with an addition, so all sets and the scalar functions
 * give the same bits.
 *
 * Three loops process each block of numbers. The first finds the row and the variables of every number. The second
 * loads the columns of several rows into vectors and evaluates them. The third computes numbers outside the tables one
 * by one. A compiler vectorises the first two. */
#ifndef COR_RUNTIME_SPHERE_ARRAY_KERNEL_H
#define COR_RUNTIME_SPHERE_ARRAY_KERNEL_H

#include <stddef.h>

#include "cor/sphere.h"
#include "runtime/sphere/array.h"
#include "runtime/sphere/contact_parts.h"
#include "runtime/sphere/eval.h"

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

/* Whether s differs from t, and m from 1 */
struct form {
    int has_s, has_m;
};

static const struct form form_plain = {0, 0}, form_s = {1, 0}, form_m = {0, 1}, form_s_m = {1, 1};

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
    const lanes m = LANES_LOAD(r->m + j), head = lanes_head(m);
    return head * c[0] + ((m - head) * c[0] + m * rest);
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

/* ---- tables in beta and in its root, and the inverse: the first loop ---- */

struct table {
    const double *rows;
    struct cor_inline_grid grid;
    double least, end; /* the table covers 0 and least <= beta < end */
    int root, plain;   /* whether the variable is sqrt(beta); number of rows with s = t */
    struct form form;
};

KERNEL mask table_has(const struct table *table, double beta)
{
    return holds(beta, table->least, table->end) | is_same(beta, 0);
}

/* Returns whether a number lies outside the table; such a number gets the row of 0. */
KERNEL mask table_reduce(struct reduced *r, const struct table *table, const double *in, int count)
{
    const struct cor_inline_grid grid = table->grid;
    mask outside = 0;
    for (int j = 0; j < count; j++) {
        const mask has = table_has(table, in[j]);
        const double beta = choose(has, in[j], 0), y = table->root ? sqrt(beta) : beta;
        const int i = cor_inline_grid_row(grid, y);
        const double node = cor_inline_grid_node(grid, i), t = y - node;
        outside |= ~has;
        r->row[j] = address_of(table->rows, (uint64_t)i);
        r->t[j] = t;
        if (table->form.has_s)
            r->s[j] = choose(mask_of(node < table->plain * grid.step), t, beta - node * node);
        if (table->form.has_m)
            r->m[j] = beta;
    }
    return outside;
}

struct inverse_table {
    const double *near_rows, *rows;
    struct cor_inline_grid near_grid;
    struct cor_inline_octaves grid;
    int root;
};

KERNEL mask inverse_has(const struct inverse_table *table, double eps)
{
    return holds(eps, table->grid.first, 1) | is_same(eps, 1);
}

KERNEL mask inverse_reduce(struct reduced *r, const struct inverse_table *table, const double *in, int count)
{
    mask outside = 0;
    for (int j = 0; j < count; j++) {
        const mask has = inverse_has(table, in[j]);
        const double eps = choose(has, in[j], 1);
        const mask near = holds(eps, 0.5, 2);
        const double loss = choose(near, 1 - eps, 0), y = table->root ? sqrt(loss) : loss;
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

/* ---- arrays of beta and of eps ---- */

typedef double scalar(double x);

KERNEL void from_beta(const double *in, double *out, size_t n, const struct table *table, scalar *one)
{
    const int stream = streams(out, n);
    for (size_t i = 0, m; i < n; i += m) {
        double from[BLOCK], value[BLOCK];
        struct reduced r;
        m = block_length(out, i, n, stream);
        look_ahead(in, i, n, stream);
        const int count = block_read(from, in + i, m);
        const mask outside = table_reduce(&r, table, from, count);
        block_evaluate(out + i, value, &r, table->form, m, count, !outside, stream);
        if (!outside)
            continue;
        for (size_t j = 0; j < m; j++)
            out[i + j] = table_has(table, from[j]) ? value[j] : one(from[j]);
    }
    end_streaming(stream);
}

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

#define TABLE(quantity, NAME, least, root, plain, form)                                                                \
    {                                                                                                                  \
        cor_rows_##quantity(0), COR_INLINE_GRID(COR_ROWS_##NAME), least, COR_ROWS_##NAME##_END, root, plain, form      \
    }

KERNEL struct table table_eps_zero_overlap(void)
{
    const struct table table = TABLE(eps_zero_overlap, EPS_ZERO_OVERLAP, 0, 0, 0, form_plain);
    return table;
}

KERNEL struct table table_eps_zero_force(void)
{
    const struct table table = TABLE(eps_zero_force, EPS_ZERO_FORCE, 0, 1, COR_ROWS_EPS_ZERO_FORCE_PLAIN_ROWS, form_s);
    return table;
}

KERNEL struct table table_loss_zero_overlap(void)
{
    const struct table table = TABLE(loss_zero_overlap, LOSS_ZERO_OVERLAP, COR_INLINE_2_M900, 0, 0, form_m);
    return table;
}

KERNEL struct table table_loss_zero_force(void)
{
    const struct table table =
        TABLE(loss_zero_force, LOSS_ZERO_FORCE, COR_INLINE_2_M900, 1, COR_ROWS_LOSS_ZERO_FORCE_PLAIN_ROWS, form_s_m);
    return table;
}

KERNEL struct table table_duration_zero_overlap(void)
{
    const struct table table = TABLE(duration_zero_overlap, DURATION_ZERO_OVERLAP, 0, 0, 0, form_plain);
    return table;
}

KERNEL struct table table_duration_zero_force(void)
{
    const struct table table = TABLE(duration_zero_force, DURATION_ZERO_FORCE, 0, 1, 0, form_plain);
    return table;
}

KERNEL struct table table_max_overlap(void)
{
    const struct table table = TABLE(max_overlap, MAX_OVERLAP, 0, 0, 0, form_plain);
    return table;
}

KERNEL struct table table_time_of_max_overlap(void)
{
    const struct table table = TABLE(time_of_max_overlap, TIME_OF_MAX_OVERLAP, 0, 0, 0, form_plain);
    return table;
}

#define INVERSE_TABLE(end, END, root)                                                                                  \
    {                                                                                                                  \
        cor_rows_near_beta_zero_##end(0), cor_rows_beta_zero_##end(0), COR_INLINE_GRID(COR_ROWS_NEAR_BETA_ZERO_##END), \
            COR_INLINE_OCTAVES(COR_ROWS_BETA_ZERO_##END), root                                                         \
    }

KERNEL struct inverse_table table_beta_zero_overlap(void)
{
    const struct inverse_table table = INVERSE_TABLE(overlap, OVERLAP, 0);
    return table;
}

KERNEL struct inverse_table table_beta_zero_force(void)
{
    const struct inverse_table table = INVERSE_TABLE(force, FORCE, 1);
    return table;
}

/* ---- eps of impact speeds ---- */

/* Tables and functions of one end of contact */
struct end {
    const double *power_rows;
    struct cor_inline_octaves power_grid;
    double power_end;
    struct table table;               /* in beta */
    double (*eps_far_root)(double x); /* beyond the table; or NULL */
    double (*contact_eps)(const struct cor_sphere_contact *contact, double speed);
};

/* Uses the rows in x = scale speed = beta^5. Beyond them it uses the rows in the fifth root of x; numbers beyond these
 * it computes one by one. */
KERNEL void eps_from_speed(const struct cor_sphere_contact *contact, const double *in, double *out, size_t n,
                           const struct end *end)
{
    const double scale = contact->beta5_per_speed, least = COR_INLINE_2_M900;
    const uint64_t limit = cor_contact_speed_limit(scale);
    const int stream = streams(out, n);
    for (size_t i = 0, m; i < n; i += m) {
        double from[BLOCK], x[BLOCK], beta[BLOCK], eps[BLOCK], other[BLOCK];
        struct reduced r;
        mask beyond = 0, within = 0;
        m = block_length(out, i, n, stream);
        look_ahead(in, i, n, stream);
        const int count = block_read(from, in + i, m);
        for (int j = 0; j < count; j++) {
            /* -1 is outside every table, and its product cannot overflow as that of a large speed could */
            x[j] = scale * choose(mask_of((int64_t)cor_inline_bits(from[j]) < (int64_t)limit), from[j], -1);
            const mask inside = holds(x[j], end->power_grid.first, end->power_end);
            beyond |= ~inside;
            within |= inside;
            const double y = choose(inside, x[j], end->power_grid.first);
            r.row[j] = address_of(end->power_rows, cor_inline_octaves_row(end->power_grid, y));
            r.t[j] = cor_inline_octaves_t(end->power_grid, y);
        }
        if (within)
            block_evaluate(out + i, eps, &r, form_plain, m, count, !beyond, stream);
        if (!beyond)
            continue;
        for (int j = 0; j < count; j++) {
            /* below 2^-180 eps is 1 to the last bit */
            const mask small = holds(x[j], 0, least), normal = holds(x[j], least, COR_INLINE_2_900);
            const double root = cor_inline_fifth_root_normal(choose(normal, x[j], least));
            /* NaN is not below the end of the table; a negative speed may give x = -0 */
            beta[j] = choose((small | normal) & holds(from[j], 0, cor_inline_infinity()), root, -1);
        }
        table_reduce(&r, &end->table, beta, count);
        evaluate(other, &r, end->table.form, count);
        for (size_t j = 0; j < m; j++) {
            if (holds(x[j], end->power_grid.first, end->power_end))
                out[i + j] = eps[j];
            else if (end->eps_far_root && holds(x[j], end->power_end, COR_INLINE_2_900))
                out[i + j] = end->eps_far_root(x[j]);
            else if (table_has(&end->table, beta[j]))
                out[i + j] = other[j];
            else
                out[i + j] = end->contact_eps(contact, from[j]);
        }
    }
    end_streaming(stream);
}

#define END_OF_CONTACT(end, END, eps_far_root)                                                                         \
    {                                                                                                                  \
        cor_rows_power_eps_zero_##end(0), COR_INLINE_OCTAVES(COR_ROWS_POWER_EPS_ZERO_##END),                           \
            COR_ROWS_POWER_EPS_ZERO_##END##_END, table_eps_zero_##end(), eps_far_root, cor_contact_eps_zero_##end      \
    }

/* ---- beta, times and overlaps of impact speeds ---- */

enum contact_quantity { CONTACT_BETA, CONTACT_DURATION, CONTACT_OVERLAP };

typedef double contact_scalar(const struct cor_sphere_contact *contact, double speed);

/* The operations of contact.c, for speeds at which nothing can overflow (contact_parts.h) */
KERNEL void from_speed(const struct cor_sphere_contact *contact, const double *in, double *out, size_t n,
                       enum contact_quantity quantity, const struct table *table, contact_scalar *one)
{
    const mask ordinary = mask_of(cor_contact_is_ordinary(contact, quantity != CONTACT_BETA));
    for (size_t i = 0, m; i < n; i += m) {
        double from[BLOCK], root[BLOCK], beta[BLOCK], value[BLOCK];
        struct reduced r;
        m = n - i < BLOCK ? n - i : BLOCK;
        const int count = block_read(from, in + i, m);
        for (int j = 0; j < count; j++) {
            const mask has = holds(from[j], COR_CONTACT_LEAST_SPEED, COR_CONTACT_MOST_SPEED) & ordinary;
            const struct cor_inline_pair parts = cor_inline_fifth_root_parts(choose(has, from[j], 1));
            root[j] = parts.hi + parts.lo;
            beta[j] = choose(has, cor_contact_beta_of_root(contact->beta_per_root, parts), -1);
        }
        if (quantity == CONTACT_BETA) {
            memcpy(value, beta, sizeof value);
        } else {
            table_reduce(&r, table, beta, count);
            evaluate(value, &r, table->form, count);
        }
        for (int j = 0; j < count && quantity != CONTACT_BETA; j++)
            value[j] = quantity == CONTACT_DURATION ? cor_contact_duration_of(contact->scale, root[j], value[j])
                                                    : cor_contact_overlap_of(contact->scale, root[j], value[j]);
        for (size_t j = 0; j < m; j++) {
            const mask has =
                quantity == CONTACT_BETA ? holds(beta[j], 0, cor_inline_infinity()) : table_has(table, beta[j]);
            out[i + j] = has ? value[j] : one(contact, from[j]);
        }
    }
}

typedef double dissipation_scalar(const struct cor_sphere_contact *contact, double speed, double eps);

KERNEL void dissipation_from_eps(const struct cor_sphere_contact *contact, const double *speed, const double *eps,
                                 double *out, size_t n, const struct inverse_table *table, dissipation_scalar *one)
{
    const mask ordinary = mask_of(cor_contact_is_ordinary(contact, 1));
    for (size_t i = 0, m; i < n; i += m) {
        double from[BLOCK], of[BLOCK], value[BLOCK];
        struct reduced r;
        m = n - i < BLOCK ? n - i : BLOCK;
        const int count = block_read(from, speed + i, m);
        block_read(of, eps + i, m);
        inverse_reduce(&r, table, of, count);
        evaluate(value, &r, form_m, count);
        for (int j = 0; j < count; j++) {
            const mask has = holds(from[j], COR_CONTACT_LEAST_SPEED, COR_CONTACT_MOST_SPEED) & ordinary;
            const double root = cor_inline_fifth_root_normal(choose(has, from[j], 1));
            value[j] = cor_contact_dissipation_of(choose(has, contact->scale, 1), root, value[j]);
        }
        for (size_t j = 0; j < m; j++) {
            const mask has = holds(from[j], COR_CONTACT_LEAST_SPEED, COR_CONTACT_MOST_SPEED) & ordinary;
            out[i + j] = has && inverse_has(table, of[j]) ? value[j] : one(contact, from[j], of[j]);
        }
    }
}

/* ---- the functions of a set ---- */

#define ARRAY_FROM_BETA(quantity)                                                                                      \
    static void array_##quantity(const double *in, double *out, size_t n)                                              \
    {                                                                                                                  \
        const struct table table = table_##quantity();                                                                 \
        from_beta(in, out, n, &table, cor_sphere_##quantity);                                                          \
    }
#define ARRAY_FROM_EPS(quantity)                                                                                       \
    static void array_##quantity(const double *in, double *out, size_t n)                                              \
    {                                                                                                                  \
        const struct inverse_table table = table_##quantity();                                                         \
        from_eps(in, out, n, &table, cor_sphere_##quantity);                                                           \
    }
#define ARRAY_EPS_FROM_SPEED(end_name, END, eps_far_root)                                                              \
    static void contact_eps_zero_##end_name(const struct cor_sphere_contact *contact, const double *in, double *out,   \
                                            size_t n)                                                                  \
    {                                                                                                                  \
        const struct end end = END_OF_CONTACT(end_name, END, eps_far_root);                                            \
        eps_from_speed(contact, in, out, n, &end);                                                                     \
    }
#define ARRAY_FROM_SPEED(quantity, kind, of)                                                                           \
    static void contact_##quantity(const struct cor_sphere_contact *contact, const double *in, double *out, size_t n)  \
    {                                                                                                                  \
        const struct table table = table_##of();                                                                       \
        from_speed(contact, in, out, n, kind, &table, cor_contact_##quantity);                                         \
    }
#define ARRAY_DISSIPATION(end)                                                                                         \
    static void contact_dissipation_time_s_zero_##end(const struct cor_sphere_contact *contact, const double *speed,   \
                                                      const double *eps, double *out, size_t n)                        \
    {                                                                                                                  \
        const struct inverse_table table = table_beta_zero_##end();                                                    \
        dissipation_from_eps(contact, speed, eps, out, n, &table, cor_contact_dissipation_time_s_zero_##end);          \
    }

ARRAY_FROM_BETA(eps_zero_overlap)
ARRAY_FROM_BETA(eps_zero_force)
ARRAY_FROM_BETA(loss_zero_overlap)
ARRAY_FROM_BETA(loss_zero_force)
ARRAY_FROM_BETA(duration_zero_overlap)
ARRAY_FROM_BETA(duration_zero_force)
ARRAY_FROM_BETA(max_overlap)
ARRAY_FROM_BETA(time_of_max_overlap)
ARRAY_FROM_EPS(beta_zero_overlap)
ARRAY_FROM_EPS(beta_zero_force)
ARRAY_EPS_FROM_SPEED(overlap, OVERLAP, cor_inline_eps_overlap_far_root)
ARRAY_EPS_FROM_SPEED(force, FORCE, NULL)
ARRAY_FROM_SPEED(beta, CONTACT_BETA, eps_zero_overlap)
ARRAY_FROM_SPEED(duration_s_zero_overlap, CONTACT_DURATION, duration_zero_overlap)
ARRAY_FROM_SPEED(duration_s_zero_force, CONTACT_DURATION, duration_zero_force)
ARRAY_FROM_SPEED(max_overlap_m, CONTACT_OVERLAP, max_overlap)
ARRAY_DISSIPATION(overlap)
ARRAY_DISSIPATION(force)

#define ARRAY_SPHERE_ENTRY(quantity) array_##quantity,
#define ARRAY_CONTACT_ENTRY(quantity) contact_##quantity,
#define ARRAYS(set)                                                                                                    \
    const struct cor_array_set cor_array_##set = {#set, COR_SPHERE_QUANTITIES(ARRAY_SPHERE_ENTRY)                      \
                                                            COR_CONTACT_QUANTITIES(ARRAY_CONTACT_ENTRY)                \
                                                                COR_DISSIPATION_QUANTITIES(ARRAY_CONTACT_ENTRY)};

#endif
