/* SPDX-License-Identifier: MIT */
/* Fig. 2: circles and radii of the disk, distorted by three free modes. The displacements are (19), with A : B from
 * the boundary conditions (22), (23) and the size from the larger of C and S at the rim. Those come by another way, a
 * closed form in omega, so that the other one and the integral (26) must agree. */
#include <math.h>

#include "cor/disk.h"
#include "mode_shape.h"
#include "report.h"

static const double pi = 3.14159265358979323846;
static const double nu = 0.33;
static const double largest_shift = 0.22; /* in units of R, for every mode */

/* int (u_r^2 + u_phi^2) r dr, (26), by Simpson's rule: 1, but 1/2 for n = 0. The integrand is 0 at r = 0. */
static double norm(const struct mode_shape *shape)
{
    enum { STEPS = 2000 };
    double sum = 0;
    for (int i = 1; i <= STEPS; i++) {
        const double r = (double)i / (double)STEPS;
        double u_r, u_phi;
        mode_displacement(shape, r, &u_r, &u_phi);
        sum += (i == STEPS ? 1 : i % 2 ? 4 : 2) * (u_r * u_r + u_phi * u_phi) * r;
    }
    return sum / (3 * STEPS);
}

/* A point of the rim or inside, displaced */
static void write_point(FILE *csv, const struct mode_shape *shape, double scale, const char *line, double r, double phi)
{
    double u_r, u_phi;
    mode_displacement(shape, fmax(r, 1e-6), &u_r, &u_phi);
    u_r *= scale * cos(shape->n * phi);
    u_phi *= scale * sin(shape->n * phi);
    fprintf(csv, "%d,%d,%.5f,%s,%.4f,%.4f\n", shape->n, shape->l, shape->omega, line,
            (r + u_r) * cos(phi) - u_phi * sin(phi), (r + u_r) * sin(phi) + u_phi * cos(phi));
}

/* A blank line after each line of the drawing, two after each mode, as gnuplot wants it */
static void write_shape(FILE *csv, const struct mode_shape *shape)
{
    enum { CIRCLES = 5, RADII = 24, ANGLES = 72, STEPS = 6 };
    double largest = 0;
    for (int i = 1; i <= 100; i++) {
        double u_r, u_phi;
        mode_displacement(shape, i / 100.0, &u_r, &u_phi);
        largest = fmax(largest, fmax(fabs(u_r), fabs(u_phi)));
    }
    const double scale = largest_shift / largest;
    for (int i = 1; i <= CIRCLES; i++) {
        for (int k = 0; k <= ANGLES; k += i < CIRCLES ? 2 : 1)
            write_point(csv, shape, scale, i < CIRCLES ? "circle" : "rim", (double)i / (double)CIRCLES,
                        2 * pi * k / (double)ANGLES);
        fputs("\n", csv);
    }
    for (int i = 0; i < RADII; i++) {
        for (int k = 0; k <= STEPS; k++)
            write_point(csv, shape, scale, "radius", (double)k / (double)STEPS, 2 * pi * i / (double)RADII);
        fputs("\n", csv);
    }
    fputs("\n", csv);
}

static const struct cor_disk_mode *mode_find(int n, int l)
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
        const struct cor_disk_mode *mode = mode_find(drawn[i], 0);
        const struct mode_shape shape = mode_shape_of(mode, nu);
        double u_r, u_phi;
        mode_displacement(&shape, 1, &u_r, &u_phi);
        worst = fmax(worst, fmax(fabs(u_r - mode->c), fabs(u_phi - mode->s)));
        worst = fmax(worst, fabs(norm(&shape) - (mode->n > 0 ? 1 : 0.5)));
        omega[i] = mode->omega;
        write_shape(csv, &shape);
    }
    if (!(worst <= 1e-9)) {
        fprintf(stderr, "cor_paper: the displacements are not those of C and S of the mode table by %.2g\n", worst);
        return 0;
    }
    snprintf(verdict, VERDICT_SIZE,
             "Agrees with the text (the caption names no modes). The three lowest modes are the quadrupole (n, l) = "
             "(2, 0) at omega = %.6f, (1, 0) at %.6f and (0, 0) at %.6f. The centre of (1, 0) moves against the "
             "rim. The displacements are those of (19); (27), which repeats it, exchanges kappa and kappa' in "
             "u_phi. Normalised by (26), u_r and u_phi at the rim equal C and S of the mode table to better than "
             "1e-9.",
             omega[0], omega[1], omega[2]);
    return 1;
}

const struct figure shapes_figure = {"shapes", "Fig. 2", "three simple modes: circles and radii, distorted",
                                     write_shapes};
