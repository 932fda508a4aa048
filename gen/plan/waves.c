/* SPDX-License-Identifier: MIT */
#include "plan/waves.h"

#include <math.h>

#include "plan/plan.h"
#include "support/console.h"

double plan_wave_loss(const struct embed_request *request, double speed)
{
    struct cor_scene scene;
    struct cor_sphere_contact contact;
    if (!request->wall || embed_given(request, COR_SCENE_G_STAR) || !embed_given(request, COR_SCENE_YOUNG) ||
        embed_request_scene(&scene, request) != STATUS_OK)
        return (double)NAN;
    const struct cor_body sphere = cor_scene_body(&scene, 1), wall = cor_scene_body(&scene, 2);
    const struct cor_half_space half_space = {wall.young_modulus_pa, wall.poisson_ratio,
                                              sphere.mass_kg / cor_sphere_mass_kg(sphere.radius_m, 1)};
    cor_sphere_contact_init(&contact, &sphere, &wall);
    return cor_contact_wave_loss(&contact, &half_space, speed);
}

char *plan_wave_remark(const struct embed_request *request, double speed, double eps)
{
    const double waves = plan_wave_loss(request, speed), all = (1 - eps) * (1 + eps);
    if (isnan(waves))
        return NULL;
    return xprintf("Elastic waves alone: 1 - eps^2 = %.2g at %.4g m/s, to first order, if the wall is massive and as "
                   "dense as the\n"
                   "sphere; with this dissipation time it is %.2g. %s\n",
                   waves, speed, all,
                   waves < all ? "A measured dissipation time includes the waves."
                               : "The waves take more: the dissipation time is too small.");
}
