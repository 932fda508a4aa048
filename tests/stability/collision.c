/* SPDX-License-Identifier: MIT */
/* Full dynamics of the disk where steps resonate, contacts never end, or the motion is chaotic, against
 * tests/unit/reference_collision.c: Taylor series in time and another quadrature. */
#include "stability.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#include <cor/disk.h>
#include <cor/status.h>

#include "reference_collision.h"

/* The error where something is missing that the errors of other points could be compared with */
static const double none = 1e9;

static int disk_collide(const struct cor_disk_modes *modes, size_t n, double alpha, double v, double tolerance,
                        size_t max_steps, struct cor_disk_collision *out)
{
    const struct cor_disk_collision_options options = {alpha, tolerance, 0, max_steps};
    return cor_disk_collision(modes, n, &options, v, out);
}

/* A collision against its eps: in units of the tolerance where the status is COR_OK, and else of error_estimate */
static void take_collision(struct outcome *out, const struct cor_disk_modes *modes, size_t n, double alpha, double v,
                           double tolerance, size_t max_steps, double eps)
{
    struct cor_disk_collision c;
    char input[160], x[40], y[40];
    const int status = disk_collide(modes, n, alpha, v, tolerance, max_steps, &c);
    const double error = status == COR_OK                      ? fabs(c.eps - eps) / tolerance
                         : status == COR_TOLERANCE_NOT_REACHED ? fabs(c.eps - eps) / c.error_estimate
                                                               : none;
    snprintf(input, sizeof input, "nu = %g, %zu modes to omega = %.3g, alpha = %g, v = %g, tolerance %g: %s", modes->nu,
             n, modes->mode[n - 1].omega, alpha, v, tolerance,
             status == COR_OK ? "COR_OK" : "COR_TOLERANCE_NOT_REACHED");
    snprintf(x, sizeof x, "%.12f", eps);
    snprintf(y, sizeof y, "%.12f", c.eps);
    outcome_take(out, isnan(error) ? none : error, input, x, y);
}

/* eps by the reference to `needed`; NaN, and a point of the case, where it fails */
static double reference_eps(struct outcome *out, const struct cor_disk_modes *modes, size_t n, double alpha, double v,
                            double needed)
{
    struct reference_collision r;
    if (reference_disk_collision(modes->mode, n, alpha, v, needed, &r, NULL, NULL) == 0)
        return r.eps;
    outcome_take(out, none, "reference", "a number", "none");
    return (double)NAN;
}

/* ---- resonance ---- */

/* The four lowest modes of a table and its modes of n = 0 */
static size_t fast_radial(struct cor_disk_mode *mode, const struct cor_disk_modes *table)
{
    size_t n = 0;
    for (size_t i = 0; i < table->count; i++)
        if (i < 4 || table->mode[i].n == 0)
            mode[n++] = table->mode[i];
    return n;
}

static void resonance(struct outcome *out, bool full)
{
    static const double alpha[] = {200, 2000, 70, 500, 1000, 4000}, tolerance[] = {1e-2, 1e-4, 1e-6, 1e-8, 1e-11};
    for (int k = 0; k < 2; k++) {
        const struct cor_disk_modes *const table = k ? &cor_disk_modes_nu090 : &cor_disk_modes_nu033;
        struct cor_disk_mode mode[100];
        const size_t most = fast_radial(mode, table);
        const struct cor_disk_modes modes = {table->nu, most, mode};
        for (size_t j = 0; j < (full ? sizeof alpha / sizeof *alpha : 2); j++)
            for (size_t n = full ? 5 : most; n <= most; n++) {
                const double eps = reference_eps(out, &modes, n, alpha[j], 0.1, 1e-13);
                for (size_t i = 0; i < sizeof tolerance / sizeof *tolerance; i++)
                    take_collision(out, &modes, n, alpha[j], 0.1, tolerance[i], 0, eps);
            }
    }
}

/* ---- slow ---- */

