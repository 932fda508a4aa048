/* SPDX-License-Identifier: MIT */
#include "plan/plan.h"

#include <math.h>
#include <stdlib.h>

#include "support/console.h"

/* ---- a constant force ---- */

enum { SCAN = 200, BISECTIONS = 30 };

/* Whether the force changes eps by less than the tolerance; a collision that cannot be solved counts as changed. */
static bool may_go(const struct cor_scene_contact *pressed, int end, double tolerance, double speed)
{
    struct cor_scene_contact without_force = *pressed;
    double with, without;
    without_force.force_n = 0;
    return cor_scene_eps(&with, pressed, speed, end) == COR_FAULT_NONE &&
           cor_scene_eps(&without, &without_force, speed, end) == COR_FAULT_NONE &&
           fabs(with / without - 1) <= tolerance;
}

char *plan_pressing_remark(const struct cor_scene_contact *contact, int end, double speed_min, double speed_max,
                           double tolerance)
{
    const double ratio = pow(speed_min / speed_max, 1.0 / (double)SCAN);
    const double sticking = cor_scene_sticking_speed(contact, end);
    char *where;
    int k = 0;
    while (k <= SCAN && may_go(contact, end, tolerance, speed_max * pow(ratio, k)))
        k++;
    if (k == 0) {
        where = xprintf("at no speed of this range up to its end");
    } else if (k > SCAN) {
        where = xprintf("at every speed of this range");
    } else {
        double low = speed_max * pow(ratio, k), high = low / ratio;
        for (int i = 0; i < BISECTIONS; i++) {
            const double middle = sqrt(low * high);
            *(may_go(contact, end, tolerance, middle) ? &high : &low) = middle;
        }
        where = xprintf("from %.4g m/s up", high);
    }
    char *text = xprintf("The constant force of %.4g N may be left out %s: eps then changes by less than %g.\n"
                         "With it the bodies stick up to %.4g m/s. The models leave it out.\n",
                         contact->force_n, where, tolerance, sticking);
    free(where);
    return text;
}

/* ---- waves ---- */

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
