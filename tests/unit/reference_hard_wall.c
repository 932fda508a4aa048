/* SPDX-License-Identifier: MIT */
#include "reference_hard_wall.h"

#include <math.h>
#include <stdlib.h>

static const double pi = 3.14159265358979323846, mass = 3.14159265358979323846;

struct disk {
    const struct reference_wall *wall;
    int modes, angles;
    double *rim;        /* [mode][angle]: sqrt(w_i) s_i */
    double *compliance; /* [angle][angle] */
    double *omega, *q, *q_dot;
    double *reach, *force, *system; /* system: [angles][angles + 1] */
    int *touches;
};

static double rim_function(const struct cor_disk_mode *mode, double phi)
{
    return mode->c * cos(mode->n * phi) * cos(phi) - mode->s * sin(mode->n * phi) * sin(phi);
}

static double angle_of(const struct reference_wall *wall, int j)
{
    return (j + wall->offset) * pi / wall->nyquist;
}

/* Static compliance of every n up to Nyquist's number, docs/paper-figures.md, Fig. 10, times pi */
static double static_compliance(double nu, int nyquist, double phi, double psi)
{
    double sum = (1 - nu) / 2 * cos(phi) * cos(psi);
    for (int n = 1; n <= nyquist; n++) {
        const double a = n == 1 ? (1 - nu) / 2 : (2 * n - 1 + nu) / ((double)n * n - 1);
        const double b = n == 1 ? (1 - nu) / 2 : (n * (1 - nu) - 2) / ((double)n * n - 1);
        const double d = n == 1 ? (3 + nu) / 2 : a;
        const double x = cos(n * phi) * cos(phi), y = sin(n * phi) * sin(phi);
        const double x_psi = cos(n * psi) * cos(psi), y_psi = sin(n * psi) * sin(psi);
        sum += a * x * x_psi - b * (x * y_psi + y * x_psi) + d * y * y_psi;
        if (n == nyquist) /* the library's cosine series end at Nyquist's number: without cos((n + 1) phi) */
            sum -= (a + 2 * b + d) / 4 * cos((n + 1) * phi) * cos((n + 1) * psi);
    }
    return sum;
}

static void fill(struct disk *disk, const struct cor_disk_modes *modes)
{
    const struct reference_wall *const wall = disk->wall;
    const int m = disk->angles;
    for (int i = 0; i < disk->modes; i++) {
        const double r2 = pow(modes->mode[i].omega / wall->omega, 2);
        const double w = (1 - r2) * (1 - r2) * (1 + wall->fade_next * r2);
        disk->omega[i] = modes->mode[i].omega;
        disk->q[i] = disk->q_dot[i] = 0;
        for (int j = 0; j < m; j++)
            disk->rim[i * m + j] = sqrt(w) * rim_function(&modes->mode[i], angle_of(wall, j));
    }
    for (int j = 0; j < m; j++)
        for (int k = 0; k <= j; k++) {
            double sum = static_compliance(modes->nu, wall->nyquist, angle_of(wall, j), angle_of(wall, k));
            for (int i = 0; i < disk->modes; i++)
                sum -= disk->rim[i * m + j] * disk->rim[i * m + k] / (disk->omega[i] * disk->omega[i]);
            disk->compliance[j * m + k] = disk->compliance[k * m + j] = sum / pi;
        }
}

/* Gauss's elimination of n equations, rows of n + 1; the solution goes to the last column. */
static int eliminate(double *a, int n)
{
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++)
            best = fabs(a[i * (n + 1) + k]) > fabs(a[best * (n + 1) + k]) ? i : best;
        if (a[best * (n + 1) + k] == 0)
            return 1;
        for (int j = k; j <= n && best != k; j++) {
            const double swap = a[k * (n + 1) + j];
            a[k * (n + 1) + j] = a[best * (n + 1) + j];
            a[best * (n + 1) + j] = swap;
        }
        for (int i = k + 1; i < n; i++) {
            const double factor = a[i * (n + 1) + k] / a[k * (n + 1) + k];
            for (int j = k; j <= n; j++)
                a[i * (n + 1) + j] -= factor * a[k * (n + 1) + j];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n; j++)
            a[k * (n + 1) + n] -= a[k * (n + 1) + j] * a[j * (n + 1) + n];
        a[k * (n + 1) + n] /= a[k * (n + 1) + k];
    }
    return 0;
}

