/* SPDX-License-Identifier: MIT */
/* Speed of eps at a speed, error beside every time: what cor ships against what a user would write today, and
 * against the floor, a copy of the array. One row a method, in one run; ratios are to the first row.
 *
 *   throughput   independent speeds, ns each
 *   latency      each speed waits for the eps before it, ns
 *   error        largest relative error over the speeds, against the collision integrated in long double */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cor/cor.h>

#include "reference_ode.h"

enum { SPEEDS = 4096, ROUNDS = 40, REPEATS = 15, CHECKED = 512 };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

/* g* = 1 m/s: (g/g*)^(1/5) = |C_1| beta. Speeds keep beta below COR_SPHERE_BETA_MAX. */
static struct cor_sphere_contact contact;

/* What a user pastes: pow and (35) with Table I, Horner. */
static double baseline(double speed)
{
    const double x = pow(speed, 0.2);
    return (1 + 2.5839 * x) / (1 + x * (3.5839 + x * (2.9839 + x * (1.1487 + x * 0.3265))));
}

static double library_overlap(double speed)
{
    return cor_contact_eps_zero_overlap(&contact, speed);
}

static double library_force(double speed)
{
    return cor_contact_eps_zero_force(&contact, speed);
}

static void scalar_array(double (*f)(double), const double *speed, double *eps, size_t n)
{
    for (size_t i = 0; i < n; i++)
        eps[i] = f(speed[i]);
}

static void array_baseline(const double *speed, double *eps, size_t n)
{
    for (size_t i = 0; i < n; i++)
        eps[i] = baseline(speed[i]);
}

static void array_overlap(const double *speed, double *eps, size_t n)
{
    cor_contact_eps_zero_overlap_array(&contact, speed, eps, n);
}

static void array_force(const double *speed, double *eps, size_t n)
{
    cor_contact_eps_zero_force_array(&contact, speed, eps, n);
}

static void array_copy(const double *speed, double *eps, size_t n)
{
    memcpy(eps, speed, n * sizeof *eps);
}

struct method {
    const char *name;
    double (*scalar)(double); /* or */
    void (*array)(const double *, double *, size_t);
    int end; /* 0 zero overlap, 1 zero force, -1 none */
};

static const struct method methods[] = {
    {"pow and the published Pade, scalar", baseline, NULL, 0},
    {"pow and the published Pade, array", NULL, array_baseline, 0},
    {"cor zero overlap, scalar", library_overlap, NULL, 0},
    {"cor zero overlap, array", NULL, array_overlap, 0},
    {"cor zero force, scalar", library_force, NULL, 1},
    {"cor zero force, array", NULL, array_force, 1},
    {"copy of the array (the floor)", NULL, array_copy, -1},
};

static double best_throughput(const struct method *m, const double *speed, double *eps)
{
    double best = HUGE_VAL;
    for (int repeat = 0; repeat < REPEATS; repeat++) {
        const double start = now();
        for (int round = 0; round < ROUNDS; round++) {
            if (m->scalar)
                scalar_array(m->scalar, speed, eps, SPEEDS);
            else
                m->array(speed, eps, SPEEDS);
        }
        best = fmin(best, (now() - start) / ROUNDS / SPEEDS);
    }
    return best;
}

static double best_latency(const struct method *m, const double *speed)
{
    /* Adding zero times the last result makes each call wait; the compiler cannot know that it is zero. */
    volatile double zero = 0.0;
    const double nothing = zero;
    double best = HUGE_VAL, last = 0.0;
    for (int repeat = 0; repeat < REPEATS; repeat++) {
        const double start = now();
        for (int i = 0; i < SPEEDS; i++)
            last = m->scalar(speed[i] + nothing * last);
        best = fmin(best, (now() - start) / SPEEDS);
    }
    zero = last;
    return best;
}

