/* SPDX-License-Identifier: MIT */
/* Array functions in float arithmetic that evaluate a row of a table of cubics for each number
 * (gen/approximation/pieces.h). A kernel that includes this file is compiled once for every instruction set. No set
 * may fuse a multiplication with an addition, so all sets give the same bits.
 *
 * A row has 16 bytes: one load fetches it, and shuffles turn the rows of eight numbers into four vectors. The exponent
 * and the first bits of a number are the row's index, so that no root is needed near beta = 0. */
#ifndef COR_RUNTIME_FLOAT_LANES_H
#define COR_RUNTIME_FLOAT_LANES_H

#include "runtime/number/kernel.h"

#if defined(__AVX2__)
#include <immintrin.h>
#endif

/* ---- vectors of floats, and of words: their bits as signed integers ---- */

#if defined(__AVX2__)
enum { FLOATS = 8 };
typedef __m256 floats;
typedef __m256i words;
#define FLOATS_LOAD(p) _mm256_loadu_ps(p)
#define FLOATS_STORE(p, v) _mm256_storeu_ps(p, v)
#define FLOATS_OF_WORDS(w) _mm256_castsi256_ps(w)
#define WORDS_OF_FLOATS(v) _mm256_castps_si256(v)
#define WORDS_ALL(w) _mm256_set1_epi32(w)
#define WORDS_STORE(p, w) _mm256_storeu_si256((__m256i *)(p), w)
#define WORDS_AND(v, w) _mm256_and_si256(v, w)
#define WORDS_OR(v, w) _mm256_or_si256(v, w)
#define WORDS_MINUS(v, w) _mm256_sub_epi32(v, w)
#define WORDS_LEAST(v, w) _mm256_min_epi32(v, w)
#define WORDS_MOST(v, w) _mm256_max_epi32(v, w)
#define WORDS_ABOVE(v, w) _mm256_cmpgt_epi32(v, w) /* all bits of v > w */
#define WORDS_UP(w, bits) _mm256_slli_epi32(w, bits)
#define WORDS_DOWN(w, bits) _mm256_srli_epi32(w, bits)
#define WORDS_SIGNS(w) _mm256_movemask_ps(_mm256_castsi256_ps(w))

/* Loads the columns of eight rows, whose offsets from `rows` in bytes are `at`. */
COR_KERNEL void floats_columns(floats c[4], const float *rows, const uint32_t at[FLOATS])
{
#define ROW_AT(i) _mm_loadu_ps((const float *)(const void *)((const char *)rows + at[i]))
#define ROWS_AT(i, j) _mm256_insertf128_ps(_mm256_castps128_ps256(ROW_AT(i)), ROW_AT(j), 1)
    const floats p = ROWS_AT(0, 4), q = ROWS_AT(1, 5), r = ROWS_AT(2, 6), s = ROWS_AT(3, 7);
    const floats even_01 = _mm256_unpacklo_ps(p, r), odd_01 = _mm256_unpacklo_ps(q, s);
    const floats even_23 = _mm256_unpackhi_ps(p, r), odd_23 = _mm256_unpackhi_ps(q, s);
    c[0] = _mm256_unpacklo_ps(even_01, odd_01);
    c[1] = _mm256_unpackhi_ps(even_01, odd_01);
    c[2] = _mm256_unpacklo_ps(even_23, odd_23);
    c[3] = _mm256_unpackhi_ps(even_23, odd_23);
#undef ROWS_AT
#undef ROW_AT
}
#else
enum { FLOATS = 1 };
typedef float floats;
typedef int32_t words;
#define FLOATS_LOAD(p) (*(p))
#define FLOATS_STORE(p, v) (*(p) = (v))
#define FLOATS_OF_WORDS(w) float_of_word(w)
#define WORDS_OF_FLOATS(v) word_of_float(v)
#define WORDS_ALL(w) ((int32_t)(w))
#define WORDS_STORE(p, w) (*(p) = (uint32_t)(w))
#define WORDS_AND(v, w) ((v) & (w))
#define WORDS_OR(v, w) ((v) | (w))
#define WORDS_MINUS(v, w) ((int32_t)((uint32_t)(v) - (uint32_t)(w)))
#define WORDS_LEAST(v, w) ((v) < (w) ? (v) : (w))
#define WORDS_MOST(v, w) ((v) > (w) ? (v) : (w))
#define WORDS_ABOVE(v, w) (-(int32_t)((v) > (w)))
#define WORDS_UP(w, bits) ((int32_t)((uint32_t)(w) << (bits)))
#define WORDS_DOWN(w, bits) ((int32_t)((uint32_t)(w) >> (bits)))
#define WORDS_SIGNS(w) ((w) < 0)
#endif

COR_KERNEL int32_t word_of_float(float x)
{
    int32_t word;
    memcpy(&word, &x, sizeof word);
    return word;
}

COR_KERNEL float float_of_word(int32_t word)
{
    float x;
    memcpy(&x, &word, sizeof x);
    return x;
}

#if !defined(__AVX2__)
COR_KERNEL void floats_columns(floats c[4], const float *rows, const uint32_t at[FLOATS])
{
    for (int k = 0; k < 4; k++)
        c[k] = rows[at[0] / sizeof *rows + (size_t)k];
}
#endif

/* ---- tables ---- */

