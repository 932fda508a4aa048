/* SPDX-License-Identifier: MIT */
/* What corgen plan says of costs that are not made of operations (gen/plan/spheres.c, gen/plan/disks.c; docs/plan.md):
 * ns for each call, one after the other, at speeds of a range. */
#include <math.h>
#include <stdio.h>

#include "cor/cor.h"
#include "support/timing.h"

enum { SPEEDS = 256, ROUNDS = 15 };
#define SAMPLE_NS 2e6

static struct cor_sphere_contact contact;
static const struct cor_disk_modes *const modes = &cor_disk_modes_nu033;
static volatile double sink;

static double sphere_speed(int i)
{
    return 0.1 * pow(100, i / (SPEEDS - 1.0));
}

static double disk_speed(int i)
{
    return 0.003 * pow(30, i / (SPEEDS - 1.0));
}

static double rayleigh(size_t n, double speed)
{
    const struct cor_disk_modes cut = {modes->nu, n, modes->mode};
    struct cor_disk_rayleigh out;
    cor_disk_rayleigh(&cut, n, COR_DISK_DATUM_CENTRE_OF_MASS, speed, &out, NULL);
    return out.fraction;
}

#define JOB(name, expression)                                                                                          \
    static void name(void *closure)                                                                                    \
    {                                                                                                                  \
        const double *const v = closure;                                                                               \
        double sum = 0;                                                                                                \
        for (int i = 0; i < SPEEDS; i++) {                                                                             \
            const double g = v[i];                                                                                     \
            sum += (expression);                                                                                       \
        }                                                                                                              \
        sink = sum;                                                                                                    \
    }

JOB(power_law, fmin(1, 0.3 * pow(g, -0.234)))
JOB(simple, cor_sphere_eps_simple(cor_contact_beta(&contact, g)))
JOB(table, cor_disk_eps(g, 0.33))
JOB(contact_time, cor_disk_contact_time(g, 0.33, COR_DISK_DATUM_CENTRE_OF_MASS))
JOB(compression, cor_disk_max_compression(g, 0.33, COR_DISK_DATUM_CENTRE_OF_MASS))
JOB(contact_time_log, cor_disk_contact_time_leading_log(g))
JOB(compression_log, cor_disk_max_compression_leading_log(g))
JOB(rayleigh_1, rayleigh(1, g))
JOB(rayleigh_1000, rayleigh(1000, g))

/* A collision by its steps and modes, as plan_disks.c has it: ns for a step with no mode, and more for each mode. */
struct collision {
    size_t modes;
    double speed, steps;
};

static void disk_collide(void *closure)
{
    struct collision *const c = closure;
    const struct cor_disk_collision_options options = {56 / c->speed, 1e-6, 0, 0};
    struct cor_disk_collision out;
    cor_disk_collision(modes, c->modes, &options, c->speed, &out);
    c->steps = (double)out.steps;
}

int main(void)
{
    static double sphere[SPEEDS], disk[SPEEDS];
    for (int i = 0; i < SPEEDS; i++) {
        sphere[i] = sphere_speed(i);
        disk[i] = disk_speed(i);
    }
    cor_sphere_contact_init_g_star(&contact, 0.2);
    static const char *const name[] = {"power law",
                                       "(27)",
                                       "cor_disk_eps",
                                       "contact time",
                                       "largest compression",
                                       "contact time, leading logarithm",
                                       "largest compression, leading logarithm",
                                       "Rayleigh, 1 mode",
                                       "Rayleigh, 1000 modes"};
    struct job job[] = {
        {power_law, sphere, SPEEDS, 0},     {simple, sphere, SPEEDS, 0},    {table, disk, SPEEDS, 0},
        {contact_time, disk, SPEEDS, 0},    {compression, disk, SPEEDS, 0}, {contact_time_log, disk, SPEEDS, 0},
        {compression_log, disk, SPEEDS, 0}, {rayleigh_1, disk, SPEEDS, 0},  {rayleigh_1000, disk, SPEEDS, 0}};
    enum { JOBS = sizeof job / sizeof *job };
    timing_measure(job, JOBS, (struct timing){SAMPLE_NS, ROUNDS, 1});
    for (int i = 0; i < JOBS; i++)
        printf("%-40s %10.1f ns\n", name[i], job[i].best_ns);

    struct collision collision[] = {{100, 0.003, 0}, {100, 0.03, 0}, {100, 0.3, 0},   {940, 0.003, 0},
                                    {940, 0.03, 0},  {940, 0.3, 0},  {1800, 0.01, 0}, {1800, 0.1, 0}};
    enum { COLLISIONS = sizeof collision / sizeof *collision };
    struct job run[COLLISIONS];
    for (int i = 0; i < COLLISIONS; i++)
        run[i] = (struct job){disk_collide, &collision[i], 1, 0};
    timing_measure(run, COLLISIONS, (struct timing){SAMPLE_NS, ROUNDS, 1});
    printf("\n  modes  speed  steps   ns for each step   1000 + 4 modes\n");
    for (int i = 0; i < COLLISIONS; i++)
        printf("%7zu %6g %6.0f %18.0f %16zu\n", collision[i].modes, collision[i].speed, collision[i].steps,
               run[i].best_ns / collision[i].steps, 1000 + 4 * collision[i].modes);
    return 0;
}
