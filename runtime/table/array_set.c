/* SPDX-License-Identifier: MIT */
#include "runtime/table/row_loops.h"

int cor_array_set(void)
{
    return cor_widest_set();
}
