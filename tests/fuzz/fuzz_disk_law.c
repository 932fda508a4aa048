/* SPDX-License-Identifier: MIT */
/* The contact law of disks on raw bit patterns: law and inverses, largest load and compression, contact time, limits,
 * leading logarithms. */
#include <limits.h>

#include "cor/disk.h"
#include "fuzz.h"

typedef double law_function(double, double, enum cor_disk_datum);
typedef double limit_function(double, enum cor_disk_datum);

struct quantity {
    const char *name;
    law_function *of;
    limit_function *domain, *range; /* range NULL: no limit */
    double at_zero;
};

static const struct quantity quantities[] = {
    {"load", cor_disk_load, cor_disk_compression_limit, cor_disk_load_limit, 0},
    {"compression", cor_disk_compression, cor_disk_load_limit, cor_disk_compression_limit, 0},
    {"energy", cor_disk_energy, cor_disk_load_limit, cor_disk_energy_limit, 0},
    {"load_of_energy", cor_disk_load_of_energy, cor_disk_energy_limit, cor_disk_load_limit, 0},
    {"max_load", cor_disk_max_load, cor_disk_speed_limit, cor_disk_load_limit, 0},
    {"max_compression", cor_disk_max_compression, cor_disk_speed_limit, cor_disk_compression_limit, 0},
    {"contact_time", cor_disk_contact_time, cor_disk_speed_limit, NULL, INFINITY},
};

struct leading {
    const char *name;
    double (*of)(double);
    double domain; /* from 0 up to this, */
    int closed;    /* itself too */
    double at_zero;
};

static const struct leading leading[] = {
    {"compression_leading_log", cor_disk_compression_leading_log, 4 * 3.14159265358979 / 2.718281828459045, 1, 0},
    {"load_leading_log", cor_disk_load_leading_log, 4, 0, 0},
    {"energy_leading_log", cor_disk_energy_leading_log, 4, 0, 0},
    {"max_compression_leading_log", cor_disk_max_compression_leading_log, 4, 1, 0},
    {"contact_time_leading_log", cor_disk_contact_time_leading_log, 4, 1, INFINITY},
};

static const double slack = 1 + COR_DISK_LAW_MAX_ULP * 0x1p-52;

static void check_value(const struct quantity *q, double x, double nu, enum cor_disk_datum datum)
{
    const double limit = q->domain(nu, datum), y = q->of(x, nu, datum);
    const int known = nu > -1 && nu < 1 && (unsigned)datum <= COR_DISK_DATUM_PRINTED;
    REQUIRE(known ? limit > 0 : isnan(limit), "%s: limit %a at nu = %a, datum %d", q->name, limit, nu, (int)datum);
    if (!(x >= 0 && x <= limit)) {
        REQUIRE(isnan(y), "%s(%a, %a, %d) = %a", q->name, x, nu, (int)datum, y);
        return;
    }
    REQUIRE(y >= 0 && (!q->range || y <= q->range(nu, datum) * slack), "%s(%a, %a, %d) = %a", q->name, x, nu,
            (int)datum, y);
    if (x == 0)
        REQUIRE(y == q->at_zero, "%s(%a, %a, %d) = %a", q->name, x, nu, (int)datum, y);
}

/* All grow but the time, which has a least value. */
static void check_order(const struct quantity *q, double x0, double x1, double nu, enum cor_disk_datum datum)
{
    const double y0 = q->of(x0, nu, datum), y1 = q->of(x1, nu, datum);
    if (!q->range || !(x0 < x1) || isnan(y0) || isnan(y1))
        return;
    REQUIRE(y0 <= y1 * slack * slack + 0x1p-1074, "%s: %a -> %a, %a -> %a; nu %a, datum %d", q->name, x0, y0, x1, y1,
            nu, (int)datum);
}

