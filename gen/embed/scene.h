/* SPDX-License-Identifier: MIT */
/* A scene: eps as a function of the impact speed over a range of speeds, with a tolerance */
#ifndef COR_GEN_EMBED_SCENE_H
#define COR_GEN_EMBED_SCENE_H

#include "approximation/law_layout.h"
#include "embed/own_law.h"
#include "embed/request.h"

struct interpolant;

/* Speeds at equal distances of their logarithms, and eps as sums of two doubles */
struct embed_samples {
    double *speed, *eps, *rest;
};

struct embed_scene {
    enum cor_end end;
    bool single; /* float */
    double speed_min, speed_max, tolerance;
    struct cor_exponents law, named; /* of beta, and of the request: see by_speed */
    bool plastic;
    struct own_law own; /* own.law 0: none */
    double *knot;       /* of its table: where cubics begin, and the end of the last one; NULL: no table */
    slong knots;
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
    /* spheres without a constant force: eps at zero overlap falls as h_star_5 beta^-5, and in powers of
     * beta^(1/series_root) is a series */
    arb_t h_star_5;
    arb_poly_t series;
    slong series_root;
    struct law_layout layout; /* of another law's interpolant */
};

enum { EMBED_SAMPLES = 4096, EMBED_BITS = 320, EMBED_SERIES = 40 /* order */ };

/* `contact` is that of the request by cor_scene_contacts. Returns STATUS_OK, or STATUS_USAGE or STATUS_FAILED after a
 * message on stderr. */
int embed_scene_init(struct embed_scene *s, const struct embed_request *request,
                     const struct cor_scene_contact *contact);
void embed_scene_clear(struct embed_scene *s);

/* beta at a speed; if `enclosed`, with the uncertainty of a beta that eps determines */
void embed_scene_beta(arb_t beta, const struct embed_scene *s, const arb_t speed, bool enclosed);

/* eps at a speed in [speed_min, speed_max], shifted like these, as accurate as interpolant.h states */
void embed_scene_eps(arb_t eps, const struct embed_scene *s, const arb_t speed);

/* x rounded to the scene's type */
double embed_rounded(const struct embed_scene *s, double x);

/* ---- the contact of a request, as exact as its numbers are written ----
 *
 * cor_scene_contacts has accepted them, and computes the same in doubles. */

/* Fills numbers that are 0 before, enclosed to `prec` bits:
 *
 *     beta_per_root: of beta = beta_per_root (speed/(m/s))^q, q = 1/5 for spheres. From a restitution it is enclosed to
 *                    2^-79 of itself, under a constant force to 2^-149. Elastic-plastic spheres have none.
 *     force: f_1 of the constant force f = f_1 (speed/(m/s))^(-2a/(a+1)) of x'' + beta x^b x' + x^a = f; 0 without one
 *     yield_speed: v_y of elastic-plastic spheres, m/s
 *     liquid_speed: the speed that a liquid takes on each way, m/s; 0 without one
 *
 * Returns STATUS_OK, or STATUS_FAILED after a message. */
int embed_contact_numbers(arb_t beta_per_root, arb_t force, arb_t yield_speed, arb_t liquid_speed,
                          const struct embed_request *request, const struct cor_scene_contact *contact, slong prec);

/* eps of one collision, under a constant force that may be 0, enclosed to `bits` bits; `end` is the end of contact.
 * Returns STATUS_OK, or STATUS_FAILED after a message. */
int embed_contact_eps(arb_t eps, const arb_t beta, const arb_t force, const struct cor_exponents *law, int end,
                      slong bits);

/* eps of elastic-plastic spheres above the yield speed */
void embed_elastic_plastic_eps(arb_t eps, const arb_t speed, const arb_t yield_speed, slong prec);

#endif
