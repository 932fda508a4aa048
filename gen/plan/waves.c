/* SPDX-License-Identifier: MIT */
#include "plan/waves.h"

#include <math.h>

#include "enclosure/wave_factor.h"
#include "plan/plan.h"

/* J(nu) with an error of about one unit of the last place */
static double wave_factor_of(double nu)
{
    acb_t tau, j;
    acb_init(tau);
    acb_init(j);
    acb_set_d(tau, sqrt(1 - 2 * nu));
    wave_factor(j, tau, 64);
    const double value = arf_get_d(arb_midref(acb_realref(j)), ARF_RND_NEAR);
    acb_clear(tau);
    acb_clear(j);
    return value;
}

static double number_of(const struct embed_request *scene, enum embed_number which, int body)
{
    return fmpq_get_d(embed_number_of_body(scene, which, body)->value);
}

double plan_wave_loss(const struct embed_request *scene, double speed)
{
    if (!scene->wall || embed_given(scene, EMBED_G_STAR) || !embed_given(scene, EMBED_YOUNG))
        return (double)NAN;
    const double pi = acos(-1), radius = number_of(scene, EMBED_RADIUS, 1), volume = 4 * pi / 3 * pow(radius, 3);
    const double mass =
        embed_mass_is_given(scene, 1) ? number_of(scene, EMBED_MASS, 1) : volume * number_of(scene, EMBED_DENSITY, 1);
    double compliance = 0;
    for (int body = 1; body <= 2; body++) {
        const double nu = number_of(scene, EMBED_POISSON, body);
        compliance += (1 - nu * nu) / number_of(scene, EMBED_YOUNG, body);
    }
    const double stiffness = 4 * sqrt(radius) / (3 * compliance); /* N/m^(3/2) */

    /* The half-space radiates J/(2 pi rho c_s^3) int F'^2 dt; C_1 of x'' + beta x x' + x^(3/2) = 0 */
    const double nu = number_of(scene, EMBED_POISSON, 2), density = mass / volume;
    const double shear_speed = sqrt(number_of(scene, EMBED_YOUNG, 2) / (2 * (1 + nu) * density));
    const double kappa = wave_factor_of(nu) / (2 * pi * density * pow(shear_speed, 3));
    const double beta = 2.25 * kappa * pow(stiffness, 1.2) * pow(mass, -0.2) * pow(speed, 0.6);
    const double c_1 = -0.8 * pow(1.25, 0.8) * tgamma(0.8) * tgamma(1.5) / tgamma(2.3);
    return fmin(-2 * c_1 * beta, 1);
}

char *plan_wave_remark(const struct embed_request *scene, double speed, double eps)
{
    const double waves = plan_wave_loss(scene, speed), all = (1 - eps) * (1 + eps);
    if (isnan(waves))
        return NULL;
    return plan_text("Elastic waves alone: 1 - eps^2 = %.2g at %.4g m/s, to first order, if the wall is massive and as "
                     "dense as the\n"
                     "sphere; with this dissipation time it is %.2g. %s\n",
                     waves, speed, all,
                     waves < all ? "A measured dissipation time includes the waves."
                                 : "The waves take more: the dissipation time is too small.");
}
