/* SPDX-License-Identifier: MIT */
/* Spheres: the functions of sphere.h and contact.h where beta or eps is at an end, at a border or beyond. */
#include "stability.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cor/contact.h>
#include <cor/sphere.h>
#include <cor/status.h>

#include "enclosure/collision.h"
#include "pumped.h"
#include "reference.h"
#include "series/series.h"
#include "series/turning_point.h"

enum { BITS = 160, ORDER = 28, LEFT_OUT = 80 };

static const struct {
    const char *name;
    double (*value)(double);
    float (*valuef)(float);
    void (*array)(const double *, double *, size_t);
    double bound;
} function[QUANTITIES] = {
#define FUNCTION(quantity, bound)                                                                                      \
    {                                                                                                                  \
#quantity, cor_sphere_##quantity, cor_sphere_##quantity##f, cor_sphere_##quantity##_array, bound               \
    }
    FUNCTION(eps_zero_overlap, COR_SPHERE_EPS_MAX_ULP),       FUNCTION(eps_zero_force, COR_SPHERE_EPS_MAX_ULP),
    FUNCTION(loss_zero_overlap, COR_SPHERE_LOSS_MAX_ULP),     FUNCTION(loss_zero_force, COR_SPHERE_LOSS_MAX_ULP),
    FUNCTION(duration_zero_overlap, COR_SPHERE_TIME_MAX_ULP), FUNCTION(duration_zero_force, COR_SPHERE_TIME_MAX_ULP),
    FUNCTION(max_overlap, COR_SPHERE_MAX_OVERLAP_MAX_ULP),    FUNCTION(time_of_max_overlap, COR_SPHERE_TIME_MAX_ULP),
};

/* ---- references ---- */

/* 1 - eps in sqrt(beta), both ends */
static arb_poly_t loss_series[2];
static bool have_series;

static void need_series(void)
{
    if (have_series)
        return;
    struct series s;
    slong root;
    arb_t c;
    arb_init(c);
    series_init(&s);
    arb_poly_init(loss_series[0]);
    arb_poly_init(loss_series[1]);
    if (series_compute(&s, ORDER, &law_sphere, BITS) != 0 ||
        series_eps(loss_series[1], &root, END_ZERO_FORCE, 2 * ORDER, &law_sphere, BITS) != 0)
        abort();
    for (slong k = 1; k <= ORDER; k++) {
        arb_poly_get_coeff_arb(c, s.c, k);
        arb_neg(c, c);
        arb_poly_set_coeff_arb(loss_series[0], 2 * k, c);
    }
    arb_poly_neg(loss_series[1], loss_series[1]);
    arb_poly_set_coeff_si(loss_series[1], 0, 0);
    series_clear(&s);
    arb_clear(c);
    have_series = true;
}

/* 1 - eps and beta d eps/d beta (negative), beta <= 1/8 */
static void loss_small(arb_t loss, arb_t slope, double beta, int end)
{
    arb_t root, rest;
    arb_init(root);
    arb_init(rest);
    need_series();
    arb_set_d(root, beta);
    arb_sqrt(root, root, BITS);
    arb_poly_evaluate2(loss, rest, loss_series[end], root, BITS);
    arb_mul(slope, rest, root, BITS);
    arb_mul_2exp_si(slope, slope, -1);
    arb_neg(slope, slope);
    arb_set_d(rest, beta); /* what is left out: about beta (beta/1.3)^ORDER */
    arb_mul_2exp_si(rest, rest, -LEFT_OUT);
    arb_add_error(loss, rest);
    arb_clear(root);
    arb_clear(rest);
}