static void check_inverse(double load, double nu, enum cor_disk_datum datum)
{
    const double limit = cor_disk_load_limit(nu, datum);
    if (!(load > 0x1p-1000 && load <= 0.5 * limit))
        return; /* where the compression hardly grows, or is subnormal, the load is not well known */
    const double by_compression = cor_disk_load(cor_disk_compression(load, nu, datum), nu, datum);
    REQUIRE(fabs(by_compression - load) <= 64 * 0x1p-52 * load, "load %a, of its compression %a; nu %a, datum %d", load,
            by_compression, nu, (int)datum);
    if (load < 0x1p-480)
        return;
    const double by_energy = cor_disk_load_of_energy(cor_disk_energy(load, nu, datum), nu, datum);
    REQUIRE(fabs(by_energy - load) <= 64 * 0x1p-52 * load, "load %a, of its energy %a; nu %a, datum %d", load,
            by_energy, nu, (int)datum);
}

static void check_leading(const struct leading *l, double x)
{
    const double y = l->of(x);
    if (!(x >= 0) || x > l->domain * (1 + 1e-14) || (!l->closed && x >= l->domain))
        REQUIRE(isnan(y), "%s(%a) = %a", l->name, x, y);
    else if (x < l->domain * (1 - 1e-14))
        REQUIRE(y >= 0, "%s(%a) = %a", l->name, x, y);
    if (x == 0)
        REQUIRE(y == l->at_zero, "%s(%a) = %a", l->name, x, y);
}

/* The limits of hard walls and all modes */
static void check_limits(double speed, double nu)
{
    const double eps = cor_disk_eps(speed, nu), eps_off = cor_disk_eps_uncertainty(speed, nu),
                 loss = cor_disk_one_minus_eps2(speed, nu), loss_off = cor_disk_one_minus_eps2_uncertainty(speed, nu);
    if (!(speed >= COR_DISK_EPS_MIN_SPEED && speed <= COR_DISK_EPS_MAX_SPEED && nu >= COR_DISK_EPS_MIN_NU &&
          nu <= COR_DISK_EPS_MAX_NU)) {
        REQUIRE(isnan(eps) && isnan(eps_off) && isnan(loss) && isnan(loss_off), "v = %a, nu = %a: eps %a", speed, nu,
                eps);
        return;
    }
    REQUIRE(eps > 0 && eps < 1 && loss > 0 && loss < 1, "v = %a, nu = %a: eps %a, 1 - eps^2 %a", speed, nu, eps, loss);
    const double most =
        speed <= COR_DISK_EPS_CALM_SPEED ? COR_DISK_EPS_MAX_UNCERTAINTY : COR_DISK_EPS_MAX_UNCERTAINTY_FAST;
    REQUIRE(loss_off > 0 && loss_off <= most && eps_off > 0 && eps_off <= most, "v = %a, nu = %a: uncertainties %a, %a",
            speed, nu, eps_off, loss_off);
    REQUIRE(fabs(eps * eps + loss - 1) <= 4 * 0x1p-53, "v = %a, nu = %a: eps %a, 1 - eps^2 %a", speed, nu, eps, loss);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input in = {data, size};
    const uint8_t how = take_byte(&in);
    const enum cor_disk_datum datum = (enum cor_disk_datum)(how < 240 ? how % 3 : take_int(&in));
    const double nu = take_double(&in);
    for (int i = 0; i < 2; i++) {
        const double drawn = take_double(&in), other = take_double(&in);
        for (size_t k = 0; k < sizeof quantities / sizeof *quantities; k++) {
            const struct quantity *q = &quantities[k];
            /* i = 1: as a part of the domain, to its end */
            const double x = i == 0 ? drawn : fmin(fabs(drawn), 1) * q->domain(nu, datum);
            check_value(q, x, nu, datum);
            check_value(q, q->domain(nu, datum), nu, datum);
            check_value(q, nextafter(q->domain(nu, datum), INFINITY), nu, datum);
            check_order(q, x, other, nu, datum);
            check_order(q, x, nextafter(x, INFINITY), nu, datum);
        }
        check_inverse(drawn, nu, datum);
        for (size_t k = 0; k < sizeof leading / sizeof *leading; k++)
            check_leading(&leading[k], drawn);
        check_limits(drawn, nu);
        check_limits(fmin(fabs(drawn), 1) * 0.3, nu); /* mostly inside */
        check_limits(COR_DISK_EPS_MAX_SPEED, nu);
        check_limits(COR_DISK_EPS_MIN_SPEED, other);
    }
    return 0;
}
