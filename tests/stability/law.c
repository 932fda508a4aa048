/* SPDX-License-Identifier: MIT */
/* Disks: the quasistatic law and Lambert's W at their ends. */
#include "stability.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#include <cor/disk.h>

#include "disk_reference.h"
#include "runtime/core/lambert_w.h"
#include "support/precision.h"

enum { BITS = 256 };

static const enum cor_disk_datum datums[3] = {COR_DISK_DATUM_CENTRE_OF_MASS, COR_DISK_DATUM_DIAMETER,
                                              COR_DISK_DATUM_PRINTED};

static void take_law(struct outcome *out, enum disk_kind kind, double argument, double nu, enum cor_disk_datum datum)
{
    arb_t exact;
    arb_init(exact);
    const double y = disk_functions[kind].value(argument, nu, datum);
    double error = HUGE_VAL;
    struct precision p = precision_doubling_to(BITS, 5000);
    do
        error = disk_value(exact, kind, argument, nu, datum, p.bits) ? ball_ulp(y, exact) : HUGE_VAL;
    while (!(error < 100) && precision_raise(&p));
    take_number(out, error, disk_functions[kind].name, argument, exact, y);
    arb_clear(exact);
}

/* ---- W ---- */

static void take_w(struct outcome *out, double z)
{
    arb_t w, x, condition;
    arb_init(w);
    arb_init(x);
    arb_init(condition);
    arb_set_d(x, z);
    arb_lambertw(w, x, 1, 400);
    arb_add_ui(condition, w, 1, 100); /* d ln W/d ln z = 1/(1 + W) */
    arb_inv(condition, condition, 53);
    out->condition = fmax(out->condition, upper(condition));
    const double y = cor_lambert_w_minus1(z);
    take_number(out, ball_ulp(y, w), "z", z, w, y);
    arb_clear(w);
    arb_clear(x);
    arb_clear(condition);
}

static void w_far(struct outcome *out, bool full)
{
    take_w(out, -1e-60);
    for (int i = 0; i < (full ? 200000 : 4000); i++)
        take_w(out, i % 4 == 0 ? moved(-1e-60, i / 4) : -exp(-drawn(2, 744)));
    for (int i = 1; i < 40; i++)
        take_w(out, -moved(0, i));
    out->condition = 0;
}

/* The branch point is between -1/e and the next double above it */
static const double branch = -0x1.78b56362cef37p-2;

static void w_branch(struct outcome *out, bool full)
{
    for (int i = 0; i < (full ? 100000 : 3000); i++)
        take_w(out, moved(branch, -(i < 1000 ? i : (long)exp(drawn(0, 36)))));
    if (!isnan(cor_lambert_w_minus1(moved(branch, 1))) || !isnan(cor_lambert_w_minus1(-1)))
        outcome_take(out, HUGE_VAL, "beyond the branch point", "nan", "a number");
}

/* ---- edges ---- */

static void edge_of_law(struct outcome *out, bool full)
{
    static const double nus[] = {0.33, 0.9, 0, 0.5, -0.9, 1 - 0x1p-53, -1 + 0x1p-53};
    for (size_t i = 0; i < sizeof nus / sizeof *nus; i++)
        for (int d = 0; d < 3; d++)
            for (enum disk_kind kind = 0; kind < DISK_KINDS; kind++) {
                const double limit = disk_functions[kind].limit(nus[i], datums[d]);
                for (int j = 0; j < (full ? 60 : 6); j++)
                    take_law(out, kind, moved(limit, j < 3 ? -j : -(long)exp(drawn(0, 36))), nus[i], datums[d]);
                if (!isnan(disk_functions[kind].value(moved(limit, 1), nus[i], datums[d])))
                    outcome_take(out, HUGE_VAL, disk_functions[kind].name, "nan beyond the limit", "a number");
            }
}

static void take_time(struct outcome *out, double v, double nu, enum cor_disk_datum datum, int level)
{
    arb_t tau, value, halved;
    arb_init(tau);
    arb_init(value);
    arb_init(halved);
    const double y = cor_disk_contact_time(v, nu, datum);
    disk_contact_time(tau, halved, v, nu, datum, level, 200);
    arb_set_d(value, y);
    take_number(out, ball_relative(value, tau) / COR_DISK_CONTACT_TIME_MAX_ERROR, "v", v, tau, y);
    arb_clear(tau);
    arb_clear(value);
    arb_clear(halved);
}

static void edge_of_time(struct outcome *out, bool full)
{
    static const double from_edge[] = {0, 0x1p-53, 0x1p-40, 1e-8, 1e-4, 1e-2, 0.1};
    for (size_t i = 0; i < sizeof from_edge / sizeof *from_edge; i++)
        for (int d = 0; d < (full ? 3 : 1); d++) {
            const double nu = i % 2 ? 0.33 : 0.9, limit = cor_disk_speed_limit(nu, datums[d]);
            take_time(out, limit - limit * from_edge[i], nu, datums[d], full ? 7 : 6);
        }
}

