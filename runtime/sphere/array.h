/* SPDX-License-Identifier: MIT */
/* The array functions by instruction set: sphere_array_<set>.c each compile sphere_array_kernel.h with other flags. */
#ifndef COR_RUNTIME_SPHERE_ARRAY_H
#define COR_RUNTIME_SPHERE_ARRAY_H

#include <stddef.h>

#include "cor/contact.h"
#include "runtime/core/instruction_set.h"

/* contact is not looked at where `in` is beta. */
typedef void cor_array_function(const struct cor_sphere_contact *contact, const double *in, double *out, size_t n);

#define COR_ARRAY_SET(set)                                                                                             \
    cor_array_function cor_array_eps_zero_overlap_##set, cor_array_eps_zero_force_##set,                               \
        cor_array_speed_zero_overlap_##set, cor_array_speed_zero_force_##set;

COR_EACH_SET(COR_ARRAY_SET)

/* The widest set that this processor has: a row of four functions. */
struct cor_array_set {
    const char *name;
    cor_array_function *eps_zero_overlap, *eps_zero_force, *speed_zero_overlap, *speed_zero_force;
};

/* By enum cor_instruction_set; NULL where this processor, or this build, has it not. */
const struct cor_array_set *cor_array_set(int i);
const struct cor_array_set *cor_array_best_set(void);

#endif
