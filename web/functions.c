/* SPDX-License-Identifier: MIT */
/* The functions of the table of law.h, and those with an exponent, for arrays. They are loops over scalar functions, so
 * that the module need not contain libcor's own loops. */
#include <math.h>
#include <stdio.h>

#include "cor/law.h"
#include "web/web.h"

enum { MOST = 150, NAME = 64 };
static struct {
    char name[NAME];
    double (*function)(double x);
} functions[MOST];
static int count;

/* of beta and of the elastic exponent */
static const struct {
    const char *name;
    double (*function)(double beta, double exponent);
} with_exponent[] = {{"hunt_crossley.duration", cor_hunt_crossley_duration},
                     {"hunt_crossley.duration_approach_only", cor_hunt_crossley_duration_approach_only},
                     {"hunt_crossley.max_overlap", cor_hunt_crossley_max_overlap},
                     {"hunt_crossley.time_of_max_overlap", cor_hunt_crossley_time_of_max_overlap}};
enum { WITH_EXPONENT = sizeof with_exponent / sizeof *with_exponent };

/* Adds "linear.zeta_of_loss_limited", ...; a function of several ends once. */
static void add(int law, int end, int quantity)
{
    static const char *const groups[] = {"sphere", "linear", "tsuji", "hunt_crossley", "hertz_dashpot"},
                             *const ends[] = {"_zero_overlap", "_zero_force", "_limited", "_approach_only"};
    const struct cor_law_function *const f =
        cor_law_function((enum cor_law)law, (enum cor_end)end, (enum cor_quantity)quantity);
    const int is_ratio = law == COR_LAW_LINEAR || law == COR_LAW_TSUJI, is_crossley = law == COR_LAW_HUNT_CROSSLEY;
    const char *const names[] = {
        "eps",      "loss",        is_ratio ? "zeta" : "beta", is_ratio ? "zeta_of_loss" : "beta_of_loss",
        "duration", "max_overlap", "time_of_max_overlap"};
    const int of_all = quantity >= COR_MAX_OVERLAP || (is_crossley && end != COR_END_APPROACH_ONLY);
    if (!f || (of_all && end != COR_END_ZERO_OVERLAP) || (is_crossley && quantity >= COR_DURATION))
        return;
    snprintf(functions[count].name, NAME, "%s.%s%s", groups[law], names[quantity], of_all ? "" : ends[end]);
    functions[count++].function = f->value;
}

/* "sphere.eps_zero_force", ...; those with an exponent come last, from web_functions_with_exponent on; NULL: no more */
WEB_EXPORT(web_function_name) const char *web_function_name(int i)
{
    for (int law = count ? COR_LAWS : 0; law <= COR_LAW_HERTZ_DASHPOT; law++)
        for (int end = 0; end <= COR_END_APPROACH_ONLY; end++)
            for (int quantity = 0; quantity < COR_QUANTITIES; quantity++)
                add(law, end, quantity);
    return i < count ? functions[i].name : i < count + WITH_EXPONENT ? with_exponent[i - count].name : NULL;
}

WEB_EXPORT(web_functions_with_exponent) int web_functions_with_exponent(void)
{
    return count;
}

WEB_EXPORT(web_map) void web_map(int i, const double *x, double *y, size_t n, double exponent)
{
    for (size_t k = 0; k < n; k++)
        y[k] = i < count ? functions[i].function(x[k]) : with_exponent[i - count].function(x[k], exponent);
}
