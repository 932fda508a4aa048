/* SPDX-License-Identifier: MIT */
/* Tests the functions of one law, x'' + beta x^b x' + x^a = 0, against collisions enclosed for this test: eps, loss,
 * times and largest overlap at any beta, then the inverse at these eps. */
#ifndef COR_TESTS_TABLE_LAW_CHECK_H
#define COR_TESTS_TABLE_LAW_CHECK_H

#include <stdbool.h>
#include <stddef.h>

#include "series/law.h"

typedef double law_function(double x);

/* Index 0 is zero overlap, 1 zero force, 2 zero force with damping during approach only, which may be absent. */
enum { LAW_ENDS = 3 };

struct law_functions {
    const char *name;
    const char *elastic, *damping;
    law_function *eps[LAW_ENDS], *loss[LAW_ENDS], *beta[LAW_ENDS], *beta_of_loss[LAW_ENDS], *duration[LAW_ENDS];
    law_function *max_overlap, *time_of_max_overlap;
    double one_ulp, two_ulp; /* one_ulp: bound of eps, loss and largest overlap. two_ulp: bound of times and inverse */
    double approach_ulp;     /* bound for the third end */
};

/* PREFIX_eps_zero_overlap, ... */
#define LAW_TWO_ENDS(prefix, quantity)                                                                                 \
    {                                                                                                                  \
        prefix##_##quantity##_zero_overlap, prefix##_##quantity##_zero_force                                           \
    }
#define LAW_THREE_ENDS(prefix, quantity)                                                                               \
    {                                                                                                                  \
        prefix##_##quantity##_zero_overlap, prefix##_##quantity##_zero_force, prefix##_##quantity##_approach_only      \
    }
#define LAW_FUNCTIONS(title, a, b, prefix, ends, ...)                                                                  \
    {                                                                                                                  \
        title, a, b, ends(prefix, eps), ends(prefix, loss), ends(prefix, beta), ends(prefix, beta_of_loss),            \
            ends(prefix, duration), prefix##_max_overlap, prefix##_time_of_max_overlap, __VA_ARGS__                    \
    }

/* Fail the test if a function misses its bound. The random checks also print the worst errors found. */
void law_check_at(const struct law_functions *f, const double *beta, size_t n);
void law_check_random(const struct law_functions *f, size_t points);
void law_check_borders(const struct law_functions *f, size_t points); /* points: number of random borders */
void law_check_special(const struct law_functions *f);

/* Checks e -> beta -> e for all magnitudes of e and of 1 - e. */
void law_check_round_trip(const struct law_functions *f, size_t points);

#endif
