/* SPDX-License-Identifier: MIT */
/* Fig. 8: 1 - eps^2 of the hard wall against 1/sqrt(N), extrapolated to all modes. */
#include <math.h>

#include "collisions.h"
#include "limit.h"
#include "report.h"
#include "rigid.h"

static int write_mode_limit(FILE *csv, char verdict[VERDICT_SIZE])
{
    double apart = 0, few_off = 0, many_off = 0;
    int fewer_leave_less = 0, pairs = 0;
    fputs("speed", csv);
    for (int n = 0; n < SIZES; n++)
        fprintf(csv, ",modes_%d", size[n]);
    fputs(",limit_300_to_940,slope_300_to_940,limit_940_to_1800,slope_940_to_1800,uncertainty,all_modes\n", csv);
    for (int i = 0; i < PAPER_SPEEDS; i++) {
        const double v = paper_speed(i);
        const struct line few = size_line(0.33, v, 0, WALL_SIZE), many = size_line(0.33, v, LARGE_FROM, SIZES - 1);
        fprintf(csv, "%g", v);
        for (int n = 0; n < SIZES; n++)
            fprintf(csv, ",%.6f", wall_line(0.33, size[n], v, 0, WALLS - 1).at_zero);
        const double all = rigid_wall(0.33, v, RIGID_TOLERANCE).one_minus_eps2;
        fprintf(csv, ",%.6f,%.5g,%.6f,%.5g,%.6f,%.5f\n", few.at_zero, few.slope, many.at_zero, many.slope,
                limit_of(0.33, v).uncertainty, all);
        few_off = fmax(few_off, fabs(few.at_zero - all));
        many_off = fmax(many_off, fabs(many.at_zero - all));
        apart = fmax(apart, fabs(few.at_zero - many.at_zero));
        for (int n = 1; v >= 0.02 && n < SIZES; n++, pairs++)
            fewer_leave_less += wall_line(0.33, size[n - 1], v, 0, WALLS - 1).at_zero <
                                wall_line(0.33, size[n], v, 0, WALLS - 1).at_zero;
    }
    const double slow = 0.02, fast = 0.3;
    snprintf(verdict, VERDICT_SIZE,
             "Agrees: from v = 0.02 on more modes leave eps closer to one. %d of the %d steps from one N to the "
             "next go the other way. 1 - eps^2 is about a straight line in 1/sqrt(N), and a faster collision needs "
             "more modes to reach the line. The slope of N = 300 to 940 is %.2f of that of N = 940 to 1800 at v = "
             "%g, %.2f at %g. Hence the limits of the paper's four N and of N = 940 to 1800 differ by up to %.4f. "
             "From the computed limit of all modes (dots) they differ by up to %.4f and %.4f. Does not agree at the "
             "smallest speed: at v = 0.005 N = 300 leaves %.4f, 600 %.4f and 1800 %.4f. Few modes make a disk that "
             "is stiff where the contact is small.",
             fewer_leave_less, pairs,
             size_line(0.33, slow, 0, WALL_SIZE).slope / size_line(0.33, slow, LARGE_FROM, SIZES - 1).slope, slow,
             size_line(0.33, fast, 0, WALL_SIZE).slope / size_line(0.33, fast, LARGE_FROM, SIZES - 1).slope, fast,
             apart, few_off, many_off, wall_line(0.33, 300, 0.005, 0, WALLS - 1).at_zero,
             wall_line(0.33, 600, 0.005, 0, WALLS - 1).at_zero, wall_line(0.33, 1800, 0.005, 0, WALLS - 1).at_zero);
    return 1;
}

const struct figure mode_limit_figure = {"mode_limit", "Fig. 8", "extrapolation to all modes", write_mode_limit};