struct float_table {
    const float *rows;
    float first, end;
    int shift;   /* 23 minus n, where an octave has 2^n rows */
    int product; /* true if the function is beta times the row; it is then valid for 0 and beta >= 2^-100 */
};

#define FLOAT_TABLE(quantity, NAME, product)                                                                           \
    {                                                                                                                  \
        cor_rows_float_##quantity(0), (float)COR_ROWS_FLOAT_##NAME##_FIRST, (float)COR_ROWS_FLOAT_##NAME##_END,        \
            23 - COR_ROWS_FLOAT_##NAME##_OCTAVE_BITS, product                                                          \
    }

/* 2^-100 and the part of a word that holds the sign, the exponent and the first five bits of the significand */
enum { FLOAT_PRODUCT_LEAST = (127 - 100) << 23, FLOAT_HEAD = -(1 << 19) };

/* Returns a word for each number. Its sign bit is set if the number is outside the table. */
COR_KERNEL words float_outside(const struct float_table *table, words x)
{
    const words last = WORDS_ALL(word_of_float(table->end) - 1), outside = WORDS_OR(x, WORDS_MINUS(last, x));
    if (!table->product)
        return outside;
    const words tiny = WORDS_ABOVE(WORDS_ALL(FLOAT_PRODUCT_LEAST), x);
    return WORDS_OR(outside, WORDS_AND(tiny, WORDS_ABOVE(x, WORDS_ALL(0))));
}

/* Returns the function at numbers in the table; for other numbers the value is undefined. The error has three parts:
 * the error of the row, the rounding of c_0' + t (...), and half a unit of the last place for the final addition. c_0'
 * + t (...) is at most c_0/100. In a product, head c_0 is exact, because c_0 has 19 bits and head, the leading part of
 * x, has 5. */
COR_KERNEL floats float_values(const struct float_table *table, floats x)
{
    const int shift = table->shift;
    const int32_t row_0 = word_of_float(table->first) - (1 << shift);
    uint32_t at[FLOATS];
    floats c[4];
    words word = WORDS_MOST(WORDS_OF_FLOATS(x), WORDS_ALL(row_0));
    word = WORDS_LEAST(word, WORDS_ALL(word_of_float(table->end) - 1));
    /* 16 bytes to a row */
    WORDS_STORE(at, WORDS_AND(WORDS_DOWN(WORDS_MINUS(word, WORDS_ALL(row_0)), shift - 4), WORDS_ALL(-16)));
    const words middle = WORDS_OR(WORDS_AND(word, WORDS_ALL(-(1 << shift))), WORDS_ALL(1 << (shift - 1)));
    const words node = WORDS_AND(middle, WORDS_ABOVE(word, WORDS_ALL(row_0 + (1 << shift) - 1)));
    const floats t = x - FLOATS_OF_WORDS(node); /* exact */
    floats_columns(c, table->rows, at);
    const floats remainder = FLOATS_OF_WORDS(WORDS_UP(WORDS_OF_FLOATS(c[3]), 16));
    const floats rest = remainder + t * (c[1] + t * (c[2] + t * c[3]));
    if (!table->product)
        return c[0] + rest;
    const floats head = FLOATS_OF_WORDS(WORDS_AND(WORDS_OF_FLOATS(x), WORDS_ALL(FLOAT_HEAD)));
    return head * c[0] + ((x - head) * c[0] + x * rest);
}

/* ---- arrays ---- */

enum { FLOAT_BLOCK = 256 };

COR_KERNEL int float_is_outside(const struct float_table *table, float x)
{
    const uint32_t word = (uint32_t)word_of_float(x);
    return word >= (uint32_t)word_of_float(table->end) || (table->product && word < (uint32_t)FLOAT_PRODUCT_LEAST);
}

/* Computes the function at each number, by blocks. `one` computes numbers outside the table. */
COR_KERNEL void floats_from_beta(const float *in, float *out, size_t n, const struct float_table *table,
                                 double (*one)(double))
{
    for (size_t i = 0, m; i < n; i += m) {
        float last[FLOATS], value[FLOAT_BLOCK];
        words outside = WORDS_ALL(0);
        m = n - i < FLOAT_BLOCK ? n - i : FLOAT_BLOCK;
        const size_t whole = m - m % FLOATS;
        for (size_t j = 0; j < whole; j += FLOATS) {
            const floats x = FLOATS_LOAD(in + i + j);
            outside = WORDS_OR(outside, float_outside(table, WORDS_OF_FLOATS(x)));
            FLOATS_STORE(value + j, float_values(table, x));
        }
        if (whole < m) { /* FLOAT_BLOCK is a multiple of FLOATS, so that value has room for a whole vector */
            for (size_t j = 0; j < FLOATS; j++)
                last[j] = in[i + (whole + j < m ? whole + j : whole)];
            const floats x = FLOATS_LOAD(last);
            outside = WORDS_OR(outside, float_outside(table, WORDS_OF_FLOATS(x)));
            FLOATS_STORE(value + whole, float_values(table, x));
        }
        if (WORDS_SIGNS(outside))
            for (size_t j = 0; j < m; j++)
                if (float_is_outside(table, in[i + j]))
                    value[j] = (float)one((double)in[i + j]);
        memcpy(out + i, value, m * sizeof *out);
    }
}

#endif
