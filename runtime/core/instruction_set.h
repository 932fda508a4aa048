/* SPDX-License-Identifier: MIT */
/* The one dispatch by instruction set. A loop is written once, as a kernel, and compiled once for every set that this
 * build has, in <stem>_<set>.c; the functions of one set stand in one row of a table, in the order of the enum. */
#ifndef COR_RUNTIME_INSTRUCTION_SET_H
#define COR_RUNTIME_INSTRUCTION_SET_H

/* By increasing width */
enum cor_instruction_set { COR_PORTABLE, COR_AVX2, COR_AVX512, COR_INSTRUCTION_SETS };

/* X(set) for every set of this build, in that order: to declare its functions, or to write its row. */
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

/* The row to take here */
static inline int cor_widest_set(void)
{
    int set = COR_INSTRUCTION_SETS - 1;
    while (!cor_processor_has(set))
        set--;
    return set;
}

#endif
