/* SPDX-License-Identifier: MIT */
/* Declares the functions of embedded_unit.c, which test_embedded.c calls from another language. */
#ifndef COR_TESTS_EMBEDDED_H
#define COR_TESTS_EMBEDDED_H

#ifdef __cplusplus
extern "C" {
#endif

/* Every public function of cor_sphere.h. */
#define EMBEDDED_LIST(row)                                                                                             \
    row(eps_zero_overlap) row(eps_zero_force) row(loss_zero_overlap) row(loss_zero_force) row(beta_zero_overlap)       \
        row(beta_zero_force) row(duration_zero_overlap) row(duration_zero_force) row(max_overlap)                      \
            row(time_of_max_overlap) row(eps_zero_overlap_root) row(eps_zero_force_root)

enum { EMBEDDED_FUNCTIONS = 12 };

struct embedded_function {
    const char *name;
    double (*value)(double);
};

extern const struct embedded_function embedded_functions[EMBEDDED_FUNCTIONS];

#ifdef __cplusplus
}
#endif

#endif
