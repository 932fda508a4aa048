/* SPDX-License-Identifier: MIT */
/* Rayleigh's energy where its integral cancels or oscillates, against sinc functions in interval arithmetic. */
#include "stability.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <cor/disk.h>
#include <cor/status.h>

#include "disk_reference.h"

enum { BITS = 192 };

static double fractions[1800];

/* Fraction of a mode, C as the table has it; and, if slope is not NULL, d ln fraction/d ln v by a difference */
static void exact_fraction(arb_t fraction, const struct indefinite *f, const struct cor_disk_mode *mode)
{
    arb_t c;
    arb_init(c);
    indefinite_integral(fraction, f, mode->omega);
    arb_set_d(c, mode->c);
    arb_mul(fraction, fraction, c, BITS);
    arb_mul_2exp_si(fraction, fraction, 1);
    arb_sqr(fraction, fraction, BITS);
    arb_clear(c);
}

/* The worst of some modes, in units of what disk.h allows */
static void take_modes(struct outcome *out, const struct cor_disk_modes *table, enum cor_disk_datum datum, double v,
                       int level, const size_t *which, size_t count)
{
    struct indefinite f;
    struct cor_disk_rayleigh r;
    arb_t exact, value;
    char name[80];
    arb_init(exact);
    arb_init(value);
    const int status = cor_disk_rayleigh(table, table->count, datum, v, &r, fractions);
    if (status != COR_OK && status != COR_BEYOND_THEORY)
        outcome_take(out, HUGE_VAL, "cor_disk_rayleigh", "COR_OK", cor_status_text(status));
    indefinite_init(&f, v, table->nu, datum, level, BITS);
    for (size_t i = 0; i < count; i++) {
        const size_t k = which[i];
        exact_fraction(exact, &f, &table->mode[k]);
        arb_set_d(value, fractions[k]);
        const double allowed =
            fmax(COR_DISK_RAYLEIGH_MAX_ERROR * upper(exact), COR_DISK_RAYLEIGH_MAX_ABSOLUTE * r.fraction);
        snprintf(name, sizeof name, "(%d,%d), omega = %.4g, v", table->mode[k].n, table->mode[k].l,
                 table->mode[k].omega);
        take_number(out, ball_absolute(value, exact) / allowed, name, v, exact, fractions[k]);
    }
    indefinite_clear(&f);
    arb_clear(exact);
    arb_clear(value);
}

static const size_t quadrupole[] = {0};

/* cos(omega tau/2) = 0 at 1e-2; then the zero of I itself, found by bisection, where the condition has no bound */
static void zero_of_quadrupole(struct outcome *out, bool full)
{
    const struct cor_disk_modes *const table = &cor_disk_modes_nu033;
    const enum cor_disk_datum datum = COR_DISK_DATUM_CENTRE_OF_MASS;
    double low = 0.008, high = 0.02; /* I changes its sign between them */
    arb_t at_low, at, near;
    struct indefinite f;
    arb_init(at_low);
    arb_init(at);
    arb_init(near);
    take_modes(out, table, datum, 1e-2, 6, quadrupole, 1);
    double sign = 0;
    for (int i = 0; i < 60 && high > low; i++) {
        const double v = i == 0 ? low : i == 1 ? high : low + (high - low) / 2;
        if (i > 1 && (v <= low || v >= high))
            break;
        indefinite_init(&f, v, table->nu, datum, 5, 128);
        indefinite_integral(at, &f, table->mode[0].omega);
        indefinite_clear(&f);
        const double value = arf_get_d(arb_midref(at), ARF_RND_NEAR);
        if (i == 0)
            sign = value;
        else if (i == 1 && !(sign * value < 0))
            outcome_take(out, HUGE_VAL, "the zero of I", "between 0.008 and 0.02", "no change of sign");
        else if (i > 1 && value * sign > 0)
            low = v;
        else if (i > 1)
            high = v;
    }
    /* d ln fraction/d ln v = 2 v I'/I at the double next to the zero */
    indefinite_init(&f, low, table->nu, datum, 5, 128);
    indefinite_integral(at, &f, table->mode[0].omega);
    indefinite_clear(&f);
    indefinite_init(&f, low * (1 + 0x1p-30), table->nu, datum, 5, 128);
    indefinite_integral(near, &f, table->mode[0].omega);
    indefinite_clear(&f);
    out->condition =
        2 * fabs(arf_get_d(arb_midref(near), ARF_RND_NEAR) / arf_get_d(arb_midref(at), ARF_RND_NEAR) - 1) * 0x1p30;
    static const double off[] = {0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3};
    for (size_t i = 0; i < sizeof off / sizeof *off; i++)
        for (int side = -1; side <= (full ? 1 : 0); side += 2)
            take_modes(out, table, datum, low * (1 + side * off[i]), full ? 7 : 6, quadrupole, 1);
    arb_clear(at_low);
    arb_clear(at);
    arb_clear(near);
}

