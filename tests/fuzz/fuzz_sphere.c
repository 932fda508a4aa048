/* SPDX-License-Identifier: MIT */
/* Every function of one number of cor/sphere.h and of generated/cor_sphere.h on raw bit patterns. The target functions
 * has the arrays. */
#include <float.h>

#include "cor/sphere.h"
#include "cor_sphere.h"
#include "fuzz.h"

struct quantity {
    const char *name;
    double (*of)(double);
    float (*of_float)(float);
    double (*embedded)(double);
    double domain;                /* from 0 up to this */
    double least, most;           /* of the values */
    double at_zero[2], at_end[2]; /* values at 0 and at the domain's end, between these two */
    double ulps_up;               /* may rise with its argument by so many units; -1: it may rise */
    double ulps_down;             /* likewise fall */
};

#define NAMES(quantity) #quantity, cor_sphere_##quantity, cor_sphere_##quantity##f, cor_inline_##quantity

static const struct quantity quantities[] = {
    {NAMES(eps_zero_overlap), INFINITY, 0, 1, {1, 1}, {0, 0}, 2, -1},
    {NAMES(eps_zero_force), INFINITY, 0, 1, {1, 1}, {0, 0}, 2, -1},
    {NAMES(loss_zero_overlap), INFINITY, 0, 1, {0, 0}, {1, 1}, -1, 2},
    {NAMES(loss_zero_force), INFINITY, 0, 1, {0, 0}, {1, 1}, -1, 2},
    {NAMES(beta_zero_overlap), 1, 0, INFINITY, {INFINITY, INFINITY}, {0, 0}, 4, -1},
    {NAMES(beta_zero_force), 1, 0, INFINITY, {INFINITY, INFINITY}, {0, 0}, 4, -1},
    {NAMES(duration_zero_overlap), INFINITY, 0, INFINITY, {3.218, 3.2181}, {INFINITY, INFINITY}, -1, -1},
    {NAMES(duration_zero_force), INFINITY, 0, 3.2181, {3.218, 3.2181}, {0, 0}, -1, -1},
    {NAMES(max_overlap), INFINITY, 0, 1.09337, {1.0933, 1.0934}, {0, 0}, 2, -1},
    {NAMES(time_of_max_overlap), INFINITY, 0, 1.6091, {1.609, 1.6091}, {0, 0}, -1, -1},
};
enum { QUANTITIES = sizeof quantities / sizeof *quantities };

static double ulp(double x)
{
    return nextafter(fabs(x), INFINITY) - fabs(x);
}

static double value_of(const struct quantity *q, double x)
{
    const double y = q->of(x);
    if (!(x >= 0 && x <= q->domain)) {
        REQUIRE(isnan(y), "%s(%a) = %a", q->name, x, y);
    } else {
        REQUIRE(y >= q->least && y <= q->most, "%s(%a) = %a", q->name, x, y);
        if (x == 0)
            REQUIRE(y >= q->at_zero[0] && y <= q->at_zero[1], "%s(%a) = %a", q->name, x, y);
        if (x == q->domain)
            REQUIRE(y >= q->at_end[0] && y <= q->at_end[1], "%s(%a) = %a", q->name, x, y);
    }
    REQUIRE(same(y, q->embedded(x)), "%s(%a) = %a, embedded %a", q->name, x, y, q->embedded(x));
    return y;
}

static void check_order(const struct quantity *q, double x0, double x1)
{
    const double y0 = q->of(x0), y1 = q->of(x1);
    if (!(x0 < x1) || isnan(y0) || isnan(y1) || isinf(y0) || isinf(y1))
        return;
    if (q->ulps_up >= 0)
        REQUIRE(y1 - y0 <= q->ulps_up * ulp(y1), "%s(%a) = %a, %s(%a) = %a", q->name, x0, y0, q->name, x1, y1);
    if (q->ulps_down >= 0)
        REQUIRE(y0 - y1 <= q->ulps_down * ulp(y0), "%s(%a) = %a, %s(%a) = %a", q->name, x0, y0, q->name, x1, y1);
}

