/* SPDX-License-Identifier: MIT */
/* Tests the quasistatic contact law of the disk (cor/disk.h), and its Lambert W (runtime/number/lambert_w.h), against
 * balls. Tests random arguments of every magnitude, nu up to its ends, the doubles on both sides of every limit, and
 * one ulp around every branch. The exact load uses arb_lambertw, and must satisfy equation (57). The exact contact time
 * is an integral over theta, in long double. Prints one line for each function; the documentation quotes these lines.
 * --help lists the options. */
#include "cor/disk.h"

#include "reference_rayleigh.h"
#include "runtime/number/lambert_w.h"
#include "search.h"
#include "support/digits.h"
#include "support/formula.h"
#include "support/local.h"
#include "ulp.h"

#include <stdio.h>

/* ---- random numbers ---- */

static struct random_state random_state;

static int choice(int count)
{
    return (int)random_uniform(&random_state, 0, count);
}

static double random_nu(void)
{
    const double sign = choice(2) ? 1 : -1;
    switch (choice(8)) {
    case 0:
        return sign * (1 - ldexp(1, -1 - choice(53)));
    case 1:
        return sign * exp(random_uniform(&random_state, -700, 0));
    case 2:
        return choice(2) ? 0.33 : 0.9;
    default:
        return sign * random_uniform(&random_state, 0, 1);
    }
}

/* ---- the law in balls ---- */

/* The compression by equation (57), and the energy */
#define COMPRESSION "load/pi*(log(4*pi/load) + b)"
#define ENERGY "load^2/(2*pi)*(log(4*pi/load) + b - 1/2)"

/* The tested functions. In the formula `x`, x is the argument. Its value is the compression or energy that determines
 * the load or, if z is NULL, the load. In the other formulas x is this value, and w is -W_-1(-z). load: the exact load.
 * law: x as a function of the load, which must agree. */
static const struct disk_function {
    const char *name;
    double (*value)(double argument, double nu, enum cor_disk_datum datum);
    double (*limit)(double nu, enum cor_disk_datum datum); /* the largest argument */
    const char *exact_limit;
    const char *x, *z, *load;
    const char *law, *value_of_load;
} disk_functions[] = {
    {"load", cor_disk_load, cor_disk_compression_limit, "4*exp(b - 1)", "x", "x*exp(-b)/4", "pi*x/w", COMPRESSION,
     "load"},
    {"compression", cor_disk_compression, cor_disk_load_limit, "4*pi*exp(b - 1)", "x", NULL, NULL, NULL, COMPRESSION},
    {"energy", cor_disk_energy, cor_disk_load_limit, "4*pi*exp(b - 1)", "x", NULL, NULL, NULL, ENERGY},
    {"load_of_energy", cor_disk_load_of_energy, cor_disk_energy_limit, "4*pi*exp(2*b - 2)", "x",
     "x*exp(1 - 2*b)/(4*pi)", "sqrt(4*pi*x/w)", ENERGY, "load"},
    {"max_load", cor_disk_max_load, cor_disk_speed_limit, "sqrt(8)*exp(b - 1)", "pi/2*x^2", "x*exp(1 - 2*b)/(4*pi)",
     "sqrt(4*pi*x/w)", ENERGY, "load"},
    {"max_compression", cor_disk_max_compression, cor_disk_speed_limit, "sqrt(8)*exp(b - 1)", "pi/2*x^2",
     "x*exp(1 - 2*b)/(4*pi)", "sqrt(4*pi*x/w)", ENERGY, COMPRESSION},
};

/* b of (57) for each datum */
static const char *const constant_b[] = {"-2*log(2) - (1 + nu)/4", "-1", "-1 - nu"};

/* Computes -W_-1(-z). */
static void disk_minus_w(arb_t w, const arb_t z, slong prec)
{
    arb_neg(w, z);
    arb_lambertw(w, w, 1, prec);
    arb_neg(w, w);
}

