/* SPDX-License-Identifier: MIT */
#include "runtime/law/array.h"

#include "runtime/number/environment.h"

void cor_law_array(enum cor_law_loop loop, const double *x, double *y, size_t n)
{
    const struct cor_environment caller = cor_environment_enter();
    cor_law_loops(cor_widest_set())->run(loop, x, y, n);
    cor_environment_leave(&caller);
}

void cor_law_arrayf(enum cor_law_loop loop, const float *x, float *y, size_t n)
{
    const struct cor_environment caller = cor_environment_enter();
    cor_law_loops(cor_widest_set())->run_floats(loop, x, y, n);
    cor_environment_leave(&caller);
}
