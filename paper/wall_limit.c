/* SPDX-License-Identifier: MIT */
/* Fig. 7: 1 - eps^2 against 1/alpha, extrapolated to the hard wall, with 940 modes. */
#include <math.h>

#include "collisions.h"
#include "limit.h"
#include "report.h"
#include "rigid.h"

static int write_wall_limit(FILE *csv, char verdict[VERDICT_SIZE])
{
    double on_line = 0, soft = 0, hard = 0, above = -INFINITY, below = INFINITY;
    fputs("speed,modes,limit,slope,all_modes\n", csv);
    for (int i = 0; i < PAPER_SPEEDS; i++) {
        const double v = paper_speed(i);
        const struct line line = wall_line(0.33, size[WALL_SIZE], v, 0, WALLS - 1);
        const double all = rigid_wall(0.33, v, RIGID_TOLERANCE).one_minus_eps2;
        fprintf(csv, "%g,%d,%.6f,%.5g,%.5f\n", v, size[WALL_SIZE], line.at_zero, line.slope, all);
        above = fmax(above, line.at_zero / all - 1);
        below = fmin(below, line.at_zero / all - 1);
        for (int k = 0; k < WALLS + OTHER_WALLS; k++) {
            const double rate = k < WALLS ? wall[k] : other_wall[k - WALLS];
            const struct collision *c = collision_find(0.33, size[WALL_SIZE], rate, v);
            if (c == NULL) /* a wall too soft or too hard */
                continue;
            const double off = fabs(c->one_minus_eps2 - line.at_zero - line.slope / c->alpha) / line.at_zero;
            double *largest = k < WALLS ? &on_line : rate < wall[0] ? &soft : &hard;
            *largest = fmax(*largest, off);
        }
    }
    snprintf(verdict, VERDICT_SIZE,
             "Agrees: 1 - eps^2 grows with alpha and is a straight line in 1/alpha, once alpha v is 25. From there to "
             "100, where the lines are drawn through, no point is off by more than %.2f %% of the limit. Softer walls, "
             "down to alpha v = 10, are off by up to %.1f %%. At alpha v = 200, still harder, points are off by up to "
             "%.1f %%: %d modes cannot follow such a wall. Its limit has to be taken before it. The walls are scaled "
             "with the speed, alpha v = 10 to 200, because the paper does not say which were taken. Dots are the limit "
             "of all modes at a rigid wall. The lines end between %+.1f %% and %+.1f %% from it.",
             100 * on_line, 100 * soft, 100 * hard, size[WALL_SIZE], 100 * below, 100 * above);
    return 1;
}

const struct figure wall_limit_figure = {"wall_limit", "Fig. 7", "extrapolation to the hard wall", write_wall_limit};