/* Every quantity of an enclosed collision, at a beta between 2^-20 and 1e6 */
static void collision_values(arb_ptr value, double beta, bool unloading)
{
    struct collision c;
    arb_t x;
    collision_init(&c);
    arb_init(x);
    arb_set_d(x, beta);
    if ((unloading ? collision_solve : collision_solve_force)(&c, x, &law_sphere, 110) != 0)
        abort();
    _arb_vec_indeterminate(value, QUANTITIES);
    if (unloading) {
        arb_set(value + EPS_ZERO_OVERLAP, c.eps_zero_overlap);
        arb_set(value + DURATION_ZERO_OVERLAP, c.t_zero_overlap);
        arb_sub_si(value + LOSS_ZERO_OVERLAP, c.eps_zero_overlap, 1, BITS);
        arb_neg(value + LOSS_ZERO_OVERLAP, value + LOSS_ZERO_OVERLAP);
    }
    arb_set(value + EPS_ZERO_FORCE, c.eps_zero_force);
    arb_set(value + DURATION_ZERO_FORCE, c.t_zero_force);
    arb_sub_si(value + LOSS_ZERO_FORCE, c.eps_zero_force, 1, BITS);
    arb_neg(value + LOSS_ZERO_FORCE, value + LOSS_ZERO_FORCE);
    arb_set(value + MAX_OVERLAP, c.x_max);
    arb_set(value + TIME_OF_MAX_OVERLAP, c.t_max);
    collision_clear(&c);
    arb_clear(x);
}

static const arb_struct *h_star(void)
{
    static arb_t h;
    static bool have;
    if (!have) {
        arb_init(h);
        collision_h_star(h, BITS);
        have = true;
    }
    return h;
}

/* h*^5/beta^5, exact to exp(-2.29 beta^(5/3)), and the leading powers at zero force, exact to beta^(-5/3) ln(beta) */
static void power_law(arb_ptr value, double beta)
{
    arb_t x, e;
    arb_init(x);
    arb_init(e);
    _arb_vec_indeterminate(value, QUANTITIES);
    arb_set_d(e, beta);
    arb_div(x, h_star(), e, BITS);
    arb_pow_ui(value + EPS_ZERO_OVERLAP, x, 5, BITS);
    arb_root_ui(x, e, 3, BITS);
    arb_inv(x, x, BITS);
    arb_set_d(e, 1.5);
    arb_root_ui(e, e, 3, BITS);
    arb_mul(e, e, x, BITS);
    arb_sqr(e, e, BITS); /* (3/2 / beta)^(2/3) */
    arb_set(value + MAX_OVERLAP, e);
    arb_set_d(x, beta);
    arb_div(value + EPS_ZERO_FORCE, e, x, BITS);
    arb_one(value + LOSS_ZERO_OVERLAP);
    arb_sub(value + LOSS_ZERO_OVERLAP, value + LOSS_ZERO_OVERLAP, value + EPS_ZERO_OVERLAP, BITS);
    arb_one(value + LOSS_ZERO_FORCE);
    arb_sub(value + LOSS_ZERO_FORCE, value + LOSS_ZERO_FORCE, value + EPS_ZERO_FORCE, BITS);
    arb_clear(x);
    arb_clear(e);
}

static void take_quantities(struct outcome *out, double beta, arb_srcptr value)
{
    for (int q = 0; q < QUANTITIES; q++)
        if (arb_is_finite(value + q)) {
            const double y = function[q].value(beta);
            take_number(out, ball_ulp(y, value + q) / function[q].bound, function[q].name, beta, value + q, y);
        }
}

/* ---- beta ---- */

static void small_beta(struct outcome *out, bool full)
{
    arb_t loss, slope;
    arb_init(loss);
    arb_init(slope);
    for (int i = 0; i < (full ? 200000 : 1500); i++) {
        const double beta = i < 400 ? ldexp(drawn(1, 2), -3 - i / 10) : 0.12 * exp(-drawn(0, 740));
        for (int end = 0; end < 2 && beta < 0.125; end++) {
            const int q = end ? LOSS_ZERO_FORCE : LOSS_ZERO_OVERLAP;
            const double y = function[q].value(beta);
            loss_small(loss, slope, beta, end);
            take_number(out, ball_ulp(y, loss), function[q].name, beta, loss, y);
        }
    }
    arb_clear(loss);
    arb_clear(slope);
}

