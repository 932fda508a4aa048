/* SPDX-License-Identifier: MIT */
/* The functions of laws, for arrays. They call scalar functions, because the module lacks the loops of libcor. */
#include "cor/law.h"
#include "web/web.h"

static const struct {
    const char *name;
    double (*function)(double beta, double elastic_exponent);
} hunt_crossley[] = {{"duration", cor_hunt_crossley_duration},
                     {"duration_approach_only", cor_hunt_crossley_duration_approach_only},
                     {"max_overlap", cor_hunt_crossley_max_overlap},
                     {"time_of_max_overlap", cor_hunt_crossley_time_of_max_overlap}};

/* Returns name i of the list 0 (laws), 1 (ends), 2 (quantities) or 3 (functions of Hunt and Crossley's law with an
 * exponent), or NULL after the last one. */
WEB_EXPORT(web_name) const char *web_name(int list, int i)
{
    switch (list) {
    case 0:
        return cor_law_name((enum cor_law)i);
    case 1:
        return cor_end_name((enum cor_end)i);
    case 2:
        return cor_quantity_name((enum cor_quantity)i);
    default:
        return (size_t)i < sizeof hunt_crossley / sizeof *hunt_crossley ? hunt_crossley[i].name : NULL;
    }
}

WEB_EXPORT(web_law) void web_law(int law, int end, int quantity, const double *x, double *y, size_t n)
{
    for (size_t k = 0; k < n; k++)
        y[k] = cor_law_value((enum cor_law)law, (enum cor_end)end, (enum cor_quantity)quantity, x[k]);
}

/* Writes the domain and the bound on the error. Returns 0 if the law has no such function. */
WEB_EXPORT(web_law_function) int web_law_function(int law, int end, int quantity, double y[3])
{
    const struct cor_law_function *const f =
        cor_law_function((enum cor_law)law, (enum cor_end)end, (enum cor_quantity)quantity);
    if (f) {
        y[0] = f->least;
        y[1] = f->largest;
        y[2] = f->max_ulp;
    }
    return f != NULL;
}

WEB_EXPORT(web_hunt_crossley)
void web_hunt_crossley(int i, const double *x, double *y, size_t n, double elastic_exponent)
{
    for (size_t k = 0; k < n; k++)
        y[k] = hunt_crossley[i].function(x[k], elastic_exponent);
}
