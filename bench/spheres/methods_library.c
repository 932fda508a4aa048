/* SPDX-License-Identifier: MIT */
/* libcor: scalar functions, in float too, and arrays by instruction set. */
#include "methods.h"

SCALAR_METHOD(speed_zero_overlap, const struct cor_sphere_contact *const contact = &scene->contact,
              cor_contact_eps_zero_overlap(contact, g))
SCALAR_METHOD(speed_zero_force, const struct cor_sphere_contact *const contact = &scene->contact,
              cor_contact_eps_zero_force(contact, g))
SCALAR_METHOD(beta_zero_overlap, , cor_sphere_eps_zero_overlap(g))
SCALAR_METHOD(beta_zero_force, , cor_sphere_eps_zero_force(g))
SCALAR_METHOD_OF(float, float_zero_overlap, , cor_sphere_eps_zero_overlapf(g))
SCALAR_METHOD_OF(float, float_zero_force, , cor_sphere_eps_zero_forcef(g))

static void array_each(const struct method *method, const struct scene *scene, const double *in, double *out, size_t n)
{
    const struct isa_row *const isa = method->isa;
    if (method->input == FROM_SPEED)
        (method->end == ZERO_OVERLAP ? isa->speed_zero_overlap : isa->speed_zero_force)(&scene->contact, in, out, n);
    else
        (method->end == ZERO_OVERLAP ? isa->beta_zero_overlap : isa->beta_zero_force)(in, out, n);
}

static void float_array_each(const struct method *method, const struct scene *scene, const double *in, double *out,
                             size_t n)
{
    (void)scene;
    (method->end == ZERO_OVERLAP ? cor_sphere_eps_zero_overlap_arrayf
                                 : cor_sphere_eps_zero_force_arrayf)((const void *)in, (void *)out, n);
}

#define CALL(CURVE, END, INPUT, FLAGS, NAME)                                                                           \
    {                                                                                                                  \
        .curve = CURVE, .end = END, .input = INPUT, .flags = FLAGS, .each = NAME##_each, .chain = NAME##_chain         \
    }
static const struct method calls[] = {
    CALL("cor", ZERO_OVERLAP, FROM_SPEED, 0, speed_zero_overlap),
    CALL("cor", ZERO_FORCE, FROM_SPEED, 0, speed_zero_force),
    CALL("cor", ZERO_OVERLAP, FROM_BETA, 0, beta_zero_overlap),
    CALL("cor", ZERO_FORCE, FROM_BETA, 0, beta_zero_force),
    CALL("cor float", ZERO_OVERLAP, FROM_BETA, FLOAT, float_zero_overlap),
    CALL("cor float", ZERO_FORCE, FROM_BETA, FLOAT, float_zero_force),
};

void add_library(struct methods *methods)
{
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++)
        methods_add(methods, &calls[i]);
    for (enum end end = ZERO_OVERLAP; end <= ZERO_FORCE; end++) {
        methods_add(methods, &(struct method){.curve = "cor float",
                                              .instructions = "as shipped",
                                              .end = end,
                                              .input = FROM_BETA,
                                              .flags = FLOAT | ARRAY,
                                              .each = float_array_each});
        for (size_t i = 0; i < isa_row_count; i++)
            for (enum input input = FROM_SPEED; input <= FROM_BETA; input++)
                if (isa_rows[i].available())
                    methods_add(methods, &(struct method){.curve = "cor",
                                                          .instructions = isa_rows[i].name,
                                                          .end = end,
                                                          .input = input,
                                                          .flags = ARRAY | (input == FROM_SPEED ? LARGE : 0),
                                                          .isa = &isa_rows[i],
                                                          .each = array_each});
    }
}