static void zero_beta(struct outcome *out, bool full)
{
    (void)full;
    static const double zeros[] = {0.0, -0.0};
    arb_ptr exact = _arb_vec_init(QUANTITIES);
    turning_point_elastic(exact + MAX_OVERLAP, exact + TIME_OF_MAX_OVERLAP, &law_sphere, BITS);
    arb_mul_2exp_si(exact + DURATION_ZERO_OVERLAP, exact + TIME_OF_MAX_OVERLAP, 1);
    arb_set(exact + DURATION_ZERO_FORCE, exact + DURATION_ZERO_OVERLAP);
    arb_one(exact + EPS_ZERO_OVERLAP);
    arb_one(exact + EPS_ZERO_FORCE);
    for (int i = 0; i < 2; i++)
        for (int q = 0; q < QUANTITIES; q++) {
            double y;
            function[q].array(&zeros[i], &y, 1);
            /* 1 and 0 exactly, the others nearest */
            const double factor = q <= LOSS_ZERO_FORCE ? 2 : 1;
            take_number(out, factor * ball_ulp(y, exact + q), function[q].name, zeros[i], exact + q, y);
            y = function[q].value(zeros[i]);
            take_number(out, factor * ball_ulp(y, exact + q), function[q].name, zeros[i], exact + q, y);
            const bool rounded = function[q].valuef((float)zeros[i]) == (float)y;
            take_number(out, rounded ? 0 : HUGE_VAL, function[q].name, zeros[i], exact + q, y);
        }
    _arb_vec_clear(exact, QUANTITIES);
}

static void tiny_beta(struct outcome *out, bool full)
{
    arb_ptr value = _arb_vec_init(QUANTITIES);
    arb_t slope, c;
    arb_init(slope);
    arb_init(c);
    for (int i = 0; i < (full ? 1021 : 256); i++) { /* 2^-1074 and on to 2^-54, one ulp to each side */
        const double base = ldexp(1, full ? i - 1074 : 4 * i - 1074);
        for (int j = -1; j <= 1; j++) {
            const double beta = moved(base, j);
            if (!(beta > 0))
                continue;
            turning_point_elastic(value + MAX_OVERLAP, value + TIME_OF_MAX_OVERLAP, &law_sphere, BITS);
            arb_mul_2exp_si(value + DURATION_ZERO_OVERLAP, value + TIME_OF_MAX_OVERLAP, 1);
            arb_set(value + DURATION_ZERO_FORCE, value + DURATION_ZERO_OVERLAP);
            arb_set_d(c, beta); /* y_1, tau_1 are below 1, and so is the change of the duration */
            for (int q = DURATION_ZERO_OVERLAP; q < QUANTITIES; q++)
                arb_add_error(value + q, c);
            for (int end = 0; end < 2; end++) {
                loss_small(value + (end ? LOSS_ZERO_FORCE : LOSS_ZERO_OVERLAP), slope, beta, end);
                arb_one(value + (end ? EPS_ZERO_FORCE : EPS_ZERO_OVERLAP));
                arb_sub(value + (end ? EPS_ZERO_FORCE : EPS_ZERO_OVERLAP),
                        value + (end ? EPS_ZERO_FORCE : EPS_ZERO_OVERLAP),
                        value + (end ? LOSS_ZERO_FORCE : LOSS_ZERO_OVERLAP), 1300);
            }
            take_quantities(out, beta, value);
        }
    }
    _arb_vec_clear(value, QUANTITIES);
    arb_clear(slope);
    arb_clear(c);
}

static void huge_beta(struct outcome *out, bool full)
{
    arb_ptr value = _arb_vec_init(QUANTITIES);
    static const double first[] = {7, 7.03125, 8, 16, 256};
    for (size_t i = 0; i < sizeof first / sizeof *first; i++) {
        collision_values(value, first[i], full);
        take_quantities(out, first[i], value);
    }
    for (int i = 48; i < 1024; i += full ? 1 : 16)
        for (int j = -1; j <= 1; j++) {
            const double beta = moved(ldexp(1, i), j);
            power_law(value, beta);
            take_quantities(out, beta, value);
        }
    static const double last[] = {1.39e62, 1.01e65, 7.6e304, DBL_MAX};
    for (size_t i = 0; i < sizeof last / sizeof *last; i++)
        for (int j = -2; j <= 0; j++) {
            power_law(value, moved(last[i], j));
            take_quantities(out, moved(last[i], j), value);
        }
    _arb_vec_clear(value, QUANTITIES);
}

