/* SPDX-License-Identifier: MIT */
#include "truth.h"

#include <math.h>
#include <stdio.h>

#include "reference_ode.h"

static void reference(long double beta, long double *zero_overlap, long double *zero_force)
{
    const struct reference r = reference_collision(beta);
    *zero_overlap = r.eps_zero_overlap;
    *zero_force = r.eps_zero_force;
}

void truth_compute(struct truth *truth, const struct scene *scene)
{
    scene_even_speeds(scene, truth->in[FROM_SPEED], CHECKED);
    for (int i = 0; i < CHECKED; i++) {
        const long double beta = scene->contact.beta_per_root * powl((long double)truth->in[FROM_SPEED][i], 0.2L);
        truth->in[FROM_BETA][i] = (double)beta;
        reference(beta, &truth->eps[FROM_SPEED][ZERO_OVERLAP][i], &truth->eps[FROM_SPEED][ZERO_FORCE][i]);
        reference((long double)(double)beta, &truth->eps[FROM_BETA][ZERO_OVERLAP][i],
                  &truth->eps[FROM_BETA][ZERO_FORCE][i]);
    }
}

/* Of a float that is given, against the library's double, which is as good as exact beside it */
static double worst_error_of_float(const struct truth *truth, const struct scene *scene, const struct method *method)
{
    static float in[CHECKED], eps[CHECKED];
    for (int i = 0; i < CHECKED; i++)
        in[i] = (float)truth->in[method->input][i];
    method->each(method, scene, (const double *)(const void *)in, (double *)(void *)eps, CHECKED);
    double worst = 0;
    for (int i = 0; i < CHECKED && !isnan(worst); i++) {
        const double beta =
            method->input == FROM_BETA ? (double)in[i] : cor_contact_beta(&scene->contact, (double)in[i]);
        const double exact =
            method->end == ZERO_FORCE ? cor_sphere_eps_zero_force(beta) : cor_sphere_eps_zero_overlap(beta);
        const double error = fabs(((double)eps[i] - exact) / exact);
        if (!(error <= worst))
            worst = error;
    }
    return worst;
}

double truth_worst_error(const struct truth *truth, const struct scene *scene, const struct method *method)
{
    if (method->end == NO_END)
        return NAN;
    if (method->flags & FLOAT)
        return worst_error_of_float(truth, scene, method);
    static double eps[CHECKED];
    method->each(method, scene, truth->in[method->input], eps, CHECKED);
    const long double *const exact = truth->eps[method->input][method->end];
    double worst = 0;
    for (int i = 0; i < CHECKED; i++) {
        const double error = fabs((double)(((long double)eps[i] - exact[i]) / exact[i]));
        if (!(error <= worst)) /* a NaN too */
            worst = error;
        if (isnan(error))
            break;
    }
    return worst;
}

void truth_print_formulas(void)
{
    static const double betas[] = {0.5, 1, 2, 3};
    enum { BETAS = sizeof betas / sizeof *betas };
    static const struct {
        const char *name;
        double (*eps)(double);
        enum end end;
    } formulas[] = {
        {"published Pade (35)", cor_sphere_eps_published_pade, ZERO_OVERLAP},
        {"simple theory (27)", cor_sphere_eps_simple, ZERO_OVERLAP},
        {"cor zero overlap", cor_sphere_eps_zero_overlap, ZERO_OVERLAP},
        {"cor zero force", cor_sphere_eps_zero_force, ZERO_FORCE},
    };
    printf("%-46s", "relative error of eps at beta");
    for (int k = 0; k < BETAS; k++)
        printf(" %11g", betas[k]);
    printf("\n");
    for (size_t i = 0; i < sizeof formulas / sizeof *formulas; i++) {
        printf("%-46s", formulas[i].name);
        for (int k = 0; k < BETAS; k++) {
            long double exact[2];
            reference((long double)betas[k], &exact[ZERO_OVERLAP], &exact[ZERO_FORCE]);
            const double eps = formulas[i].eps(betas[k]);
            printf(" %+11.1e", (double)(((long double)eps - exact[formulas[i].end]) / exact[formulas[i].end]));
        }
        printf("\n");
    }
    printf("\n");
}
