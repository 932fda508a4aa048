/* SPDX-License-Identifier: MIT */
#include "series/law.h"

#include "support/local.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const struct law law_sphere = {{3, 2}, {1, 2}, 2, 3, 1};

static slong gcd(slong x, slong y)
{
    while (y != 0) {
        slong r = x % y;
        x = y;
        y = r;
    }
    return x < 0 ? -x : x;
}

struct ratio ratio_make(slong num, slong den)
{
    slong g = gcd(num, den);
    struct ratio r = {num / g, den / g};
    if (r.den < 0) {
        r.num = -r.num;
        r.den = -r.den;
    }
    return r;
}

struct ratio ratio_add(struct ratio x, struct ratio y)
{
    return ratio_make(x.num * y.den + y.num * x.den, x.den * y.den);
}

struct ratio ratio_sub(struct ratio x, struct ratio y)
{
    return ratio_make(x.num * y.den - y.num * x.den, x.den * y.den);
}

struct ratio ratio_mul(struct ratio x, struct ratio y)
{
    return ratio_make(x.num * y.num, x.den * y.den);
}

struct ratio ratio_div(struct ratio x, struct ratio y)
{
    return ratio_make(x.num * y.den, x.den * y.num);
}

/* Reads digits without a sign into a value of at most max. Returns the end of the number, or NULL. */
static const char *parse_whole(const char *text, slong max, slong *value)
{
    slong v = 0;
    const char *p = text;
    for (; *p >= '0' && *p <= '9'; p++) {
        v = 10 * v + (*p - '0');
        if (v > max)
            return NULL;
    }
    *value = v;
    return p == text ? NULL : p;
}

static bool parse_ratio(struct ratio *r, const char *text)
{
    /* before it is reduced, a decimal such as 1.0625 has a numerator beyond the bound */
    const slong largest = 100000000;
    slong num, den = 1;
    const char *p = parse_whole(text, largest, &num);
    if (p == NULL)
        return false;
    if (*p == '/') {
        p = parse_whole(p + 1, largest, &den);
        if (p == NULL || den == 0)
            return false;
    } else if (*p == '.') {
        for (p++; *p >= '0' && *p <= '9'; p++) {
            if (num > largest || den > largest)
                return false;
            num = 10 * num + (*p - '0');
            den *= 10;
        }
    }
    if (*p != '\0')
        return false;
    *r = ratio_make(num, den);
    return r->num <= LAW_MAX_EXPONENT * r->den && r->num <= LAW_MAX_NUMERATOR && r->den <= LAW_MAX_DENOMINATOR;
}

#define STRING_(x) #x
#define STRING(x) STRING_(x)
#define EXPONENT_RULE                                                                                                  \
    " must be a number from 0 to " STRING(LAW_MAX_EXPONENT) " such as 3/2, 1.5 or 2, with numerator at most " STRING(  \
        LAW_MAX_NUMERATOR) " and denominator at most " STRING(LAW_MAX_DENOMINATOR)

const char *law_parse(struct law *law, const char *elastic, const char *damping)
{
    if (!parse_ratio(&law->a, elastic))
        return "the elastic exponent" EXPONENT_RULE;
    if (!parse_ratio(&law->b, damping))
        return "the damping exponent" EXPONENT_RULE;
    law->d = law->a.den / gcd(law->a.den, law->b.den) * law->b.den;
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
    return ratio_div(law_fall_power(law), ratio_add(law->a, (struct ratio){1, 1}));
}

struct ratio law_fall_power(const struct law *law)
{
    return ratio_add(ratio_sub(ratio_mul((struct ratio){2, 1}, law->b), law->a), (struct ratio){1, 1});
}

struct ratio law_mu_power(const struct law *law)
{
    return ratio_make(law->ad + law->d, law->bd + law->d);
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

void arb_set_ratio(arb_t y, struct ratio x, slong prec)
{
    arb_set_si(y, x.num);
    arb_div_si(y, y, x.den, prec);
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

void arb_pow_ratio(arb_t y, const arb_t x, struct ratio e, slong prec)
{
    LOCAL(fmpq, q);
    fmpq_set_ratio(q, e);
    arb_pow_fmpq(y, x, q, prec);
}

void fmpq_set_ratio(fmpq_t y, struct ratio x)
{
    fmpq_set_si(y, x.num, (ulong)x.den);
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
