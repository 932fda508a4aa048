/* SPDX-License-Identifier: MIT */
/* The quasistatic law of the disk in interval (ball) arithmetic of any precision, W by arb_lambertw: the reference of
 * the accuracy test and of the stability suite.
 *
 * A collision in time is computed by sinc functions: with theta = (pi/2)/(1 + e), e = exp(-pi sinh y), the time
 *
 *     s(theta) = int_theta^(pi/2) sqrt(-w/2) dtheta',   w = W_-1(-(v^2/8) exp(1 - 2 b) sin^2 theta)
 *
 * at every node y_k = k 2^-level is a sum over all nodes with the weights 1/2 + Si(pi (j - k))/pi. Balls enclose the
 * rounding; what the rule leaves out falls exponentially as level grows. */
#ifndef COR_TESTS_ACCURACY_DISK_REFERENCE_H
#define COR_TESTS_ACCURACY_DISK_REFERENCE_H

#include <stdbool.h>

#include <cor/disk.h>

#include "support/flint.h"

enum disk_kind {
    DISK_LOAD,
    DISK_COMPRESSION,
    DISK_ENERGY,
    DISK_LOAD_OF_ENERGY,
    DISK_MAX_LOAD,
    DISK_MAX_COMPRESSION,
    DISK_KINDS
};

/* What is judged, by kind */
extern const struct disk_function {
    const char *name;
    double (*value)(double argument, double nu, enum cor_disk_datum datum);
    double (*limit)(double nu, enum cor_disk_datum datum); /* the largest argument */
} disk_functions[DISK_KINDS];

/* b of (57) */
void disk_constant(arb_t b, double nu, enum cor_disk_datum datum, slong prec);

/* -W_-1(-z) */
void disk_minus_w(arb_t w, const arb_t z, slong prec);

/* The exact value of a function; false if putting it back into (57) contradicts. */
bool disk_value(arb_t y, enum disk_kind kind, double argument, double nu, enum cor_disk_datum datum, slong prec);

/* The contact time, and the same with steps twice as long */
void disk_contact_time(arb_t tau, arb_t halved, double v, double nu, enum cor_disk_datum datum, int level, slong prec);

struct indefinite {
    slong nodes, prec;
    arb_ptr sin_weight; /* sin(theta) dtheta/dy 2^-level */
    arb_ptr s;
};

void indefinite_init(struct indefinite *f, double v, double nu, enum cor_disk_datum datum, int level, slong prec);
void indefinite_clear(struct indefinite *f);

/* I(omega) = int_0^(pi/2) sin(theta) cos(omega s(theta)) dtheta, (68) as one integral */
void indefinite_integral(arb_t integral, const struct indefinite *f, double omega);

#endif
