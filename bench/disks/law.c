/* SPDX-License-Identifier: MIT */
/* The contact law of disks and the contact time, against what a user would write and the leading logarithms. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "disk.h"
#include "quadrature.h"

enum { POINTS = 2048, TIMES = 64 };

#define NU 0.33
static const enum cor_disk_datum datum = COR_DISK_DATUM_CENTRE_OF_MASS;
static const double pi = 3.14159265358979323846;
static double b; /* of the contact law */

/* ---- the library ---- */

#define WITH_COR(NAME)                                                                                                 \
    static double cor_##NAME(double x)                                                                                 \
    {                                                                                                                  \
        return cor_disk_##NAME(x, NU, datum);                                                                          \
    }

WITH_COR(load)
WITH_COR(compression)
WITH_COR(energy)
WITH_COR(load_of_energy)
WITH_COR(max_load)
WITH_COR(max_compression)
WITH_COR(contact_time)

/* ---- what a user would write: the formulas as they stand, Newton's method from the leading logarithm ---- */

static double users_compression(double load)
{
    return load / pi * (log(4 * pi / load) + b);
}

static double users_energy(double load)
{
    return load * load / (2 * pi) * (log(4 * pi / load) + b - 0.5);
}

static double newton(double target, double start, double value(double), int of_energy)
{
    const double limit = 4 * pi * exp(b - 1);
    double load = fmin(start, 0.9 * limit);
    for (int i = 0; i < 50; i++) {
        const double slope = (log(4 * pi / load) + b - 1) / pi * (of_energy ? load : 1);
        const double next = fmin(fmax(load - (value(load) - target) / slope, load / 2), limit);
        const double step = next - load;
        load = next;
        if (!(fabs(step) > 1e-14 * load))
            break;
    }
    return load;
}

static double users_load(double compression)
{
    return newton(compression, pi * compression / log(4 / compression), users_compression, 0);
}

static double users_load_of_energy(double energy)
{
    const double speed = sqrt(2 * energy / pi);
    return newton(energy, pi * speed / sqrt(log(4 / speed)), users_energy, 1);
}

static double users_max_load(double speed)
{
    return users_load_of_energy(pi / 2 * speed * speed);
}

static double users_max_compression(double speed)
{
    return users_compression(users_max_load(speed));
}

/* Runge and Kutta's method of order 4, ten thousand steps a collision */
static double users_contact_time(double speed)
{
    const double step = pi * sqrt(log(4 / speed)) / 1e4;
    double x = 0, v = speed, t = 0;
    for (;;) {
        const double a1 = x > 0 ? -users_load(x) / pi : 0, x2 = x + step / 2 * v, v2 = v + step / 2 * a1;
        const double a2 = x2 > 0 ? -users_load(x2) / pi : 0, x3 = x + step / 2 * v2, v3 = v + step / 2 * a2;
        const double a3 = x3 > 0 ? -users_load(x3) / pi : 0, x4 = x + step * v3, v4 = v + step * a3;
        const double a4 = x4 > 0 ? -users_load(x4) / pi : 0, next = x + step / 6 * (v + 2 * v2 + 2 * v3 + v4);
        if (next <= 0)
            return t + step * x / (x - next);
        v += step / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        x = next;
        t += step;
    }
}

/* the integral over theta in panels towards both ends */
static double quadrature_contact_time(double speed)
{
    long double time = NAN;
    disk_quadrature_double((struct disk_grid){16, 26, 1e9}, NULL, 0, disk_constant_b(NU), speed, NULL, &time);
    return (double)time;
}

/* ---- the truth, in long double ---- */

static const long double pi_l = 3.14159265358979323846264338327950288L;

static long double exact_load(long double x)
{
    return pi_l * x / (1 + disk_lambert_long(logl(4) + disk_constant_b(NU) - 1 - logl(x)));
}

static long double exact_compression(long double x)
{
    return x / pi_l * (logl(4 * pi_l / x) + disk_constant_b(NU));
}

static long double exact_energy(long double x)
{
    return x * x / (2 * pi_l) * (logl(4 * pi_l / x) + disk_constant_b(NU) - 0.5L);
}

static long double exact_load_of_energy(long double x)
{
    const long double q = logl(4 * pi_l) + 2 * disk_constant_b(NU) - 2 - logl(x);
    return sqrtl(4 * pi_l * x / (1 + disk_lambert_long(q)));
}

static long double t_of_speed(long double x)
{
    return disk_lambert_long(2 * (1.5L * logl(2) + disk_constant_b(NU) - 1 - logl(x)));
}

static long double exact_max_load(long double x)
{
    return pi_l * x * sqrtl(2 / (1 + t_of_speed(x)));
}

static long double exact_max_compression(long double x)
{
    const long double t = t_of_speed(x);
    return x * sqrtl(2 / (1 + t)) * (1 + t / 2);
}

static long double exact_contact_time(long double x)
{
    long double time = NAN;
    disk_quadrature_long(DISK_GRID_REFERENCE, NULL, 0, disk_constant_b(NU), (double)x, NULL, &time);
    return time;
}

/* ---- the table ---- */

typedef double function(double);

struct task {
    function *f;
    const double *in;
    double *out;
    size_t n;
};

static void run(void *closure)
{
    const struct task *const t = closure;
    for (size_t i = 0; i < t->n; i++)
        t->out[i] = t->f(t->in[i]);
}

