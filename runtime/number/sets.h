/* SPDX-License-Identifier: MIT */
/* The only dispatch by instruction set. Loops are written once, in <stem>_kernel.c, and end with a table of functions
 * COR_OF_SET(name). The build compiles the file once for each set, with COR_SET defined (cmake/CorArraySets.cmake). */
#ifndef COR_RUNTIME_SETS_H
#define COR_RUNTIME_SETS_H

#include <stddef.h>

#include "runtime/number/inline.h"

/* By increasing width */
enum cor_instruction_set { COR_PORTABLE, COR_AVX2, COR_AVX512, COR_INSTRUCTION_SETS };

/* Loops add numbers in this many partial sums, and pad arrays to multiples of this number. It is the same for all
 * vector widths, so all sets give the same bits. */
enum { COR_LANES = 8 };

/* True if this build has the set and this processor can run it. */
COR_INLINE int cor_processor_has(int set)
{
#ifdef COR_X86_SETS
    if (set == COR_AVX2)
        return __builtin_cpu_supports("avx2") != 0;
    if (set == COR_AVX512)
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl");
#endif
    return set == COR_PORTABLE;
}

/* Returns the widest set that this processor can run. */
COR_INLINE int cor_widest_set(void)
{
    int set = COR_INSTRUCTION_SETS - 1;
    while (!cor_processor_has(set))
        set--;
    return set;
}

/* Macros for the name of the table that a kernel defines, and of its instruction set */
#ifndef COR_SET
#define COR_SET portable
#endif
#define COR_OF_SET(name) COR_OF_SET_(name, COR_SET)
#define COR_OF_SET_(name, set) COR_OF_SET_2_(name, set)
#define COR_OF_SET_2_(name, set) name##_##set
#define COR_SET_NAME COR_SET_NAME_(COR_SET)
#define COR_SET_NAME_(set) COR_SET_NAME_2_(set)
#define COR_SET_NAME_2_(set) #set

/* COR_TABLES(type, name, function) declares the tables name_<set> of a kernel and defines function(set), which returns
 * a set's table, or NULL if this build or this processor lacks the set. */
#ifdef COR_X86_SETS
#define COR_TABLES(type, name, function)                                                                               \
    extern const type name##_portable, name##_avx2, name##_avx512;                                                     \
    COR_INLINE const type *function(int set)                                                                           \
    {                                                                                                                  \
        static const type *const table[] = {&name##_portable, &name##_avx2, &name##_avx512};                           \
        return cor_processor_has(set) ? table[set] : NULL;                                                             \
    }
#else
#define COR_TABLES(type, name, function)                                                                               \
    extern const type name##_portable;                                                                                 \
    COR_INLINE const type *function(int set)                                                                           \
    {                                                                                                                  \
        return cor_processor_has(set) ? &name##_portable : NULL;                                                       \
    }
#endif

#endif