static void slow_collision(struct outcome *out, bool full)
{
    (void)full;
    static const double alpha[] = {40, 500, 1e5}, speed[] = {1e-12, 1e-300, 0x1p-1074};
    for (size_t i = 0; i < 3; i++)
        for (size_t j = 0; j < 3; j++)
            for (size_t n = 1; n <= 10; n += 9) {
                struct cor_disk_collision c = {0};
                const int status = disk_collide(&cor_disk_modes_nu033, n, alpha[i], speed[j], 1e-8, 0, &c);
                char input[160];
                snprintf(input, sizeof input, "alpha = %g, v = %g, %zu modes", alpha[i], speed[j], n);
                outcome_take(out, status == COR_CONTACT_NOT_ENDED && isnan(c.eps) && isnan(c.one_minus_eps2) ? 0 : 1,
                             input, cor_status_text(COR_CONTACT_NOT_ENDED), cor_status_text(status));
            }
}

/* ---- chaos ---- */

/* The scene of DISKS 4. eps moves by 1e-3 with every choice of steps and angles. */
static const double chaotic_eps = 0.838427764576;

static void chaotic(struct outcome *out, bool full)
{
    static const double tolerance[] = {1e-2, 1e-3, 1e-8};
    for (size_t i = 0; i < sizeof tolerance / sizeof *tolerance; i++)
        take_collision(out, &cor_disk_modes_nu033, 940, 2000, 0.3, tolerance[i], full ? 0 : 20000, chaotic_eps);
}

/* Few modes at a hard wall bounce: 1e4 to 1e6 times an ulp of the speed. `eps` is by reference_disk_collision, to
 * 1e-11; the full form asks it again. */
static void bounces(struct outcome *out, bool full)
{
    static const struct {
        size_t n;
        double alpha, v, eps;
    } scene[] = {{30, 8000, 0.3, 0.799369796954}, {60, 2000, 0.1, 0.928625468805}, {100, 4000, 0.05, 0.967425680918}};
    static const double tolerance[] = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7};
    const struct cor_disk_modes *const modes = &cor_disk_modes_nu033;
    for (size_t i = 0; i < sizeof scene / sizeof *scene; i++) {
        const size_t n = scene[i].n;
        if (full) {
            const double eps = reference_eps(out, modes, n, scene[i].alpha, scene[i].v, 1e-11);
            outcome_take(out, fabs(eps - scene[i].eps) <= 1e-10 ? 0 : none, "the number that stands for the reference",
                         "", "");
        }
        for (size_t k = 0; k < (full ? sizeof tolerance / sizeof *tolerance : 3); k++)
            take_collision(out, modes, n, scene[i].alpha, scene[i].v, tolerance[k], 0, scene[i].eps);
    }
}

static const struct hard_case collision_cases[] = {
    {"v = 1e-12", "a contact of 10^9 time units is integrated, or reported as COR_OK",
     "full dynamics, 1e-12 and smaller, alpha 40 to 1e5", "COR_CONTACT_NOT_ENDED, at once", "wrong answers", 0,
     slow_collision},
    {"resonance of fast n = 0 modes with the step", "omega h near a multiple of pi feeds energy into a mode",
     "the four lowest modes and all of n = 0 to omega = 62 (nu = 0.33, 0.9), alpha = 200, 2000, tolerances 1e-2 to "
     "1e-11 (full: 70 to 4000, every number of modes)",
     "Taylor series in time, in long double or quad precision",
     "of the tolerance, or of error_estimate where not COR_OK", 1, resonance},
    {"the chaotic case", "error_estimate is smaller than the error",
     "940 modes, alpha = 2000, v = 0.3, tolerances 1e-2, 1e-3 and 1e-8", "runs with other steps and angles",
     "of the tolerance, or of error_estimate where not COR_OK", 1, chaotic},
    {"the chaotic case", "runs agree by chance and COR_OK is wrong",
     "few modes at a hard wall: 30, alpha = 8000, v = 0.3; 60, 2000, 0.1; 100, 4000, 0.05; tolerances 1e-3 to 1e-5 "
     "(full: "
     "to 1e-7)",
     "Taylor series in time, in long double or quad precision (full: run again)",
     "of the tolerance, or of error_estimate where not COR_OK", 1, bounces},
};

const struct case_list stability_collision = {collision_cases, sizeof collision_cases / sizeof *collision_cases};
