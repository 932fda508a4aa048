/* SPDX-License-Identifier: MIT */
/* The instruction sets that array loops are built for, and which of them this processor has. */
#ifndef COR_RUNTIME_INSTRUCTION_SET_H
#define COR_RUNTIME_INSTRUCTION_SET_H

enum cor_instruction_set { COR_PORTABLE, COR_AVX2, COR_AVX512, COR_INSTRUCTION_SETS };

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

#endif