/* omega tau to 1700 */
static void fast_modes(struct outcome *out, bool full)
{
    static const size_t some[] = {0, 3, 100, 900, 1799};
    take_modes(out, &cor_disk_modes_nu033, COR_DISK_DATUM_CENTRE_OF_MASS, 1e-8, 9, some, 5);
    if (full) {
        static size_t all[360];
        for (size_t i = 0; i < 360; i++)
            all[i] = 5 * i;
        take_modes(out, &cor_disk_modes_nu033, COR_DISK_DATUM_PRINTED, 1e-4, 9, all, 360);
        take_modes(out, &cor_disk_modes_nu090, COR_DISK_DATUM_CENTRE_OF_MASS, 1e-300, 10, some, 5);
        take_modes(out, &cor_disk_modes_nu090, COR_DISK_DATUM_DIAMETER, 0.02, 9, all, 360);
    }
}

static void slow_modes(struct outcome *out, bool full)
{
    static const size_t some[] = {0, 1, 2, 3, 20};
    take_modes(out, &cor_disk_modes_nu033, COR_DISK_DATUM_CENTRE_OF_MASS, 1e-12, 6, some, 5);
    if (full) {
        take_modes(out, &cor_disk_modes_nu090, COR_DISK_DATUM_CENTRE_OF_MASS, 1e-12, 8, some, 5);
        take_modes(out, &cor_disk_modes_nu033, COR_DISK_DATUM_PRINTED, 0x1p-1074, 8, some, 5);
        take_modes(out, &cor_disk_modes_nu033, COR_DISK_DATUM_DIAMETER, 1e-100, 8, some, 5);
    }
}

/* Beyond the theory, and to be said so; still the integral it is */
static void fraction_at_edge(struct outcome *out, bool full)
{
    static const size_t some[] = {0, 1, 2, 50, 400};
    for (int i = 0; i < (full ? 2 : 1); i++) {
        const struct cor_disk_modes *const table = i ? &cor_disk_modes_nu090 : &cor_disk_modes_nu033;
        static const double from_edge[] = {0, 0x1p-50, 1e-6, 1e-2};
        for (size_t k = 0; k < (full ? 4 : 2); k++) {
            const double limit = cor_disk_speed_limit(table->nu, COR_DISK_DATUM_CENTRE_OF_MASS);
            const double v = limit - limit * from_edge[k];
            struct cor_disk_rayleigh r;
            take_modes(out, table, COR_DISK_DATUM_CENTRE_OF_MASS, v, 7, some, 5);
            if (cor_disk_rayleigh(table, 10, COR_DISK_DATUM_CENTRE_OF_MASS, v, &r, NULL) != COR_BEYOND_THEORY)
                outcome_take(out, HUGE_VAL, "v at the limit", "COR_BEYOND_THEORY", "no warning");
        }
    }
}

static const struct hard_case rayleigh_cases[] = {
    {"v at the edge of the domain",
     "Rayleigh's integrand has its branch point; no status says that perturbation theory has ended",
     "v at the limit, and 2^-50 before it, five modes of nu = 0.33 (full: 0.9 too)",
     "sinc functions in interval arithmetic", "of COR_DISK_RAYLEIGH_MAX_ERROR", 1, fraction_at_edge},
    {"the zero of the quadrupole", "no digit is left where the integral vanishes",
     "v = 1e-2, where cos(omega tau/2) = 0; the zero of I between 0.008 and 0.02 to the last double, and 1e-12 to 1e-3 "
     "from it",
     "sinc functions in interval arithmetic", "of 1e-10, or 1e-14 of the sum", 1, zero_of_quadrupole},
    {"omega tau >> 1", "the integrand oscillates a thousand times, and I is 1e-4 of it",
     "v = 1e-8, five modes, omega tau to 900 (full: every fifth of 1800; v = 1e-300)",
     "sinc functions in interval arithmetic, 3300 nodes", "of COR_DISK_RAYLEIGH_MAX_ERROR", 1, fast_modes},
    {"v = 1e-12", "the contact time is long, v^2 small",
     "five modes of nu = 0.33 (full: nu = 0.9, 1e-100, the smallest double)", "sinc functions in interval arithmetic",
     "of COR_DISK_RAYLEIGH_MAX_ERROR", 1, slow_modes},
};

const struct case_list stability_rayleigh = {rayleigh_cases, sizeof rayleigh_cases / sizeof *rayleigh_cases};
