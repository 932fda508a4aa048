/* SPDX-License-Identifier: MIT */
/* Tables of short polynomials on a grid, for any function. These functions find the row of a number and evaluate it.
 *
 * Macros COR_ROWS_NAME_FIRST, _STEP, ... give the geometry of a generated table cor_rows_NAME(i); docs/internals.md
 * describes the form. The functions below take the geometry as a struct, COR_INLINE_GRID(COR_ROWS_NAME), whose fields a
 * compiler turns into constants. */
#ifndef COR_RUNTIME_ROW_H
#define COR_RUNTIME_ROW_H

#include "runtime/number/pair.h"

/* A row of degree 10 without its first coefficient c_0,
 *
 *     c_0' + s (c_1 + c_2 t + ... + c_10 t^9),     columns c[1] to c[11]
 *
 * The first macro is for s = t, the second for an s that is known later than t. Each pair of terms has its own power of
 * t, which is ready before the coefficients are loaded. Seven dependent operations follow the load, nine in the second
 * macro; Horner's rule has twenty. Both are macros because the array functions pass vectors. pN is t^N.
 *
 * Rounding error: the row is at most a few percent of c_0 + row (docs/accuracy.md) and has a relative rounding error of
 * about 3 2^-53. The row therefore contributes a tenth of a unit of the last place of the sum. The final addition
 * contributes half a unit. */
#define COR_INLINE_ROW(c, t, p2, p4, p6, p8, p10)                                                                      \
    ((((c)[1] + (t) * (c)[2]) + (p10) * (c)[11]) +                                                                     \
     (((p2) * ((c)[3] + (c)[4] * (t)) + (p4) * ((c)[5] + (c)[6] * (t))) +                                              \
      ((p6) * ((c)[7] + (c)[8] * (t)) + (p8) * ((c)[9] + (c)[10] * (t)))))
#define COR_INLINE_ROW_TIMES_S(c, s, t, p2, p4, p6, p8)                                                                \
    ((c)[1] +                                                                                                          \
     (s) * ((((c)[2] + (c)[3] * (t)) + (p8) * ((c)[10] + (c)[11] * (t))) +                                             \
            ((p2) * ((c)[4] + (c)[5] * (t)) + ((p4) * ((c)[6] + (c)[7] * (t)) + (p6) * ((c)[8] + (c)[9] * (t))))))
#define COR_INLINE_COLUMNS 12

/* The place of a number in a table: its row and the row's variables */
struct cor_inline_place {
    const double *row;
    double s, t;
    int has_s; /* 0 if s = t; callers pass a constant, which compilers propagate */
};

COR_INLINE double cor_inline_row(struct cor_inline_place place)
{
    const double *const c = place.row;
    const double t = place.t, p2 = t * t, p4 = p2 * p2, p6 = p4 * p2, p8 = p4 * p4;
    return place.has_s ? COR_INLINE_KEEP(COR_INLINE_ROW_TIMES_S(c, place.s, t, p2, p4, p6, p8))
                       : COR_INLINE_KEEP(COR_INLINE_ROW(c, t, p2, p4, p6, p8, p6 * p4));
}

/* Returns c_0 + row. */
COR_INLINE double cor_inline_row_value(struct cor_inline_place place)
{
    return place.row[0] + cor_inline_row(place);
}

/* Returns m (c_0 + row) for m >= 2^-900 and rows whose c_0 has at most 26 bits. m is split into two parts. Their
 * products with c_0 are exact, so the final addition causes nearly all of the rounding error. */
COR_INLINE double cor_inline_row_product(struct cor_inline_place place, double m)
{
    const double head = cor_inline_head(m), tail = m - head;
    return COR_INLINE_KEEP(head * place.row[0]) + (tail * place.row[0] + m * cor_inline_row(place));
}

COR_INLINE struct cor_inline_place cor_inline_place_of(const double *row, double t)
{
    struct cor_inline_place place;
    place.row = row;
    place.s = place.t = t;
    place.has_s = 0;
    return place;
}

