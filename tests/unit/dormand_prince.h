/* SPDX-License-Identifier: MIT */
/* Runge-Kutta 5(4) of Dormand and Prince, J. Comp. Appl. Math. 6, 19 (1980): what tests and benchmarks integrate with
 * where an ordinary method is wanted. The last stage is the first of the next step. */
#ifndef COR_TESTS_DORMAND_PRINCE_H
#define COR_TESTS_DORMAND_PRINCE_H

enum { DORMAND_PRINCE_STAGES = 7 };

static const double dormand_prince[DORMAND_PRINCE_STAGES][DORMAND_PRINCE_STAGES - 1] = {
    {0},
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
};

/* fifth order minus fourth */
static const double dormand_prince_difference[DORMAND_PRINCE_STAGES] = {
    71.0 / 57600, 0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

#endif
