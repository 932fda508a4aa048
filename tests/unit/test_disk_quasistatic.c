/* SPDX-License-Identifier: MIT */
/* Tests the quasistatic contact law of the disk (runtime/disk/quasistatic.c): known contact times, leading logarithms,
 * special values. tests/accuracy/test_disk_law.c tests errors and limits. */
#include "check.h"

#include <limits.h>

#include <cor/disk.h>

static const struct function {
    const char *name;
    double (*value)(double, double, enum cor_disk_datum), (*limit)(double, enum cor_disk_datum);
} functions[] = {
    {"load", cor_disk_load, cor_disk_compression_limit},
    {"compression", cor_disk_compression, cor_disk_load_limit},
    {"energy", cor_disk_energy, cor_disk_load_limit},
    {"load_of_energy", cor_disk_load_of_energy, cor_disk_energy_limit},
    {"max_load", cor_disk_max_load, cor_disk_speed_limit},
    {"max_compression", cor_disk_max_compression, cor_disk_speed_limit},
    {"contact_time", cor_disk_contact_time, cor_disk_speed_limit},
};

static const enum cor_disk_datum datums[3] = {COR_DISK_DATUM_CENTRE_OF_MASS, COR_DISK_DATUM_DIAMETER,
                                              COR_DISK_DATUM_PRINTED};

static const double smallest = 4.9406564584124654e-324;
static const long double pi = 3.14159265358979323846264338327950288L;

/* Returns an argument inside the limit, log-uniform, or close to the limit, or equal to it. */
static double random_argument(struct random_state *r, double limit)
{
    const double kind = random_uniform(r, 0, 10);
    if (kind < 1)
        return limit;
    if (kind < 3)
        return fmin(limit, limit * (1 - random_log(r, 0x1p-53, 1)));
    return kind < 7 ? limit * random_log(r, 1e-3, 1) : limit * random_log(r, 1e-290, 1);
}

/* Values from the check of the theory, for nu = 0.33 and the printed b */
TEST(contact_time)
{
    static const double speed[] = {1e-8, 1e-4, 1e-2, 0.1};
    static const long double tau[] = {14.106276639072995L, 10.238438141667503L, 7.490162708628413L, 5.464716335895670L};
    for (int i = 0; i < 4; i++)
        check(relative_error(cor_disk_contact_time(speed[i], 0.33, COR_DISK_DATUM_PRINTED), tau[i]) < 1e-15L, "%g",
              speed[i]);
    /* for the smallest speed tau is pi sqrt(T/2), where T is about q + ln(q) */
    const double tiny = cor_disk_contact_time(smallest, 0, COR_DISK_DATUM_DIAMETER);
    assert_true(tiny > 85.5 && tiny < 86);
}

/* ---- to leading logarithm ---- */

TEST(leading_logarithms)
{
    long double worst[5] = {0};
    for (size_t i = 0; i < points(20000); i++) {
        /* 4 - x is exact, so the logarithm is accurate near 4 */
        const double end = nextafter(4, 0), x = random_argument(&draw, end);
        const long double log = x > 2 ? -log1pl((x - 4.0L) / 4) : logl(4 / (long double)x);
        const double load = random_argument(&draw, 4.62290939916368604);
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
    /* the errors that disk.h states, for nu = 0.33 */
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
    const int bad_datum[] = {3, -1, INT_MAX, INT_MIN, 256};
    for (const struct function *f = functions; f < functions + COUNT_OF(functions); f++) {
        const double at_zero = f->value == cor_disk_contact_time ? INFINITY : 0;
        for (int d = 0; d < 3; d++) {
            check(f->value(0, 0.33, datums[d]) == at_zero, "%s(0)", f->name);
            check(f->value(-0.0, 0.33, datums[d]) == at_zero, "%s(-0)", f->name);
            for (size_t i = 0; i < COUNT_OF(bad); i++)
                check(isnan(f->value(bad[i], 0.33, datums[d])), "%s(%g)", f->name, bad[i]);
            for (size_t i = 0; i < COUNT_OF(bad_nu); i++) {
                EACH (arguments, 0, 1e-3, smallest)
                    check(isnan(f->value(*arguments, bad_nu[i], datums[d])), "%s, nu = %g", f->name, bad_nu[i]);
                check(isnan(f->limit(bad_nu[i], datums[d])), "limit, nu = %g", bad_nu[i]);
            }
        }
        for (size_t i = 0; i < COUNT_OF(bad_datum); i++) {
            const enum cor_disk_datum datum = (enum cor_disk_datum)bad_datum[i];
            check(isnan(f->value(1e-3, 0.33, datum)) && isnan(f->value(0, 0.33, datum)) && isnan(f->limit(0.33, datum)),
                  "%s, datum %d", f->name, bad_datum[i]);
        }
    }
    double (*const leading[5])(double) = {cor_disk_compression_leading_log, cor_disk_load_leading_log,
                                          cor_disk_energy_leading_log, cor_disk_max_compression_leading_log,
                                          cor_disk_contact_time_leading_log};
    for (int k = 0; k < 5; k++) {
        assert_true(leading[k](0) == (k == 4 ? INFINITY : 0) && leading[k](-0.0) == (k == 4 ? INFINITY : 0));
        for (size_t i = 0; i < COUNT_OF(bad); i++)
            check(isnan(leading[k](bad[i])), "%d at %g", k, bad[i]);
    }
    assert_true(isnan(cor_disk_load_leading_log(4)) && isnan(cor_disk_energy_leading_log(4)));
}