/* Computes the exact value of a function. Returns false if this value contradicts equation (57). */
static bool disk_value(arb_t y, const struct disk_function *f, double argument, double nu, enum cor_disk_datum datum,
                       slong prec)
{
    bool consistent = true;
    LOCAL(arb, b, x, w, load);
    LET(b, prec, constant_b[datum], nu);
    arb_set_d(x, argument);
    LET(x, prec, f->x, x);
    arb_set(load, x);
    if (f->z) {
        LET(w, prec, f->z, x, b);
        disk_minus_w(w, w, prec);
        LET(load, prec, f->load, x, w);
        LET(w, prec, f->law, load, b);
        consistent = arb_overlaps(w, x);
    }
    LET(y, prec, f->value_of_load, load, b);
    return consistent;
}

/* ---- errors ---- */

/* Returns the distance of a double from a ball, in ulp of the ball; -1 if the ball is too wide to decide. */
static double ball_error(double computed, const arb_t exact)
{
    if (!(fabs(computed) <= DBL_MAX) || !arb_is_finite(exact))
        return HUGE_VAL;
    LOCAL(arb, off);
    /* 2^(exponent - 1) <= |exact| < 2^exponent */
    const slong exponent = fmpz_get_si(ARF_EXPREF(arb_midref(exact)));
    const slong unit = (exponent < DBL_MIN_EXP ? DBL_MIN_EXP : exponent) - DBL_MANT_DIG;
    arb_set_d(off, computed);
    arb_sub(off, off, exact, 64);
    arb_mul_2exp_si(off, off, -unit);
    arb_abs(off, off);
    const double error = arf_get_d(arb_midref(off), ARF_RND_UP), radius = mag_get_d(arb_radref(off));
    return radius < 1e-4 ? error + radius : -1;
}

/* ---- algebraic functions ---- */

/* Arguments at which the code begins to scale by a power of two */
static const double unit_boundary[] = {0x1p-900, 0x1p-200, DBL_MIN};

/* Values of ln(limit/argument) at which the code branches. For functions of a speed the values are half as large. */
static const double boundary[] = {0.5, 0.1, 3, 0.25, 128, 0.05, 1.5, 0.125, 64};
enum { BOUNDARIES = sizeof boundary / sizeof *boundary };

static double moved(double x, int steps)
{
    return double_of(bits_of(x) + (uint64_t)(int64_t)steps);
}

static double random_argument(const struct disk_function *f, double nu, enum cor_disk_datum datum)
{
    const double limit = f->limit(nu, datum);
    switch (choice(10)) {
    case 0:
        return moved(limit, -choice(4));
    case 1:
        return moved(limit * exp(-boundary[choice(BOUNDARIES)]), choice(7) - 3);
    case 2:
        return moved(unit_boundary[choice(3)], choice(7) - 3);
    case 3:
        return double_of(1 + (uint64_t)random_uniform(&random_state, 0, 0x1p52)); /* subnormal */
    case 4:
        return limit * exp(-random_uniform(&random_state, 0, 700));
    case 5:
    case 6:
        return fmin(limit, limit * (1 - exp(random_uniform(&random_state, -37, 0))));
    default:
        return limit * exp(-random_uniform(&random_state, 0, 7));
    }
}

static int search_laws(uint64_t points)
{
    int good = 1;
    LOCAL(arb, exact);
    for (const struct disk_function *f = disk_functions; f < disk_functions + COUNT_OF(disk_functions); f++) {
        struct worst worst = {0};
        for (uint64_t i = 0; i < points; i++) {
            const double nu = random_nu();
            const enum cor_disk_datum datum = (enum cor_disk_datum)choice(3);
            const double x = random_argument(f, nu, datum), y = f->value(x, nu, datum);
            double error = -1;
            struct precision p = precision_doubling(128, 5000);
            do {
                if (!disk_value(exact, f, x, nu, datum, p.bits)) {
                    printf("the reference contradicts (57) at %a\n", x);
                    good = 0;
                }
                error = ball_error(y, exact);
                if (error == HUGE_VAL && !arb_is_finite(exact))
                    error = -1; /* the ball is too wide to be inside the domain */
            } while (error < 0 && precision_raise(&p));
            worst_take(&worst, error < 0 ? HUGE_VAL : error, x);
        }
        good &= worst_report(f->name, &worst, COR_DISK_LAW_MAX_ULP);
    }
    return good;
}

