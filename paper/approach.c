/* SPDX-License-Identifier: MIT */
/* Not in the paper: how Rayleigh's theory is approached as the speed falls, down to v = 1e-300. */
#include <math.h>

#include "cor/status.h"
#include "report.h"
#include "rigid.h"

#define FIRST_POWER 3.0 /* v = 10^-3 to 10^-300: the phases of the modes go like sqrt(ln(1/v)) */
#define LAST_POWER 300.0
enum { POINTS = 64 };

/* Ranges of -log10(v), of which the differences are told */
enum { RANGES = 4 };
static const double range_end[RANGES] = {10, 30, 100, LAST_POWER};

static int write_approach(FILE *csv, char verdict[VERDICT_SIZE])
{
    double difference[RANGES] = {0}, whole[RANGES] = {0};
    fputs("power,one_minus_eps2,rayleigh,ratio\n", csv);
    for (int i = 0, k = 0; i < POINTS; i++) {
        const double root = sqrt(FIRST_POWER) + (sqrt(LAST_POWER) - sqrt(FIRST_POWER)) * i / (POINTS - 1);
        const double power = i < POINTS - 1 ? root * root : LAST_POWER, speed = pow(10, -power);
        const struct cor_disk_hard_wall out = rigid_wall(0.33, speed, RIGID_TOLERANCE);
        struct cor_disk_rayleigh theory;
        const int status =
            cor_disk_rayleigh(&cor_disk_modes_nu033, 1800, COR_DISK_DATUM_CENTRE_OF_MASS, speed, &theory, NULL);
        if (status != COR_OK) {
            fprintf(stderr, "cor_paper: %s\n", cor_status_text(status));
            return 0;
        }
        const double energy = theory.fraction + theory.tail;
        fprintf(csv, "%.4f,%.4g,%.4g,%.3f\n", power, out.one_minus_eps2, energy, out.one_minus_eps2 / energy);
        while (power > range_end[k])
            k++;
        /* both fall like 1/ln^2(1/v) beside their oscillation */
        difference[k] += pow(power * power * (out.one_minus_eps2 - energy), 2);
        whole[k] += pow(power * power * energy, 2);
    }
    double part[RANGES];
    for (int k = 0; k < RANGES; k++)
        part[k] = 100 * sqrt(difference[k] / whole[k]);
    snprintf(verdict, VERDICT_SIZE,
             "Rayleigh's theory, in which vibrations do not act back on the load, is approached slowly, about like "
             "1/sqrt(ln(1/v)). Its energy and that of all modes at a rigid wall (nu = 0.33, centre of mass) differ "
             "by %.0f %%, root mean square, from v = 1e-3 to 1e-10. Down to 1e-30 they differ by %.0f %%, down to "
             "1e-100 by %.0f %%, and down to 1e-300 by %.0f %%.",
             part[0], part[1], part[2], part[3]);
    return 1;
}

const struct figure approach_figure = {"approach", "Beyond the paper", "how Rayleigh's theory is approached",
                                       write_approach};
