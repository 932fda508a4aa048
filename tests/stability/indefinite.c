/* SPDX-License-Identifier: MIT */
#include "indefinite.h"

#include <math.h>

void disk_constant(arb_t b, double nu, enum cor_disk_datum datum, slong prec)
{
    arb_set_d(b, nu);
    arb_add_ui(b, b, 1, prec);
    arb_neg(b, b); /* printed */
    if (datum == COR_DISK_DATUM_DIAMETER)
        arb_set_si(b, -1);
    if (datum == COR_DISK_DATUM_CENTRE_OF_MASS) {
        arb_t ln2;
        arb_init(ln2);
        arb_const_log2(ln2, prec);
        arb_mul_2exp_si(b, b, -2);
        arb_submul_ui(b, ln2, 2, prec);
        arb_clear(ln2);
    }
}

/* sqrt(-w/2) dtheta/dy at y, and sin(theta) dtheta/dy; z = (v^2/8) exp(1 - 2 b) */
static void node(arb_t rate, arb_t weight, const arb_t y, const arb_t z, const arb_t pi, slong prec)
{
    arb_t e, one, sine;
    arb_init(e);
    arb_init(one);
    arb_init(sine);
    const int late = arf_sgn(arb_midref(y)) > 0;
    arb_sinh_cosh(e, weight, y, prec);
    arb_mul(e, e, pi, prec);
    arb_neg(e, e);
    arb_exp(e, e, prec);
    arb_add_ui(one, e, 1, prec);
    /* (pi/2) pi cosh(y) e/(1 + e)^2 */
    arb_mul(weight, weight, e, prec);
    arb_div(weight, weight, one, prec);
    arb_div(weight, weight, one, prec);
    arb_mul(weight, weight, pi, prec);
    arb_mul(weight, weight, pi, prec);
    arb_mul_2exp_si(weight, weight, -1);
    /* sine from the nearer end */
    arb_div(sine, pi, one, prec);
    arb_mul_2exp_si(sine, sine, -1);
    if (late) {
        arb_mul(sine, sine, e, prec); /* pi/2 - theta */
        arb_cos(sine, sine, prec);
    } else {
        arb_sin(sine, sine, prec);
    }
    arb_sqr(rate, sine, prec);
    arb_mul(rate, rate, z, prec);
    arb_neg(rate, rate);
    arb_lambertw(rate, rate, 1, prec);
    arb_neg(rate, rate);
    if (!arb_is_finite(rate)) /* the ball reaches over the branch point, where -w = 1 to half of the digits */
    {
        arb_one(rate);
        arb_add_error_2exp_si(rate, -prec / 2 + 20);
    }
    arb_mul_2exp_si(rate, rate, -1);
    arb_sqrt(rate, rate, prec);
    arb_mul(rate, rate, weight, prec);
    arb_mul(weight, weight, sine, prec);
    arb_clear(e);
    arb_clear(one);
    arb_clear(sine);
}

void indefinite_init(struct indefinite *f, double v, double nu, enum cor_disk_datum datum, int level, slong prec)
{
    const slong last = (slong)ldexp(3.25, level);
    const slong n = f->nodes = 2 * last + 1;
    arb_poly_t rate, kernel, product;
    arb_t z, pi, y, x;
    f->prec = prec;
    f->sin_weight = _arb_vec_init(n);
    f->s = _arb_vec_init(n);
    arb_init(f->half_time);
    arb_poly_init2(rate, n);
    arb_poly_init2(kernel, 2 * n - 1);
    arb_poly_init(product);
    arb_init(z);
    arb_init(pi);
    arb_init(y);
    arb_init(x);
    arb_const_pi(pi, prec);
    disk_constant(z, nu, datum, prec);
    arb_mul_2exp_si(z, z, 1);
    arb_sub_ui(z, z, 1, prec);
    arb_neg(z, z);
    arb_exp(z, z, prec);
    arb_set_d(x, v);
    arb_mul(z, z, x, prec);
    arb_mul(z, z, x, prec);
    arb_mul_2exp_si(z, z, -3);
    for (slong k = 0; k < n; k++) {
        arb_set_si(y, k - last);
        arb_mul_2exp_si(y, y, -level);
        node(x, f->sin_weight + k, y, z, pi, prec);
        arb_mul_2exp_si(f->sin_weight + k, f->sin_weight + k, -level);
        arb_mul_2exp_si(x, x, -level);
        arb_poly_set_coeff_arb(rate, n - 1 - k, x); /* from the last node on */
        arb_add(f->half_time, f->half_time, x, prec);
    }
    /* s_k = sum over j of rate_j (1/2 + Si(pi (j - k))/pi): with j' = n - 1 - j a product of polynomials */
    for (slong m = 0; m < n; m++) {
        arb_mul_si(x, pi, m, prec);
        arb_hypgeom_si(x, x, prec);
        arb_div(x, x, pi, prec);
        arb_set_d(y, 0.5);
        arb_add(z, y, x, prec);
        arb_poly_set_coeff_arb(kernel, n - 1 + m, z); /* j - k = m */
        arb_sub(z, y, x, prec);
        arb_poly_set_coeff_arb(kernel, n - 1 - m, z);
    }
    arb_poly_mul(product, rate, kernel, prec);
    for (slong k = 0; k < n; k++) /* j' + (n - 1 + j - k) = 2 (n - 1) - k */
        arb_poly_get_coeff_arb(f->s + k, product, 2 * (n - 1) - k);
    arb_poly_clear(rate);
    arb_poly_clear(kernel);
    arb_poly_clear(product);
    arb_clear(z);
    arb_clear(pi);
    arb_clear(y);
    arb_clear(x);
}

void indefinite_clear(struct indefinite *f)
{
    _arb_vec_clear(f->sin_weight, f->nodes);
    _arb_vec_clear(f->s, f->nodes);
    arb_clear(f->half_time);
}

void indefinite_integral(arb_t integral, const struct indefinite *f, double omega)
{
    arb_t x, w;
    arb_init(x);
    arb_init(w);
    arb_set_d(w, omega);
    arb_zero(integral);
    for (slong k = 0; k < f->nodes; k++) {
        arb_mul(x, f->s + k, w, f->prec);
        arb_cos(x, x, f->prec);
        arb_addmul(integral, x, f->sin_weight + k, f->prec);
    }
    arb_clear(x);
    arb_clear(w);
}
