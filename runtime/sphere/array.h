/* SPDX-License-Identifier: MIT */
/* Interface of array_kernel.c: array functions of an impact speed. */
#ifndef COR_RUNTIME_SPHERE_ARRAY_H
#define COR_RUNTIME_SPHERE_ARRAY_H

#include "cor/contact.h"
#include "runtime/table/row_loops.h"

/* A function of contact.h. table: rows in eps for CONTACT_DISSIPATION, in beta^5 for CONTACT_EPS, otherwise in beta.
 * of_eps: scalar function of CONTACT_DISSIPATION. one: scalar function of other kinds. Only CONTACT_EPS uses `beyond`
 * and `eps_far_root`. beyond: a table in beta for beta^5 outside `table`. eps_far_root: for larger beta^5; may be
 * NULL. */
struct cor_contact_function {
    enum cor_contact_kind { CONTACT_EPS, CONTACT_BETA, CONTACT_DURATION, CONTACT_OVERLAP, CONTACT_DISSIPATION } kind;
    const struct cor_row_table *table, *beyond;
    double (*eps_far_root)(double x);
    double (*one)(const struct cor_sphere_contact *contact, double speed);
    double (*of_eps)(const struct cor_sphere_contact *contact, double speed, double eps);
};

/* The loop of an instruction set. Only CONTACT_DISSIPATION uses the argument `eps`. */
struct cor_contact_loops {
    void (*run)(const struct cor_contact_function *f, const struct cor_sphere_contact *contact, const double *speed,
                const double *eps, double *out, size_t n);
};
COR_TABLES(struct cor_contact_loops, cor_contact_loops, cor_contact_loops)

#endif
