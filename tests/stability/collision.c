/* SPDX-License-Identifier: MIT */
/* Full dynamics of the disk where steps resonate, contacts never end, or the motion is chaotic, against
 * tests/unit/reference_collision.c: another method, of order 16, and another quadrature. */
#include "stability.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#include <cor/disk.h>
#include <cor/status.h>

#include "reference_collision.h"

static int collide(const struct cor_disk_modes *modes, size_t n, double alpha, double v, double tolerance,
                   struct cor_disk_collision *out)
{
    const struct cor_disk_collision_options options = {alpha, tolerance, 0};
    return cor_disk_collision(modes, n, &options, v, out);
}

static void take_text(struct outcome *out, double error, const char *input, double reference, double value)
{
    char x[40], y[40];
    snprintf(x, sizeof x, "%.12f", reference);
    snprintf(y, sizeof y, "%.12f", value);
    take(out, error, input, x, y);
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
                struct reference_collision r;
                if (reference_disk_collision(mode, n, alpha[j], 0.1, 1e-15, 12, &r, NULL, NULL) != 0)
                    take(out, HUGE_VAL, "reference", "a number", "none");
                for (size_t i = 0; i < sizeof tolerance / sizeof *tolerance; i++) {
                    struct cor_disk_collision c;
                    char input[160];
                    const int status = collide(&modes, n, alpha[j], 0.1, tolerance[i], &c);
                    snprintf(input, sizeof input, "nu = %g, %zu modes to omega = %.3g, alpha = %g, tolerance %g",
                             table->nu, n, mode[n - 1].omega, alpha[j], tolerance[i]);
                    take_text(out, status == COR_OK ? fabs(c.eps - r.eps) / tolerance[i] : HUGE_VAL, input, r.eps,
                              c.eps);
                }
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
                const int status = collide(&cor_disk_modes_nu033, n, alpha[i], speed[j], 1e-8, &c);
                char input[160];
                snprintf(input, sizeof input, "alpha = %g, v = %g, %zu modes", alpha[i], speed[j], n);
                take(out, status == COR_CONTACT_NOT_ENDED && isnan(c.eps) && isnan(c.one_minus_eps2) ? 0 : 1, input,
                     cor_status_text(COR_CONTACT_NOT_ENDED), cor_status_text(status));
            }
}

/* ---- chaos ---- */

/* d eps/d ln v by runs that start ulps apart: the largest of some */
static double condition_of(size_t n, double alpha, double v, double tolerance, int runs, double eps)
{
    double largest = 0;
    for (int k = 1; k <= runs; k++) {
        struct cor_disk_collision c;
        const double near = moved(v, k % 2 ? k : -k);
        collide(&cor_disk_modes_nu033, n, alpha, near, tolerance, &c);
        largest = fmax(largest, fabs(c.eps - eps) / fabs(near / v - 1));
    }
    return largest;
}

/* The scene of DISKS 4: by reference_disk_collision(cor_disk_modes_nu033.mode, 940, 2000, 0.3, 1e-13, 24, ...), which
 * the full form runs; its digits beyond the third say how it rounded. */
static const double chaotic_eps = 0.838427764576;

static void chaotic(struct outcome *out, bool full)
{
    enum { MODES = 940 };
    const double alpha = 2000, v = 0.3, tolerance = full ? 1e-3 : 1e-2;
    struct cor_disk_collision c;
    struct reference_collision r = {.eps = chaotic_eps};
    if (full && reference_disk_collision(cor_disk_modes_nu033.mode, MODES, alpha, v, 1e-13, 24, &r, NULL, NULL) != 0)
        take(out, HUGE_VAL, "reference", "a number", "none");
    collide(&cor_disk_modes_nu033, MODES, alpha, v, tolerance, &c);
    out->condition = condition_of(MODES, alpha, v, tolerance, full ? 40 : 4, c.eps);
    const double allowed = tolerance + out->condition * 0x1p-50;
    /* a condition that is larger still would forgive everything */
    take_text(out, out->condition < 2e13 ? fabs(c.eps - r.eps) / allowed : HUGE_VAL,
              full ? "tolerance 1e-3" : "tolerance 1e-2", r.eps, c.eps);
    /* eight digits cannot be had, and COR_OK would be a lie */
    struct cor_disk_collision fine;
    const int status = full ? collide(&cor_disk_modes_nu033, MODES, alpha, v, 1e-8, &fine) : COR_TOLERANCE_NOT_REACHED;
    if (status != COR_TOLERANCE_NOT_REACHED)
        take(out, HUGE_VAL, "tolerance 1e-8", cor_status_text(COR_TOLERANCE_NOT_REACHED), cor_status_text(status));
}

