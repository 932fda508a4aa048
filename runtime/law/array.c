/* SPDX-License-Identifier: MIT */
#include "runtime/law/array.h"

#include "runtime/number/environment.h"

void cor_law_array_by(cor_law_array_function *loop, const double *x, double *y, size_t n)
{
    const struct cor_environment caller = cor_environment_enter();
    loop(x, y, n);
    cor_environment_leave(&caller);
}

/* The double loop, so that each result is rounded once */
void cor_law_arrayf_by(cor_law_array_function *loop, const float *x, float *y, size_t n)
{
    enum { CHUNK = 512 };
    double wide[CHUNK];
    const struct cor_environment caller = cor_environment_enter();
    for (size_t i = 0; i < n; i += CHUNK) {
        const size_t m = n - i < CHUNK ? n - i : CHUNK;
        for (size_t j = 0; j < m; j++)
            wide[j] = (double)x[i + j];
        loop(wide, wide, m);
        for (size_t j = 0; j < m; j++)
            y[i + j] = (float)wide[j];
    }
    cor_environment_leave(&caller);
}

void cor_law_array(enum cor_law_loop loop, const double *x, double *y, size_t n)
{
    cor_law_array_by(cor_law_loops(cor_widest_set())->of[loop], x, y, n);
}

void cor_law_arrayf(enum cor_law_loop loop, const float *x, float *y, size_t n)
{
    cor_law_arrayf_by(cor_law_loops(cor_widest_set())->of[loop], x, y, n);
}