static double gap_at(const struct disk *disk, int j)
{
    double reach = disk->reach[j];
    for (int k = 0; k < disk->angles; k++)
        reach -= disk->compliance[j * disk->angles + k] * disk->force[k];
    return reach;
}

/* Forces that make the angles that touch just touch */
static int balance(struct disk *disk)
{
    const int m = disk->angles;
    int n = 0;
    for (int j = 0; j < m; j++)
        n += disk->touches[j];
    for (int j = 0, row = 0; j < m; j++) {
        if (!disk->touches[j])
            continue;
        for (int k = 0, column = 0; k < m; k++)
            if (disk->touches[k])
                disk->system[row * (n + 1) + column++] = disk->compliance[j * m + k];
        disk->system[row++ * (n + 1) + n] = disk->reach[j];
    }
    if (eliminate(disk->system, n))
        return 1;
    for (int j = 0, row = 0; j < m; j++)
        disk->force[j] = disk->touches[j] ? disk->system[row++ * (n + 1) + n] : 0;
    return 0;
}

/* One angle at a time: the one that pulls most goes, or else the one that reaches in most comes (Lawson and Hanson). */
static int press_rigid(struct disk *disk)
{
    const int m = disk->angles;
    for (int round = 0; round < 100 * m; round++) {
        if (balance(disk))
            return 1;
        int worst = -1;
        double by = -1e-13;
        for (int j = 0; j < m; j++)
            if (disk->force[j] < by) {
                by = disk->force[j];
                worst = j;
            }
        if (worst < 0) {
            by = 1e-14;
            for (int j = 0; j < m; j++)
                if (!disk->touches[j] && disk->reach[j] > -1 && gap_at(disk, j) > by) {
                    by = gap_at(disk, j);
                    worst = j;
                }
            if (worst < 0)
                return 0;
        }
        disk->touches[worst] = !disk->touches[worst];
    }
    return 1;
}

/* f = exp(alpha x), x = reach - K (weight f), by Newton's method in ln(f), from the forces of the step before */
static int press_exponential(struct disk *disk)
{
    const int m = disk->angles;
    const double d = pi / disk->wall->nyquist, alpha = disk->wall->alpha;
    for (int j = 0; j < m; j++) /* no more than without a compliance */
        disk->force[j] = fmin(fmax(disk->force[j], d * exp(fmax(alpha * fmin(disk->reach[j], 0), -600))),
                              2 * d * exp(fmin(alpha * disk->reach[j], 0)));
    for (int round = 0; round < 200; round++) {
        double change = 0;
        for (int j = 0; j < m; j++) {
            const double weight = disk->wall->offset == 0 && j == 0 ? d : 2 * d;
            /* ln(f_j)/alpha = reach_j - sum K_jk weight_k f_k, unknown: the step of ln f */
            const double log_f = log(fmax(disk->force[j] / weight, 1e-300));
            for (int k = 0; k < m; k++)
                disk->system[j * (m + 1) + k] = disk->compliance[j * m + k] * disk->force[k] + (j == k ? 1 / alpha : 0);
            disk->system[j * (m + 1) + m] = gap_at(disk, j) - log_f / alpha;
        }
        if (eliminate(disk->system, m))
            return 1;
        for (int j = 0; j < m; j++) {
            const double step = disk->system[j * (m + 1) + m], bounded = fmin(fmax(step, -20), 2);
            disk->force[j] = fmax(disk->force[j], 1e-290) * exp(bounded);
            change = fmax(change, fabs(step) * fmin(disk->force[j] / 1e-16, 1));
        }
        if (change < 1e-9)
            return 0;
    }
    return 1;
}

