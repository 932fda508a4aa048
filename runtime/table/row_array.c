/* SPDX-License-Identifier: MIT */
#include "runtime/number/environment.h"
#include "runtime/table/row_loops.h"

/* The loops compute both sides of a condition and select one. The environment hides exceptions of the unused side. */
void cor_row_array(const struct cor_row_table *table, double (*one)(double x), const double *x, double *y, size_t n)
{
#ifdef COR_WITHOUT_LOOPS
    (void)table;
    cor_array_in_environment(one, x, y, n);
#else
    const struct cor_row_call call = {table, one, NULL, NULL, NULL, 0};
    const struct cor_environment caller = cor_environment_enter();
    cor_row_loops(cor_array_set())->doubles(&call, x, y, n);
    cor_environment_leave(&caller);
#endif
}
