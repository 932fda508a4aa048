/* SPDX-License-Identifier: MIT */
#include "relaxed_disk.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

struct relaxed_disk {
    size_t points;
    double alpha, x_0, step; /* step: points are (i + 1/2) step */
    double largest_residual;
    double *cosine, *sine;
    double *log_f, *f;  /* the state */
    double *log_unbent; /* ln f where f at that point alone bends the disk there by 1/alpha */
    double *step_u, *residual, *scale, *newton, *saved_log_f;
    double *kernel, *matrix; /* points x points */
    double memory[];         /* all of the above */
};

/* A_n, B_n, D_n for n < count, one after the other */
struct compliance {
    size_t count;
    double *a, *b, *d;
};

static int compliance_new(struct compliance *c, size_t count)
{
    c->count = count;
    c->a = calloc(3 * count, sizeof *c->a);
    c->b = c->a + count;
    c->d = c->b + count;
    return c->a != NULL;
}

/* sum_n A_n cos(n k step), D_n cos(n k step) and B_n sin(n k step), k < 2 points */
struct sums {
    double *a, *d, *b;
};

/* cos(n k step) and sin(n k step) repeat after 4 points: sin is cos a quarter later. */
static void find_sums(const struct compliance *c, size_t points, double *cosine, struct sums *sums)
{
    const size_t quarter = points, period = 4 * quarter;
    for (size_t k = 0; k < period; k++)
        cosine[k] = cos(2 * pi * (double)k / (double)period);
    for (size_t k = 0; k < 2 * points; k++) {
        double a = 0, b = 0, d = 0;
        size_t turn = 0; /* n k, less whole periods */
        for (size_t n = 0; n < c->count; n++) {
            a += c->a[n] * cosine[turn];
            d += c->d[n] * cosine[turn];
            b += c->b[n] * cosine[turn >= quarter ? turn - quarter : turn + 3 * quarter];
            turn += k < period - turn ? k : k - period;
        }
        sums->a[k] = a;
        sums->b[k] = b;
        sums->d[k] = d;
    }
}

/* Products of cosines and sines of two angles are those of their sum and difference, (i + j + 1) step, (i - j) step. */
static void find_kernel(struct relaxed_disk *disk, const struct compliance *c)
{
    const size_t points = disk->points;
    double *scratch = disk->matrix; /* 10 points of it, not needed yet */
    struct sums sums = {scratch, scratch + 2 * points, scratch + 4 * points};
    find_sums(c, points, scratch + 6 * points, &sums);
    for (size_t i = 0; i < points; i++)
        for (size_t j = 0; j <= i; j++) {
            const size_t sum = i + j + 1, difference = i - j;
            const double cos_i = disk->cosine[i], cos_j = disk->cosine[j], sin_i = disk->sine[i], sin_j = disk->sine[j];
            const double g = cos_i * cos_j * (sums.a[difference] + sums.a[sum]) +
                             sin_i * sin_j * (sums.d[difference] - sums.d[sum]) -
                             cos_i * sin_j * (sums.b[sum] - sums.b[difference]) -
                             sin_i * cos_j * (sums.b[sum] + sums.b[difference]);
            disk->kernel[i * points + j] = disk->kernel[j * points + i] = g / (2 * pi);
        }
}

double relaxed_disk_kernel(const struct relaxed_disk *disk, size_t i, size_t j)
{
    return disk->kernel[i * disk->points + j];
}

/* Of f, which is even, from -pi/2 to pi/2 */
static double weight(const struct relaxed_disk *disk)
{
    return 2 * disk->step;
}

static struct relaxed_disk *relaxed_disk_new(const struct compliance *c, double alpha, size_t points)
{
    const size_t numbers = points * (10 + 2 * points);
    struct relaxed_disk *disk = calloc(1, sizeof *disk + numbers * sizeof *disk->memory);
    if (disk == NULL)
        return NULL;
    disk->points = points;
    disk->alpha = alpha;
    disk->step = pi / 2 / (double)points;
    double **const array[] = {&disk->cosine, &disk->sine,     &disk->log_f, &disk->f,      &disk->log_unbent,
                              &disk->step_u, &disk->residual, &disk->scale, &disk->newton, &disk->saved_log_f};
    double *free_memory = disk->memory;
    for (size_t i = 0; i < sizeof array / sizeof *array; i++, free_memory += points)
        *array[i] = free_memory;
    disk->kernel = free_memory;
    disk->matrix = free_memory + points * points;
    for (size_t i = 0; i < points; i++) {
        const double phi = ((double)i + 0.5) * disk->step;
        disk->cosine[i] = cos(phi);
        disk->sine[i] = sin(phi);
    }
    find_kernel(disk, c);
    /* so far away that the pressure bends nothing: it is the undeformed disk's */
    disk->x_0 = -1 - 36 / alpha;
    for (size_t i = 0; i < points; i++) {
        disk->log_f[i] = alpha * (disk->x_0 + disk->cosine[i]);
        disk->f[i] = exp(disk->log_f[i]);
        disk->log_unbent[i] = -log(alpha * weight(disk) * relaxed_disk_kernel(disk, i, i));
    }
    return disk;
}

