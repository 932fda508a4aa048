/* SPDX-License-Identifier: MIT */
/* The functions of libcor of one number, for arrays. They are loops over scalar functions: libcor's own loops hold the
 * tables of all float functions, too, which the module need not carry. */
#include <math.h>

#include "cor/hertz_dashpot.h"
#include "cor/law.h"
#include "cor/sphere.h"
#include "web/web.h"

#define BOTH(f, group, name) f(group, name##_zero_overlap) f(group, name##_zero_force)
#define FOUR(f, group, name) BOTH(f, group, name) f(group, name##_limited) f(group, name##_approach_only)
#define WITH_APPROACH(f, group, name) BOTH(f, group, name) f(group, name##_approach_only)
#define ONE(f, group, name) f(group, name) f(group, name##_approach_only)
#define SPHERES(f, group)                                                                                              \
    WITH_APPROACH(f, group, eps)                                                                                       \
    WITH_APPROACH(f, group, loss)                                                                                      \
    WITH_APPROACH(f, group, beta)                                                                                      \
    f(group, beta_of_loss_approach_only) WITH_APPROACH(f, group, duration) f(group, max_overlap)                       \
        f(group, time_of_max_overlap)
#define RATIOS(f, group)                                                                                               \
    FOUR(f, group, eps)                                                                                                \
    FOUR(f, group, loss)                                                                                               \
    FOUR(f, group, zeta)                                                                                               \
    FOUR(f, group, zeta_of_loss) FOUR(f, group, duration) f(group, max_overlap) f(group, time_of_max_overlap)
#define CROSSLEYS(f)                                                                                                   \
    ONE(f, hunt_crossley, eps)                                                                                         \
    ONE(f, hunt_crossley, loss) ONE(f, hunt_crossley, beta) ONE(f, hunt_crossley, beta_of_loss)

#define ROW(group, name) {#group "." #name, cor_##group##_##name},
static const struct {
    const char *name;
    double (*function)(double x);
} functions[] = {SPHERES(ROW, sphere) SPHERES(ROW, hertz_dashpot) BOTH(ROW, hertz_dashpot, beta_of_loss)
                     RATIOS(ROW, linear) RATIOS(ROW, tsuji) CROSSLEYS(ROW)};
enum { FUNCTIONS = sizeof functions / sizeof *functions };

/* of beta and of the elastic exponent */
static const struct {
    const char *name;
    double (*function)(double beta, double exponent);
} with_exponent[] = {ONE(ROW, hunt_crossley, duration) ROW(hunt_crossley, max_overlap)
                         ROW(hunt_crossley, time_of_max_overlap)};
enum { WITH_EXPONENT = sizeof with_exponent / sizeof *with_exponent };

/* "sphere.eps_zero_force", ...; those with an exponent come last, from web_functions_with_exponent on; NULL: no more */
WEB_EXPORT(web_function_name) const char *web_function_name(int i)
{
    return i < FUNCTIONS ? functions[i].name : i < FUNCTIONS + WITH_EXPONENT ? with_exponent[i - FUNCTIONS].name : NULL;
}

WEB_EXPORT(web_functions_with_exponent) int web_functions_with_exponent(void)
{
    return FUNCTIONS;
}

WEB_EXPORT(web_map) void web_map(int i, const double *x, double *y, size_t n, double exponent)
{
    for (size_t k = 0; k < n; k++)
        y[k] = i < FUNCTIONS ? functions[i].function(x[k]) : with_exponent[i - FUNCTIONS].function(x[k], exponent);
}
