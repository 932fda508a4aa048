/* SPDX-License-Identifier: MIT */
/* The table of generated/disk_limits.h and its evaluation, which corgen shares: 1 - eps^2 over the plane of x = v^(1/8)
 * and nu. The plane is divided into cells. A cell in which a polynomial is not accurate enough is divided into four,
 * repeatedly. A cell holds the values on a grid of 4 x 4 points, its corners included. The polynomial of degree 3 in x
 * and in nu through these values is evaluated. The grid in x is denser for faster disks: 0.002 and 0.2 are as far apart
 * as 2e-7 and 0.002.
 * */
#ifndef COR_RUNTIME_CORE_DISK_LIMIT_H
#define COR_RUNTIME_CORE_DISK_LIMIT_H

#include <math.h>
#include <stdint.h>

enum { COR_DISK_LIMIT_SIDE = 4, COR_DISK_LIMIT_POINTS = 16 };

/* In units of COR_DISK_LIMIT_UNIT; value [4 j + i] is at place i of x and place j of nu. */
#define COR_DISK_LIMIT_UNIT 1e-7
struct cor_disk_limit_cell {
    int32_t uncertainty, value[COR_DISK_LIMIT_POINTS];
};

struct cor_disk_limit_table {
    int x_roots, nu_roots; /* number of cells before any division */
    double x_first, x_step, nu_first, nu_step;
    /* nodes of the undivided plane, x fastest, and of the quarters of cells. A node is the number of a cell, or minus
     * the place of the first of its four quarters. */
    const int16_t *node;
    const struct cor_disk_limit_cell *cell;
};

/* Coordinates in the plane: 0 to x_roots and 0 to nu_roots */
static inline double cor_disk_limit_x(const struct cor_disk_limit_table *table, double speed)
{
    return (sqrt(sqrt(sqrt(speed))) - table->x_first) / table->x_step;
}

static inline double cor_disk_limit_nu(const struct cor_disk_limit_table *table, double nu)
{
    return (nu - table->nu_first) / table->nu_step;
}

/* The cell that contains a point, and the coordinates in the cell, 0 to 1. Points outside the plane are moved to its
 * edge. */
static inline const struct cor_disk_limit_cell *cor_disk_limit_find(const struct cor_disk_limit_table *table, double x,
                                                                    double nu, double *x_in, double *nu_in)
{
    const double x_at = fmin(fmax(x, 0), table->x_roots), nu_at = fmin(fmax(nu, 0), table->nu_roots);
    const int i = x_at < table->x_roots ? (int)x_at : table->x_roots - 1;
    const int j = nu_at < table->nu_roots ? (int)nu_at : table->nu_roots - 1;
    int number = table->node[j * table->x_roots + i];
    *x_in = x_at - i;
    *nu_in = nu_at - j;
    while (number < 0) {
        const int right = *x_in >= 0.5, upper = *nu_in >= 0.5;
        *x_in = 2 * *x_in - right;
        *nu_in = 2 * *nu_in - upper;
        number = table->node[-number + 2 * upper + right];
    }
    return &table->cell[number];
}

/* Weights of Lagrange's interpolation at t from the points 0, 1/3, 2/3, 1 */
static inline void cor_disk_limit_weights(double t, double weight[COR_DISK_LIMIT_SIDE])
{
    const double a = 3 * t, b = a - 1, c = a - 2, d = a - 3;
    weight[0] = b * c * d / -6;
    weight[1] = a * c * d / 2;
    weight[2] = a * b * d / -2;
    weight[3] = a * b * c / 6;
}

static inline double cor_disk_limit_value(const struct cor_disk_limit_cell *cell, double x_in, double nu_in)
{
    double x_weight[COR_DISK_LIMIT_SIDE], nu_weight[COR_DISK_LIMIT_SIDE], sum = 0;
    cor_disk_limit_weights(x_in, x_weight);
    cor_disk_limit_weights(nu_in, nu_weight);
    for (int j = 0; j < COR_DISK_LIMIT_SIDE; j++) {
        const int32_t *const value = cell->value + COR_DISK_LIMIT_SIDE * j;
        sum += nu_weight[j] *
               ((x_weight[0] * value[0] + x_weight[3] * value[3]) + (x_weight[1] * value[1] + x_weight[2] * value[2]));
    }
    return COR_DISK_LIMIT_UNIT * sum;
}

#endif
