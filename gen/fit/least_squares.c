/* SPDX-License-Identifier: MIT */
#include "fit/least_squares.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>

#include <cminpack.h>

#include "support/console.h"

struct problem {
    least_squares_residuals *residuals;
    const void *context;
};

static int call_residuals(void *p, int m, int n, const double *x, double *fvec, int iflag)
{
    const struct problem *const problem = p;
    (void)n;
    (void)iflag;
    problem->residuals(problem->context, x, fvec);
    for (int i = 0; i < m; i++)
        if (!isfinite(fvec[i]))
            return -1; /* stop */
    return 0;
}

double least_squares_minimise(least_squares_residuals *residuals, const void *context, size_t points, int parameters,
                              double *theta)
{
    struct problem problem = {residuals, context};
    if (points > (size_t)INT_MAX / 16)
        exit(fail("too many points for least squares"));
    const int m = (int)points, n = parameters, work_length = m * n + 5 * n + m;
    double *const residual = xmalloc(points * sizeof(double));
    double *const work = xmalloc((size_t)work_length * sizeof(double));
    int *const pivot = xmalloc((size_t)n * sizeof(int));
    lmdif1(call_residuals, &problem, m, n, theta, residual, 1e-14, pivot, work, work_length);
    residuals(context, theta, residual);
    double sum = 0;
    for (size_t i = 0; i < points; i++)
        sum += residual[i] * residual[i];
    free(residual);
    free(work);
    free(pivot);
    return isfinite(sum) ? sum : INFINITY;
}
