/* SPDX-License-Identifier: MIT */
/* The two extrapolations of the paper's section 4, from the table of collisions: 1 - eps^2 is a straight line in
 * 1/alpha, once the wall is hard, and then in 1/sqrt(N). */
#ifndef COR_PAPER_LIMIT_H
#define COR_PAPER_LIMIT_H

struct line {
    double at_zero, slope;
};

/* 1 - eps^2 against 1/alpha for so many modes, through the walls wall[from] to wall[to]. at_zero NaN where a collision
 * is missing, here and below. */
struct line wall_line(double nu, int modes, double speed, int from, int to);

/* Its value at alpha = inf against 1/sqrt(N), through size[from] to size[to]. */
struct line size_line(double nu, double speed, int from, int to);

/* Both limits, the second from N = 940 on. uncertainty: the largest difference from what fewer or other points give,
 * each line without its first point and without its last, and the paper's N = 300 to 940 where there are such. */
struct limit {
    double one_minus_eps2, uncertainty;
};
struct limit limit_of(double nu, double speed);

#endif
