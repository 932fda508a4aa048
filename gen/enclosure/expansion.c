/* SPDX-License-Identifier: MIT */
#include "enclosure/expansion.h"

static slong term_index(slong i, slong j)
{
    return (i + j) * (i + j + 1) / 2 + j;
}

void expansion_init(struct expansion *x, const struct expansion_domain *domain)
{
    x->domain = domain;
    for (slong k = 0; k < EXPANSION_TERMS; k++)
        arb_poly_init(&x->c[k]);
    mag_init(x->rest);
}

void expansion_clear(struct expansion *x)
{
    for (slong k = 0; k < EXPANSION_TERMS; k++)
        arb_poly_clear(&x->c[k]);
    mag_clear(x->rest);
}

void expansion_zero(struct expansion *x)
{
    for (slong k = 0; k < EXPANSION_TERMS; k++)
        arb_poly_zero(&x->c[k]);
    mag_zero(x->rest);
}

void expansion_set(struct expansion *y, const struct expansion *x)
{
    for (slong k = 0; k < EXPANSION_TERMS; k++)
        arb_poly_set(&y->c[k], &x->c[k]);
    mag_set(y->rest, x->rest);
}

arb_poly_struct *expansion_term(struct expansion *x, slong i, slong j)
{
    return &x->c[term_index(i, j)];
}

const arb_poly_struct *expansion_term_of(const struct expansion *x, slong i, slong j)
{
    return &x->c[term_index(i, j)];
}

void expansion_add_number(struct expansion *x, slong i, slong j, const arb_t c)
{
    LOCAL(arb, sum);
    arb_poly_get_coeff_arb(sum, expansion_term(x, i, j), 0);
    arb_add(sum, sum, c, EXPANSION_BITS);
    arb_poly_set_coeff_arb(expansion_term(x, i, j), 0, sum);
}

void expansion_add_rest(struct expansion *x, const mag_t bound)
{
    mag_add(x->rest, x->rest, bound);
}

/* ---- bounds ---- */

/* Bound of the terms of p from z^first on */
static void polynomial_norm(mag_t bound, const arb_poly_t p, slong first)
{
    LOCAL(mag, c);
    mag_zero(bound);
    for (slong k = first; k < arb_poly_length(p); k++) {
        arb_get_mag(c, arb_poly_get_coeff_ptr(p, k));
        mag_add(bound, bound, c);
    }
}

/* Bound of a^i b^j */
static void weight(mag_t bound, const struct expansion_domain *domain, slong i, slong j)
{
    LOCAL(mag, power);
    mag_pow_ui(bound, domain->a, (ulong)i);
    mag_pow_ui(power, domain->b, (ulong)j);
    mag_mul(bound, bound, power);
}

void expansion_norm_of_degree(mag_t bound, const struct expansion *x, slong degree)
{
    LOCAL(mag, factor, term);
    mag_zero(bound);
    for (slong j = 0; j <= degree; j++) {
        weight(factor, x->domain, degree - j, j);
        polynomial_norm(term, expansion_term_of(x, degree - j, j), 0);
        mag_addmul(bound, factor, term);
    }
}

void expansion_norm(mag_t bound, const struct expansion *x)
{
    LOCAL(mag, term);
    mag_set(bound, x->rest);
    for (slong degree = 0; degree <= EXPANSION_ORDER; degree++) {
        expansion_norm_of_degree(term, x, degree);
        mag_add(bound, bound, term);
    }
}

/* ---- arithmetic ---- */

void expansion_add(struct expansion *z, const struct expansion *x, const struct expansion *y)
{
    for (slong k = 0; k < EXPANSION_TERMS; k++)
        arb_poly_add(&z->c[k], &x->c[k], &y->c[k], EXPANSION_BITS);
    mag_add(z->rest, x->rest, y->rest);
}

void expansion_sub(struct expansion *z, const struct expansion *x, const struct expansion *y)
{
    for (slong k = 0; k < EXPANSION_TERMS; k++)
        arb_poly_sub(&z->c[k], &x->c[k], &y->c[k], EXPANSION_BITS);
    mag_add(z->rest, x->rest, y->rest);
}

