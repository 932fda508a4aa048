/* SPDX-License-Identifier: MIT */
#include "cor/hertz_dashpot.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* If one function of the evaluator stays a call, the constants of the law are copied, which takes five times as
 * long. */
#ifdef __GNUC__
#define COR_INLINE static inline __attribute__((always_inline))
#endif

#include "runtime/law/dashpot_array.h"
#include "runtime/law/define.h"
#include "runtime/law/hertz_dashpot_approach_only.h"

/* ---- arrays by loops ---- */

static const double *first_row(struct cor_inline_law_table table)
{
    return table.kind ? table.rows(0) : NULL;
}

#define ROWS_OF_QUANTITY(function, tables)                                                                             \
    case COR_DASHPOT_##function: {                                                                                     \
        const struct cor_inline_law_quantity q = cor_law_hertz_dashpot_##tables();                                     \
        const struct cor_dashpot_rows rows = {first_row(q.near), first_row(q.middle), first_row(q.below)};             \
        return rows;                                                                                                   \
    }
#define ROWS_OF_INVERSE(function, tables)                                                                              \
    case COR_DASHPOT_##function: {                                                                                     \
        const struct cor_inline_law_inverse inverse = cor_law_hertz_dashpot_##tables();                                \
        const struct cor_dashpot_rows rows = {first_row(inverse.near), first_row(inverse.rows), NULL};                 \
        return rows;                                                                                                   \
    }

static struct cor_dashpot_rows dashpot_rows(enum cor_dashpot_number function)
{
    const struct cor_dashpot_rows none = {NULL, NULL, NULL};
    switch (function) {
        COR_DASHPOT_LOOPS(ROWS_OF_QUANTITY, ROWS_OF_QUANTITY, ROWS_OF_QUANTITY, ROWS_OF_INVERSE)
    default:
        return none;
    }
}

int cor_dashpot_array_of_set(int set, enum cor_dashpot_number function, const double *in, double *out, size_t n)
{
    const struct cor_dashpot_loops *const loops = cor_dashpot_loops(set);
    if (loops == NULL)
        return 0;
    const struct cor_dashpot_rows rows = dashpot_rows(function);
    loops->of[function](&rows, in, out, n);
    return 1;
}

/* ---- the functions of hertz_dashpot.h ---- */

#define SCALARS(quantity, inline_function)                                                                             \
    double cor_hertz_dashpot_##quantity(double x)                                                                      \
    {                                                                                                                  \
        return inline_function(x);                                                                                     \
    }                                                                                                                  \
    float cor_hertz_dashpot_##quantity##f(float x)                                                                     \
    {                                                                                                                  \
        return (float)cor_hertz_dashpot_##quantity((double)x);                                                         \
    }

#define WITH_LOOP(quantity, tables)                                                                                    \
    SCALARS(quantity, cor_inline_hertz_dashpot_##quantity)                                                             \
    static void loop_##quantity(const double *x, double *y, size_t n)                                                  \
    {                                                                                                                  \
        cor_dashpot_array_of_set(cor_widest_set(), COR_DASHPOT_##quantity, x, y, n);                                   \
    }                                                                                                                  \
    void cor_hertz_dashpot_##quantity##_array(const double *x, double *y, size_t n)                                    \
    {                                                                                                                  \
        cor_law_array_by(loop_##quantity, x, y, n);                                                                    \
    }                                                                                                                  \
    void cor_hertz_dashpot_##quantity##_arrayf(const float *x, float *y, size_t n)                                     \
    {                                                                                                                  \
        cor_law_arrayf_by(loop_##quantity, x, y, n);                                                                   \
    }
COR_DASHPOT_LOOPS(WITH_LOOP, WITH_LOOP, WITH_LOOP, WITH_LOOP)

/* Arrays of these are computed one number after the other. */
#define ONE_BY_ONE(quantity, inline_function)                                                                          \
    SCALARS(quantity, inline_function)                                                                                 \
    COR_ARRAY_IN_ENVIRONMENT(double, cor_hertz_dashpot_##quantity##_array, cor_hertz_dashpot_##quantity)               \
    COR_ARRAY_IN_ENVIRONMENT(float, cor_hertz_dashpot_##quantity##_arrayf, cor_hertz_dashpot_##quantity##f)
ONE_BY_ONE(beta_of_loss_zero_overlap, cor_inline_hertz_dashpot_beta_of_loss_zero_overlap)
ONE_BY_ONE(beta_of_loss_zero_force, cor_inline_hertz_dashpot_beta_of_loss_zero_force)

#define APPROACH_ONLY(quantity) ONE_BY_ONE(quantity##_approach_only, dashpot_##quantity##_approach_only)
APPROACH_ONLY(eps)
APPROACH_ONLY(loss)
APPROACH_ONLY(beta)
APPROACH_ONLY(beta_of_loss)
APPROACH_ONLY(duration)
