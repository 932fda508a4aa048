/* SPDX-License-Identifier: MIT */
/* The table of generated/disk_limits.h and its evaluation, which corgen shares: 1 - eps^2 over the plane of x = v^(1/8)
 * and nu. The plane is divided into cells. A cell in which a polynomial is not accurate enough is divided into four,
 * repeatedly. A cell holds the values on a grid of 4 x 4 points, its corners included. The polynomial of degree 3 in x
 * and in nu through these values is evaluated. The grid in x is denser for faster disks: 0.002 and 0.2 are as far apart
 * as 2e-7 and 0.002.
 *
 * Cells of equal size have the same 4 points on their common side, so that their polynomials join. Where the cells
 * beyond a side are smaller, their polynomials replace the cell's on this side: the difference on the side is added,
 * times the weight of the side's points. The function is continuous.
 * */
#ifndef COR_RUNTIME_CORE_DISK_LIMIT_H
#define COR_RUNTIME_CORE_DISK_LIMIT_H

#include <math.h>
#include <stdint.h>

enum { COR_DISK_LIMIT_SIDE = 4, COR_DISK_LIMIT_POINTS = 16 };

/* Smaller than half the smallest cell beside any, in the cell's sides; corgen divides no root more than 8 times */
#define COR_DISK_LIMIT_BEYOND 0x1p-10

/* In units of COR_DISK_LIMIT_UNIT; value [4 j + i] is at place i of x and place j of nu. Bit across + 2 last of joined
 * is set if the cells beyond that side (cor_disk_limit_beyond) are smaller. */
