/* SPDX-License-Identifier: MIT */
/* The array functions of the sphere: its tables for the loops of runtime/table/row_loops.h, and by instruction set what
 * array_kernel.c adds for impact speeds. */
#ifndef COR_RUNTIME_SPHERE_ARRAY_H
#define COR_RUNTIME_SPHERE_ARRAY_H

#include "cor/contact.h"
#include "runtime/sphere/float_exceptions.h"
#include "runtime/table/row_loops.h"

/* X(quantity) for every function of sphere.h in float arithmetic, of sphere.h, of contact.h that takes speeds, and of
 * contact.h that takes speeds and eps. */
#define COR_FLOAT_QUANTITIES(X)                                                                                        \
    X(eps_zero_overlap)                                                                                                \
    X(eps_zero_force)                                                                                                  \
    X(loss_zero_overlap)                                                                                               \
    X(loss_zero_force)                                                                                                 \
    X(duration_zero_overlap)                                                                                           \
    X(duration_zero_force)                                                                                             \
    X(max_overlap)                                                                                                     \
    X(time_of_max_overlap)
#define COR_SPHERE_QUANTITIES(X)                                                                                       \
    COR_FLOAT_QUANTITIES(X)                                                                                            \
    X(beta_zero_overlap)                                                                                               \
    X(beta_zero_force)                                                                                                 \
    X(eps_approach_only)                                                                                               \
    X(loss_approach_only)                                                                                              \
    X(beta_approach_only)                                                                                              \
    X(duration_approach_only)
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

#define COR_SPHERE_NUMBER_(quantity) COR_SPHERE_##quantity,
#define COR_CONTACT_NUMBER_(quantity) COR_CONTACT_##quantity,
enum cor_sphere_number { COR_SPHERE_QUANTITIES(COR_SPHERE_NUMBER_) COR_SPHERE_COUNT };
enum cor_contact_number {
    COR_CONTACT_QUANTITIES(COR_CONTACT_NUMBER_) COR_DISSIPATION_QUANTITIES(COR_CONTACT_NUMBER_) COR_CONTACT_COUNT
};

/* A quantity of sphere.h: its table, its scalar functions, and the floats that one rounding does not serve */
struct cor_sphere_rows {
    struct cor_row_table table;
    double (*one)(double);
    float (*onef)(float);
    struct cor_float_exception exception;
};
extern const struct cor_sphere_rows cor_sphere_rows[COR_SPHERE_COUNT];

/* A function of contact.h: its table, which for eps is in beta^5 and for dissipation in eps; for eps the table in beta
 * and the function of beta^5 beyond it, or NULL; and the scalar function */
struct cor_contact_function {
    enum cor_contact_kind { CONTACT_EPS, CONTACT_BETA, CONTACT_DURATION, CONTACT_OVERLAP, CONTACT_DISSIPATION } kind;
    const struct cor_row_table *table, *beyond;
    double (*eps_far_root)(double x);
    double (*one)(const struct cor_sphere_contact *contact, double speed);
    double (*of_eps)(const struct cor_sphere_contact *contact, double speed, double eps);
};
extern const struct cor_contact_function cor_contact_functions[COR_CONTACT_COUNT];

/* The loop of a set; `eps` is an argument of CONTACT_DISSIPATION alone. */
struct cor_contact_loops {
    void (*run)(const struct cor_contact_function *f, const struct cor_sphere_contact *contact, const double *speed,
                const double *eps, double *out, size_t n);
};
COR_TABLES(struct cor_contact_loops, cor_contact_loops, cor_contact_loops)

#endif
