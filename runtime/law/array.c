/* SPDX-License-Identifier: MIT */
#include "runtime/law/array.h"

#define LAW_SET_ROW(set) cor_law_loops_##set,

cor_law_array_function *const *cor_law_loops(int set)
{
    static cor_law_array_function *const *const sets[] = {COR_EACH_SET(LAW_SET_ROW)};
    return cor_processor_has(set) ? sets[set] : NULL;
}

cor_law_array_function *const *cor_law_best_loops(void)
{
    return cor_law_loops(cor_widest_set());
}
