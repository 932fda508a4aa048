/* SPDX-License-Identifier: MIT */
/* A scene: eps as a function of the impact speed over a range of speeds, to a tolerance. */
#ifndef COR_GEN_EMBED_SCENE_H
#define COR_GEN_EMBED_SCENE_H

#include "embed/request.h"

struct interpolant;

/* Speeds, even in their logarithm, and eps there as a sum of two doubles. */
struct embed_samples {
    slong count;
    double *speed, *eps, *rest;
};

struct embed_scene {
    enum contact_end end;
    bool single; /* float */
    double speed_min, speed_max, tolerance;
    arb_t beta_per_root; /* beta = beta_per_root speed^(1/5) */
    double beta_min, beta_max;
    double slope; /* the largest |d ln(eps)/d ln(beta)| */
    struct embed_samples samples;
    struct interpolant *interpolant;
    arb_t h_star_5;
};

enum { EMBED_SAMPLES = 4096, EMBED_BITS = 320 };

/* STATUS_OK, or STATUS_USAGE or STATUS_FAILED after a sentence on stderr. */
int embed_scene_init(struct embed_scene *s, const struct embed_request *request);
void embed_scene_clear(struct embed_scene *s);

/* eps at a speed in [speed_min, speed_max], certified as interpolant.h says. */
void embed_scene_eps(arb_t eps, const struct embed_scene *s, const arb_t speed);

/* x as the scene's type holds it */
double embed_rounded(const struct embed_scene *s, double x);

#endif