static int is_setting(double nu, double alpha, size_t points)
{
    return nu > -1 && nu < 1 && alpha > 0 && alpha <= 1e6 && points >= 16 && points <= 4096;
}

struct relaxed_disk *relaxed_disk_of_modes(const struct cor_disk_modes *modes, size_t n_modes, double alpha,
                                           size_t points)
{
    if (modes == NULL || n_modes < 1 || n_modes > modes->count || !is_setting(modes->nu, alpha, points))
        return NULL;
    int largest = 0;
    for (size_t i = 0; i < n_modes; i++) {
        if (modes->mode[i].n < 0 || !(modes->mode[i].omega > 0))
            return NULL;
        if (modes->mode[i].n > largest)
            largest = modes->mode[i].n;
    }
    struct compliance c;
    if (!compliance_new(&c, (size_t)largest + 1))
        return NULL;
    for (size_t i = 0; i < n_modes; i++) {
        const struct cor_disk_mode *mode = &modes->mode[i];
        const double radial = mode->c / mode->omega, tangential = mode->s / mode->omega;
        c.a[mode->n] += radial * radial;
        c.b[mode->n] += radial * tangential;
        c.d[mode->n] += tangential * tangential;
    }
    struct relaxed_disk *disk = relaxed_disk_new(&c, alpha, points);
    free(c.a);
    return disk;
}

struct relaxed_disk *relaxed_disk_of_all_modes(double nu, double alpha, size_t points)
{
    struct compliance c;
    if (!is_setting(nu, alpha, points) || !compliance_new(&c, 2 * points))
        return NULL;
    c.a[0] = c.a[1] = c.b[1] = (1 - nu) / 2;
    c.d[1] = (3 + nu) / 2;
    for (size_t i = 2; i < c.count; i++) {
        const double n = (double)i;
        c.a[i] = c.d[i] = (2 * n - 1 + nu) / (n * n - 1);
        c.b[i] = (n * (1 - nu) - 2) / (n * n - 1);
    }
    struct relaxed_disk *disk = relaxed_disk_new(&c, alpha, points);
    free(c.a);
    return disk;
}

void relaxed_disk_free(struct relaxed_disk *disk)
{
    free(disk);
}

/* Where the pressure is so low that it bends nothing, the equation is explicit: the unknowns are the points before. */
static size_t active_points(const struct relaxed_disk *disk)
{
    double largest = 0;
    size_t active = 0;
    for (size_t i = 0; i < disk->points; i++)
        if (disk->f[i] > largest)
            largest = disk->f[i];
    for (size_t i = 0; i < disk->points; i++)
        if (disk->f[i] > 1e-25 * largest)
            active = i + 1;
    return active;
}

/* residual_i = ln(f_i)/alpha - x_0 - cos(phi_i) + sum_j G_ij weight f_j; the largest in size */
static double find_residual(struct relaxed_disk *disk, double x_0)
{
    const size_t active = active_points(disk);
    double largest = 0;
    for (size_t i = 0; i < disk->points; i++) {
        const double *row = disk->kernel + i * disk->points;
        double bent = 0;
        for (size_t j = 0; j < active; j++)
            bent += row[j] * disk->f[j];
        disk->residual[i] = disk->log_f[i] / disk->alpha - x_0 - disk->cosine[i] + weight(disk) * bent;
        if (!(fabs(disk->residual[i]) <= largest))
            largest = fabs(disk->residual[i]);
    }
    return largest;
}

/* matrix = L with L L^T = matrix; 0 if that is not positive definite */
static int cholesky(double *matrix, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        double *row = matrix + i * n;
        for (size_t j = 0; j <= i; j++) {
            const double *other = matrix + j * n;
            double sum = row[j];
            for (size_t k = 0; k < j; k++)
                sum -= row[k] * other[k];
            if (j < i)
                row[j] = sum / other[j];
            else if (!(sum > 0))
                return 0;
            else
                row[i] = sqrt(sum);
        }
    }
    return 1;
}