void expansion_scale(struct expansion *y, const struct expansion *x, const arb_t c)
{
    LOCAL(mag, factor);
    arb_get_mag(factor, c);
    for (slong k = 0; k < EXPANSION_TERMS; k++)
        arb_poly_scalar_mul(&y->c[k], &x->c[k], c, EXPANSION_BITS);
    mag_mul(y->rest, x->rest, factor);
}

/* Adds x y to z, where x is c_ij and y is c_kl of two models. Powers of z beyond the length join the rest. */
static void add_product(struct expansion *z, const arb_poly_t x, slong i, slong j, const arb_poly_t y, slong k, slong l)
{
    if (!arb_poly_length(x) || !arb_poly_length(y))
        return;
    LOCAL(arb_poly, product);
    LOCAL(mag, tail, factor);
    arb_poly_mul(product, x, y, EXPANSION_BITS);
    polynomial_norm(tail, product, EXPANSION_LENGTH);
    weight(factor, z->domain, i + k, j + l);
    mag_addmul(z->rest, tail, factor);
    arb_poly_truncate(product, EXPANSION_LENGTH);
    arb_poly_struct *const term = expansion_term(z, i + k, j + l);
    arb_poly_add(term, term, product, EXPANSION_BITS);
}

/* Bounds the products of terms with degrees above the order, and those with the rests. */
static void add_product_rest(struct expansion *z, const struct expansion *x, const struct expansion *y)
{
    LOCAL(mag, first, second, whole);
    for (slong m = 0; m <= EXPANSION_ORDER; m++) {
        expansion_norm_of_degree(first, x, m);
        mag_addmul(z->rest, first, y->rest);
        for (slong n = EXPANSION_ORDER + 1 - m; n <= EXPANSION_ORDER; n++) {
            expansion_norm_of_degree(second, y, n);
            mag_addmul(z->rest, first, second);
        }
    }
    expansion_norm(whole, y);
    mag_addmul(z->rest, x->rest, whole);
}

void expansion_multiply(struct expansion *z, const struct expansion *x, const struct expansion *y)
{
    LOCAL_EXPANSION(z->domain, sum);
    for (slong m = 0; m <= EXPANSION_ORDER; m++)
        for (slong j = 0; j <= m; j++)
            for (slong n = 0; m + n <= EXPANSION_ORDER; n++)
                for (slong l = 0; l <= n; l++)
                    add_product(sum, expansion_term_of(x, m - j, j), m - j, j, expansion_term_of(y, n - l, l), n - l,
                                l);
    add_product_rest(sum, x, y);
    expansion_set(z, sum);
}

void expansion_times_a(struct expansion *y, const struct expansion *x, slong power)
{
    LOCAL(mag, term, factor);
    LOCAL_EXPANSION(y->domain, product);
    mag_set(product->rest, x->rest);
    for (slong m = 0; m <= EXPANSION_ORDER; m++)
        if (m + power > EXPANSION_ORDER) {
            expansion_norm_of_degree(term, x, m);
            mag_add(product->rest, product->rest, term);
        } else {
            for (slong j = 0; j <= m; j++)
                arb_poly_set(expansion_term(product, m - j + power, j), expansion_term_of(x, m - j, j));
        }
    mag_pow_ui(factor, y->domain->a, (ulong)power);
    mag_mul(product->rest, product->rest, factor);
    expansion_set(y, product);
}

/* ---- power series ---- */

void expansion_series(struct expansion *y, const struct expansion *x, arb_srcptr coefficient)
{
    LOCAL(mag, bound);
    LOCAL_EXPANSION(y->domain, sum, small);
    expansion_set(small, x);
    polynomial_norm(bound, &small->c[0], 0);
    expansion_add_rest(small, bound);
    arb_poly_zero(&small->c[0]);
    for (slong k = EXPANSION_ORDER; k >= 0; k--) {
        expansion_multiply(sum, sum, small);
        expansion_add_number(sum, 0, 0, coefficient + k);
    }
    expansion_norm(bound, small);
    mag_geom_series(bound, bound, EXPANSION_ORDER + 1);
    expansion_add_rest(sum, bound);
    expansion_set(y, sum);
}

