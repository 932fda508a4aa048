/* SPDX-License-Identifier: MIT */
/* The table of generated/disk_limits.h and its evaluation, which corgen shares: 1 - eps^2 over the plane of x = v^(1/8)
 * and nu. The plane is divided into cells. A cell in which a polynomial is not accurate enough is divided into four,
 * repeatedly. A cell holds the values on a grid of 4 x 4 points, its corners included. The polynomial of degree 3 in x
 * and in nu through these values is evaluated. The grid in x is denser for faster disks: 0.002 and 0.2 are as far apart
 * as 2e-7 and 0.002.
 *
 * Cells of equal size have the same 4 points on their common side, so that their polynomials join. A point that lies on
 * a side of a larger cell has the value of that cell's polynomial. The function is continuous. */
#ifndef COR_RUNTIME_CORE_DISK_LIMIT_H
#define COR_RUNTIME_CORE_DISK_LIMIT_H

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { COR_DISK_LIMIT_SIDE = 4, COR_DISK_LIMIT_POINTS = 16 };

/* x and nu of the first corner in squares, 1/side, and uncertainty and values in units of COR_DISK_LIMIT_UNIT; value [4
 * j + i] is at place i of x and place j of nu. */
#define COR_DISK_LIMIT_UNIT 1e-7
struct cor_disk_limit_cell {
    double x, nu, per_side, uncertainty, value[COR_DISK_LIMIT_POINTS];
};

struct cor_disk_limit_table {
    int x_squares, nu_squares;
    double x_first, x_step, nu_first, nu_step;
    /* squares of the plane, x fastest, and the quarters of squares. A node is the number of the cell that contains it,
     * or minus the place of the first of its four quarters. */
    const int16_t *node;
    const struct cor_disk_limit_cell *cell;
};

/* Coordinates in the plane, in squares */
static inline double cor_disk_limit_x(const struct cor_disk_limit_table *table, double speed)
{
    return (sqrt(sqrt(sqrt(speed))) - table->x_first) * (1 / table->x_step);
}

static inline double cor_disk_limit_nu(const struct cor_disk_limit_table *table, double nu)
{
    return (nu - table->nu_first) * (1 / table->nu_step);
}

/* The cell that contains a point of the plane, or a point that rounding has put beside it */
static inline const struct cor_disk_limit_cell *cor_disk_limit_find(const struct cor_disk_limit_table *table, double x,
                                                                    double nu)
{
    const int i = x < table->x_squares ? (int)x : table->x_squares - 1;
    const int j = nu < table->nu_squares ? (int)nu : table->nu_squares - 1;
    int number = table->node[j * table->x_squares + i];
    for (double x_in = x - i, nu_in = nu - j; number < 0;) {
        const int right = x_in >= 0.5, upper = nu_in >= 0.5;
        x_in = 2 * x_in - right;
        nu_in = 2 * nu_in - upper;
        number = table->node[-number + 2 * upper + right];
    }
    return &table->cell[number];
}

/* Weights of Lagrange's interpolation at t from the points 0, 1/3, 2/3, 1, as an initialiser; t may be a vector. */
#define COR_DISK_LIMIT_WEIGHTS(t)                                                                                      \
    {                                                                                                                  \
        (3 * (t)-1) * (3 * (t)-2) * (1.0 / -6) * (3 * (t)-3), 3 * (t) * (3 * (t)-3) * 0.5 * (3 * (t)-2),               \
            3 * (t) * (3 * (t)-3) * -0.5 * (3 * (t)-1), (3 * (t)-1) * (3 * (t)-2) * (1.0 / 6) * (3 * (t))              \
    }

/* The polynomial of a cell. gcc and clang multiply and add two numbers at once: the weights of x and nu, or two values
 * of a row. */
static inline double cor_disk_limit_value(const struct cor_disk_limit_cell *cell, double x, double nu)
{
    const double x_in = (x - cell->x) * cell->per_side, nu_in = (nu - cell->nu) * cell->per_side;
#ifdef __GNUC__
    typedef double two __attribute__((vector_size(16)));
    const two t = {x_in, nu_in}, w[COR_DISK_LIMIT_SIDE] = COR_DISK_LIMIT_WEIGHTS(t);
    two value[COR_DISK_LIMIT_POINTS / 2], sum[2];
    memcpy(value, cell->value, sizeof value);
    for (int i = 0; i < 2; i++)
        sum[i] = (w[0][1] * value[i] + w[3][1] * value[6 + i]) + (w[1][1] * value[2 + i] + w[2][1] * value[4 + i]);
    const two first = {w[0][0], w[1][0]}, last = {w[2][0], w[3][0]}, all = first * sum[0] + last * sum[1];
#else
    const double w_x[COR_DISK_LIMIT_SIDE] = COR_DISK_LIMIT_WEIGHTS(x_in),
                 w_nu[COR_DISK_LIMIT_SIDE] = COR_DISK_LIMIT_WEIGHTS(nu_in), *const value = cell->value;
    double sum[COR_DISK_LIMIT_SIDE], all[2];
    for (int i = 0; i < COR_DISK_LIMIT_SIDE; i++)
        sum[i] = (w_nu[0] * value[i] + w_nu[3] * value[12 + i]) + (w_nu[1] * value[4 + i] + w_nu[2] * value[8 + i]);
    for (int i = 0; i < 2; i++)
        all[i] = w_x[i] * sum[i] + w_x[i + 2] * sum[i + 2];
#endif
    return COR_DISK_LIMIT_UNIT * (all[0] + all[1]);
}

#endif
