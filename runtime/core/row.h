/* SPDX-License-Identifier: MIT */
/* Rows of short polynomials on a grid, whatever function they hold: where a number falls, and the row's value there.
 *
 * A generated table cor_rows_NAME(i) comes with its geometry in macros COR_ROWS_NAME_FIRST, _STEP, ... (form:
 * docs/header-format.md). The functions below take it as a struct, COR_INLINE_GRID(COR_ROWS_NAME); a compiler makes
 * constants of it. */
#ifndef COR_RUNTIME_ROW_H
#define COR_RUNTIME_ROW_H

#include "runtime/core/exact.h"

/* A row of degree 10 without its first coefficient c_0: c_0' + s (c_1 + c_2 t + ... + c_10 t^9), in columns c[1] to
 * c[11]. By Estrin's scheme: five products deep in t where Horner's rule has ten. An expression, because the array
 * functions put vectors in it.
 *
 * Rounding error: |s (c_1 + ...)| is at most a few percent of c_0, so its relative rounding error, some 3 2^-53, is a
 * tenth of a unit of the last place of c_0 + row, whose own rounding is at most half a unit. */
#define COR_INLINE_ROW(c, s, t, t2, t4)                                                                                \
    ((c)[1] + (s) * (((((c)[2] + (c)[3] * (t)) + ((c)[4] + (c)[5] * (t)) * (t2)) +                                     \
                      (((c)[6] + (c)[7] * (t)) + ((c)[8] + (c)[9] * (t)) * (t2)) * (t4)) +                             \
                     ((c)[10] + (c)[11] * (t)) * ((t4) * (t4))))
#define COR_INLINE_COLUMNS 12

COR_INLINE double cor_inline_row(const double *c, double s, double t)
{
    const double t2 = t * t, t4 = t2 * t2;
    return COR_INLINE_ROW(c, s, t, t2, t4);
}

/* ---- uniform grids: node i = first + i step ---- */

struct cor_inline_grid {
    double first, step, per_unit; /* per_unit = 1/step; all three short, so that products with i are exact */
};

COR_INLINE struct cor_inline_grid cor_inline_grid_of(double first, double step, double per_unit)
{
    struct cor_inline_grid grid;
    grid.first = first;
    grid.step = step;
    grid.per_unit = per_unit;
    return grid;
}
#define COR_INLINE_GRID(table) cor_inline_grid_of(table##_FIRST, table##_STEP, table##_PER_UNIT)

/* The row whose node is nearest to y */
COR_INLINE int cor_inline_grid_row(struct cor_inline_grid grid, double y)
{
    return (int)((y - grid.first) * grid.per_unit + 0.5);
}

/* y - node i. Exact: y and its node are multiples of the last place of y, or of the difference. */
COR_INLINE double cor_inline_grid_t(struct cor_inline_grid grid, double y, int i)
{
    return (y - grid.first) - i * grid.step;
}

/* ---- grids by octaves: the same cells in every octave 2^k <= x < 2^(k+1), nodes in their middle ---- */

struct cor_inline_octaves {
    int first, bits; /* the first k; 2^bits cells to an octave */
};

COR_INLINE struct cor_inline_octaves cor_inline_octaves_of(int first, int bits)
{
    struct cor_inline_octaves grid;
    grid.first = first;
    grid.bits = bits;
    return grid;
}
#define COR_INLINE_OCTAVES(table) cor_inline_octaves_of(table##_FIRST_OCTAVE, table##_OCTAVE_BITS)

/* The row of x: its exponent and the leading bits of its fraction are the index. x >= 2^first */
COR_INLINE uint64_t cor_inline_octaves_row(struct cor_inline_octaves grid, double x)
{
    const int bias = 1023, fraction_bits = 52;
    return (cor_inline_bits(x) >> (fraction_bits - grid.bits)) - ((uint64_t)(bias + grid.first) << grid.bits);
}

/* x 2^-k, 1 <= x 2^-k < 2, less the node of its cell. Exact. */
COR_INLINE double cor_inline_octaves_t(struct cor_inline_octaves grid, double x)
{
    const uint64_t one = UINT64_C(0x3ff0000000000000), half_cell = UINT64_C(1) << (51 - grid.bits);
    const uint64_t fraction = cor_inline_bits(x) & UINT64_C(0xfffffffffffff);
    const uint64_t node = (fraction & ~(2 * half_cell - 1)) | half_cell;
    return cor_inline_from_bits(fraction | one) - cor_inline_from_bits(node | one);
}

#endif
