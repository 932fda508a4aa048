/* SPDX-License-Identifier: MIT */
/* Tests Rayleigh's energy (runtime/disk/rayleigh.c): modes against known values, sums and tails against sums over
 * twenty thousand modes, the tolerance, statuses, the edges of the domain. tests/accuracy/test_disk_rayleigh.c compares
 * single modes with the motion, to all digits. */
#include "check.h"

#include <cor/disk.h>
#include <cor/status.h>

enum { MODES = 1800 };

static const enum cor_disk_datum datums[3] = {COR_DISK_DATUM_CENTRE_OF_MASS, COR_DISK_DATUM_DIAMETER,
                                              COR_DISK_DATUM_PRINTED};
static double fractions[MODES], others[MODES];

static const struct cor_disk_modes *table(int i)
{
    return i == 0 ? &cor_disk_modes_nu033 : &cor_disk_modes_nu090;
}

static struct cor_disk_modes lowest(const struct cor_disk_modes *modes, size_t n)
{
    struct cor_disk_modes few = *modes;
    few.count = n;
    return few;
}

static struct cor_disk_rayleigh rayleigh(const struct cor_disk_modes *modes, size_t n, enum cor_disk_datum datum,
                                         double speed, double *mode_fraction)
{
    struct cor_disk_rayleigh out;
    const int status = cor_disk_rayleigh(modes, n, datum, speed, &out, mode_fraction);
    check(status == COR_OK || status == COR_BEYOND_THEORY, "v = %a, %zu modes: %s", speed, n, cor_status_text(status));
    return out;
}

/* Values for nu = 0.33 in arbitrary precision. The datum is COR_DISK_DATUM_PRINTED, in the last row
 * COR_DISK_DATUM_CENTRE_OF_MASS. */
TEST(test_values)
{
    static const struct {
        double speed, lowest, sum;
    } rows[] = {{1e-8, 2.6210855651036e-3, 4.4486187796430e-3},
                {1e-3, 2.4174957962850e-2, 3.5120912929413e-2},
                {0.1, 4.2732499337497e-1, 4.5313950534031e-1}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const struct cor_disk_rayleigh out =
            rayleigh(&cor_disk_modes_nu033, MODES, COR_DISK_DATUM_PRINTED, rows[i].speed, fractions);
        double sum = 0;
        for (size_t j = MODES; j-- > 0;)
            sum += fractions[j];
        check(fabs(out.fraction / sum - 1) < 1e-14, "v = %g", rows[i].speed);
        check(fabs(fractions[0] / rows[i].lowest - 1) < COR_DISK_RAYLEIGH_MAX_ERROR, "v = %g: %.15g", rows[i].speed,
              fractions[0]);
        check(fabs(sum / rows[i].sum - 1) < COR_DISK_RAYLEIGH_MAX_ERROR, "v = %g: %.15g", rows[i].speed, sum);
        const double time = cor_disk_contact_time(rows[i].speed, 0.33, COR_DISK_DATUM_PRINTED); /* another method */
        check(fabs(out.contact_time / time - 1) <= 2 * COR_DISK_CONTACT_TIME_MAX_ERROR, "v = %g", rows[i].speed);
    }
    /* cos(omega tau/2) nearly vanishes */
    rayleigh(&cor_disk_modes_nu033, 1, COR_DISK_DATUM_CENTRE_OF_MASS, 1e-2, fractions);
    check(fabs(fractions[0] / 2.0424708e-4 - 1) < 3e-8, "%.15g", fractions[0]);
}

/* Sums over all modes: `all` is from the 20 000 lowest modes and the tail after them, with a relative error below
 * `error`. In the fourth row a reflected wave is in phase with the motion, in the sixth row the surface wave. */
