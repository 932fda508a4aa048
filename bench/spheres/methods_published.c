/* SPDX-License-Identifier: MIT */
/* Methods for comparison: published formulas for eps, and the time steps of a simulator of many grains. Copying an
 * array gives the lower limit of the time. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "methods.h"

/* Returns eps at zero overlap by equation (35) and Table I of Phys. Rev. E 60, 4465 (1999), x = (g/g*)^(1/5). */
static double published(double x)
{
    return (1 + 2.5839 * x) / (1 + x * (3.5839 + x * (2.9839 + x * (1.1487 + x * 0.3265))));
}

/* Returns the [1/4] approximant of Mueller and Poeschel, Phys. Rev. E 84, 021302 (2011), v = sqrt(beta); zero force. */
static double mueller_poeschel(double v)
{
    return (1 + 0.501086 * v) / (1 + v * (0.501086 + v * (1.15345 + v * (0.577977 + v * 0.532178))));
}

/* Returns the [3/6] approximant of Mueller and Poeschel, which YADE evaluates for `en`. */
static double mueller_poeschel_of_yade(double v)
{
    return (1 + v * (1.07232 + v * (0.574198 + v * 0.141552))) /
           (1 + v * (1.07232 + v * (1.72765 + v * (1.37842 + v * (1.19449 + v * (0.467273 + v * 0.235585))))));
}

/* Returns eps by velocity Verlet with a fixed step. steps: number of steps in a contact without dissipation. The
 * damping uses the velocity at the half-step. The contact ends at the first step after its exact end. */
static double verlet(double beta, enum end end, int steps)
{
    static const double elastic_contact = 3.2180654597190431, longest = 1e4; /* elastic contacts */
    const double h = elastic_contact / steps;
    double x = 0, v = 1, force = 0;
    for (double t = 0; t < longest * elastic_contact; t += h) {
        v += 0.5 * h * force;
        x += h * v;
        if (x <= 0 && v < 0)
            return -v;
        const double root = sqrt(x);
        force = -root * (beta * v + x);
        if (end == ZERO_FORCE && v < 0 && force >= 0)
            return -v;
        v += 0.5 * h * force;
    }
    return NAN;
}

#define UNIT const double unit = scene->contact.beta_per_root
SCALAR_METHOD_OF(double, published, const double g_star = scene->g_star, published(pow(g / g_star, 0.2)))
SCALAR_METHOD_OF(double, published_beta, , published(-COR_SPHERE_C1 *g))
SCALAR_METHOD_OF(double, mueller_poeschel, const double unit = sqrt(scene->contact.beta_per_root),
                 mueller_poeschel(pow(g, 0.1) * unit))
SCALAR_METHOD_OF(double, mueller_poeschel_beta, , mueller_poeschel(sqrt(g)))
SCALAR_METHOD_OF(double, of_yade, const double unit = sqrt(scene->contact.beta_per_root),
                 mueller_poeschel_of_yade(pow(g, 0.1) * unit))
SCALAR_METHOD_OF(double, of_yade_beta, , mueller_poeschel_of_yade(sqrt(g)))
SCALAR_METHOD_OF(double, simple_beta, , cor_sphere_eps_simple(g))
SCALAR_METHOD_OF(double, verlet, UNIT, verlet(pow(g, 0.2) * unit, method->end, method->number))
SCALAR_METHOD_OF(double, verlet_beta, , verlet(g, method->end, method->number))

static void loop_each(const struct method *method, const struct scene *scene, const double *in, double *out, size_t n)
{
    (void)method;
    (void)scene;
    for (size_t i = 0; i < n; i++) { /* the arrays might overlap, so compilers keep the loop */
        ONE_BY_ONE;
        out[i] = in[i];
    }
}

static void memcpy_each(const struct method *method, const struct scene *scene, const double *in, double *out, size_t n)
{
    (void)method;
    (void)scene;
    memcpy(out, in, n * sizeof *out);
}

void add_published(struct methods *methods)
{
    static const struct method rows[] = {
        METHOD("published", "[1/4] of Table I", ZERO_OVERLAP, FROM_SPEED, 0, published),
        METHOD("published", "[1/4] of Table I", ZERO_OVERLAP, FROM_BETA, 0, published_beta),
        METHOD("published", "Müller & Pöschel [1/4]", ZERO_FORCE, FROM_SPEED, 0, mueller_poeschel),
        METHOD("published", "Müller & Pöschel [1/4]", ZERO_FORCE, FROM_BETA, 0, mueller_poeschel_beta),
        METHOD("published", "Müller & Pöschel [3/6]", ZERO_FORCE, FROM_SPEED, 0, of_yade),
        METHOD("published", "Müller & Pöschel [3/6]", ZERO_FORCE, FROM_BETA, 0, of_yade_beta),
        METHOD("published", "simple theory (27)", ZERO_OVERLAP, FROM_BETA, 0, simple_beta),
        {.curve = "copy", .setting = "loop", .end = NO_END, .flags = ARRAY | LARGE, .each = loop_each},
        {.curve = "copy", .setting = "memcpy", .end = NO_END, .flags = ARRAY | LARGE, .each = memcpy_each},
    };
    static const struct method by_input[] = {METHOD("Verlet", "", NO_END, FROM_SPEED, INTEGRATES, verlet),
                                             METHOD("Verlet", "", NO_END, FROM_BETA, INTEGRATES, verlet_beta)};
    static const int steps[] = {10, 30, 100, 300, 1000, 3000, 10000};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        methods_add(methods, &rows[i]);
    for (int i = 0; i < 4; i++)
        for (size_t k = 0; k < sizeof steps / sizeof *steps; k++) {
            struct method method = by_input[i / 2];
            method.end = i % 2 ? ZERO_FORCE : ZERO_OVERLAP;
            method.number = steps[k];
            snprintf(method.setting, sizeof method.setting, "%d steps", steps[k]);
            methods_add(methods, &method);
        }
}
