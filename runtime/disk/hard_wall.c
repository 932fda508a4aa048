/* SPDX-License-Identifier: MIT */
#include "runtime/disk/hard_wall.h"

const struct cor_hard_wall_loops *cor_hard_wall_widest_loops(void)
{
#ifdef COR_X86_SETS
    if (cor_processor_has(COR_AVX512))
        return &cor_hard_wall_avx512;
    if (cor_processor_has(COR_AVX2))
        return &cor_hard_wall_avx2;
#endif
    return &cor_hard_wall_portable;
}
