/* SPDX-License-Identifier: MIT */
/* Two glass spheres of 1 cm diameter: eps from 1 cm/s to 1 m/s. */
#include <cor/cor.h>
#include <stdio.h>

int main(void)
{
    struct cor_body glass = {.young_modulus_pa = 70e9, .poisson_ratio = 0.22, .radius_m = 5e-3};
    glass.dissipation_time_s = 0.4e-6;
    glass.mass_kg = cor_sphere_mass_kg(glass.radius_m, 2500);
    struct cor_sphere_contact contact;
    const int status = cor_sphere_contact_init(&contact, &glass, &glass);
    if (status != COR_OK)
        return fprintf(stderr, "%s\n", cor_status_text(status)), 1;
    for (double speed = 0.01; speed < 1.01; speed *= 10)
        printf("%5.2f m/s: eps = %.6f\n", speed, cor_contact_eps_zero_force(&contact, speed));
    return 0;
}