static const struct {
    int table, datum;
    double speed, all, error;
} sums[] = {
    {0, 0, 1e-300, 5.713532732458e-06, 2e-7},  {0, 1, 1e-100, 4.912898511259e-05, 3e-7},
    {0, 2, 1e-12, 2.681668085419e-03, 6e-7},   {0, 0, 5.3e-10, 1.554503939387e-03, 1e-6},
    {0, 1, 1e-08, 4.043149007311e-03, 9e-7},   {0, 2, 1.6e-05, 4.842723813425e-03, 9e-7},
    {0, 0, 0.0001, 8.934374670987e-03, 2e-6},  {0, 1, 0.001, 3.079608324175e-02, 9e-7},
    {0, 2, 0.01, 1.150344650143e-02, 2e-6},    {0, 0, 0.03, 9.840841976263e-02, 2e-7},
    {0, 1, 0.1, 2.513922467610e-01, 1e-9},     {1, 0, 1e-300, 7.033640206608e-06, 7e-7},
    {1, 1, 1e-100, 5.128370451478e-05, 1e-6},  {1, 2, 1e-12, 3.330515265422e-03, 2e-7},
    {1, 0, 5.3e-10, 5.938187705004e-03, 2e-7}, {1, 1, 1e-08, 4.461277500041e-03, 5e-7},
    {1, 2, 1.6e-05, 2.897401338943e-02, 1e-7}, {1, 0, 0.0001, 3.587673599287e-02, 2e-7},
    {1, 1, 0.001, 1.992347301646e-02, 1e-7},   {1, 2, 0.01, 1.390777255816e-01, 3e-8},
    {1, 0, 0.03, 5.083223410399e-01, 2e-10},   {1, 1, 0.1, 7.520479714269e-01, 5e-9},
};

/* The estimate is an upper bound; for 100 modes and more it is typically a few times the error. */
TEST(test_tail)
{
    for (size_t n = 1; n <= MODES; n += 1 + n / 40) {
        double errors = 0, estimates = 0;
        for (size_t i = 0; i < COUNT_OF(sums); i++) {
            const struct cor_disk_modes few = lowest(table(sums[i].table), n);
            const enum cor_disk_datum datum = datums[sums[i].datum];
            const double speed = sums[i].speed, all = sums[i].all;
            struct cor_disk_rayleigh out = rayleigh(&few, n, datum, speed, NULL);
            double error = fabs(out.fraction + out.tail - all);
            check(error <= out.error_estimate + sums[i].error * all, "v = %g, %zu modes: %g, %g", speed, n, error / all,
                  out.error_estimate / all);
            errors += error / all;
            estimates += out.error_estimate / all;
            /* the tail contains the other modes of the table */
            out = rayleigh(table(sums[i].table), n, datum, speed, NULL);
            error = fabs(out.fraction + out.tail - all);
            const double allowed =
                speed < 1e-9 ? COR_DISK_RAYLEIGH_TAIL_MAX_ERROR_ANY_SPEED : COR_DISK_RAYLEIGH_TAIL_MAX_ERROR;
            check(error <= (fmin(allowed * all, out.error_estimate) + sums[i].error * all), "v = %g, %zu modes: %g, %g",
                  speed, n, error / all, out.error_estimate / all);
        }
        check(n < 100 || n > 1000 || estimates < 30 * errors, "%zu modes: %g, %g", n, estimates, errors);
        /* exact estimates, which would change if the fit lacked a large or a small term */
        if (n == 12 || n == 1797)
            check_near(estimates, n == 12 ? 1.84848433 : 3.64785667e-4, 1e-8);
    }
}

