/* SPDX-License-Identifier: MIT */
/* Scenes, each a contact with a range of impact speeds, and their exact eps, by the tests' long double integration. */
#ifndef COR_BENCH_SPHERES_SCENE_H
#define COR_BENCH_SPHERES_SCENE_H

#include <stddef.h>

#include <cor/cor.h>

enum end { NO_END = -1, ZERO_OVERLAP, ZERO_FORCE };
enum input { FROM_SPEED, FROM_BETA };

struct scene {
    const char *name;
    double g_star; /* m/s, like all speeds; determines the contact */
    double speed_min, speed_max;
    struct cor_sphere_contact contact;
};

enum { SCENES = 3, CHECKED = 2000 };

/* Sets the scenes, with their contacts. */
void scenes_init(struct scene scenes[SCENES]);

/* Makes random speeds, log-uniform, the same in every run. */
void scene_speeds(const struct scene *scene, double *speed, size_t n);

/* Makes speeds from speed_min to speed_max, evenly spaced in their logarithm. */
void scene_even_speeds(const struct scene *scene, double *speed, size_t n);

struct truth {
    double in[2][CHECKED]; /* index: enum input; speeds evenly spaced in their logarithm, and the beta of each */
    long double eps[2][2][CHECKED]; /* index: enum input, enum end */
};

/* Computes eps at speed g for the exact beta_per_root g^(1/5), and eps at the double beta in in[FROM_BETA]. */
void truth_compute(struct truth *truth, const struct scene *scene);

#endif
