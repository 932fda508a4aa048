/* SPDX-License-Identifier: MIT */
/* The functions of one law, x'' + beta x^b x' + x^a = 0, against collisions enclosed for this test: eps, loss, times,
 * largest overlap at any beta, and the inverse at the eps of those. */
#ifndef COR_TESTS_TABLE_LAW_CHECK_H
#define COR_TESTS_TABLE_LAW_CHECK_H

#include <stdbool.h>
#include <stddef.h>

#include "series/law.h"

typedef double law_function(double x);

/* Index 0 is zero overlap, 1 zero force. */
struct law_functions {
    const char *name;
    const char *elastic, *damping;
    law_function *eps[2], *loss[2], *beta[2], *beta_of_loss[2], *duration[2], *max_overlap, *time_of_max_overlap;
    double one_ulp, two_ulp; /* bounds of eps, loss and largest overlap; of times and inverse */
};

/* PREFIX_eps_zero_overlap, ... */
#define LAW_FUNCTIONS(title, a, b, prefix, one, two)                                                                   \
    {                                                                                                                  \
        title, a, b, {prefix##_eps_zero_overlap, prefix##_eps_zero_force},                                             \
            {prefix##_loss_zero_overlap, prefix##_loss_zero_force},                                                    \
            {prefix##_beta_zero_overlap, prefix##_beta_zero_force},                                                    \
            {prefix##_beta_of_loss_zero_overlap, prefix##_beta_of_loss_zero_force},                                    \
            {prefix##_duration_zero_overlap, prefix##_duration_zero_force}, prefix##_max_overlap,                      \
            prefix##_time_of_max_overlap, one, two                                                                     \
    }

/* Fails the test where a function misses its bound. Each prints the worst errors found. */
void law_check_random(const struct law_functions *f, size_t points);
void law_check_borders(const struct law_functions *f, size_t points); /* as many borders as that, chosen at random */
void law_check_special(const struct law_functions *f);

/* e -> beta -> e over all sizes of e, and of 1 - e */
void law_check_round_trip(const struct law_functions *f, size_t points);

#endif
