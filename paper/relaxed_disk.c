/* SPDX-License-Identifier: MIT */
#include "relaxed_disk.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* Returns the weight of a point in the integral of an even function from -pi/2 to pi/2. */
static double weight(const struct relaxed_disk *disk)
{
    return 2 * disk->step;
}

static struct relaxed_disk *relaxed_disk_new(double alpha, size_t points)
{
    enum { ARRAYS = 7 };
    struct relaxed_disk *disk = calloc(1, sizeof *disk + points * (ARRAYS + 2 * points) * sizeof *disk->memory);
    if (disk == NULL)
        return NULL;
    double **const array[ARRAYS] = {&disk->log_f, &disk->f,      &disk->residual, &disk->scale,
                                    &disk->u,     &disk->newton, &disk->saved};
    for (size_t i = 0; i < ARRAYS; i++)
        *array[i] = disk->memory + i * points;
    disk->kernel = disk->memory + ARRAYS * points;
    disk->matrix = disk->kernel + points * points;
    disk->points = points;
    disk->alpha = alpha;
    disk->step = pi / 2 / (double)points;
    /* the disk is so far away that its deformation is negligible */
    disk->x_0 = -1 - 36 / alpha;
    for (size_t i = 0; i < points; i++) {
        disk->log_f[i] = alpha * (disk->x_0 + cos(((double)i + 0.5) * disk->step));
        disk->f[i] = exp(disk->log_f[i]);
    }
    return disk;
}

/* Adds A_n, B_n and D_n to the kernel. */
static void add_compliance(struct relaxed_disk *disk, int n, double a, double b, double d)
{
    const size_t points = disk->points;
    double *p = disk->u, *q = disk->newton; /* scratch, until these arrays are needed */
    for (size_t i = 0; i < points; i++) {
        const double phi = ((double)i + 0.5) * disk->step;
        p[i] = cos(n * phi) * cos(phi);
        q[i] = sin(n * phi) * sin(phi);
    }
    for (size_t i = 0; i < points; i++) {
        double *row = disk->kernel + i * points;
        const double of_p = (a * p[i] - b * q[i]) / pi, of_q = (d * q[i] - b * p[i]) / pi;
        for (size_t j = 0; j < points; j++)
            row[j] += of_p * p[j] + of_q * q[j];
    }
}

struct relaxed_disk *relaxed_disk_of_modes(const struct cor_disk_modes *modes, size_t n_modes, double alpha,
                                           size_t points)
{
    struct relaxed_disk *disk = relaxed_disk_new(alpha, points);
    int largest = 0;
    for (size_t i = 0; i < n_modes; i++)
        largest = modes->mode[i].n > largest ? modes->mode[i].n : largest;
    for (int n = 0; disk != NULL && n <= largest; n++) {
        double a = 0, b = 0, d = 0;
        for (size_t i = 0; i < n_modes; i++)
            if (modes->mode[i].n == n) {
                const double radial = modes->mode[i].c / modes->mode[i].omega;
                const double tangential = modes->mode[i].s / modes->mode[i].omega;
                a += radial * radial;
                b += radial * tangential;
                d += tangential * tangential;
            }
        add_compliance(disk, n, a, b, d);
    }
    return disk;
}

struct relaxed_disk *relaxed_disk_of_all_modes(double nu, double alpha, size_t points)
{
    struct relaxed_disk *disk = relaxed_disk_new(alpha, points);
    if (disk == NULL)
        return NULL;
    add_compliance(disk, 0, (1 - nu) / 2, 0, 0);
    add_compliance(disk, 1, (1 - nu) / 2, (1 - nu) / 2, (3 + nu) / 2);
    for (int n = 2; n < 2 * (int)points; n++) {
        const double equal = (2 * n - 1 + nu) / ((double)n * n - 1);
        add_compliance(disk, n, equal, (n * (1 - nu) - 2) / ((double)n * n - 1), equal);
    }
    return disk;
}

/* Returns the number of unknowns. Later points have a negligible pressure in the integral, so f follows directly
 * there. */
static size_t active_points(const struct relaxed_disk *disk)
{
    double largest = 0;
    size_t active = 0;
    for (size_t i = 0; i < disk->points; i++)
        largest = fmax(largest, disk->f[i]);
    for (size_t i = 0; i < disk->points; i++)
        if (disk->f[i] > 1e-25 * largest)
            active = i + 1;
    return active;
}

static double row_times(const struct relaxed_disk *disk, size_t i, const double *x, size_t active)
{
    double sum = 0;
    for (size_t j = 0; j < active; j++)
        sum += disk->kernel[i * disk->points + j] * x[j];
    return sum;
}

/* Computes residual_i = ln(f_i)/alpha - x_0 - cos(phi_i) + sum_j G_ij weight f_j. Returns the largest magnitude. */
static double find_residual(struct relaxed_disk *disk, double x_0)
{
    const size_t active = active_points(disk);
    double largest = 0;
    for (size_t i = 0; i < disk->points; i++) {
        disk->residual[i] = disk->log_f[i] / disk->alpha - x_0 - cos(((double)i + 0.5) * disk->step) +
                            weight(disk) * row_times(disk, i, disk->f, active);
        if (!(fabs(disk->residual[i]) <= largest))
            largest = fabs(disk->residual[i]);
    }
    return largest;
}

