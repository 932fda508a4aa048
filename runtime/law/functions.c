/* SPDX-License-Identifier: MIT */
/* The table of law.h: every function by law, end of contact and quantity. */
#include <math.h>

#include "cor/sphere.h"
#include "runtime/law/functions.h"

/* The functions of sphere.h, in the order of enum cor_quantity */

#define ROW(name, function, largest, max_ulp)                                                                          \
    COR_LAW_ROW("viscoelastic_" name, cor_sphere_##function, 0, largest, max_ulp)
#define EPS_ROW(quantity)                                                                                              \
    {                                                                                                                  \
        "viscoelastic_" #quantity, cor_sphere_##quantity, cor_sphere_##quantity##_array,                               \
            cor_sphere_##quantity##_arrayf, 0, INFINITY, 1                                                             \
    }
#define OVERLAP_ROWS                                                                                                   \
    [COR_MAX_OVERLAP] = ROW("max_overlap", max_overlap, INFINITY, 1), [COR_TIME_OF_MAX_OVERLAP] =                      \
                                                                          ROW("time_of_max_overlap",                   \
                                                                              time_of_max_overlap, INFINITY, 2)
#define ROWS(end)                                                                                                      \
    {                                                                                                                  \
        EPS_ROW(eps_##end), EPS_ROW(loss_##end), ROW("damping_of_eps_" #end, beta_##end, 1, 2),                        \
            [COR_DURATION] = ROW("duration_" #end, duration_##end, INFINITY, 2), OVERLAP_ROWS                          \
    }

const cor_law_functions cor_viscoelastic_functions = {
    [COR_END_ZERO_OVERLAP] = ROWS(zero_overlap),
    [COR_END_ZERO_FORCE] = ROWS(zero_force),
    [COR_END_APPROACH_ONLY] = {ROW("eps_approach_only", eps_approach_only, INFINITY, 2),
                               ROW("loss_approach_only", loss_approach_only, INFINITY, 2),
                               ROW("damping_of_eps_approach_only", beta_approach_only, 1, 2),
                               ROW("damping_of_loss_approach_only", beta_of_loss_approach_only, 1, 2),
                               ROW("duration_approach_only", duration_approach_only, INFINITY, 2), OVERLAP_ROWS},
};

#define OF_LAW(law, array) [COR_LAW_##law] = &(array),
static const cor_law_functions *const laws[] = {COR_LAWS_WITH_FUNCTIONS(OF_LAW)};

/* Returns an entry of the table, or NULL beyond the table. Its value is NULL if the function does not exist. */
static inline const struct cor_law_function *table_entry(enum cor_law law, enum cor_end end, enum cor_quantity quantity)
{
    const int exists = ((unsigned)law < sizeof laws / sizeof *laws) & ((unsigned)end <= COR_END_APPROACH_ONLY) &
                       ((unsigned)quantity < COR_QUANTITIES);
    return exists && laws[law] ? &(*laws[law])[end][quantity] : NULL;
}

const struct cor_law_function *cor_law_function(enum cor_law law, enum cor_end end, enum cor_quantity quantity)
{
    const struct cor_law_function *const function = table_entry(law, end, quantity);
    return function && function->value ? function : NULL;
}

double cor_law_value(enum cor_law law, enum cor_end end, enum cor_quantity quantity, double x)
{
    const struct cor_law_function *const function = table_entry(law, end, quantity);
    return function && function->value ? function->value(x) : (double)NAN;
}

void cor_law_array(enum cor_law law, enum cor_end end, enum cor_quantity quantity, const double *in, double *out,
                   size_t n)
{
    const struct cor_law_function *const function = cor_law_function(law, end, quantity);
    if (function)
        function->array(in, out, n);
    else
        for (size_t i = 0; i < n; i++)
            out[i] = NAN;
}

void cor_law_arrayf(enum cor_law law, enum cor_end end, enum cor_quantity quantity, const float *in, float *out,
                    size_t n)
{
    enum { BLOCK = 256 };
    const struct cor_law_function *const function = cor_law_function(law, end, quantity);
    double wide[BLOCK];
    if (function && function->arrayf) {
        function->arrayf(in, out, n);
        return;
    }
    for (size_t i = 0, m; i < n; i += m) {
        m = n - i < BLOCK ? n - i : BLOCK;
        for (size_t j = 0; j < m; j++)
            wide[j] = (double)in[i + j];
        cor_law_array(law, end, quantity, wide, wide, m);
        for (size_t j = 0; j < m; j++)
            out[i + j] = cor_inline_narrow(wide[j]);
    }
}
