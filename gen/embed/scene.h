/* SPDX-License-Identifier: MIT */
/* A scene: eps as a function of the impact speed over a range of speeds, with a tolerance */
#ifndef COR_GEN_EMBED_SCENE_H
#define COR_GEN_EMBED_SCENE_H

#include "approximation/law_layout.h"
#include "embed/request.h"

struct interpolant;

/* Speeds at equal distances of their logarithms, and eps as sums of two doubles */
struct embed_samples {
    slong count;
    double *speed, *eps, *rest;
};

struct embed_scene {
    enum contact_end end;
    bool single; /* float */
    double speed_min, speed_max, tolerance;
    struct law law, named; /* of beta, and of the request: see by_speed */
    bool plastic;
    bool by_speed;      /* dry eps is a closed form of the speed; law has q = 1, and beta is the speed in m/s */
    arb_t yield_speed;  /* of elastic-plastic spheres */
    arb_t liquid_speed; /* what a liquid takes on each way; 0: a dry contact */
    bool pressed;       /* by a constant force: f = press beta^(-2a/n), and eps = 0 up to sticking_speed */
    arb_t press, sticking_speed;
    double sticking_log; /* ln(beta) at that speed */
    double origin;       /* every speed of the scene but the onset is less by this, a double below sticking_speed */
    double onset;        /* eps is 1, or 0 if pressed, up to this speed; the forms begin above it; 0: no such speed */
    bool constant;       /* eps is the same at every speed: no damping, or q = 0 */
    arb_t eps;           /* that eps */
    arb_t beta_per_root; /* beta = beta_per_root speed^q, q = 1/5 for spheres */
    arb_t beta_enclosed; /* the same, where beta_per_root is the middle of a ball that eps determines */
    double beta_min, beta_max;
    double slope; /* largest |d ln(eps)/d ln(speed^(1/5))|; for spheres |d ln(eps)/d ln(beta)| */
    struct embed_samples samples;
    struct interpolant *interpolant;
    arb_t h_star_5;           /* spheres */
    struct law_layout layout; /* of another law's interpolant */
};

enum { EMBED_SAMPLES = 4096, EMBED_BITS = 320 };

/* `contact` is that of the request by cor_scene_contacts. Returns STATUS_OK, or STATUS_USAGE or STATUS_FAILED after a
 * message on stderr. */
int embed_scene_init(struct embed_scene *s, const struct embed_request *request,
                     const struct cor_scene_contact *contact);
void embed_scene_clear(struct embed_scene *s);

/* beta at a speed; the second includes the uncertainty of a beta that eps determines */
void embed_scene_beta(arb_t beta, const struct embed_scene *s, const arb_t speed);
void embed_scene_beta_enclosed(arb_t beta, const struct embed_scene *s, const arb_t speed);

/* eps at a speed in [speed_min, speed_max], shifted like these, as accurate as interpolant.h states */
void embed_scene_eps(arb_t eps, const struct embed_scene *s, const arb_t speed);

/* x rounded to the scene's type */
double embed_rounded(const struct embed_scene *s, double x);

#endif