static void set_reach(struct disk *disk, double depth)
{
    const int m = disk->angles;
    for (int j = 0; j < m; j++)
        disk->reach[j] = depth + cos(angle_of(disk->wall, j)) - 1;
    for (int i = 0; i < disk->modes; i++)
        for (int j = 0; j < m; j++)
            disk->reach[j] += disk->rim[i * m + j] * disk->q[i];
}

static void turn_modes(struct disk *disk, double h)
{
    for (int i = 0; i < disk->modes; i++) {
        const double omega = disk->omega[i], q = disk->q[i], q_dot = disk->q_dot[i];
        disk->q[i] = cos(omega * h) * q + sin(omega * h) / omega * q_dot;
        disk->q_dot[i] = cos(omega * h) * q_dot - sin(omega * h) * omega * q;
    }
}

static double kick(struct disk *disk, double h)
{
    const int m = disk->angles;
    double load = 0;
    for (int j = 0; j < m; j++)
        load += disk->force[j];
    if (load > 0)
        for (int i = 0; i < disk->modes; i++) {
            double force = 0;
            for (int j = 0; j < m; j++)
                force += disk->rim[i * m + j] * disk->force[j];
            disk->q_dot[i] -= h / mass * force;
        }
    return load;
}

/* As far as any part of the rim can be out of its round shape */
static double swing_of(const struct disk *disk)
{
    double swing = 0;
    for (int i = 0; i < disk->modes; i++) {
        double most = 0;
        for (int j = 0; j < disk->angles; j++)
            most = fmax(most, fabs(disk->rim[i * disk->angles + j]));
        swing += most * hypot(disk->q[i], disk->q_dot[i] / disk->omega[i]);
    }
    return swing;
}

/* 1 - eps^2, or NaN if a contact is not found or reaches the last angle */
static double disk_collide(struct disk *disk, double speed)
{
    const double h = disk->wall->h, alpha = disk->wall->alpha;
    /* an exponential wall begins where its load is nothing yet */
    double v = speed, depth = alpha > 0 ? log(1e-9 * speed * speed * alpha) / alpha : 0.5 * h * speed;
    for (int j = 0; j < disk->angles; j++) {
        disk->touches[j] = 0;
        disk->force[j] = alpha > 0 ? 1e-280 : 0;
    }
    for (int steps = 0; steps < 1000000; steps++) {
        set_reach(disk, depth);
        if (alpha > 0 ? press_exponential(disk) : press_rigid(disk) || disk->touches[disk->angles - 1])
            break;
        const double load = kick(disk, h);
        v -= h * load / mass;
        /* far enough away that even what the exponential wall has left is nothing */
        if (v < 0 && load <= (alpha > 0 ? 1e-9 * speed * speed * alpha : 0) && steps % 64 == 0 &&
            depth + swing_of(disk) < (alpha > 0 ? log(1e-10 * speed * speed * alpha) / alpha : 0))
            return 1 - v / speed * (v / speed);
        turn_modes(disk, h);
        depth += h * v;
    }
    return (double)NAN;
}

double reference_hard_wall(const struct cor_disk_modes *modes, double speed, const struct reference_wall *wall)
{
    int count = 0;
    while (count < (int)modes->count && modes->mode[count].omega < wall->omega)
        count++;
    const size_t n = (size_t)count, m = (size_t)wall->angles;
    double *const memory = malloc((n * m + m * m + m * (m + 1) + 3 * n + 2 * m) * sizeof *memory);
    int *const touches = malloc(m * sizeof *touches);
    if (memory == NULL || touches == NULL)
        abort();
    double *const rim = memory, *const compliance = rim + n * m, *const system = compliance + m * m,
                  *const omega = system + m * (m + 1), *const reach = omega + 3 * n;
    struct disk disk = {wall,      count,         wall->angles, rim,       compliance, omega,
                        omega + n, omega + 2 * n, reach,        reach + m, system,     touches};
    fill(&disk, modes);
    const double one_minus_eps2 = disk_collide(&disk, speed);
    free(memory);
    free(touches);
    return one_minus_eps2;
}