/* Few modes at a hard wall bounce: 1e4 to 1e6 times an ulp of the speed. What is called good must be. `exact` is what
 * reference_disk_collision gives at a tolerance of 1e-13 with 24 panels, good to 3e-8; the full form asks it again. */
static void bounces(struct outcome *out, bool full)
{
    static const struct {
        size_t n;
        double alpha, v, exact;
    } scene[] = {{30, 8000, 0.3, 0.799369773689}, {60, 2000, 0.1, 0.928625468580}, {100, 4000, 0.05, 0.967425679106}};
    static const double tolerance[] = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7};
    for (size_t i = 0; i < (full ? sizeof scene / sizeof *scene : 1); i++) {
        struct reference_collision r = {.eps = scene[i].exact};
        if (full) {
            char input[160];
            if (reference_disk_collision(cor_disk_modes_nu033.mode, scene[i].n, scene[i].alpha, scene[i].v, 1e-13, 24,
                                         &r, NULL, NULL) != 0)
                take(out, HUGE_VAL, "reference", "a number", "none");
            snprintf(input, sizeof input, "%zu modes: the number that stands for the reference", scene[i].n);
            take_text(out, fabs(r.eps - scene[i].exact) < 3e-8 ? 0 : HUGE_VAL, input, r.eps, scene[i].exact);
        }
        for (size_t k = 0; k < (full ? sizeof tolerance / sizeof *tolerance : 3); k++) {
            struct cor_disk_collision c;
            char input[160];
            const int status = collide(&cor_disk_modes_nu033, scene[i].n, scene[i].alpha, scene[i].v, tolerance[k], &c);
            const double condition =
                condition_of(scene[i].n, scene[i].alpha, scene[i].v, tolerance[k], full ? 8 : 1, c.eps);
            out->condition = fmax(out->condition, condition);
            snprintf(input, sizeof input, "%zu modes, alpha = %g, v = %g, tolerance %g: %s", scene[i].n, scene[i].alpha,
                     scene[i].v, tolerance[k], status == COR_OK ? "COR_OK" : "not reached");
            double error = 0; /* nothing is promised */
            if (status == COR_OK)
                error = fabs(c.eps - r.eps) / (tolerance[k] + condition * 0x1p-50);
            else if (status != COR_TOLERANCE_NOT_REACHED)
                error = HUGE_VAL;
            take_text(out, error, input, r.eps, c.eps);
        }
    }
}

static const struct hard_case collision_cases[] = {
    {"v = 1e-12", "a contact of 10^9 time units is stepped through, or called good",
     "full dynamics, 1e-12 and smaller, alpha 40 to 1e5", "COR_CONTACT_NOT_ENDED, at once", "wrong answers", 0,
     slow_collision},
    {"resonance of fast n = 0 modes with the step", "omega h near a multiple of pi feeds energy into a mode",
     "the four lowest modes and all of n = 0 to omega = 62 (nu = 0.33, 0.9), alpha = 200, 2000, tolerances 1e-2 to "
     "1e-11 (full: 70 to 4000, every number of modes)",
     "the independent integrator", "tolerances", 1, resonance},
    {"the chaotic case", "digits are told that an ulp of v takes away",
     "940 modes, alpha = 2000, v = 0.3, and v some ulps away", "the independent integrator, run in the full form",
     "of tolerance (1e-2; full: 1e-3) and condition times 2^-50", 1, chaotic},
    {"the chaotic case", "runs agree by chance and COR_OK is wrong",
     "few modes at a hard wall: 30, alpha = 8000, v = 0.3, tolerances 1e-3 to 1e-5 (full: 60 and 100, too; to 1e-7)",
     "the independent integrator (full: run again)", "of tolerance and the condition times 2^-50", 1, bounces},
};

const struct case_list stability_collision = {collision_cases, sizeof collision_cases / sizeof *collision_cases};
