/* SPDX-License-Identifier: MIT */
/* What a user writes today, as it is printed. */
#include <math.h>

#include "methods.h"

/* (35) with Table I of Phys. Rev. E 60, 4465 (1999), x = (g/g*)^(1/5); zero overlap. */
static double published(double x)
{
    return (1 + 2.5839 * x) / (1 + x * (3.5839 + x * (2.9839 + x * (1.1487 + x * 0.3265))));
}

/* The [1/4] approximant of Mueller and Poeschel, Phys. Rev. E 84, 021302 (2011), v = sqrt(beta); zero force. */
static double mueller_poeschel(double v)
{
    return (1 + 0.501086 * v) / (1 + v * (0.501086 + v * (1.15345 + v * (0.577977 + v * 0.532178))));
}

SCALAR_METHOD(published, const double g_star = scene->g_star, published(pow(g / g_star, 0.2)))
SCALAR_METHOD(mueller_poeschel, const double unit = sqrt(scene->contact.beta_per_root),
              mueller_poeschel(pow(g, 0.1) * unit))
SCALAR_METHOD(published_beta, , published(-COR_SPHERE_C1 *g))
SCALAR_METHOD(mueller_poeschel_beta, , mueller_poeschel(sqrt(g)))
SCALAR_METHOD(simple_beta, , cor_sphere_eps_simple(g))

void add_published(struct methods *methods)
{
    static const struct method rows[] = {
        {.setting = "[1/4] of Table I", .end = ZERO_OVERLAP, .each = published_each, .chain = published_chain},
        {.setting = "Müller & Pöschel [1/4]",
         .end = ZERO_FORCE,
         .each = mueller_poeschel_each,
         .chain = mueller_poeschel_chain},
        {.setting = "[1/4] of Table I",
         .end = ZERO_OVERLAP,
         .input = FROM_BETA,
         .each = published_beta_each,
         .chain = published_beta_chain},
        {.setting = "Müller & Pöschel [1/4]",
         .end = ZERO_FORCE,
         .input = FROM_BETA,
         .each = mueller_poeschel_beta_each,
         .chain = mueller_poeschel_beta_chain},
        {.setting = "simple theory (27)",
         .end = ZERO_OVERLAP,
         .input = FROM_BETA,
         .each = simple_beta_each,
         .chain = simple_beta_chain},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct method method = rows[i];
        method.curve = "published";
        methods_add(methods, &method);
    }
}
