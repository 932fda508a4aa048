/* SPDX-License-Identifier: MIT */
/* Tests fractions of single modes against their integral along the real axis (the library uses another path) and
 * against a step-by-step motion. Tests sums and tails of the library's tables against tables with three times the
 * number of modes. */
#include "check.h"

#include <cor/disk.h>
#include <cor/status.h>

#include "disk/modes.h"
#include "reference_rayleigh.h"
#include "support/local.h"

enum { FREQUENCIES = 10, MANY = 6000 };

/* Speed at which the integral of the lowest mode vanishes, for nu = 0.33 and the datum centre of mass */
#define QUADRUPOLE_ZERO 0x1.64014a0b3a0b3p-7

static const enum cor_disk_datum datums[3] = {COR_DISK_DATUM_CENTRE_OF_MASS, COR_DISK_DATUM_DIAMETER,
                                              COR_DISK_DATUM_PRINTED};

static double worst; /* largest error, relative to the allowed error */

/* Compares modes with C = sqrt(2) and S = 0 with the reference. */
static void compare(double nu, enum cor_disk_datum datum, double v, const double *omega)
{
    long double exact[FREQUENCIES];
    double f[FREQUENCIES];
    struct cor_disk_mode mode[FREQUENCIES];
    struct cor_disk_rayleigh out;
    for (int i = 0; i < FREQUENCIES; i++)
        mode[i] = (struct cor_disk_mode){2, i, omega[i], 1.4142135623730951, 0};
    const struct cor_disk_modes modes = {nu, FREQUENCIES, mode};
    const int status = cor_disk_rayleigh(&modes, FREQUENCIES, datum, v, &out, f);
    check(status == COR_OK || status == COR_BEYOND_THEORY, "v = %a: %s", v, cor_status_text(status));
    const long double time = reference_rayleigh(mode, FREQUENCIES, nu, datum, v, exact);
    check(fabsl(out.contact_time / time - 1) <= COR_DISK_CONTACT_TIME_MAX_ERROR, "v = %a: contact time %.17g", v,
          out.contact_time);
    for (int i = 0; i < FREQUENCIES; i++) {
        const double error = (double)fabsl(f[i] - exact[i]);
        const double allowed =
            fmax(COR_DISK_RAYLEIGH_MAX_ERROR * (double)exact[i], COR_DISK_RAYLEIGH_MAX_ABSOLUTE * out.fraction);
        check(error <= allowed, "nu = %g, v = %a, omega = %a: %.17g, %.19Lg", nu, v, omega[i], f[i], exact[i]);
        worst = fmax(worst, error / allowed);
    }
}

TEST(test_hard_points)
{
    /* frequencies of modes: the lowest of any disk, the lowest for nu = 0.33 and 0.9, the 1800th and the 20000th */
    static const double omega[FREQUENCIES] = {
        1.1769, 1.20715112596031, 1.43853032762639, 1.6891017846666, 2.21008494893776, 4.3, 8.6, 25, 62.9, 211.44};
    static const double speeds[] = {1e-300, 1e-12, 1e-8, 1e-4, 1e-3, 1e-2, 0.03, 0.1};
    for (size_t i = 0; i < sizeof speeds / sizeof *speeds; i++)
        compare(0.33, datums[i == 5 ? 0 : 2], speeds[i], omega);
    static const double from_edge[] = {1e-1, 1e-2, 1e-4, 1e-8, 0x1p-50, 0};
    for (size_t i = 0; i < sizeof from_edge / sizeof *from_edge; i++)
        compare(0.9, datums[i % 3], (1 - from_edge[i]) * cor_disk_speed_limit(0.9, datums[i % 3]), omega);
    /* close to the zero of the quadrupole's integral */
    static const double from_zero[] = {0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3};
    for (size_t i = 0; i < sizeof from_zero / sizeof *from_zero; i++)
        compare(0.33, COR_DISK_DATUM_CENTRE_OF_MASS, QUADRUPOLE_ZERO * (1 - from_zero[i]), omega);
}

/* 2 I = (2/(pi v)) int_0^(tau/2) P cos(omega t) dt for delta'' = -P/pi, starting at the largest compression */
TEST(test_motion)
{
    enum { STEPS = 20000 };
    const double pi = 3.14159265358979323846, v = 1e-3, nu = 0.33, omega[] = {1.2, 1.5, 2, 3};
    for (size_t k = 0; k < 4; k++) {
        const enum cor_disk_datum datum = datums[k % 3];
        const double dt = cor_disk_contact_time(v, nu, datum) / 2 / STEPS;
        double depth = cor_disk_max_compression(v, nu, datum), speed = 0, sum = 0, f;
        for (int i = 0; i < STEPS; i++) { /* forces at whole steps; trapezoidal rule with the end value 0 */
            const double load = cor_disk_load(depth, nu, datum) * (i == 0 ? 0.5 : 1);
            sum += load * cos(omega[k] * i * dt) * dt;
            speed += load / pi * dt;
            depth = fmax(depth - speed * dt, 0);
        }
        const struct cor_disk_mode mode = {2, 0, omega[k], 1, 0};
        struct cor_disk_rayleigh out;
        cor_disk_rayleigh(&(struct cor_disk_modes){nu, 1, &mode}, 1, datum, v, &out, &f);
        check(fabs(sqrt(f) / fabs(2 / (pi * v) * sum) - 1) < 1e-6, "omega = %g: %.9g, not %.9g", omega[k], sqrt(f),
              fabs(2 / (pi * v) * sum));
    }
}

