/* SPDX-License-Identifier: MIT */
/* Nonlinear least squares by the Levenberg-Marquardt method of MINPACK (cminpack). */
#ifndef COR_GEN_FIT_LEAST_SQUARES_H
#define COR_GEN_FIT_LEAST_SQUARES_H

#include <stddef.h>

typedef void least_squares_residuals(const void *context, const double *theta, double *residual);

/* Minimises the sum of the squares of `points` residuals from the given theta on, which becomes the minimiser; returns
 * the sum there. points >= parameters >= 1. Stops where the relative change of the sum or of theta is below 1e-14. */
double least_squares_minimise(least_squares_residuals *residuals, const void *context, size_t points, int parameters,
                              double *theta);

#endif
