/* SPDX-License-Identifier: MIT */
#include "scene.h"

#include <math.h>
#include <stdint.h>

#include "ode.h"

void scenes_init(struct scene scenes[SCENES])
{
    static const struct scene table[SCENES] = {
        {.name = "ordinary", .g_star = 0.2, .speed_min = 0.001, .speed_max = 10},   /* 0.30 <= beta <= 1.90 */
        {.name = "strong", .g_star = 0.00063, .speed_min = 0.001, .speed_max = 10}, /* 0.95 <= beta <= 6.00 */
        {.name = "weak", .g_star = 40000, .speed_min = 0.001, .speed_max = 10},     /* 0.03 <= beta <= 0.19 */
    };
    for (int i = 0; i < SCENES; i++) {
        scenes[i] = table[i];
        cor_sphere_contact_init_g_star(&scenes[i].contact, scenes[i].g_star);
    }
}

/* Returns a number of splitmix64 in [0, 1). */
static double uniform(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

void scene_speeds(const struct scene *scene, double *speed, size_t n)
{
    uint64_t state = 1;
    for (size_t i = 0; i < n; i++)
        speed[i] = scene->speed_min * pow(scene->speed_max / scene->speed_min, uniform(&state));
}

void scene_even_speeds(const struct scene *scene, double *speed, size_t n)
{
    for (size_t i = 0; i < n; i++)
        speed[i] = scene->speed_min * pow(scene->speed_max / scene->speed_min, (double)i / (double)(n - 1));
    speed[n - 1] = scene->speed_max;
}

/* Returns the force of Hertz's spring and its damper, where x = w^2. */
static long double force(long double w, long double v, const void *beta)
{
    return w * w * w + *(const long double *)beta * w * v;
}

static void reference(struct truth *truth, enum input input, int i, long double beta)
{
    const struct motion_course r = motion_course(&(struct motion){2, 0, force, &beta, 0, 0});
    truth->eps[input][ZERO_OVERLAP][i] = r.eps[0];
    truth->eps[input][ZERO_FORCE][i] = r.eps[1];
}

void truth_compute(struct truth *truth, const struct scene *scene)
{
    scene_even_speeds(scene, truth->in[FROM_SPEED], CHECKED);
    for (int i = 0; i < CHECKED; i++) {
        const long double beta = scene->contact.beta_per_root * powl((long double)truth->in[FROM_SPEED][i], 0.2L);
        truth->in[FROM_BETA][i] = (double)beta;
        reference(truth, FROM_SPEED, i, beta);
        reference(truth, FROM_BETA, i, (long double)(double)beta);
    }
}