/* Checks that each limit is in the domain, that the next double is not, and that all functions have the same domain. */
static int search_limits(uint64_t points)
{
    uint64_t wrong = 0;
    LOCAL(arb, b, exact, x);
    for (uint64_t i = 0; i < points; i++) {
        const double nu = random_nu();
        const enum cor_disk_datum datum = (enum cor_disk_datum)choice(3);
        const struct disk_function *const f = &disk_functions[choice((int)COUNT_OF(disk_functions))];
        const double limit = f->limit(nu, datum), beyond = moved(limit, 1);
        LET(b, 256, constant_b[datum], nu);
        LET(exact, 256, f->exact_limit, b);
        arb_set_d(x, limit);
        int good = arb_le(x, exact);
        arb_set_d(x, beyond);
        good &= arb_gt(x, exact);
        good &= !isnan(f->value(limit, nu, datum)) && isnan(f->value(beyond, nu, datum));
        if (f->value == cor_disk_max_load)
            good &= !isnan(cor_disk_contact_time(limit, nu, datum)) && isnan(cor_disk_contact_time(beyond, nu, datum));
        if (!good && wrong++ == 0)
            printf("limit of %s: %a at nu = %a, datum %d\n", f->name, limit, nu, (int)datum);
    }
    printf("%-4s  limits: %llu of %llu wrong\n", wrong == 0 ? "ok" : "FAIL", (unsigned long long)wrong,
           (unsigned long long)points);
    return wrong == 0;
}

/* ---- Lambert's W ---- */

/* Tests t(q) of runtime/number/lambert_w.h for q of every magnitude, also around the branches. */
static int search_lambert(uint64_t points)
{
    struct worst worst = {0};
    LOCAL(arb, x, y);
    for (uint64_t i = 0; i < points; i++) {
        static const double of_t[] = {0x1p-500, 0.1, 3};
        const int kind = choice(4);
        const double q = kind == 0   ? moved(of_t[choice(3)], choice(7) - 3)
                         : kind == 1 ? exp(random_uniform(&random_state, -700, 8))
                         : kind == 2 ? exp(random_uniform(&random_state, -4, 2))
                                     : random_uniform(&random_state, 0, 10);
        /* W loses half of its digits near its branch point, that is, for small q */
        double error = -1;
        for (slong prec = 128 + (q < 1 ? (slong)(-1.5 * log2(q)) : 0); error < 0; prec = 3000) {
            LET(x, prec + 1100, "exp(-1 - q)", q);
            disk_minus_w(y, x, prec);
            arb_sub_ui(y, y, 1, prec);
            error = arb_is_finite(y) ? ball_error(cor_lambert_t(q), y) : -1;
            if (prec == 3000)
                break;
        }
        worst_take(&worst, error < 0 ? HUGE_VAL : error, q);
    }
    return worst_report("t of q", &worst, 2);
}

/* ---- contact time ---- */

static int search_contact_time(uint64_t points)
{
    const struct cor_disk_mode mode = {2, 0, 1, 1, 0};
    struct worst worst = {0};
    for (uint64_t i = 0; i < points; i++) {
        const double nu = random_nu();
        const enum cor_disk_datum datum = (enum cor_disk_datum)choice(3);
        const double v = random_argument(&disk_functions[COUNT_OF(disk_functions) - 1], nu, datum); /* a speed */
        long double fraction;
        const long double exact = reference_rayleigh(&mode, 1, nu, datum, v, &fraction);
        const double error = (double)fabsl(cor_disk_contact_time(v, nu, datum) / exact - 1);
        worst_take(&worst, error / COR_DISK_CONTACT_TIME_MAX_ERROR, v);
    }
    return worst_report("contact_time, of its bound", &worst, 1);
}

/* ---- */

int main(int argc, char **argv)
{
    static const char help[] = "test_disk_law [--points N] [--times N] [--seed N]\n"
                               "    --points N  random arguments for each algebraic function, 25000 if not said\n"
                               "    --times N   random arguments for the contact time, 100 if not said\n";
    struct search_options o = {.points = 25000, .times = 100, .seed = 19990101, .threads = 1};
    const int status = search_options_read(&o, argc, argv, help);
    if (status != 0)
        return status;
    random_state = random_seeded(o.seed);
    worst_heading(o.seed);
    int good = search_laws(o.points);
    good &= search_limits(o.points);
    good &= search_lambert(o.points);
    good &= search_contact_time(o.times);
    flint_cleanup();
    return good ? 0 : 1;
}
