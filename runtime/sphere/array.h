/* SPDX-License-Identifier: MIT */
/* The array functions by instruction set: array_kernel.c. */
#ifndef COR_RUNTIME_SPHERE_ARRAY_H
#define COR_RUNTIME_SPHERE_ARRAY_H

#include <stddef.h>

#include "cor/contact.h"
#include "runtime/number/sets.h"

/* X(quantity) for every function of sphere.h, of sphere.h in float arithmetic, of contact.h that takes speeds, and of
 * contact.h that takes speeds and eps. */
#define COR_SPHERE_QUANTITIES(X)                                                                                       \
    X(eps_zero_overlap)                                                                                                \
    X(eps_zero_force)                                                                                                  \
    X(loss_zero_overlap)                                                                                               \
    X(loss_zero_force)                                                                                                 \
    X(beta_zero_overlap)                                                                                               \
    X(beta_zero_force)                                                                                                 \
    X(duration_zero_overlap)                                                                                           \
    X(duration_zero_force)                                                                                             \
    X(max_overlap)                                                                                                     \
    X(time_of_max_overlap)                                                                                             \
    X(eps_approach_only)                                                                                               \
    X(loss_approach_only)                                                                                              \
    X(beta_approach_only)                                                                                              \
    X(duration_approach_only)
#define COR_FLOAT_QUANTITIES(X)                                                                                        \
    X(eps_zero_overlap)                                                                                                \
    X(eps_zero_force)                                                                                                  \
    X(loss_zero_overlap)                                                                                               \
    X(loss_zero_force)                                                                                                 \
    X(duration_zero_overlap)                                                                                           \
    X(duration_zero_force)                                                                                             \
    X(max_overlap)                                                                                                     \
    X(time_of_max_overlap)
#define COR_CONTACT_QUANTITIES(X)                                                                                      \
    X(eps_zero_overlap)                                                                                                \
    X(eps_zero_force)                                                                                                  \
    X(beta)                                                                                                            \
    X(duration_s_zero_overlap)                                                                                         \
    X(duration_s_zero_force)                                                                                           \
    X(max_overlap_m)
#define COR_DISSIPATION_QUANTITIES(X)                                                                                  \
    X(dissipation_time_s_zero_overlap)                                                                                 \
    X(dissipation_time_s_zero_force)

typedef void cor_sphere_array(const double *in, double *out, size_t n);
typedef void cor_float_array(const float *in, float *out, size_t n);
typedef void cor_contact_array(const struct cor_sphere_contact *contact, const double *speed, double *out, size_t n);
typedef void cor_dissipation_array(const struct cor_sphere_contact *contact, const double *speed, const double *eps,
                                   double *out, size_t n);

/* The functions of one set */
struct cor_array_set {
    const char *name;
#define COR_ARRAY_FIELD(quantity) cor_sphere_array *sphere_##quantity;
    COR_SPHERE_QUANTITIES(COR_ARRAY_FIELD)
#undef COR_ARRAY_FIELD
#define COR_ARRAY_FIELD(quantity) cor_float_array *float_##quantity;
    COR_FLOAT_QUANTITIES(COR_ARRAY_FIELD)
#undef COR_ARRAY_FIELD
#define COR_ARRAY_FIELD(quantity) cor_contact_array *contact_##quantity;
    COR_CONTACT_QUANTITIES(COR_ARRAY_FIELD)
#undef COR_ARRAY_FIELD
#define COR_ARRAY_FIELD(quantity) cor_dissipation_array *contact_##quantity;
    COR_DISSIPATION_QUANTITIES(COR_ARRAY_FIELD)
#undef COR_ARRAY_FIELD
};

COR_TABLES(struct cor_array_set, cor_array, cor_array_set)

#endif
