/* SPDX-License-Identifier: MIT */
/* libcor: scalar functions, also in float, and arrays by instruction set. */
#include "methods.h"

#include <cor/cor.h>

#include "runtime/number/sets.h"

#define CONTACT const struct cor_sphere_contact *const contact = &scene->contact
SCALAR_METHOD_OF(double, speed_overlap, CONTACT, cor_contact_eps_zero_overlap(contact, g))
SCALAR_METHOD_OF(double, speed_force, CONTACT, cor_contact_eps_zero_force(contact, g))
SCALAR_METHOD_OF(double, beta_overlap, , cor_sphere_eps_zero_overlap(g))
SCALAR_METHOD_OF(double, beta_force, , cor_sphere_eps_zero_force(g))

/* Replaces the library's function, so that array functions use the instruction set of the current method. */
static int array_set;
int cor_array_set(void)
{
    return array_set;
}

static void array_each(const struct method *method, const struct scene *scene, const double *in, double *out, size_t n)
{
    const int is_overlap = method->end == ZERO_OVERLAP;
    array_set = method->number;
    if (method->input == FROM_SPEED)
        (is_overlap ? cor_contact_eps_zero_overlap_array : cor_contact_eps_zero_force_array)(&scene->contact, in, out,
                                                                                             n);
    else
        (is_overlap ? cor_sphere_eps_zero_overlap_array : cor_sphere_eps_zero_force_array)(in, out, n);
}

static void float_array_each(const struct method *method, const struct scene *scene, const double *in, double *out,
                             size_t n)
{
    (void)scene;
    array_set = cor_widest_set();
    (method->end == ZERO_OVERLAP ? cor_sphere_eps_zero_overlap_arrayf
                                 : cor_sphere_eps_zero_force_arrayf)((const void *)in, (void *)out, n);
}

void add_library(struct methods *methods)
{
    static const char *const set_name[COR_INSTRUCTION_SETS] = {"portable", "AVX2", "AVX-512"};
    static const struct method calls[] = {
        METHOD("cor", "", ZERO_OVERLAP, FROM_SPEED, 0, speed_overlap),
        METHOD("cor", "", ZERO_FORCE, FROM_SPEED, 0, speed_force),
        METHOD("cor", "", ZERO_OVERLAP, FROM_BETA, 0, beta_overlap),
        METHOD("cor", "", ZERO_FORCE, FROM_BETA, 0, beta_force),
    };
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++)
        methods_add(methods, &calls[i]);
    struct method array = {.flags = ARRAY};
    for (array.end = ZERO_OVERLAP; array.end <= ZERO_FORCE; array.end++) {
        array.curve = "cor float";
        array.instructions = "as shipped";
        array.input = FROM_BETA;
        array.flags = FLOAT | ARRAY;
        array.each = float_array_each;
        methods_add(methods, &array);
        array.curve = "cor";
        array.each = array_each;
        for (array.number = COR_PORTABLE; array.number < COR_INSTRUCTION_SETS; array.number++)
            for (array.input = FROM_SPEED; array.input <= FROM_BETA && cor_processor_has(array.number); array.input++) {
                array.instructions = set_name[array.number];
                array.flags = ARRAY | (array.input == FROM_SPEED ? LARGE : 0);
                methods_add(methods, &array);
            }
    }
}
