/* SPDX-License-Identifier: MIT */
/* An elastic disk against a hard wall: a slow one, how long it touches, how far it is compressed, what it loses to its
 * modes; a faster one, what it loses to all modes, and one collision with some modes in full. */
#include <cor/cor.h>
#include <math.h>
#include <stdio.h>

int main(void)
{
    const enum cor_disk_datum datum = COR_DISK_DATUM_CENTRE_OF_MASS;
    printf("   speed  contact time  compression       eps  modes\n");
    for (int i = -6; i <= -2; i++) {
        const double speed = pow(10, i); /* in sqrt(E/rho), lengths in R */
        struct cor_disk_rayleigh r;
        size_t modes;
        const int status = cor_disk_rayleigh_tolerance(&cor_disk_modes_nu033, datum, speed, 1e-3, &r, &modes);
        if (status != COR_OK)
            return fprintf(stderr, "%s\n", cor_status_text(status)), 1;
        printf("%8.0e  %12.6f  %11.4e  %.6f  %5zu\n", speed, r.contact_time,
               cor_disk_max_compression(speed, 0.33, datum), sqrt(1 - r.fraction - r.tail), modes);
    }
    printf("\n   speed  eps, all modes, hard wall  eps, 940 modes, alpha = 500\n");
    for (int i = 1; i <= 3; i++) {
        const double speed = i / 10.0;
        const struct cor_disk_collision_options options = {.alpha = 500, .tolerance = 1e-6};
        struct cor_disk_collision c;
        const int status = cor_disk_collision(&cor_disk_modes_nu033, 940, &options, speed, &c);
        if (status != COR_OK)
            return fprintf(stderr, "%s\n", cor_status_text(status)), 1;
        printf("%8.1f           %.4f +- %.4f  %27.6f\n", speed, cor_disk_eps(speed, 0.33),
               cor_disk_eps_uncertainty(speed, 0.33), c.eps);
    }
    return 0;
}