/* eps at a speed: five, or 5/3, times the rounding of beta is unavoidable, and none of the rounding of the speed */
static void huge_beta_speed(struct outcome *out, bool full)
{
    struct cor_sphere_contact contact;
    arb_t beta, eps;
    arb_init(beta);
    arb_init(eps);
    out->condition = 5;
    for (int i = 0; i < (full ? 200000 : 1000); i++) {
        if (cor_sphere_contact_init_g_star(&contact, exp(drawn(-60, -20))) != COR_OK)
            abort();
        const double speed = exp(drawn(-5, 40));
        arb_set_d(beta, speed);
        arb_root_ui(beta, beta, 5, BITS);
        arb_set_d(eps, contact.beta_per_root);
        arb_mul(beta, beta, eps, BITS);
        if (upper(beta) < 8)
            continue;
        arb_div(eps, h_star(), beta, BITS);
        arb_pow_ui(eps, eps, 5, BITS);
        const double y = cor_contact_eps_zero_overlap(&contact, speed);
        arb_set_d(beta, y);
        if (y >= DBL_MIN)
            take_number(out, ball_relative(beta, eps) / COR_CONTACT_EPS_MAX_ERROR(5), "speed", speed, eps, y);
    }
    arb_clear(beta);
    arb_clear(eps);
}

/* ---- special values: the number of wrong answers ---- */

static void take_special(struct outcome *out, const char *name, double x, double y, double expected)
{
    char input[160], exact[40], value[40];
    const bool right = isnan(expected) ? isnan(y) : y == expected && signbit(y) == signbit(expected);
    snprintf(input, sizeof input, "%s(%g)", name, x);
    snprintf(exact, sizeof exact, "%g", expected);
    snprintf(value, sizeof value, "%g", y);
    outcome_take(out, right ? 0 : 1, input, exact, value);
}

/* As double, float and in the middle of an array */
static void special_everywhere(struct outcome *out, double beta, const double *expected)
{
    enum { LENGTH = 37 };
    for (int q = 0; q < QUANTITIES; q++) {
        double x[LENGTH], y[LENGTH];
        take_special(out, function[q].name, beta, function[q].value(beta), expected[q]);
        take_special(out, function[q].name, beta, (double)function[q].valuef((float)beta), expected[q]);
        for (int at = 0; at < LENGTH; at++) {
            for (int i = 0; i < LENGTH; i++)
                x[i] = 0.25 * i;
            x[at] = beta;
            function[q].array(x, y, LENGTH);
            take_special(out, function[q].name, beta, y[at], expected[q]);
            const int other = at == 0 ? 1 : at - 1;
            take_special(out, function[q].name, x[other], y[other], function[q].value(x[other]));
        }
    }
    struct cor_sphere_contact contact;
    cor_sphere_contact_init_g_star(&contact, 1);
    take_special(out, "contact_eps_zero_overlap", beta, cor_contact_eps_zero_overlap(&contact, beta), expected[0]);
    take_special(out, "contact_eps_zero_force", beta, cor_contact_eps_zero_force(&contact, beta), expected[1]);
}

static void infinite_beta(struct outcome *out, bool full)
{
    (void)full;
    static const double limit[QUANTITIES] = {0, 0, 1, 1, HUGE_VAL, 0, 0, 0};
    special_everywhere(out, HUGE_VAL, limit);
    take_special(out, "beta_zero_overlap", 0, cor_sphere_beta_zero_overlap(0), HUGE_VAL);
    take_special(out, "beta_zero_force", -0.0, cor_sphere_beta_zero_force(-0.0), HUGE_VAL);
}

static const double nothing[QUANTITIES] = {NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};