static void slow_law(struct outcome *out, bool full)
{
    static const double v[] = {1e-12, 1e-300, DBL_MIN, 0x1p-1074, 1e-8};
    for (size_t i = 0; i < sizeof v / sizeof *v; i++)
        for (int d = 0; d < 3; d++)
            for (enum disk_kind kind = 0; kind < DISK_KINDS; kind++)
                for (int j = -1; j <= (full ? 20 : 1); j++)
                    if (moved(v[i], j) > 0)
                        take_law(out, kind, moved(v[i], j), 0.33, datums[d]);
}

static void slow_time(struct outcome *out, bool full)
{
    static const double v[] = {1e-12, 1e-300, 0x1p-1074, 1e-8, 1e-4};
    for (size_t i = 0; i < (full ? 5 : 3); i++)
        take_time(out, v[i], 0.33, COR_DISK_DATUM_CENTRE_OF_MASS, 6);
}

static void take_nu(struct outcome *out, double nu, bool full)
{
    for (int d = 0; d < 3; d++)
        for (enum disk_kind kind = 0; kind < DISK_KINDS; kind++) {
            const double limit = disk_functions[kind].limit(nu, datums[d]);
            for (int i = 0; i < (full ? 200 : 12); i++)
                take_law(out, kind, limit * exp(-drawn(0, i % 2 ? 2 : 60)), nu, datums[d]);
        }
}

static void nu_to_one(struct outcome *out, bool full)
{
    for (int i = 1; i <= 5; i++)
        take_nu(out, 1 - i * 0x1p-53, full);
    for (enum disk_kind kind = 0; kind < DISK_KINDS; kind++)
        if (!isnan(disk_functions[kind].value(1e-3, 1, COR_DISK_DATUM_DIAMETER)) ||
            !isnan(disk_functions[kind].value(1e-3, 2, COR_DISK_DATUM_PRINTED)))
            outcome_take(out, HUGE_VAL, "nu = 1", "nan", "a number");
}

static void nu_to_minus_one(struct outcome *out, bool full)
{
    for (int i = 1; i <= 5; i++)
        take_nu(out, -1 + i * 0x1p-53, full);
    for (enum disk_kind kind = 0; kind < DISK_KINDS; kind++)
        if (!isnan(disk_functions[kind].value(1e-3, -1, COR_DISK_DATUM_DIAMETER)) ||
            !isnan(disk_functions[kind].value(1e-3, -HUGE_VAL, COR_DISK_DATUM_PRINTED)))
            outcome_take(out, HUGE_VAL, "nu = -1", "nan", "a number");
}

static const struct hard_case law_cases[] = {
    {"W_-1 at -1e-60", "the first guess is far off, or z underflows",
     "1000 doubles from -1e-60 on, 3000 of every size (full: 50 times as many), the smallest", "Arb", "ulp", 2, w_far},
    {"W_-1 at the branch point", "half of the digits are lost: d ln W/d ln z = 1/(1 + W) has no bound",
     "the last 1000 doubles and 2000 to 2^-1 from it", "Arb", "ulp, not divided by the condition", 2, w_branch},
    {"v at the edge of the domain", "the root of 0, or of less; the domain ends a double too early or late",
     "arguments of six laws at their limits and 1 to 2^52 ulp inside, seven nu, three datums",
     "(57) in interval arithmetic, W by Arb", "ulp", COR_DISK_LAW_MAX_ULP, edge_of_law},
    {"v at the edge of the domain", "the integrand of the time is a root with a branch point at mid-collision",
     "v at the limit and 1e-16 to 0.1 before it", "tanh-sinh rule in interval arithmetic",
     "of COR_DISK_CONTACT_TIME_MAX_ERROR", 1, edge_of_time},
    {"v = 1e-12", "v^2 exp(1 - 2 b) underflows",
     "six laws at 1e-12, 1e-300, the smallest normal and subnormal and next to them",
     "(57) in interval arithmetic, W by Arb", "ulp", COR_DISK_LAW_MAX_ULP, slow_law},
    {"v = 1e-12", "the same in the time", "1e-12, 1e-300 and the smallest double",
     "tanh-sinh rule in interval arithmetic", "of COR_DISK_CONTACT_TIME_MAX_ERROR", 1, slow_time},
    {"nu -> 1", "b loses digits; limits", "six laws for the last five doubles below 1; nu = 1 and beyond",
     "(57) in interval arithmetic, W by Arb", "ulp", COR_DISK_LAW_MAX_ULP, nu_to_one},
    {"nu -> -1", "1 + nu cancels in b", "six laws for the first five doubles above -1; nu = -1 and beyond",
     "(57) in interval arithmetic, W by Arb", "ulp", COR_DISK_LAW_MAX_ULP, nu_to_minus_one},
};

const struct case_list stability_law = {law_cases, sizeof law_cases / sizeof *law_cases};
