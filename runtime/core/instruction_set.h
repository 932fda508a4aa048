/* SPDX-License-Identifier: MIT */
/* The only dispatch by instruction set. A loop is written once, as a kernel. <stem>_<set>.c compiles the kernel for
 * each set of this build. A table has one row of functions for each set, in the order of the enum. */
#ifndef COR_RUNTIME_INSTRUCTION_SET_H
#define COR_RUNTIME_INSTRUCTION_SET_H

/* By increasing width */
enum cor_instruction_set { COR_PORTABLE, COR_AVX2, COR_AVX512, COR_INSTRUCTION_SETS };

/* Rows of numbers and sums have this number of parts for every width of a vector, so that every set gives the same
 * bits. */
enum { COR_LANES = 8 };

/* X(set) for every set of this build, in the order of the enum. X declares the functions of a set or writes its row. */
#ifdef COR_X86_SETS
#define COR_EACH_SET(X) X(portable) X(avx2) X(avx512)
#else
#define COR_EACH_SET(X) X(portable)
#endif

/* Whether this build has the set and this processor can run it */
static inline int cor_processor_has(int set)
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

/* The row for the processor at hand */
static inline int cor_widest_set(void)
{
    int set = COR_INSTRUCTION_SETS - 1;
    while (!cor_processor_has(set))
        set--;
    return set;
}

#endif
