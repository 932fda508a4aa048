/* SPDX-License-Identifier: MIT */
#include "check.h"

#include "relaxed_disk.h"

static const double pi = 3.14159265358979323846;

static double load_at(struct relaxed_disk *disk, double compression)
{
    const double load = relaxed_disk_press(disk, compression);
    check(load == disk->load, "no equilibrium at %g", compression);
    return load;
}

static double energy_at(struct relaxed_disk *disk, double compression)
{
    load_at(disk, compression);
    return disk->energy;
}

static struct relaxed_disk *finite_disk(size_t points)
{
    return relaxed_disk_of_modes(&cor_disk_modes_nu033, 1300, 500, points);
}

/* Values from another program, which minimises over the amplitudes Q of all modes. */
TEST(loads_of_1300_modes)
{
    struct relaxed_disk *disk = finite_disk(128);
    const struct {
        double compression, load;
    } known[] = {{0.05, 0.044713}, {0.2, 0.273241}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const double load = load_at(disk, known[i].compression);
        check(fabs(load - known[i].load) <= 5e-7, "P(%g) = %.9f", known[i].compression, load);
    }
    free(disk);
}

static double kernel_at(const struct relaxed_disk *disk, size_t i, size_t j)
{
    return disk->kernel[i * disk->points + j];
}

/* Returns the sum of (40) and (42), mode by mode. */
static double kernel_mode_by_mode(size_t n_modes, double phi, double psi)
{
    double sum = 0;
    for (size_t i = 0; i < n_modes; i++) {
        const struct cor_disk_mode *mode = &cor_disk_modes_nu033.mode[i];
        const double n = mode->n;
        const double at_phi = mode->c * cos(n * phi) * cos(phi) - mode->s * sin(n * phi) * sin(phi);
        const double at_psi = mode->c * cos(n * psi) * cos(psi) - mode->s * sin(n * psi) * sin(psi);
        sum += at_phi * at_psi / (pi * mode->omega * mode->omega);
    }
    return sum;
}

TEST(kernel_is_the_sum_over_modes_and_symmetric)
{
    enum { POINTS = 40 };
    const double step = pi / 2 / (double)POINTS;
    struct relaxed_disk *disk = finite_disk(POINTS);
    struct relaxed_disk *all = relaxed_disk_of_all_modes(0.33, 500, POINTS);
    for (size_t i = 0; i < POINTS; i++)
        for (size_t j = 0; j < POINTS; j++) {
            const double kernel = kernel_at(disk, i, j), swapped = kernel_at(disk, j, i);
            check(fabs(kernel - swapped) <= 1e-15, "G(%zu, %zu) = %.17g, %.17g", i, j, kernel, swapped);
            check(fabs(kernel_at(all, i, j) - kernel_at(all, j, i)) <= 1e-15, "%zu %zu", i, j);
            if ((i + j) % 5 != 0)
                continue;
            const double sum = kernel_mode_by_mode(1300, ((double)i + 0.5) * step, ((double)j + 0.5) * step);
            check(fabs(kernel - sum) <= 1e-13, "G(%zu, %zu) = %.17g, %.17g", i, j, kernel, sum);
        }
    free(disk);
    free(all);
}

/* Returns half of f . G f, the energy that a pressure f = cos(phi)^power stores. */
static double energy_of_smooth_pressure(const struct relaxed_disk *disk, size_t points, int power)
{
    const double step = pi / 2 / (double)points;
    double sum = 0;
    for (size_t i = 0; i < points; i++)
        for (size_t j = 0; j < points; j++)
            sum += kernel_at(disk, i, j) * pow(cos(((double)i + 0.5) * step) * cos(((double)j + 0.5) * step), power);
    return 2 * step * step * sum;
}

/* The part of the modes beyond omega is proportional to 1/omega, so 2 G(4 N) - G(N) nearly contains all modes. */
TEST(all_modes_are_the_limit_of_many)
{
    enum { POINTS = 60 };
    const struct cor_disk_modes *table[] = {&cor_disk_modes_nu033, &cor_disk_modes_nu090};
    for (size_t t = 0; t < 2; t++) {
        struct relaxed_disk *some = relaxed_disk_of_modes(table[t], 450, 500, POINTS);
        struct relaxed_disk *many = relaxed_disk_of_modes(table[t], 1800, 500, POINTS);
        struct relaxed_disk *all = relaxed_disk_of_all_modes(table[t]->nu, 500, POINTS);
        for (int power = 0; power <= 8; power++) {
            const double limit =
                2 * energy_of_smooth_pressure(many, POINTS, power) - energy_of_smooth_pressure(some, POINTS, power);
            const double energy = energy_of_smooth_pressure(all, POINTS, power);
            check(fabs(limit / energy - 1) <= 1e-3, "nu = %g, power %d: %g, %g", table[t]->nu, power, limit, energy);
        }
        free(some);
        free(many);
        free(all);
    }
}

