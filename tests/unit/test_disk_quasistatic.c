/* SPDX-License-Identifier: MIT */
/* The quasistatic contact law of the disk (runtime/disk/quasistatic.c): the law itself in long double, its limits and
 * identities, the contact time over theta, special values. tests/accuracy/test_disk_law.c has the many points. */
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
static const long double ln2 = 0.693147180559945309417232121458176568L;

/* What long double itself may lose, relative */
static const long double slack = LDBL_MANT_DIG >= 64 ? 0x1p-60L : 0x1p-49L;

static long double constant_b(double nu, enum cor_disk_datum datum)
{
    if (datum == COR_DISK_DATUM_CENTRE_OF_MASS)
        return -2 * ln2 - (1 + (long double)nu) / 4;
    return datum == COR_DISK_DATUM_DIAMETER ? -1 : -1 - (long double)nu;
}

/* (57) */
static long double law_compression(long double load, double nu, enum cor_disk_datum datum)
{
    return load / pi * (logl(4 * pi / load) + constant_b(nu, datum));
}

static long double law_energy(long double load, double nu, enum cor_disk_datum datum)
{
    return load * load / (2 * pi) * (logl(4 * pi / load) + constant_b(nu, datum) - 0.5L);
}

static double random_nu(struct random_state *r)
{
    const double kind = random_uniform(r, 0, 4);
    if (kind < 0.5)
        return 1 - ldexp(1, -(int)random_uniform(r, 1, 54));
    if (kind < 1)
        return ldexp(1, -(int)random_uniform(r, 1, 54)) - 1;
    return random_uniform(r, -1, 1);
}

static enum cor_disk_datum random_datum(struct random_state *r)
{
    return datums[(int)random_uniform(r, 0, 3)];
}

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

/* ---- limits ---- */

/* Each limit is the exact one rounded towards zero, and the last argument of its functions. */
TEST(limits)
{
    static const struct {
        double (*value)(double, enum cor_disk_datum);
        double power;
    } limit[4] = {{cor_disk_load_limit, 1},
                  {cor_disk_compression_limit, 1},
                  {cor_disk_energy_limit, 2},
                  {cor_disk_speed_limit, 1}};
    const long double factor[4] = {4 * pi, 4, 4 * pi, 2 * sqrtl(2)};
    struct random_state random = random_start();
    for (size_t i = 0; i < points(3000); i++) {
        const double nu = random_nu(&random);
        const enum cor_disk_datum datum = random_datum(&random);
        for (int k = 0; k < 4; k++) {
            const long double exact = factor[k] * expl(limit[k].power * (constant_b(nu, datum) - 1));
            const double end = limit[k].value(nu, datum);
            check(end <= exact * (1 + 8 * slack) && nextafter(end, 8) > exact * (1 - 8 * slack),
                  "limit %d at nu = %a, datum %d: %a, %La", k, nu, (int)datum, end, exact);
        }
        for (int k = 0; k < FUNCTIONS; k++) {
            const double end = functions[k].limit(nu, datum);
            check(functions[k].value(end, nu, datum) > 0, "%s at its limit, nu = %a", functions[k].name, nu);
            check(isnan(functions[k].value(nextafter(end, 8), nu, datum)), "%s beyond its limit, nu = %a",
                  functions[k].name, nu);
        }
    }
}

/* ---- the law in long double ---- */

TEST(law)
{
    struct random_state random = random_start();
    long double worst[2] = {0};
    for (size_t i = 0; i < points(20000); i++) {
        const double nu = random_nu(&random);
        const enum cor_disk_datum datum = random_datum(&random);
        double load = random_argument(&random, cor_disk_load_limit(nu, datum));
        const long double delta = ulp_error(cor_disk_compression(load, nu, datum), law_compression(load, nu, datum));
        const long double energy = ulp_error(cor_disk_energy(load, nu, datum), law_energy(load, nu, datum));
        worst[0] = fmaxl(worst[0], delta);
        worst[1] = fmaxl(worst[1], energy);
        check(delta <= COR_DISK_LAW_MAX_ULP, "compression(%a), nu = %a: %Lg ulp", load, nu, delta);
        check(energy <= COR_DISK_LAW_MAX_ULP, "energy(%a), nu = %a: %Lg ulp", load, nu, energy);
    }
    print_message("compression %.2Lf, energy %.2Lf ulp at the worst\n", worst[0], worst[1]);
}

