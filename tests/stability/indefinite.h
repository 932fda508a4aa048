/* SPDX-License-Identifier: MIT */
/* A quasistatic collision of a disk by sinc functions, in balls of any precision: with theta = (pi/2)/(1 + e),
 * e = exp(-pi sinh y), the time
 *
 *     s(theta) = int_theta^(pi/2) sqrt(-w/2) dtheta',   w = W_-1(-(v^2/8) exp(1 - 2 b) sin^2 theta)
 *
 * at every node y_k = k 2^-level is a sum over all nodes with the weights 1/2 + Si(pi (j - k))/pi. Balls enclose the
 * rounding; what the rule leaves out falls exponentially as level grows. */
#ifndef COR_TESTS_INDEFINITE_H
#define COR_TESTS_INDEFINITE_H

#include "support/flint.h"

#include <cor/disk.h>

struct indefinite {
    slong nodes, prec;
    arb_ptr sin_weight; /* sin(theta) dtheta/dy 2^-level */
    arb_ptr s;
    arb_t half_time; /* s(0) */
};

/* b of (57) */
void disk_constant(arb_t b, double nu, enum cor_disk_datum datum, slong prec);

void indefinite_init(struct indefinite *f, double v, double nu, enum cor_disk_datum datum, int level, slong prec);
void indefinite_clear(struct indefinite *f);

/* I(omega) = int_0^(pi/2) sin(theta) cos(omega s(theta)) dtheta, (68) as one integral */
void indefinite_integral(arb_t integral, const struct indefinite *f, double omega);

#endif
