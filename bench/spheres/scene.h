/* SPDX-License-Identifier: MIT */
/* What eps is asked for: a contact and a range of impact speeds. */
#ifndef COR_BENCH_SPHERES_SCENE_H
#define COR_BENCH_SPHERES_SCENE_H

#include <stddef.h>

#include <cor/cor.h>

struct scene {
    const char *name;
    double g_star; /* m/s, as all speeds; fixes the contact */
    double speed_min, speed_max;
    struct cor_sphere_contact contact;
};

enum { SCENES = 3 };

/* The scenes, with their contacts filled. */
void scenes_init(struct scene scenes[SCENES]);

/* Random speeds, uniform in their logarithm, the same in every run. */
void scene_speeds(const struct scene *scene, double *speed, size_t n);

/* From speed_min to speed_max, even in their logarithm. */
void scene_even_speeds(const struct scene *scene, double *speed, size_t n);

#endif
