/* SPDX-License-Identifier: MIT */
/* Fig. 2: circles and radii of the disk, distorted by three free modes. The displacements are (19), with A : B from
 * the boundary conditions (22), (23) and the size from (26). C and S of the mode table come by another way, a closed
 * form in omega, so that both must agree at the rim. */
#include <math.h>

#include "cor/disk.h"
#include "report.h"

static const double pi = 3.14159265358979323846;
static const double nu = 0.33;
static const double largest_shift = 0.22; /* in units of R, for every mode */

/* u_r and u_phi of (27), with kappa and kappa' where (19) has them */
struct field {
    int n, l;
    double omega, kappa, kappa_prime, a, b;
};

/* J_n, and its derivative times z */
struct bessel {
    double j, slope;
};

static struct bessel bessel_at(int n, double z)
{
    const double j = jn(n, z);
    return (struct bessel){j, n == 0 ? -z * j1(z) : z * jn(n - 1, z) - n * j};
}

static void displacement(const struct field *field, double r, double *u_r, double *u_phi)
{
    const struct bessel a = bessel_at(field->n, field->kappa * r), b = bessel_at(field->n, field->kappa_prime * r);
    *u_r = (field->a * a.slope + field->n * field->b * b.j) / r;
    *u_phi = -(field->n * field->a * a.j + field->b * b.slope) / r;
}

/* int (u_r^2 + u_phi^2) r dr by Simpson's rule: 1 by (26), 1/2 for n = 0. The integrand is 0 at r = 0. */
static double norm(const struct field *field)
{
    enum { STEPS = 2000 };
    double sum = 0;
    for (int i = 1; i <= STEPS; i++) {
        const double r = (double)i / STEPS;
        double u_r, u_phi;
        displacement(field, r, &u_r, &u_phi);
        sum += (i == STEPS ? 1 : i % 2 ? 4 : 2) * (u_r * u_r + u_phi * u_phi) * r;
    }
    return sum / (3 * STEPS);
}

static struct field field_of(const struct cor_disk_mode *mode)
{
    const int n = mode->n;
    struct field field = {.n = n,
                          .l = mode->l,
                          .omega = mode->omega,
                          .kappa = mode->omega * sqrt(1 - nu * nu),
                          .kappa_prime = mode->omega * sqrt(2 * (1 + nu)),
                          .a = 1};
    if (n > 0) {
        /* (22)/(1 - nu) and (23)/2: p A + q B = 0, of which that with the larger coefficients says more */
        const double diagonal = mode->omega * mode->omega * (1 + nu) - n * n;
        const struct bessel a = bessel_at(n, field.kappa), b = bessel_at(n, field.kappa_prime);
        double p = -(a.slope + diagonal * a.j), q = n * (b.slope - b.j);
        const double p23 = -n * (a.slope - a.j), q23 = b.slope + diagonal * b.j;
        if (fabs(p23) + fabs(q23) > fabs(p) + fabs(q)) {
            p = p23;
            q = q23;
        }
        field.a = q;
        field.b = -p;
    }
    double u_r, u_phi;
    displacement(&field, 1, &u_r, &u_phi);
    const double scale = copysign(sqrt((n > 0 ? 1 : 0.5) / norm(&field)), u_r);
    field.a *= scale;
    field.b *= scale;
    return field;
}

/* A point of the rim or inside, displaced */
static void write_point(FILE *csv, const struct field *field, double scale, const char *line, double r, double phi)
{
    double u_r, u_phi;
    displacement(field, fmax(r, 1e-6), &u_r, &u_phi);
    u_r *= scale * cos(field->n * phi);
    u_phi *= scale * sin(field->n * phi);
    fprintf(csv, "%d,%d,%.5f,%s,%.4f,%.4f\n", field->n, field->l, field->omega, line,
            (r + u_r) * cos(phi) - u_phi * sin(phi), (r + u_r) * sin(phi) + u_phi * cos(phi));
}

/* A blank line after each line of the drawing, two after each mode, as gnuplot wants it */
static void write_shape(FILE *csv, const struct field *field)
{
    enum { CIRCLES = 5, RADII = 24, ANGLES = 72, STEPS = 10 };
    double largest = 0;
    for (int i = 1; i <= 100; i++) {
        double u_r, u_phi;
        displacement(field, i / 100.0, &u_r, &u_phi);
        largest = fmax(largest, fmax(fabs(u_r), fabs(u_phi)));
    }
    const double scale = largest_shift / largest;
    for (int i = 1; i <= CIRCLES; i++) {
        for (int k = 0; k <= ANGLES; k++)
            write_point(csv, field, scale, i < CIRCLES ? "circle" : "rim", (double)i / CIRCLES, 2 * pi * k / ANGLES);
        fputs("\n", csv);
    }
    for (int i = 0; i < RADII; i++) {
        for (int k = 0; k <= STEPS; k++)
            write_point(csv, field, scale, "radius", (double)k / STEPS, 2 * pi * i / RADII);
        fputs("\n", csv);
    }
    fputs("\n", csv);
}

static const struct cor_disk_mode *find(int n, int l)
{
    const struct cor_disk_mode *mode = cor_disk_modes_nu033.mode;
    while (mode->n != n || mode->l != l)
        mode++;
    return mode;
}

static int write_shapes(FILE *csv, char verdict[VERDICT_SIZE])
{
    const int drawn[] = {2, 1, 0};
    double worst = 0, omega[3];
    fputs("n,l,omega,line,x,y\n", csv);
    for (int i = 0; i < 3; i++) {
        const struct cor_disk_mode *mode = find(drawn[i], 0);
        const struct field field = field_of(mode);
        double u_r, u_phi;
        displacement(&field, 1, &u_r, &u_phi);
        worst = fmax(worst, fmax(fabs(u_r - mode->c), fabs(u_phi - mode->s)));
        omega[i] = mode->omega;
        write_shape(csv, &field);
    }
    if (!(worst <= 1e-9)) {
        fprintf(stderr, "cor_report: the displacements at the rim and C, S of the mode table differ by %.2g\n", worst);
        return 0;
    }
    snprintf(verdict, VERDICT_SIZE,
             "Agrees with the text (the caption names no modes): the three lowest, the quadrupole (n, l) = (2, 0) "
             "at omega = %.6f, (1, 0) at %.6f, whose centre moves against the rim, and (0, 0) at %.6f. Drawn from "
             "(19); in (27), which repeats it, kappa and kappa' are exchanged in u_phi. Normalised by (26), u_r and "
             "u_phi at the rim are C and S of the mode table to better than 1e-9.",
             omega[0], omega[1], omega[2]);
    return 1;
}

const struct figure shapes_figure = {"shapes", "Fig. 2", "three simple modes: circles and radii, distorted",
                                     write_shapes};
