/* SPDX-License-Identifier: MIT */
#include "embed/scene.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "approximation/interpolant.h"
#include "enclosure/collision.h"
#include "support/console.h"

/* At zero overlap eps is h*^5 beta^-5 from here on, to 2^-60; the interpolant ends at 8.25. */
#define OVERLAP_FAR 7.0
/* At zero force the interpolant ends at 17; from exp(10) on there are three orders in beta^(-5/3). */
#define FORCE_FAR 16.9
#define LOG_FAR 9.99
/* eps below this is of no use in a double, in a float */
#define EPS_LEAST 1e-250
#define EPS_LEAST_FLOAT 1e-30

double embed_rounded(const struct embed_scene *s, double x)
{
    return s->single ? (double)(float)x : x;
}

/* ---- beta from materials ---- */

/* The number of body 2, or else that of body 1. */
static void of_body(arb_t x, const struct embed_request *request, enum embed_number which, int body)
{
    arb_set_fmpq(x, embed_number_of_body(request, which, body)->value, EMBED_BITS);
}

/* (1 - nu^2)/Y; 0 of a rigid body */
static void compliance(arb_t c, const struct embed_request *request, int body)
{
    arb_t nu, y;
    arb_init(nu);
    arb_init(y);
    of_body(nu, request, EMBED_POISSON, body);
    of_body(y, request, EMBED_YOUNG, body);
    arb_sqr(c, nu, EMBED_BITS);
    arb_sub_ui(c, c, 1, EMBED_BITS);
    arb_neg(c, c);
    arb_div(c, c, y, EMBED_BITS);
    arb_clear(nu);
    arb_clear(y);
}

/* 1/radius and 1/mass; 0 of a wall */
static void inverses(arb_t radius, arb_t mass, const struct embed_request *request, int body)
{
    arb_zero(radius);
    arb_zero(mass);
    if (body == 2 && request->wall)
        return;
    arb_t x, y;
    arb_init(x);
    arb_init(y);
    of_body(x, request, EMBED_RADIUS, body);
    arb_inv(radius, x, EMBED_BITS);
    if (embed_mass_is_given(request, body)) {
        of_body(mass, request, EMBED_MASS, body);
    } else { /* (4/3) pi R^3 density */
        arb_pow_ui(x, x, 3, EMBED_BITS);
        of_body(y, request, EMBED_DENSITY, body);
        arb_mul(x, x, y, EMBED_BITS);
        arb_const_pi(y, EMBED_BITS);
        arb_mul(x, x, y, EMBED_BITS);
        arb_mul_ui(x, x, 4, EMBED_BITS);
        arb_div_ui(mass, x, 3, EMBED_BITS);
    }
    arb_inv(mass, mass, EMBED_BITS);
    arb_clear(x);
    arb_clear(y);
}

/* (3/2) A (rho/m)^(2/5) of include/cor/contact.h */
static void beta_of_materials(arb_t beta, const struct embed_request *request)
{
    enum { C1, C2, C, R1, R2, M1, M2, A, RHO, COUNT };
    arb_ptr x = _arb_vec_init(COUNT);
    compliance(x + C1, request, 1);
    compliance(x + C2, request, 2);
    arb_add(x + C, x + C1, x + C2, EMBED_BITS);
    inverses(x + R1, x + M1, request, 1);
    inverses(x + R2, x + M2, request, 2);
    arb_add(x + R1, x + R1, x + R2, EMBED_BITS); /* 1/R */
    arb_add(x + M1, x + M1, x + M2, EMBED_BITS); /* 1/m */
    /* rho = 4 sqrt(R)/(3 (c_1 + c_2)) */
    arb_rsqrt(x + RHO, x + R1, EMBED_BITS);
    arb_mul_ui(x + RHO, x + RHO, 4, EMBED_BITS);
    arb_div_ui(x + RHO, x + RHO, 3, EMBED_BITS);
    arb_div(x + RHO, x + RHO, x + C, EMBED_BITS);
    /* A = (A_1 c_1 + A_2 c_2)/(c_1 + c_2) */
    of_body(beta, request, EMBED_DISSIPATION_TIME, 1);
    arb_mul(x + A, beta, x + C1, EMBED_BITS);
    of_body(beta, request, EMBED_DISSIPATION_TIME, 2);
    arb_addmul(x + A, beta, x + C2, EMBED_BITS);
    arb_div(x + A, x + A, x + C, EMBED_BITS);
    arb_mul(x + RHO, x + RHO, x + M1, EMBED_BITS);
    arb_pow_ratio(beta, x + RHO, ratio_make(2, 5), EMBED_BITS);
    arb_mul(beta, beta, x + A, EMBED_BITS);
    arb_mul_ui(beta, beta, 3, EMBED_BITS);
    arb_mul_2exp_si(beta, beta, -1);
    _arb_vec_clear(x, COUNT);
}