/* Sum and tail together do not depend on the number of modes, at any speed. */
TEST(test_any_speed)
{
    for (size_t i = 0; i < points(60); i++) {
        const int t = i % 2 != 0;
        const enum cor_disk_datum datum = datums[i % 3];
        const double limit = cor_disk_speed_limit(table(t)->nu, datum);
        const double speed = i == 0 ? limit : i == 1 ? 5e-324 : random_log(&draw, i % 4 ? 1e-9 : 1e-320, limit);
        const size_t n = (size_t)random_log(&draw, 20, MODES);
        const struct cor_disk_rayleigh all = rayleigh(table(t), MODES, datum, speed, fractions);
        const struct cor_disk_modes few = lowest(table(t), n);
        const struct cor_disk_rayleigh some = rayleigh(&few, n, datum, speed, others);
        const double difference = some.fraction + some.tail - all.fraction - all.tail;
        check(fabs(difference) <= some.error_estimate + all.error_estimate, "v = %a, %zu modes: %g, %g", speed, n,
              difference, some.error_estimate);
        check(all.fraction > 0 && all.tail > 0 && all.tail < 0.01 * all.fraction, "v = %a: %g, %g", speed, all.fraction,
              all.tail);
        for (size_t j = 0; j < n; j++)
            check(fabs(fractions[j] - others[j]) <=
                      fmax(COR_DISK_RAYLEIGH_MAX_ERROR * fractions[j], COR_DISK_RAYLEIGH_MAX_ABSOLUTE * all.fraction),
                  "v = %a, mode %zu: %g, %g", speed, j, fractions[j], others[j]);
        /* within the table, a change of n only moves terms between sum and tail */
        const struct cor_disk_rayleigh same = rayleigh(table(t), n, datum, speed, others);
        double sum = 0;
        for (size_t j = 0; j < n; j++) {
            check(fractions[j] == others[j], "v = %a, mode %zu: %g, %g", speed, j, fractions[j], others[j]);
            sum += others[j];
        }
        check(same.fraction == sum, "v = %a, %zu modes: %.17g, %.17g", speed, n, same.fraction, sum);
        check(fabs((same.fraction + same.tail) / (all.fraction + all.tail) - 1) < 1e-13, "v = %a, %zu modes", speed, n);
        check(fabs(same.error_estimate - all.error_estimate) < 1e-13 * all.fraction, "v = %a, %zu modes", speed, n);
    }
}

TEST(test_tolerance)
{
    static const double tolerances[] = {0.3, 1e-2, 1e-3, 3e-5};
    for (size_t i = 0; i < points(24); i++) {
        const int t = i % 2 != 0;
        const enum cor_disk_datum datum = datums[i % 3];
        const double limit = cor_disk_speed_limit(table(t)->nu, datum);
        const double speed = random_log(&draw, 1e-12, fmin(limit, 0.2)), tolerance = tolerances[i % 4];
        struct cor_disk_rayleigh out;
        size_t n = 0;
        const int status = cor_disk_rayleigh_tolerance(table(t), datum, speed, tolerance, &out, &n);
        check(n >= 1 && n <= MODES, "%zu", n);
        struct cor_disk_modes few = lowest(table(t), n);
        const struct cor_disk_rayleigh same = rayleigh(&few, n, datum, speed, NULL);
        check(fabs(out.fraction / same.fraction - 1) < 1e-11 && fabs(out.tail - same.tail) < 1e-11 * same.fraction,
              "v = %a, %zu modes: %.15g, %.15g", speed, n, out.fraction, same.fraction);
        if (status == COR_TOLERANCE_NOT_REACHED) {
            check(n == MODES && same.error_estimate > 0.999 * tolerance * (same.fraction + same.tail), "v = %a", speed);
            continue;
        }
        check(status ==
                  (speed > COR_DISK_RAYLEIGH_MAX_SPEED || out.fraction + out.tail > 1 ? COR_BEYOND_THEORY : COR_OK),
              "v = %a: %d", speed, status);
        check(out.error_estimate <= tolerance * (out.fraction + out.tail), "v = %a", speed);
        if (n > 1) {
            few.count = n - 1;
            const struct cor_disk_rayleigh fewer = rayleigh(&few, n - 1, datum, speed, NULL);
            check(fewer.error_estimate > 0.999 * tolerance * (fewer.fraction + fewer.tail), "v = %a, %zu modes", speed,
                  n);
        }
    }
    struct cor_disk_rayleigh out;
    check(cor_disk_rayleigh_tolerance(&cor_disk_modes_nu033, COR_DISK_DATUM_PRINTED, 1e-3, 1e-2, &out, NULL) == COR_OK,
          "n_modes may be NULL");
    size_t n = 0;
    check(cor_disk_rayleigh_tolerance(&cor_disk_modes_nu033, COR_DISK_DATUM_PRINTED, 1e-8, 1e-9, &out, &n) ==
                  COR_TOLERANCE_NOT_REACHED &&
              n == MODES && out.fraction > 0,
          "%zu", n);
}

