/* SPDX-License-Identifier: MIT */
#include "series/law.h"

#include "support/decimal.h"
#include "support/local.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const struct law law_sphere = {{3, 2}, {1, 2}, 2, 3, 1};

static bool parse_exponent(struct ratio *r, const char *text)
{
    struct decimal x = {0};
    const bool good = decimal_parse(&x, text, 0) && !(x.forms & DECIMAL_SIGN) &&
                      fmpz_cmp_si(fmpq_numref(x.value), LAW_MAX_NUMERATOR) <= 0 &&
                      fmpz_cmp_si(fmpq_denref(x.value), LAW_MAX_DENOMINATOR) <= 0 &&
                      fmpq_cmp_si(x.value, LAW_MAX_EXPONENT) <= 0;
    if (good)
        *r = (struct ratio){fmpz_get_si(fmpq_numref(x.value)), fmpz_get_si(fmpq_denref(x.value))};
    decimal_clear(&x);
    return good;
}

#define STRING_(x) #x
#define STRING(x) STRING_(x)
#define EXPONENT_RULE                                                                                                  \
    " must be a number from 0 to " STRING(LAW_MAX_EXPONENT) " such as 3/2, 1.5 or 2, with numerator at most " STRING(  \
        LAW_MAX_NUMERATOR) " and denominator at most " STRING(LAW_MAX_DENOMINATOR)

const char *law_parse(struct law *law, const char *elastic, const char *damping)
{
    if (!parse_exponent(&law->a, elastic))
        return "the elastic exponent" EXPONENT_RULE;
    if (!parse_exponent(&law->b, damping))
        return "the damping exponent" EXPONENT_RULE;
    law->d = law->a.den / (slong)n_gcd((ulong)law->a.den, (ulong)law->b.den) * law->b.den;
    law->ad = law->a.num * (law->d / law->a.den);
    law->bd = law->b.num * (law->d / law->b.den);
    return NULL;
}

struct law law_even(const struct law *law)
{
    const slong times = law->d == 1 ? 2 : 1;
    return (struct law){law->a, law->b, times * law->d, times * law->ad, times * law->bd};
}

bool law_equal(const struct law *law, const struct law *other)
{
    return law->d == other->d && law->ad == other->ad && law->bd == other->bd;
}

bool law_is_sphere(const struct law *law)
{
    return law_equal(law, &law_sphere);
}

struct ratio law_speed_exponent(const struct law *law)
{
    return RATIO("(2*law->b - law->a + 1)/(law->a + 1)", law->b, law->a);
}

struct ratio law_fall_power(const struct law *law)
{
    return RATIO("2*law->b - law->a + 1", law->b, law->a);
}

struct ratio law_mu_power(const struct law *law)
{
    return RATIO("(law->a + 1)/(law->b + 1)", law->a, law->b);
}

bool law_force_ends(const struct law *law)
{
    return law->ad > law->bd;
}

bool law_is_linear(const struct law *law)
{
    return law_fall_power(law).num == 0;
}

bool law_is_hunt_crossley(const struct law *law)
{
    return law->ad == law->bd;
}

bool law_force_has_one_peak(const struct law *law)
{
    const slong a = law->ad, b = law->bd;
    return b == 0 || 4 * a * b + (a + b) * law->d + 2 * b * b >= a * a;
}

double law_forgetting(const struct law *law)
{
    const struct ratio n = law_fall_power(law);
    const double power = ratio_double(n), b1 = (double)(law->bd + law->d) / (double)law->d;
    return pow(b1, power / b1) / power;
}

double law_elastic_time(const struct law *law)
{
    const double p = (double)law->d / (double)(law->ad + law->d);
    return pow(0.5 / p, p) * p * exp(lgamma(p) + lgamma(0.5) - lgamma(p + 0.5));
}

double law_elastic_radius(const struct law *law)
{
    const double half_turn = acos(-1.0), c = cos(half_turn * (double)law->d / (double)(law->ad + law->d));
    return c > 0.5 ? 1.0 / c : 2.0;
}

double ratio_double(struct ratio x)
{
    return (double)x.num / (double)x.den;
}

void arb_set_upper(arb_t y, const mag_t m)
{
    arf_set_mag(arb_midref(y), m);
    mag_zero(arb_radref(y));
}

void arb_around(arb_t low, arb_t high, const arb_t x, slong exponent, slong prec)
{
    LOCAL(arb, width);
    arb_mul_2exp_si(width, x, exponent);
    arb_sub(low, x, width, prec);
    arb_add(high, x, width, prec);
    arb_get_mid_arb(low, low);
    arb_get_mid_arb(high, high);
}

struct ratio_text ratio_text(struct ratio x)
{
    struct ratio_text t;
    if (x.den == 1)
        snprintf(t.text, sizeof t.text, "%ld", (long)x.num);
    else
        snprintf(t.text, sizeof t.text, "%ld/%ld", (long)x.num, (long)x.den);
    return t;
}

struct ratio_text ratio_power(struct ratio x)
{
    const struct ratio_text bare = ratio_text(x);
    struct ratio_text t;
    snprintf(t.text, sizeof t.text, x.den == 1 && x.num >= 0 ? "%.40s" : "(%.40s)", bare.text);
    return t;
}

/* "x^(3/2)", "sqrt(x)", "x" or "1" */
static struct ratio_text power_of_overlap(struct ratio e)
{
    struct ratio_text t;
    if (e.num == 0)
        snprintf(t.text, sizeof t.text, "1");
    else if (e.num == 1 && e.den <= 2)
        snprintf(t.text, sizeof t.text, e.den == 1 ? "x" : "sqrt(x)");
    else
        snprintf(t.text, sizeof t.text, "x^%.40s", ratio_power(e).text);
    return t;
}

struct law_text law_equation(const struct law *law)
{
    struct law_text t;
    const struct ratio_text damping = power_of_overlap(law->b), elastic = power_of_overlap(law->a);
    snprintf(t.text, sizeof t.text, "x'' + beta %s%sx' + %s = 0", law->b.num == 0 ? "" : damping.text,
             law->b.num == 0 ? "" : " ", elastic.text);
    return t;
}
