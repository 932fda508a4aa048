/* SPDX-License-Identifier: MIT */
/* Solutions of scalar equations dy/dx = f(x, y) along straight paths in the complex plane, enclosed for all ends,
 * coefficients and initial values in balls at once.
 *
 * A step replaces the solution by a straight line. The residual of the line, for all values in the ball, and Gronwall's
 * inequality bound the distance to every exact solution. The steps add a few per cent to the radii of the balls, which
 * is accurate enough for a bound of the modulus. */
#ifndef COR_GEN_ENCLOSURE_COMPLEX_PATH_H
#define COR_GEN_ENCLOSURE_COMPLEX_PATH_H

#include "enclosure/complex_ball.h"

/* The slope, its derivative by the dependent variable, and the slope of the time */
struct slopes {
    struct complex_ball slope, derivative, time;
};

struct path;

/* Returns the slopes for every x and every y in balls. */
typedef struct slopes path_equation(const struct path *p, struct complex_ball x, struct complex_ball y);

/* A straight path, begin + s length, 0 <= s <= 1, length = end - begin */
struct path {
    path_equation *equation;
    struct complex_ball begin, end, length;
    struct complex_ball s;          /* where path_equation is evaluated, as a fraction of the path */
    struct complex_ball c1, c2, c3; /* coefficients of the equation */
    double a, b;                    /* exponents; difference = a - b and n = 2b + 1 - a, each rounded once */
    double difference, n;
    double resolution;         /* 1, or a smaller number for smaller radii and more steps */
    bool pressed;              /* a constant force c3 acts */
    bool logarithm;            /* y is a logarithm: its radius is compared with 1, not with |y| */
    struct complex_ball slope; /* slope of the last step, which predicts the slope of the next */
};

/* The dependent variable of every solution, and its time */
struct path_state {
    struct complex_ball value, time;
};

/* Follows the solution along a straight path between two numbers, which may be balls. Returns false if the balls are
 * too wide, or if the solution is not proved to be analytic there. */
bool path_follow(struct path *p, path_equation *equation, struct complex_ball begin, struct complex_ball end,
                 struct path_state *y);

#endif
