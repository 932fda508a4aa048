/* SPDX-License-Identifier: MIT */
/* Coefficients of the splittings, and the disk that all rivals integrate. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "collision_rivals.h"
#include "disk.h"

#define PI 3.14159265358979323846

/* Yoshida, Phys. Lett. A 150, 262 (1990): three Strang steps, the middle one backwards */
#define YOSHIDA_OUTER 1.3512071919596578
#define YOSHIDA_INNER (-1.7024143839193153)

/* Blanes and Moan, J. Comput. Appl. Math. 142, 313 (2002), tables 2 and 3 */
#define B6_1 0.0829844064174052
#define B6_2 0.396309801498368
#define B6_3 (-0.0390563049223486)
#define A6_1 0.245298957184271
#define A6_2 0.604872665711080
#define A6_3 (0.5 - (A6_1 + A6_2))

#define B11_1 0.0414649985182624
#define B11_2 0.198128671918067
#define B11_3 (-0.0400061921041533)
#define B11_4 0.0752539843015807
#define B11_5 (-0.0115113874206879)
#define B11_6 (0.5 - (B11_1 + B11_2 + B11_3 + B11_4 + B11_5))
#define A11_1 0.123229775946271
#define A11_2 0.290553797799558
#define A11_3 (-0.127049212625417)
#define A11_4 (-0.246331761062075)
#define A11_5 0.357208872795928
#define A11_6 (1 - 2 * (A11_1 + A11_2 + A11_3 + A11_4 + A11_5))

/* begins with free motion: a kick of nothing before it */
#define A14_1 0.0378593198406116
#define A14_2 0.102635633102435
#define A14_3 (-0.0258678882665587)
#define A14_4 0.314241403071447
#define A14_5 (-0.130144459517415)
#define A14_6 0.106417700369543
#define A14_7 (-0.00879424312851058)
#define A14_8 (1 - 2 * (A14_1 + A14_2 + A14_3 + A14_4 + A14_5 + A14_6 + A14_7))
#define B14_1 0.0917191526244616
#define B14_2 0.183983170005006
#define B14_3 (-0.0565343658328883)
#define B14_4 0.00491468877471285
#define B14_5 0.143761127168358
#define B14_6 0.328567693746804
#define B14_7 (0.5 - (B14_1 + B14_2 + B14_3 + B14_4 + B14_5 + B14_6))

const struct rival_splitting rival_splittings[RIVAL_SPLITTINGS] = {
    [RIVAL_STRANG] = {"Strang", 2, 1, {1}, {0.5, 0.5}},
    [RIVAL_YOSHIDA4] = {"Yoshida 4",
                        4,
                        3,
                        {YOSHIDA_OUTER, YOSHIDA_INNER, YOSHIDA_OUTER},
                        {YOSHIDA_OUTER / 2, (YOSHIDA_OUTER + YOSHIDA_INNER) / 2, (YOSHIDA_OUTER + YOSHIDA_INNER) / 2,
                         YOSHIDA_OUTER / 2}},
    [RIVAL_SRKN6_4] = {"SRKN 6-4",
                       4,
                       6,
                       {A6_1, A6_2, A6_3, A6_3, A6_2, A6_1},
                       {B6_1, B6_2, B6_3, 1 - 2 * (B6_1 + B6_2 + B6_3), B6_3, B6_2, B6_1}},
    [RIVAL_SRKN11_6] = {"SRKN 11-6",
                        6,
                        11,
                        {A11_1, A11_2, A11_3, A11_4, A11_5, A11_6, A11_5, A11_4, A11_3, A11_2, A11_1},
                        {B11_1, B11_2, B11_3, B11_4, B11_5, B11_6, B11_6, B11_5, B11_4, B11_3, B11_2, B11_1}},
    [RIVAL_SRKN14_6] = {"SRKN 14-6",
                        6,
                        15,
                        {A14_1, A14_2, A14_3, A14_4, A14_5, A14_6, A14_7, A14_8, A14_7, A14_6, A14_5, A14_4, A14_3,
                         A14_2, A14_1},
                        {0, B14_1, B14_2, B14_3, B14_4, B14_5, B14_6, B14_7, B14_7, B14_6, B14_5, B14_4, B14_3, B14_2,
                         B14_1, 0}},
};

static void fill_tables(struct rival_disk *d)
{
    const size_t entries = d->width * d->angles;
    d->cos_by_n = disk_memory(entries, sizeof *d->cos_by_n);
    d->sin_by_n = disk_memory(entries, sizeof *d->sin_by_n);
    d->cos_by_angle = disk_memory(entries, sizeof *d->cos_by_angle);
    d->sin_by_angle = disk_memory(entries, sizeof *d->sin_by_angle);
    d->cos_phi = disk_memory(d->angles, sizeof *d->cos_phi);
    for (size_t j = 0; j < d->angles; j++) {
        const double phi = ((double)j + 0.5) * PI / (2 * (double)d->angles);
        d->cos_phi[j] = cos(phi);
        for (size_t n = 0; n < d->ns; n++) {
            const double c = cos((double)n * phi) * cos(phi), s = sin((double)n * phi) * sin(phi);
            d->cos_by_n[n * d->angles + j] = d->cos_by_angle[j * d->width + n] = c;
            d->sin_by_n[n * d->angles + j] = d->sin_by_angle[j * d->width + n] = s;
        }
    }
}

void rival_disk_init(struct rival_disk *disk, const struct cor_disk_modes *modes, size_t n_modes, double alpha,
                     double speed, size_t angles, double wall_left)
{
    disk_must(angles % 4 == 0 && n_modes <= modes->count, "no such disk");
    *disk = (struct rival_disk){.modes = n_modes, .angles = angles, .alpha = alpha, .speed = speed};
    disk->wall_left = wall_left;
    disk->weight = PI / (double)angles;
    for (size_t i = 0; i < n_modes; i++)
        if ((size_t)modes->mode[i].n >= disk->ns)
            disk->ns = (size_t)modes->mode[i].n + 1;
    disk->width = (disk->ns + 3) / 4 * 4;
    disk->first = disk_memory(disk->width + 1, sizeof *disk->first);
    disk->omega = disk_memory(n_modes, sizeof *disk->omega);
    disk->c = disk_memory(n_modes, sizeof *disk->c);
    disk->s = disk_memory(n_modes, sizeof *disk->s);
    size_t at = 0;
    for (size_t n = 0; n < disk->width; n++) {
        disk->first[n] = at;
        for (size_t i = 0; i < n_modes; i++)
            if ((size_t)modes->mode[i].n == n) {
                disk->omega[at] = modes->mode[i].omega;
                disk->c[at] = modes->mode[i].c;
                disk->s[at++] = modes->mode[i].s;
            }
    }
    disk->first[disk->width] = at;
    fill_tables(disk);
}

void rival_disk_free(struct rival_disk *disk)
{
    free(disk->first);
    double *const arrays[] = {disk->omega,        disk->c,        disk->s,
                              disk->cos_by_n,     disk->sin_by_n, disk->cos_by_angle,
                              disk->sin_by_angle, disk->cos_phi};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
        free(arrays[i]);
}

double rival_negligible_load(const struct rival_disk *disk)
{
    return disk->wall_left * 0.5 * PI * disk->speed * disk->speed * disk->alpha;
}

/* a round disk has the load sqrt(2 pi/alpha) exp(alpha (x_0 + 1)) */
double rival_first_position(const struct rival_disk *disk)
{
    return -1 + log(rival_negligible_load(disk) * sqrt(disk->alpha / (2 * PI))) / disk->alpha;
}
