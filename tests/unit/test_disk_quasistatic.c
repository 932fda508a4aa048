/* SPDX-License-Identifier: MIT */
/* The quasistatic contact law of the disk (runtime/disk/quasistatic.c): identities, known contact times, the leading
 * logarithms, special values. Errors and limits: tests/accuracy/test_disk_law.c. */
#include "check.h"

#include <limits.h>

#include <cor/disk.h>

typedef double law_function(double, double, enum cor_disk_datum);
typedef double plain_function(double);

enum { LOAD, COMPRESSION, ENERGY, LOAD_OF_ENERGY, MAX_LOAD, MAX_COMPRESSION, CONTACT_TIME, FUNCTIONS };

static const struct function {
    const char *name;
    law_function *value;
    double (*limit)(double, enum cor_disk_datum);
} functions[FUNCTIONS] = {
    [LOAD] = {"load", cor_disk_load, cor_disk_compression_limit},
    [COMPRESSION] = {"compression", cor_disk_compression, cor_disk_load_limit},
    [ENERGY] = {"energy", cor_disk_energy, cor_disk_load_limit},
    [LOAD_OF_ENERGY] = {"load_of_energy", cor_disk_load_of_energy, cor_disk_energy_limit},
    [MAX_LOAD] = {"max_load", cor_disk_max_load, cor_disk_speed_limit},
    [MAX_COMPRESSION] = {"max_compression", cor_disk_max_compression, cor_disk_speed_limit},
    [CONTACT_TIME] = {"contact_time", cor_disk_contact_time, cor_disk_speed_limit},
};

static const enum cor_disk_datum datums[3] = {COR_DISK_DATUM_CENTRE_OF_MASS, COR_DISK_DATUM_DIAMETER,
                                              COR_DISK_DATUM_PRINTED};

static const double smallest = 4.9406564584124654e-324;
static const long double pi = 3.14159265358979323846264338327950288L;

/* Inside the limit: by its logarithm, near the limit, on it */
static double random_argument(struct random_state *r, double limit)
{
    const double kind = random_uniform(r, 0, 10);
    if (kind < 1)
        return limit;
    if (kind < 3)
        return fmin(limit, limit * (1 - random_log(r, 0x1p-53, 1)));
    return kind < 7 ? limit * random_log(r, 1e-3, 1) : limit * random_log(r, 1e-290, 1);
}

/* V = int P ddelta, by Gauss's rule of four points; the inverses; V = pi v^2/2 */
TEST(energy_is_work)
{
    static const long double node[2] = {0.861136311594052575224L, 0.339981043584856264803L},
                             weight[2] = {0.347854845137453857373L, 0.652145154862546142627L};
    for (double nu = -0.9; nu < 1; nu += 0.3)
        for (int datum = 0; datum < 3; datum++) {
            const double end = 0.9 * cor_disk_compression_limit(nu, datums[datum]);
            double low = end / 1024;
            long double work = 0;
            const double start = cor_disk_energy(cor_disk_load(low, nu, datums[datum]), nu, datums[datum]);
            while (low < end) {
                const double high = fmin(end, low * 1.1), half = (high - low) / 2, middle = (high + low) / 2;
                for (int i = 0; i < 2; i++)
                    for (int side = -1; side <= 1; side += 2)
                        work +=
                            half * weight[i] * cor_disk_load(middle + side * half * (double)node[i], nu, datums[datum]);
                low = high;
            }
            const double stored = cor_disk_energy(cor_disk_load(end, nu, datums[datum]), nu, datums[datum]);
            check(fabsl(work / (stored - start) - 1) < 1e-9L, "nu = %g, datum %d: %Lg and %g", nu, datum, work,
                  stored - start);
            const double load = cor_disk_load(end, nu, datums[datum]), speed = sqrt(2 * stored / (double)pi);
            const double back[4] = {cor_disk_compression(load, nu, datums[datum]) / end,
                                    cor_disk_load_of_energy(stored, nu, datums[datum]) / load,
                                    cor_disk_max_load(speed, nu, datums[datum]) / load,
                                    cor_disk_max_compression(speed, nu, datums[datum]) / end};
            for (int k = 0; k < 4; k++)
                check(fabs(back[k] - 1) < 1e-14, "nu = %g, datum %d, inverse %d: %.17g", nu, datum, k, back[k]);
        }
}

/* Of the theory's check, nu = 0.33 and the printed b */
TEST(contact_time)
{
    static const double speed[] = {1e-8, 1e-4, 1e-2, 0.1};
    static const long double tau[] = {14.106276639072995L, 10.238438141667503L, 7.490162708628413L, 5.464716335895670L};
    for (int i = 0; i < 4; i++)
        check(relative_error(cor_disk_contact_time(speed[i], 0.33, COR_DISK_DATUM_PRINTED), tau[i]) < 1e-15L, "%g",
              speed[i]);
    /* pi sqrt(T/2) with T about q + ln(q), where the speed is as small as can be */
    const double tiny = cor_disk_contact_time(smallest, 0, COR_DISK_DATUM_DIAMETER);
    assert_true(tiny > 85.5 && tiny < 86);
}

/* ---- to leading logarithm ---- */