/* ---- many speeds ---- */

enum { LIST = 90 };
static double list_fractions[LIST * MODES];

/* Compares every speed of a list with the function for one speed. */
static void against_one(const struct cor_disk_modes *modes, size_t n_modes, enum cor_disk_datum datum,
                        const double *speed, size_t n, int exact)
{
    struct cor_disk_rayleigh list[LIST];
    int status[LIST];
    int expected = COR_OK;
    const int first = cor_disk_rayleigh_array(modes, n_modes, datum, speed, n, list, list_fractions, status);
    for (size_t i = 0; i < n; i++) {
        struct cor_disk_rayleigh one;
        const int here = cor_disk_rayleigh(modes, n_modes, datum, speed[i], &one, fractions);
        const double *const f = list_fractions + i * n_modes;
        check(status[i] == here, "v = %a: %d, %d", speed[i], status[i], here);
        expected = expected ? expected : here;
        if (here == COR_ERROR_SPEED) {
            check(isnan(list[i].fraction) && isnan(list[i].tail) && isnan(list[i].error_estimate) &&
                      isnan(list[i].contact_time) && isnan(f[n_modes - 1]),
                  "v = %a", speed[i]);
            continue;
        }
        check(same_bits(list[i].contact_time, one.contact_time), "v = %a", speed[i]);
        const double allowed = exact ? 0 : 1e-12, sum = one.fraction + one.tail;
        check(fabs(list[i].fraction - one.fraction) <= allowed * sum &&
                  fabs(list[i].tail - one.tail) <= allowed * sum &&
                  fabs(list[i].error_estimate - one.error_estimate) <= allowed * sum,
              "v = %a: %.17g, %.17g", speed[i], list[i].fraction, one.fraction);
        for (size_t k = 0; k < n_modes; k++)
            check(fabs(f[k] - fractions[k]) <= (exact ? 0
                                                      : fmax(COR_DISK_RAYLEIGH_MAX_ERROR * fractions[k],
                                                             COR_DISK_RAYLEIGH_MAX_ABSOLUTE * one.fraction)),
                  "v = %a, mode %zu: %.17g, %.17g", speed[i], k, f[k], fractions[k]);
    }
    check(first == expected, "%d, %d", first, expected);
}

TEST(test_array)
{
    double speed[LIST];
    for (int t = 0; t < 2; t++) {
        const enum cor_disk_datum datum = datums[(t + 1) % 3];
        const double limit = cor_disk_speed_limit(table(t)->nu, datum);
        /* ranges of speeds so dense that spectra are interpolated: slow, fast, and close to the limit of the law */
        const double from[] = {1e-9, 1e-5, 0.3 * limit, 0.9 * limit}, to[] = {1e-6, 1e-3, 0.95 * limit, limit};
        for (size_t k = 0; k < 4; k++) {
            for (size_t i = 0; i < LIST; i++)
                speed[i] = random_log(&draw, from[k], to[k]);
            speed[0] = to[k];
            against_one(table(t), k == 0 ? MODES : (size_t)random_log(&draw, 1, MODES), datum, speed, LIST, 0);
        }
        /* too few or too sparse speeds for interpolation, each computed separately, with wrong speeds between them */
        const double special[] = {0, -0.0, limit, nextafter(limit, 9), -1, NAN, INFINITY, 5e-324, 1e-300, 1e-3};
        against_one(table(t), 70, datum, special, sizeof special / sizeof *special, 1);
        for (size_t i = 0; i < 20; i++)
            speed[i] = random_log(&draw, 1e-320, limit);
        against_one(table(t), 64, datum, speed, 20, 1);
    }
    /* a table that is too short to continue its modes l = 0 */
    struct cor_disk_modes few = lowest(&cor_disk_modes_nu033, 20);
    against_one(&few, 7, COR_DISK_DATUM_DIAMETER, speed, 20, 1);
}