void expansion_power(struct expansion *y, const struct expansion *x, slong p, slong q)
{
    LOCAL_VECTOR(c, EXPANSION_ORDER + 1);
    arb_one(c);
    for (slong k = 0; k < EXPANSION_ORDER; k++) {
        const arb_srcptr c_k = c + k;
        LET(c + k + 1, EXPANSION_BITS, "c_k*(p - k*q)/((k + 1)*q)", c_k, p, k, q);
    }
    expansion_series(y, x, c);
}

/* ---- substitution ---- */

/* sum_n p_n e^n as a model. e^n has the degree n at least, so higher powers join the rest. */
static void polynomial_of(struct expansion *y, const arb_poly_t p, const struct expansion *e)
{
    LOCAL(mag, bound, power);
    LOCAL(arb, c);
    expansion_zero(y);
    for (slong n = FLINT_MIN(arb_poly_length(p) - 1, EXPANSION_ORDER); n >= 0; n--) {
        expansion_multiply(y, y, e);
        arb_poly_get_coeff_arb(c, p, n);
        expansion_add_number(y, 0, 0, c);
    }
    polynomial_norm(bound, p, EXPANSION_ORDER + 1);
    expansion_norm(power, e);
    mag_pow_ui(power, power, EXPANSION_ORDER + 1);
    mag_mul(bound, bound, power);
    expansion_add_rest(y, bound);
}

void expansion_substitute(struct expansion *y, const struct expansion *x, const struct expansion *tau,
                          const struct expansion *e)
{
    LOCAL(mag, bound, one);
    LOCAL_EXPANSION(y->domain, sum, term);
    mag_one(one);
    for (slong m = 0; m <= EXPANSION_ORDER; m++)
        for (slong j = 0; j <= m; j++) {
            polynomial_of(term, expansion_term_of(x, m - j, j), e);
            for (slong k = 0; k < j; k++)
                expansion_multiply(term, term, tau);
            expansion_times_a(term, term, m - j);
            expansion_add(sum, sum, term);
        }
    expansion_add_rest(sum, x->rest);
    expansion_norm(bound, tau);
    if (mag_cmp(bound, x->domain->b) > 0 || mag_cmp(y->domain->a, x->domain->a) > 0)
        mag_inf(sum->rest);
    expansion_norm(bound, e);
    if (mag_cmp(bound, one) > 0 || arb_poly_length(&e->c[0]))
        mag_inf(sum->rest);
    expansion_set(y, sum);
}

/* ---- fixed points ---- */

/* Replaces the coefficients by numbers, and the rest by 0. */
static void to_numbers(struct expansion *x)
{
    mag_zero(x->rest);
    for (slong k = 0; k < EXPANSION_TERMS; k++)
        for (slong n = 0; n < arb_poly_length(&x->c[k]); n++)
            arb_get_mid_arb(arb_poly_get_coeff_ptr(&x->c[k], n), arb_poly_get_coeff_ptr(&x->c[k], n));
}

bool expansion_fixed_point(struct expansion *x, expansion_map *map, void *context)
{
    LOCAL(mag, rest, bound);
    LOCAL_EXPANSION(x->domain, image, difference);
    for (int k = 0; k <= EXPANSION_ORDER; k++) {
        map(image, x, context);
        expansion_set(x, image);
        to_numbers(x);
    }
    map(image, x, context);
    expansion_sub(difference, image, x);
    expansion_norm(rest, difference);
    mag_mul_2exp_si(rest, rest, 1);
    mag_set(x->rest, rest);
    map(image, x, context);
    mag_zero(x->rest);
    expansion_sub(difference, image, x);
    expansion_norm(bound, difference);
    mag_set(x->rest, rest);
    return mag_is_finite(rest) && mag_cmp(bound, rest) <= 0;
}
