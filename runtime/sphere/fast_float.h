/* SPDX-License-Identifier: MIT */
/* The tables of the functions in float arithmetic. fast_float.c makes scalar functions of them, array_kernel.c arrays.
 */
#ifndef COR_RUNTIME_SPHERE_FAST_FLOAT_H
#define COR_RUNTIME_SPHERE_FAST_FLOAT_H

#include "generated/sphere_float_tables.h"
#include "runtime/table/float_lanes.h"

#define FAST_FLOAT_TABLE(quantity, NAME, product)                                                                      \
    KERNEL struct float_table float_table_##quantity(void)                                                             \
    {                                                                                                                  \
        const struct float_table table = FLOAT_TABLE(quantity, NAME, product);                                         \
        return table;                                                                                                  \
    }
FAST_FLOAT_TABLE(eps_zero_overlap, EPS_ZERO_OVERLAP, 0)
FAST_FLOAT_TABLE(eps_zero_force, EPS_ZERO_FORCE, 0)
FAST_FLOAT_TABLE(loss_zero_overlap, LOSS_ZERO_OVERLAP, 1)
FAST_FLOAT_TABLE(loss_zero_force, LOSS_ZERO_FORCE, 1)
FAST_FLOAT_TABLE(duration_zero_overlap, DURATION_ZERO_OVERLAP, 0)
FAST_FLOAT_TABLE(duration_zero_force, DURATION_ZERO_FORCE, 0)
FAST_FLOAT_TABLE(max_overlap, MAX_OVERLAP, 0)
FAST_FLOAT_TABLE(time_of_max_overlap, TIME_OF_MAX_OVERLAP, 0)

#endif
