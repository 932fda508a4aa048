/* SPDX-License-Identifier: MIT */
#include "series/law.h"

#include "support/decimal.h"
#include "support/local.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const struct cor_exponents law_sphere = {3, 1, 2};

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
    " must be a number from 0 to " STRING(LAW_MAX_EXPONENT) ", such as 3/2, 1.5 or 2, with a numerator up to " STRING( \
        LAW_MAX_NUMERATOR) " and a denominator up to " STRING(LAW_MAX_DENOMINATOR)

const char *law_parse(struct cor_exponents *law, const char *elastic, const char *damping)
{
    struct ratio a, b;
    if (!parse_exponent(&a, elastic))
        return "the elastic exponent" EXPONENT_RULE;
    if (!parse_exponent(&b, damping))
        return "the damping exponent" EXPONENT_RULE;
    const slong d = a.den / (slong)n_gcd((ulong)a.den, (ulong)b.den) * b.den;
    *law = (struct cor_exponents){(int)(a.num * (d / a.den)), (int)(b.num * (d / b.den)), (int)d};
    return NULL;
}

struct ratio law_elastic(const struct cor_exponents *law)
{
    return RATIO("law->a", law);
}

struct ratio law_damping(const struct cor_exponents *law)
{
    return RATIO("law->b", law);
}

struct cor_exponents law_even(const struct cor_exponents *law)
{
    const int times = law->denominator == 1 ? 2 : 1;
    return (struct cor_exponents){times * law->elastic, times * law->damping, times * law->denominator};
}

bool law_equal(const struct cor_exponents *law, const struct cor_exponents *other)
{
    return law->denominator == other->denominator && law->elastic == other->elastic && law->damping == other->damping;
}

bool law_is_sphere(const struct cor_exponents *law)
{
    return law_equal(law, &law_sphere);
}

struct ratio law_speed_exponent(const struct cor_exponents *law)
{
    return RATIO("(2*law->b - law->a + 1)/(law->a + 1)", law);
}

struct ratio law_fall_power(const struct cor_exponents *law)
{
    return RATIO("2*law->b - law->a + 1", law);
}

struct ratio law_mu_power(const struct cor_exponents *law)
{
    return RATIO("(law->a + 1)/(law->b + 1)", law);
}

bool law_force_ends(const struct cor_exponents *law)
{
    return law->elastic > law->damping;
}

bool law_is_linear(const struct cor_exponents *law)
{
    return law_fall_power(law).num == 0;
}

bool law_is_hunt_crossley(const struct cor_exponents *law)
{
    return law->elastic == law->damping;
}

bool law_force_has_one_peak(const struct cor_exponents *law)
{
    const slong a = law->elastic, b = law->damping;
    return b == 0 || 4 * a * b + (a + b) * law->denominator + 2 * b * b >= a * a;
}

double law_forgetting(const struct cor_exponents *law)
{
    const struct ratio n = law_fall_power(law);
    const double power = ratio_double(n), b1 = (double)(law->damping + law->denominator) / (double)law->denominator;
    return pow(b1, power / b1) / power;
}

double law_elastic_time(const struct cor_exponents *law)
{
    const double p = (double)law->denominator / (double)(law->elastic + law->denominator);
    return pow(0.5 / p, p) * p * exp(lgamma(p) + lgamma(0.5) - lgamma(p + 0.5));
}

double law_elastic_radius(const struct cor_exponents *law)
{
    const double half_turn = acos(-1.0),
                 c = cos(half_turn * (double)law->denominator / (double)(law->elastic + law->denominator));
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

/* Returns "x^(3/2)", "sqrt(x)", "x" or "1". */
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

struct law_text law_equation(const struct cor_exponents *law)
{
    struct law_text t;
    const struct ratio_text damping = power_of_overlap(law_damping(law)), elastic = power_of_overlap(law_elastic(law));
    snprintf(t.text, sizeof t.text, "x'' + beta %s%sx' + %s = 0", law_damping(law).num == 0 ? "" : damping.text,
             law_damping(law).num == 0 ? "" : " ", elastic.text);
    return t;
}
