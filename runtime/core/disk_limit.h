/* SPDX-License-Identifier: MIT */
/* Evaluates the table of generated/disk_limits.h: 1 - eps^2 as a function of x = v^(1/8) and nu. corgen uses this file,
 * too. The speeds 0.002 and 0.2 are about as far apart in x as 2e-7 and 0.002, so the grid is denser for faster disks.
 *
 * The plane is divided into cells. A cell in which a polynomial of degree 3 in x and in nu is not accurate enough is
 * divided into four, repeatedly. Near smaller cells the function of a cell blends into their functions
 * (docs/theory-disks.md, 17), so that 1 - eps^2 is continuous on the plane. corgen cuts such a cell into rectangles
 * ("pieces") in each of which the function is one polynomial. A call finds one piece and evaluates one polynomial. */
#ifndef COR_RUNTIME_CORE_DISK_LIMIT_H
#define COR_RUNTIME_CORE_DISK_LIMIT_H

#include "runtime/number/inline.h"

/* Sides of a square of the index (struct cor_disk_limit_table) and of a root, an undivided cell. The unit is the side
 * of the smallest piece */
enum { COR_DISK_LIMIT_SQUARE_BITS = 3, COR_DISK_LIMIT_PER_SQUARE = 8, COR_DISK_LIMIT_PER_ROOT = 16 };

/* Distance beyond a cell's edge at which its neighbour is looked up. The unit is the side of the cell. The distance is
 * below the side of every neighbour */
#define COR_DISK_LIMIT_BEYOND 0x1p-10

/* A piece. x, nu: the corner with the smallest coordinates in the plane. per_x, per_nu: inverse sides. coefficient[4 j
 * + i] multiplies s^i t^j, where s and t grow from 0 to 1 across the piece in x and nu. uncertainty: the value of the
 * cell that contains the piece. depth: number of divisions from a root to this cell. Coefficients and uncertainty are
 * in units of COR_DISK_LIMIT_UNIT. */
#define COR_DISK_LIMIT_UNIT 1e-7
enum { COR_DISK_LIMIT_SIDE = 4, COR_DISK_LIMIT_POINTS = 16 };
struct cor_disk_limit_piece {
    double x, nu;
    float per_x, per_nu;
    uint16_t uncertainty, depth;
    double coefficient[COR_DISK_LIMIT_POINTS];
};

struct cor_disk_limit_table {
    int x_roots, nu_roots;
    double x_first, x_step, nu_first, nu_step;
    /* A root has 2 x 2 squares. A square is cut evenly into 2^a by 2^b places. square[i] is 16 times the index of its
     * first place, plus 4 b, plus a. place[i] is the index of its piece. In both arrays x varies fastest. */
    const uint16_t *square, *place;
    const struct cor_disk_limit_piece *piece;
};

/* Return the coordinates of a point of the plane, 0 to x_roots and 0 to nu_roots. The unit is the side of a root. */
COR_INLINE double cor_disk_limit_x(const struct cor_disk_limit_table *table, double speed)
{
    return (sqrt(sqrt(sqrt(speed))) - table->x_first) * (1 / table->x_step);
}

COR_INLINE double cor_disk_limit_nu(const struct cor_disk_limit_table *table, double nu)
{
    return (nu - table->nu_first) * (1 / table->nu_step);
}

/* Returns the piece that contains a point of the plane. Rounding may have put the point just outside the plane. */
COR_INLINE const struct cor_disk_limit_piece *cor_disk_limit_find(const struct cor_disk_limit_table *table, double x,
                                                                  double nu)
{
    enum { BITS = COR_DISK_LIMIT_SQUARE_BITS, IN_SQUARE = COR_DISK_LIMIT_PER_SQUARE - 1 };
    const int x_last = table->x_roots * COR_DISK_LIMIT_PER_ROOT - 1,
              nu_last = table->nu_roots * COR_DISK_LIMIT_PER_ROOT - 1;
    int i = (int)(x * COR_DISK_LIMIT_PER_ROOT), j = (int)(nu * COR_DISK_LIMIT_PER_ROOT);
    i = i < x_last ? i : x_last;
    j = j < nu_last ? j : nu_last;
    const int square = table->square[(j >> BITS) * ((x_last + 1) >> BITS) + (i >> BITS)];
    const int x_bits = square & 3, nu_bits = square >> 2 & 3;
    const int column = (i & IN_SQUARE) >> (BITS - x_bits), row = (j & IN_SQUARE) >> (BITS - nu_bits);
    return &table->piece[table->place[(square >> 4) + (row << x_bits) + column]];
}

COR_INLINE double cor_disk_limit_value(const struct cor_disk_limit_piece *piece, double x, double nu)
{
    const double s = (x - piece->x) * (double)piece->per_x, t = (nu - piece->nu) * (double)piece->per_nu;
    const double *const c = piece->coefficient;
    double of_s[COR_DISK_LIMIT_SIDE];
    for (int i = 0; i < COR_DISK_LIMIT_SIDE; i++)
        of_s[i] = (c[i] + t * c[4 + i]) + t * t * (c[8 + i] + t * c[12 + i]);
    return COR_DISK_LIMIT_UNIT * ((of_s[0] + s * of_s[1]) + s * s * (of_s[2] + s * of_s[3]));
}

/* Returns the weight of the first of four values at 0, 1/3, 2/3, 1 in the polynomial through them. */
COR_INLINE double cor_disk_limit_weight(double t)
{
    return (1 - t) * (1 - 3 * t) * (1 - 1.5 * t);
}

/* Returns the uncertainty at a point. It increases from the cell's value to the larger value of a finer neighbour. */
COR_INLINE double cor_disk_limit_uncertainty(const struct cor_disk_limit_table *table, double x, double nu)
{
    const struct cor_disk_limit_piece *const own = cor_disk_limit_find(table, x, nu);
    const double side = ldexp(1, -own->depth), at[2] = {x, nu}, end[2] = {table->x_roots, table->nu_roots};
    const double first[2] = {side * floor(own->x / side), side * floor(own->nu / side)};
    double uncertainty = own->uncertainty;
    for (int across = 0; across < 2; across++)
        for (int last = 0; last < 2; last++) {
            double beyond[2] = {x, nu};
            beyond[across] = first[across] + side * (last ? 1 + COR_DISK_LIMIT_BEYOND : -COR_DISK_LIMIT_BEYOND);
            if (beyond[across] < 0 || beyond[across] > end[across])
                continue;
            const struct cor_disk_limit_piece *const other = cor_disk_limit_find(table, beyond[0], beyond[1]);
            const double from = (at[across] - first[across]) / side;
            const double weight = fabs(cor_disk_limit_weight(last ? 1 - from : from));
            if (other->depth > own->depth)
                uncertainty = fmax(uncertainty, own->uncertainty + weight * (other->uncertainty - own->uncertainty));
        }
    return COR_DISK_LIMIT_UNIT * uncertainty;
}

#endif