/* |C_1| = sqrt(pi) Gamma(3/5)/(2^(1/5) 5^(2/5) Gamma(21/10)), (30) */
static void first_coefficient(arb_t c)
{
    arb_t x;
    fmpq_t argument;
    arb_init(x);
    fmpq_init(argument);
    fmpq_set_si(argument, 3, 5);
    arb_gamma_fmpq(c, argument, EMBED_BITS);
    fmpq_set_si(argument, 21, 10);
    arb_gamma_fmpq(x, argument, EMBED_BITS);
    arb_div(c, c, x, EMBED_BITS);
    arb_const_pi(x, EMBED_BITS);
    arb_sqrt(x, x, EMBED_BITS);
    arb_mul(c, c, x, EMBED_BITS);
    arb_set_ui(x, 50); /* 2^(1/5) 5^(2/5) */
    arb_root_ui(x, x, 5, EMBED_BITS);
    arb_div(c, c, x, EMBED_BITS);
    fmpq_clear(argument);
    arb_clear(x);
}

static void beta_of_g_star(arb_t beta, const struct embed_request *request)
{
    arb_t c;
    arb_init(c);
    arb_set_fmpq(beta, request->number[EMBED_G_STAR].value, EMBED_BITS);
    arb_root_ui(beta, beta, 5, EMBED_BITS);
    first_coefficient(c);
    arb_mul(beta, beta, c, EMBED_BITS);
    arb_inv(beta, beta, EMBED_BITS);
    arb_clear(c);
}

/* ---- eps ---- */

/* eps beta^(5/3) at zero force, ln(beta) > 10 */
static void far_force(arb_t y, const struct embed_scene *s, const arb_t beta, const arb_t u)
{
    arb_ptr a = _arb_vec_init(INTERPOLANT_FAR);
    arb_t mu, order;
    arb_init(mu);
    arb_init(order);
    interpolant_far(a, s->interpolant, EPS_ZERO_FORCE);
    arb_pow_ratio(mu, beta, ratio_make(-5, 3), EMBED_BITS);
    /* ((a_8 u + ...) mu + (a_4 u + ...)) mu + a_1 u + a_0 */
    static const int first[] = {0, 2, 5, INTERPOLANT_FAR};
    arb_zero(y);
    for (int i = 2; i >= 0; i--) {
        arb_zero(order);
        for (int k = first[i + 1] - 1; k >= first[i]; k--) {
            arb_mul(order, order, u, EMBED_BITS);
            arb_add(order, order, a + k, EMBED_BITS);
        }
        arb_mul(y, y, mu, EMBED_BITS);
        arb_add(y, y, order, EMBED_BITS);
    }
    arb_clear(mu);
    arb_clear(order);
    _arb_vec_clear(a, INTERPOLANT_FAR);
}

static void eps_of_beta(arb_t eps, const struct embed_scene *s, const arb_t beta)
{
    const double b = arf_get_d(arb_midref(beta), ARF_RND_NEAR);
    const bool overlap = s->end == END_ZERO_OVERLAP;
    arb_t z;
    arb_init(z);
    if (overlap && b >= OVERLAP_FAR) {
        arb_pow_ui(z, beta, 5, EMBED_BITS);
        arb_div(eps, s->h_star_5, z, EMBED_BITS);
    } else if (b < FORCE_FAR) {
        arb_sqrt(z, beta, EMBED_BITS);
        interpolant_value(eps, s->interpolant, overlap ? EPS_ZERO_OVERLAP : EPS_ZERO_FORCE, z, EMBED_BITS);
    } else {
        arb_log(z, beta, EMBED_BITS);
        if (log(b) < LOG_FAR)
            interpolant_tail(eps, s->interpolant, EPS_ZERO_FORCE, z, EMBED_BITS);
        else
            far_force(eps, s, beta, z);
        arb_pow_ratio(z, beta, ratio_make(-5, 3), EMBED_BITS);
        arb_mul(eps, eps, z, EMBED_BITS);
    }
    arb_clear(z);
    /* The interpolant's exact samples make exact arithmetic of this: the radius is that of the rounding here. */
}

void embed_scene_eps(arb_t eps, const struct embed_scene *s, const arb_t speed)
{
    arb_t beta;
    arb_init(beta);
    arb_root_ui(beta, speed, 5, EMBED_BITS);
    arb_mul(beta, beta, s->beta_per_root, EMBED_BITS);
    eps_of_beta(eps, s, beta);
    arb_clear(beta);
}

/* ---- the scene ---- */