/* The result satisfies the equation in the header, and the load is the integral of the pressure. */
TEST(the_pressure_solves_the_equation)
{
    const double alpha = 500, compression = 0.15;
    struct relaxed_disk *disk = relaxed_disk_of_all_modes(0.33, alpha, 100);
    load_at(disk, compression);
    const double step = pi / 2 / (double)disk->points;
    double load = 0;
    for (size_t i = 0; i < disk->points; i++) {
        double x = compression - 1 + cos(((double)i + 0.5) * step);
        for (size_t j = 0; j < disk->points; j++)
            x -= 2 * step * kernel_at(disk, i, j) * disk->f[j];
        const double error = log(disk->f[i]) / alpha - x;
        check(fabs(error) <= 1e-13, "%g at point %zu", error, i);
        load += 2 * step * disk->f[i];
    }
    check(disk->largest_residual <= 1e-13, "%g", disk->largest_residual);
    check(fabs(load / disk->load - 1) <= 1e-14, "%.17g, %.17g", load, disk->load);
    free(disk);
}

/* dE/dx_0 = P, from five points. Ten modes cannot adapt to a hard wall: it touches them at a few places only, and the
 * path to that state has many stages. */
TEST(the_load_is_the_slope_of_the_energy)
{
    const struct {
        struct relaxed_disk *disk;
        double compression[3], h, allowed;
    } scene[] = {{finite_disk(128), {0.01, 0.1, 0.25}, 1e-3, 1e-6},
                 {relaxed_disk_of_all_modes(0.9, 2000, 256), {0.01, 0.1, 0.25}, 1e-3, 1e-6},
                 {relaxed_disk_of_modes(&cor_disk_modes_nu033, 10, 1e6, 256), {0.3}, 1e-4, 1e-4}};
    for (size_t d = 0; d < COUNT_OF(scene); d++) {
        struct relaxed_disk *const disk = scene[d].disk;
        for (size_t i = 0; i < 3 && scene[d].compression[i] > 0; i++) {
            const double delta = scene[d].compression[i], h = scene[d].h;
            const double near = energy_at(disk, delta + h) - energy_at(disk, delta - h);
            const double far = energy_at(disk, delta + 2 * h) - energy_at(disk, delta - 2 * h);
            const double slope = (8 * near - far) / (12 * h), load = load_at(disk, delta);
            check(fabs(slope / load - 1) <= scene[d].allowed, "disk %zu at %g: %.12g, %.12g", d, delta, slope, load);
            check(disk->largest_residual <= 1e-10, "%g", disk->largest_residual);
        }
        free(disk);
    }
}

TEST(neither_the_way_nor_the_number_of_points_matters)
{
    struct relaxed_disk *disk = relaxed_disk_of_all_modes(0.33, 500, 128);
    struct relaxed_disk *finer = relaxed_disk_of_all_modes(0.33, 500, 256);
    const double there = load_at(disk, 0.05);
    load_at(disk, 0.3);
    load_at(disk, -0.01);
    const double others[] = {load_at(disk, 0.05), load_at(disk, 0.05), load_at(finer, 0.05)}; /* 2: again; 3: finer */
    for (size_t i = 0; i < COUNT_OF(others); i++)
        check(fabs(others[i] / there - 1) <= 1e-12, "%.17g, %.17g", others[i], there);
    free(disk);
    free(finer);
}

/* The harder the wall, the closer is the load to the law of (57) with the centre of mass as datum. */
TEST(a_hard_wall_gives_the_contact_law)
{
    leave_to_turn(0, 2);
    const double delta = 0.03, law = cor_disk_load(delta, 0.33, COR_DISK_DATUM_CENTRE_OF_MASS);
    const double alpha[] = {500, 2000, 2e4};
    double ratio[3];
    for (size_t i = 0; i < 3; i++) {
        struct relaxed_disk *disk = relaxed_disk_of_all_modes(0.33, alpha[i], 400);
        ratio[i] = load_at(disk, delta) / law;
        free(disk);
    }
    check(fabs(ratio[2] - 1.001) <= 5e-4, "%.6f", ratio[2]);
    check(ratio[0] > ratio[1] && ratio[1] > ratio[2], "%.6f, %.6f, %.6f", ratio[0], ratio[1], ratio[2]);
}
