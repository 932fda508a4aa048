/* SPDX-License-Identifier: MIT */
/* Ice spheres, Fig. 1 of the paper of 1999: eps against impact speed g. Five curves:
 *   - the fit to the measurements of Bridges, Hatzes & Lin (1984), eps = 0.32 g^(-0.234), g in
 * cm/s, measured for 0.015 <= g <= 5.1 cm/s;
 *   - the published Pade (35) with the published g* = 0.32 cm/s;
 *   - the viscoelastic sphere itself, at both ends of contact, with the same g*;
 *   - the same three with g* refitted: least squares of eps over the measured range.
 * Uses the installed package only: <cor/cor.h> and libm. */
#include <cor/cor.h>
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double measured_from = 0.015, measured_to = 5.1; /* cm/s */
static const double published_g_star = 0.32;                  /* cm/s */

enum { SAMPLES = 400, CURVE_POINTS = 101 };
static const double curve_from = 1e-3, curve_to = 10; /* cm/s, what --csv covers */

/* eps at a speed, both speeds in cm/s */
typedef double model(double g_star, double speed);

static double bridges(double speed)
{
    return 0.32 * pow(speed, -0.234);
}

static struct cor_sphere_contact contact_of(double g_star_cm_s)
{
    struct cor_sphere_contact contact;
    cor_sphere_contact_init_g_star(&contact, g_star_cm_s / 100);
    return contact;
}

static double zero_overlap(double g_star, double speed)
{
    const struct cor_sphere_contact contact = contact_of(g_star);
    return cor_contact_eps_zero_overlap(&contact, speed / 100);
}

static double zero_force(double g_star, double speed)
{
    const struct cor_sphere_contact contact = contact_of(g_star);
    return cor_contact_eps_zero_force(&contact, speed / 100);
}

static double published_pade(double g_star, double speed)
{
    const struct cor_sphere_contact contact = contact_of(g_star);
    return cor_sphere_eps_published_pade(cor_contact_beta(&contact, speed / 100));
}

struct curve {
    const char *name, *column;
    model *eps;
    double refitted; /* g*, cm/s */
};

/* The i-th of n points from a to b, equal steps in log(speed). */
static double log_point(double a, double b, int i, int n)
{
    return a * pow(b / a, (double)i / (n - 1));
}

static double residuals(const struct curve *curve, double g_star, double *largest)
{
    double sum = 0;
    *largest = 0;
    for (int i = 0; i < SAMPLES; i++) {
        const double speed = log_point(measured_from, measured_to, i, SAMPLES);
        const double difference = curve->eps(g_star, speed) - bridges(speed);
        sum += difference * difference;
        if (!(fabs(difference) <= *largest))
            *largest = fabs(difference);
    }
    return sqrt(sum / SAMPLES);
}

/* Golden section in log g*: the sum of squares has one minimum there. */
static void refit(struct curve *curve)
{
    const double section = 0.6180339887498949;
    double low = log(1e-3), high = log(1e3), largest;
    double a = high - section * (high - low), b = low + section * (high - low);
    double at_a = residuals(curve, exp(a), &largest), at_b = residuals(curve, exp(b), &largest);
    while (high - low > 1e-9) {
        if (at_a < at_b) {
            high = b;
            b = a;
            at_b = at_a;
            a = high - section * (high - low);
            at_a = residuals(curve, exp(a), &largest);
        } else {
            low = a;
            a = b;
            at_a = at_b;
            b = low + section * (high - low);
            at_b = residuals(curve, exp(b), &largest);
        }
    }
    curve->refitted = exp((low + high) / 2);
}