/* Even in the logarithm, in random order. */
static void fill(double *x, size_t n, double low, double high)
{
    for (size_t i = 0; i < n; i++)
        x[i] = low * pow(high / low, ((double)i + 0.5) / (double)n);
    uint64_t state = 1;
    for (size_t i = n - 1; i > 0; i--) {
        state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        const size_t k = (size_t)(state >> 33) % (i + 1);
        const double swap = x[i];
        x[i] = x[k];
        x[k] = swap;
    }
}

/* Largest error, relative; in *ulp in units of the last place. */
static double worst_error(const double *x, const double *computed, size_t n, long double exact(long double),
                          double *ulp)
{
    double worst = 0;
    *ulp = 0;
    for (size_t i = 0; i < n; i++) {
        const long double truth = exact(x[i]);
        const double off = fabs((double)(computed[i] - truth));
        const double last_place = nextafter((double)truth, INFINITY) - (double)truth;
        if (!(off / last_place <= *ulp)) /* a NaN too */
            *ulp = off / last_place;
        if (!(off / (double)truth <= worst))
            worst = off / (double)truth;
        if (isnan(off))
            break;
    }
    return worst;
}

enum { COLUMNS = 4, ROWS = 7 };

static const struct row {
    const char *name;
    enum { OF_COMPRESSION, OF_LOAD, OF_ENERGY, OF_SPEED } argument;
    function *f[COLUMNS]; /* cor; two ways of a user; the leading logarithm */
    long double (*exact)(long double);
} rows[ROWS] = {
    {"load", OF_COMPRESSION, {cor_load, users_load, NULL, cor_disk_load_leading_log}, exact_load},
    {"compression",
     OF_LOAD,
     {cor_compression, users_compression, NULL, cor_disk_compression_leading_log},
     exact_compression},
    {"energy", OF_LOAD, {cor_energy, users_energy, NULL, NULL}, exact_energy},
    {"load_of_energy", OF_ENERGY, {cor_load_of_energy, users_load_of_energy, NULL, NULL}, exact_load_of_energy},
    {"max_load", OF_SPEED, {cor_max_load, users_max_load, NULL, NULL}, exact_max_load},
    {"max_compression",
     OF_SPEED,
     {cor_max_compression, users_max_compression, NULL, cor_disk_max_compression_leading_log},
     exact_max_compression},
    {"contact_time",
     OF_SPEED,
     {cor_contact_time, users_contact_time, quadrature_contact_time, cor_disk_contact_time_leading_log},
     exact_contact_time},
};

static const char *const column_names[COLUMNS] = {"cor", "user", "user, quadrature", "leading logarithm"};

void disk_law(struct disk_bench *bench)
{
    static double in[ROWS][POINTS], out[ROWS][COLUMNS][POINTS];
    struct task task[ROWS * COLUMNS];
    struct job job[ROWS * COLUMNS];
    size_t jobs = 0;
    b = (double)disk_constant_b(NU);
    const double limit[] = {cor_disk_compression_limit(NU, datum), cor_disk_load_limit(NU, datum),
                            cor_disk_energy_limit(NU, datum), cor_disk_speed_limit(NU, datum)};
    for (int i = 0; i < ROWS; i++) {
        const size_t n = rows[i].exact == exact_contact_time ? TIMES : POINTS;
        fill(in[i], n, rows[i].argument == OF_ENERGY ? 1e-24 : 1e-12, limit[rows[i].argument]);
        for (int k = 0; k < COLUMNS; k++)
            if (rows[i].f[k]) {
                task[jobs] = (struct task){rows[i].f[k], in[i], out[i][k], n};
                job[jobs] = (struct job){run, &task[jobs], (double)n, NAN};
                jobs++;
            }
    }
    timing_measure(job, jobs, bench->timing);

    printf("contact law, nu = 0.33, centre of mass, arguments even in the logarithm from 1e-12 (energy: 1e-24) to the\n"
           "limit: ns each, largest error at these points against long double (bound: %g ulp, contact time %g; worst\n"
           "known: docs/accuracy.md). User: the formula as it stands, or Newton's method from the leading logarithm;\n"
           "for the time 10^4 steps of RK4, below it the integral in panels. Leading logarithm: (58) to (61).\n",
           COR_DISK_LAW_MAX_ULP, COR_DISK_CONTACT_TIME_MAX_ERROR);
    printf("%-16s | %8s %6s %8s | %10s %8s %8s | %8s %8s\n", "", "cor ns", "ulp", "error", "user's ns", "error",
           "ratio", "log. ns", "error");
    jobs = 0;
    for (int i = 0; i < ROWS; i++) {
        const size_t n = task[jobs].n;
        double cor_ns = NAN;
        for (int k = 0; k < COLUMNS; k++) {
            if (!rows[i].f[k])
                continue;
            double ulp;
            const double ns = job[jobs++].best_ns, error = worst_error(in[i], out[i][k], n, rows[i].exact, &ulp);
            if (k == 0)
                printf("%-16s | %8.1f %6.2f %8.1e |", rows[i].name, cor_ns = ns, ulp, error);
            else if (k == 3)
                printf("%s %8.1f %8.1e", rows[i].f[2] ? "" : " |", ns, error);
            else
                printf("%s %10.1f %8.1e %8.1f%s", k == 2 ? "\n                 |                          |" : "", ns,
                       error, ns / cor_ns, k == 2 ? " |" : "");
            char method[64];
            snprintf(method, sizeof method, "%s %s", rows[i].name, column_names[k]);
            disk_csv(bench, &(struct disk_row){"law", method, NAN, NAN, 0, ns / 1e9, error});
        }
        printf("\n");
    }
    printf("\n");
}