#define COR_DISK_LIMIT_UNIT 1e-7
struct cor_disk_limit_cell {
    int32_t uncertainty, joined, value[COR_DISK_LIMIT_POINTS];
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

/* A cell, its first corner and its side in the coordinates of the plane, and a point in it, 0 to 1 */
struct cor_disk_limit_place {
    const struct cor_disk_limit_cell *cell;
    double x, nu, side, x_in, nu_in;
};

/* The cell that contains a point of the plane */
static inline struct cor_disk_limit_place cor_disk_limit_find_inside(const struct cor_disk_limit_table *table, double x,
                                                                     double nu)
{
    const int i = x < table->x_roots ? (int)x : table->x_roots - 1;
    const int j = nu < table->nu_roots ? (int)nu : table->nu_roots - 1;
    int number = table->node[j * table->x_roots + i];
    struct cor_disk_limit_place at = {NULL, i, j, 1, x - i, nu - j};
    while (number < 0) {
        const int right = at.x_in >= 0.5, upper = at.nu_in >= 0.5;
        at.side *= 0.5;
        at.x += right * at.side;
        at.nu += upper * at.side;
        at.x_in = 2 * at.x_in - right;
        at.nu_in = 2 * at.nu_in - upper;
        number = table->node[-number + 2 * upper + right];
    }
    at.cell = &table->cell[number];
    return at;
}

/* The same for any point. Points outside the plane are moved to its edge. */
static inline struct cor_disk_limit_place cor_disk_limit_find(const struct cor_disk_limit_table *table, double x,
                                                              double nu)
{
    return cor_disk_limit_find_inside(table, fmin(fmax(x, 0), table->x_roots), fmin(fmax(nu, 0), table->nu_roots));
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

/* The polynomial of degree 3 through four values that are `stride` apart */
static inline double cor_disk_limit_along(const int32_t *value, int stride, const double weight[COR_DISK_LIMIT_SIDE])
{
    return (weight[0] * value[0] + weight[3] * value[3 * stride]) +
           (weight[1] * value[stride] + weight[2] * value[2 * stride]);
}

/* The polynomial of a cell alone */
static inline double cor_disk_limit_value(const struct cor_disk_limit_cell *cell, double x_in, double nu_in)
{
    double x_weight[COR_DISK_LIMIT_SIDE], nu_weight[COR_DISK_LIMIT_SIDE], sum = 0;
    cor_disk_limit_weights(x_in, x_weight);
    cor_disk_limit_weights(nu_in, nu_weight);
    for (int j = 0; j < COR_DISK_LIMIT_SIDE; j++)
        sum += nu_weight[j] * cor_disk_limit_along(cell->value + COR_DISK_LIMIT_SIDE * j, 1, x_weight);
    return COR_DISK_LIMIT_UNIT * sum;
}

struct cor_disk_limit_result {
    double value, uncertainty;
};

/* The cell beyond the last (1) or first (0) value of nu, or of x (across), of a place; its `cell` is NULL outside the
 * plane. */
static inline struct cor_disk_limit_place cor_disk_limit_beyond(const struct cor_disk_limit_table *table,
                                                                const struct cor_disk_limit_place *at, int across,
                                                                int last)
{
    const double beyond = last ? 1 + COR_DISK_LIMIT_BEYOND : -COR_DISK_LIMIT_BEYOND;
    const double x = at->x + at->side * (across ? beyond : at->x_in);
    const double nu = at->nu + at->side * (across ? at->nu_in : beyond);
    if (x >= 0 && x <= table->x_roots && nu >= 0 && nu <= table->nu_roots)
        return cor_disk_limit_find_inside(table, x, nu);
    const struct cor_disk_limit_place outside = {NULL, x, nu, 1, 0, 0};
    return outside;
}

/* Joins a result to the smaller cells beyond one side of its cell. weight is that of this side's points. The
 * uncertainty goes over to a larger one beyond. */
static inline void cor_disk_limit_join(const struct cor_disk_limit_table *table, const struct cor_disk_limit_place *at,
                                       int across, int last, double weight, struct cor_disk_limit_result *result)
{
    enum { LAST = COR_DISK_LIMIT_SIDE - 1 };
    if (!(at->cell->joined >> (across + 2 * last) & 1))
        return;
    const struct cor_disk_limit_place other = cor_disk_limit_beyond(table, at, across, last);
    const int stride = across ? COR_DISK_LIMIT_SIDE : 1, apart = across ? LAST : LAST * COR_DISK_LIMIT_SIDE;
    double own_weight[COR_DISK_LIMIT_SIDE], other_weight[COR_DISK_LIMIT_SIDE];
    cor_disk_limit_weights(across ? at->nu_in : at->x_in, own_weight);
    cor_disk_limit_weights(across ? other.nu_in : other.x_in, other_weight);
    const double own = cor_disk_limit_along(at->cell->value + last * apart, stride, own_weight);
    const double others = cor_disk_limit_along(other.cell->value + !last * apart, stride, other_weight);
    const double larger = other.cell->uncertainty - at->cell->uncertainty;
    result->value += COR_DISK_LIMIT_UNIT * weight * (others - own);
    result->uncertainty =
        fmax(result->uncertainty, COR_DISK_LIMIT_UNIT * (at->cell->uncertainty + fabs(weight) * larger));
}

/* The value and its uncertainty at a point, in a cell that the caller found */
static inline struct cor_disk_limit_result cor_disk_limit_in(const struct cor_disk_limit_table *table,
                                                             const struct cor_disk_limit_place *at)
{
    double x_weight[COR_DISK_LIMIT_SIDE], nu_weight[COR_DISK_LIMIT_SIDE];
    cor_disk_limit_weights(at->x_in, x_weight);
    cor_disk_limit_weights(at->nu_in, nu_weight);
    struct cor_disk_limit_result result = {cor_disk_limit_value(at->cell, at->x_in, at->nu_in),
                                           COR_DISK_LIMIT_UNIT * at->cell->uncertainty};
    for (int last = 0; last < 2 && at->cell->joined; last++) {
        cor_disk_limit_join(table, at, 0, last, nu_weight[last * (COR_DISK_LIMIT_SIDE - 1)], &result);
        cor_disk_limit_join(table, at, 1, last, x_weight[last * (COR_DISK_LIMIT_SIDE - 1)], &result);
    }
    return result;
}

#endif