/* Solves matrix y = x by Cholesky's method, and leaves y in x. Returns 0 if the matrix is not positive definite. */
static int solve(double *matrix, size_t n, double *x)
{
    for (size_t i = 0; i < n; i++) {
        double *row = matrix + i * n;
        for (size_t j = 0; j <= i; j++) {
            const double *other = matrix + j * n;
            double sum = row[j];
            for (size_t k = 0; k < j; k++)
                sum -= row[k] * other[k];
            if (j == i && !(sum > 0))
                return 0;
            row[j] = j < i ? sum / other[j] : sqrt(sum);
        }
        for (size_t k = 0; k < i; k++)
            x[i] -= row[k] * x[k];
        x[i] /= row[i];
    }
    for (size_t i = n; i-- > 0;) {
        for (size_t k = i + 1; k < n; k++)
            x[i] -= matrix[k * n + i] * x[k];
        x[i] /= matrix[i * n + i];
    }
    return 1;
}

/* Computes the Newton step d of ln f, (1/alpha + G W f) d = -residual. With s = sqrt(alpha W f) and u = s d the matrix
 * 1 + s G s is symmetric, and never singular. */
static int newton_step(struct relaxed_disk *disk)
{
    const size_t active = active_points(disk);
    double *scale = disk->scale, *u = disk->u;
    for (size_t i = 0; i < active; i++) {
        scale[i] = sqrt(disk->alpha * weight(disk) * disk->f[i]);
        u[i] = -disk->alpha * scale[i] * disk->residual[i];
    }
    for (size_t i = 0; i < active; i++)
        for (size_t j = 0; j <= i; j++)
            disk->matrix[i * active + j] = scale[i] * disk->kernel[i * disk->points + j] * scale[j] + (i == j);
    if (!solve(disk->matrix, active, u))
        return 0;
    for (size_t i = 0; i < active; i++)
        u[i] *= scale[i];
    for (size_t i = 0; i < disk->points; i++)
        disk->newton[i] = -disk->alpha * disk->residual[i] - row_times(disk, i, u, active);
    return 1;
}

/* Adds the Newton step d to ln f. A large positive d would overshoot, so the step is then ln(1 + d), as for Newton's
 * method in f. This is slow for a tiny f. Steps are therefore not shortened until f bends the disk at this point by
 * 1/alpha. */
static void advance(struct relaxed_disk *disk)
{
    for (size_t i = 0; i < disk->points; i++) {
        const double unbent = -log(disk->alpha * weight(disk) * disk->kernel[i * disk->points + i]);
        const double step = disk->newton[i];
        disk->log_f[i] += step > 0 ? fmin(step, fmax(log1p(step), unbent - disk->log_f[i])) : step;
        disk->f[i] = exp(disk->log_f[i]);
    }
}

/* Iterates from the current pressure to the equilibrium at x_0. Returns 1, or 0 if Newton's steps do not converge. */
static int settle(struct relaxed_disk *disk, double x_0)
{
    double before = INFINITY;
    for (int i = 0; i < 60; i++) {
        const double residual = find_residual(disk, x_0);
        if (residual < 1e-10 && residual >= before / 2) { /* rounding limits the residual */
            disk->x_0 = x_0;
            disk->largest_residual = residual;
            return 1;
        }
        if (!isfinite(residual) || !newton_step(disk))
            return 0;
        before = residual;
        advance(disk);
    }
    return 0;
}

/* Moves the disk from its position to x_0, in stages that are halved after a failure. */
static int approach(struct relaxed_disk *disk, double x_0)
{
    double stage = x_0 - disk->x_0;
    for (int i = 0; i < 100 && fabs(stage) > 1e-9; i++) {
        const double start = disk->x_0, left = x_0 - start;
        memcpy(disk->saved, disk->log_f, disk->points * sizeof *disk->saved);
        if (settle(disk, fabs(stage) < fabs(left) ? start + stage : x_0)) {
            if (disk->x_0 == x_0)
                return 1;
            stage *= 2;
        } else {
            stage /= 2;
            for (size_t k = 0; k < disk->points; k++) {
                disk->log_f[k] = disk->saved[k];
                disk->f[k] = exp(disk->saved[k]);
            }
        }
    }
    return fabs(x_0 - disk->x_0) <= 0 && settle(disk, x_0); /* already at x_0 */
}

double relaxed_disk_press(struct relaxed_disk *disk, double compression)
{
    if (!approach(disk, compression - 1))
        return NAN;
    disk->load = disk->energy = 0;
    for (size_t i = 0; i < disk->points; i++) {
        const double bent = disk->x_0 + cos(((double)i + 0.5) * disk->step) - disk->log_f[i] / disk->alpha;
        disk->load += weight(disk) * disk->f[i];
        disk->energy += weight(disk) * disk->f[i] * (bent / 2 + 1 / disk->alpha);
    }
    return disk->load;
}
