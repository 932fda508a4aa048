/* SPDX-License-Identifier: MIT */
/* The sphere functions in long double at every beta >= 0, fast enough for 10^9 points and good to a few 2^-64
 * where long double has 64 bits: what the doubles of the library are judged by.
 *
 * beta < 1/8           the exact series of corgen in beta and sqrt(beta)
 * 1/8 <= beta < 2^48   Chebyshev interpolation in beta within binades, the values integrated
 * 2^48 <= beta         powers of beta and ln(beta), what is next is below 2^-70
 * zero overlap, 8 <= beta: eps = h*^5/beta^5, exact to exp(-73)
 *
 * Nothing of it comes from collision_solve, the source of the library's tables: test_reference.c compares the two. */
#ifndef COR_TESTS_ACCURACY_REFERENCE_H
#define COR_TESTS_ACCURACY_REFERENCE_H

enum quantity {
    EPS_ZERO_OVERLAP,
    EPS_ZERO_FORCE,
    LOSS_ZERO_OVERLAP,
    LOSS_ZERO_FORCE,
    DURATION_ZERO_OVERLAP,
    DURATION_ZERO_FORCE,
    MAX_OVERLAP,
    TIME_OF_MAX_OVERLAP,
    QUANTITIES,
    /* made of the largest overlap and its time; a loss stands two places behind its eps */
    EPS_APPROACH_ONLY = QUANTITIES,
    DURATION_APPROACH_ONLY,
    LOSS_APPROACH_ONLY,
    ALL_QUANTITIES
};

/* Makes the tables, some seconds; once, before any thread calls the functions below. Returns 0, or 1 after saying
 * what failed. */
int reference_build(void);

long double reference_value(enum quantity quantity, long double beta);

/* d value/d beta to a few digits. */
long double reference_slope(enum quantity quantity, long double beta);

#endif
