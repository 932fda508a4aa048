/* SPDX-License-Identifier: MIT */
/* libcor: scalar functions, and arrays by instruction set. */
#include <stdio.h>

#include "methods.h"

SCALAR_METHOD(speed_zero_overlap, const struct cor_sphere_contact *const contact = &scene->contact,
              cor_contact_eps_zero_overlap(contact, g))
SCALAR_METHOD(speed_zero_force, const struct cor_sphere_contact *const contact = &scene->contact,
              cor_contact_eps_zero_force(contact, g))
SCALAR_METHOD(beta_zero_overlap, , cor_sphere_eps_zero_overlap(g))
SCALAR_METHOD(beta_zero_force, , cor_sphere_eps_zero_force(g))

static void array_each(const struct method *method, const struct scene *scene, const double *in, double *out, size_t n)
{
    const struct isa_row *const isa = method->isa;
    if (method->input == FROM_SPEED)
        (method->end == ZERO_OVERLAP ? isa->speed_zero_overlap : isa->speed_zero_force)(&scene->contact, in, out, n);
    else
        (method->end == ZERO_OVERLAP ? isa->beta_zero_overlap : isa->beta_zero_force)(in, out, n);
}

static void add_scalars(struct methods *methods)
{
    static const struct method scalars[] = {
        {.name = "cor, from speed",
         .label = "cor",
         .end = ZERO_OVERLAP,
         .input = FROM_SPEED,
         .each = speed_zero_overlap_each,
         .chain = speed_zero_overlap_chain},
        {.name = "cor, from speed",
         .label = "cor",
         .end = ZERO_FORCE,
         .input = FROM_SPEED,
         .each = speed_zero_force_each,
         .chain = speed_zero_force_chain},
        {.name = "cor, from beta",
         .end = ZERO_OVERLAP,
         .input = FROM_BETA,
         .each = beta_zero_overlap_each,
         .chain = beta_zero_overlap_chain},
        {.name = "cor, from beta",
         .end = ZERO_FORCE,
         .input = FROM_BETA,
         .each = beta_zero_force_each,
         .chain = beta_zero_force_chain},
    };
    for (size_t i = 0; i < sizeof scalars / sizeof *scalars; i++) {
        struct method method = scalars[i];
        method.precision = "full";
        if (method.input == FROM_SPEED) {
            method.least_speed_up = 1;
            method.least_latency_gain = 1 / 1.2;
        }
        methods_add(methods, &method);
    }
}

static void add_array(struct methods *methods, const struct isa_row *isa, enum input input, enum end end)
{
    struct method method = {
        .precision = "full", .end = end, .input = input, .flags = ARRAY, .isa = isa, .each = array_each};
    snprintf(method.name, sizeof method.name, "cor array, from %s, %s", input == FROM_SPEED ? "speed" : "beta",
             isa->name);
    snprintf(method.label, sizeof method.label, "%s", isa->label);
    if (input == FROM_SPEED) {
        method.flags |= LARGE;
        method.least_speed_up = isa->least_speed_up ? isa->least_speed_up() : 0;
    }
    methods_add(methods, &method);
}

void add_library(struct methods *methods)
{
    add_scalars(methods);
    for (size_t i = 0; i < isa_row_count; i++) {
        const struct isa_row *const isa = &isa_rows[i];
        if (!isa->available())
            continue;
        for (enum end end = ZERO_OVERLAP; end <= ZERO_FORCE; end++)
            if (end == ZERO_OVERLAP ? isa->speed_zero_overlap : isa->speed_zero_force)
                add_array(methods, isa, FROM_SPEED, end);
        for (enum end end = ZERO_OVERLAP; end <= ZERO_FORCE; end++)
            if (end == ZERO_OVERLAP ? isa->beta_zero_overlap : isa->beta_zero_force)
                add_array(methods, isa, FROM_BETA, end);
    }
}