static void make_samples(struct embed_scene *s)
{
    struct embed_samples *samples = &s->samples;
    const double ratio = s->speed_max / s->speed_min;
    samples->count = EMBED_SAMPLES;
    samples->speed = xmalloc(3 * EMBED_SAMPLES * sizeof *samples->speed);
    samples->eps = samples->speed + EMBED_SAMPLES;
    samples->rest = samples->eps + EMBED_SAMPLES;
    arb_t g, eps;
    arb_init(g);
    arb_init(eps);
    for (slong i = 0; i < EMBED_SAMPLES; i++) {
        const double place = (double)i / (EMBED_SAMPLES - 1);
        double speed = i == 0                  ? s->speed_min
                       : i + 1 < EMBED_SAMPLES ? embed_rounded(s, s->speed_min * pow(ratio, place))
                                               : s->speed_max;
        samples->speed[i] = fmin(fmax(speed, s->speed_min), s->speed_max);
        arb_set_d(g, samples->speed[i]);
        embed_scene_eps(eps, s, g);
        samples->eps[i] = arf_get_d(arb_midref(eps), ARF_RND_NEAR);
        arb_set_d(g, samples->eps[i]);
        arb_sub(eps, eps, g, EMBED_BITS);
        samples->rest[i] = arf_get_d(arb_midref(eps), ARF_RND_NEAR);
    }
    arb_clear(g);
    arb_clear(eps);
    s->slope = 0;
    const slong step = EMBED_SAMPLES / 64;
    for (slong i = step; i < EMBED_SAMPLES; i += step)
        s->slope = fmax(s->slope, 5 * log(samples->eps[i - step] / samples->eps[i]) /
                                      log(samples->speed[i] / samples->speed[i - step]));
}

static int read_range(struct embed_scene *s, const struct embed_request *request)
{
    const double limit = s->single ? (double)FLT_MAX : DBL_MAX, least = s->single ? (double)FLT_MIN : 1e-270;
    const char *type = s->single ? "float" : "double";
    s->speed_min = embed_rounded(s, embed_number(request, EMBED_SPEED_MIN));
    s->speed_max = embed_rounded(s, embed_number(request, EMBED_SPEED_MAX));
    s->tolerance = embed_number(request, EMBED_TOLERANCE);
    if (!(s->speed_min >= least))
        return usage_error("--speed-min %s m/s is too small for a %s; at least %.2g",
                           request->number[EMBED_SPEED_MIN].text, type, least);
    if (!(s->speed_max <= fmin(limit, 1e270)))
        return usage_error("--speed-max %s m/s is too large for a %s", request->number[EMBED_SPEED_MAX].text, type);
    if (!(s->speed_max > s->speed_min))
        return usage_error("--speed-min %s is not below --speed-max %s", request->number[EMBED_SPEED_MIN].text,
                           request->number[EMBED_SPEED_MAX].text);
    const double finest = s->single ? 4e-7 : 1e-15;
    if (!(s->tolerance >= finest && s->tolerance <= 0.1))
        return usage_error("--tolerance %s is not from %g to 0.1, what a %s can hold",
                           request->number[EMBED_TOLERANCE].text, finest, type);
    return STATUS_OK;
}

static int prepare(struct embed_scene *s)
{
    const bool overlap = s->end == END_ZERO_OVERLAP;
    const double per_root = arf_get_d(arb_midref(s->beta_per_root), ARF_RND_NEAR);
    s->beta_min = per_root * pow(s->speed_min, 0.2);
    s->beta_max = per_root * pow(s->speed_max, 0.2);
    if (arb_is_zero(s->beta_per_root))
        return usage_error("--dissipation-time: no dissipation, so eps is 1 at every speed; no header is needed");
    if (!(s->beta_min > 1e-60 && s->beta_max < 1e60))
        return fail("beta from %.3g to %.3g: no material is like that", s->beta_min, s->beta_max);
    if (overlap && collision_h_star(s->h_star_5, EMBED_BITS / 2))
        return STATUS_FAILED;
    arb_pow_ui(s->h_star_5, s->h_star_5, 5, EMBED_BITS);
    if (!overlap || s->beta_min < OVERLAP_FAR) {
        s->interpolant = interpolant_new(&interpolant_sphere, s->beta_min * (1 - 1e-9),
                                         overlap ? fmin(s->beta_max, OVERLAP_FAR) : s->beta_max * (1 + 1e-9));
        if (!s->interpolant)
            return STATUS_FAILED;
    }
    make_samples(s);
    const double least = s->samples.eps[EMBED_SAMPLES - 1];
    if (!(least > (s->single ? EPS_LEAST_FLOAT : EPS_LEAST)))
        return fail("eps falls to %.3g at --speed-max, beta = %.3g: too small for a %s", least, s->beta_max,
                    s->single ? "float" : "double");
    return STATUS_OK;
}

int embed_scene_init(struct embed_scene *s, const struct embed_request *request)
{
    *s = (struct embed_scene){.end = request->end, .single = request->type == EMBED_FLOAT};
    arb_init(s->beta_per_root);
    arb_init(s->h_star_5);
    int status = read_range(s, request);
    if (status == STATUS_OK)
        status = embed_request_check(request);
    if (status)
        return status;
    if (embed_given(request, EMBED_G_STAR))
        beta_of_g_star(s->beta_per_root, request);
    else
        beta_of_materials(s->beta_per_root, request);
    return prepare(s);
}

void embed_scene_clear(struct embed_scene *s)
{
    arb_clear(s->beta_per_root);
    arb_clear(s->h_star_5);
    free(s->samples.speed);
    interpolant_free(s->interpolant);
}