static void nan_beta(struct outcome *out, bool full)
{
    (void)full;
    special_everywhere(out, NAN, nothing);
    special_everywhere(out, -NAN, nothing);
    take_special(out, "beta_zero_overlap", NAN, cor_sphere_beta_zero_overlap(NAN), NAN);
    take_special(out, "beta_zero_force", NAN, cor_sphere_beta_zero_force(NAN), NAN);
}

static void negative_beta(struct outcome *out, bool full)
{
    (void)full;
    /* each is a float, too */
    static const double negative[] = {-0x1p-149, -0x1p-126, -1e-3f, -1, -1.388361925615829410, -7, -0x1p127, -HUGE_VAL};
    for (size_t i = 0; i < sizeof negative / sizeof *negative; i++)
        special_everywhere(out, negative[i], nothing);
    static const double further[] = {-0x1p-1074, -DBL_MIN, -DBL_MAX};
    for (size_t i = 0; i < sizeof further / sizeof *further; i++)
        for (int q = 0; q < QUANTITIES; q++)
            take_special(out, function[q].name, further[i], function[q].value(further[i]), NAN);
    static const double outside[] = {-0x1p-1074, -1, 1 + DBL_EPSILON, 2, HUGE_VAL, -HUGE_VAL};
    for (size_t i = 0; i < sizeof outside / sizeof *outside; i++) {
        take_special(out, "beta_zero_overlap", outside[i], cor_sphere_beta_zero_overlap(outside[i]), NAN);
        take_special(out, "beta_zero_force", outside[i], cor_sphere_beta_zero_force(outside[i]), NAN);
    }
}

/* ---- borders ---- */

/* tests/accuracy has every edge and node, and 256 doubles to each side, by another reference. */
static void borders(struct outcome *out, bool full)
{
    arb_ptr value = _arb_vec_init(QUANTITIES);
    /* edges of the first cells, of the last ones, and between */
    static const double edge[] = {1.0 / 32, 3.0 / 32, 17.0 / 32, 33.0 / 32, 65.0 / 32, 127.0 / 32, 223.0 / 32};
    for (size_t i = 0; i < 2 * sizeof edge / sizeof *edge; i++)
        for (int j = -1; j <= 1; j++) {
            const double beta = moved(i % 2 == 0 ? edge[i / 2] : edge[i / 2] * edge[i / 2], j);
            collision_values(value, beta, full || beta < 2);
            take_quantities(out, beta, value);
        }
    _arb_vec_clear(value, QUANTITIES);
}

/* ---- the inverse ---- */

/* Error of beta in ulp, from eps at the beta that was found: (eps(beta) - eps)/(beta eps') beta/ulp(beta) */
static void take_inverse(struct outcome *out, int end, double eps, double beta, const arb_t off, const arb_t slope)
{
    arb_t error, exact;
    arb_init(error);
    arb_init(exact);
    arb_div(error, off, slope, BITS); /* ln(beta found/beta), to first order */
    arb_set_d(exact, beta);
    arb_mul(error, error, exact, BITS);
    arb_sub(exact, exact, error, BITS);
    take_number(out, ball_ulp(beta, exact), end ? "force, eps" : "overlap, eps", eps, exact, beta);
    arb_clear(error);
    arb_clear(exact);
}

static void inverse_near_one(struct outcome *out, bool full)
{
    arb_t loss, slope, off;
    arb_init(loss);
    arb_init(slope);
    arb_init(off);
    for (int i = 0; i < (full ? 200000 : 1500); i++) {
        const double eps = i < 200 ? 1 - (i + 1) * 0x1p-53 : 1 - exp(-drawn(2.5, 37));
        for (int end = 0; end < 2 && eps < 1; end++) {
            const double beta = end ? cor_sphere_beta_zero_force(eps) : cor_sphere_beta_zero_overlap(eps);
            if (!(beta > 0 && beta < 0.125)) {
                take_number(out, HUGE_VAL, "eps", eps, loss, beta);
                continue;
            }
            loss_small(loss, slope, beta, end);
            arb_set_d(off, eps);
            arb_sub_si(off, off, 1, BITS);
            arb_add(off, off, loss, BITS);
            arb_neg(off, off);
            take_inverse(out, end, eps, beta, off, slope);
        }
    }
    arb_clear(loss);
    arb_clear(slope);
    arb_clear(off);
}