TEST(test_limits)
{
    struct cor_disk_rayleigh out = {1, 1, 1, 1};
    fractions[0] = fractions[1] = 1;
    check(cor_disk_rayleigh(&cor_disk_modes_nu033, 2, COR_DISK_DATUM_DIAMETER, 0, &out, fractions) == COR_OK, "v = 0");
    check(out.fraction == 0 && out.tail == 0 && out.error_estimate == 0 && isinf(out.contact_time), "v = 0");
    check(fractions[0] == 0 && fractions[1] == 0, "v = 0");
    size_t n = 0;
    check(cor_disk_rayleigh_tolerance(&cor_disk_modes_nu033, COR_DISK_DATUM_DIAMETER, 0, 0.1, &out, &n) == COR_OK &&
              n == 1 && out.fraction == 0,
          "v = 0");
    /* the energy vanishes like 1/ln(v)^2 */
    const double tiny = rayleigh(&cor_disk_modes_nu033, 100, COR_DISK_DATUM_DIAMETER, 5e-324, NULL).fraction;
    check(tiny > 1e-7 && tiny < 1e-4, "%g", tiny);
    check(cor_disk_rayleigh(&cor_disk_modes_nu033, 9, COR_DISK_DATUM_DIAMETER, COR_DISK_RAYLEIGH_MAX_SPEED, &out,
                            NULL) == COR_OK,
          "still within theory");
    check(cor_disk_rayleigh(&cor_disk_modes_nu033, 9, COR_DISK_DATUM_DIAMETER, 0.0301, &out, NULL) == COR_BEYOND_THEORY,
          "too fast");
}

/* Checks that each function refuses the arguments and changes no results. If the speed is wrong, omits
 * cor_disk_rayleigh_array, which has a status for each speed. If n_modes is only a part of the modes, omits
 * cor_disk_rayleigh_tolerance. */
static void refused(const struct cor_disk_modes *modes, size_t n_modes, enum cor_disk_datum datum, double speed,
                    int expected)
{
    struct cor_disk_rayleigh out[2] = {{7, 7, 7, 7}, {7, 7, 7, 7}}, untouched[2];
    const double speeds[2] = {speed, speed};
    double f[3] = {7, 7, 7};
    int status[2] = {7, 7};
    size_t n = 7;
    memcpy(untouched, out, sizeof out);
    check(cor_disk_rayleigh(modes, n_modes, datum, speed, out, f) == expected, "%d", expected);
    if (expected != COR_ERROR_SPEED)
        check(cor_disk_rayleigh_array(modes, n_modes, datum, speeds, 2, out, f, status) == expected, "%d", expected);
    if (!modes || n_modes == modes->count)
        check(cor_disk_rayleigh_tolerance(modes, datum, speed, 0.1, out, &n) == expected, "%d", expected);
    check(memcmp(out, untouched, sizeof out) == 0 && f[0] == 7 && status[0] == 7 && n == 7, "touched: %d", expected);
}

