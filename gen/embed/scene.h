/* SPDX-License-Identifier: MIT */
/* A scene: eps as a function of the impact speed over a range of speeds, and its tolerance */
#ifndef COR_GEN_EMBED_SCENE_H
#define COR_GEN_EMBED_SCENE_H

#include "approximation/law_layout.h"
#include "embed/own_law.h"
#include "embed/request.h"

struct interpolant;

/* Speeds that are equally spaced in their logarithm, and eps as the sum of two doubles, eps + rest */
struct embed_samples {
    double *speed, *eps, *rest;
};

struct embed_scene {
    enum cor_end end;
    bool single; /* float */
    double speed_min, speed_max, tolerance;
    struct cor_exponents law, named; /* named: the law of the request; law: q = 1 if by_speed, otherwise the same */
    bool plastic;
    struct own_law own; /* own.law 0: none */
    double *knot;       /* the starts of the cubics of the law's table, and the end of the last one; NULL: no table */
    slong knots;
    bool by_speed;      /* dry eps is a closed form of the speed; law has q = 1, and beta is the speed in m/s */
    arb_t yield_speed;  /* yield speed of elastic-plastic spheres */
    arb_t liquid_speed; /* the speed lost to a liquid on each way; 0: a dry contact */
    bool pressed;       /* a constant force f = press beta^(-2a/n) acts; eps = 0 up to sticking_speed */
    arb_t press, sticking_speed;
    double sticking_log; /* ln(beta) at that speed */
    double origin;       /* a double below sticking_speed; subtracted from every speed of the scene except the onset */
    double onset;        /* up to this speed eps is 1 (0 if pressed); the forms begin above it; 0: none */
    bool constant;       /* eps is the same at every speed: no damping, or q = 0 */
    arb_t eps;           /* the value of the constant eps */
    arb_t beta_per_root; /* beta = beta_per_root speed^q, q = 1/5 for spheres */
    arb_t beta_enclosed; /* encloses beta_per_root, which is the middle of this ball if a restitution is given */
    double beta_min, beta_max;
    double slope; /* largest |d ln(eps)/d ln(speed^(1/5))|; for spheres |d ln(eps)/d ln(beta)| */
    struct embed_samples samples;
    struct interpolant *interpolant;
    /* for spheres without a constant force: eps at zero overlap is h_star_5 beta^-5 for large beta; the series of eps
     * is in powers of beta^(1/series_root) */
    arb_t h_star_5;
    arb_poly_t series;
    slong series_root;
    struct law_layout layout; /* layout of the interpolant of another law */
};

enum { EMBED_SAMPLES = 4096, EMBED_BITS = 320, EMBED_SERIES = 40 /* order */ };

/* Prepares a scene. contact: a result of cor_scene_contacts. Returns STATUS_OK, or another status after a message. */
int embed_scene_init(struct embed_scene *s, const struct embed_request *request,
                     const struct cor_scene_contact *contact);
void embed_scene_clear(struct embed_scene *s);

/* Computes beta at a speed. enclosed: includes the uncertainty of a beta that follows from a restitution */
void embed_scene_beta(arb_t beta, const struct embed_scene *s, const arb_t speed, bool enclosed);

/* Computes eps at a speed in [speed_min, speed_max]; all three have the origin subtracted. Accuracy: interpolant.h */
void embed_scene_eps(arb_t eps, const struct embed_scene *s, const arb_t speed);

/* Returns x rounded to the scene's type */
double embed_rounded(const struct embed_scene *s, double x);

/* ---- the contact of a request, from the exact decimal numbers ----
 *
 * cor_scene_contacts has accepted these numbers, and computes the same quantities in doubles. */

/* Fills numbers that are 0 on entry, enclosed to `prec` bits:
 *
 *     beta_per_root: the factor in beta = beta_per_root (speed/(m/s))^q, q = 1/5 for spheres. If it follows from a
 *                    restitution, its relative error is at most 2^-79, or 2^-149 under a constant force.
 *                    Elastic-plastic spheres have none.
 *     force: f_1 in the constant force f = f_1 (speed/(m/s))^(-2a/(a+1)) of x'' + beta x^b x' + x^a = f; 0 without one
 *     yield_speed: v_y of elastic-plastic spheres, m/s
 *     liquid_speed: the speed lost to a liquid on each way, m/s; 0 without one
 *
 * Returns STATUS_OK, or STATUS_FAILED after a message. */
int embed_contact_numbers(arb_t beta_per_root, arb_t force, arb_t yield_speed, arb_t liquid_speed,
                          const struct embed_request *request, const struct cor_scene_contact *contact, slong prec);

/* Encloses eps of one collision to `bits` bits, under a constant force that may be 0. end: the end of contact. Returns
 * STATUS_OK, or STATUS_FAILED after a message. */
int embed_contact_eps(arb_t eps, const arb_t beta, const arb_t force, const struct cor_exponents *law, int end,
                      slong bits);

/* Computes eps of elastic-plastic spheres above the yield speed */
void embed_elastic_plastic_eps(arb_t eps, const arb_t speed, const arb_t yield_speed, slong prec);

#endif