/* There and back: half an ulp of eps near 1 is much of beta, and no more than the condition number says */
static void there_and_back(struct outcome *out, bool full)
{
    arb_t loss, slope;
    arb_init(loss);
    arb_init(slope);
    for (int i = 0; i < (full ? 200000 : 1500); i++)
        for (int end = 0; end < 2; end++) {
            const double beta = 0.12 * exp(-drawn(0, 33));
            const double eps = function[end].value(beta);
            const double back = end ? cor_sphere_beta_zero_force(eps) : cor_sphere_beta_zero_overlap(eps);
            loss_small(loss, slope, beta, end);
            const double condition = eps / upper(slope); /* d ln beta/d ln eps */
            const double allowed =
                condition * COR_SPHERE_EPS_MAX_ULP * 0x1p-53 / eps + COR_SPHERE_BETA_MAX_ULP * 0x1p-52;
            arb_set_d(loss, beta);
            const double error = fabs(back / beta - 1) / allowed;
            if (out->points == 0 || error > out->error)
                out->condition = fmax(out->condition, condition);
            take_number(out, error, end ? "force, beta" : "overlap, beta", beta, loss, back);
        }
    arb_clear(loss);
    arb_clear(slope);
}

static void inverse_near_zero(struct outcome *out, bool full)
{
    arb_ptr value = _arb_vec_init(QUANTITIES);
    arb_t off, slope, eps_ball;
    arb_init(off);
    arb_init(slope);
    arb_init(eps_ball);
    for (int i = 0; i < (full ? 20000 : 600); i++) {
        const double eps = i < 40    ? moved(0, 1 + i)
                           : i == 40 ? DBL_MIN
                           : i == 41 ? moved(DBL_MIN, -1)
                                     : exp(-drawn(13, 744));
        for (int end = 0; end < 2; end++) {
            const double beta = end ? cor_sphere_beta_zero_force(eps) : cor_sphere_beta_zero_overlap(eps);
            if (end && beta < 0x1p48)
                continue;
            power_law(value, beta);
            arb_set_d(eps_ball, eps);
            arb_sub(off, value + (end ? EPS_ZERO_FORCE : EPS_ZERO_OVERLAP), eps_ball, BITS);
            arb_mul_si(slope, eps_ball, -5, BITS);
            if (end)
                arb_div_ui(slope, slope, 3, BITS);
            take_inverse(out, end, eps, beta, off, slope);
        }
    }
    for (int i = 0; i < (full ? 200 : 5); i++) { /* between, by collisions */
        const double eps = exp(-drawn(1, 20));
        const double beta = cor_sphere_beta_zero_force(eps);
        arb_t near;
        arb_init(near);
        collision_values(value, beta * (1 + 0x1p-30), false);
        arb_set(near, value + EPS_ZERO_FORCE);
        collision_values(value, beta, false);
        arb_sub(slope, near, value + EPS_ZERO_FORCE, BITS);
        arb_set_d(off, beta);
        arb_set_d(near, beta * (1 + 0x1p-30));
        arb_sub(near, near, off, BITS);
        arb_div(near, near, off, BITS);
        arb_div(slope, slope, near, BITS);
        arb_set_d(off, eps);
        arb_sub(off, value + EPS_ZERO_FORCE, off, BITS);
        take_inverse(out, 1, eps, beta, off, slope);
        arb_clear(near);
    }
    _arb_vec_clear(value, QUANTITIES);
    arb_clear(off);
    arb_clear(slope);
    arb_clear(eps_ball);
}

/* ---- the involution ---- */