static double worst_error(const struct method *m, const double *speed)
{
    double worst = 0.0;
    for (size_t i = 0; i < SPEEDS; i += SPEEDS / CHECKED) {
        const double beta = cor_contact_beta(&contact, speed[i]);
        const struct reference r = reference_collision((long double)beta);
        const long double exact = m->end ? r.eps_zero_force : r.eps_zero_overlap;
        double eps;
        if (m->scalar)
            eps = m->scalar(speed[i]);
        else
            m->array(&speed[i], &eps, 1);
        worst = fmax(worst, fabs((double)(((long double)eps - exact) / exact)));
    }
    return worst;
}

/* eps over the truth, minus 1, at a few beta: what each formula costs in accuracy. */
static void print_errors(void)
{
    static const double betas[] = {0.5, 1, 2, 3};
    enum { BETAS = sizeof betas / sizeof *betas };
    static const struct {
        const char *name;
        double (*eps)(double);
        int end;
    } formulas[] = {
        {"published Pade (35)", cor_sphere_eps_published_pade, 0},
        {"simple theory (27)", cor_sphere_eps_simple, 0},
        {"cor zero overlap", cor_sphere_eps_zero_overlap, 0},
        {"cor zero force", cor_sphere_eps_zero_force, 1},
    };
    printf("\n%-38s", "relative error of eps at beta");
    for (int k = 0; k < BETAS; k++)
        printf(" %11g", betas[k]);
    printf("\n");
    for (size_t i = 0; i < sizeof formulas / sizeof *formulas; i++) {
        printf("%-38s", formulas[i].name);
        for (int k = 0; k < BETAS; k++) {
            const struct reference r = reference_collision((long double)betas[k]);
            const long double exact = formulas[i].end ? r.eps_zero_force : r.eps_zero_overlap;
            printf(" %+11.1e", (double)(((long double)formulas[i].eps(betas[k]) - exact) / exact));
        }
        printf("\n");
    }
    printf("\n");
}

int main(int argc, char **argv)
{
    const char *const csv = argc == 3 && strcmp(argv[1], "--csv") == 0 ? argv[2] : NULL;
    if (argc != 1 && !csv) {
        fprintf(stderr, "usage: bench_sphere [--csv FILE]\n");
        return 2;
    }
    static double speed[SPEEDS], eps[SPEEDS];
    cor_sphere_contact_init_g_star(&contact, 1.0);
    /* Two decades of beta's fifth power and more: beta from 0.02 to just below 2, in a shuffled order. */
    const double low = pow(0.02 * fabs(COR_SPHERE_C1), 5), high = pow(1.999 * fabs(COR_SPHERE_C1), 5);
    for (int i = 0; i < SPEEDS; i++)
        speed[(i * 1597) % SPEEDS] = low * pow(high / low, (i + 0.5) / SPEEDS);

    FILE *file = NULL;
    if (csv && !(file = fopen(csv, "w"))) {
        fprintf(stderr, "bench_sphere: cannot write %s\n", csv);
        return 1;
    }
    if (file)
        fprintf(file, "method,throughput_ns,latency_ns,throughput_ratio,max_relative_error\n");
    printf("%-38s %12s %12s %10s %12s\n", "eps at a speed, 0.02 <= beta < 2", "throughput", "latency", "speed-up",
           "max error");
    double first = 0.0;
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        const struct method *m = &methods[i];
        const double throughput = best_throughput(m, speed, eps);
        const double latency = m->scalar ? best_latency(m, speed) : NAN;
        const double error = m->end < 0 ? NAN : worst_error(m, speed);
        if (i == 0)
            first = throughput;
        printf("%-38s %9.2f ns ", m->name, throughput);
        if (m->scalar)
            printf("%9.2f ns ", latency);
        else
            printf("%12s ", "");
        printf("%9.2fx ", first / throughput);
        if (m->end < 0)
            printf("\n");
        else
            printf("%12.1e\n", error);
        if (file)
            fprintf(file, "%s,%.3f,%.3f,%.3f,%.2e\n", m->name, throughput, latency, first / throughput, error);
    }
    print_errors();
    if (file && fclose(file)) {
        fprintf(stderr, "bench_sphere: cannot write %s\n", csv);
        return 1;
    }
    return 0;
}
