/* SPDX-License-Identifier: MIT */
/* Not in the paper: energy left in the modes at small speed, from the full dynamics, against Rayleigh's curve. */
#include <math.h>

#include "collisions.h"
#include "cor/status.h"
#include "limit.h"
#include "report.h"
#include "rigid.h"

#define UNCERTAIN 0.06 /* of a limit, above which none is given */

/* Of a series of values: the places of the highest maximum and of the lowest minimum inside it */
static void extremes(const double *value, int n, int *top, int *bottom)
{
    *top = *bottom = 0;
    for (int i = 1; i < n - 1; i++) {
        if (value[i] >= value[i - 1] && value[i] > value[i + 1] && (*top == 0 || value[i] > value[*top]))
            *top = i;
        if (value[i] <= value[i - 1] && value[i] < value[i + 1] && (*bottom == 0 || value[i] < value[*bottom]))
            *bottom = i;
    }
}

static int write_oscillation(FILE *csv, char verdict[VERDICT_SIZE])
{
    static struct limit limit[SLOW_SPEEDS];
    static double dynamic[SLOW_SPEEDS], rayleigh[SLOW_SPEEDS];
    int known_from = SLOW_SPEEDS;
    double known_to = 0;
    for (int i = SLOW_SPEEDS - 1; i >= 0; i--) {
        limit[i] = limit_of(0.33, slow_speed(i));
        const double uncertain = limit[i].uncertainty / limit[i].one_minus_eps2;
        if (i + 1 == known_from && uncertain <= UNCERTAIN) {
            known_from = i;
            known_to = fmax(known_to, uncertain);
        }
    }
    fputs("speed,one_minus_eps2,low,high,modes_940,modes_1300,modes_1800,rayleigh\n", csv);
    for (int i = 0; i < SLOW_SPEEDS; i++) {
        const double v = slow_speed(i);
        struct cor_disk_rayleigh out;
        const int status = cor_disk_rayleigh(&cor_disk_modes_nu033, 1800, COR_DISK_DATUM_CENTRE_OF_MASS, v, &out, NULL);
        if (status != COR_OK && status != COR_BEYOND_THEORY) {
            fprintf(stderr, "cor_paper: %s\n", cor_status_text(status));
            return 0;
        }
        dynamic[i] = wall_line(0.33, size[SIZES - 1], v, 0, WALLS - 1).at_zero;
        rayleigh[i] = out.fraction + out.tail;
        fprintf(csv, "%g", v);
        write_cell(csv, i < known_from ? NAN : limit[i].one_minus_eps2);
        write_cell(csv, i < known_from ? NAN : limit[i].one_minus_eps2 - limit[i].uncertainty);
        write_cell(csv, i < known_from ? NAN : limit[i].one_minus_eps2 + limit[i].uncertainty);
        for (int n = LARGE_FROM; n < SIZES; n++)
            write_cell(csv, wall_line(0.33, size[n], v, 0, WALLS - 1).at_zero);
        write_cell(csv, rayleigh[i]);
        fputs("\n", csv);
    }
    int top, bottom, rayleigh_top, rayleigh_bottom;
    extremes(dynamic, SLOW_SPEEDS, &top, &bottom);
    extremes(rayleigh, SLOW_SPEEDS, &rayleigh_top, &rayleigh_bottom);
    snprintf(
        verdict, VERDICT_SIZE,
        "1 - eps^2 does not fall steadily with v, in the full dynamics either. At nu = 0.33, with %d modes and a "
        "hard wall, it falls from a maximum of %.4f at v = %.2g by %.0f %% to a minimum at v = %.2g. Then it rises "
        "again. Rayleigh's curve, with the centre of mass, falls from %.4f at v = %.2g by %.0f %% to v = %.2g. It "
        "is as high, but at half the speed, and much deeper. From v = %.2g on extrapolations know the limit to %.0f "
        "%%, and are drawn. At smaller speeds the contact is too narrow for 1800 modes, and N = 940, 1300 and 1800, "
        "drawn for all, do not yet form a line. The black line is the limit itself, all modes at a rigid wall: %.5f "
        "at v = 0.0023, %.5f at 0.015.",
        size[SIZES - 1], dynamic[top], slow_speed(top), 100 * (1 - dynamic[bottom] / dynamic[top]), slow_speed(bottom),
        rayleigh[rayleigh_top], slow_speed(rayleigh_top),
        100 * (1 - rayleigh[rayleigh_bottom] / rayleigh[rayleigh_top]), slow_speed(rayleigh_bottom),
        slow_speed(known_from), 100 * known_to, rigid_wall(0.33, 0.0023, RIGID_TOLERANCE).one_minus_eps2,
        rigid_wall(0.33, 0.015, RIGID_TOLERANCE).one_minus_eps2);
    return 1;
}

const struct figure oscillation_figure = {"oscillation", "Beyond the paper", "1 - eps^2 at small speed",
                                          write_oscillation};