/* eps, loss and the inverse of one beta belong together. */
static void check_end(double beta, double (*eps_of)(double), double (*loss_of)(double), double (*beta_of)(double),
                      double (*root_of)(double))
{
    const double eps = eps_of(beta), loss = loss_of(beta);
    if (isnan(eps)) {
        REQUIRE(isnan(root_of(beta)), "eps_root(%a) = %a", beta, root_of(beta));
        return;
    }
    REQUIRE(fabs(1 - eps - loss) <= 4 * 0x1p-53, "beta = %a: eps %a, loss %a", beta, eps, loss);
    /* |d ln eps/d ln beta| is 5 at most */
    const double again = eps_of(beta_of(eps)), bound = (1 + 5 * COR_SPHERE_BETA_MAX_ULP) * 0x1p-52;
    REQUIRE(fabs(again - eps) <= bound * eps + 2 * 0x1p-1074, "beta = %a: eps %a, of its inverse %a", beta, eps, again);
    const double x = beta * beta * beta * beta * beta;
    if (x >= DBL_MIN && x <= DBL_MAX) {
        const double root = root_of(x), miss = fabs(root - eps);
        /* five roundings of x/2, at most 5 ulp of a fifth power's root; one ulp of each value */
        REQUIRE(miss <= (2 + 5.0) * 0x1p-52 * eps + 2 * 0x1p-1074, "beta = %a: eps %a, from its fifth power %a", beta,
                eps, root);
    }
    const double raw = root_of(beta);
    REQUIRE(raw >= 0 && raw <= 1, "eps_root(%a) = %a", beta, raw);
}

static void check_1999(double beta, int depth)
{
    const double simple = cor_sphere_eps_simple(beta), fraction = cor_sphere_eps_simple_fraction(beta, depth),
                 pade = cor_sphere_eps_published_pade(beta);
    if (!(beta >= 0)) {
        REQUIRE(isnan(simple) && isnan(fraction) && isnan(pade), "beta = %a: %a %a %a", beta, simple, fraction, pade);
        return;
    }
    const double slack = 1 + COR_SPHERE_EPS_SIMPLE_MAX_ULP * 0x1p-52;
    REQUIRE(simple >= 0 && simple <= slack, "simple(%a) = %a", beta, simple);
    REQUIRE(pade >= 0 && pade <= slack, "pade(%a) = %a", beta, pade);
    REQUIRE(depth < 0 ? isnan(fraction) : fraction >= 0 && fraction <= slack, "fraction(%a, %d) = %a", beta, depth,
            fraction);
    if (depth == 0)
        REQUIRE(fraction == 1, "fraction(%a, 0) = %a", beta, fraction);
    if (depth >= 0)
        REQUIRE(fraction >= simple * (1 - 2 * COR_SPHERE_EPS_SIMPLE_MAX_ULP * 0x1p-52), "fraction(%a, %d) = %a < %a",
                beta, depth, fraction, simple);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input in = {data, size};
    const double x = take_double(&in), x1 = take_double(&in);
    const float f = take_float(&in);
    for (size_t i = 0; i < QUANTITIES; i++) {
        const struct quantity *q = &quantities[i];
        value_of(q, x);
        check_order(q, x, x1);
        const double once = (double)(float)q->of((double)f);
        REQUIRE(same((double)q->of_float(f), once), "%sf(%a) = %a, double rounded %a", q->name, (double)f,
                (double)q->of_float(f), once);
    }
    check_end(x, cor_sphere_eps_zero_overlap, cor_sphere_loss_zero_overlap, cor_sphere_beta_zero_overlap,
              cor_inline_eps_zero_overlap_root);
    check_end(x, cor_sphere_eps_zero_force, cor_sphere_loss_zero_force, cor_sphere_beta_zero_force,
              cor_inline_eps_zero_force_root);
    check_1999(x, take_int(&in));
    check_1999(x1, take_byte(&in) % 40);
    return 0;
}