static void cholesky_solve(const double *matrix, size_t n, double *x)
{
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < i; k++)
            x[i] -= matrix[i * n + k] * x[k];
        x[i] /= matrix[i * n + i];
    }
    for (size_t i = n; i-- > 0;) {
        for (size_t k = i + 1; k < n; k++)
            x[i] -= matrix[k * n + i] * x[k];
        x[i] /= matrix[i * n + i];
    }
}

/* The Newton step d of ln f, (1/alpha + G W f) d = -residual: with s = sqrt(alpha W f) and u = s d the matrix
 * 1 + s G s is symmetric, and never singular. */
static int newton_step(struct relaxed_disk *disk)
{
    const size_t active = active_points(disk);
    double *scale = disk->scale, *u = disk->step_u, *matrix = disk->matrix;
    for (size_t i = 0; i < active; i++) {
        scale[i] = sqrt(disk->alpha * weight(disk) * disk->f[i]);
        u[i] = -disk->alpha * scale[i] * disk->residual[i];
    }
    for (size_t i = 0; i < active; i++)
        for (size_t j = 0; j <= i; j++)
            matrix[i * active + j] = scale[i] * relaxed_disk_kernel(disk, i, j) * scale[j] + (i == j);
    if (!cholesky(matrix, active))
        return 0;
    cholesky_solve(matrix, active, u);
    for (size_t i = 0; i < active; i++)
        u[i] *= scale[i];
    for (size_t i = 0; i < disk->points; i++) {
        const double *row = disk->kernel + i * disk->points;
        double sum = 0;
        for (size_t j = 0; j < active; j++)
            sum += row[j] * u[j];
        disk->newton[i] = -disk->alpha * disk->residual[i] - sum;
    }
    return 1;
}

/* Where the pressure grows, Newton in ln f overshoots and Newton in f, ln f + ln(1 + d), does not; but that one is slow
 * where f is so small that the point itself bends the disk by less than 1/alpha: up to there it may rise freely. */
static void advance(struct relaxed_disk *disk)
{
    for (size_t i = 0; i < disk->points; i++) {
        double step = disk->newton[i];
        if (step > 0) {
            const double free_rise = disk->log_unbent[i] - disk->log_f[i];
            step = fmin(step, fmax(log1p(step), free_rise));
        }
        disk->log_f[i] += step;
        disk->f[i] = exp(disk->log_f[i]);
    }
}

/* From the pressure as it is to the equilibrium at x_0; 1, or 0 where Newton's steps lead nowhere. */
static int settle(struct relaxed_disk *disk, double x_0)
{
    double before = INFINITY;
    for (int i = 0; i < 60; i++) {
        const double residual = find_residual(disk, x_0);
        if (residual < 1e-10 && residual >= before / 2) { /* rounding has been reached */
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

/* From where the disk is to x_0, in stages that are halved where one fails. */
static int approach(struct relaxed_disk *disk, double x_0)
{
    double *saved = disk->saved_log_f;
    double stage = x_0 - disk->x_0;
    for (int i = 0; i < 100 && fabs(stage) > 1e-9; i++) {
        const double start = disk->x_0, left = x_0 - start;
        memcpy(saved, disk->log_f, disk->points * sizeof *saved);
        if (settle(disk, fabs(stage) < fabs(left) ? start + stage : x_0)) {
            if (disk->x_0 == x_0)
                return 1;
            stage *= 2;
        } else {
            stage /= 2;
            for (size_t k = 0; k < disk->points; k++) {
                disk->log_f[k] = saved[k];
                disk->f[k] = exp(saved[k]);
            }
        }
    }
    return fabs(x_0 - disk->x_0) <= 0 && settle(disk, x_0); /* where it is already */
}

int relaxed_disk_press(struct relaxed_disk *disk, double compression, struct relaxed_state *out)
{
    if (disk == NULL || out == NULL || !(compression <= 1) || !(compression >= -1))
        return 0;
    if (!approach(disk, compression - 1))
        return 0;
    double load = 0, energy = 0;
    for (size_t i = 0; i < disk->points; i++) {
        const double bent = disk->x_0 + disk->cosine[i] - disk->log_f[i] / disk->alpha;
        load += disk->f[i];
        energy += disk->f[i] * (bent / 2 + 1 / disk->alpha);
    }
    *out = (struct relaxed_state){
        .load = weight(disk) * load,
        .energy = weight(disk) * energy,
        .residual = disk->largest_residual,
        .pressure = disk->f,
        .points = disk->points,
    };
    return 1;
}
