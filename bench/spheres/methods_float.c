/* SPDX-License-Identifier: MIT */
/* libcor in float, from beta: calls, and arrays as shipped. */
#include "methods.h"

SCALAR_METHOD_OF(float, zero_overlap, , cor_sphere_eps_zero_overlapf(g))
SCALAR_METHOD_OF(float, zero_force, , cor_sphere_eps_zero_forcef(g))

static void array_each(const struct method *method, const struct scene *scene, const double *in, double *out, size_t n)
{
    (void)scene;
    (method->end == ZERO_OVERLAP ? cor_sphere_eps_zero_overlap_arrayf
                                 : cor_sphere_eps_zero_force_arrayf)((const void *)in, (void *)out, n);
}

void add_floats(struct methods *methods)
{
    for (enum end end = ZERO_OVERLAP; end <= ZERO_FORCE; end++) {
        const struct method call = {.name = "cor float, from beta",
                                    .precision = "full float",
                                    .end = end,
                                    .input = FROM_BETA,
                                    .flags = FLOAT,
                                    .each = end == ZERO_OVERLAP ? zero_overlap_each : zero_force_each,
                                    .chain = end == ZERO_OVERLAP ? zero_overlap_chain : zero_force_chain};
        const struct method array = {.name = "cor float array, from beta, as shipped",
                                     .precision = "full float",
                                     .end = end,
                                     .input = FROM_BETA,
                                     .flags = FLOAT | ARRAY,
                                     .each = array_each};
        methods_add(methods, &call);
        methods_add(methods, &array);
    }
}