static int increasing(const void *x, const void *y)
{
    const double a = *(const double *)x, b = *(const double *)y;
    return (a > b) - (a < b);
}

TEST(test_random_points)
{
    for (size_t i = 0; i < points(12); i++) {
        const enum cor_disk_datum datum = datums[i % 3];
        const double nu = random_uniform(&draw, -0.99, 0.99), limit = cor_disk_speed_limit(nu, datum);
        double omega[FREQUENCIES];
        for (int j = 0; j < FREQUENCIES; j++)
            omega[j] = random_log(&draw, 1.1769, j < 4 ? 3 : 300);
        qsort(omega, FREQUENCIES, sizeof *omega, increasing);
        compare(nu, datum, random_log(&draw, i % 4 ? 1e-9 : 1e-40, limit), omega);
    }
    print_message("worst error: %.2g of what is allowed\n", worst);
}

enum { MOST_SPEEDS = 10000, FEW = 1800, TAKEN = 1000 };

/* Compares the sum and tail of the TAKEN lowest modes of `table` with the sum and tail of MANY modes of the same nu.
 * The difference must be within `bound` for v = 1e-9 and above. */
static void compare_tails(const struct cor_disk_modes *many, const struct cor_disk_modes *table, double bound)
{
    static double errors[MOST_SPEEDS], ratios[MOST_SPEEDS];
    double worst_any = 0;
    size_t n = 0;
    for (size_t j = 0; j < points(100) && n < MOST_SPEEDS; j++) {
        const enum cor_disk_datum datum = datums[j % 3];
        const double limit = cor_disk_speed_limit(table->nu, datum);
        const double v = random_log(&draw, j % 5 ? 1e-9 : 1e-300, j % 5 ? limit : 1e-9);
        struct cor_disk_rayleigh all, out;
        cor_disk_rayleigh(many, MANY, datum, v, &all, NULL);
        cor_disk_rayleigh(table, TAKEN, datum, v, &out, NULL);
        const double expected = all.fraction + all.tail, error = fabs(out.fraction + out.tail - expected);
        check(error <= (j % 5 ? bound : COR_DISK_RAYLEIGH_TAIL_MAX_ERROR_ANY_SPEED) * expected + all.error_estimate,
              "nu = %g, v = %a: %g", table->nu, v, error / expected);
        check(error <= out.error_estimate + all.error_estimate, "nu = %g, v = %a: %g, estimated %g", table->nu, v,
              error / expected, out.error_estimate / expected);
        if (j % 5) {
            errors[n] = error / expected;
            ratios[n++] = out.error_estimate / error;
        } else {
            worst_any = fmax(worst_any, error / expected);
        }
    }
    qsort(errors, n, sizeof *errors, increasing);
    qsort(ratios, n, sizeof *ratios, increasing);
    print_message("nu = %g, sum plus tail from v = 1e-9 on: worst error %.2g, median %.1g, estimated %.2g to %.3g "
                  "(median) times as large; below: worst %.2g\n",
                  table->nu, errors[n - 1], errors[n / 2], ratios[0], ratios[n / 2], worst_any);
}

/* Tests the library's two tables. COR_TEST_MULTIPLIER adds 14 other nu, for which the bound is larger. */
TEST(test_tails)
{
    static const long percent[] = {33, 90, -90, -75, -50, -25, 0, 20, 25, 40, 50, 60, 70, 80, 95, 99};
    const size_t materials = points(1) > 1 ? sizeof percent / sizeof *percent : 2;
    for (size_t i = 0; i < materials; i++) {
        struct cor_disk_modes many;
        LOCAL(fmpq, nu);
        fmpq_set_si(nu, percent[i], 100);
        check(disk_modes_rounded(&many, nu, MANY) == 0, "nu = 0.%ld", percent[i]);
        const struct cor_disk_modes few = {many.nu, FEW, many.mode};
        if (i < 2)
            compare_tails(&many, i == 0 ? &cor_disk_modes_nu033 : &cor_disk_modes_nu090,
                          COR_DISK_RAYLEIGH_TAIL_MAX_ERROR);
        else
            compare_tails(&many, &few, COR_DISK_RAYLEIGH_TAIL_MAX_ERROR_ANY_SPEED);
        free((void *)many.mode);
    }
}