static void print_summary(const struct curve *curve, int curves)
{
    printf("Ice spheres: eps(g) against 0.32 g^(-0.234), the fit to the measurements of\n"
           "Bridges, Hatzes & Lin (1984), g in cm/s, over its measured range %g to %g cm/s.\n"
           "Residuals in eps over %d samples with equal steps in log g.\n\n",
           measured_from, measured_to, SAMPLES);
    printf("%-34s %10s %8s %8s\n", "curve", "g* (cm/s)", "rms", "largest");
    double largest;
    for (int i = 0; i < curves; i++) {
        const double rms = residuals(&curve[i], published_g_star, &largest);
        printf("%-34s %10.4f %8.4f %8.4f\n", curve[i].name, published_g_star, rms, largest);
    }
    for (int i = 0; i < curves; i++) {
        const double rms = residuals(&curve[i], curve[i].refitted, &largest);
        printf("%-23s %-10s %10.4f %8.4f %8.4f\n", curve[i].name, "refitted", curve[i].refitted, rms, largest);
    }
}

/* Empty where there is nothing: the measurements beyond their range. */
static void print_cell(FILE *file, double value)
{
    if (isnan(value))
        fputs(",", file);
    else
        fprintf(file, ",%.6f", value);
}

static int write_csv(FILE *file, const struct curve *curve, int curves)
{
    fputs("speed_cm_s,bridges_1984", file);
    for (int i = 0; i < curves; i++)
        fprintf(file, ",%s_g_star_%.4f,%s_g_star_%.4f", curve[i].column, published_g_star, curve[i].column,
                curve[i].refitted);
    fputs("\n", file);
    for (int k = 0; k < CURVE_POINTS; k++) {
        const double speed = log_point(curve_from, curve_to, k, CURVE_POINTS);
        fprintf(file, "%.6g", speed);
        const int measured = speed >= measured_from && speed <= measured_to;
        print_cell(file, measured ? bridges(speed) : NAN);
        for (int i = 0; i < curves; i++) {
            print_cell(file, curve[i].eps(published_g_star, speed));
            print_cell(file, curve[i].eps(curve[i].refitted, speed));
        }
        fputs("\n", file);
    }
    return ferror(file) == 0 && fflush(file) == 0;
}

/* Written beside the target and renamed over it, so that no reader sees half a file. */
static int replace_csv(const char *path, const struct curve *curve, int curves)
{
    const size_t size = strlen(path) + sizeof ".tmp";
    char *temporary = malloc(size);
    if (temporary == NULL) {
        fprintf(stderr, "ice: out of memory\n");
        return 1;
    }
    snprintf(temporary, size, "%s.tmp", path);
    errno = 0;
    FILE *file = fopen(temporary, "w");
    int done = file != NULL;
    if (file != NULL) {
        done = write_csv(file, curve, curves);
        const int closed = fclose(file) == 0;
        done = done && closed && rename(temporary, path) == 0;
    }
    if (!done) {
        fprintf(stderr, "ice: cannot write %s: %s\n", path, strerror(errno));
        if (file != NULL)
            remove(temporary);
    }
    free(temporary);
    return !done;
}

int main(int argc, char **argv)
{
    static const char usage[] = "usage: ice [--csv FILE]\n";
    const char *csv = NULL;
    if (argc == 2 && strcmp(argv[1], "--help") == 0) {
        printf("%sPrints how well eps(g) of viscoelastic spheres fits ice; --csv writes the curves.\n", usage);
        return 0;
    }
    if (argc == 3 && strcmp(argv[1], "--csv") == 0 && argv[2][0] != '\0') {
        csv = argv[2];
    } else if (argc != 1) {
        fputs(usage, stderr);
        return 2;
    }

    struct curve curve[] = {
        {"published Pade (35)", "published_pade", published_pade, 0},
        {"exact, zero overlap", "zero_overlap", zero_overlap, 0},
        {"exact, zero force", "zero_force", zero_force, 0},
    };
    const int curves = sizeof curve / sizeof *curve;
    for (int i = 0; i < curves; i++)
        refit(&curve[i]);
    print_summary(curve, curves);
    int status = csv != NULL ? replace_csv(csv, curve, curves) : 0;
    errno = 0;
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fprintf(stderr, "ice: cannot write to standard output: %s\n", strerror(errno));
        status = 1;
    }
    return status;
}