/* ---- uniform grids: node i = first + i step ---- */

struct cor_inline_grid {
    double first, step, per_unit; /* per_unit = 1/step; all three have few bits, so that products with i are exact */
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

/* Returns the row whose node is nearest to y. */
COR_INLINE int cor_inline_grid_row(struct cor_inline_grid grid, double y)
{
    return (int)((y - grid.first) * grid.per_unit + 0.5);
}

/* Returns node i. The branch avoids the addition of a first node of 0, which compilers may not omit: 0 + -0 is 0. */
COR_INLINE double cor_inline_grid_node(struct cor_inline_grid grid, int i)
{
    return grid.first == 0 ? i * grid.step : grid.first + i * grid.step;
}

/* Returns y - node i. The result is exact: y and its node are multiples of the last place of y or of the result. */
COR_INLINE double cor_inline_grid_t(struct cor_inline_grid grid, double y, int i)
{
    return (y - grid.first) - i * grid.step;
}

COR_INLINE struct cor_inline_place cor_inline_grid_place(struct cor_inline_grid grid, double y,
                                                         const double *(*rows)(int))
{
    const int i = cor_inline_grid_row(grid, y);
    return cor_inline_place_of(rows(i), cor_inline_grid_t(grid, y, i));
}

/* Returns the place of z = sqrt(x). From row `plain` onward, s is x - node^2, which is exact. t has the rounding error
 * of the root; c_1 t would add this error to the row. */
COR_INLINE struct cor_inline_place cor_inline_grid_place_of_root(struct cor_inline_grid grid, int plain, double x,
                                                                 const double *(*rows)(int))
{
    const double z = sqrt(x);
    const int i = cor_inline_grid_row(grid, z);
    const double node = cor_inline_grid_node(grid, i);
    struct cor_inline_place place = cor_inline_place_of(rows(i), z - node);
    place.s = cor_inline_choose(i < plain, place.t, x - node * node);
    place.has_s = 1;
    return place;
}

/* ---- grids by octaves: every octave 2^k <= x < 2^(k+1) has the same cells, with the nodes in their middle ---- */

struct cor_inline_octaves {
    double first; /* a power of two */
    int bits;     /* 2^bits cells to an octave */
};

COR_INLINE struct cor_inline_octaves cor_inline_octaves_of(double first, int bits)
{
    struct cor_inline_octaves grid;
    grid.first = first;
    grid.bits = bits;
    return grid;
}
#define COR_INLINE_OCTAVES(table) cor_inline_octaves_of(table##_FIRST, table##_OCTAVE_BITS)

/* Returns the row of x: the number of cells between first and x. The bits of x, read as an integer, increase by the
 * same amount from cell to cell. */
COR_INLINE uint64_t cor_inline_octaves_row(struct cor_inline_octaves grid, double x)
{
    return (cor_inline_bits(x) - cor_inline_bits(grid.first)) >> (52 - grid.bits);
}

/* Returns x 2^-k minus the node of its cell, where 1 <= x 2^-k < 2. The result is exact. */
COR_INLINE double cor_inline_octaves_t(struct cor_inline_octaves grid, double x)
{
    const uint64_t one = UINT64_C(0x3ff0000000000000), half_cell = UINT64_C(1) << (51 - grid.bits);
    const uint64_t fraction = cor_inline_bits(x) & UINT64_C(0xfffffffffffff);
    const uint64_t node = (fraction & ~(2 * half_cell - 1)) | half_cell;
    return cor_inline_from_bits(fraction | one) - cor_inline_from_bits(node | one);
}

COR_INLINE struct cor_inline_place cor_inline_octaves_place(struct cor_inline_octaves grid, double x,
                                                            const double *(*rows)(int))
{
    return cor_inline_place_of(rows((int)cor_inline_octaves_row(grid, x)), cor_inline_octaves_t(grid, x));
}

#endif
