/* SPDX-License-Identifier: MIT */
/* Computes the sphere functions in long double at every beta >= 0, fast enough for 10^9 points and accurate to a few
 * 2^-64 if long double has 64 bits. They are the reference for the library's doubles.
 *
 *     beta < 1/8           Chebyshev interpolation of integrated values in sqrt(beta); losses are divided by beta
 *     1/8 <= beta < 2^48   Chebyshev interpolation of integrated values in beta, in each binade
 *     2^48 <= beta         powers of beta and ln(beta); the next terms are below 2^-70
 *     zero overlap, 8 <= beta: eps = h*^5/beta^5, exact to exp(-73)
 *
 * Nothing here comes from collision_solve, the source of the library's tables. test_reference.c compares the two. */
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
    /* computed from MAX_OVERLAP and TIME_OF_MAX_OVERLAP */
    EPS_APPROACH_ONLY = QUANTITIES,
    DURATION_APPROACH_ONLY,
    LOSS_APPROACH_ONLY,
    ALL_QUANTITIES
};

/* The functions of one double: name, shape (see search.h), quantity and bound. `quantity` of a loss or an inverse is
 * the quantity of its eps. */
#define SPHERE_FUNCTIONS(ROW)                                                                                          \
    ROW(eps_zero_overlap, EPS, EPS_ZERO_OVERLAP, COR_SPHERE_EPS_MAX_ULP)                                               \
    ROW(eps_zero_force, EPS, EPS_ZERO_FORCE, COR_SPHERE_EPS_MAX_ULP)                                                   \
    ROW(loss_zero_overlap, LOSS, EPS_ZERO_OVERLAP, COR_SPHERE_LOSS_MAX_ULP)                                            \
    ROW(loss_zero_force, LOSS, EPS_ZERO_FORCE, COR_SPHERE_LOSS_MAX_ULP)                                                \
    ROW(duration_zero_overlap, OTHER, DURATION_ZERO_OVERLAP, COR_SPHERE_TIME_MAX_ULP)                                  \
    ROW(duration_zero_force, OTHER, DURATION_ZERO_FORCE, COR_SPHERE_TIME_MAX_ULP)                                      \
    ROW(max_overlap, OTHER, MAX_OVERLAP, COR_SPHERE_MAX_OVERLAP_MAX_ULP)                                               \
    ROW(time_of_max_overlap, OTHER, TIME_OF_MAX_OVERLAP, COR_SPHERE_TIME_MAX_ULP)                                      \
    ROW(beta_zero_overlap, INVERSE, EPS_ZERO_OVERLAP, COR_SPHERE_BETA_MAX_ULP)                                         \
    ROW(beta_zero_force, INVERSE, EPS_ZERO_FORCE, COR_SPHERE_BETA_MAX_ULP)                                             \
    ROW(eps_approach_only, EPS, EPS_APPROACH_ONLY, COR_SPHERE_APPROACH_MAX_ULP)                                        \
    ROW(loss_approach_only, LOSS, EPS_APPROACH_ONLY, COR_SPHERE_APPROACH_MAX_ULP)                                      \
    ROW(duration_approach_only, OTHER, DURATION_APPROACH_ONLY, COR_SPHERE_TIME_MAX_ULP)                                \
    ROW(beta_approach_only, INVERSE, EPS_APPROACH_ONLY, COR_SPHERE_APPROACH_MAX_ULP)                                   \
    ROW(beta_of_loss_approach_only, INVERSE_OF_LOSS, EPS_APPROACH_ONLY, COR_SPHERE_APPROACH_MAX_ULP)
enum { LOSS_OF_EPS = LOSS_ZERO_OVERLAP - EPS_ZERO_OVERLAP }; /* eps + LOSS_OF_EPS is the enumerator of its loss */

/* Makes the tables in some seconds. Call it once, before any thread calls the functions below. */
void reference_build(void);

long double reference_value(enum quantity quantity, long double beta);

/* Returns d value/d beta to a few digits. */
long double reference_slope(enum quantity quantity, long double beta);

#endif
