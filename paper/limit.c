/* SPDX-License-Identifier: MIT */
#include "limit.h"

#include <math.h>

#include "collisions.h"

/* The regression line, of n >= 2 points */
static struct line fit_line(const double *x, const double *y, int n)
{
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (int i = 0; i < n; i++) {
        mean_x += x[i] / n;
        mean_y += y[i] / n;
    }
    for (int i = 0; i < n; i++) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    return (struct line){mean_y - xy / xx * mean_x, xy / xx};
}

struct line wall_line(double nu, int modes, double speed, int from, int to)
{
    double x[WALLS], y[WALLS];
    int n = 0;
    for (int k = from; k <= to; k++, n++) {
        const struct collision *c = collision_find(nu, modes, wall[k], speed);
        if (c == NULL)
            return (struct line){NAN, NAN};
        x[n] = 1 / c->alpha;
        y[n] = c->one_minus_eps2;
    }
    return fit_line(x, y, n);
}

static struct line line_of_walls(double nu, double speed, int from, int to, int first_wall, int last_wall)
{
    double x[SIZES], y[SIZES];
    for (int n = from; n <= to; n++) {
        x[n - from] = 1 / sqrt(size[n]);
        y[n - from] = wall_line(nu, size[n], speed, first_wall, last_wall).at_zero;
    }
    return fit_line(x, y, to - from + 1);
}

struct line size_line(double nu, double speed, int from, int to)
{
    return line_of_walls(nu, speed, from, to, 0, WALLS - 1);
}

struct limit limit_of(double nu, double speed)
{
    const int last = SIZES - 1;
    const double best = size_line(nu, speed, LARGE_FROM, last).at_zero;
    const double other[] = {
        size_line(nu, speed, LARGE_FROM, last - 1).at_zero, size_line(nu, speed, LARGE_FROM + 1, last).at_zero,
        line_of_walls(nu, speed, LARGE_FROM, last, 0, WALLS - 2).at_zero,
        line_of_walls(nu, speed, LARGE_FROM, last, 1, WALLS - 1).at_zero, size_line(nu, speed, 0, WALL_SIZE).at_zero};
    double uncertainty = 0;
    for (int i = 0; i < (int)(sizeof other / sizeof *other); i++)
        if (!isnan(other[i]))
            uncertainty = fmax(uncertainty, fabs(other[i] - best));
    return (struct limit){best, uncertainty};
}