TEST(test_statuses)
{
    struct cor_disk_mode mode[] = {{2, 0, 1.44, 1.4, -0.4}, {1, 0, 1.69, 0.5, 2}, {0, 0, 2.2, 1.1, 0}};
    const struct cor_disk_mode good = mode[1];
    struct cor_disk_modes modes = {0.33, 3, mode};
    const enum cor_disk_datum datum = COR_DISK_DATUM_CENTRE_OF_MASS;
    struct cor_disk_rayleigh out[2];
    const double speed[2] = {1e-3, 1};
    int status[2];
    size_t n = 7;
    refused(NULL, 3, datum, 0.01, COR_ERROR_NULL);
    refused(&modes, 0, datum, 0.01, COR_ERROR_MODES);
    refused(&(struct cor_disk_modes){0.33, 2, mode}, 3, datum, 0.01, COR_ERROR_MODES);
    refused(&(struct cor_disk_modes){0.33, 0, mode}, 0, datum, 0.01, COR_ERROR_MODES);
    refused(&modes, 3, (enum cor_disk_datum)3, 0.01, COR_ERROR_DATUM);
    EACH (bad_speed, -1e-9, nextafter(cor_disk_speed_limit(0.33, datum), 1), NAN)
        refused(&modes, 3, datum, *bad_speed, COR_ERROR_SPEED);
    refused(&(struct cor_disk_modes){0.33, 3, NULL}, 3, datum, 0.01, COR_ERROR_NULL);
    EACH (bad_nu, -1, 1, 2, NAN)
        refused(&(struct cor_disk_modes){*bad_nu, 3, mode}, 3, datum, 0.01, COR_ERROR_DISK_POISSON_RATIO);
    static const struct {
        int at;
        double omega;
    } bad[] = {{0, 1}, {1, 1.43}, {1, 2.3}, {1, NAN}, {2, INFINITY}};
    for (size_t i = 0; i < COUNT_OF(bad); i++) {
        const double kept = mode[bad[i].at].omega;
        mode[bad[i].at].omega = bad[i].omega;
        refused(&modes, 3, datum, 0.01, COR_ERROR_MODES);
        mode[bad[i].at].omega = kept;
    }
    EACH (bad_n, -1, COR_DISK_MODES_MAX_N + 1, 100000) {
        mode[1].n = (int)*bad_n;
        refused(&modes, 3, datum, 0.01, COR_ERROR_MODES);
    }
    mode[1] = good;
    mode[2].c = NAN;
    refused(&modes, 3, datum, 0.01, COR_ERROR_MODES);
    refused(&modes, 2, datum, 0.01, COR_ERROR_MODES); /* the tail needs a third mode */
    modes.count = 2;
    check(cor_disk_rayleigh(&modes, 2, datum, 0.01, out, NULL) == COR_OK && out->fraction > 0, "only what there is");
    out->fraction = 7;
    EACH (bad_tolerance, 0, 1, -0.5, NAN)
        check(cor_disk_rayleigh_tolerance(&modes, datum, 0.01, *bad_tolerance, out, &n) == COR_ERROR_TOLERANCE &&
                  n == 7 && out->fraction == 7,
              "%g", *bad_tolerance);
    check(cor_disk_rayleigh(&modes, 2, datum, 0.01, NULL, fractions) == COR_ERROR_NULL, "out");
    check(cor_disk_rayleigh_tolerance(&modes, datum, 0.01, 0.1, NULL, &n) == COR_ERROR_NULL, "out");
    check(cor_disk_rayleigh_array(&modes, 2, datum, speed, 2, NULL, NULL, status) == COR_ERROR_NULL, "out");
    check(cor_disk_rayleigh_array(&modes, 2, datum, NULL, 2, out, NULL, status) == COR_ERROR_NULL, "speed");
    check(cor_disk_rayleigh_array(&modes, 2, datum, speed, 0, NULL, NULL, NULL) == COR_OK, "no speeds");
    check(cor_disk_rayleigh_array(&modes, 2, datum, speed, SIZE_MAX / 4, out, NULL, NULL) == COR_ERROR_MEMORY,
          "no memory");
    check(cor_disk_rayleigh_array(&modes, 2, datum, speed, 1, out, NULL, NULL) == COR_OK && out->fraction < 1, "one");
    check(cor_disk_rayleigh_array(&modes, 2, datum, speed, 2, out, NULL, status) == COR_ERROR_SPEED &&
              status[0] == COR_OK && status[1] == COR_ERROR_SPEED && isnan(out[1].fraction),
          "too fast for the law");
}