static void involution(struct outcome *out, bool full)
{
    arb_t eps, h;
    arb_init(eps);
    arb_init(h);
    static const double beta[] = {1, 3, 0.125, 0.5, 1.5, 2, 2.5, 3.5, 4, 5, 6, 7, 8, 10};
    for (size_t i = 0; i < (full ? sizeof beta / sizeof *beta : 2); i++) {
        if (pumped_eps(eps, h, beta[i]) != 0)
            outcome_take(out, HUGE_VAL, "no bracket", "", "");
        const double y = cor_sphere_eps_zero_overlap(beta[i]);
        take_number(out, ball_ulp(y, eps), "beta", beta[i], eps, y);
    }
    arb_clear(eps);
    arb_clear(h);
}

static const struct hard_case sphere_cases[] = {
    {"beta -> 0", "1 - eps cancels and keeps no digit",
     "loss at both ends, 1500 beta from 0.125 to 2^-1070 (full: 200000)", "corgen's series in interval arithmetic",
     "ulp", COR_SPHERE_LOSS_MAX_ULP, small_beta},
    {"beta = 0", "logarithms and divisions by beta; -0; eps not exactly 1", "+0 and -0, double, float and array",
     "1, 0 and the closed forms (51) in interval arithmetic", "ulp, exact ones doubled", 1, zero_beta},
    {"beta tiny", "underflow within; the result is subnormal",
     "every fourth power of 2 to 2^-54, one ulp to each side (full: every)", "series and (51) in interval arithmetic",
     "of the public bounds", 1, tiny_beta},
    {"beta huge", "overflow within; a tail that is not a power law; subnormal eps",
     "7 to the largest double, powers of 2 from 2^48 on and where results leave the doubles",
     "enclosed collisions to 256, then h*^5/beta^5 and (3/2)^(2/3) beta^(-5/3) in interval arithmetic",
     "of the public bounds", 1, huge_beta},
    {"beta huge", "the rounding of beta is multiplied by 5", "eps at a speed, beta > 8, 1000 contacts (full: 200000)",
     "(h*/beta)^5 with beta in interval arithmetic", "of COR_CONTACT_EPS_MAX_ERROR", 1, huge_beta_speed},
    {"beta infinite", "inf - inf, inf/inf", "+inf at every place of an array; eps = 0 in the inverse", "the limits",
     "wrong answers", 0, infinite_beta},
    {"beta NaN", "a comparison sends NaN to a table; it spreads to its neighbours in a vector",
     "both signs, at every place of an array", "NaN", "wrong answers", 0, nan_beta},
    {"beta negative", "a number outside the domain: collisions with negative damping end at -h*",
     "the smallest to -inf, -h* too; eps outside [0, 1]", "NaN", "wrong answers", 0, negative_beta},
    {"beta at a border of pieces", "the wrong row, or a jump",
     "edges of cells in beta and sqrt(beta), one ulp to each side; every edge and node: `tests/accuracy`",
     "enclosed collisions", "of the public bounds", 1, borders},
    {"eps near 0 in the inverse", "beta overflows or eps is subnormal",
     "every size of eps down to the smallest subnormal", "the closed tails in interval arithmetic; enclosed collisions",
     "ulp", COR_SPHERE_BETA_MAX_ULP, inverse_near_zero},
    {"eps near 1 in the inverse", "beta loses the digits that 1 - eps has lost",
     "the last 200 doubles below 1 and 1300 to 0.92, both ends (full: 200000)",
     "series and its derivative in interval arithmetic", "ulp", COR_SPHERE_BETA_MAX_ULP, inverse_near_one},
    {"eps near 1 in the inverse", "a rounded eps determines beta badly", "beta to eps and back, 0.12 to 5e-16", "beta",
     "of condition times the bound of eps", 1, there_and_back},
    {"beta = -h*", "psi(h) = h Y(-h)^(1/4) is logarithmically singular at h*: Newton's method leaves the domain",
     "beta = 1 and 3 (full: 1/8 to 10, where h* - h is 1e-46)",
     "a pumped collision of damping -h, h by a bracketed root in ln(h* - h)", "ulp of eps", COR_SPHERE_EPS_MAX_ULP,
     involution},
};

const struct case_list stability_sphere = {sphere_cases, sizeof sphere_cases / sizeof *sphere_cases};
