/* SPDX-License-Identifier: MIT */
/* The array functions by instruction set: each array_<set>.c compiles array_kernel.h with the flags of its set. */
#ifndef COR_RUNTIME_LAW_ARRAY_H
#define COR_RUNTIME_LAW_ARRAY_H

#include <stddef.h>

#include "runtime/core/instruction_set.h"
#include "runtime/law/functions.h"

typedef void cor_law_array_function(const double *in, double *out, size_t n);

#define COR_LAW_LOOP_NUMBER_(name, least, largest) COR_LAW_##name,
enum cor_law_loop { COR_LAW_LOOPS(COR_LAW_LOOP_NUMBER_, COR_LAW_LOOP_NUMBER_) COR_LAW_LOOP_COUNT };

#define COR_LAW_SET_(set) extern cor_law_array_function *const cor_law_loops_##set[COR_LAW_LOOP_COUNT];
COR_EACH_SET(COR_LAW_SET_)

/* The loops of a set, by enum cor_law_loop; NULL if this build lacks the set or this processor cannot run it. */
cor_law_array_function *const *cor_law_loops(int set);
/* The loops of the widest set */
cor_law_array_function *const *cor_law_best_loops(void);

#endif