TEST(leading_logarithms)
{
    struct random_state random = random_start();
    long double worst[5] = {0};
    for (size_t i = 0; i < points(20000); i++) {
        /* 4 - x is exact, and so the logarithm is good near 4 */
        const double end = nextafter(4, 0), x = random_argument(&random, end);
        const long double log = x > 2 ? -log1pl((x - 4.0L) / 4) : logl(4 / (long double)x);
        const double load = random_argument(&random, 4.62290939916368604);
        const long double error[5] = {
            ulp_error(cor_disk_compression_leading_log(load), load / pi * logl(4 * pi / load)),
            ulp_error(cor_disk_load_leading_log(x), pi * x / log),
            ulp_error(cor_disk_energy_leading_log(x), pi / 2 * x * x / log),
            ulp_error(cor_disk_max_compression_leading_log(x), x * sqrtl(log)),
            ulp_error(cor_disk_contact_time_leading_log(x), pi * sqrtl(log)),
        };
        for (int k = 0; k < 5; k++) {
            worst[k] = fmaxl(worst[k], error[k]);
            check(error[k] <= COR_DISK_LAW_MAX_ULP, "%d at %a: %Lg ulp", k, k == 0 ? load : x, error[k]);
        }
    }
    print_message("leading logarithms: %.2Lf, %.2Lf, %.2Lf, %.2Lf, %.2Lf ulp at the worst\n", worst[0], worst[1],
                  worst[2], worst[3], worst[4]);
    /* what disk.h says they miss, nu = 0.33 */
    for (int datum = 0; datum < 3; datum++) {
        const enum cor_disk_datum d = (enum cor_disk_datum)datum;
        for (double v = 1e-12; v <= 1e-2; v *= 1.7) {
            assert_true(fabs(cor_disk_contact_time_leading_log(v) / cor_disk_contact_time(v, 0.33, d) - 1) < 0.07);
            assert_true(fabs(cor_disk_max_compression_leading_log(v) / cor_disk_max_compression(v, 0.33, d) - 1) <
                        0.07);
        }
        for (double x = 0.001; x <= 0.2; x *= 1.1)
            assert_true(fabs(cor_disk_load_leading_log(x) / cor_disk_load(x, 0.33, d) - 1) < 0.36);
    }
    assert_true(cor_disk_max_compression_leading_log(4) == 0 && cor_disk_contact_time_leading_log(4) == 0);
    assert_true(isnan(cor_disk_load_leading_log(4)) && isnan(cor_disk_energy_leading_log(4)));
    assert_true(isnan(cor_disk_max_compression_leading_log(nextafter(4, 5))));
    assert_true(isnan(cor_disk_contact_time_leading_log(nextafter(4, 5))));
    /* 4 pi/e is 4.62290939916368599... */
    assert_true(cor_disk_compression_leading_log(4.62290939916368604) > 0);
    assert_true(isnan(cor_disk_compression_leading_log(nextafter(4.62290939916368604, 5))));
}

/* ---- special values ---- */

TEST(special_values)
{
    const double bad[] = {-smallest, -1, -INFINITY, INFINITY, NAN, 1e300};
    const double bad_nu[] = {-1, 1, nextafter(1, 2), nextafter(-1, -2), INFINITY, -INFINITY, NAN};
    for (int k = 0; k < FUNCTIONS; k++)
        for (int d = 0; d < 3; d++) {
            law_function *const value = functions[k].value;
            const double at_zero = k == CONTACT_TIME ? INFINITY : 0;
            check(value(0, 0.33, datums[d]) == at_zero, "%s(0)", functions[k].name);
            check(value(-0.0, 0.33, datums[d]) == at_zero, "%s(-0)", functions[k].name);
            for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
                check(isnan(value(bad[i], 0.33, datums[d])), "%s(%g)", functions[k].name, bad[i]);
            EACH (arguments, 0, 1e-3, smallest)
                for (size_t i = 0; i < sizeof bad_nu / sizeof *bad_nu; i++)
                    check(isnan(value(*arguments, bad_nu[i], datums[d])), "%s, nu = %g", functions[k].name, bad_nu[i]);
            for (size_t i = 0; i < sizeof bad_nu / sizeof *bad_nu; i++)
                check(isnan(functions[k].limit(bad_nu[i], datums[d])), "limit, nu = %g", bad_nu[i]);
        }
    const int bad_datum[] = {3, -1, INT_MAX, INT_MIN, 256};
    for (int k = 0; k < FUNCTIONS; k++)
        for (size_t i = 0; i < sizeof bad_datum / sizeof *bad_datum; i++) {
            const enum cor_disk_datum datum = (enum cor_disk_datum)bad_datum[i];
            check(isnan(functions[k].value(1e-3, 0.33, datum)), "%s, datum %d", functions[k].name, bad_datum[i]);
            check(isnan(functions[k].value(0, 0.33, datum)), "%s, datum %d", functions[k].name, bad_datum[i]);
            check(isnan(functions[k].limit(0.33, datum)), "limit, datum %d", bad_datum[i]);
        }
    plain_function *const leading[5] = {cor_disk_compression_leading_log, cor_disk_load_leading_log,
                                        cor_disk_energy_leading_log, cor_disk_max_compression_leading_log,
                                        cor_disk_contact_time_leading_log};
    for (int k = 0; k < 5; k++) {
        assert_true(leading[k](0) == (k == 4 ? INFINITY : 0) && leading[k](-0.0) == (k == 4 ? INFINITY : 0));
        for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
            check(isnan(leading[k](bad[i])), "%d at %g", k, bad[i]);
    }
}

RUN_TESTS(energy_is_work, contact_time, leading_logarithms, special_values)
