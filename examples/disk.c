/* SPDX-License-Identifier: MIT */
/* Elastic disks against a rigid wall. Slow disks: contact time, compression, eps without the reaction of the vibrations
 * on the contact (first order), and eps with all modes. Faster disks: eps with all modes, and with some modes at a
 * softer wall. */
#include <cor/disk.h>
#include <cor/status.h>
#include <math.h>
#include <stdio.h>

int main(void)
{
    const enum cor_disk_datum datum = COR_DISK_DATUM_CENTRE_OF_MASS;
    printf("   speed  contact time  compression  eps, first order  modes  eps, all modes\n");
    for (int i = -6; i <= -2; i++) {
        const double speed = pow(10, i); /* in units of sqrt(E/rho); lengths in units of R */
        struct cor_disk_rayleigh r;
        size_t modes;
        const int status = cor_disk_rayleigh_tolerance(&cor_disk_modes_nu033, datum, speed, 1e-3, &r, &modes);
        if (status != COR_OK)
            return fprintf(stderr, "%s\n", cor_status_text(status)), 1;
        printf("%8.0e  %12.6f  %11.4e  %16.6f  %5zu  ", speed, r.contact_time,
               cor_disk_max_compression(speed, 0.33, datum), sqrt(1 - r.fraction - r.tail), modes);
        if (speed >= COR_DISK_EPS_MIN_SPEED) {
            printf("%.6f +- %.0e\n", cor_disk_eps(speed, 0.33), cor_disk_eps_uncertainty(speed, 0.33));
        } else { /* beyond the table: computes the collision */
            const struct cor_disk_hard_wall_options options = {.tolerance = 1e-5};
            struct cor_disk_hard_wall wall;
            const int solved = cor_disk_hard_wall_nu(0.33, &options, speed, &wall);
            if (solved != COR_OK)
                return fprintf(stderr, "%s\n", cor_status_text(solved)), 1;
            printf("%.6f +- %.0e\n", wall.eps, wall.error_estimate / (2 * wall.eps));
        }
    }
    printf("First order: the vibrations do not push back on the contact. It is approached slowly.\n");
    printf("\n   speed   eps, all modes, rigid wall  eps, 940 modes, alpha = 500\n");
    for (int i = 1; i <= 3; i++) {
        const double speed = i / 10.0;
        const struct cor_disk_collision_options options = {.alpha = 500, .tolerance = 1e-6};
        struct cor_disk_collision c;
        const int status = cor_disk_collision(&cor_disk_modes_nu033, 940, &options, speed, &c);
        if (status != COR_OK)
            return fprintf(stderr, "%s\n", cor_status_text(status)), 1;
        printf("%8.1f        %.6f +- %.6f  %27.6f\n", speed, cor_disk_eps(speed, 0.33),
               cor_disk_eps_uncertainty(speed, 0.33), c.eps);
    }
    return 0;
}