/* The inverses put back into the law, which is t/(1 + t) and 2 t/(1/2 + t) times as far off; V = pi v^2/2. */
TEST(inverses)
{
    struct random_state random = random_start();
    for (size_t i = 0; i < points(20000); i++) {
        const double nu = random_nu(&random);
        const enum cor_disk_datum datum = random_datum(&random);
        const long double bound = COR_DISK_LAW_MAX_ULP * DBL_EPSILON, b = constant_b(nu, datum);

        const double delta = random_argument(&random, cor_disk_compression_limit(nu, datum));
        const double load = cor_disk_load(delta, nu, datum);
        long double t = fmaxl(0, logl(4 * pi / load) + b - 1);
        check(fabsl(law_compression(load, nu, datum) / delta - 1) <= bound * t / (1 + t) + slack,
              "load(%a) = %a, nu = %a", delta, load, nu);

        const double energy = random_argument(&random, cor_disk_energy_limit(nu, datum));
        const double load_of_energy = cor_disk_load_of_energy(energy, nu, datum);
        t = fmaxl(0, logl(4 * pi / load_of_energy) + b - 1);
        check(fabsl(law_energy(load_of_energy, nu, datum) / energy - 1) <= bound * 2 * t / (0.5L + t) + slack,
              "load_of_energy(%a) = %a, nu = %a", energy, load_of_energy, nu);

        const double speed = random_argument(&random, cor_disk_speed_limit(nu, datum));
        const double max_load = cor_disk_max_load(speed, nu, datum);
        const double max_compression = cor_disk_max_compression(speed, nu, datum);
        t = fmaxl(0, logl(4 * pi / max_load) + b - 1);
        check(fabsl(law_energy(max_load, nu, datum) / (pi * speed * speed / 2) - 1) <=
                  bound * 2 * t / (0.5L + t) + slack,
              "max_load(%a) = %a, nu = %a", speed, max_load, nu);
        check(fabsl(law_compression(max_load, nu, datum) / max_compression - 1) <= bound * (1 + t / (1 + t)) + slack,
              "max_compression(%a) = %a, nu = %a", speed, max_compression, nu);
    }
}

/* V = int P ddelta, by Gauss's rule of four points */
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
        }
}

/* ---- contact time ---- */

/* t - ln(1 + t) = q by Newton's method; close to q = 0 no more than absolutely good */
static long double t_of_q(long double q)
{
    long double t = q + sqrtl(2 * q) + 1e-6L;
    for (int i = 0; i < 60; i++) {
        const long double step = (t - log1pl(t) - q) * (1 + t) / t;
        t -= step;
        if (!(fabsl(step) > 1e-19L * t))
            break;
    }
    return t;
}

/* The integral over theta, by tanh-sinh: theta or pi/2 - theta = (pi/2)/(1 + exp(pi sinh(y))) */
static long double contact_time_over_theta(double speed, double nu, enum cor_disk_datum datum)
{
    const long double q = 2 * (1.5L * ln2 + constant_b(nu, datum) - 1 - logl(speed));
    const int steps = 28;
    long double sum = 0;
    for (int k = -7 * steps / 2; k <= 7 * steps / 2; k++) {
        const long double y = (long double)k / steps, e = expl(-pi * sinhl(fabsl(y)));
        const long double angle = pi / 2 * e / (1 + e), weight = coshl(y) * e / ((1 + e) * (1 + e));
        const long double log_sine = k > 0 ? log1pl(-sinl(angle) * sinl(angle)) / 2 : logl(sinl(angle));
        sum += weight * sqrtl(1 + t_of_q(q - 2 * log_sine));
    }
    return sqrtl(2) * pi * pi / 2 * sum / steps;
}

TEST(contact_time)
{
    struct random_state random = random_start();
    long double worst = 0;
    for (size_t i = 0; i < points(300); i++) {
        const double nu = random_nu(&random);
        const enum cor_disk_datum datum = random_datum(&random);
        const double end = cor_disk_speed_limit(nu, datum);
        const double v = i % 3 == 0   ? end * random_log(&random, 1e-290, 1e-3)
                         : i % 3 == 1 ? end * random_log(&random, 1e-3, 0.9)
                                      : end * (1 - random_log(&random, 1e-4, 0.3));
        const long double error =
            relative_error(cor_disk_contact_time(v, nu, datum), contact_time_over_theta(v, nu, datum));
        worst = fmaxl(worst, error);
        check(error <= COR_DISK_CONTACT_TIME_MAX_ERROR + 8 * slack, "%a, nu = %a, datum %d: %Lg", v, nu, (int)datum,
              error);
    }
    print_message("contact time: %.2Lg at the worst\n", worst);
    /* of the theory's check, nu = 0.33 and the printed b */
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

/* Results that are no normal doubles: the same law in units in which they are. */
TEST(subnormal_results)
{
    struct random_state random = random_start();
    for (size_t i = 0; i < points(5000); i++) {
        const double nu = random_nu(&random), x = random_log(&random, 1e-323, 1e-305);
        const enum cor_disk_datum datum = random_datum(&random);
        const long double delta = law_compression(x, nu, datum);
        check(ulp_error(cor_disk_compression(x, nu, datum), delta) <= COR_DISK_LAW_MAX_ULP, "compression(%a)", x);
        const double load = random_log(&random, 1e-163, 1e-152);
        check(ulp_error(cor_disk_energy(load, nu, datum), law_energy(load, nu, datum)) <= COR_DISK_LAW_MAX_ULP,
              "energy(%a)", load);
        const double back = cor_disk_load_of_energy(x, nu, datum);
        check(fabsl(law_energy(back, nu, datum) / x - 1) <= 2 * COR_DISK_LAW_MAX_ULP * DBL_EPSILON,
              "load_of_energy(%a)", x);
        /* far from the limit a slightly smaller P is a slightly smaller delta: to one unit of the last place */
        const double p = cor_disk_load(x, nu, datum), step = (double)ulp(p) * COR_DISK_LAW_MAX_ULP;
        check(law_compression(p + step, nu, datum) >= x && (p <= step || law_compression(p - step, nu, datum) <= x),
              "load(%a) = %a", x, p);
    }
    assert_true(cor_disk_energy(1e-200, 0, COR_DISK_DATUM_DIAMETER) == 0);
    assert_true(cor_disk_energy_leading_log(smallest) == 0);
}

RUN_TESTS(limits, law, inverses, energy_is_work, contact_time, special_values, subnormal_results, leading_logarithms)
