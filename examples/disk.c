/* SPDX-License-Identifier: MIT */
/* A slow elastic disk against a hard wall: how long it touches, how far it is compressed, what it loses to its modes. */
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
    return 0;
}
